#include "command/options.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "number.h"
#include "picture/benchmark.h"
#include "picture/overlay.h"
#include "picture/probe.h"
#include "report.h"
#include "sequence.h"

#define FPS_DEFAULT 25.0
#define LIMIT       1e9 // of times and places: beyond it a float of the shader has lost every fraction

// ---- Values ----

// Report what an option's value must be.
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

// Read two whole numbers with a separator between, those beyond every range as +-1e9.
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

// True for a name that ends in .png, in letters of any size.
static bool is_png(const char *name)
{
    static const char ending[] = ".png";
    size_t length = strlen(name), own = sizeof ending - 1;
    for (size_t i = 0; i < own && length > own; i++)
        if (tolower((unsigned char)name[length - own + i]) != ending[i])
            return false;
    return length > own;
}

// A setter takes the text after its option, NULL where that is left out, and reports what is wrong
// with it.
static bool set_output(struct options *options, const char *text)
{
    options->output = text;
    return is_png(text) ||
           refuse("output", text, "must name a file that ends in .png: no other kind is written");
}

static bool set_size(struct options *options, const char *text)
{
    int size[2];
    if (!read_pair(text, 'x', size))
        return refuse("size", text, "must be WIDTHxHEIGHT in pixels, as in 640x360");
    for (int i = 0; i < 2; i++)
        if (size[i] < 1 || size[i] > OPTIONS_SIZE_LIMIT)
            return refuse("size", text, "width and height must be from 1 to %d pixels",
                          OPTIONS_SIZE_LIMIT);
    options->width = size[0];
    options->height = size[1];
    return true;
}

static bool set_time(struct options *options, const char *text)
{
    if (!number_read(text, &options->time))
        return refuse("time", text, "must be a number of seconds, as in 1.5%s", number_hint(text));
    return fabs(options->time) <= LIMIT || refuse("time", text, "must be from -1e9 to 1e9 seconds");
}

static bool add_setting(struct options *options, const char *text)
{
    options->settings[options->setting_count++] = text;
    return (text[0] != '=' && strchr(text, '=') != NULL) ||
           refuse("set", text, "must be NAME=VALUE; --list shows the names");
}

// The settings that follow are the second picture's alone.
static bool set_compare(struct options *options, const char *text)
{
    if (options->compares)
        return report("--compare: two pictures at most stand beside each other: give it once");
    options->compares = true;
    options->compare = text;
    options->shared_settings = options->setting_count;
    return text == NULL || text[0] != '\0' || refuse("compare", text, "must name a file");
}

static bool set_divider(struct options *options, const char *text)
{
    options->has_divider = true;
    return (number_read(text, &options->divider) && options->divider >= 0.0 &&
            options->divider <= 1.0) ||
           refuse("divider", text, "must be a share of the width from 0 to 1, as in 0.3%s",
                  number_hint(text));
}

static bool add_texture(struct options *options, const char *text)
{
    const char *file = strchr(text, '=');
    options->textures[options->texture_count++] = text;
    return (text[0] != '=' && file != NULL && file[1] != '\0') ||
           refuse("texture", text, "must be NAME=FILE.png; --list shows the names");
}

static bool set_channel(struct options *options, const char *text)
{
    if (text[0] < '0' || text[0] > '3' || text[1] != '=' || text[2] == '\0')
        return refuse("channel", text, "must be N=FILE.png, N from 0 to 3, as in 0=stone.png");
    options->channels[text[0] - '0'] = text + 2;
    return true;
}

// Read where an eye is and looks, X,Y,Z,PAN,TILT.
static bool read_camera(const char *option, const char *text, struct camera *camera)
{
    double value[5];
    const char *c = text;
    for (int i = 0; i < 5; i++) {
        size_t length = number_begin(c, &value[i]);
        if (length == 0 || c[length] != (i < 4 ? ',' : '\0'))
            return refuse(option, text, "must be X,Y,Z,PAN,TILT, five numbers, as in 0,1,4,0,-10");
        if (!(fabs(value[i]) <= LIMIT))
            return refuse(option, text, "each number must be from -1e9 to 1e9");
        c += length + 1;
    }
    *camera = (struct camera){.position = {(float)value[0], (float)value[1], (float)value[2]},
                              .pan = (float)value[3],
                              .tilt = (float)value[4]};
    return fabs(value[4]) <= (double)CAMERA_TILT_LIMIT ||
           refuse(option, text, "the tilt must be from %g to %g degrees",
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

// A step's number, or the word walk.
static bool set_step(struct options *options, const char *text)
{
    options->walk = strcmp(text, "walk") == 0;
    options->step = -1;
    return options->walk || number_read_int(text, 0, PROBE_STEPS - 1, &options->step) ||
           refuse("step", text, "must be a whole number from 0 to %d, or walk with --frames",
                  PROBE_STEPS - 1);
}

static bool set_samples(struct options *options, const char *text)
{
    return number_read_int(text, 1, OPTIONS_SAMPLES_LIMIT, &options->samples) ||
           refuse("samples", text, "must be a whole number from 1 to %d: N x N samples a pixel",
                  OPTIONS_SAMPLES_LIMIT);
}

static bool set_frames(struct options *options, const char *text)
{
    return number_read_int(text, 1, SEQUENCE_FRAMES_LIMIT, &options->frames) ||
           refuse("frames", text, "must be a whole number of pictures from 1 to %d",
                  SEQUENCE_FRAMES_LIMIT);
}

static bool set_fps(struct options *options, const char *text)
{
    return (number_read(text, &options->fps) && options->fps >= 0.001 && options->fps <= 1000.0) ||
           refuse("fps", text, "must be a number of pictures a second from 0.001 to 1000%s",
                  number_hint(text));
}

// A number of frames, or the word json; both may be given, one after the other.
static bool set_benchmark(struct options *options, const char *text)
{
    bool json = strcmp(text, "json") == 0;
    options->json = options->json || json;
    if (json && options->benchmark == 0)
        options->benchmark = BENCHMARK_FRAMES_DEFAULT;
    return json || number_read_int(text, 1, BENCHMARK_FRAMES_LIMIT, &options->benchmark) ||
           refuse("benchmark", text, "must be a whole number of frames from 1 to %d, or json",
                  BENCHMARK_FRAMES_LIMIT);
}

static bool set_view(struct options *options, const char *text)
{
    char names[128] = "";
    for (int i = 0; i < SHADER_VIEW_COUNT; i++)
        snprintf(names + strlen(names), sizeof names - strlen(names), "%s%s", i > 0 ? ", " : "",
                 shader_view_name((enum shader_view)i));
    return shader_view_from_name(text, &options->view) ||
           refuse("view", text, "no such view: there are %s", names);
}

static bool set_probe(struct options *options, const char *text)
{
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
           refuse("overlay", text, "the scale must be a number from %g to %g%s",
                  OVERLAY_SCALE_MINIMUM, OVERLAY_SCALE_MAXIMUM, number_hint(text));
}

static bool set_backend(struct options *options, const char *text)
{
    return context_backend_from_name(text, &options->backend) ||
           refuse("backend", text, "no such backend: there are glfw, egl, osmesa");
}

static bool set_shader(struct options *options, const char *text)
{
    options->shader = text;
    return text[0] != '\0' || refuse("shader", text, "must name a file");
}

static bool set_root(struct options *options, const char *text)
{
    options->root = text;
    return text[0] != '\0' || refuse("root", text, "must name a folder");
}

static bool set_print_shader(struct options *options, const char *text)
{
    options->shadertoy = text != NULL;
    return text == NULL || strcmp(text, "shadertoy") == 0 ||
           refuse("print-shader", text, "must be shadertoy, or be left out");
}

// Letter and value stand as help writes them: a value after a blank is needed, one in brackets may
// be left out, and after a blank is a word of its own that does not begin with '-'. An empty
// default is not printed.
static const struct row {
    const char *letter, *name, *value;
    bool (*set)(struct options *options, const char *text);
    enum options_action action;
    const char *meaning, *initial;
} rows[] = {
    {"-o,", "output", " FILE.png", set_output, OPTIONS_RUN,
     "render one picture without a window, write it, exit", ""},
    {"-s,", "size", " WxH", set_size, OPTIONS_RUN, "size of the picture in pixels, 1 to 16384 each",
     "960x540 in a window, 640x360 to a file"},
    {"-t,", "time", " SECONDS", set_time, OPTIONS_RUN, "time of the picture", "0"},
    {"-p,", "set", " NAME=VALUE", add_setting, OPTIONS_RUN,
     "set a parameter of the shader; may be repeated", ""},
    {"", "texture", " NAME=FILE.png", add_texture, OPTIONS_RUN,
     "another picture for a texture of the shader; may be repeated", ""},
    {"", "channel", " N=FILE.png", set_channel, OPTIONS_RUN,
     "a shader from elsewhere: the picture of iChannelN, N from 0 to 3", ""},
    {"-c,", "camera", " X,Y,Z,PAN,TILT", set_camera, OPTIONS_RUN,
     "where the eye is, in scene units, and looks, in degrees", "the chapter's own"},
    {"-a,", "samples", " N", set_samples, OPTIONS_RUN, "N x N samples a pixel, 1 to 8", "1"},
    {"-v,", "view", " NAME", set_view, OPTIONS_RUN, "picture, normals, depth, steps, slice or plot",
     "picture"},
    {"", "probe", " X,Y", set_probe, OPTIONS_RUN,
     "print a pixel's march and colour, 0,0 bottom left; repeatable", ""},
    {"", "step", " K|walk", set_step, OPTIONS_RUN,
     "show that ray's march up to step K, from 0; walk: all of --frames", ""},
    {"", "from", " X,Y,Z,PAN,TILT", set_from, OPTIONS_RUN,
     "where the ray of --probe starts; --camera looks at it", "the camera"},
    {"", "overlay", "[=SCALE]", set_overlay, OPTIONS_RUN,
     "scale of the overlay, 0.5 to 8; draws it into a file too", "by the picture's height"},
    {"-b,", "backend", " NAME", set_backend, OPTIONS_RUN, "glfw, egl or osmesa",
     "glfw for a window; egl, osmesa, glfw for a file"},
    {"-f,", "shader", " FILE", set_shader, OPTIONS_RUN,
     "run this fragment shader instead of the chapter's", ""},
    {"", "compare", " [FILE]", set_compare, OPTIONS_RUN,
     "a second shader beside it; --set behind this is for that alone", ""},
    {"", "divider", " SHARE", set_divider, OPTIONS_RUN,
     "where the second picture of --compare begins, 0 to 1", "0.5"},
    {"", "root", " DIR", set_root, OPTIONS_RUN, "the project's folder",
     "found from the program's place"},
    {"", "frames", " N", set_frames, OPTIONS_RUN,
     "N pictures from --time on, as in -o frame-%04d.png", ""},
    {"", "fps", " F", set_fps, OPTIONS_RUN, "pictures a second of --frames", "25"},
    {"", "print-shader", "[=shadertoy]", set_print_shader, OPTIONS_PRINT_SHADER,
     "print the shader as one file; one for Shadertoy", ""},
    {"", "benchmark", " N|json", set_benchmark, OPTIONS_RUN,
     "measure compilation, N frames, evaluations of the scene; as JSON", "20 frames with json"},
    {"", "list", "", NULL, OPTIONS_LIST, "print the parameters: name, value, range, unit, meaning",
     ""},
    {"-h,", "help", "", NULL, OPTIONS_HELP, "print this text", ""},
    {"-V,", "version", "", NULL, OPTIONS_VERSION, "print backend, OpenGL version and renderer", ""},
};

enum { ROWS = sizeof rows / sizeof *rows };

static bool refuse_unknown(const char *word, size_t length)
{
    return report("unknown option '%.*s': --help lists the options", (int)length, word);
}

// Carry out an option.
//   text  what stands in the option's own word, or NULL
//   next  the words that follow, NULL at their end
static bool apply(struct options *options, const struct row *row, const char *text, char ***next)
{
    bool may = strncmp(row->value, " [", 2) == 0;
    if (may && text == NULL && **next != NULL && (**next)[0] != '-')
        text = *(*next)++;
    bool needs = row->value[0] == ' ' && !may && text == NULL;
    if (needs && **next == NULL)
        report("--%s: a value is missing: --help shows its form", row->name);
    else if (row->value[0] == '\0' && text != NULL)
        report("--%s: takes no value", row->name);
    else {
        // --help wins over other actions, so that it can be added to any command line.
        if (row->action != OPTIONS_RUN && options->action != OPTIONS_HELP)
            options->action = row->action;
        return row->set == NULL || row->set(options, needs ? *(*next)++ : text);
    }
    return false;
}

// --name, --name=value
static bool read_name(struct options *options, const char *word, char ***next)
{
    size_t length = strcspn(word, "=");
    for (const struct row *row = rows; row < rows + ROWS; row++)
        if (strlen(row->name) == length - 2 && strncmp(row->name, word + 2, length - 2) == 0)
            return apply(options, row, word[length] == '=' ? word + length + 1 : NULL, next);
    return refuse_unknown(word, length);
}

// -a, -avalue, -abc
static bool read_letters(struct options *options, const char *letter, char ***next)
{
    for (; *letter != '\0'; letter++) {
        const struct row *row = rows;
        while (row < rows + ROWS && (row->letter[0] == '\0' || row->letter[1] != *letter))
            row++;
        if (row == rows + ROWS)
            return refuse_unknown((char[]){'-', *letter, '\0'}, 2);
        if (row->value[0] != '\0')
            return apply(options, row, letter[1] != '\0' ? letter + 1 : NULL, next);
        if (!apply(options, row, NULL, next))
            return false;
    }
    return true;
}

static bool read_words(struct options *options, char **next)
{
    while (*next != NULL) {
        const char *word = *next++;
        bool named = strncmp(word, "--", 2) == 0, last = named && word[2] == '\0';
        if (last && *next == NULL)
            return true;
        if (word[0] != '-' || word[1] == '\0' || last)
            return report("unexpected argument '%s': --help lists the options",
                          last ? *next : word);
        if (named ? !read_name(options, word, &next) : !read_letters(options, word + 1, &next))
            return false;
    }
    return true;
}

static bool check_probes(const struct options *options)
{
    for (int i = 0; i < options->probe_count; i++) {
        const int *pixel = options->probe[i];
        if (pixel[0] < 0 || pixel[0] >= options->width || pixel[1] < 0 ||
            pixel[1] >= options->height)
            return report(
                "--probe '%d,%d': outside the picture of %dx%d: X is from 0 to %d, Y from 0 to %d",
                pixel[0], pixel[1], options->width, options->height, options->width - 1,
                options->height - 1);
    }
    return true;
}

// The ray that a picture shows: in a view of one ray's march, or in the overlay.
static bool check_ray(const struct options *options)
{
    bool view = form_shows_ray(options->view);
    bool overlaid = options->has_overlay && options->probe_count > 0;
    bool stepped = options->step >= 0 || options->walk;
    if (options->output == NULL && (stepped || options->has_from))
        return report("--%s: goes with --output: in a window E and Q go from step to step",
                      stepped ? "step" : "from");
    if (stepped && !view && !overlaid)
        return report("--step: goes with --view slice or plot, or with --probe and --overlay");
    if (options->walk != (options->frames > 0) && stepped)
        return report(options->walk
                          ? "--step walk: goes with --frames N: how many pictures?"
                          : "--step: one step of one picture: --frames wants --step walk");
    if (options->has_from && (view || !overlaid))
        return report("--from: a ray that is seen from elsewhere: goes with --probe and --overlay, "
                      "and no --view of one ray");
    return true;
}

// What one option asks of the others.
static bool complete(struct options *options)
{
    bool row = options->frames > 0, paced = options->fps > 0.0;
    options->fps = paced ? options->fps : FPS_DEFAULT;
    options->divider = options->has_divider ? options->divider : 0.5;
    if (!options->compares)
        options->shared_settings = options->setting_count;
    options->window =
        options->output == NULL && options->probe_count == 0 && options->benchmark == 0;
    if (options->width == 0) {
        options->width = options->window ? 960 : 640;
        options->height = options->window ? 540 : 360;
    }
    if (options->benchmark > 0 && (options->output != NULL || options->probe_count > 0))
        report("--benchmark: writes no picture and probes no ray: leave --%s out",
               options->output != NULL ? "output" : "probe");
    else if (options->has_divider && !options->compares)
        report("--divider: goes with --compare: what stands on its other side?");
    else if (options->compares && options->compare == NULL &&
             options->shared_settings == options->setting_count)
        report("--compare: with what? Give a shader's FILE, or --set NAME=VALUE behind it");
    else if (options->compares &&
             (options->benchmark > 0 || options->action == OPTIONS_PRINT_SHADER))
        report("--compare: goes with a window, a picture or --probe: leave --%s out",
               options->benchmark > 0 ? "benchmark" : "print-shader");
    else if (!row && paced)
        report("--fps: goes with --frames N: how many pictures?");
    else if (row && options->output == NULL)
        report("--frames: goes with --output, as in -o frame-%%04d.png");
    else if (row && !sequence_is_name(options->output))
        report("--output '%s': with --frames the name must hold one %%d for the number, as in "
               "frame-%%04d.png",
               options->output);
    else if (row && options->probe_count > 0 && !form_shows_ray(options->view) && !options->walk)
        report("--probe: the march of one picture: leave --frames out");
    else if (row && fabs(options->time) + options->frames / options->fps > LIMIT)
        report("--frames: the last time must be from -1e9 to 1e9 seconds");
    else if (options->shadertoy && options->view != SHADER_PICTURE)
        report("--print-shader=shadertoy: only the picture runs there: leave --view %s out",
               shader_view_name(options->view));
    else
        return check_probes(options) && check_ray(options);
    return false;
}

bool options_parse(struct options *options, int argc, char **argv)
{
    *options = (struct options){.samples = 1, .step = -1};
    options->settings = memory_zeros((size_t)argc, sizeof *options->settings);
    options->probe = memory_zeros((size_t)argc, sizeof *options->probe);
    options->textures = memory_zeros((size_t)argc, sizeof *options->textures);
    if (read_words(options, argv + (argc > 0)) && complete(options))
        return true;
    options_free(options);
    return false;
}

void options_free(struct options *options)
{
    free(options->settings);
    free(options->probe);
    free(options->textures);
    *options = (struct options){0};
}

// ---- Help ----

static const char ending[] =
    "In the window:\n"
    "  W A S D            move, by the keys' places on an American keyboard\n"
    "  Space, C           up, down (or Left Ctrl); Left Shift or F: faster\n"
    "  drag               look, or the divider of --compare; M captures and frees the mouse\n"
    "  click              choose a pixel's ray and show its march; again hides it\n"
    "  E, Q               a step on along the ray, and back; held they run; also Page Down, Up\n"
    "  Home, End          its first and last step\n"
    "  wheel              focal length; in the slice and the plot their zoom\n"
    "  Tab                perspective or orthographic, where the shader has both\n"
    "  1 2 3 4 5 6        views: picture, normals, depth, steps, slice, plot\n"
    "  up, down           choose a parameter\n"
    "  left, right        change it, with Shift ten steps; Delete resets it\n"
    "  Escape, R          pause and resume; restart the time, with Shift the camera too\n"
    "  H, K               hide and show the overlay; all keys and ranges in it\n"
    "  O, T               its panel to the other side; to its title alone, and back\n"
    "  P, F11             write a screenshot; full screen\n"
    "  Backspace          end\n\n"
    "Exit status: 0 done; 1 it could not be done; 2 the command line is wrong;\n"
    "3 no window can be opened here.\n";

void options_print_help(FILE *file, const char *program, const char *title, const char *shows)
{
    const int width = 30; // of the longest option
    fprintf(file, "Usage: %s [OPTION]...\n\n%s\n%s\n\n", program, title, shows);
    fprintf(file, "Without --output, --probe or --benchmark a window opens.\n\n");
    for (const struct row *row = rows; row < rows + ROWS; row++) {
        fprintf(file, "  %3s --%s%-*s  %s\n", row->letter, row->name,
                width - 6 - (int)strlen(row->name), row->value, row->meaning);
        if (row->initial[0] != '\0')
            fprintf(file, "  %*s  default: %s\n", width, "", row->initial);
    }
    fprintf(file, "\n%s", ending);
}
