// state.h - what a page shows of the program, as JSON.
#ifndef BROWSER_STATE_H
#define BROWSER_STATE_H

#include <stdio.h>

#include "chapter.h"

struct window;

enum {
    STATE_NAME = 160
}; // bytes of a parameter's name here, "factor (right)" for the second picture's

// Write the state:
//   title, shows          of the chapter
//   error                 why the last text of the shader is not shown, "" when all is well
//   runs                  there is a window; without one nothing follows
//   view, time, paused    view by its name, seconds
//   camera                position, pan and tilt as the options have them
//   rate, milliseconds    frames a second, and what the last picture took
//   divisor, size, pixel  the picture's sides are divided by it; pixels; the chosen pixel or -1
//   shown, why            how many of its ray's steps are shown, 0 for all; why it has no march
//   halves                float targets are made of half floats here
//   views                 the names of those that there are, in the order of their numbers
//   files                 of the shader, paths
//   parameters            of both pictures where there are two, as the panel lists them: name,
//                         type, value, initial, minimum, maximum, step, multiplies, unit, meaning
//   probe                 of the chosen pixel's ray: outcome, steps, all_steps, evaluations,
//                         colour, march (t, distance, x, y, z of each step)
//   window  NULL for none
void state_write(FILE *stream, const struct chapter *chapter, const struct window *window);

// Write a text as a JSON string.
void state_string(FILE *stream, const char *text);

#endif
