// land.glsl - mountains from noise: a ground of height h(x, z), its slope, and how far a ray may go over it.
//
// A ground is y = h(x, z). Its octaves of noise are at least 0, so each raises it; what is still to come is
// at most the sum of their weights. docs/21_a_landscape.md proves what is claimed here.
#include "noise.glsl"

// Value noise on the plane: the slice y = 0 of valueNoise, at half its price.
//   p        scene units
//   returns  value (x) in [0, 1), gradient (yz), which is never longer than VALUE_STRETCH
vec3 groundNoise(vec2 p)
{
    vec2 corner = floor(p), x = p - corner;
    uvec2 steps = uvec2(ivec2(corner)) * LATTICE_STEP.xz;
    uvec4 bits = stirredBits(steps.x + steps.y + uvec4(0u, LATTICE_STEP.x, LATTICE_STEP.z, LATTICE_STEP.x + LATTICE_STEP.z));
    vec4 v = vec4(ivec4(bits >> 8u)) / 16777216.0;
    vec2 q = x * (1.0 - x), u = x * x * x * (x * (6.0 * x - 15.0) + 10.0);
    vec2 rise = v.zw - v.xy, row = v.xy + u.y * rise;
    float growth = row.y - row.x;
    return vec3(row.x + u.x * growth, 30.0 * q * q * vec2(growth, rise.x + u.x * (rise.y - rise.x)));
}

// Ridges: the lines where noise is 1/2 become crests.
//   noise    of groundNoise
//   returns  value (x) in [0, 1], gradient (yz), which is never longer than 2 VALUE_STRETCH
//   formula  1 - |2 n - 1|
vec3 ridged(vec3 noise)
{
    float s = 2.0 * noise.x - 1.0;
    return vec3(1.0 - abs(s), -2.0 * sign(s) * noise.yz);
}

// A round hill on a plain.
//   p        scene units, from the top
//   radius   along both axes, scene units, > 0; outside it is 0
//   height   scene units
//   returns  height (x), gradient (yz), which is never longer than HILL_STRETCH height / the smaller radius
//   formula  height max(1 - |p / radius|^2, 0)^2
vec3 hill(vec2 p, vec2 radius, float height)
{
    vec2 inverse = 1.0 / radius, r = p * inverse;
    float w = max(1.0 - dot(r, r), 0.0);
    return vec3(height * w * w, -4.0 * height * w * r * inverse);
}

const float HILL_STRETCH = 1.5396007; // 8 sqrt(3) / 9: the slope of (1 - r^2)^2 at r = 1 / sqrt(3)

// The higher of two grounds: height (x), gradient (yz). No steeper than the steeper of the two.
vec3 higherGround(vec3 a, vec3 b)
{
    return a.x > b.x ? a : b;
}

// How fast a ray can come nearer to a ground, per scene unit of its way: the stretch of y - h along it,
// forwards alone.
//   slope      the largest |grad h|, >= 0
//   direction  of the ray, length 1
//   returns    > 0; (y - h) over it is a lower bound of the way to the ground, and of nothing else. A ray that
//              climbs more steeply than slope never meets it: 0.001 then
//   formula    max(slope |(v_x, v_z)| - v_y, 0.001)
float approachStretch(float slope, vec3 direction)
{
    return max(slope * length(direction.xz) - direction.y, 0.001);
}
