// random.glsl - numbers without a pattern for the samples of a pixel.
#include "inputs.glsl"

// A number that looks drawn by lot: evenly spread over [0, 1), without relation to that of another pixel,
// sample or dimension. It is the same for the same three on every machine, and never depends on the time:
// a picture stays a function of its options, and a film does not flicker.
//   dimension  which number of this sample, >= 0: a point in a disc takes two, 0 and 1, what comes after it
//              2 and so on; who asks for one dimension twice gets one number twice
//   formula    pcg4d of (x and y of iPixel, iSample, dimension), all modulo 2^32; the upper 24 bits of the
//              first component over 2^24, which a float holds exactly
// Source: M. Jarzynski, M. Olano, 'Hash functions for GPU rendering', Journal of Computer Graphics
// Techniques 9 (2020).
float pixelRandom(int dimension)
{
    uvec4 v = uvec4(uvec2(iPixel), uint(iSample), uint(dimension)) * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v ^= v >> 16u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return float(v.x >> 8u) / 16777216.0;
}
