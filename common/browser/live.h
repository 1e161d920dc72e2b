// live.h - what a page's script can ask of the program. The functions of this header and of
// canvas.h are exported.
//
// The page owns the loop: live_start carries out a command line as the chapter's program would, and
// if that opens a window, the page calls live_turn repeatedly. Texts that the page passes belong to
// the page; texts that the page receives are valid until the next call.
#ifndef LIVE_H
#define LIVE_H

// ---- A command line ----

// Carry out a command line, after closing what ran before.
//   stem  the chapter's stem, such as "03_shadows"
//   line  the options as in a shell: blanks separate words, quotes keep them together
// Returns the program's exit status. After status 0, live_runs tells whether there is a window;
// without one, everything is done.
int live_start(const char *stem, const char *line);

// Have the driver start compiling the shaders of a command line, after closing what ran before.
// Once live_ready returns 1, live_start does not wait for the driver. live_start reports an error
// that occurs here again.
void live_begin(const char *stem, const char *line);
int live_ready(void);

// Return the paths of the files that a command line needs, as a JSON list. The page provides those
// files that the course has.
const char *live_files(const char *stem, const char *line);

void live_stop(void);

// True while there is a window.
int live_runs(void);

// Act on the input and draw what is due. Returns 0 if drawing has failed, for a reason that
// live_report returns, or if the user has quit.
int live_turn(void);

// Restart after the browser has restored a lost context, with the previous view, camera, time, ray,
// strokes and divider, and the values of both pictures. Returns an exit status. If a shader no
// longer loads, there is no window; once its files have changed, the page calls this again.
int live_restore(void);

// ---- State ----

// Return the program's state as JSON, as state.h describes it.
const char *live_state(void);

// Return the last error message, or "" if there is none.
const char *live_report(void);

// Return the version and the name of the OpenGL driver; "" without a window.
const char *live_version(void);

// Set a component of a parameter, clamped to its range. An unknown name is ignored.
void live_set(const char *name, int component, double value);

// Reset a parameter.
void live_reset(const char *name);

// Show a view by its number. Returns 0 if the view cannot be shown; live_report gives the reason.
int live_view(int view);

void live_pause(int paused);

// Select the ray of a pixel, (0, 0) bottom left; a negative x deselects it.
void live_pixel(int x, int y);

// Show the selected ray's march up to this step, counted from 0. Without a ray, nothing happens.
void live_step(int step);

// Set the time in seconds.
void live_time(double time);

#endif
