// cumulus.h - a field of cumulus over a round Earth, and its panorama: the upper half of the sky as
// seen by an eye on the ground, row by row and column by column, found by a march through the
// vapour.
//
// u turns once around the horizon; v is the square root of the height above the horizon, where a
// quarter turn is 1, so the rows are denser where clouds are seen from the side.
#ifndef CUMULUS_H
#define CUMULUS_H

#include <stdint.h>

// A cumulonimbus: a column whose head has met warm air that stops it, and spreads into an anvil.
// Lengths are in kilometres.
struct tower {
    double north, east; // position of its base relative to the eye
    double width;       // radius of the column
    double top, anvil;  // height of its head above the ground, and how far the head spreads
    double drawn;       // how far the wind draws the head to the north
    double clearing;    // no other cloud is closer than this to the line from eye to tower
};

enum { TOWERS = 2, CUMULUS_WIDTH = 2048, CUMULUS_HEIGHT = 320 }; // size of a panorama: texels

// Lengths are in kilometres. There is a column of cloud wherever the ground's noise is above the
// threshold; the more it is above, the higher the column. Puffs of two sizes make the column round.
struct cumulus {
    double base,
        depth;        // height of the flat bases; greatest height of a column above them
    double cell;      // of the noise: about the distance from one cloud to the next
    double threshold; // of the noise, in (0, 1)
    double slope;     // share of depth that a column gains for each unit of noise
    double puff,
        fray;         // how far puffs bulge, the large ones and the small ones, as a share of depth
    double size;      // four times the width of a large puff
    double thickness; // optical depth of a kilometre of cloud
    uint32_t seed;
    struct tower tower[TOWERS]; // one of width 0 does not exist
};

// The contents of the panorama at the middle of a texel: cover, the share of the background that
// the cloud hides; above, the share of a light overhead that reaches the visible side; side, 1/2 +
// 1/2 (right - left), where right and left are the same share for lights on the horizon, to the
// right and to the left of an observer who faces the cloud. High up, a texel is narrower than it is
// high, and the rim of a cloud would look like a staircase. So each texel is the mean of about as
// many texels of its row as are together as wide as one is high, and of as many in the rows above
// and below.
//   field  the same in all calls
void cumulus_at(const struct cumulus *field, double u, double v, double value[3]);

#endif
