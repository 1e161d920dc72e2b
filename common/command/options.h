// options.h - the command line of every chapter program.
#ifndef OPTIONS_H
#define OPTIONS_H

#include <stdbool.h>
#include <stdio.h>

#include "camera.h"
#include "context/context.h"
#include "shader/form.h"

#define OPTIONS_SIZE_LIMIT    16384 // pixels, each way
#define OPTIONS_SAMPLES_LIMIT 8     // samples along each side of a pixel
#define OPTIONS_LIMIT         1e9   // of times, places: beyond it a float has lost every fraction

enum options_action {
    OPTIONS_RUN,          // a window, or a file, or a probe
    OPTIONS_PRINT_SHADER, // --print-shader
    OPTIONS_LIST,         // --list
    OPTIONS_HELP,         // --help
    OPTIONS_VERSION       // --version
};

// What the command line asks for. Strings point into argv.
struct options {
    enum options_action action;
    bool window;    // the run needs one: it writes no picture, no march, no measurement
    bool shadertoy; // --print-shader=shadertoy
    bool compares;  // there is a second picture beside the first
    bool walk;      // --step walk: the pictures of --frames go from step to step
    bool has_from, has_divider, has_camera, has_overlay;
    const char *output;    // PNG to write, its name ends so, or NULL
    int width, height;     // pixels, 1 to OPTIONS_SIZE_LIMIT; defaults set by options_parse
    double time;           // seconds
    int frames;            // pictures to write, output holds one %d then; 0: one picture
    double fps;            // pictures a second of time
    int benchmark;         // frames to measure; 0: none
    bool json;             // --benchmark=json
    const char **settings; // NAME=VALUE, in the order given; owned, see options_free
    int setting_count;
    const char *compare;   // its shader's file; NULL: that of the first
    int shared_settings;   // the first of the settings, which are both pictures'
    double divider;        // share of the width that the first one has, 0 to 1
    const char **textures; // NAME=FILE, in the order given; owned
    int texture_count;
    const char *channels[4]; // the files of Shadertoy's iChannel0 to 3, or NULL
    struct camera camera;    // meaningful when has_camera
    int samples;             // 1 to OPTIONS_SAMPLES_LIMIT, along each side of a pixel
    enum shader_view view;
    int (*probe)[2]; // pixels of the picture, 0,0 bottom left; the last one is the picture's
    int probe_count;
    enum context_backend backend;
    double overlay;     // its scale; 0: by the height of the picture
    int step;           // of the ray's march: shown up to this one, from 0; -1: all
    struct camera from; // where the ray of --probe starts; meaningful when has_from
    const char *shader; // --shader, or NULL for the chapter's own
    const char *root;   // --root, or NULL: found from the program's own place
};

// Read the command line.
//   options  filled in; defaults: window 960x540, file or probe 640x360, time 0, 1 sample, picture
// Returns false after one reported line (what was given, what is expected): exit status 2. Checked
// here: syntax, ranges, the probe inside the picture, no operand left over. Not here: the names and
// ranges of parameters, which only the shader knows.
bool options_parse(struct options *options, int argc, char **argv);

// Free what options_parse allocated.
void options_free(struct options *options);

// One option. Letter and value stand as help writes them: a value after a blank is needed, one in
// brackets may be left out, and after a blank is a word of its own that does not begin with '-'. An
// empty default is not printed.
struct options_row {
    const char *letter, *name, *value;
    // Takes the text after the option, NULL where that is left out, and reports what is wrong with
    // it; NULL where the action is all.
    bool (*set)(struct options *options, const char *text);
    enum options_action action;
    const char *meaning, *initial;
};

// All of them, with a row of zeros at their end (options_table.c).
extern const struct options_row options_rows[];

// The text of --help (options_help.c).
//   program  how the program was called
//   title, shows   of the chapter
void options_print_help(FILE *file, const char *program, const char *title, const char *shows);

#endif
