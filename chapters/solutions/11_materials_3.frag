// Solution to exercise 11.3: a striped cloth. Only the first coordinate counts, so only one factor
// has to be averaged over a pixel's footprint.
//
// The chapter's call to checkers is replaced by a call to stripeShare.
#include "main.glsl"
#include "checkers.glsl"

float stripeShare(vec2 middle, vec2 width)
{
    float after = abs(mod(middle.x + 0.5 * width.x, 2.0) - 1.0);
    float before = abs(mod(middle.x - 0.5 * width.x, 2.0) - 1.0);
    return 0.5 + 0.5 * (before - after) / width.x;
}

#define checkers stripeShare
#include "11_materials.frag"
