// samples.glsl - one cell for each sample of a pixel: random sample positions that are also spread evenly.
#include "random.glsl"
#include "repetition.glsl"

// The integer quotient a / b, rounded down.
//   a, b     integers, 0 <= a < 2^20, b >= 1
//   formula  floor((a + 1/2) / b): the half keeps the quotient away from integers by at least 1 / (2 b), which is
//            more than the rounding error. Exact
// The software renderer llvmpipe divides integers one at a time, but floats eight at a time.
int wholeQuotient(int a, int b)
{
    return int((float(a) + 0.5) / float(b));
}

// The index of the cell that this sample takes, of iSamples cells. The samples of a pixel take each cell once.
//   dimension  one for each quantity that is sampled, >= 0: for each dimension and pixel, the order begins
//              at a different random cell, so that the mean over pixels is also right for pairs of quantities
//   returns    from 0 to iSamples - 1
//   formula    (23 iSample + r) mod iSamples, where r depends on the pixel and the dimension: a permutation,
//              because no square number below 23^2 has a factor in common with 23. Samples that are neighbours in the
//              pixel do not get neighbouring cells
int sampleCell(int dimension)
{
    // cellRandom ignores the order of the last two components, so one of them is negative, unlike every pixel's y.
    float turn = cellRandom(ivec3(iPixel, -1 - dimension));
    int cell = 23 * iSample + int(turn * float(iSamples));
    return cell - iSamples * wholeQuotient(cell, iSamples);
}

// A number in [0, 1) for this sample. The samples of a pixel have one number in each of iSamples equal parts of this
// interval; a single sample may have any number.
//   dimension  of sampleCell and of pixelRandom
float sampleLine(int dimension)
{
    return (float(sampleCell(dimension)) + pixelRandom(dimension)) / float(iSamples);
}

// A point in the unit square for this sample. The samples of a pixel have one point in each of k x k cells of the
// square, iSamples = k^2; a single sample has the middle.
//   dimension  of sampleCell; pixelRandom is called for this dimension and the next
vec2 sampleSquare(int dimension)
{
    int side = int(sqrt(float(iSamples)) + 0.5), cell = sampleCell(dimension);
    vec2 lot = iSamples > 1 ? vec2(pixelRandom(dimension), pixelRandom(dimension + 1)) : vec2(0.5);
    int row = wholeQuotient(cell, side);
    return (vec2(cell - side * row, row) + lot) / float(side);
}
