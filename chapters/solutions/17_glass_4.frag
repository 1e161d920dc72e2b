// Solution to exercise 17.4: the light that is left when the number of surfaces runs out comes from
// the room, as if there were no more glass in its path.
#include "main.glsl"
#define rayColour chapterRayColour
#include "17_glass.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    Way way = wayThrough(ray, 0.55, 0);
    vec3 seen = way.free ? worldLight(way.ray, way.far) : surroundings(way.ray.direction);
    return encodeSRGB(way.light + way.share * seen);
}
