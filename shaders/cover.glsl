// cover.glsl - how few evaluations on its ray could have shown what the first march has shown.
//
// One evaluation at t says that nothing stands between t - d and t + d, d the distance there, and no
// more. docs/benchmark.md proves what is computed here.
#include "inputs.glsl"
#include "scene.glsl"

// Compiled only where evaluations are counted.
#if VIEW == 7

// The rays that are looked at: one from the middle of each cell of this grid over the picture.
const vec2 COVER_GRID = vec2(32.0, 18.0);

// Does the pixel hold the middle of a cell?
//   pixel  in pixels of the picture, at a pixel's centre
bool onCoverGrid(vec2 pixel)
{
    vec2 cell = floor(pixel * COVER_GRID / iResolution.xy);
    return floor(pixel) == floor((cell + 0.5) * iResolution.xy / COVER_GRID);
}

// The least number of evaluations on a ray whose intervals cover what the first march was asked about,
// as far as it came; for a hit one of them at the hit itself. What is covered grows from the start:
// among all t whose interval begins in it, the one that reaches farthest is next.
//   ray      of the first march
//   steps    of that march; 0, no march: the result is 0
//   formula  with a distance that is 1-Lipschitz, t - d and t + d grow along the ray: the next t is
//            the last one with t - d <= covered, found by halving. What is taken for t + d there is
//            its value behind that place, so that the result is never more than the least number
//   returns  at most steps + 1; that, more than the march took, shows a distance that is not 1-Lipschitz
int fewestEvaluations(Ray ray, int steps)
{
    float covered = trace.interval.x, far = min(trace.t, trace.interval.y);
    bool hit = trace.end == END_HIT && trace.t < trace.interval.y;
    float atFar = max(sceneDistance(ray.origin + far * ray.direction), 0.0);
    int count = 0;
    while (covered < far - atFar && count < steps) {
        float low = covered, high = far, reached = far + atFar;
        for (int i = 0; i < 24; i++) {
            float t = 0.5 * (low + high);
            float distance = sceneDistance(ray.origin + t * ray.direction);
            bool begins = t - distance <= covered;
            low = begins ? t : low;
            high = begins ? high : t;
            reached = begins ? reached : t + distance;
        }
        covered = reached;
        count++;
    }
    return steps > 0 ? count + int(hit || covered < far) : 0;
}

#endif
