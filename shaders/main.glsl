// main.glsl - main(): runs the chapter's pixelRay and rayColour, then shows the colour, or what the
// trace holds.
//
// The harness sets VIEW: 0 the picture, 1 normals, 2 depth, 3 steps, 4 a slice,
// 5 the numbers of a probe, 6 evaluations of the scene, and how few of the march would do, 7 the
// coarse pass of coarse.glsl, one pixel a block of the picture.

#include "cover.glsl"
#include "inputs.glsl"
#include "scene.glsl"
#include "slice.glsl"
#include "views.glsl"

out vec4 fragColour;

#if VIEW == 4

void main()
{
    iPixel = ivec2(floor(iMarchPixel));
    fragColour = vec4(clamp(sliceView(gl_FragCoord.xy + iPixelOffset), 0.0, 1.0), 1.0);
}

#elif VIEW == 5

uniform vec2 iProbe; // centre of the pixel whose ray is marched, in pixels

// Column k, row 0: t, distance, steps of the first march, why it ended. Row 1: position.
// Row 2: steps of all marches, evaluations, where the first march was asked to look.
void main()
{
    traceReset(int(gl_FragCoord.x));
    iPixel = ivec2(floor(iProbe));
    Ray ray = pixelRay(screenPosition(iProbe));
    rayColour(ray);
    int row = int(gl_FragCoord.y);
    if (row == 0)
        fragColour = vec4(trace.wantedT, trace.wantedDistance, float(trace.steps), float(trace.end));
    else if (row == 1)
        fragColour = vec4(ray.origin + trace.wantedT * ray.direction, 0.0);
    else
        fragColour = vec4(float(trace.allSteps), float(trace.evaluations), trace.interval);
}

#elif VIEW == 7

vec2 coarseBlock(ivec2 block);

void main()
{
    traceReset(-1);
    fragColour = vec4(coarseBlock(ivec2(gl_FragCoord.xy)), 0.0, 1.0);
}

#else

void main()
{
    traceReset(-1);
    vec2 pixel = gl_FragCoord.xy + iPixelOffset; // less than half a pixel from the pixel's centre
    iPixel = ivec2(floor(pixel));
    Ray ray = pixelRay(screenPosition(pixel));
    vec3 colour = rayColour(ray);
#if VIEW == 1
    colour = normalView();
#elif VIEW == 2
    colour = depthView();
#elif VIEW == 3
    colour = stepView(pixel);
#endif
#if VIEW == 6
    // What the march took and what would do, for the pixels of the grid: else 0, 0 and 0.
    bool looked = onCoverGrid(pixel);
    int steps = looked ? trace.steps : 0;
    fragColour = vec4(float(trace.evaluations), float(steps), float(fewestEvaluations(ray, steps)), float(looked));
#else
    fragColour = vec4(clamp(colour, 0.0, 1.0), 1.0);
#endif
}

#endif
