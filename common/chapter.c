#include "chapter.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "picture/aside.h"
#include "picture/benchmark.h"
#include "context/context.h"
#include "context/guard.h"
#include "shader/export.h"
#include "picture/image.h"
#include "memory.h"
#include "command/options.h"
#include "picture/panel.h"
#include "platform.h"
#include "picture/probe.h"
#include "picture/renderer.h"
#include "picture/second.h"
#include "report.h"
#include "sequence.h"
#include "window/window.h"

// Of a film of a march, while it waits at the first step; twice as long at the last.
#define WALK_WAIT 0.06

enum { DONE = 0, NOT_DONE = 1, WRONG_COMMAND_LINE = 2, NO_WINDOW = 3 };

// What one run of a chapter works with.
struct run {
    const struct chapter *chapter;
    struct options options;
    char root[PLATFORM_PATH];   // the project's folder
    char shader[PLATFORM_PATH]; // the shader to run
    struct shader_request request;
    // What was read of it, until the renderer takes it over.
    struct shader_source source;
    struct parameters parameters;
    struct second second; // of --compare
    // What works until chapter_close.
    struct context context;
    struct renderer renderer;
    struct window_start start;
    struct window *window; // NULL where none was asked for
};

static bool is_root(const char *folder)
{
    char path[PLATFORM_PATH + 32];
    struct platform_file file;
    snprintf(path, sizeof path, "%s/shaders/screen.vert", folder);
    return platform_look(path, &file) && file.regular;
}

static bool take_root(struct run *run, const char *given)
{
    char *resolved = platform_resolve(given);
    bool fits = resolved != NULL &&
                snprintf(run->root, sizeof run->root, "%s", resolved) < (int)sizeof run->root;
    free(resolved);
    return (fits && is_root(run->root)) ||
           report("--root %s: no shaders/screen.vert in it: give the project's folder", given);
}

// Find the project's folder: --root, or the nearest folder above the program that holds shaders/,
// so that programs run from any directory.
static bool find_root(struct run *run)
{
    if (run->options.root != NULL)
        return take_root(run, run->options.root);
    char *slash = NULL;
    if (platform_program(run->root))
        while ((slash = strrchr(run->root, '/')) != NULL && slash != run->root) {
            *slash = '\0';
            if (is_root(run->root))
                return true;
        }
    return report("shaders/screen.vert: not found above this program's folder: give --root DIR");
}

static bool find_shader(struct run *run)
{
    int length = run->options.shader != NULL
                     ? snprintf(run->shader, sizeof run->shader, "%s", run->options.shader)
                     : snprintf(run->shader, sizeof run->shader, "%s/chapters/%s.frag", run->root,
                                run->chapter->stem);
    if (length < (int)sizeof run->shader)
        return true;
    return report("%.40s...: the path of the shader is too long", run->shader);
}

// The chapter's title, or the name of the file that runs in place of its shader.
static const char *title_of(const struct run *run)
{
    if (run->options.shader == NULL)
        return run->chapter->title;
    const char *slash = strrchr(run->options.shader, '/');
    return slash != NULL ? slash + 1 : run->options.shader;
}

// Read the shader of --compare; as read_shader.
static int read_second(struct run *run)
{
    const struct options *options = &run->options;
    const struct second_request request = {.file = options->compare,
                                           .own = options->settings + options->shared_settings,
                                           .own_count =
                                               options->setting_count - options->shared_settings,
                                           .divider = options->divider,
                                           .gripped = options->window,
                                           .reading = &run->request};
    if (!second_read(&run->second, &request, run->shader, run->root))
        return NOT_DONE;
    return second_assign(&run->second) ? DONE : WRONG_COMMAND_LINE;
}

// Read the shader and its parameters, with values and pictures of the command line. Returns the
// exit status.
static int read_shader(struct run *run)
{
    run->request.textures = run->options.textures;
    run->request.texture_count = run->options.texture_count;
    run->request.channels = run->options.channels;
    if (!shader_read_asked(&run->source, run->shader, run->root, &run->request) ||
        !parameters_read(&run->parameters, &run->source))
        return NOT_DONE;
    if (!samplers_fit(&run->parameters.samplers, &run->source))
        return WRONG_COMMAND_LINE;
    for (int i = 0; i < run->options.shared_settings; i++)
        if (!parameters_assign(&run->parameters, run->options.settings[i]))
            return WRONG_COMMAND_LINE;
    return run->options.compares ? read_second(run) : DONE;
}

static int print_shader(const struct run *run)
{
    const struct options *options = &run->options;
    char *text = NULL;
    if (options->shadertoy)
        text = export_shadertoy(&run->source, &run->parameters, &options->camera,
                                RENDERER_FOCAL_LENGTH);
    else if (shader_has_view(&run->source, options->view))
        text = shader_text(&run->source, options->view);
    if (text == NULL)
        return NOT_DONE;
    fputs(text, stdout);
    free(text);
    return DONE;
}

static int print_version(const struct run *run)
{
    struct context context = {0};
    char text[512];
    if (!context_open_offscreen(&context, run->options.backend))
        return NOT_DONE;
    context_describe(&context, text, sizeof text);
    printf("%s: %s\n", run->chapter->stem, text);
    context_close(&context);
    return DONE;
}

// Draw the overlay over a picture that is about to be written, or of a pair the labels alone. The
// caller closes the overlay.
//   probe  of the pixel that --probe names, or NULL
static bool add_overlay(const struct run *run, struct renderer *renderer,
                        const struct renderer_inputs *inputs, const struct probe *probe,
                        struct overlay *overlay)
{
    double asked = run->options.overlay;
    float scale = asked > 0.0 ? (float)asked : overlay_scale_of(inputs->height);
    struct panel panel = {.title = title_of(run),
                          .renderer = renderer,
                          .ranges = true,
                          .pixel = {inputs->pixel[0], inputs->pixel[1]},
                          .side = pair_side_name(renderer, inputs->width, inputs->pixel[0]),
                          .shown = inputs->shown,
                          .probe = probe};
    if (!overlay_open(overlay, renderer->gl))
        return false;
    if (run->options.has_overlay)
        panel_gather(&panel, overlay, inputs->width, inputs->height, scale);
    else
        pair_gather(renderer, overlay, inputs->width, inputs->height, scale);
    renderer->overlay = overlay;
    return true;
}

// Draw a picture with what stands over it. The caller frees image.
static bool draw_picture(const struct run *run, struct renderer *renderer,
                         const struct renderer_inputs *inputs, const struct probe *probe,
                         struct image *image)
{
    struct overlay overlay = {0};
    bool wants = run->options.has_overlay || renderer->pair != NULL;
    bool done = (!wants || add_overlay(run, renderer, inputs, probe, &overlay)) &&
                renderer_picture(renderer, inputs, image);
    renderer->overlay = NULL;
    overlay_close(&overlay);
    return done;
}

static bool write_picture(const struct run *run, struct renderer *renderer,
                          const struct renderer_inputs *inputs, const struct probe *probe,
                          const char *path)
{
    struct image image = {0};
    bool done = draw_picture(run, renderer, inputs, probe, &image) && image_write_png(&image, path);
    image_free(&image);
    return done;
}

static struct renderer_inputs still_inputs(const struct options *options)
{
    const int *pixel = options->probe_count > 0 ? options->probe[options->probe_count - 1] : NULL;
    // No clock: a picture is a function of its options alone.
    return (struct renderer_inputs){
        .width = options->width,
        .height = options->height,
        .camera = options->camera,
        .time = options->time,
        .date = {1970.0f, 0.0f, 1.0f, (float)options->time},
        .samples = options->samples,
        .pixel = {pixel != NULL ? pixel[0] : -1, pixel != NULL ? pixel[1] : -1},
        .zoom = 1.0f,
        .shown = (float)(options->step + 1)};
}

// Where the ray of --probe starts, if that is not at the camera.
//   eye  must outlive the inputs
static void start_ray(const struct options *options, const struct renderer *renderer,
                      struct renderer_inputs *inputs, struct renderer_eye *eye)
{
    *eye = aside_eye(renderer, inputs);
    eye->camera = options->from;
    inputs->eye = options->has_from ? eye : NULL;
}

// March the ray that the pictures show, where its steps are counted.
//   probe  receives it
// Returns false, reported: --step is beyond its end.
static bool march_shown(const struct run *run, struct renderer *renderer,
                        const struct renderer_inputs *inputs, struct probe *probe)
{
    int x = inputs->pixel[0] < 0 ? inputs->width / 2 : inputs->pixel[0];
    int y = inputs->pixel[0] < 0 ? inputs->height / 2 : inputs->pixel[1];
    if (!renderer_probe(renderer, inputs, x, y, probe))
        return false;
    if (run->options.step < probe_rows(probe))
        return true;
    return report("--step %d: the march of pixel %d,%d has %d steps, from 0 on", run->options.step,
                  x, y, probe_rows(probe));
}

// How much of a march the picture i of n shows. The walk goes from the first step to the last; it
// waits at both for a while, so that a film that begins again shows where it is.
static float shown_of(int i, int n, int steps)
{
    double share = n > 1 ? (double)i / (n - 1) : 1.0;
    double walked = fmin(fmax((share - WALK_WAIT) / (1.0 - 3.0 * WALK_WAIT), 0.0), 1.0);
    return (float)(1.0 + walked * (steps > 0 ? steps - 1 : 0));
}

// The pictures of --frames, with one context and one program.
static bool write_frames(const struct run *run, struct renderer *renderer)
{
    const struct options *options = &run->options;
    struct renderer_inputs inputs = still_inputs(options);
    struct renderer_eye eye;
    char path[PLATFORM_PATH];
    struct probe *probe = options->walk ? memory_zeros(1, sizeof *probe) : NULL;
    start_ray(options, renderer, &inputs, &eye);
    bool done = probe == NULL || march_shown(run, renderer, &inputs, probe);
    for (int i = 0; i < options->frames && done; i++) {
        sequence_progress(i, options->frames);
        inputs.frame = i;
        // A walk is along one march: its time stands still.
        inputs.time = options->time + (options->walk ? 0.0 : i / options->fps);
        inputs.date[3] = (float)inputs.time;
        inputs.time_delta = i > 0 ? 1.0 / options->fps : 0.0;
        if (probe != NULL)
            inputs.shown = shown_of(i, options->frames, probe_rows(probe));
        done = sequence_path(options->output, i, path, sizeof path) &&
               write_picture(run, renderer, &inputs, probe, path);
    }
    if (done)
        sequence_progress(options->frames, options->frames);
    free(probe);
    return done;
}

// True when a file is none of those that a shader was read from: a picture in its place would
// destroy a person's work. Reported.
static bool check_source(const struct shader_source *source, const char *path)
{
    struct platform_file target, read;
    for (int i = 0; i < source->file_count && platform_look(path, &target); i++)
        if (platform_look(source->paths[i], &read) && platform_is_same(&read, &target))
            return report("--output '%s': is %s, which this run reads: choose another name", path,
                          source->files[i]);
    return true;
}

// The same of all that this run has read.
static bool check_unread(const struct run *run, const char *path)
{
    char vertex[PLATFORM_PATH + 32];
    char *files[] = {vertex};
    const struct shader_source own = {.paths = files, .files = files, .file_count = 1};
    snprintf(vertex, sizeof vertex, "%s/shaders/screen.vert", run->root);
    return check_source(&own, path) && check_source(&run->source, path) &&
           check_source(&run->second.source, path);
}

// True when every file of --output can be written, before the work of rendering. Reported.
static bool check_targets(const struct run *run)
{
    const struct options *options = &run->options;
    char path[PLATFORM_PATH];
    if (options->frames == 0)
        return options->output == NULL ||
               (image_check_target(options->output) && check_unread(run, options->output));
    for (int i = 0; i < options->frames; i++)
        if (!sequence_path(options->output, i, path, sizeof path) || !image_check_target(path) ||
            !check_unread(run, path))
            return false;
    return true;
}

// The tables of --probe, then the picture of --output.
static bool work_still(const struct run *run, struct renderer *renderer)
{
    const struct options *options = &run->options;
    struct renderer_inputs inputs = still_inputs(options);
    struct renderer_eye eye;
    struct probe *probe = NULL;
    bool done = true;
    start_ray(options, renderer, &inputs, &eye);
    if (options->frames > 0)
        return write_frames(run, renderer);
    for (int i = 0; i < options->probe_count && done; i++) {
        probe = probe != NULL ? probe : memory_zeros(1, sizeof *probe);
        done = renderer_probe(renderer, &inputs, options->probe[i][0], options->probe[i][1], probe);
        if (done)
            probe_print(probe, stdout);
    }
    if (done && options->step >= 0) {
        probe = probe != NULL ? probe : memory_zeros(1, sizeof *probe);
        done = march_shown(run, renderer, &inputs, probe);
    }
    done = done && (options->output == NULL ||
                    write_picture(run, renderer, &inputs, probe, options->output));
    free(probe);
    return done;
}

static int run_benchmark(struct run *run, const struct context *context, struct renderer *renderer)
{
    const struct options *options = &run->options;
    struct benchmark benchmark = {.shader = options->shader != NULL ? options->shader
                                                                    : run->chapter->stem,
                                  .frames = options->benchmark,
                                  .inputs = still_inputs(options)};
    if (!benchmark_load(&benchmark, renderer, &run->source, &run->parameters) ||
        !benchmark_run(&benchmark, context, renderer))
        return NOT_DONE;
    benchmark_print(&benchmark, options->json, stdout);
    return DONE;
}

static bool open_loop(struct run *run)
{
    const struct options *options = &run->options;
    run->start = (struct window_start){.title = title_of(run),
                                       .stem = run->chapter->stem,
                                       .shader = run->shader,
                                       .request = &run->request,
                                       .second = run->second.shader,
                                       .camera = options->camera,
                                       .time = options->time,
                                       .samples = options->samples,
                                       .overlay_scale = options->overlay,
                                       .overlay_kept = options->has_overlay};
    if (options->shader != NULL)
        printf("%s: every save is shown at once\n", options->shader);
    fflush(stdout);
    run->window = window_open(&run->context, &run->renderer, &run->start);
    return run->window != NULL;
}

// With a context and a renderer: load the shader, then carry out what was asked.
static int work(struct run *run, struct context *context, struct renderer *renderer)
{
    renderer->view = run->options.view;
    if (run->options.benchmark > 0)
        return run_benchmark(run, context, renderer);
    if (!renderer_load(renderer, &run->source, &run->parameters) ||
        !second_load(&run->second, renderer))
        return NOT_DONE;
    bool done = context->window != NULL ? open_loop(run) : work_still(run, renderer);
    return done ? DONE : NOT_DONE;
}

static int open_and_work(struct run *run)
{
    struct context *context = &run->context;
    const struct options *options = &run->options;
    if (options->benchmark > 0)
        guard_forget_caches();
    if (!check_targets(run))
        return NOT_DONE;
    bool opened = options->window ? context_open_window(context, options->backend, title_of(run),
                                                        options->width, options->height)
                                  : context_open_offscreen(context, options->backend);
    int status = options->window && !opened ? NO_WINDOW : NOT_DONE;
    if (opened && renderer_open(&run->renderer, &context->gl, run->root))
        status = work(run, context, &run->renderer);
    return status;
}

static int act(struct run *run, const char *program)
{
    if (run->options.action == OPTIONS_HELP) {
        options_print_help(stdout, program, run->chapter->title, run->chapter->shows);
        return DONE;
    }
    if (run->options.action == OPTIONS_VERSION)
        return print_version(run);
    if (!find_root(run) || !find_shader(run))
        return NOT_DONE;
    int status = read_shader(run);
    if (status != DONE)
        return status;
    switch (run->options.action) {
    case OPTIONS_PRINT_SHADER:
        return print_shader(run);
    case OPTIONS_LIST:
        parameters_print(&run->parameters, stdout);
        samplers_print(&run->parameters.samplers, &run->source, stdout);
        if (run->options.compares) {
            printf("\n# beside it\n");
            parameters_print(&run->second.parameters, stdout);
            samplers_print(&run->second.parameters.samplers, &run->second.source, stdout);
        }
        return DONE;
    default:
        return open_and_work(run);
    }
}

// Read the command line. Returns the exit status.
static int begin(struct run *run, const struct chapter *chapter, int argc, char **argv)
{
    run->chapter = chapter;
    if (!guard_stack())
        return NOT_DONE;
    if (!options_parse(&run->options, argc, argv))
        return WRONG_COMMAND_LINE;
    if (!run->options.has_camera)
        run->options.camera = chapter->camera;
    return DONE;
}

int chapter_open(struct run **run, const struct chapter *chapter, int argc, char **argv)
{
    *run = memory_zeros(1, sizeof **run);
    int status = begin(*run, chapter, argc, argv);
    return status == DONE ? act(*run, argv[0]) : status;
}

struct window *chapter_window(const struct run *run)
{
    return run->window;
}

void chapter_close(struct run *run)
{
    window_close(run->window);
    second_close(&run->second);
    renderer_close(&run->renderer);
    context_close(&run->context);
    shader_free(&run->source);
    parameters_free(&run->parameters);
    options_free(&run->options);
    free(run);
}

int chapter_run(const struct chapter *chapter, int argc, char **argv)
{
    struct run *run;
    int status = chapter_open(&run, chapter, argc, argv);
    if (run->window != NULL && !window_run(run->window))
        status = NOT_DONE;
    chapter_close(run);
    if (fflush(stdout) != 0 || ferror(stdout)) {
        report("standard output: cannot be written: is the disk full?");
        return NOT_DONE;
    }
    return status;
}

void chapter_see(const struct chapter *chapter, int argc, char **argv,
                 void (*see)(void *to, const char *path), void *to)
{
    struct run run = {.request = {.see = see, .to = to}};
    if (begin(&run, chapter, argc, argv) == DONE && find_root(&run) && find_shader(&run)) {
        see(to, run.shader); // also where it is missing
        if (run.options.compare != NULL)
            see(to, run.options.compare);
        read_shader(&run);
    }
    second_close(&run.second);
    shader_free(&run.source);
    parameters_free(&run.parameters);
    options_free(&run.options);
}
