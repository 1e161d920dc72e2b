// resolution.h - chooses the resolution at which a window draws its picture, from the time that its
// frames take. No clock is read here.
//
// Level k draws each side 2^(-k/4) times as long, so each level has 2^(-1/2), about 0.71, times the
// pixels of the previous level. A frame with N pixels at full resolution takes, at level k,
//
//     T(k) = a + c N / 2^(k/2), plus E for enlarging if k > 0;   a, c, E >= 0.
//
// Only T - E - f per pixel of recent frames is known, where f is an estimate of a, made when the
// program was tried. If more than f would be spent whatever the level, a coarser picture would not
// help; so the times below are T - f, and predictions assume that a = f. If a frame is predicted to
// take longer than RESOLUTION_SLOW, the finest level at which it would not is chosen. If a frame at
// a finer level is predicted to take less than RESOLUTION_QUICK, that level is chosen.
//
// The choice settles. Let E = 0; a larger E only lowers both limits. Let f <= a, and write T for
// T - f, and a for a - f. The prediction for a finer
// level is never too short: 2^(1/2) T(k) >= T(k - 1). So after a step to the finer level k - 1 the
// frame takes T(k - 1) < QUICK < SLOW, and nothing drives it back. After a step to the coarser
// level k + 1 because T(k) > SLOW, the finer level is predicted to take 2^(1/2) T(k + 1) >= T(k) >
// SLOW > QUICK, and is not chosen. So while the cost of a picture stays the same, the level moves
// in only one direction, and there are few levels. Measured times may be wrong by a factor of up to
// (SLOW / QUICK)^(1/2), that is 15 %, without causing a step back. One frame in three may be wrong
// by more, because the cost is the median of the last three. A lasting change takes effect in
// its second frame.
#ifndef RESOLUTION_H
#define RESOLUTION_H

#include <stdbool.h>

// Seconds that a picture may take: about 10 frames per second with everything else that a frame
// needs.
#define RESOLUTION_SLOW     0.08
#define RESOLUTION_QUICK    0.06
#define RESOLUTION_COARSEST 32 // level at which each side is 1/256 as long

// A zero-initialised struct is at full resolution and knows no cost.
struct resolution {
    int level;
    double fixed;        // seconds that a picture takes however few pixels it has
    double cost[3];      // seconds per pixel of the last three frames, the newest first
    bool guessed;        // the cost is an estimate, not measured from a frame
    double enlarging[3]; // the same for enlarging, per pixel of the window; 0 at first
};

// Return the factor by which each side is shorter at a level: 1 to 256.
double resolution_divisor(int level);

// Return the length of a side at a level in pixels, at least 1.
int resolution_side(int level, int side);

// Begin with an estimated cost, in seconds per pixel beyond the fixed seconds. The cost of the
// first frame replaces the estimate.
void resolution_guess(struct resolution *resolution, double fixed, double cost);

// Add the cost of the last frame, which took some seconds for some pixels.
void resolution_learn(struct resolution *resolution, double seconds, double pixels);

// Return the median of the last three costs, in seconds per pixel.
double resolution_cost(const struct resolution *resolution);

// Add the cost of enlarging the last frame, which took some seconds for some pixels of the window.
void resolution_learn_enlarging(struct resolution *resolution, double seconds, double pixels);

// Choose the level of the next frame.
//   pixels  number of pixels of the full picture
// Returns the level, which is also stored in resolution->level.
int resolution_choose(struct resolution *resolution, double pixels);

#endif
