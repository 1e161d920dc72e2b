#include "shader/shader.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "context/guard.h"
#include "shader/form.h"
#include "report.h"

static const char *const view_names[SHADER_VIEW_COUNT] = {"picture", "normals", "depth", "steps",
                                                          "slice"};

const char *shader_view_name(enum shader_view view)
{
    return view < SHADER_VIEW_COUNT ? view_names[view] : view == SHADER_PROBE ? "probe" : "count";
}

bool shader_view_from_name(const char *name, enum shader_view *view)
{
    for (int i = 0; i < SHADER_VIEW_COUNT; i++)
        if (strcmp(name, view_names[i]) == 0) {
            *view = (enum shader_view)i;
            return true;
        }
    return false;
}

bool shader_has_view(const struct shader_source *source, enum shader_view view)
{
    if (view == SHADER_PICTURE || source->form == SHADER_COURSE)
        return true;
    report("%s: cannot show %s%s: it has a main of its own, which records nothing of its rays: "
           "the chapters from 01 on have all views",
           source->files[0], view == SHADER_PROBE ? "a probe" : "the view ",
           view == SHADER_PROBE ? "" : shader_view_name(view));
    return false;
}

char *shader_text(const struct shader_source *source, enum shader_view view)
{
    char *prelude = form_prelude(source, view);
    char *body = prelude != NULL ? form_body(source) : NULL;
    size_t size = body != NULL ? strlen(prelude) + strlen(body) + 1 : 0;
    char *text = body != NULL ? malloc(size) : NULL;
    if (text != NULL)
        snprintf(text, size, "%s%s", prelude, body);
    else if (body != NULL)
        report("%s: not enough memory", source->files[0]);
    free(prelude);
    free(body);
    return text;
}

// Report why a step failed, in the author's files and lines.
//   step  "compile" or "link"
//   log   what the driver wrote; may be NULL or empty
static void report_failure(const struct shader_source *source, enum shader_view view,
                           const char *step, const char *log)
{
    if (log != NULL && form_refuses(source, log, strcmp(step, "link") == 0))
        return;
    char *errors = shader_explain(source, view, log != NULL ? log : "");
    if (errors == NULL)
        return;
    size_t size = strlen(source->files[0]) + strlen(errors) + 64;
    char *text = malloc(size);
    if (text == NULL || errors[0] == '\0')
        report("%s: does not %s: the driver does not say why: try another --backend",
               source->files[0], step);
    else {
        snprintf(text, size, "%s: does not %s:\n%s", source->files[0], step, errors);
        report_lines(text);
    }
    free(text);
    free(errors);
}

static GLuint compile(const struct gl *gl, GLenum stage, const struct shader_source *source,
                      enum shader_view view)
{
    char *text = shader_text(source, view);
    if (text == NULL)
        return 0;
    GLint compiled = GL_FALSE, size = 0;
    GLuint shader = gl->CreateShader(stage);
    gl->ShaderSource(shader, 1, (const GLchar *const *)&text, NULL);
    gl->CompileShader(shader);
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    free(text);
    if (shader != 0 && compiled == GL_TRUE)
        return shader;
    gl->GetShaderiv(shader, GL_INFO_LOG_LENGTH, &size);
    char *log = size > 0 ? calloc((size_t)size + 1, 1) : NULL;
    if (log != NULL)
        gl->GetShaderInfoLog(shader, size, NULL, log);
    report_failure(source, view, "compile", log);
    free(log);
    gl->DeleteShader(shader);
    return 0;
}

static GLuint link_stages(const struct gl *gl, GLuint vertex, GLuint fragment,
                          const struct shader_source *source, enum shader_view view)
{
    GLint linked = GL_FALSE, size = 0;
    GLuint program = gl->CreateProgram();
    gl->AttachShader(program, vertex);
    gl->AttachShader(program, fragment);
    gl->LinkProgram(program);
    gl->GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (program != 0 && linked == GL_TRUE)
        return program;
    gl->GetProgramiv(program, GL_INFO_LOG_LENGTH, &size);
    char *log = size > 0 ? calloc((size_t)size + 1, 1) : NULL;
    if (log != NULL)
        gl->GetProgramInfoLog(program, size, NULL, log);
    report_failure(source, view, "link", log);
    free(log);
    gl->DeleteProgram(program);
    return 0;
}

// ---- A program ----

GLuint shader_link(const struct gl *gl, const struct shader_source *vertex,
                   const struct shader_source *fragment, enum shader_view view)
{
    GLuint program = 0, fragment_stage = 0;
    // A compiler that calls itself for each term of a sum runs out of stack on a long one.
    guard_begin("%.800s: the graphics driver crashed over it: split its longest statement",
                fragment->files[0]);
    GLuint vertex_stage = compile(gl, GL_VERTEX_SHADER, vertex, view);
    if (vertex_stage != 0)
        fragment_stage = compile(gl, GL_FRAGMENT_SHADER, fragment, view);
    if (fragment_stage != 0)
        program = link_stages(gl, vertex_stage, fragment_stage, fragment, view);
    guard_end();
    // A shader that is attached lives on until its program goes.
    if (vertex_stage != 0)
        gl->DeleteShader(vertex_stage);
    if (fragment_stage != 0)
        gl->DeleteShader(fragment_stage);
    if (program != 0 && !form_accepts(fragment)) {
        gl->DeleteProgram(program);
        program = 0;
    }
    // What is known to the user by now must not be found again as an error of the next call.
    while (program == 0 && gl->GetError() != GL_NO_ERROR)
        continue;
    return program;
}
