// Solution to exercise 18.4: the light of the sky on the islet, from the tables themselves. It is
// the mean of twelve directions: four horizontal angles, and three heights that represent equal shares
// of the light on a horizontal surface.
#include "main.glsl"
#define rayColour chapterRayColour
#define tableAmbient closedAmbient
#include "sky_table.glsl"
#undef tableAmbient
vec3 tableAmbient(vec3 sun);
#include "18_sky_from_tables.frag"
#undef rayColour

vec3 tableAmbient(vec3 sun)
{
    vec3 sum = vec3(0.0), level = normalize(vec3(sun.x, 0.0, sun.z)), across = vec3(-level.z, 0.0, level.x);
    for (int i = 0; i < 12; i++) {
        float y = sqrt((float(i / 4) + 0.5) / 3.0), turn = radians(45.0 + 90.0 * float(i % 4));
        vec3 direction = sqrt(1.0 - y * y) * (cos(turn) * level + sin(turn) * across) + vec3(0.0, y, 0.0);
        sum += tableSky(sunward, away, direction, sun);
    }
    return sum / 12.0;
}

vec3 rayColour(Ray ray)
{
    return chapterRayColour(ray);
}
