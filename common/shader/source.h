// source.h - a shader's text with every include in place, each line traced back to its file.
#ifndef SHADER_SOURCE_H
#define SHADER_SOURCE_H

#include <stdbool.h>

#include "shader/glsl.h"
#include "shader/text_file.h"

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

// What a reading is asked besides. Whatever it points to must outlive the reading.
struct shader_request {
    // Is called with the resolved path of each file before it is read, so that what is watched is
    // what was read; for a file that is missing, with each place where it was looked for; NULL:
    // nobody asks.
    void (*see)(void *to, const char *path);
    void *to;                    // is handed on to see
    const char *const *textures; // NAME=FILE: other pictures for samplers of the course's form
    int texture_count;
    const char *const *channels; // four files for Shadertoy's iChannel0 to 3; NULL for none
};

// A shader's text with every include in place.
struct shader_source {
    enum shader_form form;     // set by form.c
    bool versioned;            // the text itself says its #version; form.c: to the driver
    char *text;                // '\n' ends each line; '\0' terminated
    struct glsl code;          // the text in tokens
    struct shader_line *lines; // of each line of text
    int line_count;
    char **files; // files[0] is the one given; the names to print, '?' for control characters;
                  // textures come last
    char **paths; // the same files resolved, to watch for changes
    int file_count;
    char *root, *own; // the project's folder and that of the first file, resolved
    struct shader_request request;
};

// Read a shader and put what it includes in place.
//   path   the file; a byte-order mark and carriage returns are dropped
//   root   the project's folder; includes are looked for beside the including file, then in
//          root/shaders, then in root/chapters, each file once, and never outside root or path's
//          own folder (the preprocessor is not run: an include between #if and #endif is always
//          expanded); the line of an include stays as a comment
//   request  NULL for none
// Returns false, reported in one line with file and line: missing, unreadable, empty, binary (a
// zero byte) or over 1 MiB, over 8 MiB with its includes; an include that is malformed, missing,
// includes itself, or climbs out; a #version that does not come first; a comment that is never
// closed. Free with shader_free.
bool shader_expand(struct shader_source *source, const char *path, const char *root,
                   const struct shader_request *request);

// Find a picture that a shader names, and add it to the source's files.
//   from  the file that names it: it is looked for beside that, then in root/shaders/textures, and
//         never outside root or the first file's own folder
//   why   receives one phrase when there is none
// Returns its index, or -1, not reported.
int shader_find_texture(struct shader_source *source, int from, const char *name,
                        char why[TEXT_FILE_WHY]);

// As shader_find_texture for a picture that a person names, which may lie anywhere.
int shader_take_texture(struct shader_source *source, const char *path, char why[TEXT_FILE_WHY]);

// Free a source; one of zeros is allowed.
void shader_free(struct shader_source *source);

// Report what is wrong in a line of the expanded text, from 0, under its author's file and line;
// always false.
bool shader_refuse(const struct shader_source *source, int line, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
