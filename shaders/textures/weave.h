// weave.h - a linen weave: threads over and under each other, for the cloth's colour and its
// height.
#ifndef WEAVE_H
#define WEAVE_H

#include <stdbool.h>

// The thread that lies uppermost at a point.
struct weave {
    double height; // 0 in a gap between the threads, 1 at the top of the highest thread
    bool warp;     // true: one of the threads along v; false: one of those along u
    int thread;    // its index among the threads of its direction, from 0
    double along;  // from 0 to 1 along the thread
    double across; // from -1 to 1 across the thread
    bool covered;  // false in a gap between the threads
};

enum { WEAVE_THREADS = 64 }; // per period, in each direction

struct weave weave_at(double u, double v);

#endif
