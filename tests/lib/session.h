// session.h - runs a chapter or a lecture in an invisible window, with the test as its user
// (user.h), and collects the program's output for the test.
#ifndef TESTS_SESSION_H
#define TESTS_SESSION_H

#include "lib/test.h"
#include "lib/user.h"

// Options for a small, still picture of chapter 01.
#define SESSION_STILL "--size 320x200 --camera 1.65,1.6,3.4,-26,-23.5"

// cmocka's setup and teardown. The setup resets the user and makes a folder for files (scratch.h).
// The teardown closes a window that is still open and removes the folder.
int session_setup(void **unused);
int session_teardown(void **unused);

#define SESSION_TEST(name) TEST_WITH(name, session_setup, session_teardown)

// Open a chapter in a window and run two iterations of its main loop. Fails the test if that is
// impossible.
//   options  the options of the command line, as a format of printf
void session_open(const char *stem, const char *options, ...) __attribute__((format(printf, 2, 3)));

// False, so that sessions begin with --samples 1 and a picture at rest stays that of the command
// line.
extern bool session_smooths;

// Open a chapter like session_open, and press H: the window then shows only the picture.
void session_open_bare(const char *stem, const char *options, ...)
    __attribute__((format(printf, 2, 3)));

// Open a lecture with all chapters, in a window of 320x180 units.
//   list  the path of the list of scenes, which must stay valid until session_close; NULL for the
//         course
void session_open_lecture(const char *list);

// The window of the program that is open.
struct window *session_window(void);

// End the program. Fails the test if the program has reported something that session_said has not
// fetched.
void session_close(void);

// Run one iteration of the program's main loop, a sixtieth of a second after the last one, or all
// iterations within some seconds.
void session_turn(void);
void session_wait(double seconds);

// Run the program's main loop until the window is closed. Returns false if drawing failed.
bool session_run(void);

// Press a key, alone or with Shift, and run one iteration.
void session_key(int key);
void session_shift_key(int key);

// Click at a position with the left button, and run two iterations.
void session_click(double x, double y);

// session_titled is true if the title bar contains a text; session_assert_title fails the test if
// it does not.
bool session_titled(const char *text);
void session_assert_title(const char *text);

// The text that the program has printed (stream 1) or reported (stream 2) since the last call for
// this stream. The text is valid until the next call.
const char *session_said(int stream);

// Fails the test unless the window shows the picture that a chapter writes with --output, apart
// from differences due to rounding.
//   options  the options of the command line, as a format of printf
void session_assert_shown(const char *stem, const char *options, ...)
    __attribute__((format(printf, 2, 3)));

// Take a screenshot; the caller frees image. Fails the test if the screenshot is not written within
// ten seconds.
void session_shoot(struct image *image);

// Like session_assert_shown, but for a screenshot instead of the window.
void session_assert_screenshot(const char *stem, const char *options);

// Store the window's picture under a number from 0 to 3.
void session_keep(int number);

// The share of pixels that differ by more than rounding between the window's picture and the
// picture stored under a number.
//   part  x, y, width and height, from the top left, of the part that is compared; NULL for
//         everything
double session_off(int number, const int part[4]);

// Find the bounding box of the pixels that differ in a part: x, y, width, height. Returns the
// number of pixels that differ.
//   in  the part, as for session_off, but not NULL
int session_bounds(int number, const int in[4], int box[4]);

#endif
