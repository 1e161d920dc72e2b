#include "shader/dialects.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dialects/directives.h"
#include "dialects/export.h"
#include "dialects/formats.h"
#include "dialects/tool_inputs.h"
#include "dialects/translate.h"
#include "dialects/unpack.h"
#include "memory.h"
#include "report.h"

// ---- Shadertoy's function ----

static bool refuse_image(const struct shader_source *source, const struct glsl_token *image)
{
    return shader_refuse(source, image->line,
                         "mainImage has parameters other than those it is called with: write void "
                         "mainImage(out vec4 fragColor, in vec2 fragCoord)");
}

// Check that mainImage returns its colour in an out parameter, and that the text does not mention
// gl_FragColor.
static bool check_image(const struct shader_source *source)
{
    const struct glsl *code = &source->code;
    const struct glsl_token *image = glsl_find_definition(code, "mainImage");
    const struct glsl_token *old = glsl_find(code, "gl_FragColor");
    if (image == NULL || !image->certain || image[2].macro)
        return true;
    if (!glsl_is_any(image + 2, (const char *const[]){"out", "inout", NULL}))
        return refuse_image(source, image);
    const struct glsl_token *colour = glsl_skip(code, image + 2, ",)") - 1;
    return old == NULL || !old->certain ||
           shader_refuse(source, old->line,
                         "gl_FragColor: mainImage returns its colour in %s: write %s = ...",
                         colour->text, colour->text);
}

// ---- The dialect ----

// Determine the dialect. A file that has a main without the course's main.glsl, perhaps in a macro,
// is a whole shader, whatever else it includes, unless it is the course's vertex shader.
static enum shader_dialect dialect_of(const struct shader_source *source)
{
    const struct glsl *code = &source->code;
    if (glsl_find(code, "mainImage") != NULL && glsl_find_definition(code, "main") == NULL)
        return DIALECT_SHADERTOY;
    bool whole = glsl_find(code, "main") != NULL && glsl_mentions(code, "gl_Position") == 0 &&
                 !shader_includes(source, "shaders/main.glsl");
    return source->version != 0 || whole ? DIALECT_WHOLE : DIALECT_COURSE;
}

static bool take(struct shader_source *source)
{
    source->dialect = dialect_of(source);
    source->marches =
        source->dialect == DIALECT_COURSE && glsl_find_call(&source->code, "traceBegin") != NULL;
    if (source->dialect == DIALECT_WHOLE && glsl_mentions(&source->code, "gl_Position") > 0)
        return formats_refuse_vertex(source);
    return (source->dialect != DIALECT_SHADERTOY || check_image(source)) &&
           (source->dialect == DIALECT_COURSE ||
            translate(source, TRANSLATE_DRIVER, &source->prelude, &source->body));
}

// ---- Checks after the driver's ----

static bool explain(const struct shader_source *source, const char *log)
{
    const struct glsl *code = &source->code;
    const struct glsl_token *image = glsl_find(code, "mainImage");
    const struct input *input;
    const struct glsl_token *pixel = glsl_find(code, "FC");
    if (glsl_mentions(code, "gl_Position") > 0)
        return !formats_refuse_vertex(source);
    if (pixel != NULL && source->file_count == 1)
        return !shader_refuse(
            source, pixel->line,
            "FC: a short name from twigl: write gl_FragCoord, declare uniform vec2 "
            "resolution; and uniform float time; and put everything into void "
            "main()");
    if (glsl_find(code, "main") == NULL && image == NULL && glsl_mentions(code, "error") == 0)
        return !report("%s: draws no picture, because it has no main: write void main(), or "
                       "mainImage as in Shadertoy, or begin with #include \"main.glsl\" as the "
                       "chapters do",
                       source->files[0]);
    if (source->version > 330 && strstr(log, "not supported") != NULL &&
        strstr(log, "ersion") != NULL)
        return !shader_refuse(source, glsl_find(code, "version")->line,
                              "#version %d: this driver does not have it: write #version 330",
                              source->version);
    for (int i = 0; source->dialect != DIALECT_COURSE && (input = tool_inputs_row(i)) != NULL;
         i++) {
        bool lacks = tool_inputs_lacks(source, input) && strstr(log, input->name) != NULL;
        const struct glsl_token *token = lacks ? glsl_find(code, input->name) : NULL;
        if (token != NULL)
            return !tool_inputs_refuse(source, input, token->line);
    }
    return source->dialect == DIALECT_SHADERTOY && image != NULL &&
           strstr(log, "mainImage") != NULL && !refuse_image(source, image);
}

// True if the code may write a colour, perhaps through a macro.
static bool writes(const struct glsl *code)
{
    for (const struct glsl_token *t = code->statement; t->kind != GLSL_END;
         t = t->sign == '(' ? glsl_next(code, t) : t + 1) // an out parameter is not an output
        if (glsl_is(t, "out"))
            return true;
    for (const struct glsl_token *t = code->item; t->kind != GLSL_END; t++)
        if (t->directive && t->live && glsl_is(t, "out"))
            return true;
    return glsl_mentions(code, "gl_FragColor") + glsl_mentions(code, "gl_FragData") > 0;
}

// Print a warning, unless this was done before, perhaps for another pass. Frees why.
//   input  the warning is about an input, and the first such one is kept
static void warn(struct shader_source *source, int line, bool input, char *why)
{
    char *before = source->warned;
    if (before == NULL || strstr(before, why) == NULL) {
        shader_refuse(source, line, "warning: %s", why);
        source->warned = memory_text("%s%s\n", before != NULL ? before : "", why);
        free(before);
    }
    if (input && source->unset == NULL)
        source->unset = memory_text("%s", why);
    free(why);
}

// Warn that nothing sets a uniform or a block, and say how to give it a value.
static void warn_of(struct shader_source *source, const struct declared *at)
{
    const struct input *input = tool_inputs_find(at->word);
    bool silent = input != NULL && input->meaning == INPUT_SILENT;
    const char *type = at->type->text, *one = "1.0";
    char base = ' ', vector[16];
    int components = glsl_type(type, &base);
    if (components > 1) {
        snprintf(vector, sizeof vector, "%s(1.0)", type);
        one = vector;
    } else if (base != 'f')
        one = base == 'i' ? "1" : "true";
    bool parameter = base == 'f' || (components == 1 && strchr("ib", base) != NULL);
    char *why;
    if (at->kind == DECLARED_BLOCK)
        why = memory_text("the members of the block %s are 0: nothing sets them; declare variables "
                          "with a value instead",
                          at->word);
    else if (!silent && parameter && at->name[1].sign != '[')
        why =
            memory_text("uniform %s %s is 0: nothing sets it; give it a value: uniform %s %s = "
                        "%s; // %s",
                        type, at->word, type, at->word, one, base == 'b' ? "true" : "1 in [0, 4]");
    else
        why = memory_text("uniform %s %s is 0: %s", type, at->word,
                          silent                          ? input->text
                          : strstr(type, "image") != NULL ? "images that a shader writes to are "
                                                            "not supported"
                                                          : "nothing sets it; give it a value "
                                                            "where it is declared");
    warn(source, at->name->line, true, why);
}

// Warn of the samplers without a picture that the program reads, and of the sizes of such pictures.
static void warn_of_black(struct shader_source *source, const struct gl *gl, GLuint program)
{
    for (int i = 0; i < source->sampler_count; i++) {
        const struct shader_sampler *s = &source->samplers[i];
        if (!sampler_has_picture(source, s) && gl->GetUniformLocation(program, s->name) >= 0)
            warn(source, s->line, true, tool_inputs_why_black(source, s));
    }
    for (int i = 0; i < source->input_count; i++) {
        const struct input *input = source->inputs[i].input;
        bool silent = input->meaning == INPUT_SILENT;
        bool sizes = input->meaning == INPUT_CHANNEL_SIZE && source->unset == NULL &&
                     !tool_inputs_has_size(source, input);
        if ((silent || sizes) && gl->GetUniformLocation(program, input->name) >= 0)
            warn(source, glsl_find(&source->code, input->name)->line, true,
                 memory_text("%s is 0: %s", input->name,
                             silent ? input->text : "no channel has a picture"));
    }
}

static void warn_of_unset(struct shader_source *source)
{
    struct declared at = {.code = &source->code};
    while (declared_next(&at)) {
        const struct input *input = tool_inputs_find(at.word);
        bool set =
            input != NULL && input->meaning != INPUT_SILENT && input->meaning != INPUT_POSITION;
        for (int i = 0; i < source->sampler_count; i++)
            set |= strcmp(source->samplers[i].name, at.word) == 0;
        bool unset = at.kind == DECLARED_UNIFORM && !set && at.value == NULL;
        bool block = at.kind == DECLARED_BLOCK && !glsl_is(at.type - 1, "in");
        if ((block || unset) && declared_is_read(&at) && !parameter_declared(source, at.name))
            warn_of(source, &at);
    }
}

// Warn of smoothstep with two equal edges, which divides by 0.
static void warn_of_edges(struct shader_source *source)
{
    const struct glsl_token *t = NULL;
    while ((t = glsl_find_next(&source->code, t, "smoothstep")) != NULL)
        if (t[1].sign == '(' && t[2].kind == GLSL_NUMBER && t[3].sign == ',' &&
            t[4].kind == GLSL_NUMBER && t[4].name == t[2].name && t[5].sign == ',')
            warn(source, t->line, false,
                 memory_text("smoothstep(%s, %s, ...) divides by 0, and drivers draw it "
                             "differently: write step(%s, ...)",
                             t[2].text, t[4].text, t[2].text));
}

static bool accept(struct shader_source *source, const struct gl *gl, GLuint program)
{
    const struct glsl *code = &source->code;
    if (source->dialect != DIALECT_COURSE) {
        warn_of_black(source, gl, program);
        warn_of_unset(source);
        warn_of_edges(source);
    }
    if (source->dialect != DIALECT_WHOLE)
        return true;
    struct declared shown = declared_output(code);
    if (shown.kind != DECLARED_NONE && shown.name->certain && !declared_is_read(&shown))
        return shader_refuse(source, shown.name->line,
                             "out %s %s never gets a value: write %s = vec4(...); in main",
                             shown.type->text, shown.word, shown.word);
    return writes(code) ||
           report("%s: writes no colour: declare out vec4 FragColor; and give it a value in main",
                  source->files[0]);
}

const struct dialects dialects = {.unpack = unpack,
                                  .obey = directives_obey,
                                  .take = take,
                                  .explain = explain,
                                  .with_floats = translate_floats,
                                  .accept = accept,
                                  .export_file = export_file};
