#include "command/run.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "picture/passes.h"
#include "platform.h"
#include "report.h"
#include "command/sequence.h"
#include "shader/compile.h"

static const char *name_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

bool run_parse(struct run *run, const char *stem, const char *title, const struct camera *camera,
               const struct sculpture_tool *tool, int argc, char **argv)
{
    if (!options_parse(&run->options, argc, argv))
        return false;
    if (tool == NULL && run->options.strokes.count > 0)
        return report("--stroke: %s has no tool; chapter 23 has one", stem);
    run->tool = tool;
    if (!run->options.has_camera)
        run->options.camera = *camera;
    run->stem = stem;
    const struct options *options = &run->options;
    bool named = options->shader != NULL && options->labels == NULL;
    report_clean(run->title, sizeof run->title, named ? name_of(options->shader) : title);
    return true;
}

void run_close(struct run *run)
{
    window_close(run->window);
    for (int i = 1; i >= 0; i--)
        loader_close(&run->picture[i]);
    context_close(&run->context);
    options_free(&run->options);
    *run = (struct run){0};
}

// ---- Files ----

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
           report("--root %s: contains no shaders/screen.vert: give the project's folder", given);
}

bool run_find_root(struct run *run)
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
    return report("shaders/screen.vert: not in this program's folder or above it: give --root DIR");
}

bool run_find_shader(struct run *run)
{
    int length = run->options.shader != NULL
                     ? snprintf(run->shader, sizeof run->shader, "%s", run->options.shader)
                     : snprintf(run->shader, sizeof run->shader, "%s/chapters/%s.frag", run->root,
                                run->stem);
    if (length < (int)sizeof run->shader)
        return true;
    return report("%.40s...: the path of the shader is too long", run->shader);
}

// Read one of the shaders and set the values of its parameters.
static int read_shader(struct run *run, int number, const char *path)
{
    const struct options *options = &run->options;
    struct loader *picture = &run->picture[number];
    int first = number == 0 ? 0 : options->shared_settings;
    int end = number == 0 ? options->shared_settings : options->setting_count;
    picture->path = path;
    picture->root = run->root;
    picture->request.textures = options->textures;
    picture->request.texture_count = options->texture_count;
    picture->request.channels = options->channels;
    picture->request.include = options->include;
    if (!loader_read(picture))
        return RUN_NOT_DONE;
    // A texture or a channel that the second shader does not have is ignored.
    if (number == 0 && !samplers_fit(&picture->parameters.samplers, &picture->source))
        return RUN_WRONG_COMMAND_LINE;
    for (int i = first; i < end; i++)
        if (!parameters_assign(&picture->parameters, options->settings[i]))
            return RUN_WRONG_COMMAND_LINE;
    return RUN_DONE;
}

// Check that the first shader has the tool's texture and parameter, and that the amounts of all
// strokes are in the parameter's range. Returns false after reporting the error.
static bool check_strokes(const struct run *run)
{
    const struct strokes *strokes = &run->options.strokes;
    const struct parameters *parameters = &run->picture[0].parameters;
    if (strokes->count == 0)
        return true;
    const struct parameter *amount = parameters_find(parameters, run->tool->amount);
    bool has = false;
    for (int i = 0; i < parameters->samplers.count; i++)
        has |= strcmp(parameters->samplers.item[i].name, run->tool->texture) == 0;
    if (!has || amount == NULL)
        return report("--stroke: %s lacks the sampler '%s' or the parameter '%s'", run->title,
                      run->tool->texture, run->tool->amount);
    for (int i = 0; i < strokes->count; i++)
        if (strokes->item[i].amount < amount->minimum || strokes->item[i].amount > amount->maximum)
            return report("--stroke %g,...: the amount must be between %g and %g",
                          strokes->item[i].amount, amount->minimum, amount->maximum);
    return true;
}

int run_read_shaders(struct run *run)
{
    struct options *options = &run->options;
    const char *other = options->compare;
    int status = read_shader(run, 0, run->shader);
    if (status == RUN_DONE && !check_strokes(run))
        status = RUN_WRONG_COMMAND_LINE;
    if (status == RUN_DONE && options->compares)
        status = read_shader(run, 1, other != NULL ? other : run->shader);
    bool keeps = samplers_keep(&run->picture[0].parameters.samplers) ||
                 samplers_keep(&run->picture[1].parameters.samplers);
    if (options->fps == 0.0 && (keeps || options->has_frame || options->frames > 0))
        options->fps = keeps ? PASSES_RATE : OPTIONS_FPS;
    return status;
}

static bool open_renderer(struct run *run, int number, const struct gl *gl)
{
    struct renderer *renderer = &run->picture[number].renderer;
    return renderer->gl != NULL || renderer_open(renderer, gl, run->root);
}

bool run_begin(struct run *run, const struct gl *gl)
{
    shader_forget(gl);
    for (int i = 0; i < (run->options.compares ? 2 : 1); i++) {
        if (!open_renderer(run, i, gl))
            return false;
        run->picture[i].renderer.view = run->options.view;
        loader_begin(&run->picture[i]);
    }
    return true;
}

// Take the names of both pictures from --labels.
static void split_labels(struct run *run)
{
    const char *text = run->options.labels;
    size_t left = strcspn(text, ",");
    snprintf(run->label[0], sizeof run->label[0], "%.*s", (int)left, text);
    snprintf(run->label[1], sizeof run->label[1], "%s", text + left + 1);
    for (int i = 0; i < 2; i++)
        run->comparison.label[i] = run->label[i];
}

bool run_compile(struct run *run, const struct gl *gl)
{
    const struct options *options = &run->options;
    struct renderer *first = &run->picture[0].renderer;
    int pictures = options->compares ? 2 : 1;
    for (int i = 0; i < pictures; i++)
        if (!open_renderer(run, i, gl) || !loader_link(&run->picture[i], options->view))
            return false;
    for (int i = 0; i < pictures; i++) {
        struct renderer *renderer = &run->picture[i].renderer;
        loader_take(&run->picture[i]);
        renderer->comparison = NULL;
        renderer->sculpture.tool = run->tool;
        renderer->view = options->view;
    }
    if (!options->compares)
        return true;
    run->comparison =
        (struct comparison){.other = &run->picture[1].renderer,
                            .divider = options->divider,
                            .own = options->settings + options->shared_settings,
                            .own_count = options->setting_count - options->shared_settings,
                            .gripped = options->window};
    if (options->labels != NULL)
        split_labels(run);
    else if (options->compare != NULL)
        for (int i = 0; i < 2; i++)
            run->comparison.label[i] = name_of(run->picture[i].path);
    first->comparison = &run->comparison;
    comparison_follow(first);
    return true;
}

struct window_start run_window_start(struct run *run)
{
    const struct options *options = &run->options;
    struct window_start start = options->start;
    start.title = run->title;
    start.stem = run->stem;
    start.picture = run->picture;
    start.pictures = options->compares ? 2 : 1;
    start.camera = options->camera;
    start.time = options->time;
    start.frame = options->has_frame ? options->frame : -1;
    start.rate = options->fps;
    start.samples = options->samples;
    start.strokes = &run->options.strokes;
    start.overlay_scale = options->overlay;
    start.overlay_kept = options->has_overlay;
    start.shown = options->step + 1;
    return start;
}

// Check that a picture would not overwrite a file of a shader, including its textures. Returns
// false after reporting the error.
static bool check_source(const struct shader_source *source, const char *path)
{
    struct platform_file target, read;
    for (int i = 0; i < source->file_count && platform_look(path, &target); i++)
        if (platform_look(source->paths[i], &read) && platform_is_same(&read, &target))
            return report("--output '%s': is %s, which this run reads: choose another name", path,
                          source->files[i]);
    return true;
}

// Check that a picture would not overwrite a file of either shader, or the vertex shader.
static bool check_unread(const struct run *run, const char *path)
{
    char vertex[PLATFORM_PATH + 32];
    char *files[] = {vertex};
    const struct shader_source own = {.paths = files, .files = files, .file_count = 1};
    snprintf(vertex, sizeof vertex, "%s/shaders/screen.vert", run->root);
    return check_source(&own, path) && check_source(&run->picture[0].source, path) &&
           check_source(&run->picture[1].source, path);
}

bool run_check_targets(const struct run *run)
{
    const struct options *options = &run->options;
    char path[PLATFORM_PATH];
    if (options->frames == 0)
        return options->output == NULL ||
               (image_check_target(options->output) && check_unread(run, options->output));
    for (int i = options->first_frame; i < options->frames; i++)
        if (!sequence_path(options->output, i, path, sizeof path) || !image_check_target(path) ||
            !check_unread(run, path))
            return false;
    return true;
}

int run_end(int status, bool window)
{
    errno = 0;
    if (fflush(stdout) == 0 && !ferror(stdout))
        return status;
    bool closed = errno == EBADF, left = !closed && platform_reader_left();
    if (closed)
        report("standard output: is closed: leave out >&-");
    else if (!left) // a reader that has closed the pipe needs no message
        report("standard output: cannot be written: is the disk full?");
    return left && window ? status : RUN_NOT_DONE;
}
