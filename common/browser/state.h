// state.h - the program's state that a page shows, as JSON.
#ifndef BROWSER_STATE_H
#define BROWSER_STATE_H

#include <stdio.h>

#include "chapter.h"

struct window;

enum { STATE_NAME = 160 }; // bytes of a parameter's name, such as "factor (right)"

// Write the state:
//   runs                  whether there is a window; without one, the list ends after unset
//   title, shows          the chapter's title, and the sentence about its picture
//   error                 the error that the panel shows, or ""; without a window, the last error
//                         reported
//   unset                 one line about a uniform or block that nothing sets, or ""
//   view, time, paused    the view's name; the time in seconds; whether the time is paused
//   compiles              whether the driver is compiling the newest version of the shader
//   camera                position, pan and tilt, as for --camera
//   rate, milliseconds    frames per second, and the time that the last picture took
//   divisor, size, pixel  divisor of the picture's sides; size in pixels; selected pixel, or -1, -1
//   shown, why            how many steps of the selected ray are shown, 0 for all; why it has no
//                         march
//   halves                whether float targets contain half floats
//   kept                  only if the shader keeps frames: the frame that is shown; the last one,
//   at
//                         which they stop, or -1; halves, whether they are kept in half floats
//   views                 the names of the views, in the order of their numbers
//   files                 the paths of the shader's files
//   parameters            of both pictures of a comparison, as the panel lists them: name, type,
//                         value, initial, minimum, maximum, step, multiplies, unit, meaning
//   handles               those in the picture: name, x and y as fractions of the picture from the
//                         top left, focused
//   tool                  whether dragging the pointer changes the chapter's volume
//   probe                 of the selected pixel's ray, once it has been marched: recorded, outcome,
//                         steps, all_steps, evaluations, colour, march (t, distance, x, y, z of
//                         each step)
//   window  NULL if there is none
void state_write(FILE *stream, const struct chapter *chapter, const struct window *window);

#endif
