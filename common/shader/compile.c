#include "shader/compile.h"

#include <stdlib.h>
#include <string.h>

#include "context/guard.h"
#include "memory.h"
#include "report.h"
#include "shader/translate.h"

char *shader_text(const struct shader_source *source, enum shader_view view)
{
    char *prelude = dialect_prelude(source, view);
    char *text = memory_text("%s%s", prelude, source->body != NULL ? source->body : source->text);
    free(prelude);
    return text;
}

// Report why a step failed, with the author's files and lines.
//   step  "compile" or "link"
//   log   the driver's log; may be NULL or empty
static void report_failure(const struct shader_source *source, enum shader_view view,
                           const char *step, const char *log)
{
    if (log != NULL && dialect_refuses(source, log, strcmp(step, "link") == 0))
        return;
    char *errors = shader_explain(source, view, log != NULL ? log : "");
    char *text = memory_text("%s: does not %s:\n%s", source->files[0], step, errors);
    if (errors[0] != '\0')
        report_lines(text);
    else
        report("%s: does not %s: the driver does not say why: try another --backend",
               source->files[0], step);
    free(text);
    free(errors);
}

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

// ---- A program ----

// The vertex shader that computes the positions that a fragment shader reads. The caller frees its
// prelude and its body.
static struct shader_source vertex_for(const struct shader_source *vertex,
                                       const struct shader_source *fragment)
{
    struct shader_source stage = *vertex;
    char *before, *behind;
    inputs_vertex(fragment, &before, &behind);
    stage.prelude = memory_text("%s%s", GL_GLSL, before);
    stage.body = memory_text("%s%s", vertex->text, behind);
    free(before);
    free(behind);
    return stage;
}

// Prepare a message in case the driver crashes: a recursive compiler runs out of stack on a long
// sum.
static void guard(const struct gl *gl, const struct shader_source *fragment)
{
    guard_begin("%.800s: the graphics driver crashed on it, or needs more than 4 GB for it: "
                "split its longest statement, or shorten its arrays and macros",
                fragment->files[0]);
    const char *version = (const char *)gl->GetString(GL_VERSION);
    if (version != NULL && strstr(version, "Mesa") != NULL)
        guard_memory();
}

void shader_begin(const struct gl *gl, const struct shader_source *vertex,
                  const struct shader_source *fragment, enum shader_view view)
{
    struct shader_source stage = vertex_for(vertex, fragment);
    struct begun one = {.text = {shader_text(&stage, view), shader_text(fragment, view)}};
    struct begun *free_one = list;
    while (free_one < list + LIST && free_one->program != 0)
        free_one++;
    if (free_one < list + LIST && find(one.text[0], one.text[1]) == NULL) {
        guard(gl, fragment);
        begin(gl, &one, one.text[0], one.text[1]);
        guard_end();
        *free_one = one;
    } else
        leave(gl, &one);
    free(stage.prelude);
    free(stage.body);
}

GLuint shader_link(const struct gl *gl, const struct shader_source *vertex,
                   struct shader_source *fragment, enum shader_view view)
{
    struct shader_source stage = vertex_for(vertex, fragment);
    char *first = shader_text(&stage, view), *second = shader_text(fragment, view), *log;
    enum shader_step step;
    guard(gl, fragment);
    GLuint program = shader_link_texts(gl, first, second, &step, &log);
    if (GL_IS_ES && program == 0 && step == SHADER_COMPILE_FRAGMENT && fragment->body != NULL) {
        // Desktop GLSL accepts integers as floats. If both texts fail, the error in the author's
        // text is reported.
        char *floats = translate_floats(second), *other;
        program = shader_link_texts(gl, first, floats, &step, &other);
        free(floats);
        free(other);
    }
    guard_end();
    if (program == 0)
        report_failure(step == SHADER_COMPILE_VERTEX ? &stage : fragment, view,
                       step == SHADER_LINK ? "link" : "compile", log);
    free(stage.prelude);
    free(stage.body);
    free(first);
    free(second);
    free(log);
    if (program != 0 && !dialect_accepts(fragment)) {
        gl->DeleteProgram(program);
        program = 0;
    }
    // An error that has already been reported must not be blamed on the next call.
    while (program == 0 && gl->GetError() != GL_NO_ERROR)
        continue;
    return program;
}
