#include "dialects/formats.h"

#include <stdio.h>
#include <string.h>

#include "report.h"

enum clue {
    CLUE_MEMBER,   // the first comment is JSON and has this member
    CLUE_WORD,     // the text mentions this word
    CLUE_FUNCTION, // the text defines this function, and neither main nor mainImage
    CLUE_PRAGMA    // there is a #pragma with this word
};

#define GLSL_ONLY "a shader must be in GLSL"
#define FRAGMENT  "a picture needs a fragment shader"
#define ISF                                                                                        \
    "an ISF file, as its first comment shows; ISF is not supported",                               \
        "declare its inputs as uniforms with a value, and use iResolution and iTime"

// The table of formats, of which the first that applies is named.
// clang-format off
static const struct format {
    enum clue clue;
    const char *word, *what, *instead;
} formats[] = {
    {CLUE_MEMBER, "\"INPUTS\"", ISF},
    {CLUE_MEMBER, "\"ISFVSN\"", ISF},
    {CLUE_MEMBER, "\"CATEGORIES\"", ISF},
    {CLUE_MEMBER, "\"DESCRIPTION\"", ISF},
    {CLUE_MEMBER, "\"CREDIT\"", ISF},
    {CLUE_MEMBER, "PASSES", "a file with several passes, as its first comment shows",
     "only a single pass can be drawn"},
    {CLUE_WORD, "gl_GlobalInvocationID", "a compute shader", FRAGMENT},
    {CLUE_WORD, "EmitVertex", "a geometry shader", FRAGMENT},
    {CLUE_WORD, "gl_TessCoord", "a tessellation shader", FRAGMENT},
    {CLUE_WORD, "SV_Target", "HLSL, the language of DirectX", GLSL_ONLY},
    {CLUE_WORD, "SV_POSITION", "HLSL, the language of DirectX", GLSL_ONLY},
    {CLUE_WORD, "CGPROGRAM", "a shader for Unity", GLSL_ONLY},
    {CLUE_WORD, "metal_stdlib", "the language of Metal", GLSL_ONLY},
    {CLUE_WORD, "shader_type", "a shader for Godot",
     "write void main() or mainImage, and name the inputs as docs/using.md does"},
    {CLUE_WORD, "isf_vertShaderInit", "a vertex shader for ISF", FRAGMENT},
    {CLUE_WORD, "IMG_PIXEL", "an ISF file, because it uses IMG_PIXEL", "ISF is not supported"},
    {CLUE_WORD, "IMG_NORM_PIXEL", "an ISF file, because it uses IMG_NORM_PIXEL",
     "ISF is not supported"},
    {CLUE_FUNCTION, "mainSound", "a sound shader for Shadertoy, because it defines mainSound",
     "sound is not supported"},
    {CLUE_FUNCTION, "mainCubemap", "a cube map for Shadertoy, because it defines mainCubemap",
     "cube maps are not supported"},
    {CLUE_FUNCTION, "transition", "a GL Transition, which blends two pictures",
     "transitions are not supported"},
    {CLUE_PRAGMA, "glslify", "#pragma glslify: this file needs glslify, a JavaScript tool",
     "run glslify first and use its output"},
};
// clang-format on

// True if a JSON comment at the beginning of the text contains a word.
static bool has_member(const struct glsl *code, const char *word)
{
    const char *c = code->text + code->item->begin + 2, *end = c + code->item->length;
    if (code->item->kind != GLSL_COMMENTED || c[strspn(c, "* \t\n")] != '{')
        return false;
    const char *member = strstr(c, word);
    return member != NULL && member < end;
}

static bool applies(const struct format *format, const struct shader_source *source)
{
    const struct glsl *code = &source->code;
    const struct glsl_token *t;
    switch (format->clue) {
    case CLUE_MEMBER:
        return has_member(code, format->word);
    case CLUE_WORD:
        return glsl_mentions(code, format->word) > 0;
    case CLUE_FUNCTION:
        return source->dialect != DIALECT_SHADERTOY && glsl_mentions(code, "main") == 0 &&
               glsl_find_definition(code, format->word) != NULL;
    case CLUE_PRAGMA:
        t = glsl_find(code, format->word);
        return t != NULL && t->directive && glsl_is(t - 1, "pragma");
    }
    return false;
}

bool formats_check(const struct shader_source *source)
{
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        const struct format *format = &formats[i];
        if (!applies(format, source))
            continue;
        if (format->clue == CLUE_PRAGMA)
            return shader_refuse(source, glsl_find(&source->code, format->word)->line, "%s: %s",
                                 format->what, format->instead);
        return report("%s: %s: %s", source->files[0], format->what, format->instead);
    }
    return source->dialect != DIALECT_WHOLE || glsl_mentions(&source->code, "gl_Position") == 0 ||
           formats_refuse_vertex(source);
}

bool formats_refuse_vertex(const struct shader_source *source)
{
    return report("%s: a vertex shader, because it sets gl_Position: give the fragment shader "
                  "instead",
                  source->files[0]);
}
