// source.h - a shader's text with its includes expanded, and where each line comes from.
#ifndef SHADER_SOURCE_H
#define SHADER_SOURCE_H

#include <stdbool.h>

#include "shader/glsl.h"
#include "shader/text_file.h"

// The three dialects that --shader accepts.
enum shader_dialect {
    DIALECT_COURSE,    // the course's own: no #version, three functions and includes
    DIALECT_SHADERTOY, // defines mainImage and no main
    DIALECT_WHOLE      // its own main, and mostly a #version
};

struct shader_input;

// Where one line of the expanded text comes from.
struct shader_line {
    int file; // index into files
    int line; // from 1
};

// Options of a reading. Everything that it points to must outlive the source.
struct shader_request {
    // Called with the resolved path of each file before it is read, so that a window watches
    // exactly what was read; for a missing file, with each path that was tried. May be NULL.
    void (*see)(void *to, const char *path);
    void *to;                    // passed to see
    const char *const *textures; // NAME=FILE: other pictures for samplers of the course's dialect
    int texture_count;
    const char *const *channels; // four files for Shadertoy's iChannel0 to 3; NULL for none
};

struct shader_source {
    enum shader_dialect dialect; // set by dialect.c, as are prelude, body, inputs and unset
    int version;                 // the #version of the text itself; 0 for none
    char *text;                  // code.text: '\n' ends each line; '\0' terminated
    struct glsl code;            // the text in tokens
    struct shader_line *lines;   // of each line of text
    int line_count;
    char *prelude, *body;        // for the driver; NULL in the course's dialect
    struct shader_input *inputs; // that it reads
    int input_count;
    char *unset;     // one line about the first thing that it reads and nothing sets, or NULL
    char was[4][24]; // what the author's tool had in each channel, in Shadertoy's words
    int channel[4];  // the files that the text itself names for its channels; 0 for none
    char **files;    // the names to print, '?' for control characters; files[0] is the shader
    char **paths;    // the same files resolved, to watch for changes
    int file_count;
    char *root, *own; // the project's folder and that of the first file, resolved
    struct shader_request request;
};

// Read a shader and expand its includes.
//   path     the file, or an export of Shadertoy, whose passes are read; a byte-order mark and
//            carriage returns are dropped
//   root     the project's folder; an include is looked for next to the including file, then in
//            root/shaders, then in root/chapters, never outside root and path's own folder; each
//            file is included once, and the line of an include stays as a comment
//   request  or NULL
// Of VS Code's extension Shader Toy, #iUniform becomes an annotated uniform, and #iChannel0 names a
// picture next to its file, or tells what the channel was.
// Returns false, reported in one line with file and line: missing, unreadable, empty, binary (a
// zero byte) or over 1 MiB, over 8 MiB with its includes; an include that is malformed, missing,
// includes itself, or climbs out; a picture that is missing; a #version that does not come first; a
// comment that is never closed. Free with shader_free.
bool shader_expand(struct shader_source *source, const char *path, const char *root,
                   const struct shader_request *request);

// Find a picture that a shader names, and add it to the source's files.
//   from  index of the file that names it: it is looked for next to that one, then in
//         root/shaders/textures, never outside root and the first file's own folder
//   why   receives one phrase if there is none
// Returns its index, or -1, not reported.
int shader_find_texture(struct shader_source *source, int from, const char *name,
                        char why[TEXT_FILE_WHY]);

// As shader_find_texture for a picture on the command line, which may be anywhere.
int shader_take_texture(struct shader_source *source, const char *path, char why[TEXT_FILE_WHY]);

// Free a source, which may be zeros.
void shader_free(struct shader_source *source);

// Report an error in a line of the expanded text, from 0, with its author's file and line; always
// false.
bool shader_refuse(const struct shader_source *source, int line, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
