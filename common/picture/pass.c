#include "picture/pass.h"

const char *const pass_lens[PASS_LENSES] = {"focalLength", "orthographic"};

static bool reads(const struct renderer *renderer, const struct shader_source *source,
                  GLuint program, const char *name)
{
    return source->form == SHADER_COURSE && program != 0 &&
           renderer->gl->GetUniformLocation(program, name) >= 0;
}

bool pass_link(struct renderer *renderer, const struct shader_source *source, enum shader_view view,
               GLuint program[SHADER_PROGRAM_COUNT])
{
    if (!shader_has_view(source, view))
        return false;
    if (program[view] == 0)
        program[view] = shader_link(renderer->gl, &renderer->vertex, source, view);
    if (program[view] == 0)
        return false;
    return (!form_shows_ray(view) || pass_link(renderer, source, SHADER_PROBE, program)) &&
           (!reads(renderer, source, program[view], "iCoarse") ||
            pass_link(renderer, source, SHADER_COARSE, program));
}

bool pass_reads(const struct renderer *renderer, enum shader_view view, const char *name)
{
    return reads(renderer, &renderer->fragment, renderer->program[view], name);
}

GLint pass_location(const struct renderer *renderer, const char *name)
{
    return renderer->gl->GetUniformLocation(renderer->used, name);
}

static void set_vector(const struct renderer *renderer, const char *name, const float v[3])
{
    renderer->gl->Uniform3f(pass_location(renderer, name), v[0], v[1], v[2]);
}

static void set_parameter(const struct renderer *renderer, const struct parameter *parameter)
{
    const struct gl *gl = renderer->gl;
    GLint at = pass_location(renderer, parameter->name);
    float v[4] = {(float)parameter->value[0], (float)parameter->value[1],
                  (float)parameter->value[2], (float)parameter->value[3]};
    if (parameter->type != PARAMETER_FLOAT)
        gl->Uniform1i(at, (GLint)parameter->value[0]);
    else if (parameter->components == 1)
        gl->Uniform1f(at, v[0]);
    else if (parameter->components == 2)
        gl->Uniform2f(at, v[0], v[1]);
    else if (parameter->components == 3)
        gl->Uniform3f(at, v[0], v[1], v[2]);
    else
        gl->Uniform4f(at, v[0], v[1], v[2], v[3]);
}

// Another value for one that has a parameter, or that a shader has without one.
static void set_lens(const struct renderer *renderer, const char *name, double value)
{
    const struct parameter *own = parameters_find(&renderer->parameters, name);
    if (own == NULL) {
        renderer->gl->Uniform1f(pass_location(renderer, name), (float)value);
        return;
    }
    struct parameter other = *own;
    other.value[0] = value;
    set_parameter(renderer, &other);
}

void pass_use(struct renderer *renderer, const struct renderer_inputs *inputs,
              enum shader_view view)
{
    const struct gl *gl = renderer->gl;
    renderer->used = renderer->program[view];
    struct camera_basis basis = camera_basis_of(&inputs->camera);
    gl->UseProgram(renderer->used);
    gl->Uniform3f(pass_location(renderer, "iResolution"), (float)inputs->width,
                  (float)inputs->height, 1.0f);
    gl->Uniform1f(pass_location(renderer, "iTime"), (float)inputs->time);
    gl->Uniform1f(pass_location(renderer, "iTimeDelta"), (float)inputs->time_delta);
    gl->Uniform1i(pass_location(renderer, "iFrame"), inputs->frame);
    gl->Uniform4f(pass_location(renderer, "iMouse"), inputs->mouse[0], inputs->mouse[1],
                  inputs->mouse[2], inputs->mouse[3]);
    gl->Uniform1f(pass_location(renderer, "iFrameRate"),
                  inputs->time_delta > 0.0 ? (float)(1.0 / inputs->time_delta) : 60.0f);
    gl->Uniform4f(pass_location(renderer, "iDate"), inputs->date[0], inputs->date[1],
                  inputs->date[2], inputs->date[3]);
    set_vector(renderer, "iCameraPosition", inputs->camera.position);
    set_vector(renderer, "iCameraRight", basis.right);
    set_vector(renderer, "iCameraUp", basis.up);
    set_vector(renderer, "iCameraForward", basis.forward);
    gl->Uniform1f(pass_location(renderer, "focalLength"), renderer->focal_length);
    gl->Uniform1f(pass_location(renderer, "iOrthoView"), (float)renderer->orthographic);
    for (int i = 0; i < renderer->parameters.count; i++)
        set_parameter(renderer, &renderer->parameters.item[i]);
    for (int i = 0; i < PASS_LENSES && inputs->lens != NULL; i++)
        set_lens(renderer, pass_lens[i], inputs->lens[i]);
    textures_bind(&renderer->textures, gl, renderer->used);
    gl->BindVertexArray(renderer->vertex_array);
}

void pass_clear(const struct gl *gl)
{
    gl->ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    gl->Clear(GL_COLOR_BUFFER_BIT);
}

// Each of several samples adds its share to what is there; one alone takes its place. That too is
// left to blending: llvmpipe compiles a program that may have to read the target once, any other
// twice, the second time for squares of pixels that the triangle covers whole.
static void blend(const struct gl *gl, int samples)
{
    float share = 1.0f / (float)samples;
    gl->Enable(GL_BLEND);
    gl->BlendColor(share, share, share, share);
    gl->BlendFunc(samples > 1 ? GL_CONSTANT_COLOR : GL_ONE, samples > 1 ? GL_ONE : GL_ZERO);
}

void pass_draw(const struct renderer *renderer, const struct pass_sample *sample, int bottom)
{
    static const struct pass_sample only = {0, 1, {0.0f, 0.0f}};
    if (sample == NULL)
        sample = &only;
    const float *jitter = sample->jitter;
    const float offset[2] = {jitter[0], (float)bottom + jitter[1]};
    renderer->gl->Uniform1i(pass_location(renderer, "iSample"), sample->number);
    renderer->gl->Uniform1i(pass_location(renderer, "iSamples"), sample->count);
    renderer->gl->Uniform2f(pass_location(renderer, "iPixelOffset"), offset[0], offset[1]);
    // What is not in the program is ignored: this is its name in Shadertoy's form.
    renderer->gl->Uniform2f(pass_location(renderer, "harnessPixelOffset"), offset[0], offset[1]);
    renderer->gl->Uniform2f(pass_location(renderer, "iPixelJitter"), jitter[0], jitter[1]);
    blend(renderer->gl, sample->count);
    renderer->gl->DrawArrays(GL_TRIANGLES, 0, 3);
    renderer->gl->Disable(GL_BLEND);
}
