// Experiment of chapter 04: figure 5 of the report, drawn with the formula itself. The top strip
// shows the hues from 0 to 360 degrees. Below it are the curves of red, green and blue, with a line
// every 60 degrees.
//
// There is nothing to march: the picture is a diagram.
#include "main.glsl"
#include "camera.glsl"
#include "hue.glsl"

uniform float saturation; // 1 in [0, 1] step 0.05: 0 grey, 1 the pure hue
uniform float value;      // 1 in [0, 1] step 0.05: the largest channel
uniform bool  rounded;    // false: three cosines instead of the trapezoids

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float sceneDistance(vec3 p)
{
    return length(p) + 1.0;
}

// The colour of a hue, used for the strip and for the curves.
vec3 drawnColour(float hue)
{
    vec3 smoothed = 0.5 + 0.5 * cos(radians(hue - vec3(0.0, 120.0, 240.0)));
    return rounded ? value * mix(vec3(1.0), smoothed, saturation) : hsvToRGB(hue, saturation, value);
}

// The share of a pixel that a line covers, given the line's width and its distance from the centre
// of the pixel, both in pixels.
float line(float distance, float width)
{
    return clamp(0.5 * width + 0.5 - abs(distance), 0.0, 1.0);
}

// The band of one channel: the area under the curve has the channel's colour, and the curve is
// white.
//   point    hue in degrees, and height in the band from 0 to 1
//   pixels   size of the band in pixels: the width of 360 degrees, and the height of the value 1
vec3 band(vec2 point, vec2 pixels, int channel)
{
    vec3 ink = vec3(0.10, 0.11, 0.13);
    vec3 hue = vec3(channel == 0, channel == 1, channel == 2);
    float curve = drawnColour(point.x)[channel];
    float slope = (drawnColour(point.x + 0.5)[channel] - drawnColour(point.x - 0.5)[channel]) * pixels.y / (pixels.x / 360.0);
    float off = (point.y - curve) * pixels.y / sqrt(1.0 + slope * slope);
    vec3 colour = point.y < curve ? mix(ink, mix(vec3(0.35), hue, 0.8), 0.25 + 0.6 * curve) : ink;
    float grid = abs(mod(point.x + 30.0, 60.0) - 30.0) * pixels.x / 360.0;
    colour = mix(colour, vec3(0.6), 0.35 * line(grid, 1.0));
    return mix(colour, vec3(0.97), line(off, 3.0));
}

vec3 rayColour(Ray ray)
{
    vec2 pixel = floor(gl_FragCoord.xy + iPixelOffset) + 0.5;
    vec2 size = iResolution.xy;
    vec2 low = vec2(0.05, 0.05) * size, high = vec2(0.95, 0.95) * size;
    vec2 point = (pixel - low) / (high - low);
    float hue = 360.0 * point.x;
    vec3 colour = vec3(0.055, 0.062, 0.075);
    float row = point.y * 4.0, up = fract(row);
    vec2 pixels = vec2(high.x - low.x, 0.8 * 0.25 * (high.y - low.y));
    bool inside = point.x >= 0.0 && point.x <= 1.0 && point.y >= 0.0 && point.y < 1.0;
    if (inside && row >= 3.0)
        colour = drawnColour(hue);
    else if (inside)
        colour = band(vec2(hue, (up - 0.08) / 0.8), pixels, 2 - int(row));
    return colour;
}
