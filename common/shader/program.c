#include "shader/program.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"

// ---- The two stages ----

// The driver's log; NULL if the driver wrote nothing.
static char *read_log(void (*get)(GLuint object, GLsizei size, GLsizei *length, GLchar *log),
                      GLuint object, GLint size)
{
    char *log = size > 0 ? memory_zeros((size_t)size + 1, 1) : NULL;
    if (log != NULL)
        get(object, size, NULL, log);
    return log;
}

static GLuint compile(const struct gl *gl, GLenum stage, const char *text)
{
    GLuint shader = gl->CreateShader(stage);
    gl->ShaderSource(shader, 1, &text, NULL);
    gl->CompileShader(shader);
    return shader;
}

// A program whose compilation has begun. The result is not queried at once, because the query would
// wait for the driver.
struct begun {
    char *text[2];            // texts of the stages, owned; NULL if the caller owns them
    GLuint stage[2], program; // 0 before they are begun
};

static void begin(const struct gl *gl, struct begun *one, const char *vertex, const char *fragment)
{
    one->stage[0] = compile(gl, GL_VERTEX_SHADER, vertex);
    one->stage[1] = compile(gl, GL_FRAGMENT_SHADER, fragment);
    one->program = gl->CreateProgram();
    gl->AttachShader(one->program, one->stage[0]);
    gl->AttachShader(one->program, one->stage[1]);
    gl->LinkProgram(one->program);
}

// The first step that failed, or SHADER_LINK if both stages compiled.
static enum shader_step step_of(const struct gl *gl, const struct begun *one)
{
    for (int i = 0; i < 2; i++) {
        GLint compiled = GL_FALSE;
        gl->GetShaderiv(one->stage[i], GL_COMPILE_STATUS, &compiled);
        if (compiled != GL_TRUE)
            return i == 0 ? SHADER_COMPILE_VERTEX : SHADER_COMPILE_FRAGMENT;
    }
    return SHADER_LINK;
}

// Free everything except the program.
static void leave(const struct gl *gl, struct begun *one)
{
    // An attached shader lives until its program is deleted; DeleteShader ignores 0.
    gl->DeleteShader(one->stage[0]);
    gl->DeleteShader(one->stage[1]);
    free(one->text[0]);
    free(one->text[1]);
    *one = (struct begun){.program = 0};
}

// Wait for a program, and return what shader_link_texts returns.
static GLuint end(const struct gl *gl, struct begun *one, enum shader_step *step, char **log)
{
    GLuint program = one->program;
    GLint linked = GL_FALSE, size = 0;
    *log = NULL;
    *step = SHADER_LINK;
    gl->GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (program == 0 || linked != GL_TRUE) {
        *step = step_of(gl, one);
        if (*step == SHADER_LINK) {
            gl->GetProgramiv(program, GL_INFO_LOG_LENGTH, &size);
            *log = read_log(gl->GetProgramInfoLog, program, size);
        } else {
            GLuint stage = one->stage[*step == SHADER_COMPILE_FRAGMENT];
            gl->GetShaderiv(stage, GL_INFO_LOG_LENGTH, &size);
            *log = read_log(gl->GetShaderInfoLog, stage, size);
        }
        gl->DeleteProgram(program);
        program = 0;
    }
    leave(gl, one);
    return program;
}

// ---- Programs that were begun ----

// Room for two pictures, each with its coarse pass.
static struct begun list[4];
enum { LIST = sizeof list / sizeof *list };

// The program that was begun with these texts, or NULL if there is none.
static struct begun *find(const char *vertex, const char *fragment)
{
    for (int i = 0; i < LIST; i++)
        if (list[i].program != 0 && strcmp(list[i].text[0], vertex) == 0 &&
            strcmp(list[i].text[1], fragment) == 0)
            return &list[i];
    return NULL;
}

bool shader_ready(const struct gl *gl)
{
    for (int i = 0; i < LIST; i++) {
        // The value stays GL_TRUE, with an OpenGL error, if the driver lacks the extension.
        GLint done = GL_TRUE;
        if (list[i].program == 0)
            continue;
        gl->GetProgramiv(list[i].program, GL_COMPLETION_STATUS_KHR, &done);
        gl->GetError();
        if (done != GL_TRUE)
            return false;
    }
    return true;
}

void shader_forget(const struct gl *gl)
{
    for (int i = 0; i < LIST; i++)
        if (list[i].program != 0) {
            gl->DeleteProgram(list[i].program);
            leave(gl, &list[i]);
        }
}

GLuint shader_link_texts(const struct gl *gl, const char *vertex, const char *fragment,
                         enum shader_step *step, char **log)
{
    struct begun *begun = find(vertex, fragment), one = {.program = 0};
    if (begun == NULL)
        begin(gl, begun = &one, vertex, fragment);
    return end(gl, begun, step, log);
}

void shader_begin_texts(const struct gl *gl, char *vertex, char *fragment)
{
    struct begun one = {.text = {vertex, fragment}};
    struct begun *free_one = list;
    while (free_one < list + LIST && free_one->program != 0)
        free_one++;
    if (free_one < list + LIST && find(vertex, fragment) == NULL) {
        begin(gl, &one, vertex, fragment);
        *free_one = one;
    } else
        leave(gl, &one);
}
