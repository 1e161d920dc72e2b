// session.h - runs a chapter in an invisible window, with the test as its user (user.h), and
// collects the program's output for the test.
#ifndef TESTS_SESSION_H
#define TESTS_SESSION_H

#include "lib/test.h"
#include "lib/user.h"

// A small, still picture of chapter 01.
#define SESSION_STILL "--size 320x200 --camera 1.65,1.6,3.4,-26,-23.5"

// cmocka's setup and teardown. They make and remove a folder for files (scratch.h), begin with an
// idle user, and close a window that is still open.
int session_setup(void **unused);
int session_teardown(void **unused);

#define SESSION_TEST(name) TEST_WITH(name, session_setup, session_teardown)

// Open a chapter in a window and carry out its first turns. Fails the test if that is impossible.
//   options  of the command line, as a format of printf
void session_open(const char *stem, const char *options, ...) __attribute__((format(printf, 2, 3)));

// Open a chapter like session_open, and press H: the window then shows only the picture.
void session_open_bare(const char *stem, const char *options, ...)
    __attribute__((format(printf, 2, 3)));

// End the program. Fails the test if it has reported something that no session_said has fetched.
void session_close(void);

// Carry out one turn of the program's loop, a sixtieth of a second later, or all turns within some
// seconds.
void session_turn(void);
void session_wait(double seconds);

// Run the program's own loop until its window is closed. Returns false if drawing failed.
bool session_run(void);

// Press a key, with Shift if the name says so, and carry out a turn.
void session_key(int key);
void session_shift_key(int key);

// Click at a position with the left button, and carry out two turns.
void session_click(double x, double y);

// session_titled is true if the title bar contains a text; session_assert_title fails the test if
// it does not.
bool session_titled(const char *text);
void session_assert_title(const char *text);

// The text that the program has printed (1) or reported (2) since the last call for this stream;
// valid until the next call.
const char *session_said(int stream);

// Fails the test unless the window shows what a chapter writes with --output, apart from
// differences due to rounding.
//   options  of the command line, as a format of printf
void session_assert_shown(const char *stem, const char *options, ...)
    __attribute__((format(printf, 2, 3)));

// Take a screenshot; the caller frees image. Fails the test if the screenshot is not written within
// ten seconds.
void session_shoot(struct image *image);

// Fails the test unless a screenshot is what a chapter writes, like session_assert_shown.
void session_assert_screenshot(const char *stem, const char *options);

// Store what the window shows under a number from 0 to 3.
void session_keep(int number);

// The share of pixels that differ by more than rounding between what the window shows and what was
// stored under a number.
//   part  x, y, width and height, from the top left, of the part that is compared; NULL for
//         everything
double session_off(int number, const int part[4]);

// Find the bounding box of the pixels that differ in a part: x, y, width, height. Returns how many
// pixels differ.
//   in  the part, as for session_off, but not NULL
int session_bounds(int number, const int in[4], int box[4]);

#endif
