// state.h - what a page shows of the program, as JSON.
#ifndef BROWSER_STATE_H
#define BROWSER_STATE_H

#include <stdio.h>

#include "chapter.h"

struct window;

enum { STATE_NAME = 160 }; // bytes of a parameter's name, such as "factor (right)"

// Write the state:
//   title, shows          of the chapter
//   error                 why the last text of the shader is not shown, or ""
//   runs                  there is a window; without one nothing follows
//   view, time, paused    the view's name; seconds
//   compiles              the driver compiles the last text of the shader
//   camera                position, pan and tilt, as for --camera
//   rate, milliseconds    frames per second, and the time that the last picture took
//   divisor, size, pixel  the picture's sides are divided by it; pixels; the selected pixel or -1
//   shown, why            how many steps of its ray are shown, 0 for all; why it has no march
//   halves                float targets are made of half floats
//   views                 the names of the views, in the order of their numbers
//   files                 the shader's files, paths
//   parameters            of both pictures of a comparison, as the panel lists them: name, type,
//                         value, initial, minimum, maximum, step, multiplies, unit, meaning
//   handles               those in the picture: name, x and y as fractions of it from the top left,
//                         focused
//   probe                 of the selected pixel's ray: outcome, steps, all_steps, evaluations,
//                         colour, march (t, distance, x, y, z of each step)
//   window  or NULL
void state_write(FILE *stream, const struct chapter *chapter, const struct window *window);

#endif
