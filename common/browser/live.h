// live.h - the functions with which a page's script controls the program. The functions of this
// header and of canvas.h are exported.
//
// The page owns the loop: live_start executes a command line as the chapter's program would, and if
// a window opens, the page calls live_turn repeatedly. Strings that the page passes belong to the
// page; strings that the page receives are valid until the next call.
#ifndef LIVE_H
#define LIVE_H

// ---- A command line ----

// Execute a command line, after closing the previous run.
//   stem  the chapter's stem, such as "03_shadows"
//   line  the options as in a shell: blanks separate words, and a quoted word may contain blanks
// Returns the program's exit status. After status 0, live_runs tells whether there is a window; if
// there is none, the run is complete.
int live_start(const char *stem, const char *line);

// Have the driver start compiling the shaders of a command line, after closing the previous run.
// Once live_ready returns 1, live_start no longer waits for the driver. An error is reported here,
// and again by live_start.
void live_begin(const char *stem, const char *line);
int live_ready(void);

// Return the paths of the files that a command line needs, as a JSON array. The page provides those
// that belong to the course.
const char *live_files(const char *stem, const char *line);

void live_stop(void);

// True while there is a window.
int live_runs(void);

// Run one iteration of the main loop: act on the input, and draw what is due. Returns 0 if there is
// no window, if the user has quit, or if drawing has failed; after a failure, live_report returns
// the reason.
int live_turn(void);

// Restart after the browser has restored a lost context, with the previous view, camera, time, ray,
// strokes and divider, and the parameters of both pictures. Returns an exit status. If a shader can
// no longer be loaded, there is no window; the page calls live_restore again once the shader's
// files have changed.
int live_restore(void);

// ---- State ----

// Return the program's state as JSON, as state.h describes it.
const char *live_state(void);

// Return the last error message, or "" if there is none.
const char *live_report(void);

// Return the version of OpenGL and the name of its driver, or "" if there is no window.
const char *live_version(void);

// Set a component of a parameter to a value, which is clamped to the parameter's range. Does
// nothing if the name is unknown, the component does not exist or the value is NaN.
void live_set(const char *name, int component, double value);

// Reset a parameter to its initial value.
void live_reset(const char *name);

// Switch to the view with this number. Returns 0 if there is no window or no such view, or if the
// shader cannot show the view; in this last case, live_report returns the reason.
int live_view(int view);

void live_pause(int paused);

// Select the ray of a pixel, where (0, 0) is at the bottom left. A negative x deselects the ray.
void live_pixel(int x, int y);

// Show the selected ray's march up to this step, counted from 0. Does nothing if no ray is selected
// or the ray has no march.
void live_step(int step);

// Set the time in seconds.
void live_time(double time);

#endif
