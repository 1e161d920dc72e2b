#include "command/options.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "picture/benchmark.h"
#include "picture/overlay.h"
#include "picture/probe.h"
#include "report.h"
#include "command/sequence.h"

// Report what is expected of an option's value.
__attribute__((format(printf, 3, 4))) static bool refuse(const char *option, const char *text,
                                                         const char *format, ...)
{
    char expected[256];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(expected, sizeof expected, format, arguments);
    va_end(arguments);
    return report("--%s '%s': %s", option, text, expected);
}

// Read two whole numbers with a separator between them. Values beyond +-1e9 become +-1e9.
static bool read_pair(const char *text, char separator, int pair[2])
{
    for (int i = 0; i < 2; i++) {
        double value;
        size_t length = strspn(text, "-0123456789");
        if (length == 0 || number_begin(text, &value) != length ||
            text[length] != (i == 0 ? separator : '\0'))
            return false;
        pair[i] = value > 1e9 ? 1000000000 : value < -1e9 ? -1000000000 : (int)value;
        text += length + 1;
    }
    return true;
}

// True for a name that ends in .png, in any case.
static bool is_png(const char *name)
{
    static const char ending[] = ".png";
    size_t length = strlen(name), own = sizeof ending - 1;
    for (size_t i = 0; i < own && length > own; i++)
        if (tolower((unsigned char)name[length - own + i]) != ending[i])
            return false;
    return length > own;
}

static bool set_output(struct options *options, const char *text)
{
    options->output = text;
    return is_png(text) ||
           refuse("output", text, "must name a file that ends in .png, the only format");
}

static bool set_size(struct options *options, const char *text)
{
    int size[2];
    if (!read_pair(text, 'x', size))
        return refuse("size", text, "must be WIDTHxHEIGHT in pixels, as in 640x360");
    for (int i = 0; i < 2; i++)
        if (size[i] < 1 || size[i] > OPTIONS_SIZE_LIMIT)
            return refuse("size", text, "width and height must be between 1 and %d pixels",
                          OPTIONS_SIZE_LIMIT);
    options->width = size[0];
    options->height = size[1];
    return true;
}

static bool set_time(struct options *options, const char *text)
{
    options->has_time = true;
    if (!number_read(text, &options->time))
        return refuse("time", text, "must be a number of seconds, as in 1.5%s", number_hint(text));
    return fabs(options->time) <= OPTIONS_LIMIT ||
           refuse("time", text, "must be between -1e9 and 1e9 seconds");
}

static bool add_setting(struct options *options, const char *text)
{
    options->settings[options->setting_count++] = text;
    return (text[0] != '=' && strchr(text, '=') != NULL) ||
           refuse("set", text, "must be NAME=VALUE; --list shows the names");
}

// The settings that follow apply only to the second picture.
static bool set_compare(struct options *options, const char *text)
{
    if (options->compares)
        return report("--compare: can be given only once");
    options->compares = true;
    options->compare = text;
    options->shared_settings = options->setting_count;
    return text == NULL || text[0] != '\0' || refuse("compare", text, "must name a file");
}

static bool set_labels(struct options *options, const char *text)
{
    options->labels = text;
    return strchr(text, ',') != NULL ||
           refuse("labels", text, "must be two names with a comma between them, as in wrong,right");
}

static bool set_divider(struct options *options, const char *text)
{
    options->has_divider = true;
    return (number_read(text, &options->divider) && options->divider >= 0.0 &&
            options->divider <= 1.0) ||
           refuse("divider", text, "must be a fraction of the width between 0 and 1, as in 0.3%s",
                  number_hint(text));
}

static bool add_texture(struct options *options, const char *text)
{
    const char *file = strchr(text, '=');
    options->textures[options->texture_count++] = text;
    return (text[0] != '=' && file != NULL && file[1] != '\0') ||
           refuse("texture", text, "must be NAME=FILE.png; --list shows the names");
}

static bool add_stroke(struct options *options, const char *text)
{
    return strokes_read(&options->strokes, text) ||
           refuse(
               "stroke", text,
               "must be AMOUNT,X,Y,Z and more points X,Y,Z, as in 0.09,-0.5,0,0.1,-0.4,-0.1,0.1");
}

static bool set_channel(struct options *options, const char *text)
{
    if (text[0] < '0' || text[0] > '3' || text[1] != '=' || text[2] == '\0')
        return refuse("channel", text, "must be N=FILE.png, with N from 0 to 3, as in 0=stone.png");
    options->channels[text[0] - '0'] = text + 2;
    return true;
}

// Read a camera, X,Y,Z,PAN,TILT.
static bool read_camera(const char *option, const char *text, struct camera *camera)
{
    double value[5];
    const char *c = text;
    for (int i = 0; i < 5; i++) {
        size_t length = number_begin(c, &value[i]);
        if (length == 0 || c[length] != (i < 4 ? ',' : '\0'))
            return refuse(option, text, "must be five numbers, X,Y,Z,PAN,TILT, as in 0,1,4,0,-10");
        if (!(fabs(value[i]) <= OPTIONS_LIMIT))
            return refuse(option, text, "each number must be between -1e9 and 1e9");
        c += length + 1;
    }
    *camera = (struct camera){.position = {(float)value[0], (float)value[1], (float)value[2]},
                              .pan = (float)value[3],
                              .tilt = (float)value[4]};
    return fabs(value[4]) <= (double)CAMERA_TILT_LIMIT ||
           refuse(option, text, "the tilt must be between %g and %g degrees",
                  (double)-CAMERA_TILT_LIMIT, (double)CAMERA_TILT_LIMIT);
}

static bool set_camera(struct options *options, const char *text)
{
    options->has_camera = true;
    return read_camera("camera", text, &options->camera);
}

static bool set_from(struct options *options, const char *text)
{
    options->has_from = true;
    return read_camera("from", text, &options->from);
}

// Read the index of a step, or the word walk.
static bool set_step(struct options *options, const char *text)
{
    options->walk = strcmp(text, "walk") == 0;
    options->step = -1;
    return options->walk || number_read_int(text, 0, PROBE_STEPS - 1, &options->step) ||
           refuse("step", text, "must be a whole number between 0 and %d, or walk with --frames",
                  PROBE_STEPS - 1);
}

static bool set_samples(struct options *options, const char *text)
{
    options->start.smooths = false; // the window shows exactly what was asked for
    return number_read_int(text, 1, OPTIONS_SAMPLES_LIMIT, &options->samples) ||
           refuse("samples", text,
                  "must be a whole number between 1 and %d: N x N samples per pixel",
                  OPTIONS_SAMPLES_LIMIT);
}

static bool set_frames(struct options *options, const char *text)
{
    const char *dash = strchr(text, '-');
    char first[NUMBER_SIZE] = "";
    options->first_frame = 0;
    if (dash == NULL || dash == text)
        return number_read_int(text, 1, SEQUENCE_FRAMES_LIMIT, &options->frames) ||
               refuse("frames", text, "must be a whole number of pictures between 1 and %d",
                      SEQUENCE_FRAMES_LIMIT);
    if (dash - text < NUMBER_SIZE)
        memcpy(first, text, (size_t)(dash - text));
    if (!number_read_int(dash + 1, 0, SEQUENCE_FRAMES_LIMIT - 1, &options->frames) ||
        !number_read_int(first, 0, options->frames, &options->first_frame))
        return refuse("frames", text,
                      "must be the first and the last picture of a part, counted from 0 to %d, "
                      "as in 100-199",
                      SEQUENCE_FRAMES_LIMIT - 1);
    options->frames++;
    return true;
}

static bool set_frame(struct options *options, const char *text)
{
    options->has_frame = true;
    return number_read_int(text, 0, SEQUENCE_FRAMES_LIMIT - 1, &options->frame) ||
           refuse("frame", text, "must be a whole number between 0 and %d",
                  SEQUENCE_FRAMES_LIMIT - 1);
}

static bool set_fps(struct options *options, const char *text)
{
    return (number_read(text, &options->fps) && options->fps >= 0.001 && options->fps <= 1000.0) ||
           refuse("fps", text, "must be a number of pictures per second between 0.001 and 1000%s",
                  number_hint(text));
}

// Read a number of frames, or the word json. The option may be given twice to set both.
static bool set_benchmark(struct options *options, const char *text)
{
    bool json = strcmp(text, "json") == 0;
    options->json = options->json || json;
    if (json && options->benchmark == 0)
        options->benchmark = BENCHMARK_FRAMES_DEFAULT;
    return json || number_read_int(text, 1, BENCHMARK_FRAMES_LIMIT, &options->benchmark) ||
           refuse("benchmark", text, "must be a whole number of frames between 1 and %d, or json",
                  BENCHMARK_FRAMES_LIMIT);
}

static bool set_view(struct options *options, const char *text)
{
    char names[128] = "";
    for (int i = 0; i < SHADER_VIEW_COUNT; i++)
        snprintf(names + strlen(names), sizeof names - strlen(names), "%s%s", i > 0 ? ", " : "",
                 shader_view_name((enum shader_view)i));
    return shader_view_from_name(text, &options->view) ||
           refuse("view", text, "unknown view; the views are %s", names);
}

static bool set_probe(struct options *options, const char *text)
{
    options->probe_text[options->probe_count] = text;
    return read_pair(text, ',', options->probe[options->probe_count++]) ||
           refuse("probe", text, "must be X,Y in pixels, as in 320,180");
}

static bool set_overlay(struct options *options, const char *text)
{
    options->has_overlay = true;
    options->overlay = 0.0;
    return text == NULL ||
           (number_read(text, &options->overlay) && options->overlay >= OVERLAY_SCALE_MINIMUM &&
            options->overlay <= OVERLAY_SCALE_MAXIMUM) ||
           refuse("overlay", text, "the scale must be a number between %g and %g%s",
                  OVERLAY_SCALE_MINIMUM, OVERLAY_SCALE_MAXIMUM, number_hint(text));
}

static bool set_backend(struct options *options, const char *text)
{
    return context_backend_from_name(text, &options->backend) ||
           refuse("backend", text, "unknown backend; use glfw, egl or osmesa");
}

static bool set_shader(struct options *options, const char *text)
{
    options->shader = text;
    return text[0] != '\0' || refuse("shader", text, "must name a file");
}

static bool set_include(struct options *options, const char *text)
{
    options->include = text;
    return text[0] != '\0' || refuse("include", text, "must name a folder");
}

static bool set_root(struct options *options, const char *text)
{
    options->root = text;
    return text[0] != '\0' || refuse("root", text, "must name a folder");
}

static bool set_print_shader(struct options *options, const char *text)
{
    options->shadertoy = text != NULL && strcmp(text, "shadertoy") == 0;
    options->page = text != NULL && strcmp(text, "page") == 0;
    return text == NULL || options->shadertoy || options->page ||
           refuse("print-shader", text, "must be shadertoy or page, or be omitted");
}

#define VIEW_WORD(id, kind, key, name) " " name

const struct options_row options_rows[] = {
    {"-o,", "output", " FILE.png", set_output, OPTIONS_RUN,
     "write the picture to a file, without a window", ""},
    {"-s,", "size", " WxH", set_size, OPTIONS_RUN, "size of the picture in pixels, 1 to 16384 each",
     "960x540 in a window, 640x360 in a file"},
    {"-t,", "time", " SECONDS", set_time, OPTIONS_RUN, "time of the picture", "0"},
    {"-p,", "set", " NAME=VALUE", add_setting, OPTIONS_RUN,
     "set a parameter of the shader; repeatable", ""},
    {"", "texture", " NAME=FILE.png", add_texture, OPTIONS_RUN,
     "use another picture for a texture of the shader; repeatable", ""},
    {"", "stroke", " A,X,Y,Z,...", add_stroke, OPTIONS_RUN,
     "change the clay of chapter 23 along points; A: radius; repeatable", ""},
    {"", "channel", " N=FILE.png", set_channel, OPTIONS_RUN,
     "picture of channel N of a shader from elsewhere, N from 0 to 3", ""},
    {"", "include", " DIR", set_include, OPTIONS_RUN,
     "another folder whose files the shader may include", ""},
    {"-c,", "camera", " X,Y,Z,PAN,TILT", set_camera, OPTIONS_RUN,
     "position in scene units and direction in degrees", "the chapter's own"},
    {"-a,", "samples", " N", set_samples, OPTIONS_RUN, "N x N samples per pixel, 1 to 8", "1"},
    {"-v,", "view", " NAME", set_view, OPTIONS_RUN, "one of" SHADER_VIEWS(VIEW_WORD), "picture"},
    {"", "probe", " X,Y", set_probe, OPTIONS_RUN,
     "print a pixel's march and colour, 0,0 bottom left; repeatable", ""},
    {"", "step", " K|walk", set_step, OPTIONS_RUN,
     "show the march up to step K, from 0; walk: follow it over --frames", ""},
    {"", "from", " X,Y,Z,PAN,TILT", set_from, OPTIONS_RUN,
     "camera of the ray of --probe; --camera looks at that ray", "--camera"},
    {"", "overlay", "[=SCALE]", set_overlay, OPTIONS_RUN,
     "scale of the overlay, 0.5 to 8; draws it into a file too", "from the picture's height"},
    {"-b,", "backend", " NAME", set_backend, OPTIONS_RUN, "glfw, egl or osmesa",
     "glfw for a window; egl, osmesa, glfw for a file"},
    {"-f,", "shader", " FILE", set_shader, OPTIONS_RUN,
     "run this fragment shader instead of the chapter's", ""},
    {"", "compare", " [FILE]", set_compare, OPTIONS_RUN,
     "second shader beside the first; a later --set applies to it", ""},
    {"", "divider", " FRACTION", set_divider, OPTIONS_RUN,
     "where the second picture of --compare begins, 0 to 1", "0.5"},
    {"", "labels", " LEFT,RIGHT", set_labels, OPTIONS_RUN, "names for the pictures of --compare",
     "the files' names"},
    {"", "root", " DIR", set_root, OPTIONS_RUN, "the project's folder",
     "found from the program's folder"},
    {"", "frames", " N|K-L", set_frames, OPTIONS_RUN,
     "write N pictures from --time on, or K to L: -o frame-%04d.png", ""},
    {"", "frame", " N", set_frame, OPTIONS_RUN,
     "picture N of --frames; a window that keeps frames stops there", "0"},
    {"", "fps", " F", set_fps, OPTIONS_RUN, "pictures per second of --frames and --frame",
     "25; 60 if frames are kept"},
    {"", "print-shader", "[=FOR]", set_print_shader, OPTIONS_PRINT_SHADER,
     "print the shader as one file; shadertoy, page: to use it there", ""},
    {"", "benchmark", " N|json", set_benchmark, OPTIONS_RUN,
     "measure compilation, N frames and evaluations; json: print JSON", "20 frames with json"},
    {"", "list", "", NULL, OPTIONS_LIST, "list the parameters: name, value, range, unit, meaning",
     ""},
    {"-h,", "help", "", NULL, OPTIONS_HELP, "print this text", ""},
    {"-V,", "version", "", NULL, OPTIONS_VERSION, "print backend, OpenGL version and renderer", ""},
    {0},
};
