// random.glsl - random numbers for the samples of a pixel.
#include "inputs.glsl"

// Four integers that look random, from four integers: where one bit differs, each bit of the result changes half of
// the time.
//   formula  pcg4d: v = 1664525 v + 1013904223, then x += y w, y += z x, z += x y, w += y z, then v ^= v >> 16, and the
//            four sums again; all modulo 2^32
// Source: M. Jarzynski, M. Olano, 'Hash functions for GPU rendering', Journal of Computer Graphics
// Techniques 9 (2020).
uvec4 hashOf(uvec4 v)
{
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v ^= v >> 16u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

// A number that looks random: uniformly distributed over [0, 1), independent of the numbers of other pixels, samples
// and dimensions. For a given pixel, sample and dimension it is the same on every machine and never depends on
// the time, so a picture remains a function of its options, and a film does not flicker.
//   dimension  index of this number within the sample, >= 0: if a point in a disc uses 0 and 1, the next
//              quantity begins at 2; the same dimension always gives the same number
//   formula    the upper 24 bits of the first number of hashOf (x and y of iPixel, iSample, dimension), divided by
//              2^24, which a float represents exactly
float pixelRandom(int dimension)
{
    uvec4 v = hashOf(uvec4(uvec2(iPixel), uint(iSample), uint(dimension)));
    return float(v.x >> 8u) / 16777216.0;
}
