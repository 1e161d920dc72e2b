// cover.glsl - the least number of evaluations that could have given the result of a ray's first march.
//
// One evaluation at t shows only that nothing lies between t - d and t + d, where d is the distance there.
// docs/benchmark.md proves the claims made here.
#include "inputs.glsl"
#include "scene.glsl"

// Compiled only where evaluations are counted.
#if VIEW == VIEW_COVER

// The rays that are examined: one through the middle of each cell of this grid over the picture.
const vec2 COVER_GRID = vec2(32.0, 18.0);

// Does the pixel contain the middle of a cell?
//   pixel  the centre of the pixel, in pixels of the picture
bool onCoverGrid(vec2 pixel)
{
    vec2 cell = floor(pixel * COVER_GRID / iResolution.xy);
    return floor(pixel) == floor((cell + 0.5) * iResolution.xy / COVER_GRID);
}

// The least number of evaluations on a ray whose intervals, each from t - d to t + d, together cover the part of the
// ray that the first march covered; for a hit, one of the evaluations is at the hit itself. The covered part grows from
// the start: of all t whose interval begins in the covered part, the one whose interval reaches farthest comes next.
//   ray      of the first march
//   steps    of that march; 0 means no march, and the result is 0
//   formula  with a distance that is 1-Lipschitz, t - d and t + d grow along the ray: the next t is
//            the last one with t - d <= covered, found by bisection. The value of t + d is taken at a point
//            just beyond this t, so the result never exceeds the least number
//   returns  at most steps + 1; steps + 1, more than the march took, shows a distance that is not 1-Lipschitz
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
