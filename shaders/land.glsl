// land.glsl - mountains from noise: a ground of height h(x, z), its slope, and how far a ray may advance above it.
//
// Heights and positions are in scene units. A ground is given by its height (x) and its gradient (yz).
// docs/21_a_landscape.md proves the claims made here.
#include "noise.glsl"

// Value noise on the plane: the slice y = 0 of valueNoise, at half the cost.
//   p        scene units
//   returns  value in [0, 1) up to rounding, about 1e-6; gradient, which is never longer than VALUE_STRETCH
vec3 groundNoise(vec2 p)
{
    vec2 corner = floor(p), x = p - corner;
    uvec2 steps = uvec2(ivec2(corner)) * LATTICE_STEP.xz;
    uvec4 corners = uvec4(0u, LATTICE_STEP.x, LATTICE_STEP.z, LATTICE_STEP.x + LATTICE_STEP.z);
    vec4 v = vec4(ivec4(stirredBits(steps.x + steps.y + corners) >> 8u)) / 16777216.0;
    vec2 q = x * (1.0 - x), u = x * x * x * (x * (6.0 * x - 15.0) + 10.0);
    vec2 rise = v.zw - v.xy, row = v.xy + u.y * rise;
    float growth = row.y - row.x;
    return vec3(row.x + u.x * growth, 30.0 * q * q * vec2(growth, rise.x + u.x * (rise.y - rise.x)));
}

// Ridges: the lines on which noise is 1/2 become crests.
//   noise    from groundNoise
//   returns  value in [0, 1], up to rounding, about 2e-6, and gradient, which is never longer than 2
//            VALUE_STRETCH
//   formula  1 - |2 n - 1|
// Source: F. K. Musgrave, in D. S. Ebert and others, 'Texturing and modeling' (1994), ridged multifractals.
vec3 ridged(vec3 noise)
{
    float s = 2.0 * noise.x - 1.0;
    return vec3(1.0 - abs(s), -2.0 * sign(s) * noise.yz);
}

// A round hill on a plain.
//   p        relative to the top
//   radius   along each axis, > 0; outside the ellipse the height is 0
//   height   of the top
//   returns  height, gradient, which is never longer than HILL_STRETCH height / the smaller radius
//   formula  height max(1 - |p / radius|^2, 0)^2
vec3 hill(vec2 p, vec2 radius, float height)
{
    vec2 inverse = 1.0 / radius, r = p * inverse;
    float w = max(1.0 - dot(r, r), 0.0);
    return vec3(height * w * w, -4.0 * height * w * r * inverse);
}

const float HILL_STRETCH = 1.5396007; // 8 sqrt(3) / 9: the steepest slope of (1 - r^2)^2, at r = 1 / sqrt(3)

// The higher of two grounds. It is no steeper than the steeper of the two.
vec3 higherGround(vec3 a, vec3 b)
{
    return a.x > b.x ? a : b;
}

// A lower bound of the distance at which a gap has closed, if after a length s it closes by at most slope + growth s
// per unit of length.
//   gap      between the ray and the ground here; if it is negative, below the ground, so is the result
//   slope    how fast the gap can close here, per unit of length, > 0
//   growth   how fast the slope can grow, per unit of length, >= 0
//   returns  scene units: the s with slope s + growth s^2 / 2 = gap; a lower bound of the distance
//   formula  2 gap / (slope + sqrt(slope^2 + 2 growth gap))
float wayToClose(float gap, float slope, float growth)
{
    return 2.0 * gap / (slope + sqrt(max(slope * slope + 2.0 * growth * gap, 1e-9)));
}
