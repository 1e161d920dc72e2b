#include "picture/loader.h"

#include <string.h>

bool loader_read(struct loader *loader)
{
    shader_free(&loader->source);
    parameters_free(&loader->parameters);
    return shader_read_asked(&loader->source, loader->path, loader->root, &loader->request) &&
           parameters_read(&loader->parameters, &loader->source);
}

void loader_begin(const struct loader *loader)
{
    const struct renderer *renderer = &loader->renderer;
    shader_begin(renderer->gl, &renderer->vertex, &loader->source, renderer->view);
    if (glsl_mentions(&loader->source.code, "coarseStart") > 0)
        shader_begin(renderer->gl, &renderer->vertex, &loader->source, VIEW_COARSE);
}

bool loader_compile(struct loader *loader)
{
    return renderer_load(&loader->renderer, &loader->source, &loader->parameters);
}

bool loader_link(struct loader *loader, enum shader_view view)
{
    struct renderer *renderer = &loader->renderer;
    const char *has = renderer->fragment.text;
    renderer_drop(&loader->next);
    if (has != NULL && strcmp(has, loader->source.text) == 0)
        return renderer_link(renderer, view);
    return renderer_prepare(renderer, &loader->next, view, &loader->source, &loader->parameters);
}

void loader_take(struct loader *loader)
{
    struct renderer *renderer = &loader->renderer;
    if (loader->next.gl != NULL) {
        renderer_take(renderer, &loader->next);
        return;
    }
    parameters_free(&renderer->parameters);
    renderer->parameters = loader->parameters;
    loader->parameters = (struct parameters){0};
    shader_free(&loader->source);
}

void loader_close(struct loader *loader)
{
    renderer_drop(&loader->next);
    renderer_close(&loader->renderer);
    shader_free(&loader->source);
    parameters_free(&loader->parameters);
}
