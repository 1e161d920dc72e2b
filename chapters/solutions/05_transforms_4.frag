// Solution of exercise 05.4: a bound for this ray alone. Along a direction D the height over the water
// falls by at most |D.y| + slope |(D.x, D.z)| per scene unit, which is less than sqrt(1 + slope^2) for
// a ray that grazes the sea: longer steps, still safe. Only the first march knows its direction here.
#include "main.glsl"
#define sceneDistance chapterDistance
#define pixelRay chapterPixelRay
#include "05_transforms.frag"
#undef sceneDistance
#undef pixelRay

uniform bool directed; // true: the bound of the ray in place of the bound of every direction

float fall; // the most by which the height over the water falls along the first march's ray

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
