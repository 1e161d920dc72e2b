// reef_parts.h - the parts of the reef of chapter 22.
#ifndef REEF_PARTS_H
#define REEF_PARTS_H

#include "parts.h"

enum { REEF_MOST = 8192 };

#define REEF_BLEND 0.024 // width of the blends

// Fill in a reef of count parts, from 64 to REEF_MOST. There is one coral for every 96 parts
// that are not pebbles, rocks or fish, and at least one. The fewer corals there are, the larger
// each one is, so that their total volume stays about the same.
void reef_build(int count, struct part *part);

#endif
