#include "command/run.h"

#include <string.h>

// The chapter's title, or the name of the file that runs in place of its shader.
static const char *title_of(const struct options *options, const char *title)
{
    if (options->shader == NULL)
        return title;
    const char *slash = strrchr(options->shader, '/');
    return slash != NULL ? slash + 1 : options->shader;
}

bool run_parse(struct run *run, const char *stem, const char *title, const struct camera *camera,
               int argc, char **argv)
{
    if (!options_parse(&run->options, argc, argv))
        return false;
    if (!run->options.has_camera)
        run->options.camera = *camera;
    run->stem = stem;
    run->title = title_of(&run->options, title);
    return true;
}

void run_close(struct run *run)
{
    window_close(run->window);
    second_close(&run->second);
    renderer_close(&run->renderer);
    context_close(&run->context);
    shader_free(&run->source);
    parameters_free(&run->parameters);
    options_free(&run->options);
    *run = (struct run){0};
}
