// views.glsl - the trace as a picture: the first normal, the depth, the number of steps, that of evaluations.
#include "ramp.glsl"
#include "signs.glsl"
#include "inputs.glsl"
#include "scene.glsl"

// Compiled only for these views.
#if VIEW_OF_TRACE

// The colour of a ray along which nothing was found.
const vec3 VIEW_NOTHING = vec3(0.09, 0.10, 0.13);

// The first normal N of the pixel's rays, as 0.5 N + 0.5: x red, y green, z blue.
vec3 normalView()
{
    return trace.normals > 0 ? 0.5 * trace.normal + 0.5 : VIEW_NOTHING;
}

// Where the first march ended: white at the eye, and darker with the distance t, as 1 / (1 + (t / 6)^4). The
// greys change most around 6 units, where most scenes are. A miss is shown in a blue that no depth has.
vec3 depthView()
{
    float square = trace.t * trace.t / 36.0;
    return trace.end == END_HIT ? vec3(1.0 / (1.0 + square * square)) : VIEW_NOTHING;
}

// The legend over the picture: the ramp along the bottom, with the multiples of a quarter of its largest number
// above it. The legend is left out if the picture is too small.
//   largest  the number at the bright end of the ramp, a multiple of 4
//   pixel    in pixels of the picture
vec3 rampLegend(vec3 colour, int largest, vec2 pixel)
{
    float unit = float(signCell());
    vec2 cell = floor(pixel / unit) - vec2(7.0, 5.0);   // in cells, from the ramp's corner
    float right = 66.0 + float(numberWidth(largest, 0));
    bool fits = iResolution.x >= (right + 19.0) * unit && iResolution.y >= 40.0 * unit;
    if (!fits || cell.x < -4.0 || cell.x > right || cell.y < -2.0 || cell.y > 12.0)
        return colour;
    bool ramp = cell.x >= 0.0 && cell.x <= 64.0 && cell.y >= 0.0 && cell.y < 4.0;
    colour = ramp ? evenRamp(cell.x / 64.0) : vec3(0.0);
    for (int quarter = 0; quarter <= 4; quarter++) {
        float tick = 16.0 * float(quarter);
        float number = numberCover(quarter * largest / 4, 0, pixel - unit * vec2(tick + 7.0, 11.0));
        colour = mix(colour, vec3(1.0), cell == vec2(tick, 4.0) ? 1.0 : number);
    }
    return colour;
}

// A number of the trace as a colour of the ramp, with a legend.
//   largest  the number at the bright end of the ramp, which also shows any larger number
//   pixel    in pixels of the picture
vec3 rampView(int number, int largest, vec2 pixel)
{
    float share = min(float(number) / float(largest), 1.0);
    return rampLegend(evenRamp(share), largest, pixel);
}

// The view that VIEW names.
//   pixel  in pixels of the picture
vec3 traceView(vec2 pixel)
{
#if VIEW == VIEW_NORMALS
    return normalView();
#elif VIEW == VIEW_DEPTH
    return depthView();
#elif VIEW == VIEW_STEPS
    return rampView(trace.allSteps, 64, pixel); // of all marches, with those of the shadow rays
#elif VIEW == VIEW_EVALUATIONS
    return rampView(trace.evaluations, 64, pixel); // of the scene, by marches and normals
#else
#error traceView has no case for this view
#endif
}

#endif
