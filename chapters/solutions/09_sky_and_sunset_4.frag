// Solution to exercise 09.4: stars. The celestial sphere turns about the pole. Each small square on
// a cube around the eye contains one star or none, depending on an integer hash of the square.
#include "main.glsl"
#define rayColour chapterRayColour
#include "09_sky_and_sunset.frag"
#undef rayColour

uniform float starSize; // 0.003 in [0.0005, 0.01] step *1.2, radians: radius of a star in the picture

// The direction in a frame that turns with the sun. Its third axis is the pole. Its first axis lies
// in the plane of the equator and has the sun's hour angle, and its second is a quarter turn
// farther west.
vec3 starFrame(vec3 direction)
{
    float angle = radians(15.0 * (hour() - 12.0)), latitude = radians(LATITUDE);
    float meridian = direction.y * cos(latitude) - direction.x * sin(latitude), west = -direction.z;
    float pole = direction.x * cos(latitude) + direction.y * sin(latitude);
    return vec3(meridian * cos(angle) + west * sin(angle), west * cos(angle) - meridian * sin(angle), pole);
}

// The star of a square: its position in the square (x, y), away from the edges, and its light (z),
// which is 0 for most squares.
vec3 starOf(ivec3 square)
{
    float random = cellRandom(ivec3(square.x, square.y + 64 * square.z, 0)); // which treats the last two alike
    vec2 point = 0.25 + 0.5 * fract(random * vec2(256.0, 65536.0));
    return vec3(point, random < 0.4 ? 0.2 + 5.0 * random * random : 0.0);
}

float starLight(vec3 direction)
{
    vec3 d = starFrame(direction), size = abs(d);
    float largest = max(size.x, max(size.y, size.z));
    int face = size.x == largest ? 0 : size.y == largest ? 1 : 2;
    vec2 point = 24.0 * (face == 0 ? d.yz : face == 1 ? d.zx : d.xy) / largest;
    vec3 star = starOf(ivec3(floor(point), 2 * face + (d[face] < 0.0 ? 1 : 0)));
    return star.z * (1.0 - smoothstep(0.0, starSize, length(fract(point) - star.xy) / 24.0));
}

vec3 rayColour(Ray ray)
{
    vec3 sun = sunDirection(hour(), LATITUDE, DECLINATION);
    vec3 upwards = vec3(ray.direction.x, max(ray.direction.y, 0.0), ray.direction.z);
    vec3 sky = skyLight(upwards, sun), city = cityColour(ray, sun, sky);
    vec3 stars = starLight(ray.direction) * transmittance(airDepth(), airMass(ray.direction.y));
    stars *= 1.0 - daylight(sun.y);
    bool seen = stars.y > 0.0 && trace.end != END_HIT;
    return seen ? exposed(sky + stars, sun) : city;
}
