// lecture.h - show the scenes of a list, or all chapters, one after another in one window. The next
// scene is compiled while the current one is shown.
//
// A list is a text file with lines of these kinds:
//
//   == 0-5 An evening          a part of the lecture begins
//   09 --set timeOfDay=17      a scene: a chapter's number or stem, and options as on its command
//                              line; quotes keep a word with blanks together; with --time, the
//                              time is paused
//      Where are we going?     a line that begins with a blank: the speaker's sentence
//   # a comment
#ifndef LECTURE_H
#define LECTURE_H

#include "command/run.h"

enum { LECTURE_SCENES = 1000 }; // maximum number of scenes

// A chapter that a scene may name.
struct lecture_chapter {
    const char *stem, *title, *shows; // as in struct chapter
    struct camera camera;             // the initial view
    const struct sculpture_tool *tool;
};

struct lecture;

// Read a list and all its shaders.
//   lecture          receives the lecture; close it with lecture_close, also after an error
//   path             the file that contains the list
//   chapters, count  the chapters, which must outlive the lecture, and their number
// Returns RUN_DONE. After reporting the error, returns RUN_NOT_DONE if a shader cannot be read, or
// RUN_WRONG_COMMAND_LINE if the list is missing or has no scenes, or has an unknown chapter, a
// wrong option, an option that is not for a window, an unclosed quote, more than LECTURE_SCENES
// scenes, or a sentence without a scene. An error in a scene is reported with its line.
int lecture_read(struct lecture **lecture, const char *path, const struct lecture_chapter *chapters,
                 int count);

// Make a lecture of all chapters, which has no captions but a sheet of contents. A shader is read
// when its chapter is about to be shown, so that an error in one chapter does not lock the others.
//   first  the chapter that is shown first; NULL for chapter 00
// The other parameters and the result are those of lecture_read.
int lecture_course(struct lecture **lecture, const char *first,
                   const struct lecture_chapter *chapters, int count);

// Print the scenes on standard output, one per line, for the scripts that make slides: number,
// part, stem, the scene's options and its sentence, separated by the character with code 31.
void lecture_print(const struct lecture *lecture);

// Show the first scene: a lecture fills the screen, and the course opens a window. Each scene's
// sentence is shown in the window and printed.
//   notes  the sentences are only printed, each with the one that follows
// Returns the exit status so far, which is RUN_NO_WINDOW if no window can be opened.
int lecture_open(struct lecture *lecture, bool notes);

// The window of the lecture, whose loop the caller runs; NULL before the lecture is open.
struct window *lecture_window(const struct lecture *lecture);

// Call this after each iteration of the window's main loop. It shows the scene that the speaker has
// asked for or, if the iteration drew nothing, compiles the next scene. If a scene cannot be shown,
// the error is reported, in the window too, and the current scene stays until one of the files of
// the other has been changed and can be shown, or until another scene is asked for.
//   of  the lecture, a struct lecture *
void lecture_follow(void *of);

void lecture_close(struct lecture *lecture);

#endif
