// bounds.glsl - the part of a ray that lies in a box, or in several: what is outside needs no march.
#include "scene.glsl"

// Where a ray is inside a box with faces across the axes.
//   low, high  opposite corners, scene units, low < high in each component
//   returns    (entry, exit) along the ray, entry >= 0; entry > exit when the ray misses the box
//   formula    per axis the ray is between the two faces while t is between (low - o) / d and
//              (high - o) / d; the intersection of the three intervals and of t >= 0
// A direction with a zero component divides by zero: the infinities order correctly. Only an origin
// on the face itself gives a NaN; so keep the box a little larger than what it holds.
// Source: T. L. Kay and J. T. Kajiya, 'Ray tracing complex scenes', SIGGRAPH 1986.
vec2 boxInterval(Ray ray, vec3 low, vec3 high)
{
    vec3 first = (low - ray.origin) / ray.direction;
    vec3 second = (high - ray.origin) / ray.direction;
    vec3 entry = min(first, second);
    vec3 leave = max(first, second);
    return vec2(max(0.0, max(entry.x, max(entry.y, entry.z))), min(leave.x, min(leave.y, leave.z)));
}

// The smallest interval that holds two, which may be empty: that of a scene of two parts, each in bounds
// of its own.
//   a, b     (entry, exit); empty where entry >= exit
//   returns  from the first entry to the last exit, what lies between the two included; where one is
//            empty the other as it is, where both are an empty one
vec2 intervalUnion(vec2 a, vec2 b)
{
    vec2 both = vec2(min(a.x, b.x), max(a.y, b.y));
    return a.x >= a.y ? b : (b.x >= b.y ? a : both);
}
