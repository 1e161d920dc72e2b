// A point is followed through the folds: drag it, and raise the number of levels. Each level has two folds, along the
// dashed mirrors, and the arrows show how each fold moves the point. The distance is measured only to the triangle that
// is filled with orange. Its value is at the top left and is the radius of both circles: the circle around the original
// point is empty.
#include "figure.glsl"
#include "symmetry.glsl"

uniform vec2 point;  // (0.264, -0.752) handle: the point that is folded
uniform int  levels; // 1 in [0, 6]: each level has two folds

const float SCALE = 0.88;              // units of the sheet per unit of length; the side of the triangle is 2
const vec2  CORNER = vec2(0.0, 0.92);  // upper corner of the triangle
const vec3  N1 = vec3(0.5, 0.8660254, 0.0), N2 = vec3(-0.5, 0.8660254, 0.0); // normals of the mirrors

// Convert a point of the sheet to the triangle's coordinates, whose origin is the upper corner.
vec2 trianglePoint(vec2 p)
{
    return (p - CORNER) / SCALE;
}

// The distance to the upper triangle of a level; the side of this triangle is 2 size.
float upperDistance(vec2 q, float size)
{
    return sdTriangle(q, vec2(0.0), size * vec2(-1.0, -1.7320508), size * vec2(1.0, -1.7320508));
}

// The distance to the nearest triangle of the last level.
float sceneDistance(vec3 p)
{
    vec3 q = p;
    float size = 1.0;
    for (int i = 0; i < levels; i++) {
        q = opReflect(opReflect(q, N1, size), N2, size);
        size *= 0.5;
    }
    return upperDistance(q.xy, size);
}

vec3 rayColour(Ray ray)
{
    vec2 p = trianglePoint(sheetPoint(ray)), at = trianglePoint(point);
    float d = SCALE * sceneDistance(vec3(p, 0.0)), empty = sceneDistance(vec3(at, 0.0)), size = 1.0;
    fill(d, SAND, 1.0);
    stroke(d, 1.5, ORANGE);
    fill(SCALE * upperDistance(p, exp2(-float(levels))), ORANGE, 1.0);
    fill(SCALE * (length(p - at) - abs(empty)), SKY, 0.7);
    stroke(SCALE * (length(p - at) - abs(empty)), 1.5, BLUE);
    vec3 q = vec3(at, 0.0);
    for (int i = 0; i < levels; i++) {
        vec2 from = SCALE * q.xy;
        q = opReflect(q, N1, size);
        vec2 between = SCALE * q.xy;
        q = opReflect(q, N2, size);
        vec2 foot = -size * SCALE * N1.xy, side = 1.4 * size * SCALE * vec2(0.8660254, -0.5);
        vec2 pixel = SCALE * p, mirrored = vec2(-pixel.x, pixel.y);
        dashes(pixel, foot - side, foot + side, 1.0, INK);
        dashes(mirrored, foot - side, foot + side, 1.0, INK);
        arrow(pixel, from, between, 2.0, INK);
        arrow(pixel, between, SCALE * q.xy, 2.0, INK);
        size *= 0.5;
    }
    stroke(SCALE * (length(p - q.xy) - abs(empty)), 1.5, TEAL);
    dot2(SCALE * p, SCALE * q.xy, 7.0, TEAL);
    dot2(SCALE * p, SCALE * at, 8.0, INK);
    number(sheetPoint(ray), vec2(-1.6, 0.88), empty, 3, BLUE); // distance #
    return sheetColour;
}
