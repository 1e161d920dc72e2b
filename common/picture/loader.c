#include "picture/loader.h"

#include <stdio.h>
#include <string.h>

#include "report.h"

bool loader_read(struct loader *loader)
{
    shader_free(&loader->source);
    parameters_free(&loader->parameters);
    return shader_read_asked(&loader->source, loader->path, loader->root, &loader->request) &&
           parameters_read(&loader->parameters, &loader->source);
}

bool loader_open(struct loader *loader, const char *path)
{
    struct loader_other *other = &loader->other;
    if (strlen(path) >= sizeof other->path)
        return report("%.40s...: the path is too long", path);
    snprintf(other->path, sizeof other->path, "%s", path);
    loader->path = other->path;
    loader->request.textures = NULL;
    loader->request.texture_count = 0;
    loader->request.channels = NULL;
    return true;
}

// The channel that gets the next picture: the first one that has none, or else the first that the
// shader reads; -1 if it reads none.
static int next_channel(const struct loader *loader)
{
    const struct shader_source *source = &loader->renderer.fragment;
    const char *const *given = loader->request.channels;
    int channel = -1;
    for (int i = source->sampler_count - 1; i >= 0; i--) {
        int at = source->samplers[i].channel;
        if (at >= 0 && (channel < 0 || given == NULL || given[at] == NULL ||
                        (given[channel] != NULL && at < channel)))
            channel = at;
    }
    return channel;
}

bool loader_give(struct loader *loader, const char *path)
{
    struct loader_other *other = &loader->other;
    struct shader_request *request = &loader->request;
    const struct samplers *samplers = &loader->renderer.parameters.samplers;
    bool course = loader->renderer.fragment.dialect == DIALECT_COURSE;
    int first = 0, channel = course ? 0 : next_channel(loader);
    while (course && first < samplers->count &&
           (samplers->item[first].slices > 0 || samplers->item[first].pass > 0))
        first++;
    if (course ? first == samplers->count : channel < 0)
        return report("%s: the shader reads no picture", path);
    char *picture = other->picture[channel];
    int length = snprintf(picture, sizeof *other->picture, "%s%s%s",
                          course ? samplers->item[first].name : "", course ? "=" : "", path);
    if (length >= (int)sizeof *other->picture)
        return report("%.40s...: the path is too long", path);
    if (course) {
        other->textures[0] = picture;
        request->textures = other->textures;
        request->texture_count = 1;
        return true;
    }
    for (int i = 0; i < 4; i++)
        other->channels[i] = request->channels != NULL ? request->channels[i] : NULL;
    other->channels[channel] = picture;
    request->channels = other->channels;
    return true;
}

void loader_begin(const struct loader *loader)
{
    const struct renderer *renderer = &loader->renderer;
    shader_begin(renderer->gl, &renderer->vertex, &loader->source, renderer->view);
    if (glsl_mentions(&loader->source.code, "coarseStart") > 0)
        shader_begin(renderer->gl, &renderer->vertex, &loader->source, VIEW_COARSE);
    if (loader->source.dialect == DIALECT_COURSE && samplers_keep(&loader->parameters.samplers))
        shader_begin(renderer->gl, &renderer->vertex, &loader->source, VIEW_KEPT);
    for (int i = 0; i < loader->source.pass_count; i++)
        shader_begin(renderer->gl, &renderer->vertex, &loader->source.pass[i], VIEW_PICTURE);
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
    if (has != NULL && strcmp(has, loader->source.text) == 0 && loader->source.pass_count == 0)
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
