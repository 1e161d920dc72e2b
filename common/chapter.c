#include "chapter.h"

#include <stdio.h>
#include <stdlib.h>

#include "command/run.h"
#include "context/guard.h"
#include "memory.h"
#include "picture/benchmark.h"
#include "platform.h"
#include "report.h"
#include "shader/compile.h"
#include "shader/dialects.h"

static int print_shader(struct run *run)
{
    const struct options *options = &run->options;
    struct shader_source *source = &run->picture[0].source;
    char *text = NULL;
    if ((options->shadertoy || options->page) && dialects.export_file == NULL)
        report("--print-shader=%s: this program was built without common/dialects/",
               options->page ? "page" : "shadertoy");
    else if (options->shadertoy || options->page)
        text = dialects.export_file(source, &run->picture[0].parameters, &options->camera,
                                    RENDERER_FOCAL_LENGTH, options->page);
    else if (shader_has_view(source, options->view))
        text = shader_text(source, options->view);
    if (text == NULL)
        return RUN_NOT_DONE;
    if (platform_is_terminal(stdout))
        report_text(text);
    else
        fputs(text, stdout); // a file receives every byte of the shader
    free(text);
    return RUN_DONE;
}

// Print the text of a stream that memory_open opened, and free it.
static void print_stream(FILE *stream, char **text)
{
    memory_close(stream);
    report_text(*text);
    free(*text);
}

static int print_version(const struct run *run)
{
    struct context context = {0};
    char text[512];
    if (!context_open_offscreen(&context, run->options.backend))
        return RUN_NOT_DONE;
    context_describe(&context, text, sizeof text);
    report_result("%s: %s\n", run->stem, text);
    context_close(&context);
    return RUN_DONE;
}

static bool run_benchmark(struct run *run)
{
    const struct options *options = &run->options;
    struct loader *picture = &run->picture[0];
    struct renderer *renderer = &picture->renderer;
    struct benchmark benchmark = {.shader = options->shader != NULL ? options->shader : run->stem,
                                  .frames = options->benchmark,
                                  .inputs = run_still_inputs(options)};
    if (!renderer_open(renderer, &run->context.gl, run->root))
        return false;
    renderer->view = options->view;
    if (!benchmark_load(&benchmark, renderer, &picture->source, &picture->parameters) ||
        !benchmark_run(&benchmark, &run->context, renderer))
        return false;
    char *text;
    FILE *stream = memory_open(&text);
    benchmark_print(&benchmark, options->json, stream);
    print_stream(stream, &text);
    return true;
}

static bool open_loop(struct run *run)
{
    run->start = run_window_start(run);
    if (run->options.shader != NULL)
        report_result("%s: reloads on every save\n", run->options.shader);
    fflush(stdout);
    run->window = window_open(&run->context, &run->start);
    return run->window != NULL;
}

static int open_context(struct run *run)
{
    const struct options *options = &run->options;
    if (!options->window)
        return context_open_offscreen(&run->context, options->backend) ? RUN_DONE : RUN_NOT_DONE;
    return context_open_window(&run->context, options->backend, run->title, options->width,
                               options->height)
               ? RUN_DONE
               : RUN_NO_WINDOW;
}

static int open_and_draw(struct run *run)
{
    struct context *context = &run->context;
    const struct options *options = &run->options;
    bool done;
    if (options->benchmark > 0)
        guard_forget_caches();
    if (!run_check_targets(run))
        return RUN_NOT_DONE;
    int status = open_context(run);
    if (status != RUN_DONE)
        return status;
    if (options->benchmark > 0)
        done = run_benchmark(run);
    else
        done =
            run_compile(run, &context->gl) && (options->window ? open_loop(run) : run_still(run));
    return done ? RUN_DONE : RUN_NOT_DONE;
}

// Print the parameters and textures for --list.
static int print_list(const struct run *run)
{
    char *text;
    FILE *stream = memory_open(&text);
    for (int i = 0; i < (run->options.compares ? 2 : 1); i++) {
        const struct loader *picture = &run->picture[i];
        if (i > 0)
            fprintf(stream, "\n# second picture\n");
        parameters_print(&picture->parameters, stream);
        samplers_print(&picture->parameters.samplers, &picture->source, stream);
    }
    print_stream(stream, &text);
    return RUN_DONE;
}

static int act(struct run *run, const struct chapter *chapter, const char *program)
{
    if (run->options.action == OPTIONS_HELP) {
        char *text;
        FILE *stream = memory_open(&text);
        options_print_help(stream, program, chapter->title, chapter->shows);
        print_stream(stream, &text);
        return RUN_DONE;
    }
    if (run->options.action == OPTIONS_VERSION)
        return print_version(run);
    if (!run_find_root(run) || !run_find_shader(run))
        return RUN_NOT_DONE;
    int status = run_read_shaders(run);
    if (status != RUN_DONE)
        return status;
    switch (run->options.action) {
    case OPTIONS_PRINT_SHADER:
        return print_shader(run);
    case OPTIONS_LIST:
        return print_list(run);
    default:
        return open_and_draw(run);
    }
}

int chapter_open(struct run **run, const struct chapter *chapter, int argc, char **argv)
{
    *run = memory_zeros(1, sizeof **run);
    return run_parse(*run, chapter->stem, chapter->title, &chapter->camera, chapter->tool, argc,
                     argv)
               ? act(*run, chapter, argv[0])
               : RUN_WRONG_COMMAND_LINE;
}

void chapter_begin(struct run **run, const struct chapter *chapter, int argc, char **argv)
{
    *run = memory_zeros(1, sizeof **run);
    if (run_parse(*run, chapter->stem, chapter->title, &chapter->camera, chapter->tool, argc,
                  argv) &&
        (*run)->options.action == OPTIONS_RUN && (*run)->options.benchmark == 0 &&
        run_find_root(*run) && run_find_shader(*run) && run_read_shaders(*run) == RUN_DONE &&
        open_context(*run) == RUN_DONE)
        run_begin(*run, &(*run)->context.gl);
}

bool chapter_ready(const struct run *run)
{
    return shader_ready(&run->context.gl);
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
    bool window = run->window != NULL;
    if (window && !window_run(run->window, NULL, NULL))
        status = RUN_NOT_DONE;
    chapter_close(run);
    return run_end(status, window);
}

void chapter_visit_files(const struct chapter *chapter, int argc, char **argv,
                         void (*visit)(void *to, const char *path), void *to)
{
    struct run run = {0};
    for (int i = 0; i < 2; i++)
        run.picture[i].request = (struct shader_request){.visit = visit, .to = to};
    if (run_parse(&run, chapter->stem, chapter->title, &chapter->camera, chapter->tool, argc,
                  argv) &&
        run_find_root(&run) && run_find_shader(&run)) {
        visit(to, run.shader); // even if the file is missing
        if (run.options.compare != NULL)
            visit(to, run.options.compare);
        run_read_shaders(&run);
    }
    run_close(&run);
}
