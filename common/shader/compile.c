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

// Report why a step failed, in the author's files and lines.
//   step  "compile" or "link"
//   log   what the driver wrote; may be NULL or empty
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

// ---- Two stages ----

// The driver's log; NULL if it wrote nothing.
static char *read_log(void (*get)(GLuint object, GLsizei size, GLsizei *length, GLchar *log),
                      GLuint object, GLint size)
{
    char *log = size > 0 ? memory_zeros((size_t)size + 1, 1) : NULL;
    if (log != NULL)
        get(object, size, NULL, log);
    return log;
}

static GLuint compile(const struct gl *gl, GLenum stage, const char *text, char **log)
{
    GLint compiled = GL_FALSE, size = 0;
    GLuint shader = gl->CreateShader(stage);
    gl->ShaderSource(shader, 1, &text, NULL);
    gl->CompileShader(shader);
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (shader != 0 && compiled == GL_TRUE)
        return shader;
    gl->GetShaderiv(shader, GL_INFO_LOG_LENGTH, &size);
    *log = read_log(gl->GetShaderInfoLog, shader, size);
    gl->DeleteShader(shader);
    return 0;
}

static GLuint link_stages(const struct gl *gl, const GLuint stage[2], char **log)
{
    GLint linked = GL_FALSE, size = 0;
    GLuint program = gl->CreateProgram();
    gl->AttachShader(program, stage[0]);
    gl->AttachShader(program, stage[1]);
    gl->LinkProgram(program);
    gl->GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (program != 0 && linked == GL_TRUE)
        return program;
    gl->GetProgramiv(program, GL_INFO_LOG_LENGTH, &size);
    *log = read_log(gl->GetProgramInfoLog, program, size);
    gl->DeleteProgram(program);
    return 0;
}

GLuint shader_link_texts(const struct gl *gl, const char *vertex, const char *fragment,
                         enum shader_step *step, char **log)
{
    GLuint program = 0, stage[2] = {0, 0};
    *log = NULL;
    *step = SHADER_COMPILE_VERTEX;
    stage[0] = compile(gl, GL_VERTEX_SHADER, vertex, log);
    if (stage[0] != 0) {
        *step = SHADER_COMPILE_FRAGMENT;
        stage[1] = compile(gl, GL_FRAGMENT_SHADER, fragment, log);
    }
    if (stage[1] != 0) {
        *step = SHADER_LINK;
        program = link_stages(gl, stage, log);
    }
    // An attached shader lives until its program is deleted; 0 is ignored.
    gl->DeleteShader(stage[0]);
    gl->DeleteShader(stage[1]);
    return program;
}

// ---- A program ----

// The vertex shader that computes what a fragment shader reads. Free its prelude and its body.
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

GLuint shader_link(const struct gl *gl, const struct shader_source *vertex,
                   struct shader_source *fragment, enum shader_view view)
{
    struct shader_source stage = vertex_for(vertex, fragment);
    char *first = shader_text(&stage, view), *second = shader_text(fragment, view), *log;
    enum shader_step step;
    // A recursive compiler runs out of stack on a long sum.
    guard_begin("%.800s: the graphics driver crashed on it, or needs more than 4 GB for it: "
                "split its longest statement, shorten its arrays and macros",
                fragment->files[0]);
    const char *version = (const char *)gl->GetString(GL_VERSION);
    if (version != NULL && strstr(version, "Mesa") != NULL)
        guard_memory();
    GLuint program = shader_link_texts(gl, first, second, &step, &log);
    if (GL_IS_ES && program == 0 && step == SHADER_COMPILE_FRAGMENT && fragment->body != NULL) {
        // The desktop accepts integers as floats. Of two errors, the one in the author's text is
        // reported.
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
    // An error that is already reported must not be blamed on the next call.
    while (program == 0 && gl->GetError() != GL_NO_ERROR)
        continue;
    return program;
}
