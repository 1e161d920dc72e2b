// shader.h - from a shader's file to a linked program: read, expand #include, compile, link, and
// say each error in the author's own file and line.
#ifndef SHADER_H
#define SHADER_H

#include <stdbool.h>
#include <stddef.h>

#include "context/gl.h"
#include "shader/glsl.h"

// What main() shows; the value of VIEW in shaders/main.glsl.
enum shader_view {
    SHADER_PICTURE, // the colour of rayColour
    SHADER_NORMALS, // the first normal of the pixel's ray
    SHADER_DEPTH,   // where its first march ended
    SHADER_STEPS,   // the steps of all its marches
    SHADER_SLICE,   // the march of one ray, seen from the side
    SHADER_VIEW_COUNT,
    SHADER_PROBE = SHADER_VIEW_COUNT, // the steps of one ray, as numbers; not a view to choose
    SHADER_COUNT,                     // evaluations of the scene for each pixel; not a view either
    SHADER_PROGRAM_COUNT
};

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
    enum shader_form form;
    bool versioned;            // the text itself says its #version to the driver
    char *text;                // '\n' ends each line; '\0' terminated
    struct glsl code;          // the text in tokens
    struct shader_line *lines; // of each line of text
    int line_count;
    char **files; // files[0] is the one given; the names to print in messages
    char **paths; // the same files resolved, to watch for changes
    int file_count;
};

// Read a shader and what it includes.
//   path   the file; a byte-order mark and carriage returns are dropped
//   root   the project's folder; includes are looked for beside the including file, then in
//          root/shaders, then in root/chapters, each file once, and never outside root or path's
//          own folder (the preprocessor is not run: an include between #if and #endif is always
//          expanded); the line of an include stays as a comment
// Returns false, reported in one line with file and line: missing, unreadable, empty, binary (a
// zero byte) or over 1 MiB, over 8 MiB with its includes; an include that is malformed, missing,
// includes itself, or climbs out; a #version that does not come first; a comment that is never
// closed; an input that a whole file cannot have. Free with shader_free.
bool shader_read(struct shader_source *source, const char *path, const char *root);

// As shader_read, telling of each file before it is read, so that what is watched is what was read.
//   see  is called with the resolved path; for an include that is missing, with each place where it
//        was looked for
//   to   is handed on to see
bool shader_read_seen(struct shader_source *source, const char *path, const char *root,
                      void (*see)(void *to, const char *path), void *to);

// Free a source; one of zeros is allowed.
void shader_free(struct shader_source *source);

// Report what is wrong in a line of the expanded text, from 0, under its author's file and line;
// always false.
bool shader_refuse(const struct shader_source *source, int line, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

// The text that is compiled: what form.h puts before the expanded text, and what it makes of this.
// Returns memory that the caller frees, or NULL, reported.
char *shader_text(const struct shader_source *source, enum shader_view view);

// The name of a view ("steps"), and the view of a name (false for an unknown one, not reported).
const char *shader_view_name(enum shader_view view);
bool shader_view_from_name(const char *name, enum shader_view *view);

// True when the view can be shown; else reported with the reason: a whole file or one in
// Shadertoy's form has a main of its own, which fills in no trace.
bool shader_has_view(const struct shader_source *source, enum shader_view view);

// Compile and link.
//   vertex   shaders/screen.vert
// Returns the program, owned by the caller, or 0 with every error reported by file and line, the
// source line beneath.
GLuint shader_link(const struct gl *gl, const struct shader_source *vertex,
                   const struct shader_source *fragment, enum shader_view view);

// The steps to a program.
enum shader_step { SHADER_COMPILE_VERTEX, SHADER_COMPILE_FRAGMENT, SHADER_LINK };

// Compile and link two texts as they are.
//   step  receives the last step that was begun
//   log   receives what the driver wrote of one that failed, which the caller frees; or NULL
// Returns the program, owned by the caller, or 0, not reported.
GLuint shader_link_texts(const struct gl *gl, const char *vertex, const char *fragment,
                         enum shader_step *step, char **log);

// Rewrite a driver's log in the author's own files and lines, for the text that shader_text made
// for this source and view. Understands Mesa "0:12(3): ", NVIDIA "0(12) : " and "ERROR: 0:12: ". A
// line that names a function which links to nothing gets the file and line of the call.
// Each line becomes "FILE:LINE: error: message" with the source line beneath, shown once where
// several stand together and cut after 160 letters. Warnings are left out of a log that holds
// errors; a line that belongs to no line of the source is kept as it is; of more than 20 lines the
// rest is counted. Returns memory that the caller frees, or NULL, reported.
char *shader_explain(const struct shader_source *source, enum shader_view view, const char *log);

#endif
