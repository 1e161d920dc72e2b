// Solution of exercise 04.2: a subtraction whose edges are rounded, the smooth union of the outside
// of a with b, seen from outside. The groove of the stage is rounded too.
//
// Every opSubtraction of the chapter becomes a smoothSubtraction, and the sharp share a soft one.
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

// The chapter asks step(a, -b) for the ball's share of block less ball, and step for the sharp
// shares of union and intersection, which stay.
float softStep(float edge, float x)
{
    return operation == 2 ? smoothUnionShare(-edge, -x, blend) : float(edge <= x);
}
