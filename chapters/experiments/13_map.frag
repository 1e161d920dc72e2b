// Experiment of chapter 13: the shadows of three objects on a floor that is perpendicular to the
// light. The columns are a half-plane, a ball and a thin bar. In each field, the horizontal axis is
// the position of the point on the floor, and the vertical axis is the height of the object. The
// rows show the visible share of the lamp: in closed form, from one march with the smallest
// distance / t, and from one march with pairs of steps.
#include "main.glsl"
#include "lighting.glsl"
#include "primitives.glsl"
#include "soft_shadow.glsl"

uniform float spread;       // 0.1 in [0.01, 0.3] step *1.1: radius of the lamp's disc at a distance of one unit
uniform bool  errors;       // false: paint the error: blue is too dark, orange too light
uniform float hitThreshold; // 0.0005 in [0.00001, 0.1] step *2, scene units: distance that counts as a hit

const float BALL = 0.22, BAR = 0.04;         // radii, scene units
const vec3  UP = vec3(0.0, 1.0, 0.0);        // the lamp's direction
const vec3  DARKER = vec3(0.03, 0.16, 0.50), LIGHTER = vec3(0.85, 0.32, 0.02);

int   thing;  // 0 half-plane, 1 ball, 2 bar
float height; // the object's height above the floor, scene units

Ray pixelRay(vec2 screen)
{
    return Ray(vec3(screen, 0.0), vec3(0.0, 0.0, -1.0));
}

// The distance to the object or the floor, whichever is nearer. The floor is slightly below the
// shaded point.
float sceneDistance(vec3 p)
{
    vec3 q = p - height * UP;
    float sheet = length(vec2(max(q.x, 0.0), q.y));
    float bar = length(q.xy) - BAR;
    float distance = thing == 0 ? sheet : (thing == 1 ? sdSphere(q, BALL) : bar);
    return min(distance, p.y + 0.002);
}

// The share of the lamp that is visible from a point on the floor, past one edge, past a ball, or
// past both edges of a bar.
//   x  position relative to the edge or the centre, scene units
float truth(float x)
{
    vec3 p = vec3(x, 0.0, 0.0), along = vec3(0.0, 0.0, 1.0);
    // Tangents of angles: half the angle that the bar subtends, and the directions of its middle
    // and its edges.
    float wide = BAR / sqrt(max(height * height + x * x - BAR * BAR, 1e-6));
    float middle = abs(x) / height;
    float near = (middle - wide) / (1.0 + middle * wide), far = (middle + wide) / (1.0 - middle * wide);
    float bar = discBesideEdge(near / spread) + 1.0 - discBesideEdge(far / spread);
    float ball = lampBesideBall(p, UP, spread, height * UP, BALL);
    float edge = lampBesideEdge(p, UP, spread, height * UP, along);
    return thing == 0 ? edge : (thing == 1 ? ball : bar);
}

vec3 rayColour(Ray ray)
{
    float column = (ray.origin.x + 16.0 / 9.0) * 27.0 / 32.0, row = 1.5 * (1.0 - ray.origin.y); // 3 columns, 3 rows
    thing = clamp(int(column), 0, 2);
    height = 0.3 + 2.7 * (1.0 - fract(row));
    float x = 1.15 * (fract(column) - 0.5);
    Clearance clearance = clearanceAlong(Ray(vec3(x, 0.0, 0.0), UP), 0.0, 9.0, hitThreshold, 128);
    float right = truth(x);
    float quick = min((row < 2.0 ? clearance.most : clearance.least) / spread, 1.0);
    float seen = row < 1.0 ? right : quick, off = seen - right;
    vec3 stone = mix(vec3(0.22, 0.26, 0.36), vec3(0.92, 0.82, 0.70), seen);
    vec3 wrong = mix(vec3(0.9), off < 0.0 ? DARKER : LIGHTER, min(1.5 * abs(off), 1.0));
    vec2 edge = min(fract(vec2(column, row)), 1.0 - fract(vec2(column, row)));
    return encodeSRGB(min(edge.x, edge.y) < 0.012 ? vec3(1.0) : (errors && row >= 1.0 ? wrong : stone));
}
