// chapter.h - call the functions of a chapter's shader and read their results.
#ifndef TESTS_CHAPTER_H
#define TESTS_CHAPTER_H

#include "lib/gpu.h"
#include "lib/mirror.h"

enum { CHAPTER_WIDTH = 640, CHAPTER_HEIGHT = 360 };

// Replace a chapter's rayColour with a line of GLSL, draw one picture from the starting camera, and
// read the float target. The caller frees the numbers. Fails the test if that is impossible.
//   stem  for example "21_a_landscape"
//   body  the line; it can use the ray, the pixel as 'vec2 pixel', and chapterColour(ray), which is
//         the original function. The colour that the line returns is clamped to [0, 1]
float *chapter_numbers(const char *stem, const char *body);

#endif
