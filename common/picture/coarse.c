#include "picture/coarse.h"

static int blocks(int pixels)
{
    return (pixels + COARSE_BLOCK - 1) / COARSE_BLOCK;
}

bool coarse_wanted(const struct renderer *renderer, enum shader_view view)
{
    const struct parameter *parameter = parameters_find(&renderer->parameters, "coarsePass");
    return pass_reads(renderer, view, "iCoarse") &&
           (parameter == NULL || parameter->value[0] > 0.5);
}

bool coarse_run(struct renderer *renderer, const struct renderer_inputs *inputs,
                enum shader_view view, const int low[2], const int high[2])
{
    const struct gl *gl = renderer->gl;
    int width = blocks(inputs->width), height = blocks(inputs->height);
    int left = low[0] / COARSE_BLOCK, bottom = low[1] / COARSE_BLOCK;
    if (!coarse_wanted(renderer, view))
        return true;
    if (!target_bind(&renderer->coarse, gl, width, height))
        return false;
    pass_use(renderer, inputs, SHADER_COARSE);
    gl->Viewport(0, 0, width, height);
    pass_clear(gl);
    gl->Enable(GL_SCISSOR_TEST);
    gl->Scissor(left, bottom, blocks(high[0]) - left, blocks(high[1]) - bottom);
    pass_draw(renderer, NULL, 0);
    gl->Disable(GL_SCISSOR_TEST);
    return true;
}

void coarse_bind(const struct renderer *renderer, enum shader_view view)
{
    // The texture of unit 0, which a sampler reads unless told otherwise.
    if (coarse_wanted(renderer, view))
        renderer->gl->BindTexture(GL_TEXTURE_2D, renderer->coarse.texture);
}
