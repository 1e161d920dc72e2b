// Experiment of chapter 10: figures of the plane, extruded along a line or revolved about an axis.
// They become cut stone and turned clay in the light of a low lamp.
#include "main.glsl"
#include "camera.glsl"     // perspectiveRay
#include "cone.glsl"       // marchCone, coneReaching, pixelSpread
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdSphere, sdBox
#include "combine.glsl"    // opSubtraction, opSmoothUnion
#include "transform.glsl"  // Pose, seenFrom, sdTorus
#include "plane.glsl"      // sdCircle, sdSegment, sdTriangle, sdArc, opRound, opOnion
#include "solids.glsl"     // opExtrude, opRevolve, sdHexPrism, sdCappedCone, sdCapsule
#include "lighting.glsl"   // lambert, fallOff, encodeSRGB
#include "shadow.glsl"     // shadowRay, shadowReach

uniform int   maxSteps;     // 160 in [1, 512]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.001 in [0.00001, 0.2] step *2, scene units: distance that counts as a hit

const float FAR = 24.0;
const vec3  LAMP = vec3(-9.2, 4.9, 6.9);              // position of the lamp
const vec3  LAMP_COLOUR = vec3(1.30, 1.15, 0.93);     // light of the lamp at the distance REFERENCE, linear RGB
const float REFERENCE = 11.2;                         // scene units
const vec3  FILL_COLOUR = vec3(0.10, 0.13, 0.20);     // bluish ambient light, stronger from above
const vec3  PAPER = vec3(0.84, 0.79, 0.70);
const vec3  STONE = vec3(0.74, 0.72, 0.68);
const vec3  CLAY = vec3(0.60, 0.14, 0.035);
const vec3  INK = vec3(0.012, 0.018, 0.045);
const vec3  VASE = vec3(-1.2, 0.0, -0.25);            // position of the vase
const Pose  ROSE = Pose(vec3(1.32, 0.95, -0.50),      // turned by -36 degrees about y, towards the lamp
                        mat3(0.8090170, 0.0, 0.5877853, 0.0, 1.0, 0.0, -0.5877853, 0.0, 0.8090170));

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// ---- Figures of the plane ----

// A rose window: a disc with eight lights (large openings), eight round eyes and a hole in the
// centre cut out. It is symmetric about eight mirrors. After the folds along these mirrors, only
// one light and one eye remain.
float roseFigure(vec2 q)
{
    q = abs(q);
    q = vec2(max(q.x, q.y), min(q.x, q.y));
    q -= 2.0 * min(dot(q, vec2(0.38268343, -0.92387953)), 0.0) * vec2(0.38268343, -0.92387953);
    float wedge = opRound(sdTriangle(q, vec2(0.26, 0.0), vec2(0.49, 0.115), vec2(0.49, -0.115)), 0.04);
    float light = min(wedge, sdCircle(q - vec2(0.51, 0.0), 0.155));
    float eye = sdCircle(q - 0.70 * vec2(0.92387953, 0.38268343), 0.075);
    return opSubtraction(sdCircle(q, 0.84), min(light, min(eye, sdCircle(q, 0.11))));
}

// An arc whose middle lies in a given direction from its centre.
float arcTowards(vec2 q, vec2 centre, float degrees, float radius, float halfDegrees)
{
    vec2 m = vec2(cos(radians(degrees)), sin(radians(degrees)));
    vec2 d = q - centre;
    return sdArc(vec2(m.y * d.x - m.x * d.y, dot(m, d)), radius, radians(halfDegrees));
}

// Half of the vase's cross-section: foot, belly, shoulder and neck are arcs that join smoothly, and
// the base is a segment. The wall is a stroke along these five lines.
float vaseFigure(vec2 q)
{
    float foot = arcTowards(q, vec2(0.3543, 0.17), 186.885, 0.16, 50.655);
    float belly = arcTowards(q, vec2(-0.70, 1.18), -21.885, 1.30, 21.885);
    float shoulder = arcTowards(q, vec2(0.12, 1.18), 29.6, 0.48, 29.6);
    float neck = arcTowards(q, vec2(0.5194, 1.85), 178.6, 0.30, 60.6);
    float base = sdSegment(q, vec2(0.0, 0.035), vec2(0.2684, 0.035));
    return opRound(min(min(min(foot, belly), min(shoulder, neck)), base), 0.032);
}

// ---- Solids made from them ----

// The rose window, extruded, with a thicker rim, a thicker hub and a plinth.
float roseDistance(vec3 p)
{
    vec3 q = seenFrom(ROSE, p);
    float wheel = opExtrude(roseFigure(q.xy), q.z, 0.05);
    float rim = opExtrude(opOnion(sdCircle(q.xy, 0.835), 0.07), q.z, 0.085);
    float hub = opExtrude(opOnion(sdCircle(q.xy, 0.15), 0.035), q.z, 0.075);
    float plinth = sdBox(q - vec3(0.0, -0.89, 0.0), vec3(0.42, 0.06, 0.22));
    return opRound(min(min(wheel, rim), min(hub, plinth)), 0.012);
}

// The vase, revolved, and a ring.
float clayDistance(vec3 p)
{
    float vase = vaseFigure(opRevolve(p - VASE, 0.0));
    return min(vase, sdTorus(p - vec3(-2.15, 0.12, 0.55), 0.33, 0.12));
}

float stoneDistance(vec3 p)
{
    float cone = sdCappedCone(p - vec3(-0.42, 0.5, 0.62), 0.40, 0.0, 0.5);
    float prism = sdHexPrism(p - vec3(2.2, 0.25, 0.95), 0.34, 0.25);
    float ball = sdSphere(p - vec3(2.2, 0.74, 0.95), 0.24);
    float rod = sdCapsule(p, vec3(0.42, 0.12, 1.08), vec3(1.16, 0.12, 0.98), 0.12);
    return min(roseDistance(p), min(min(cone, prism), min(ball, rod)));
}

// A sheet of paper, hung up and rolled out, serves as both table and wall.
float paperDistance(vec3 p)
{
    return opSmoothUnion(p.y, p.z + 1.9, 1.2);
}

float sceneDistance(vec3 p)
{
    return min(paperDistance(p), min(clayDistance(p), stoneDistance(p)));
}

vec3 colourAt(vec3 p)
{
    float paper = paperDistance(p), clay = clayDistance(p), stone = stoneDistance(p);
    float bands = min(abs(abs(p.y - 1.18) - 0.07), abs(p.y - 1.90));
    vec3 painted = mix(INK, CLAY, smoothstep(0.018, 0.022, bands));
    return paper < min(clay, stone) ? PAPER : (clay < stone ? painted : STONE);
}

// The light of the lamp, whose visibility is estimated with a cone as wide as the lamp, and the
// ambient light, which is weaker where objects are close together.
vec3 lightAt(vec3 p, vec3 normal)
{
    vec3 toLamp = LAMP - p;
    float away = length(toLamp);
    toLamp /= away;
    Ray ray = shadowRay(p, normal, toLamp, 0.012);
    float seen = coneReaching(ray, 0.0, shadowReach(normal, toLamp, away), 0.004, 0.011, maxSteps);
    Ray up = shadowRay(p, normal, normalize(normal + vec3(0.1, 0.9, 0.3)), 0.012);
    float open = 0.45 + 0.55 * coneReaching(up, 0.0, 3.0, 0.03, 0.55, 64);
    return LAMP_COLOUR * fallOff(away, REFERENCE) * seen * lambert(normal, toLamp) +
           FILL_COLOUR * open * (0.6 + 0.4 * normal.y);
}

vec3 rayColour(Ray ray)
{
    Hit hit = marchCone(ray, 0.0, FAR, hitThreshold, 0.5 * pixelSpread(), maxSteps);
    vec3 p = ray.origin + hit.t * ray.direction;
    return encodeSRGB(colourAt(p) * lightAt(p, normalAt(p, 0.002)));
}
