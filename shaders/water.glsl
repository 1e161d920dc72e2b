// water.glsl - a lake: waves, what remains of them in a pixel, and the sun's reflection in them.
//
// The water is level, y = 0; the waves tilt only the normal. docs/21_a_landscape.md proves the claims made here.
#include "texture.glsl"

// The slope of the water within a pixel.
struct Water {
    vec2  slope;    // the mean slope, along x and z
    float variance; // of the slope about its mean, along any one direction
};

// The footprint of a pixel on level water: footprintOn, without the limit on the length of the footprint.
//   direction  of the ray, length 1, downwards
//   width      of the ray there, scene units
Footprint footprintOnWater(vec3 direction, float width)
{
    Footprint f = footprintOn(direction, vec3(0.0, 1.0, 0.0), width);
    return Footprint(f.across, f.along * max(0.0625 / max(abs(direction.y), 1e-4), 1.0));
}

// Four waves, averaged over a pixel.
//   p        position on the water, scene units
//   f        from footprintOnWater; of size 0 for a point
//   kx, kz   wave vectors, radians per scene unit
//   steep    the largest slope of each wave
//   phase    of each wave, radians
//   returns  slope: sum of steep kept cos(k . p + phase) along each k; variance: half of the variance lost
//   formula  kept = exp(-((k . across)^2 + (k . along)^2) / 24), the mean of cos(k . x) over a Gaussian with the
//            variance of the pixel, a twelfth of each axis squared. A wave's slope has the variance steep^2 / 2 over
//            all positions; the part that the mean loses, steep^2 (1 - kept^2) / 2, is the variance about the mean.
//            Half of it is along x if the waves run in all directions
Water fourWaves(vec2 p, Footprint f, vec4 kx, vec4 kz, vec4 steep, vec4 phase)
{
    vec4 across = kx * f.across.x + kz * f.across.z, along = kx * f.along.x + kz * f.along.z;
    vec4 kept = exp(-(across * across + along * along) / 24.0);
    vec4 tilt = steep * kept * cos(kx * p.x + kz * p.y + phase) * inversesqrt(kx * kx + kz * kz);
    return Water(vec2(dot(kx, tilt), dot(kz, tilt)), 0.25 * dot(steep * steep, 1.0 - kept * kept));
}

// The reflection of a lamp in rough water: the light that facets of all slopes send to the eye, before Fresnel's share.
//   direction  of the ray, to the water, length 1
//   toLight    length 1, upwards
//   water      slope and variance, > 0
//   light      of the lamp on a white surface perpendicular to its rays, linear
//   formula    light pi P / (4 cos h_y^4), P the Gaussian density of the slope that reflects the lamp to the
//              eye, h the normal of a facet with this slope, cos = -direction.y. Exact where no facet hides another
// Source: C. Cox, W. Munk, 'Measurement of the roughness of the sea surface from photographs of the sun's
// glitter', Journal of the Optical Society of America 44 (1954).
vec3 glitter(vec3 direction, vec3 toLight, Water water, vec3 light)
{
    vec3 h = normalize(toLight - direction);
    float up = max(h.y, 0.05), square = up * up;
    vec2 off = -h.xz / up - water.slope;
    float density = exp(-0.5 * dot(off, off) / water.variance) / (6.2831853 * water.variance);
    return light * (3.1415927 * density / (4.0 * max(-direction.y, 0.01) * square * square));
}
