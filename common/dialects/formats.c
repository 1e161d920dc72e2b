#include "dialects/formats.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "report.h"

#define GLSL_ONLY "a shader must be in GLSL"
#define FRAGMENT  "a picture needs a fragment shader"
#define COPY      "save the shader's text in a file of its own"
#define STAGE     "keep its fragment part, and declare its inputs as uniforms with a value"
#define UNIFORMS  "declare its inputs as uniforms with a value, and use iResolution and iTime"

// The table of formats. The first row is named of which a clue applies; blanks separate the clues:
//   .ab       the file's name ends in .ab
//   ^ab       the text begins with ab
//   ` or "    a statement contains this sign
//   @ab       a statement contains ab directly after an @
//   #ab, %ab  there is a directive #ab, or a #pragma ab
//   {ab       the first comment is JSON and contains ab
//   =ab       a statement certainly contains the type ab, which is no macro, before a name
//   ab()      the text defines the function ab, and neither main nor mainImage
//   ab        the text mentions ab
// clang-format off
static const struct format {
    const char *clues, *what, *instead;
} formats[] = {
    {".klproj", "a KodeLife project", "copy its fragment shader from KodeLife into a file"},
    {".html .htm ^<!doctype ^<html ^<script ^<?xml ^<svg", "a web page", COPY},
    {".md ^```", "Markdown", COPY},
    {".slang .slangp %stage", "a shader with several stages, for RetroArch or in Slang", STAGE},
    {"%parameter COMPAT_VARYING COMPAT_TEXTURE", "a libretro shader", STAGE},
    {"CGPROGRAM HLSLPROGRAM CGINCLUDE UnityObjectToClipPos", "a shader for Unity", GLSL_ONLY},
    {".metal metal_stdlib", "Metal, Apple's language", GLSL_ONLY},
    {".hlsl .fx SV_Target SV_POSITION SV_Position", "HLSL, the language of DirectX", GLSL_ONLY},
    {"=float4 =float3 =float2 =half4 =half3 =half2", "HLSL, Metal or Cg, because of its types", GLSL_ONLY},
    {".wgsl @fragment @vertex @compute @group @builtin", "WGSL, the language of WebGPU", GLSL_ONLY},
    {"shader_type", "a shader for Godot", "write void main() or mainImage, and name the inputs as docs/using.md does"},
    {"MODULES_HEAD MODULE_BEGIN_FRAG", "a shader for Cables", UNIFORMS},
    {"qt_TexCoord0 qt_Opacity qt_Matrix", "a shader for Qt", UNIFORMS},
    {"#info #group #preset #donotrun", "a shader for Fragmentarium", "give it a main that marches DE, as chapters/00_first_scene.frag does"},
    {"`", "JavaScript, because it has backquotes", COPY},
    {"\"", "a program, because it has strings", COPY},
    {"{PASSES", "a file with several passes, as its first comment shows", "only those of Shadertoy and glslViewer are drawn"},
    {"isf_vertShaderInit", "a vertex shader for ISF", FRAGMENT},
    {"gl_GlobalInvocationID local_size_x", "a compute shader", FRAGMENT},
    {"EmitVertex", "a geometry shader", FRAGMENT},
    {"gl_TessCoord gl_TessLevelOuter gl_InvocationID", "a tessellation shader", FRAGMENT},
    {"rayPayloadEXT rayPayloadInEXT hitAttributeEXT", "a shader that traces rays with Vulkan", FRAGMENT},
    {"SetMeshOutputsEXT", "a mesh shader", FRAGMENT},
    {"mainSound()", "a sound shader for Shadertoy, because it defines mainSound", "sound is not supported"},
    {"mainCubemap()", "a cube map for Shadertoy, because it defines mainCubemap", "cube maps are not supported"},
    {"transition()", "a GL Transition, which blends two pictures", "transitions are not supported"},
    {"%glslify", "#pragma glslify: this file needs glslify, a JavaScript tool", "run glslify first and use its output"},
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

static bool has_directive(const struct glsl *code, const char *word, bool pragma)
{
    const struct glsl_token *t = code->item;
    while (t->kind != GLSL_END &&
           !(t->kind == GLSL_HASH && t->live && glsl_is(t + 1 + pragma, word) &&
             (!pragma || glsl_is(t + 1, "pragma"))))
        t++;
    return t->kind != GLSL_END;
}

// True if a text begins with a word, in capitals or not.
static bool begins_with(const char *text, const char *word)
{
    while (*word != '\0' && tolower((unsigned char)*text) == tolower((unsigned char)*word)) {
        text++;
        word++;
    }
    return *word == '\0';
}

static bool applies(const char *clue, const char *file, const struct glsl *code)
{
    const struct glsl_token *t = code->statement;
    size_t length = strlen(clue), name = strlen(file);
    char function[32];
    switch (clue[0]) {
    case '.':
        return name > length && begins_with(file + name - length, clue);
    case '^':
        return begins_with(code->text + strspn(code->text, " \t\n"), clue + 1);
    case '`':
    case '"': // an include may be malformed, which has a message of its own
        if (clue[0] == '"' && has_directive(code, "include", false))
            return false;
        while (t->kind != GLSL_END && t->sign != clue[0])
            t++;
        return t->kind != GLSL_END;
    case '@':
        t = glsl_find_next(code, NULL, clue + 1);
        return t != NULL && t[-1].sign == '@';
    case '#':
    case '%':
        return has_directive(code, clue + 1, clue[0] == '%');
    case '{':
        return has_member(code, clue + 1);
    case '=':
        t = glsl_find(code, clue + 1); // float half2 = ... is no type
        return t != NULL && t->certain && !t->directive && glsl_is_word(t[1].text[0]);
    }
    if (clue[length - 1] != ')')
        return glsl_mentions(code, clue) > 0;
    snprintf(function, sizeof function, "%.*s", (int)length - 2, clue);
    return glsl_find_definition(code, function) != NULL && glsl_mentions(code, "main") == 0 &&
           glsl_mentions(code, "mainImage") == 0 && glsl_mentions(code, "include") == 0;
}

// The first format that applies to a file, or NULL.
static const struct format *format_of(const char *file, const struct glsl *code)
{
    char clues[128], *rest;
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        snprintf(clues, sizeof clues, "%s", formats[i].clues);
        for (char *c = strtok_r(clues, " ", &rest); c != NULL; c = strtok_r(NULL, " ", &rest))
            if (applies(c, file, code))
                return &formats[i];
    }
    return NULL;
}

bool formats_check(const char *file, const char *text)
{
    struct glsl code;
    bool plain = text != NULL && strpbrk(text, "\1\2\3\4\5\6\7\10") == NULL;
    glsl_read(&code, plain ? text : "");
    const struct glsl_token *first = code.statement;
    bool json = first->sign == '[' || (first->sign == '{' && first[1].sign != '{');
    const struct format *format = json ? NULL : format_of(file, &code);
    glsl_free(&code);
    return format == NULL || report("%s: %s: %s", file, format->what, format->instead);
}

bool formats_refuse_vertex(const struct shader_source *source)
{
    return report("%s: a vertex shader, because it sets gl_Position: give the fragment shader "
                  "instead",
                  source->files[0]);
}
