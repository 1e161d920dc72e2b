// water.glsl - a lake: waves, what of them a pixel sees, and what it sees in them.
#include "texture.glsl"

// The water where a ray meets it, as its pixel sees it.
struct Water {
    vec2  slope;    // of the waves, the mean over the pixel
    float variance; // of the slope about that mean, along any one direction
};

// Four waves: wave numbers along x and z, amplitudes of their slope, phases.
//   f        footprint of the pixel on the water
//   formula  over a pixel that weighs as a Gaussian of the box's variance, the mean of cos(k . p) is
//            cos(k . p) exp(-((k . across)^2 + (k . along)^2) / 24); what the mean loses of each wave's
//            variance, slope^2 / 2, is left to the pixel
Water fourWaves(vec2 p, Footprint f, vec4 kx, vec4 kz, vec4 slope, vec4 phase)
{
    vec4 across = kx * f.across.x + kz * f.across.z, along = kx * f.along.x + kz * f.along.z;
    vec4 kept = exp(-(across * across + along * along) / 24.0);
    vec4 tilt = slope * kept * cos(kx * p.x + kz * p.y + phase) * inversesqrt(kx * kx + kz * kz);
    float lost = 0.25 * dot(slope * slope, 1.0 - kept * kept);
    return Water(vec2(dot(kx, tilt), dot(kz, tilt)), lost);
}

// The sun in rough water: its light that facets of every slope send to the eye.
//   direction  of the ray, to the water, length 1
//   toLight    length 1
//   water      its slope and variance, > 0
//   light      on a white surface across its rays, linear
//   formula    light pi P / (4 cos h_y^4), P the Gaussian density of the slope that mirrors toLight to the
//              eye, h the normal of that facet, cos that of the angle between eye and the level. Times
//              Fresnel's share
// Source: C. Cox, W. Munk, 'Measurement of the roughness of the sea surface from photographs of the sun's
// glitter', Journal of the Optical Society of America 44 (1954).
vec3 glitter(vec3 direction, vec3 toLight, Water water, vec3 light)
{
    vec3 h = normalize(toLight - direction);
    vec2 off = -h.xz / max(h.y, 0.05) - water.slope;
    float density = exp(-0.5 * dot(off, off) / water.variance) / (6.2831853 * water.variance);
    float up = max(h.y * h.y, 0.05);
    return light * 3.14159265 * density / (4.0 * max(-direction.y, 0.03) * up * up);
}
