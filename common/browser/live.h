// live.h - what a page's script asks of the program in it. All of this, and of hands.h, is
// exported.
//
// The page owns the loop: live_start carries out a command line as the chapter's program would;
// where that opens a window, the page gives it turns. Texts that the page passes lie in the
// program's memory and are the page's; those that it gets are valid until the next call.
#ifndef LIVE_H
#define LIVE_H

// ---- A command line ----

// Carry out a command line; what ran before is closed.
//   stem  of the chapter, "03_shadows"
//   line  its options as a shell reads them: blanks part words, quotes hold them together
// Returns the program's exit status. After 0 a window waits for turns where live_runs says so; else
// everything is done.
int live_start(const char *stem, const char *line);

// Which files a command line asks for, as a JSON list of paths; the page sees to it that those are
// there that the course has.
const char *live_files(const char *stem, const char *line);

void live_stop(void);

// True while there is a window.
int live_runs(void);

// Carry out what happened and draw what is due. Returns 0 when nothing can be drawn any more, and
// when the reader has ended the program: live_report says why, or nothing.
int live_turn(void);

// After the browser has given back a context that it had taken: everything is made again, the
// values of both pictures, the divider, the eye and the time are as they were. Returns an exit
// status. Where a shader does not load any more there is no window; once its files are others the
// page calls this again.
int live_restore(void);

// ---- What the page shows ----

// The program's state as JSON: state.c lists it.
const char *live_state(void);

// What could not be done last; "" when there is nothing.
const char *live_report(void);

// Name and version of the driver.
const char *live_version(void);

// ---- What the page sets ----

// A component of a parameter, kept within its range. An unknown name is ignored.
void live_set(const char *name, int component, double value);

// A parameter back to the value of its comment.
void live_reset(const char *name);

// Show a view by its number. Returns 0 where there is none: live_report says why.
int live_view(int view);

void live_pause(int paused);

// Look at the ray of a pixel, (0, 0) bottom left; a negative x lets go of it.
void live_pixel(int x, int y);

// Show the steps of the chosen ray up to this one, 0 the first. Without a ray nothing happens.
void live_step(int step);

// Set the clock, seconds. It runs on from there, or stands.
void live_time(double time);

#endif
