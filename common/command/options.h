// options.h - the command line of every chapter program.
#ifndef OPTIONS_H
#define OPTIONS_H

#include <stdbool.h>
#include <stdio.h>

#include "camera.h"
#include "context/context.h"
#include "picture/sculpture.h"
#include "shader/view.h"
#include "window/start.h"

#define OPTIONS_SIZE_LIMIT    16384 // maximum width and height in pixels
#define OPTIONS_SAMPLES_LIMIT 8     // maximum number of samples along each side of a pixel
#define OPTIONS_FPS           25.0  // pictures per second of a film, unless its frames are kept
#define OPTIONS_LIMIT         1e9   // largest time or camera value; floats near it are 64 apart

enum options_action {
    OPTIONS_RUN,          // a window, a file, a probe or a benchmark
    OPTIONS_PRINT_SHADER, // --print-shader
    OPTIONS_LIST,         // --list
    OPTIONS_HELP,         // --help
    OPTIONS_VERSION       // --version
};

// The command line. Strings point into argv.
struct options {
    enum options_action action;
    bool window;    // the run needs a window, because there is no --output, --probe or --benchmark
    bool shadertoy; // --print-shader=shadertoy
    bool page;      // --print-shader=page
    bool compares;  // there is a second picture
    bool walk;      // --step walk: the pictures of --frames step along the ray
    bool has_from, has_divider, has_camera, has_overlay, has_time, has_frame;
    const char *output;    // name of the PNG file, with one %d for a film; NULL if not given
    int width, height;     // pixels, 1 to OPTIONS_SIZE_LIMIT
    double time;           // seconds
    int frames;            // 1 + the index of the last picture of the film; 0 if there is no film
    int first_frame;       // index of the first picture to write
    int frame;             // index of the frame that the picture shows
    double fps;            // pictures per second; 0 if not given
    int benchmark;         // frames to measure, or 0
    bool json;             // --benchmark=json
    const char **settings; // NAME=VALUE, in the order given; owned, see options_free
    int setting_count;
    const char *compare;   // the second shader's file; NULL if both pictures use the first
    int shared_settings;   // the number of settings before --compare, which apply to both pictures
    const char *labels;    // names of both pictures, with a comma between them; NULL if not given
    double divider;        // fraction of the width that the first picture fills, 0 to 1
    const char **textures; // NAME=FILE, in the order given; owned
    int texture_count;
    struct strokes strokes;  // --stroke, in the order given; owned
    const char *channels[4]; // the files of Shadertoy's iChannel0 to 3; NULL if not given
    struct camera camera;    // meaningful when has_camera
    int samples;             // 1 to OPTIONS_SAMPLES_LIMIT, along each side of a pixel
    enum shader_view view;
    int (*probe)[2];         // pixels, 0,0 bottom left; a picture shows the ray of the last pixel
    const char **probe_text; // the pixels as they were typed
    int probe_count;
    enum context_backend backend;
    double overlay;            // scale of the overlay; 0 if it depends on the picture's height
    int step;                  // the last step of the ray's march that is shown, from 0; -1 for all
    struct camera from;        // camera of the ray of --probe; meaningful when has_from
    struct window_start start; // what only a window needs; run_window_start adds the rest
    const char *shader;        // --shader, or NULL for the chapter's own
    const char *include;       // --include, or NULL
    const char *root;          // --root; NULL if it is found from the program's folder
};

enum { OPTIONS_WORDS = 64 }; // maximum number of words of a line

// Split a line into words as a shell does, removing the quotes. The words lie in the line, which is
// changed.
//   word  receives argv: the words, and NULL
// Returns the number of words, or -1 after reporting the error: too many words, or an open quote.
int options_split(char *line, char *word[OPTIONS_WORDS + 1]);

// Read the command line, and check its syntax, its ranges, and what the options require of each
// other. Names and ranges of parameters are not checked, because only the shader knows them.
//   options  receives the values; the caller frees them with options_free
// Returns false after reporting the error in one line; the exit status is then 2.
bool options_parse(struct options *options, int argc, char **argv);

// Free what options_parse allocated.
void options_free(struct options *options);

// One option, as --help prints it. A value after a blank is required, unless it is in brackets. A
// value in brackets is optional; if a blank precedes the bracket, the value may also be the next
// word, which must not begin with '-'. An empty default (initial) is not printed.
struct options_row {
    const char *letter, *name, *value;
    // Set the value; text is NULL if the value is omitted. Returns false after reporting the error.
    // An option that has only an action has NULL here.
    bool (*set)(struct options *options, const char *text);
    enum options_action action;
    const char *meaning, *initial;
};

// All options, ended by a row of zeros (options_table.c).
extern const struct options_row options_rows[];

// Print the text of --help (options_help.c).
//   program       argv[0]
//   title, shows  the chapter's title, and a sentence on what it shows
void options_print_help(FILE *file, const char *program, const char *title, const char *shows);

#endif
