#include "picture/aside.h"

#include <stdlib.h>
#include <string.h>

#include "memory.h"

struct renderer_eye aside_eye(const struct renderer *renderer, const struct renderer_inputs *inputs)
{
    struct renderer_eye eye = {.camera = inputs->camera, .lens = {0}};
    for (int i = 0; i < PASS_LENSES; i++) {
        const struct parameter *lens = parameters_find(&renderer->parameters, pass_lens[i]);
        eye.lens[i] = lens != NULL ? lens->value[0] : i == 0 ? (double)renderer->focal_length : 0.0;
    }
    return eye;
}

struct renderer_inputs aside_from_eye(const struct renderer_inputs *inputs)
{
    struct renderer_inputs from = *inputs;
    if (inputs->eye == NULL)
        return from;
    from.camera = inputs->eye->camera;
    from.lens = inputs->eye->lens;
    from.eye = NULL;
    return from;
}

bool aside_seen(const struct renderer *renderer, const struct renderer_inputs *inputs)
{
    if (inputs->eye == NULL)
        return false;
    struct renderer_eye here = aside_eye(renderer, inputs);
    const struct camera *a = &here.camera, *b = &inputs->eye->camera;
    bool same = a->pan == b->pan && a->tilt == b->tilt;
    for (int i = 0; i < 3; i++)
        same = same && a->position[i] == b->position[i];
    for (int i = 0; i < PASS_LENSES; i++)
        same = same && here.lens[i] == inputs->eye->lens[i];
    return !same;
}

static void find_places(struct renderer *renderer, const struct renderer_inputs *inputs,
                        struct probe *probe)
{
    const struct gl *gl = renderer->gl;
    float(*place)[4] = memory_zeros(PROBE_STEPS, sizeof *place);
    pass_use(renderer, inputs, SHADER_PLACES);
    gl->BindTexture(GL_TEXTURE_2D, renderer->table.texture);
    gl->Viewport(0, 0, PROBE_STEPS, 1);
    gl->Enable(GL_SCISSOR_TEST);
    gl->Scissor(0, 0, probe_rows(probe), 1);
    pass_clear(gl);
    pass_draw(renderer, NULL, 0);
    gl->Disable(GL_SCISSOR_TEST);
    target_read(&renderer->places, gl, place[0]);
    for (int k = 0; k < probe_rows(probe); k++) {
        memcpy(probe->step[k].place, place[k], sizeof probe->step[k].place);
        probe->step[k].seen = place[k][2] > 0.5f;
    }
    free(place);
}

bool aside_places(struct renderer *renderer, const struct renderer_inputs *inputs, int x, int y,
                  struct probe *probe)
{
    probe->aside = aside_seen(renderer, inputs);
    for (int k = 0; k < probe_rows(probe); k++) {
        probe->step[k].place[0] = (float)x + 0.5f;
        probe->step[k].place[1] = (float)y + 0.5f;
        probe->step[k].seen = true;
    }
    if (!probe->aside || probe_rows(probe) == 0)
        return true;
    if (!pass_link(renderer, &renderer->fragment, SHADER_PLACES, renderer->program) ||
        !target_bind(&renderer->places, renderer->gl, PROBE_STEPS, 1))
        return false;
    find_places(renderer, inputs, probe);
    return true;
}
