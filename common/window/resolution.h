// resolution.h - how fine a window's picture is drawn, from what its frames take. No clock is read
// here.
//
// Level k draws 2^(-k/4) of each side, so a level more takes 2^(-1/2), about 0.71, of the pixels. A
// frame of N pixels in full takes, at level k,
//
//     T(k) = a + c N / 2^(k/2),   and E more where k > 0, to enlarge it;   a, c, E >= 0.
//
// What is known is the last frame's T - E for each of its pixels. From it the frame is foretold as
// though a were 0. Where it is foretold to take longer than RESOLUTION_SLOW, the next level is the
// finest one that does not; where a finer level is foretold to take less than RESOLUTION_QUICK, it
// is taken.
//
// Why that comes to rest. Let E = 0; it only lowers both limits. Foretold for a finer level the
// time is too long, if anything: 2^(1/2) T(k) >= T(k - 1). So after a step to the finer level k - 1
// the time is T(k - 1) < QUICK < SLOW, and nothing drives it back. After a step to a coarser level
// k + 1, T(k) > SLOW, the finer one is foretold to take 2^(1/2) T(k + 1) >= T(k) > SLOW > QUICK,
// and is not taken. So a picture whose cost stays goes in one direction alone, and levels are few.
// What a clock says may be off by a factor of up to (SLOW / QUICK)^(1/2), 15 %, either way, without
// a step to and fro; of what is farther off, one frame among three is no matter, for the cost is
// the middle one of the last three. A change that lasts is followed in its second frame.
#ifndef RESOLUTION_H
#define RESOLUTION_H

#include <stdbool.h>

#define ENLARGING_SLOW  0.02 // seconds that the edge filter may take
#define ENLARGING_QUICK 0.013
#define ENLARGING_RATIO 3.0 // of the times of the edge filter and the bilinear one

#define RESOLUTION_SLOW                                                                            \
    0.08 // seconds that a picture may take: 10 frames a second with what a frame needs beside it
#define RESOLUTION_QUICK    0.06
#define RESOLUTION_COARSEST 12 // level: an eighth of each side

// One of zeros is at the full resolution and knows no cost.
struct resolution {
    int level;
    double cost[3]; // seconds that a pixel took, of the last three frames; the newest is first
    bool guessed;   // none of these was a frame
};

// How many pixels of the full picture's side one of a level's stands for: 1 to 8.
double resolution_divisor(int level);

// The side of a level's picture in pixels, at least 1.
int resolution_side(int level, int side);

// Begin with a program whose cost is a guess: the first frame's takes its place.
void resolution_guess(struct resolution *resolution, double cost);

// Take what a pixel of the last frame took, in seconds.
void resolution_learn(struct resolution *resolution, double cost);

// The seconds that a pixel takes, as far as is known.
double resolution_cost(const struct resolution *resolution);

// Choose the level of the next frame.
//   pixels  of the full picture
//   beside  seconds that enlarging it takes
// Returns it; resolution->level is it too.
int resolution_choose(struct resolution *resolution, double pixels, double beside);

// What enlarging takes, and by which filter it is done. One of zeros knows nothing and takes the
// edge filter.
struct enlarging {
    double cost[3]; // seconds that the edge filter takes for a pixel of the window, as the last
                    // three times foretell it; 0 before they are known
    bool plain;     // the bilinear filter has to do
};

// Take what a pixel of the window took, in seconds, by the filter in use.
void enlarging_learn(struct enlarging *enlarging, double cost);

// Choose the filter of the next frame: the bilinear one where the edge filter would take longer
// than ENLARGING_SLOW, until it would take less than ENLARGING_QUICK. So one time among three is no
// matter, nor is a clock that is off by 20 %.
//   pixels  of the window
// Returns the seconds that it takes.
double enlarging_choose(struct enlarging *enlarging, double pixels);

#endif
