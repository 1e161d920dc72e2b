#include "picture/room.h"

#include "shader/compile.h"

// True if the shader is in the course's dialect and defines cameraRoom.
static bool has_room(const struct renderer *renderer)
{
    return renderer->fragment.dialect == DIALECT_COURSE &&
           glsl_find_definition(&renderer->fragment.code, "cameraRoom") != NULL;
}

// Have the driver start compiling the program if it is not linked yet. Returns true while the
// driver is compiling the program in other threads.
static bool is_compiling(const struct renderer *renderer)
{
    if (renderer->program[VIEW_ROOM] != 0)
        return false;
    shader_begin(renderer->gl, &renderer->vertex, &renderer->fragment, VIEW_ROOM);
    return !shader_ready(renderer->gl);
}

bool room_keep(struct renderer *renderer, const struct renderer_inputs *inputs, float to[3])
{
    const struct gl *gl = renderer->gl;
    float by[4];
    if (!has_room(renderer) || is_compiling(renderer))
        return true;
    if (!renderer_link(renderer, VIEW_ROOM) || !target_bind(&renderer->single, gl, 1, 1))
        return false;
    renderer_use(renderer, inputs, VIEW_ROOM);
    gl->Uniform3fv(renderer->used[UNIFORM_iCameraTo], 1, to);
    renderer_clear(gl);
    renderer_fill(renderer, &renderer->single, 0, 0, 1, 1);
    target_read(&renderer->single, gl, by);
    for (int i = 0; i < 3; i++)
        to[i] += by[i];
    return true;
}
