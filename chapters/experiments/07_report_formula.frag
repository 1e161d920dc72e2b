// Experiment of chapter 07: the report's formula (section 2.2.3), mod(x - N / 2, N) + N / 2, for
// the position in the cell, where N is the period. Its values lie between N / 2 and 3 N / 2 and are
// never 0. The lanterns hang at position 0, so rays never hit them, and their light is missing too.
//
// A macro replaces the chapter's calls to cellOf with calls to reportCellOf.
#include "main.glsl"
#include "repetition.glsl"

// The number of periods that the formula subtracts: the report's position is
// x - N floor((x - N / 2) / N).
float reportCellOf(float x, float period)
{
    return floor((x - 0.5 * period) / period);
}

#define cellOf reportCellOf
#include "07_repetition.frag"
