// bounds.glsl - the interval in which a ray is inside a box or several boxes; the rest of the ray needs no march.
#include "scene.glsl"

// The interval in which a ray is inside a box with axis-aligned faces.
//   low, high  opposite corners, scene units, low < high in each component
//   returns    (entry, exit) along the ray, entry >= 0; entry > exit if the ray misses the box
//   formula    on each axis, the ray is between the two faces while t is between (low - o) / d and
//              (high - o) / d; the result is the intersection of the three intervals and of t >= 0
// A component of the direction that is 0 causes a division by 0. GLSL 3.30 leaves the quotient unspecified; if it
// is infinite, as IEEE 754 and later versions of GLSL require, the result is still correct. In that case only an
// origin in the plane of a face gives a NaN, so make the box a little larger than its contents.
// Source: T. L. Kay and J. T. Kajiya, 'Ray tracing complex scenes', SIGGRAPH 1986.
vec2 boxInterval(Ray ray, vec3 low, vec3 high)
{
    vec3 first = (low - ray.origin) / ray.direction;
    vec3 second = (high - ray.origin) / ray.direction;
    vec3 entry = min(first, second);
    vec3 leave = max(first, second);
    return vec2(max(0.0, max(entry.x, max(entry.y, entry.z))), min(leave.x, min(leave.y, leave.z)));
}

// The smallest interval that contains two intervals, either of which may be empty. Use it for a scene of two
// parts, each with its own bounds.
//   a, b     (entry, exit); empty where entry >= exit
//   returns  from the first entry to the last exit, including any gap between the two; the other interval,
//            unchanged, if one is empty; an empty interval if both are empty
vec2 intervalUnion(vec2 a, vec2 b)
{
    vec2 both = vec2(min(a.x, b.x), max(a.y, b.y));
    return a.x >= a.y ? b : (b.x >= b.y ? a : both);
}
