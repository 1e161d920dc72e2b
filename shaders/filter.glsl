// filter.glsl - how the samples of a pixel lie: the filter that their mean is taken with.
//
// The renderer takes the plain mean of a pixel's samples. So a filter is in their places: where it weighs
// twice as much, they lie twice as dense. A place of the unit square is mapped to an offset from the
// pixel's middle, in pixels, through the filter's cumulative share; (1/2, 1/2) always to (0, 0).
#include "samples.glsl"

// The place of this sample within its pixel, (0, 0) the pixel's lower left corner, (1, 1) the upper right.
//   screen  as pixelRay gets it
vec2 placeInPixel(vec2 screen)
{
    return 0.5 * (screen * iResolution.y + iResolution.xy) - vec2(iPixel);
}

// An offset with the density of a tent, 1 - |x| between -1 and 1, in each coordinate.
//   place    in [0, 1]
//   formula  sqrt(2 u) - 1 up to u = 1/2, else 1 - sqrt(2 - 2 u). Variance 1/6
vec2 tentOffset(vec2 place)
{
    vec2 side = sqrt(2.0 * min(place, 1.0 - place));
    return mix(side - 1.0, 1.0 - side, step(0.5, place));
}

// The number below which a share of a Gaussian of standard deviation 1 lies.
//   share    in (0, 1); moved to [1e-6, 1 - 1e-6]
//   formula  sqrt(2) inverseErf(x), x = 2 share - 1, with inverseErf(x)^2 nearly sqrt(c^2 - l / 0.147) - c,
//            l = log(1 - x^2), c = 2 / (0.147 pi) + l / 2: off by less than 0.003 within two standard
//            deviations, by 0.02 at the ends. Exactly 0 at 1/2
// Source: S. Winitzki, 'A handy approximation for the error function and its inverse' (2008).
float gaussianQuantile(float share)
{
    float x = 2.0 * clamp(share, 1e-6, 1.0 - 1e-6) - 1.0;
    float l = log((1.0 - x) * (1.0 + x)), c = 4.3307468 + 0.5 * l;
    float square = sqrt(c * c - l / 0.147) - c;
    return 1.4142136 * sign(x) * sqrt(max(square, 0.0));
}

// The offset of a place by one of three filters.
//   place    in the unit square
//   kernel   0 box: the pixel itself. 1 tent, over 2 x 2 pixels. 2 Gaussian of standard deviation 0.5
//   returns  from the pixel's middle, pixels
vec2 filterOffset(vec2 place, int kernel)
{
    vec2 gaussian = 0.5 * vec2(gaussianQuantile(place.x), gaussianQuantile(place.y));
    return kernel == 0 ? place - 0.5 : (kernel == 1 ? tentOffset(place) : gaussian);
}

// Where the ray of this sample goes, in place of the middle of its cell.
//   screen   as pixelRay gets it
//   kernel   of filterOffset
//   jitter   whether the sample goes anywhere in its cell, in place of the cell's middle; with one sample it
//            stays in the pixel's middle
//   dimension  of pixelRandom; takes this one and the next
//   returns  a place of the screen, for perspectiveRay
vec2 filteredScreen(vec2 screen, int kernel, bool jitter, int dimension)
{
    vec2 lot = vec2(pixelRandom(dimension), pixelRandom(dimension + 1)) - 0.5;
    float cell = jitter && iSamples > 1 ? inversesqrt(float(iSamples)) : 0.0;
    vec2 offset = filterOffset(placeInPixel(screen) + cell * lot, kernel);
    return screenPosition(vec2(iPixel) + 0.5 + offset);
}
