// main.glsl - main(): runs the chapter's pixelRay and rayColour, then shows the colour or the contents of
// the trace.
//
// The harness defines VIEW as one of the names of common/shader/view.h, such as VIEW_PICTURE. For views of what
// each pixel's march has recorded, and for them alone, VIEW_OF_TRACE is true.

#include "cover.glsl"
#include "inputs.glsl"
#include "positions.glsl"
#include "plot.glsl"
#include "room.glsl"
#include "scene.glsl"
#include "slice.glsl"
#include "views.glsl"

out vec4 fragColour;

#if VIEW == VIEW_SLICE || VIEW == VIEW_PLOT

void main()
{
    iPixel = ivec2(floor(iMarchPixel));
    vec2 pixel = gl_FragCoord.xy + iPixelOffset;
#if VIEW == VIEW_SLICE
    vec3 colour = sliceView(pixel);
#else
    vec3 colour = plotView(pixel);
#endif
    fragColour = vec4(clamp(colour, 0.0, 1.0), 1.0);
}

#elif VIEW == VIEW_PROBE

uniform vec2 iProbe; // centre of the pixel whose ray is marched, in pixels

// Column k of row 0: t and distance at step k, the number of steps of the first march, and why that march ended.
// Column k of row 1: the position at step k, and the distance below which the surface would have counted as found
// there. Row 2: the steps of all marches, the evaluations, and the interval of the first march.
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
        fragColour = vec4(ray.origin + trace.wantedT * ray.direction,
                          trace.threshold + trace.spread * trace.wantedT);
    else
        fragColour = vec4(float(trace.allSteps), float(trace.evaluations), trace.interval);
}

#elif VIEW == VIEW_COARSE

vec2 coarseBlock(ivec2 block);

void main()
{
    traceReset(-1);
    fragColour = vec4(coarseBlock(ivec2(gl_FragCoord.xy)), 0.0, 1.0);
}

#elif VIEW == VIEW_POSITIONS

void main()
{
    fragColour = projectedPixel(projectedPoint(int(gl_FragCoord.x)));
}

#elif VIEW == VIEW_KEPT

// What this frame keeps for the next one, neither clamped nor encoded. In this function the sampler that reads the last
// frame has the one before, which is 0 everywhere at frame 0. In rayColour, and in all views, it has this frame.
//   pixel    centre of the pixel; iSample is the index of the frame, so pixelRandom continues from frame to frame
vec4 frameKept(vec2 pixel);

void main()
{
    traceReset(-1);
    iPixel = ivec2(gl_FragCoord.xy);
    fragColour = frameKept(gl_FragCoord.xy);
}

#elif VIEW == VIEW_ROOM

void main()
{
    traceReset(-1);
    pixelRay(vec2(0.0)); // a chapter may prepare its scene in pixelRay
    fragColour = vec4(cameraStop(iCameraPosition, iCameraTo) - iCameraTo, 1.0); // small, so precise even in half floats
}

#else

void main()
{
    traceReset(-1);
    vec2 pixel = gl_FragCoord.xy + iPixelOffset; // the sample, less than half a pixel from the pixel's centre
    iPixel = ivec2(floor(pixel));
    Ray ray = pixelRay(screenPosition(pixel));
    vec3 colour = rayColour(ray);
#if VIEW_OF_TRACE
    colour = traceView(pixel);
#endif
#if VIEW == VIEW_COVER
    // The evaluations of the scene; for pixels on the grid of cover.glsl, also the steps that the first march took and
    // the evaluations that would have been enough, both of which are 0 elsewhere.
    bool looked = onCoverGrid(pixel);
    int steps = looked ? trace.steps : 0;
    fragColour = vec4(float(trace.evaluations), float(steps), float(fewestEvaluations(ray, steps)), float(looked));
#else
    fragColour = vec4(clamp(colour, 0.0, 1.0), 1.0);
#endif
}

#endif
