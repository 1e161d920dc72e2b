// live.h - what a page's script can ask of the program. The functions of this header and of
// canvas.h are exported.
//
// The page owns the loop: live_start carries out a command line as the chapter's program would; if
// that opens a window, the page calls live_turn. Texts that the page passes belong to the page;
// texts that it gets are valid until the next call.
#ifndef LIVE_H
#define LIVE_H

// ---- A command line ----

// Carry out a command line, after closing what ran before.
//   stem  of the chapter, "03_shadows"
//   line  its options as in a shell: blanks separate words, quotes keep them together
// Returns the program's exit status. After 0 there is a window if live_runs says so; otherwise
// everything is done.
int live_start(const char *stem, const char *line);

// Let the driver begin to compile the shaders of a command line, after closing what ran before.
// Once live_ready returns 1, live_start does not wait for the driver. An error that occurs here
// occurs again there.
void live_begin(const char *stem, const char *line);
int live_ready(void);

// The files that a command line needs, as a JSON list of paths. The page provides those that the
// course has.
const char *live_files(const char *stem, const char *line);

void live_stop(void);

// True while there is a window.
int live_runs(void);

// Act on the input and draw what is due. Returns 0 when drawing failed or the reader has quit:
// live_report gives the reason, or nothing.
int live_turn(void);

// Restart after the browser has given back a lost context: the values of both pictures, the
// divider, the camera and the time are restored. Returns an exit status. If a shader no longer
// loads, there is no window; once its files have changed, the page calls this again.
int live_restore(void);

// ---- State ----

// The program's state as JSON, as state.h describes it.
const char *live_state(void);

// The last failure, or "".
const char *live_report(void);

// Version and name of the driver.
const char *live_version(void);

// Set a component of a parameter, clamped to its range. An unknown name is ignored.
void live_set(const char *name, int component, double value);

// Reset a parameter.
void live_reset(const char *name);

// Show a view by its number. Returns 0 if there is no such view: live_report gives the reason.
int live_view(int view);

void live_pause(int paused);

// Select the ray of a pixel, (0, 0) bottom left; a negative x deselects it.
void live_pixel(int x, int y);

// Show the selected ray's march up to this step, counted from 0. Ignored without a ray.
void live_step(int step);

// Set the time, seconds.
void live_time(double time);

#endif
