#version 330 core
// For clouds.c: the functions of clouds.glsl. Time selects the function; iMouse contains some of its arguments, and the
// pixel's coordinates determine the others.

in float Time;
out vec4 FragColor;

uniform vec4 iMouse;

#include "clouds.glsl"

// A direction from the coordinates of one of 128 x 64 pixels, which together cover the sky from the horizon to the
// zenith.
vec3 directionOf(vec2 number)
{
    float turn = 6.2831853 * (number.x + 0.37) / 128.0, height = 1.5707963 * (number.y + 0.5) / 64.0;
    return vec3(cos(height) * cos(turn), sin(height), cos(height) * sin(turn));
}

float lot(vec2 number, int which)
{
    return cellRandom(ivec3(ivec2(number), which));
}

void main()
{
    int function = int(Time);
    vec2 number = floor(gl_FragCoord.xy);
    FragColor = vec4(0.0);
    if (function == 0) { // layerHit; iMouse: height, altitude; climb from -1 to 1, often near 0
        float side = number.x < 128.0 ? -1.0 : 1.0, climb = side * exp2(-0.125 * mod(number.x, 128.0));
        float b = (EARTH_RADIUS + iMouse.x) * climb, whole = EARTH_RADIUS + iMouse.y, eye = EARTH_RADIUS + iMouse.x;
        float plain = -b + sqrt(b * b + whole * whole - eye * eye);
        FragColor = vec4(climb, layerHit(iMouse.x, climb, iMouse.y), plain, 0.0);
    } else if (function == 1) { // position and footprint in the panorama; iMouse: width of a pixel
        vec3 direction = directionOf(number);
        FragColor = vec4(panoramaUV(direction), panoramaFootprint(direction, iMouse.x));
    } else if (function == 2) {
        FragColor = vec4(directionOf(number), 0.0);
    } else if (function == 3) { // an overcast sky; iMouse.xyz: its white
        float y = (number.x + 0.5) / 256.0;
        FragColor = vec4(overcastSky(y, iMouse.xyz), y);
    } else if (function == 4) { // the weather, from 0.5 to 1
        float w = 0.5 + number.x / 1000.0;
        FragColor = vec4(fairShare(w), stormShare(w), overcastShare(w), sunLeft(w));
    } else if (function == 5) {
        float w = 0.5 + number.x / 1000.0;
        FragColor = vec4(hazeDensity(w), rainShare(w), discLeft(w), 0.0);
    } else if (function == 6) { // errors of cloudOver and cloudShare for random clouds
        float a = lot(number, 0), b = lot(number, 1);
        Cloud near = Cloud(a, a * lot(number, 2), a * (2.0 * lot(number, 3) - 1.0));
        Cloud far = Cloud(b, b * lot(number, 4), b * (2.0 * lot(number, 5) - 1.0));
        Cloud both = cloudOver(near, far), part = cloudShare(near, lot(number, 6));
        FragColor = vec4(a + b - a * b - both.cover, near.above + (1.0 - a) * far.above - both.above, part.cover - a * lot(number, 6),
                         both.side - near.side - (1.0 - a) * far.side);
    } else if (function == 7) { // light of a random cloud; iMouse: hour
        float a = lot(number, 0);
        Cloud cloud = Cloud(a, a * lot(number, 2), a * (2.0 * lot(number, 3) - 1.0));
        vec3 sun = sunDirection(iMouse.x, 43.6, -8.0), sunlight = vec3(0.3, 0.2, 0.1);
        vec3 light = cloudLight(cloud, directionOf(mod(number, vec2(128.0, 64.0))), sun, sunlight, vec3(0.01));
        FragColor = vec4(light, a);
    } else if (function == 8) { // seenFromMiddle for an eye beside the centre; iMouse: eye, altitude
        vec3 direction = directionOf(number);
        FragColor = vec4(seenFromMiddle(iMouse.xyz, direction, iMouse.w), 0.0);
    } else if (function == 9) { // sine of the sun's height at a cloud; iMouse: altitude
        float height = (number.x - 256.0) / 256.0;
        FragColor = vec4(height, cloudSunHeight(height, iMouse.x), 0.0, 0.0);
    } else { // rain in each pixel of a 16 : 9 screen; iMouse: seconds, number of rows
        vec2 screen = (2.0 * (number + 0.5) - vec2(16.0 / 9.0, 1.0) * iMouse.y) / iMouse.y;
        FragColor = vec4(rainStreaks(screen, iMouse.x, 2.0 / iMouse.y), screen, 0.0);
    }
}
