#include "lib/filter.h"

#include <math.h>

#include "lib/mirror.h"
#include "lib/random.h"

const char *const filter_way_names[FILTER_WAYS] = {
    "box", "box jittered", "tent", "tent jittered", "Gaussian", "Gaussian jittered", "workshop"};

enum { PIXELS = 64, TRUTH = 16 }; // no pixel has more than TRUTH samples in a row

// A fan of dark and light wedges that get thinner towards its centre, which is outside the picture.
static double picture(double x, double y)
{
    double turn = atan2(y + 3.7, x + 5.3) / MIRROR_PI;
    return sin(turn * MIRROR_PI * 24.0) > 0.0 ? 1.0 : 0.0;
}

static double tent(double share)
{
    return share < 0.5 ? sqrt(2.0 * share) - 1.0 : 1.0 - sqrt(2.0 - 2.0 * share);
}

// The quantile of a Gaussian with standard deviation 1/2, found by bisection: this share of the
// Gaussian is below it.
static double gaussian(double share)
{
    double low = -4.0, high = 4.0;
    for (int i = 0; i < 40; i++) {
        double middle = 0.5 * (low + high);
        *(0.5 * erfc(-middle / sqrt(0.5)) < share ? &low : &high) = middle;
    }
    return 0.5 * (low + high);
}

static double offset_of(enum filter_way way, double share)
{
    if (way == FILTER_TENT || way == FILTER_TENT_JITTERED)
        return tent(share);
    if (way == FILTER_GAUSSIAN || way == FILTER_GAUSSIAN_JITTERED)
        return gaussian(share);
    return share - 0.5;
}

static double mean_of(enum filter_way way, int side, int x, int y)
{
    bool jittered = way == FILTER_BOX_JITTERED || way == FILTER_TENT_JITTERED ||
                    way == FILTER_GAUSSIAN_JITTERED;
    double shift = way == FILTER_WORKSHOP ? 0.5 - 0.5 / side : 0.0;
    double regular[TRUTH] = {0.0}; // offsets that are the same in each row and column
    for (int i = 0; i < side; i++)
        regular[i] = offset_of(way, (i + 0.5) / side);
    double sum = 0.0;
    for (int i = 0; i < side * side; i++) {
        int column = i % side, line = i / side;
        double across = regular[column], down = regular[line];
        if (jittered && side > 1) {
            across = offset_of(way, (column + random_of(x, y, i, 0)) / side);
            down = offset_of(way, (line + random_of(x, y, i, 1)) / side);
        }
        sum += picture(x + 0.5 + shift + across, y + 0.5 + shift + down);
    }
    return sum / (side * side);
}

double filter_error(enum filter_way way, int side)
{
    static const enum filter_way regular[FILTER_WAYS] = {
        FILTER_BOX,      FILTER_BOX,      FILTER_TENT, FILTER_TENT,
        FILTER_GAUSSIAN, FILTER_GAUSSIAN, FILTER_BOX};
    double squares = 0.0;
    for (int y = 0; y < PIXELS; y++)
        for (int x = 0; x < PIXELS; x++) {
            double off = mean_of(way, side, x, y) - mean_of(regular[way], TRUTH, x, y);
            squares += off * off;
        }
    return sqrt(squares / (PIXELS * PIXELS));
}
