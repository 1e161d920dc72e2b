#include "picture/loader.h"

bool loader_read(struct loader *loader)
{
    shader_free(&loader->source);
    parameters_free(&loader->parameters);
    return shader_read_asked(&loader->source, loader->path, loader->root, &loader->request) &&
           parameters_read(&loader->parameters, &loader->source);
}

bool loader_compile(struct loader *loader)
{
    return renderer_load(&loader->renderer, &loader->source, &loader->parameters);
}

void loader_close(struct loader *loader)
{
    renderer_close(&loader->renderer);
    shader_free(&loader->source);
    parameters_free(&loader->parameters);
}
