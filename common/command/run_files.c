#include "command/run.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "report.h"
#include "sequence.h"

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
    return report("shaders/screen.vert: not found above this program's folder: give --root DIR");
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

// Read the shader of --compare; as run_read_shader.
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
        return RUN_NOT_DONE;
    return second_assign(&run->second) ? RUN_DONE : RUN_WRONG_COMMAND_LINE;
}

int run_read_shader(struct run *run)
{
    run->request.textures = run->options.textures;
    run->request.texture_count = run->options.texture_count;
    run->request.channels = run->options.channels;
    if (!shader_read_asked(&run->source, run->shader, run->root, &run->request) ||
        !parameters_read(&run->parameters, &run->source))
        return RUN_NOT_DONE;
    if (!samplers_fit(&run->parameters.samplers, &run->source))
        return RUN_WRONG_COMMAND_LINE;
    for (int i = 0; i < run->options.shared_settings; i++)
        if (!parameters_assign(&run->parameters, run->options.settings[i]))
            return RUN_WRONG_COMMAND_LINE;
    return run->options.compares ? read_second(run) : RUN_DONE;
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

bool run_check_targets(const struct run *run)
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
