// Experiment of chapter 16: a frame of chapter 03 in less time. A formula finds where a ray meets
// the stage, so the stage is not part of the distance; rays are marched only in the boxes around
// the three groups of objects on the stage; the normal and the shadow share one loop.
//
// The colours are those of chapter 03. On a machine whose pixels run in lockstep, every pixel takes
// at least one iteration of each loop, so one loop fewer saves one evaluation.
#include "main.glsl"
#define sceneDistance chapterDistance
#define rayColour chapterRayColour
#include "03_shadows.frag"
#undef sceneDistance
#undef rayColour

const vec3  STAGE = vec3(0.0, -0.1, 0.0), STAGE_HALF = vec3(2.6, 0.1, 2.2); // centre and half size
const vec3  FRAME = vec3(0.4, 0.8, -0.5), BALL = vec3(1.75, 0.4, 1.2);       // centres
const vec3  BLOCK = vec3(-1.6, 0.3, 0.1), BLOCK_HALF = vec3(0.35, 0.3, 0.55);
const float MARGIN = 0.01;      // how much larger the boxes are than their contents
const float MET_BEFORE = 0.7;   // in thresholds: how far in front of the stage a march ends, on average

float squareOutside(vec3 q)
{
    q = max(q, 0.0);
    return dot(q, q);
}

float largest(vec3 q)
{
    return max(q.x, max(q.y, q.z));
}

// The scene of chapter 03 without the stage. The frame is the union of three boxes, and the block
// is a single box. Outside these four boxes, the smallest distance has the smallest square, so one
// root is enough; inside, depths need no root.
float sceneDistance(vec3 p)
{
    vec3 q = p - FRAME, outer = abs(q) - 0.8, inner = abs(outer + 0.07) - 0.07;
    vec3 alongX = vec3(outer.x, inner.yz), alongY = vec3(inner.x, outer.y, inner.z), alongZ = vec3(inner.xy, outer.z);
    vec3 block = abs(p - BLOCK) - BLOCK_HALF;
    float square = min(min(squareOutside(alongX), squareOutside(alongY)), min(squareOutside(alongZ), squareOutside(block)));
    float depth = min(min(largest(alongX), largest(alongY)), min(largest(alongZ), largest(block)));
    float balls = min(sdSphere(q, 0.36), min(sdSphere(q - vec3(0.0, 1.25, 0.0), 0.28), sdSphere(p - BALL, 0.4)));
    return min(sqrt(square) + min(depth, 0.0), balls);
}

// boxInterval of bounds.glsl for a centre and a half size, with one division for all the boxes of a
// ray.
//   inverse  1 / direction
vec2 inBox(vec3 origin, vec3 inverse, vec3 centre, vec3 halfSize)
{
    vec3 middle = inverse * (centre - origin), aside = abs(inverse) * halfSize;
    vec3 entry = middle - aside, leave = middle + aside;
    return vec2(max(0.0, max(entry.x, max(entry.y, entry.z))), min(leave.x, min(leave.y, leave.z)));
}

// The smallest interval that contains all points of a ray inside three boxes: one for the frame
// with both balls on its axis, one for the ball beside the frame, and one for the block.
vec2 groupsInterval(vec3 origin, vec3 inverse)
{
    vec2 frame = inBox(origin, inverse, vec3(0.4, 1.165, -0.5), vec3(0.8, 1.165, 0.8) + MARGIN);
    vec2 ball = inBox(origin, inverse, BALL, vec3(0.4) + MARGIN);
    vec2 block = inBox(origin, inverse, BLOCK, BLOCK_HALF + MARGIN);
    return intervalUnion(frame, intervalUnion(ball, block));
}

// The normal of the stage: the result of central differences with the step h, in closed form. Near
// an edge, both faces that meet there contribute.
vec3 stageNormal(vec3 p, float h)
{
    vec3 q = p - STAGE, outside = abs(q) - STAGE_HALF - MET_BEFORE * hitThreshold;
    vec3 others = max(outside.yzx, outside.zxy);
    return normalize(max(outside + h + step(others, outside) * clamp(-others, 0.0, h), 0.0) * sign(q));
}

vec3 rayColour(Ray ray)
{
    vec3 inverse = 1.0 / ray.direction;
    vec2 stage = inBox(ray.origin, inverse, STAGE, STAGE_HALF + MET_BEFORE * hitThreshold);
    vec2 groups = groupsInterval(ray.origin, inverse);
    bool onStage = stage.x < stage.y;
    float end = onStage ? stage.x : FAR;
    Hit hit = march(ray, groups.x, min(groups.y, end), hitThreshold, maxSteps);
    bool met = hit.found || onStage;
    vec3 p = ray.origin + (hit.found ? hit.t : end) * ray.direction;

    vec3 toLamp = sun ? lampPosition() : lampPosition() - p;
    float distance = length(toLamp);
    vec3 toLight = toLamp / distance;
    vec2 shade = groupsInterval(p, 1.0 / toLight);
    float t = shade.x, far = shadows ? min(shade.y, sun ? FAR : distance) : 0.0;

    // In iterations 0 to 5, compute the differences of a normal, as normalAt does; after that,
    // march the shadow ray. For a point on the stage, the loop begins with the shadow ray.
    int turn = hit.found ? 0 : 6;
    vec3 gradient = hit.found ? vec3(0.0) : stageNormal(p, normalStep), normal = gradient;
    bool dark = false, searching = hit.found || (onStage && t < far && dot(normal, toLight) > 0.0);
    while (searching) {
        bool tap = turn < 6;
        vec3 axis = vec3(turn == 0 || turn == 3, turn == 1 || turn == 4, turn == 2 || turn == 5);
        axis *= turn < 3 ? normalStep : -normalStep;
        float d = distanceAt(p + (tap ? axis : shadowOffset * hitThreshold * normal + t * toLight));
        gradient += tap ? d * axis : vec3(0.0);
        normal = tap ? normalize(gradient) : normal;
        dark = !tap && d < hitThreshold;
        t += tap ? 0.0 : d;
        turn++;
        searching = turn < 6 || (!dark && t < far && dot(normal, toLight) > 0.0 && turn < 6 + maxSteps);
    }

    if (met) { // report the stage to the views and the probe too
        traceNormal(normal);
        traceMarch(trace.steps, hit.found ? hit.t : end, END_HIT);
    }
    vec3 warm = dark ? vec3(0.0) : lampLight(normal, toLamp, LAMP_COLOUR);
    vec3 cold = lampLight(normal, COLD_LAMP - p, COLD_COLOUR);
    return encodeSRGB(met ? OBJECT_COLOUR * (AMBIENT + warm + cold) : skyLight(ray.direction));
}
