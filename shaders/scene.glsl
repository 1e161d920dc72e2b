// scene.glsl - the three functions of a chapter, and the record of what its rays did.

// A half-line: the points origin + t direction, t >= 0.
struct Ray {
    vec3 origin;    // scene units
    vec3 direction; // length 1
};

// Where the ray of this pixel starts and goes.
//   screen  y from -1 to 1, x from -aspect to aspect
Ray pixelRay(vec2 screen);

// How far the scene is from p: a signed distance in scene units, or a lower bound of it, negative
// inside.
float sceneDistance(vec3 p);

// What colour the ray sees: red, green, blue in [0, 1]; the screen clamps what lies outside.
vec3 rayColour(Ray ray);

// Why a march ended.
const int END_NONE   = 0; // there was no march
const int END_HIT    = 1; // the scene was nearer than the threshold
const int END_PASSED = 2; // the far limit was passed
const int END_STEPS  = 3; // the steps ran out

// What the rays of this pixel did: filled in by distanceAt, march and normalAt, shown by the views
// and by --probe. Where nothing shows it, the compiler removes it.
struct Trace {
    int   evaluations;    // of sceneDistance, by whatever asked
    int   allSteps;       // of all marches
    int   marches;        // begun
    vec2  interval;       // where the first march was asked to look: from tMin to tMax
    float threshold;      // of the first march: a distance below threshold + spread t was a hit,
    float spread;         // scene units, and scene units per scene unit; 0, 0: not said
    int   steps;          // of the first march
    float t;              // where the first march ended
    int   end;            // why it did
    int   normals;        // computed
    vec3  normal;         // the first one
    int   wanted;         // the step that a probe asks for, from 0
    float wantedT;        // t at that step
    float wantedDistance; // the distance there
};

Trace trace;

// Forget all rays: with this every pixel begins.
//   wanted  the step whose numbers a probe asks for, from 0; -1: none
void traceReset(int wanted)
{
    trace = Trace(0, 0, 0, vec2(0.0), 0.0, 0.0, 0, 0.0, END_NONE, 0, vec3(0.0), wanted, 0.0, 0.0);
}

// The scene's distance, counted. March, normal and shadow ask this function, never sceneDistance.
float distanceAt(vec3 p)
{
    trace.evaluations++;
    return sceneDistance(p);
}

// Note that a march begins; where the first one is to look is kept.
void traceBegin(float tMin, float tMax)
{
    if (trace.marches == 0)
        trace.interval = vec2(tMin, tMax);
    trace.marches++;
}

// Note which distance a march takes for a hit: one below threshold + spread t. The first march's is kept.
void traceThreshold(float threshold, float spread)
{
    if (trace.marches == 1) {
        trace.threshold = threshold;
        trace.spread = spread;
    }
}

// Note one step of a march.
void traceStep(int step, float t, float distance)
{
    trace.allSteps++;
    if (trace.marches == 1 && step == trace.wanted) {
        trace.wantedT = t;
        trace.wantedDistance = distance;
    }
}

// Note how a march ended; the first one is kept.
void traceMarch(int steps, float t, int end)
{
    if (trace.marches == 1) {
        trace.steps = steps;
        trace.t = t;
        trace.end = end;
    }
}

// Note a normal; the first one is kept.
void traceNormal(vec3 normal)
{
    if (trace.normals == 0)
        trace.normal = normal;
    trace.normals++;
}
