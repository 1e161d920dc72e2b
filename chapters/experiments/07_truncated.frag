// Experiment of chapter 07: the number of the cell by a rounding towards zero, as C's % and fmod divide.
// It agrees with floor from -N / 2 on. Below that every cell is called by the number of its neighbour:
// the place in it is a whole period away, and its lantern is not there.
//
// The chapter's calls of cellOf are turned into calls of truncatedCellOf.
#include "main.glsl"
#include "repetition.glsl"

float truncatedCellOf(float x, float period)
{
    return trunc(x / period + 0.5);
}

#define cellOf truncatedCellOf
#include "07_repetition.frag"
