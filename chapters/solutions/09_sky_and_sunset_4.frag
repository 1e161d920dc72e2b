// Solution of exercise 09.4: stars. The sphere of the sky turns about the celestial pole; each small
// cell of it holds one star or none, as an integer hash of the cell says.
#include "main.glsl"
#define rayColour chapterRayColour
#include "09_sky_and_sunset.frag"
#undef rayColour

uniform float starSize; // 0.0022 in [0.0005, 0.01] step *1.2, radians: radius of a star as it is drawn

// The direction in a frame that turns with the stars, its z axis towards the pole.
vec3 starFrame(vec3 direction)
{
    float angle = radians(15.0 * hour()), latitude = radians(LATITUDE);
    float pole = direction.x * cos(latitude) + direction.y * sin(latitude);
    float south = direction.y * cos(latitude) - direction.x * sin(latitude);
    float east = direction.z;
    return vec3(south * cos(angle) - east * sin(angle), south * sin(angle) + east * cos(angle), pole);
}

float starLight(vec3 direction)
{
    vec3 d = starFrame(direction);
    vec3 size = abs(d);
    float largest = max(size.x, max(size.y, size.z));
    int face = size.x == largest ? 0 : size.y == largest ? 1 : 2;
    vec2 place = 24.0 * (face == 0 ? d.yz : face == 1 ? d.zx : d.xy) / largest;
    ivec3 cell = ivec3(floor(place), 2 * face + (d[face] < 0.0 ? 1 : 0));
    float random = cellRandom(cell);
    vec2 star = 0.25 + 0.5 * fract(random * vec2(256.0, 65536.0));
    float away = length(fract(place) - star) / 24.0;
    return random < 0.4 ? smoothstep(starSize, 0.0, away) * (0.2 + 5.0 * random * random) : 0.0;
}

vec3 rayColour(Ray ray)
{
    vec3 sun = sunDirection(hour(), LATITUDE, DECLINATION);
    vec3 upwards = vec3(ray.direction.x, max(ray.direction.y, 0.0), ray.direction.z);
    float stars = (1.0 - daylight(sun)) * starLight(upwards) * transmittance(airDepth(), airMass(upwards.y)).y;
    return cityColour(ray, sun, skyColour(upwards, sun) + vec3(0.9, 0.95, 1.0) * stars);
}
