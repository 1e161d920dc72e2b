#include "options.h"

#include <getopt.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "picture/benchmark.h"
#include "number.h"
#include "picture/overlay.h"
#include "report.h"
#include "sequence.h"

#define FPS_MINIMUM 0.001
#define FPS_MAXIMUM 1000.0

#define LIMIT 1e9 // of times and places: beyond it a float of the shader has lost every fraction

// Codes of the options that have no letter.
enum {
    CODE_PROBE = 256,
    CODE_ROOT,
    CODE_PRINT_SHADER,
    CODE_LIST,
    CODE_OVERLAY,
    CODE_FRAMES,
    CODE_FPS,
    CODE_BENCHMARK
};

static const struct option long_options[] = {
    {"output", required_argument, NULL, 'o'},
    {"size", required_argument, NULL, 's'},
    {"time", required_argument, NULL, 't'},
    {"set", required_argument, NULL, 'p'},
    {"camera", required_argument, NULL, 'c'},
    {"samples", required_argument, NULL, 'a'},
    {"view", required_argument, NULL, 'v'},
    {"probe", required_argument, NULL, CODE_PROBE},
    {"backend", required_argument, NULL, 'b'},
    {"shader", required_argument, NULL, 'f'},
    {"root", required_argument, NULL, CODE_ROOT},
    {"print-shader", optional_argument, NULL, CODE_PRINT_SHADER},
    {"list", no_argument, NULL, CODE_LIST},
    {"overlay", optional_argument, NULL, CODE_OVERLAY},
    {"frames", required_argument, NULL, CODE_FRAMES},
    {"fps", required_argument, NULL, CODE_FPS},
    {"benchmark", required_argument, NULL, CODE_BENCHMARK},
    {"help", no_argument, NULL, 'h'},
    {"version", no_argument, NULL, 'V'},
    {NULL, 0, NULL, 0},
};

// The ':' in front has getopt tell a missing value from an unknown option.
static const char letters[] = ":o:s:t:p:c:a:v:b:f:hV";

static const struct option *option_of(int code)
{
    for (const struct option *option = long_options; option->name != NULL; option++)
        if (option->val == code)
            return option;
    return NULL;
}

// ---- Values ----

// Each takes the text after its option and reports what is wrong with it.
static bool refuse(const char *option, const char *text, const char *expected)
{
    report("--%s '%s': %s", option, text, expected);
    return false;
}

// Read two whole numbers with a separator between; false when the form is wrong.
// A number that no int can hold is read as the largest or smallest one.
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

static bool set_size(struct options *options, const char *text)
{
    int size[2];
    if (!read_pair(text, 'x', size))
        return refuse("size", text, "must be WIDTHxHEIGHT in pixels, as in 640x360");
    for (int i = 0; i < 2; i++)
        if (size[i] < 1 || size[i] > OPTIONS_SIZE_LIMIT) {
            report("--size '%s': width and height must be from 1 to %d pixels", text,
                   OPTIONS_SIZE_LIMIT);
            return false;
        }
    options->width = size[0];
    options->height = size[1];
    return true;
}

static bool set_time(struct options *options, const char *text)
{
    double time;
    if (!number_read(text, &time))
        return refuse("time", text, "must be a number of seconds, as in 1.5");
    if (fabs(time) > LIMIT)
        return refuse("time", text, "must be from -1e9 to 1e9 seconds");
    options->time = time;
    return true;
}

static bool add_setting(struct options *options, const char *text)
{
    if (text[0] == '=' || strchr(text, '=') == NULL)
        return refuse("set", text, "must be NAME=VALUE; --list shows the names");
    options->settings[options->setting_count++] = text;
    return true;
}

static bool set_camera(struct options *options, const char *text)
{
    double value[5];
    const char *c = text;
    for (int i = 0; i < 5; i++) {
        size_t length = number_begin(c, &value[i]);
        if (length == 0 || c[length] != (i < 4 ? ',' : '\0'))
            return refuse("camera", text,
                          "must be X,Y,Z,PAN,TILT, five numbers, as in 0,1,4,0,-10");
        if (!(fabs(value[i]) <= LIMIT))
            return refuse("camera", text, "each number must be from -1e9 to 1e9");
        c += length + 1;
    }
    if (fabs(value[4]) > (double)CAMERA_TILT_LIMIT) {
        report("--camera '%s': the tilt must be from %g to %g degrees", text,
               (double)-CAMERA_TILT_LIMIT, (double)CAMERA_TILT_LIMIT);
        return false;
    }
    options->camera =
        (struct camera){.position = {(float)value[0], (float)value[1], (float)value[2]},
                        .pan = (float)value[3],
                        .tilt = (float)value[4]};
    options->has_camera = true;
    return true;
}

static bool set_samples(struct options *options, const char *text)
{
    if (number_read_int(text, 1, OPTIONS_SAMPLES_LIMIT, &options->samples))
        return true;
    report("--samples '%s': must be a whole number from 1 to %d: N x N samples a pixel", text,
           OPTIONS_SAMPLES_LIMIT);
    return false;
}

static bool set_frames(struct options *options, const char *text)
{
    if (number_read_int(text, 1, SEQUENCE_FRAMES_LIMIT, &options->frames))
        return true;
    report("--frames '%s': must be a whole number of pictures from 1 to %d", text,
           SEQUENCE_FRAMES_LIMIT);
    return false;
}

static bool set_fps(struct options *options, const char *text)
{
    if (number_read(text, &options->fps) && options->fps >= FPS_MINIMUM &&
        options->fps <= FPS_MAXIMUM)
        return true;
    report("--fps '%s': must be a number of pictures a second from %g to %g", text, FPS_MINIMUM,
           FPS_MAXIMUM);
    return false;
}

// A number of frames, or the word json; both may be given, one after the other.
static bool set_benchmark(struct options *options, const char *text)
{
    bool json = strcmp(text, "json") == 0;
    options->json = options->json || json;
    if (json && options->benchmark == 0)
        options->benchmark = BENCHMARK_FRAMES_DEFAULT;
    if (json || number_read_int(text, 1, BENCHMARK_FRAMES_LIMIT, &options->benchmark))
        return true;
    report("--benchmark '%s': must be a whole number of frames from 1 to %d, or json", text,
           BENCHMARK_FRAMES_LIMIT);
    return false;
}

static bool set_view(struct options *options, const char *text)
{
    char names[128] = "";
    if (shader_view_from_name(text, &options->view))
        return true;
    for (int i = 0; i < SHADER_VIEW_COUNT; i++)
        snprintf(names + strlen(names), sizeof names - strlen(names), "%s%s", i > 0 ? ", " : "",
                 shader_view_name((enum shader_view)i));
    report("--view '%s': no such view: there are %s", text, names);
    return false;
}

static bool set_probe(struct options *options, const char *text)
{
    int pixel[2];
    if (!read_pair(text, ',', pixel))
        return refuse("probe", text, "must be X,Y in pixels, as in 320,180");
    options->probe_x = pixel[0];
    options->probe_y = pixel[1];
    options->has_probe = true;
    return true;
}

static bool set_backend(struct options *options, const char *text)
{
    return context_backend_from_name(text, &options->backend) ||
           refuse("backend", text, "no such backend: there are glfw, egl, osmesa");
}

static bool set_path(const char *option, const char **path, const char *text)
{
    *path = text;
    return text[0] != '\0' || refuse(option, text, "must name a file or folder");
}

// --help wins over other actions, so that it can be added to any command line.
static bool set_action(struct options *options, enum options_action action)
{
    if (options->action != OPTIONS_HELP)
        options->action = action;
    return true;
}

//   form  NULL where none is given
static bool set_print_shader(struct options *options, const char *form)
{
    options->shadertoy = form != NULL;
    if (form == NULL || strcmp(form, "shadertoy") == 0)
        return set_action(options, OPTIONS_PRINT_SHADER);
    return refuse("print-shader", form, "must be shadertoy, or be left out");
}

// ---- The command line ----

//   text  the option's value, "" where it takes none
// The scale may be left out: it is NULL then.
static bool set_overlay(struct options *options, const char *scale)
{
    double value = 0.0;
    options->has_overlay = true;
    options->overlay = 0.0;
    if (scale == NULL)
        return true;
    if (!number_read(scale, &value) || value < OVERLAY_SCALE_MINIMUM ||
        value > OVERLAY_SCALE_MAXIMUM) {
        report("--overlay '%s': the scale must be a number from %g to %g", scale,
               OVERLAY_SCALE_MINIMUM, OVERLAY_SCALE_MAXIMUM);
        return false;
    }
    options->overlay = value;
    return true;
}

static bool apply(struct options *options, int code, const char *text)
{
    switch (code) {
    case 'o':
        return set_path("output", &options->output, text);
    case 's':
        return set_size(options, text);
    case 't':
        return set_time(options, text);
    case 'p':
        return add_setting(options, text);
    case 'c':
        return set_camera(options, text);
    case 'a':
        return set_samples(options, text);
    case 'v':
        return set_view(options, text);
    case CODE_PROBE:
        return set_probe(options, text);
    case 'b':
        return set_backend(options, text);
    case 'f':
        return set_path("shader", &options->shader, text);
    case CODE_ROOT:
        return set_path("root", &options->root, text);
    case CODE_FRAMES:
        return set_frames(options, text);
    case CODE_FPS:
        return set_fps(options, text);
    case CODE_BENCHMARK:
        return set_benchmark(options, text);
    case CODE_LIST:
        return set_action(options, OPTIONS_LIST);
    case 'h':
        return set_action(options, OPTIONS_HELP);
    default:
        return set_action(options, OPTIONS_VERSION);
    }
}

static bool refuse_unknown(const char *word)
{
    report("unknown option '%.*s': --help lists the options", (int)strcspn(word, "="), word);
    return false;
}

// getopt takes "--out" for "--output", which would change its meaning when an option is added.
//   word  the argument that holds the option
static bool is_in_full(const char *word, int code)
{
    const struct option *option = option_of(code);
    size_t length = strcspn(word, "=");
    return word[0] != '-' || word[1] != '-' || option == NULL ||
           (length == strlen(option->name) + 2 && strncmp(word + 2, option->name, length - 2) == 0);
}

// Report what getopt could not read.
//   code  ':' for a missing value, '?' otherwise
//   word  the argument that it read last
static bool refuse_option(int code, const char *word)
{
    const struct option *option = option_of(optopt);
    if (code == ':' && option != NULL && !is_in_full(word, optopt))
        return refuse_unknown(word);
    if (code == ':' && option != NULL)
        report("--%s: a value is missing: --help shows its form", option->name);
    else if (optopt == 0 || option == NULL || !is_in_full(word, optopt)) {
        char letter[] = {'-', (char)optopt, '\0'};
        return refuse_unknown(optopt == 0 || optopt > 255 ? word : letter);
    } else
        report("--%s: takes no value", option->name);
    return false;
}

static bool read_options(struct options *options, int argc, char **argv)
{
    opterr = 0;
    optind = 0; // begin anew, in every C library
    for (;;) {
        int code = getopt_long(argc, argv, letters, long_options, NULL);
        if (code == -1)
            break;
        const char *word = optind > 0 && optind <= argc ? argv[optind - 1] : "";
        if (code == '?' || code == ':')
            return refuse_option(code, word);
        if (optarg != NULL && optarg == word)
            word = argv[optind - 2];
        if (!is_in_full(word, code))
            return refuse_unknown(word);
        bool taken = code == CODE_PRINT_SHADER ? set_print_shader(options, optarg)
                     : code == CODE_OVERLAY    ? set_overlay(options, optarg)
                                               : apply(options, code, optarg != NULL ? optarg : "");
        if (!taken)
            return false;
    }
    if (optind < argc)
        report("unexpected argument '%s': --help lists the options", argv[optind]);
    return optind >= argc;
}

bool options_parse(struct options *options, int argc, char **argv)
{
    *options = (struct options){.samples = 1};
    options->settings = malloc(((size_t)argc + 1) * sizeof *options->settings);
    if (options->settings == NULL)
        report("command line: not enough memory");
    else if (read_options(options, argc, argv) && options_complete(options))
        return true;
    options_free(options);
    return false;
}

void options_free(struct options *options)
{
    free(options->settings);
    *options = (struct options){0};
}
