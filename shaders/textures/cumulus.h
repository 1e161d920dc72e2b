// cumulus.h - a field of cumulus over a round Earth, and its panorama: the upper half of the sky as
// seen by an eye on the ground. Each texel is computed with a march through the clouds.
//
// u goes once around the horizon; v is the square root of the height above the horizon, where a
// quarter turn is 1, so the rows are denser where clouds are seen from the side.
#ifndef CUMULUS_H
#define CUMULUS_H

#include <stdint.h>

// A cumulonimbus: a column whose head is stopped by warm air and spreads into an anvil. Lengths are
// in kilometres.
struct tower {
    double north, east; // position of its base relative to the eye
    double width;       // radius of the column
    double top, anvil;  // height of its head above the ground, and how far the head spreads
    double drawn;       // how far the wind draws the head to the north
    double clearing;    // other clouds fade out closer than this to the line from eye to tower
};

// A place above which there is cloud whatever the noise is. Lengths are in kilometres.
struct tuft {
    double north, east; // relative to the eye
    double width;       // distance at which it ends
};

enum {
    TOWERS = 2,
    TUFTS = 2,
    CUMULUS_WIDTH = 2048,
    CUMULUS_HEIGHT = 320
}; // size of a panorama in texels

// Lengths are in kilometres. There is a column of cloud wherever the noise along the ground is
// above the threshold; the larger the noise, the higher the column. Puffs of two sizes make the
// column round.
struct cumulus {
    double base,
        depth;        // height of the flat bases; greatest height of a column above them
    double cell;      // size of a cell of the noise, about the distance between clouds
    double threshold; // of the noise, in (0, 1)
    double slope;     // share of depth that a column gains for each unit of noise
    double puff,
        fray;         // how far puffs bulge, the large ones and the small ones, as a share of depth
    double size;      // four times the width of a large puff
    double thickness; // optical depth of a kilometre of cloud
    uint32_t seed;
    struct tower tower[TOWERS]; // a tower of width 0 is ignored
    struct tuft tuft[TUFTS];    // so is a tuft
};

// The contents of the panorama at the middle of a texel: cover, the share of the background that
// the cloud hides; above, the share of a light overhead that reaches the visible side; side, 1/2 +
// 1/2 (right - left), where right and left are the same share for lights on the horizon, to the
// right and to the left of an observer who faces the cloud. High up, a texel is narrower than it is
// high, and the rim of a cloud would look like a staircase. Therefore each texel is a mean over its
// row and the rows above and below, in each row over about as many texels as are together as wide
// in the sky as one texel is high.
//   field  the same in all calls
void cumulus_at(const struct cumulus *field, double u, double v, double value[3]);

#endif
