// Solution to exercise 19.3: the guest star of the year 1054, of magnitude -6, in the constellation
// Taurus.
#include "main.glsl"
#include "night.glsl"

const float RIGHT = 83.63;       // right ascension of the star, degrees
const float HIGH = 22.01;        // declination of the star, degrees
const float BRIGHTNESS = -6.0;   // magnitude of the star

vec3 guestLight(vec3 direction, float width)
{
    vec3 guest = vec3(cos(radians(HIGH)) * vec2(cos(radians(RIGHT)), sin(radians(RIGHT))), sin(radians(HIGH)));
    vec3 away = direction - guest;
    float radius = 1.761 * width, near = max(1.0 - dot(away, away) / (radius * radius), 0.0);
    float light = 2.54e-6 * pow(10.0, -0.4 * BRIGHTNESS) / 4000.0;
    return starLight(direction, width) + 4.0 / (NIGHT_PI * radius * radius) * light * near * near * near;
}

#define starLight guestLight
#include "19_moon_and_stars.frag"
