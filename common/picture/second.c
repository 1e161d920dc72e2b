#include "picture/second.h"

#include <stdio.h>
#include <string.h>

#include "report.h"

static const char *name_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

bool second_read(struct second *second, const struct second_request *request, const char *shader,
                 const char *root)
{
    const char *path = request->file != NULL ? request->file : shader;
    second->pair = (struct pair){.other = &second->renderer,
                                 .divider = request->divider,
                                 .own = request->own,
                                 .own_count = request->own_count,
                                 .gripped = request->gripped};
    if (request->file != NULL) {
        second->pair.label[0] = name_of(shader);
        second->pair.label[1] = name_of(path);
    }
    int length = snprintf(second->shader, sizeof second->shader, "%s", path);
    if (length >= (int)sizeof second->shader)
        return report("%.40s...: the path of the shader is too long", path);
    return shader_read_asked(&second->source, second->shader, root, request->reading) &&
           parameters_read(&second->parameters, &second->source);
}

bool second_assign(struct second *second)
{
    for (int i = 0; i < second->pair.own_count; i++)
        if (!parameters_assign(&second->parameters, second->pair.own[i]))
            return false;
    return true;
}

bool second_load(struct second *second, struct renderer *first)
{
    if (second->shader[0] == '\0')
        return true;
    if (!renderer_open(&second->renderer, first->gl, first->root))
        return false;
    second->renderer.view = first->view;
    if (!renderer_load(&second->renderer, &second->source, &second->parameters))
        return false;
    first->pair = &second->pair;
    return true;
}

void second_close(struct second *second)
{
    renderer_close(&second->renderer);
    shader_free(&second->source);
    parameters_free(&second->parameters);
    *second = (struct second){0};
}
