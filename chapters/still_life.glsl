// still_life.glsl - the objects on the table of chapter 11: their distances, and the interval in
// which a ray can meet them. Their materials are in the chapter.
//
// x points to the right, y upwards from the table, z towards the camera; scene units. If an object
// is a blend of two materials, its function returns two distances, which the chapter blends.
#include "bounds.glsl"
#include "combine.glsl"
#include "primitives.glsl"
#include "repetition.glsl"

const vec3  LOW = vec3(-0.82, -0.02, -1.20);     // opposite corners of a box around all objects except the jug
const vec3  HIGH = vec3(2.82, 1.43, 1.38);
const vec3  JUG_LOW = vec3(-2.14, -0.02, -1.16); // opposite corners of a box around the jug
const vec3  JUG_HIGH = vec3(-0.64, 1.74, 0.16);
const float HOLES = 0.24;                        // distance between neighbouring holes in the ivory cube, scene units
const float SILVER_RADIUS = 0.34;                // radius of the silver ball, scene units

// A jug: a round belly and neck, blended with each other and hollowed from above, and a handle.
float jugDistance(vec3 p)
{
    p -= vec3(-1.3, 0.62, -0.5);
    float side = length(p.xz);
    float neck = opIntersection(0.97 * (side - max(0.25, 0.25 * p.y + 0.06)), abs(p.y - 0.6) - 0.5);
    float hollow = opIntersection(side - 0.2, 0.5 - p.y);
    float handle = opIntersection(abs(length(p.xy + vec2(0.42, -0.5)) - 0.36) - 0.04, abs(p.z) - 0.075);
    return opUnion(opSubtraction(opSmoothUnion(sdSphere(p, 0.64), neck, 0.35), hollow), handle);
}

// A bowl: half a shell on a ring.
float bowlDistance(vec3 p)
{
    p -= vec3(0.45, 0.82, -0.35);
    float shell = opIntersection(abs(sdSphere(p, 0.78)) - 0.04, p.y);
    float foot = opIntersection(sdSphere(p, 0.88), abs(p.y + 0.80) - 0.03);
    return opUnion(shell, foot);
}

// A lemon: a ball with a smaller ball at each end, mirrored so that only one end is evaluated. x is
// the distance to the large ball, y the distance to the nearer small ball.
vec2 lemonDistances(vec3 p)
{
    p -= vec3(0.2, 0.93, -0.2);
    float along = abs(0.92 * p.x + 0.39 * p.y) - 0.37, across = 0.92 * p.y - 0.39 * p.x;
    return vec2(sdSphere(p, 0.33), sdSphere(vec3(along, across, p.z), 0.07));
}

// A pear: x is the distance to its lower ball, y the distance to its upper ball.
vec2 pearDistances(vec3 p)
{
    p -= vec3(1.3, 0.42, 0.55);
    return vec2(sdSphere(p, 0.43), sdSphere(p - vec3(0.05, 0.54, 0.0), 0.22));
}

float stalkDistance(vec3 p)
{
    p = abs(p - vec3(1.37, 1.27, 0.55));
    return opIntersection(max(p.x, p.z) - 0.022, p.y - 0.14);
}

float silverDistance(vec3 p)
{
    return sdSphere(p - vec3(-0.45, SILVER_RADIUS, 0.75), SILVER_RADIUS);
}

float cube(vec3 p, float halfSide)
{
    vec3 a = abs(p);
    return max(a.x, max(a.y, a.z)) - halfSide;
}

// An ivory cube minus a ball that is repeated endlessly.
float ivoryDistance(vec3 p)
{
    p -= vec3(2.3, 0.36, -0.05);
    p.xz = vec2(0.8 * p.x + 0.6 * p.z, 0.8 * p.z - 0.6 * p.x);
    vec3 q = vec3(opRepeat(p.x, HOLES), opRepeat(p.y, HOLES), opRepeat(p.z, HOLES));
    return opSubtraction(cube(p, 0.36), sdSphere(q, 0.148));
}

// A piece of wax that changes from a cube to a ball: x is the distance to the cube, y the distance to
// the ball.
vec2 waxDistances(vec3 p)
{
    p -= vec3(0.45, 0.18, 1.1);
    p.xz = vec2(0.8 * p.x - 0.6 * p.z, 0.6 * p.x + 0.8 * p.z);
    return vec2(cube(p, 0.18), sdSphere(p, 0.2));
}

// The interval in which a ray is inside the boxes around the objects.
vec2 thingsInterval(Ray ray)
{
    return intervalUnion(boxInterval(ray, LOW, HIGH), boxInterval(ray, JUG_LOW, JUG_HIGH));
}
