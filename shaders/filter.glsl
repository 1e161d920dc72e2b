// filter.glsl - how the samples of a pixel are distributed: the filter with which they are averaged.
//
// The renderer takes the plain mean of a pixel's samples, so the filter determines their positions: where its
// weight is twice as large, the samples are twice as dense. A point of the unit square is mapped to an offset from the
// pixel's middle, in pixels, with the inverse of the filter's cumulative distribution; (1/2, 1/2) becomes (0, 0).
#include "samples.glsl"

// The position of this sample in its pixel, from (0, 0) at the lower left corner to (1, 1) at the upper right.
//   screen  as passed to pixelRay
vec2 positionInPixel(vec2 screen)
{
    return 0.5 * (screen * iResolution.y + iResolution.xy) - vec2(iPixel);
}

// An offset with the density of a tent, 1 - |x| between -1 and 1, in each coordinate.
//   u        in [0, 1], per coordinate
//   formula  sqrt(2 u) - 1 up to u = 1/2, then 1 - sqrt(2 - 2 u). The variance is 1/6
vec2 tentOffset(vec2 u)
{
    vec2 side = sqrt(2.0 * min(u, 1.0 - u));
    return mix(side - 1.0, 1.0 - side, step(0.5, u));
}

// The quantile of a share: the value below which this share of a Gaussian of standard deviation 1 lies.
//   share    in (0, 1); clamped to [1e-6, 1 - 1e-6]
//   formula  sqrt(2) inverseErf(x), x = 2 share - 1, where inverseErf(x)^2 is about sqrt(c^2 - l / 0.147) - c,
//            l = log(1 - x^2), c = 2 / (0.147 pi) + l / 2. The error is less than 0.003 within two standard
//            deviations and 0.02 at the ends. The result is exactly 0 at 1/2
// Source: S. Winitzki, 'A handy approximation for the error function and its inverse' (2008).
float gaussianQuantile(float share)
{
    float x = 2.0 * clamp(share, 1e-6, 1.0 - 1e-6) - 1.0;
    float l = log((1.0 - x) * (1.0 + x)), c = 4.3307468 + 0.5 * l;
    float square = sqrt(c * c - l / 0.147) - c;
    return 1.4142136 * sign(x) * sqrt(max(square, 0.0));
}

// The offset of a sample for one of three filters.
//   u        in the unit square
//   kernel   0 a box, the pixel itself; 1 a tent over 2 x 2 pixels; 2 a Gaussian of standard deviation 0.5 pixels
//   returns  the offset from the pixel's middle, pixels
vec2 filterOffset(vec2 u, int kernel)
{
    vec2 gaussian = 0.5 * vec2(gaussianQuantile(u.x), gaussianQuantile(u.y));
    return kernel == 0 ? u - 0.5 : (kernel == 1 ? tentOffset(u) : gaussian);
}

// The point on the screen that the ray of this sample passes through, instead of the middle of its cell.
//   screen   as passed to pixelRay
//   kernel   as for filterOffset
//   jitter   true for a random position in the sample's cell, false for the middle of the cell. A single
//            sample stays in the pixel's middle
//   dimension  of pixelRandom; this dimension and the next are used
//   returns  a point on the screen, for perspectiveRay
vec2 filteredScreen(vec2 screen, int kernel, bool jitter, int dimension)
{
    vec2 lot = vec2(pixelRandom(dimension), pixelRandom(dimension + 1)) - 0.5;
    float cell = jitter && iSamples > 1 ? inversesqrt(float(iSamples)) : 0.0;
    vec2 offset = filterOffset(positionInPixel(screen) + cell * lot, kernel);
    return screenPosition(vec2(iPixel) + 0.5 + offset);
}
