// scene.glsl - the three functions of a chapter, and the record of its rays.

// A half-line: the points origin + t direction, t >= 0.
struct Ray {
    vec3 origin;    // scene units
    vec3 direction; // length 1
};

// The ray of this pixel.
//   screen  y from -1 to 1, x from -aspect to aspect
Ray pixelRay(vec2 screen);

// The distance of the scene from p: a signed distance in scene units, negative inside, or a lower bound of
// the signed distance.
float sceneDistance(vec3 p);

// The colour of the ray: red, green, blue in [0, 1]; main clamps values outside this range.
vec3 rayColour(Ray ray);

// Why a march ended.
const int END_NONE   = 0; // there was no march
const int END_HIT    = 1; // the scene was nearer than the threshold
const int END_PASSED = 2; // the far limit was passed
const int END_STEPS  = 3; // the steps ran out

// The record of the rays of this pixel, filled in by distanceAt, march and normalAt, and shown by the
// views and by --probe. If nothing reads the record, the compiler removes it.
struct Trace {
    int   evaluations;    // number of calls of distanceAt
    int   allSteps;       // number of steps of all marches
    int   marches;        // number of marches begun
    vec2  interval;       // tMin and tMax of the first march
    float threshold;      // of the first march, scene units: a distance below threshold + spread t was a hit
    float spread;         // of the first march, per scene unit; threshold and spread are 0 if not reported
    int   steps;          // number of steps of the first march
    float t;              // where the first march ended
    int   end;            // why the first march ended
    int   normals;        // number of normals computed
    vec3  normal;         // the first normal
    int   wanted;         // the step that a probe wants, from 0
    float wantedT;        // t at that step
    float wantedDistance; // the distance at that step
};

Trace trace;

// Clear the record. Every pixel begins with this call.
//   wanted  the step whose values a probe wants, from 0; -1 for none
void traceReset(int wanted)
{
    trace = Trace(0, 0, 0, vec2(0.0), 0.0, 0.0, 0, 0.0, END_NONE, 0, vec3(0.0), wanted, 0.0, 0.0);
}

// The scene's distance; the evaluation is counted. Marches and normals call this function, never sceneDistance.
float distanceAt(vec3 p)
{
    trace.evaluations++;
    return sceneDistance(p);
}

// Record that a march begins; the interval of the first march is kept.
void traceBegin(float tMin, float tMax)
{
    if (trace.marches == 0)
        trace.interval = vec2(tMin, tMax);
    trace.marches++;
}

// Record which distances count as a hit: those below threshold + spread t. The values of the first march are kept.
void traceThreshold(float threshold, float spread)
{
    if (trace.marches == 1) {
        trace.threshold = threshold;
        trace.spread = spread;
    }
}

// Record one step of a march.
void traceStep(int step, float t, float distance)
{
    trace.allSteps++;
    if (trace.marches == 1 && step == trace.wanted) {
        trace.wantedT = t;
        trace.wantedDistance = distance;
    }
}

// Record how a march ended; the values of the first march are kept.
void traceMarch(int steps, float t, int end)
{
    if (trace.marches == 1) {
        trace.steps = steps;
        trace.t = t;
        trace.end = end;
    }
}

// Record a normal; the first normal is kept.
void traceNormal(vec3 normal)
{
    if (trace.normals == 0)
        trace.normal = normal;
    trace.normals++;
}
