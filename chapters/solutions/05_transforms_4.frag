// Solution to exercise 05.4: a bound for one ray. Along a direction D, the height above the water
// falls by at most |D.y| + slope |(D.x, D.z)| per scene unit. For a ray that grazes the sea, this
// is less than sqrt(1 + slope^2), so the steps are longer but still safe. The second march keeps the
// bound for every direction.
#include "main.glsl"
#define sceneDistance chapterDistance
#define pixelRay chapterPixelRay
#include "05_transforms.frag"
#undef sceneDistance
#undef pixelRay

uniform bool directed; // true: use the bound for the ray instead of the bound for every direction

float fall; // how fast the height above the water can fall, per unit of the first march's ray

Ray pixelRay(vec2 screen)
{
    Ray ray = chapterPixelRay(screen);
    fall = abs(ray.direction.y) + waveHeight * STEEPEST * length(ray.direction.xz);
    return ray;
}

float sceneDistance(vec3 p)
{
    float stretch = directed && trace.marches == 1 ? min(fall, now.seaStretch) : now.seaStretch;
    float sea = (p.y - seaHeight(p.xz)) / stretch;
    return stepScale * min(sea, thingsDistance(p));
}
