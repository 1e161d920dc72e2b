#include "shader/compile.h"

#include <stdlib.h>
#include <string.h>

#include "context/guard.h"
#include "memory.h"
#include "report.h"
#include "shader/dialects.h"

char *shader_text(const struct shader_source *source, enum shader_view view)
{
    char *prelude = shader_prelude(source, view);
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
    if (log != NULL && dialects.explain != NULL && dialects.explain(source, log))
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

// ---- A program ----

// The vertex shader that computes the positions that a fragment shader reads. The caller frees its
// prelude and its body.
static struct shader_source vertex_for(const struct shader_source *vertex,
                                       const struct shader_source *fragment)
{
    struct shader_source stage = *vertex;
    char *before, *after;
    inputs_vertex(fragment, &before, &after);
    stage.prelude = memory_text("%s%s", GL_GLSL, before);
    stage.body = memory_text("%s%s", vertex->text, after);
    free(before);
    free(after);
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
    guard(gl, fragment);
    shader_begin_texts(gl, shader_text(&stage, view), shader_text(fragment, view));
    guard_end();
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
        char *floats = dialects.with_floats(second), *other;
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
    if (program != 0 && dialects.accept != NULL && !dialects.accept(fragment, gl, program)) {
        gl->DeleteProgram(program);
        program = 0;
    }
    // An error that has already been reported must not be blamed on the next call.
    while (program == 0 && gl->GetError() != GL_NO_ERROR)
        continue;
    return program;
}
