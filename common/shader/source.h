// source.h - a shader's text with every include in place, each line traced back to its file.
#ifndef SHADER_SOURCE_H
#define SHADER_SOURCE_H

#include <stdbool.h>

#include "shader/glsl.h"

// Which of the three kinds of file that --shader accepts.
enum shader_form {
    SHADER_COURSE,    // the course's own: no #version, three functions and includes
    SHADER_SHADERTOY, // defines mainImage and no main
    SHADER_WHOLE      // its own main, and mostly a #version
};

// Where one line of the expanded text comes from.
struct shader_line {
    int file; // index into files
    int line; // from 1
};

// A shader's text with every include in place.
struct shader_source {
    enum shader_form form;     // set by form.c
    bool versioned;            // the text itself says its #version; form.c: to the driver
    char *text;                // '\n' ends each line; '\0' terminated
    struct glsl code;          // the text in tokens
    struct shader_line *lines; // of each line of text
    int line_count;
    char **files; // files[0] is the one given; the names to print in messages
    char **paths; // the same files resolved, to watch for changes
    int file_count;
};

// Read a shader and put what it includes in place.
//   path   the file; a byte-order mark and carriage returns are dropped
//   root   the project's folder; includes are looked for beside the including file, then in
//          root/shaders, then in root/chapters, each file once, and never outside root or path's
//          own folder (the preprocessor is not run: an include between #if and #endif is always
//          expanded); the line of an include stays as a comment
//   see    is called with the resolved path of each file before it is read, so that what is watched
//          is what was read; for an include that is missing, with each place where it was looked
//          for; NULL: nobody asks
//   to     is handed on to see
// Returns false, reported in one line with file and line: missing, unreadable, empty, binary (a
// zero byte) or over 1 MiB, over 8 MiB with its includes; an include that is malformed, missing,
// includes itself, or climbs out; a #version that does not come first; a comment that is never
// closed. Free with shader_free.
bool shader_expand(struct shader_source *source, const char *path, const char *root,
                   void (*see)(void *to, const char *path), void *to);

// Free a source; one of zeros is allowed.
void shader_free(struct shader_source *source);

// Report what is wrong in a line of the expanded text, from 0, under its author's file and line;
// always false.
bool shader_refuse(const struct shader_source *source, int line, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
