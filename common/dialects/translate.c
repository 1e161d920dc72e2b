#include "dialects/translate.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "context/gl.h"
#include "memory.h"
#include "dialects/tool_inputs.h"
#include "dialects/translation.h"

// toy_after follows the author's text. Macros of that text also apply to toy_after, so it uses
// few words.
static const char toy_front[] = "out vec4 harnessColour;\n"
                                "vec4 harnessOwn = vec4(0.0);\n"
                                "vec2 harnessPixel;\n"
                                "void harnessBegin() { harnessPixel = harnessFragCoord.xy; }\n"
                                "void harnessEnd() { harnessColour = HARNESS_END; }\n";
static const char toy_after[] =
    "#undef void\n#undef main\n#undef mainImage\n"
    "void main() { harnessBegin(); mainImage(harnessOwn, harnessPixel); harnessEnd(); }\n";

// Lookups in a sampler1D. WebGL lacks this type, so it becomes a sampler2D.
static const char line_lookups[] =
    "vec4 harnessLine(sampler2D line, float x) { return texture(line, vec2(x, 0.5)); }\n"
    "vec4 harnessLine(sampler2D line, float x, float y) { return harnessLine(line, x); }\n"
    "vec4 harnessLine(sampler2D line, int x, int y) { return texelFetch(line, ivec2(x, 0), y); }\n";

// True if mainImage is declared as Shadertoy declares it, or not at all.
static bool is_plain_image(const struct glsl *code)
{
    const struct glsl_token *image = glsl_find_definition(code, "mainImage");
    const struct glsl_token *t = image != NULL ? image + 6 : NULL;
    return image == NULL || (glsl_is(image + 2, "out") && glsl_is(image + 3, "vec4") &&
                             image[5].sign == ',' && glsl_is(t + glsl_is(t, "in"), "vec2"));
}

// True if Shadertoy needs a new mainImage that calls the file's main or mainImage.
static bool must_wrap(const struct translation *t)
{
    bool wraps =
        t->wraps || !t->toy || !is_plain_image(t->code) || glsl_mentions(t->code, "precision") > 0;
    for (int i = 0; i < t->source->input_count; i++)
        wraps |= !tool_inputs_is_own(&t->source->inputs[i]);
    return wraps;
}

static char *driver_prelude(const struct translation *t, const char *inputs, const char *extensions)
{
    int version = GL_IS_ES || t->toy ? 0 : t->source->version;
    char *prelude;
    FILE *text = memory_open(&prelude);
    if (version > 330)
        fprintf(text, "#version %d core\n%s", version < 450 ? version : 450, extensions);
    else
        fprintf(text, GL_GLSL_WITH("%s%s"),
                GL_IS_ES ? ""
                         : "#extension GL_ARB_shading_language_420pack : enable\n"
                           "#extension GL_ARB_shading_language_packing : enable\n",
                extensions);
    if (t->toy)
        fputs("#define HW_PERFORMANCE 1\n", text);
    if (t->blocks)
        fputs("uniform vec3 harnessResolution;\n", text);
    if (t->toy || t->blocks || glsl_mentions(t->code, "gl_FragCoord") > 0)
        fputs("uniform vec2 harnessPixelOffset;\n"
              "#define harnessFragCoord (gl_FragCoord + vec4(harnessPixelOffset, 0.0, 0.0))\n",
              text);
    if (GL_IS_ES && glsl_mentions(t->code, "sampler1D") > 0)
        fputs(line_lookups, text);
    fputs(inputs, text);
    if (t->toy)
        fprintf(text, "#define HARNESS_END %s\n",
                t->source->request.pass > 0 ? "harnessOwn"
                                            : "vec4(clamp(harnessOwn.rgb, 0.0, 1.0), 1.0)");
    fputs(t->toy ? toy_front : t->old ? "out vec4 harnessColour;\n" : "", text);
    memory_close(text);
    return prelude;
}

static void write_text(struct translation *t, const char *begin, char **body)
{
    const struct glsl_token *main = glsl_find_definition(t->code, t->toy ? "mainImage" : "main");
    if (main != NULL && begin[0] != '\0')
        edits_add(&t->edits, glsl_next(t->code, main + 1)->begin + 1, 0, "%s", begin);
    char *text = edits_apply(&t->edits, t->source->text);
    *body = memory_text("%s%s", text, t->toy && !t->exported ? toy_after : "");
    free(text);
}

bool translate(struct shader_source *source, enum translate_target target, char **prelude,
               char **body)
{
    struct translation t = {.source = source,
                            .code = &source->code,
                            .toy = source->dialect == DIALECT_SHADERTOY,
                            .exported = target == TRANSLATE_SHADERTOY,
                            .web = GL_IS_ES || target == TRANSLATE_SHADERTOY};
    t.mark = memory_zeros((size_t)t.code->name_count, sizeof *t.mark);
    char *begin, *inputs, *extensions;
    t.begin = memory_open(&begin);
    t.inputs = memory_open(&inputs);
    t.extensions = memory_open(&extensions);
    bool done = translation_declarations(&t);
    if (done) {
        translation_undeclared(&t);
        t.wraps = t.exported && must_wrap(&t);
        translation_words(&t);
        if (!t.exported && t.old)
            fputs("harnessColour=vec4(0);", t.begin);
        if (!t.exported)
            translate_zeros(t.code, &t.edits, t.begin);
    }
    memory_close(t.begin);
    memory_close(t.inputs);
    memory_close(t.extensions);
    if (done) {
        write_text(&t, begin, body);
        *prelude = !t.exported ? driver_prelude(&t, inputs, extensions)
                   : t.wraps   ? memory_text("%s%s", inputs, t.old ? "vec4 shaderColour;\n" : "")
                               : NULL;
    }
    free(t.mark);
    free(begin);
    free(inputs);
    free(extensions);
    edits_free(&t.edits);
    return done;
}
