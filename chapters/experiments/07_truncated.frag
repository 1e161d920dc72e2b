// Experiment of chapter 07: the index of the cell is rounded towards zero, as C's % and fmod round
// a quotient. For x >= -N / 2, where N is the period, the result is the same as with floor. Below
// that, every cell has the index of its neighbour, so the position in the cell is off by a whole
// period, and the lantern is missing.
//
// A macro replaces the chapter's calls to cellOf with calls to truncatedCellOf.
#include "main.glsl"
#include "repetition.glsl"

float truncatedCellOf(float x, float period)
{
    return trunc(x / period + 0.5);
}

#define cellOf truncatedCellOf
#include "07_repetition.frag"
