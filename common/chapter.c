#include "chapter.h"

#include <stdio.h>
#include <stdlib.h>

#include "command/run.h"
#include "context/guard.h"
#include "memory.h"
#include "picture/benchmark.h"
#include "platform.h"
#include "report.h"
#include "shader/export.h"

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
        return RUN_NOT_DONE;
    fputs(text, stdout);
    free(text);
    return RUN_DONE;
}

static int print_version(const struct run *run)
{
    struct context context = {0};
    char text[512];
    if (!context_open_offscreen(&context, run->options.backend))
        return RUN_NOT_DONE;
    context_describe(&context, text, sizeof text);
    printf("%s: %s\n", run->stem, text);
    context_close(&context);
    return RUN_DONE;
}

static int run_benchmark(struct run *run, const struct context *context, struct renderer *renderer)
{
    const struct options *options = &run->options;
    struct benchmark benchmark = {.shader = options->shader != NULL ? options->shader : run->stem,
                                  .frames = options->benchmark,
                                  .inputs = run_still_inputs(options)};
    if (!benchmark_load(&benchmark, renderer, &run->source, &run->parameters) ||
        !benchmark_run(&benchmark, context, renderer))
        return RUN_NOT_DONE;
    benchmark_print(&benchmark, options->json, stdout);
    return RUN_DONE;
}

static bool open_loop(struct run *run)
{
    const struct options *options = &run->options;
    run->start = (struct window_start){.title = run->title,
                                       .stem = run->stem,
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
        return RUN_NOT_DONE;
    bool done = context->window != NULL ? open_loop(run) : run_still(run, renderer);
    return done ? RUN_DONE : RUN_NOT_DONE;
}

static int open_and_work(struct run *run)
{
    struct context *context = &run->context;
    const struct options *options = &run->options;
    if (options->benchmark > 0)
        guard_forget_caches();
    if (!run_check_targets(run))
        return RUN_NOT_DONE;
    bool opened = options->window ? context_open_window(context, options->backend, run->title,
                                                        options->width, options->height)
                                  : context_open_offscreen(context, options->backend);
    int status = options->window && !opened ? RUN_NO_WINDOW : RUN_NOT_DONE;
    if (opened && renderer_open(&run->renderer, &context->gl, run->root))
        status = work(run, context, &run->renderer);
    return status;
}

// The parameters and textures of --list.
static int print_list(const struct run *run)
{
    parameters_print(&run->parameters, stdout);
    samplers_print(&run->parameters.samplers, &run->source, stdout);
    if (run->options.compares) {
        printf("\n# beside it\n");
        parameters_print(&run->second.parameters, stdout);
        samplers_print(&run->second.parameters.samplers, &run->second.source, stdout);
    }
    return RUN_DONE;
}

static int act(struct run *run, const struct chapter *chapter, const char *program)
{
    if (run->options.action == OPTIONS_HELP) {
        options_print_help(stdout, program, chapter->title, chapter->shows);
        return RUN_DONE;
    }
    if (run->options.action == OPTIONS_VERSION)
        return print_version(run);
    if (!run_find_root(run) || !run_find_shader(run))
        return RUN_NOT_DONE;
    int status = run_read_shader(run);
    if (status != RUN_DONE)
        return status;
    switch (run->options.action) {
    case OPTIONS_PRINT_SHADER:
        return print_shader(run);
    case OPTIONS_LIST:
        return print_list(run);
    default:
        return open_and_work(run);
    }
}

// Read the command line. Returns the exit status.
static int begin(struct run *run, const struct chapter *chapter, int argc, char **argv)
{
    if (!guard_stack())
        return RUN_NOT_DONE;
    return run_parse(run, chapter->stem, chapter->title, &chapter->camera, argc, argv)
               ? RUN_DONE
               : RUN_WRONG_COMMAND_LINE;
}

int chapter_open(struct run **run, const struct chapter *chapter, int argc, char **argv)
{
    *run = memory_zeros(1, sizeof **run);
    int status = begin(*run, chapter, argc, argv);
    return status == RUN_DONE ? act(*run, chapter, argv[0]) : status;
}

struct window *chapter_window(const struct run *run)
{
    return run->window;
}

void chapter_close(struct run *run)
{
    run_close(run);
    free(run);
}

int chapter_run(const struct chapter *chapter, int argc, char **argv)
{
    struct run *run;
    int status = chapter_open(&run, chapter, argc, argv);
    if (run->window != NULL && !window_run(run->window))
        status = RUN_NOT_DONE;
    chapter_close(run);
    if (fflush(stdout) == 0 && !ferror(stdout))
        return status;
    if (!platform_reader_left()) // who needs no more of it need not hear so
        report("standard output: cannot be written: is the disk full?");
    return RUN_NOT_DONE;
}

void chapter_see(const struct chapter *chapter, int argc, char **argv,
                 void (*see)(void *to, const char *path), void *to)
{
    struct run run = {.request = {.see = see, .to = to}};
    if (begin(&run, chapter, argc, argv) == RUN_DONE && run_find_root(&run) &&
        run_find_shader(&run)) {
        see(to, run.shader); // also where it is missing
        if (run.options.compare != NULL)
            see(to, run.options.compare);
        run_read_shader(&run);
    }
    run_close(&run);
}
