// cumulus.h - a field of cumulus over a round Earth, and the panorama of it: what the sky's upper
// half shows to an eye on the ground, row by row and column by column, by a march through the
// vapour.
//
// u turns once round the horizon; v is the square root of the height over it, a quarter turn being
// 1: the rows crowd where clouds are seen from the side.
#ifndef CUMULUS_H
#define CUMULUS_H

#include <stdint.h>

// A cumulonimbus: a column whose head has met the warm air that stops it, and spreads to an anvil.
// Lengths in kilometres.
struct tower {
    double north, east; // where its foot stands, from the eye
    double width;       // radius of the column
    double top, anvil;  // height of its head over the ground, and how far that spreads
    double drawn;       // how far the wind draws the head to the north
    double clearing;    // so far from the way between the eye and it no other cloud stands
};

enum { TOWERS = 2 };

// Lengths in kilometres. A column of cloud stands wherever the ground's noise is over the
// threshold, and is the higher, the more it is over it; puffs of two sizes make it round.
struct cumulus {
    double base, depth; // height of the flat feet; how high above them the highest column may reach
    double cell;        // of the noise: about the distance from one cloud to the next
    double threshold;   // of the noise, in (0, 1)
    double slope;       // share of depth a column gains for each unit of noise
    double puff,
        fray;         // how far puffs bulge, the large ones and the small ones, as a share of depth
    double size;      // four times the width of a large puff
    double thickness; // optical depth of a kilometre of cloud
    uint32_t seed;
    struct tower tower[TOWERS]; // those of width 0 are none
};

// What the panorama holds at a place: cover, the share of what is behind that the cloud hides;
// above, the share of a light overhead that reaches what is seen of it; side, 1/2 + 1/2 (right -
// left), the same for lights on the horizon, to the right and to the left of whom looks at it.
void cumulus_at(const struct cumulus *field, double u, double v, double value[3]);

#endif
