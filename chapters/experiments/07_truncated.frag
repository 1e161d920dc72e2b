// Experiment of chapter 07: the number of the cell by a rounding towards zero, as C's % and fmod divide.
// It agrees with floor from -N / 2 on. Below that every cell is called by the number of its neighbour:
// the place in it is a whole period away, and its lantern is not there.
//
// The library's floor is turned into trunc.
#include "main.glsl"
#define floor trunc
#include "repetition.glsl"
#undef floor
#include "07_repetition.frag"
