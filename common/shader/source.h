// source.h - a shader's text with its includes expanded, and where each line comes from.
#ifndef SHADER_SOURCE_H
#define SHADER_SOURCE_H

#include <stdbool.h>

#include "shader/glsl.h"
#include "shader/text_file.h"

// The three dialects that --shader accepts.
enum shader_dialect {
    DIALECT_COURSE,    // defines pixelRay, sceneDistance and rayColour for main.glsl; no #version
    DIALECT_SHADERTOY, // defines mainImage and no main
    DIALECT_WHOLE      // has its own main, and usually a #version
};

struct shader_input;

// Where one line of the expanded text comes from.
struct shader_line {
    int file; // index in files
    int line; // from 1
};

// Options for reading a shader. Everything that this struct points to must outlive the source.
struct shader_request {
    // Called with the resolved path of each file before it is read, so that a window watches
    // exactly the files that were read; for a missing file, called with each path that was tried.
    // May be NULL.
    void (*visit)(void *to, const char *path);
    void *to;                    // passed to visit
    const char *const *textures; // NAME=FILE, where FILE replaces the picture of the sampler NAME
    int texture_count;
    const char *include; // another folder whose files may be read; NULL if there is none
    // Four files for Shadertoy's iChannel0 to 3, each NULL if it is not given; NULL if none is
    // given.
    const char *const *channels;
    int pass; // the number of the pass that is read, from 1; 0 for the picture
};

enum { SHADER_PASSES = 8 }; // the maximum number of passes before the picture

// A sampler that reads the picture of a pass.
struct shader_read {
    char name[24];
    int pass;    // number of the pass, from 1; 0 for none
    char filter; // 'n' the nearest texel, 'l' linear, 'm' from mip levels
};

// How one of several passes is connected with the others.
struct shader_pass {
    struct shader_read read[SHADER_PASSES];
    bool repeat;     // the pass's own picture repeats beyond its edge
    bool mip_levels; // and is read with mip levels
    bool shown;      // the pass is the picture itself, as the last frame showed it, in 8 bits
};

// A sampler of a file in another tool's dialect. It reads the picture of --texture NAME=FILE or
// that of its channel; without either, it is black.
struct shader_sampler {
    const char *name; // of its uniform; not owned
    const char *type; // sampler2D; for Shadertoy's cube maps and volumes, which are black here,
                      // samplerCube and sampler3D
    int channel;      // 0 to 3; -1 for a fifth one, which only --texture reaches
    int line; // of the text, from 0: its declaration or, if there is none, its first mention
};

struct shader_source {
    enum shader_dialect dialect; // set by dialect.c, like prelude, body, inputs, unset, warned
    bool marches;                // true if the course's text records marches: calls traceBegin
    int version;                 // the number in the text's #version; 0 if there is none
    char *text;                  // the same as code.text; '\n' ends each line, and '\0' the text
    struct glsl code;            // the text as tokens
    struct shader_line *lines;   // the origin of each line of text
    int line_count;
    char *prelude, *body;        // for the driver; NULL in the course's dialect
    struct shader_input *inputs; // the inputs that the text reads
    int input_count;
    struct shader_sampler *samplers; // in the order of the text; none in the course's dialect
    int sampler_count;
    char *unset;     // the first warning that nothing sets a uniform or a block; NULL if none
    char *warned;    // all warnings, one in each line; NULL if there are none
    char was[4][24]; // what each channel contains in the author's tool, in Shadertoy's words
    struct shader_pass links;   // with other passes of the file
    struct shader_source *pass; // the passes that are drawn before this one, in order; owned
    int pass_count;
    int channel[4]; // indices of the files that the text names for its channels; 0 for no file
    char **files;   // the names to print, with '?' for control characters; files[0] is the shader
    char **paths;   // the resolved paths of these files, to watch for changes
    int file_count;
    char *root, *own,
        *include; // the project's folder, the first file's and the request's, resolved
    struct shader_request request;
};

// Read a shader and expand its includes.
//   path     the shader's file, or an export from Shadertoy, whose passes are read; the file is
//            read as text_file_read describes
//   root     the project's folder; an include is looked for next to the including file, then in the
//            request's folder, in root/shaders and in root/chapters, but never outside root, path's
//            own folder and the request's; each file is included once, and the line of an include
//            stays as a comment
//   request  the options; may be NULL
// Two directives of Shader Toy, an extension for VS Code, are understood: #iUniform becomes an
// annotated uniform, and #iChannel0 names a picture next to its file, or tells what the channel
// contains in the author's tool.
// Returns false after reporting the error in one line with file and line. Errors are: a file that
// is missing, unreadable, empty, binary (has a zero byte) or larger than 1 MiB, or than 8 MiB with
// its includes; an include that is malformed, is missing, includes itself or is outside these
// folders; a missing picture; a #version that does not come first; and a comment that is never
// closed. Free with shader_free.
bool shader_expand(struct shader_source *source, const char *path, const char *root,
                   const struct shader_request *request);

// Find a picture that a shader names, and add it to the source's files. The picture is looked for
// next to the file that names it, then in the request's folder and in root/shaders/textures, but
// never outside root, the first file's own folder and the request's.
//   from  index of the file that names the picture
//   why   receives the reason on failure, as a phrase
// Returns the picture's index among the files, or -1 without reporting an error.
int shader_find_texture(struct shader_source *source, int from, const char *name,
                        char why[TEXT_FILE_WHY]);

// Do the same for a picture that is named on the command line and may be in any folder.
int shader_take_texture(struct shader_source *source, const char *path, char why[TEXT_FILE_WHY]);

// True if a source includes a file, whose name is relative to the project, such as
// shaders/main.glsl.
bool shader_includes(const struct shader_source *source, const char *file);

// Free a source. A zero-initialised source is allowed.
void shader_free(struct shader_source *source);

// What a sampler reads, or NULL if it reads no pass.
const struct shader_read *shader_read_of(const struct shader_source *source, const char *sampler);

// Report an error with the author's file and line. Always returns false.
//   line  the line of the expanded text, counted from 0
bool shader_refuse(const struct shader_source *source, int line, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
