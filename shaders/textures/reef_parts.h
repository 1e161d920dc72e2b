// reef_parts.h - the parts of the reef of chapter 22.
#ifndef REEF_PARTS_H
#define REEF_PARTS_H

#include "parts.h"

enum { REEF_MOST = 8192 };

#define REEF_BLEND 0.024 // width of the blends

// Fill in a reef of count parts, from 64 to REEF_MOST. The fewer there are, the larger they are:
// there is one coral for every 128 parts, and their total volume stays the same.
void reef_build(int count, struct part *part);

#endif
