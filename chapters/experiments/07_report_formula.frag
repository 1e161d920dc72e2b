// Experiment of chapter 07: the report's formula (section 2.2.3), mod(x - N / 2, N) + N / 2, for the
// place in the cell. It runs from N / 2 to 3 N / 2 and never reaches 0: a lantern in the middle of
// its cell is never met, and its light neither.
//
// The chapter's calls of cellOf are turned into calls of reportCellOf.
#include "main.glsl"
#include "repetition.glsl"

// The number that the formula subtracts: x - N floor((x - N / 2) / N) is the report's place.
float reportCellOf(float x, float period)
{
    return floor((x - 0.5 * period) / period);
}

#define cellOf reportCellOf
#include "07_repetition.frag"
