// Solution to exercise 04.2: a subtraction with rounded edges. It is the complement of the smooth
// union of b and the outside of a. The groove of the stage is rounded too.
//
// Macros replace every opSubtraction of the chapter with smoothSubtraction, and every step() with
// softStep(), which makes the share of the ball smooth.
#include "main.glsl"
#include "combine.glsl"

float smoothSubtraction(float a, float b);
float softStep(float edge, float x);

#define opSubtraction smoothSubtraction
#define step softStep
#include "04_hue_colour.frag"
#undef step
#undef opSubtraction

float smoothSubtraction(float a, float b)
{
    return -opSmoothUnion(-a, b, blend);
}

// The chapter uses step(a, -b) as the ball's share of block minus ball, where a and b are the
// distances to block and ball. It also uses step for the sharp shares of union and intersection,
// which do not change.
float softStep(float edge, float x)
{
    return operation == 2 ? smoothUnionShare(-edge, -x, blend) : float(edge <= x);
}
