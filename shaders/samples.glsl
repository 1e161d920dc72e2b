// samples.glsl - one cell for each sample of a pixel: places that are spread, and not by lot alone.
#include "random.glsl"
#include "repetition.glsl"

// How often one whole number is in another: a / b, rounded down.
//   a, b     whole numbers, 0 <= a < 2^20, b >= 1
//   formula  floor((a + 1/2) / b): the half keeps the quotient off whole numbers by 1 / (2 b), which is more
//            than its rounding. Exact
// A processor that draws divides whole numbers one by one, and floats eight at once.
int wholeQuotient(int a, int b)
{
    return int((float(a) + 0.5) / float(b));
}

// Which of iSamples cells this sample takes, so that the samples of a pixel take all, each one.
//   dimension  one for each thing that is sampled, >= 0: between two of them, and between pixels, the order
//              begins at another place, drawn by lot, so that the mean over pixels is right for pairs too
//   returns    from 0 to iSamples - 1
//   formula    (23 iSample + r) mod iSamples, r the pixel's and the dimension's own: a permutation, since no
//              square number below 23^2 has a factor in common with 23. So neighbours within the pixel do not
//              get neighbouring cells
int sampleCell(int dimension)
{
    float turn = cellRandom(ivec3(iPixel, -1 - dimension)); // negative, for it must not be taken for a pixel's y
    int cell = 23 * iSample + int(turn * float(iSamples));
    return cell - iSamples * wholeQuotient(cell, iSamples);
}

// A number of this sample between 0 and 1, one in each of iSamples equal parts: anywhere with one sample.
//   dimension  of sampleCell; takes the number of the same dimension of pixelRandom too
float sampleLine(int dimension)
{
    return (float(sampleCell(dimension)) + pixelRandom(dimension)) / float(iSamples);
}

// A place of this sample in the unit square, one in each of its k x k cells, iSamples = k^2; the middle with
// one sample.
//   dimension  of sampleCell; takes this one and the next of pixelRandom
vec2 sampleSquare(int dimension)
{
    int side = int(sqrt(float(iSamples)) + 0.5), cell = sampleCell(dimension);
    vec2 lot = iSamples > 1 ? vec2(pixelRandom(dimension), pixelRandom(dimension + 1)) : vec2(0.5);
    int row = wholeQuotient(cell, side);
    return (vec2(cell - side * row, row) + lot) / float(side);
}
