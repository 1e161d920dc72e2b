// Twelve solids for the price of two: drag the point. Four folds, the first two of which share an arrow, bring the
// point into the wedge between the mirrors at 0 and 30 degrees, where only a ball and a die are evaluated. At the top
// left is the distance from the point to the nearest of all twelve solids; below it is the distance from the folded
// point to the nearer of the two.
#include "figure.glsl"
#include "hue.glsl"
#include "lighting.glsl"

uniform vec2 point; // (-0.21, -0.57) handle: the point; z points down

const float SCALE = 0.3, RING = 2.5;           // units per scene unit; radius of the wheel, scene units
const vec2  MIRROR_60 = vec2(0.8660254, -0.5); // normals of two mirrors
const vec2  MIRROR_30 = vec2(0.5, -0.8660254);

float sceneDistance(vec3 p)
{
    return p.z;
}

vec2 folded(vec2 q, vec2 normal)
{
    return q - 2.0 * min(dot(q, normal), 0.0) * normal;
}

// The distance to the solid at 30 i degrees: a ball if i is even, otherwise a die.
float solidDistance(vec2 q, int i)
{
    float c = cos(radians(30.0 * float(i))), s = sin(radians(30.0 * float(i)));
    vec2 own = vec2(c * q.x + s * q.y - RING, c * q.y - s * q.x);
    float die = opIntersection(sdRectangle(own, vec2(0.33)), sdCircle(own, 0.45));
    return i % 2 == 0 ? sdCircle(own, 0.4) : die;
}

float wheelDistance(vec2 q, int solids)
{
    float d = 1e6;
    for (int i = 0; i < solids; i++)
        d = opUnion(d, solidDistance(q, i));
    return d;
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), q = vec2(p.x, -p.y) / SCALE;
    vec2 at = vec2(point.x, -point.y) / SCALE, step1 = abs(at);
    vec2 step2 = folded(step1, MIRROR_60), step3 = folded(step2, MIRROR_30);
    float all = wheelDistance(at, 12), two = wheelDistance(step3, 2);
    float angle = degrees(atan(q.y, q.x + 1e-6));
    fill(max(length(q) - 3.2, max(-q.y, dot(q, MIRROR_30) < 0.0 ? 1.0 : -1.0)) * SCALE, SAND, 1.0);
    fill((length(q - at) - abs(all)) * SCALE, SKY, 0.6);
    fill((length(q - step3) - abs(two)) * SCALE, SKY, 0.6);
    for (int i = 0; i < 6; i++) {
        vec2 along = 0.96 * vec2(cos(radians(30.0 * float(i))), sin(radians(30.0 * float(i))));
        dashes(p, -along, along, 0.8, PALE);
    }
    float d = wheelDistance(q, 12) * SCALE;
    fill(d, encodeSRGB(hsvToRGB(30.0 * floor(angle / 30.0 + 0.5), 0.9, 0.85)), 1.0);
    stroke(d, 1.5, INK);
    stroke((length(q - at) - abs(all)) * SCALE, 1.5, BLUE);
    stroke((length(q - step3) - abs(two)) * SCALE, 1.5, TEAL);
    arrow(q * SCALE, at * SCALE, step1 * SCALE, 2.0, INK);
    arrow(q * SCALE, step1 * SCALE, step2 * SCALE, 2.0, INK);
    arrow(q * SCALE, step2 * SCALE, step3 * SCALE, 2.0, INK);
    dot2(p, point, 8.0, INK);
    dot2(q * SCALE, step3 * SCALE, 7.0, TEAL);
    number(p, vec2(-1.55, 0.85), all, 3, BLUE); // of twelve solids #
    number(p, vec2(-1.55, 0.74), two, 3, TEAL); // of two solids #
    return sheetColour;
}
