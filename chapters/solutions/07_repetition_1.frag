// Solution of exercise 07.1: five times five lanterns instead of a field without end.
//
// The chapter's calls of cellOf are turned into calls of cellOfFive. cellOthers may stay: where there
// are fewer lanterns than it thinks it is too careful, and never too bold.
#include "main.glsl"
#include "repetition.glsl"

float cellOfFive(float x, float period)
{
    return cellOfLimited(x, period, -2.0, 2.0);
}

#define cellOf cellOfFive
#include "07_repetition.frag"
