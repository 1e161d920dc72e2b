#include "shader/translate.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "context/gl.h"
#include "memory.h"
#include "shader/inputs.h"
#include "shader/parameter.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

// A translation in progress.
struct translation {
    struct shader_source *source;
    const struct glsl *code;
    struct edits edits;
    bool toy;      // the source is in Shadertoy's dialect
    bool exported; // the target is Shadertoy
    bool web;      // the target is WebGL, as Shadertoy is
    bool coloured; // an output is declared
    bool old;      // gl_FragColor is the output
    bool wraps;    // Shadertoy gets a mainImage that calls the file's own
    bool blocks;   // there is a block of inputs
    FILE *inputs;  // declarations of the inputs that the text reads and does not declare
    FILE *begin;   // statements at the beginning of main
    FILE *extensions;
};

// ---- Declarations ----

static bool is_used(const struct declared *at)
{
    return at->code->name[at->name->name].last > at->name - at->code->statement;
}

static bool refuse_type(struct translation *t, const struct declared *at, const struct input *input)
{
    return shader_refuse(
        t->source, at->name->line, "%s %.*s%s %s: %s is a %s here%s",
        at->kind == DECLARED_IN ? "in" : "uniform", GLSL_TEXT(t->code, at->type),
        declared_is_array(at) ? "[]" : "", at->word, at->word, input->type,
        input->meaning < INPUT_VALUES ? ": declare it as float, int, vec2, vec3 or vec4" : "");
}

static bool store(struct translation *t, struct declared *at, const char *storage)
{
    declared_store(at, &t->edits, t->exported ? "" : storage);
    return true;
}

// Leave a name out of what Shadertoy gets, which declares it, or needs none.
static bool leave_out(struct translation *t, struct declared *at)
{
    if (at->name == at->first && at->end->sign == ';') {
        edits_cut(&t->edits, at->begin, at->end);
        return true;
    }
    edits_add(&t->edits, at->name->begin, 0, "shader_");
    return store(t, at, "");
}

static void cut_value(struct translation *t, const struct declared *at)
{
    if (at->value != NULL && at->end->kind != GLSL_END)
        edits_cut(&t->edits, at->value, at->end - 1);
}

static bool take_sampler(struct translation *t, struct declared *at, const struct input *input)
{
    bool used = is_used(at), channel = input != NULL && input->meaning == INPUT_CHANNEL;
    int line = at->name->line;
    if (used && glsl_is(t->code, at->type, "samplerCube"))
        return shader_refuse(t->source, line,
                             "%s: cube maps are not offered: a picture is a sampler2D", at->word);
    if (used && channel && (!glsl_is(t->code, at->type, "sampler2D") || declared_is_array(at)))
        return refuse_type(t, at, input);
    if (used && !channel && (input == NULL || input->meaning != INPUT_SILENT))
        return shader_refuse(t->source, line,
                             "%s has no picture: name it iChannel0, a sampler2D, and give "
                             "--channel 0=FILE.png",
                             at->word);
    if (used && (channel ? !inputs_offers(t->source, input) : t->exported))
        return inputs_refuse(t->source, input, line);
    if (channel)
        inputs_add(t->source, (struct shader_input){.input = input, .declared = true});
    if (t->exported && at->name == at->first && at->end->sign == ';')
        return leave_out(t, at);
    declared_store(at, &t->edits, "uniform");
    return true;
}

// Take an input whose value is the same for all pixels.
static bool take_value(struct translation *t, struct declared *at, const struct shader_input *in)
{
    if (in->input->meaning == INPUT_ZERO && at->value != NULL)
        return store(t, at, "");
    inputs_add(t->source, *in);
    cut_value(t, at);
    return t->exported && inputs_is_own(in) ? leave_out(t, at) : store(t, at, "uniform");
}

// Take an input that differs from pixel to pixel.
static bool take_position(struct translation *t, struct declared *at, const struct shader_input *in)
{
    if (in->input != NULL && in->input->meaning == INPUT_POSITION)
        inputs_add(t->source, *in);
    else if (is_used(at))
        return shader_refuse(t->source, at->name->line,
                             "in %.*s %s: there is no such input; the nearest is %s: "
                             "docs/using.md lists all",
                             GLSL_TEXT(t->code, at->type), at->word,
                             inputs_nearest(at->word)->name);
    return store(t, at, "in");
}

static bool take_uniform(struct translation *t, struct declared *at, const struct shader_input *in)
{
    const struct input *input = in->input;
    if (input != NULL && input->meaning == INPUT_CHANNEL_SIZE) {
        bool array = declared_is_array(at), row = input->channel < 0;
        if (array != row || !glsl_is(t->code, at->type, row ? "vec3" : "vec2"))
            return refuse_type(t, at, input);
        inputs_add(t->source, *in);
    }
    if (input != NULL && is_used(at) && !inputs_offers(t->source, input))
        return inputs_refuse(t->source, input, at->name->line);
    if (t->exported && input != NULL && inputs_is_shadertoy(input))
        return leave_out(t, at);
    if (!parameter_declared(t->source, at->name))
        return store(t, at, at->value != NULL ? "" : "uniform");
    cut_value(t, at);
    t->wraps = t->exported;
    return store(t, at, "uniform");
}

static bool take_input(struct translation *t, struct declared *at)
{
    struct shader_input in = {.input = inputs_find(at->word), .declared = true};
    const struct input *input = in.input;
    bool typed = inputs_type(t->code->text + at->type->begin, at->type->length, &in) &&
                 !declared_is_array(at);
    bool varies = at->kind == DECLARED_IN;
    char type[DECLARED_NAME];
    snprintf(type, sizeof type, "%.*s", GLSL_TEXT(t->code, at->type));
    if (at->type->macro || at->name->macro || (varies && strncmp(at->word, "gl_", 3) == 0))
        return true;
    if (!varies &&
        (strstr(type, "sampler") != NULL || (input != NULL && input->meaning == INPUT_CHANNEL)))
        return take_sampler(t, at, input);
    bool value = input != NULL && input->meaning < INPUT_VALUES;
    bool position = varies && input != NULL && input->meaning == INPUT_POSITION;
    if ((value && !typed) || (position && (!typed || in.integer)))
        return refuse_type(t, at, input);
    return value    ? take_value(t, at, &in)
           : varies ? take_position(t, at, &in)
                    : take_uniform(t, at, &in);
}

// Make a block of inputs, as in KodeLife, a structure that main fills in.
static bool take_block(struct translation *t, const struct declared *at)
{
    static const struct {
        const char *word, *value;
    } members[] = {{"coord", "%s"}, {"uv", "%s"}, {"position", "2.0 * %s - 1.0"}};
    static const char *const types[] = {"vec2", "vec3", "vec4", NULL}, *const rest[] = {
                                                                           "", ", 1.0",
                                                                           ", 0.0, 1.0"};
    const struct glsl_token *end = glsl_partner(t->code, at->end), *name = end + 1;
    char value[128], member[DECLARED_NAME];
    if (name->kind != GLSL_WORD)
        return shader_refuse(t->source, at->name->line,
                             "in %s { }: give the block a name behind it", at->word);
    edits_replace(&t->edits, at->type - 1, "struct");
    edits_add(&t->edits, name->begin, 0, "; %s ", at->word);
    for (const struct glsl_token *m = at->end + 1; m < end; m++) {
        size_t i = 0;
        if (!glsl_is_any(t->code, m, types) || m[1].kind != GLSL_WORD)
            continue;
        snprintf(member, sizeof member, "%.*s", GLSL_TEXT(t->code, m + 1));
        while (i < COUNT(members) && strstr(member, members[i].word) == NULL)
            i++;
        if (i == COUNT(members))
            continue;
        snprintf(value, sizeof value, members[i].value,
                 t->exported ? "(gl_FragCoord.xy / iResolution.xy)"
                             : "(harnessFragCoord.xy / harnessResolution.xy)");
        fprintf(t->begin, "%.*s.%s=%.*s(%s%s);", GLSL_TEXT(t->code, name), member,
                GLSL_TEXT(t->code, m), value, rest[t->code->text[m->begin + 3] - '2']);
    }
    t->blocks = true;
    return true;
}

// The outputs of a whole file.
struct outputs {
    int count;
    struct declared shown;  // at location 0, or the first
    struct declared second; // the first of the others
    bool placed;            // one is at location 0
};

//   uncertain  those inside an #if that only the driver can decide count
static struct outputs find_outputs(const struct glsl *code, bool uncertain)
{
    struct declared at = {.code = code};
    struct outputs outputs = {0};
    while (declared_next(&at)) {
        if (at.kind != DECLARED_OUT || !(at.name->certain || uncertain))
            continue;
        bool zero = declared_is_first(&at), first = zero || outputs.count == 0;
        if (outputs.count++ > 0 && (first || outputs.count == 2))
            outputs.second = first ? outputs.shown : at;
        if (first)
            outputs.shown = at;
        outputs.placed |= zero;
    }
    return outputs;
}

struct declared translate_output(const struct glsl *code)
{
    return find_outputs(code, true).shown;
}

static bool check_outputs(struct translation *t, const struct outputs *outputs)
{
    static const char *const colours[] = {"vec4", "vec3", NULL};
    const struct declared *shown = &outputs->shown, *second = &outputs->second;
    if (outputs->count > 1 && !outputs->placed)
        return shader_refuse(t->source, second->name->line,
                             "out %.*s %s: a second output: write layout(location = 0) before the "
                             "one that is the picture",
                             GLSL_TEXT(t->code, second->type), second->word);
    return outputs->count == 0 || shown->type->macro ||
           glsl_is_any(t->code, shown->type, colours) ||
           shader_refuse(t->source, shown->name->line,
                         "out %.*s %s: a picture is made of colours: write out vec4 %s;",
                         GLSL_TEXT(t->code, shown->type), shown->word, shown->word);
}

// Check the declarations, rewrite them, and gather the inputs.
static bool take_declarations(struct translation *t)
{
    struct declared at = {.code = t->code};
    struct outputs outputs = find_outputs(t->code, false);
    bool done = t->toy || check_outputs(t, &outputs);
    while (done && declared_next(&at)) {
        if (at.kind == DECLARED_IN || at.kind == DECLARED_UNIFORM)
            done = take_input(t, &at);
        else if (at.kind == DECLARED_BLOCK && glsl_is(t->code, at.type - 1, "in"))
            done = take_block(t, &at);
        else if (at.kind == DECLARED_BLOCK && t->exported)
            done = shader_refuse(t->source, at.name->line,
                                 "the block %s: Shadertoy sets none: declare variables with a "
                                 "value instead",
                                 at.word);
        else if (at.kind == DECLARED_OUT && !t->toy && (t->exported || outputs.count == 1))
            store(t, &at, "out");
    }
    t->coloured = translate_output(t->code).kind != DECLARED_NONE;
    t->old = !t->toy && !t->coloured &&
             glsl_mentions(t->code, "gl_FragColor") + glsl_mentions(t->code, "gl_FragData") > 0;
    return done;
}

// Declare the inputs that the text reads and does not declare.
static void add_undeclared(struct translation *t)
{
    const struct input *input;
    for (int i = 0; (input = inputs_row(i)) != NULL; i++) {
        const struct glsl_name *name = glsl_name(t->code, input->name);
        if (name == NULL || name->count == 0 || name->macro || input->meaning == INPUT_POSITION ||
            input->meaning >= INPUT_SILENT || !inputs_offers(t->source, input) ||
            declared_anywhere(t->code, input->name))
            continue;
        inputs_add(t->source, inputs_default(input));
        int type = (int)strcspn(input->type, "[");
        if (t->exported && inputs_is_shadertoy(input))
            continue;
        if (input->meaning == INPUT_CHANNEL && !inputs_is_shadertoy(input))
            fprintf(t->inputs, "uniform sampler2D iChannel%d;\n", input->channel);
        else
            fprintf(t->inputs, "%s%.*s %s%s;\n", t->exported ? "" : "uniform ", type, input->type,
                    input->name, input->type + type);
    }
}

// ---- Words ----

enum { TO_DRIVER = 1, TO_TOY = 2, TO_WEB = 4, WRAPPED = 8 };

static const struct {
    const char *word, *instead;
    int when; // the targets
} renamed[] = {{"gl_FragCoord", "harnessFragCoord", TO_DRIVER},
               {"lowp", "highp", TO_DRIVER},
               {"mediump", "highp", TO_DRIVER},
               {"varying", "in", TO_DRIVER},
               {"gl_FragDepthEXT", "gl_FragDepth", TO_DRIVER | TO_TOY},
               {"main", "shaderMain", TO_TOY | WRAPPED},
               {"mainImage", "shaderImage", TO_TOY | WRAPPED},
               {"double", "float", TO_WEB},
               {"dvec2", "vec2", TO_WEB},
               {"dvec3", "vec3", TO_WEB},
               {"dvec4", "vec4", TO_WEB},
               {"dmat2", "mat2", TO_WEB},
               {"dmat3", "mat3", TO_WEB},
               {"dmat4", "mat4", TO_WEB}};

// Words that WebGL defines or reserves, and another version leaves to an author.
static const char *const reserved[] = {
    "texture", "sample",    "patch", "resource", "round",       "roundEven",   "trunc",
    "sinh",    "cosh",      "tanh",  "asinh",    "acosh",       "atanh",       "inverse",
    "isnan",   "transpose", "isinf", "modf",     "determinant", "outerProduct"};

static bool is_targeted(const struct translation *t, int when)
{
    int target = (t->exported ? TO_TOY : TO_DRIVER) | (t->web ? TO_WEB : 0);
    return (when & target) != 0 && (!(when & WRAPPED) || t->wraps);
}

// Rename a texture function of an old version: texture2DLodEXT becomes textureLod.
static bool rename_texture(struct translation *t, const struct glsl_token *token)
{
    static const char *const kinds[] = {"1D", "2DRect", "2D", "3D", "Cube"};
    static const char *const ways[] = {"", "Lod", "Proj", "ProjLod", "Grad", "ProjGrad"};
    char word[32];
    snprintf(word, sizeof word, "%.*s", GLSL_TEXT(t->code, token));
    size_t kind = 0, way = 0;
    while (kind < COUNT(kinds) && (strncmp(word, "texture", 7) != 0 ||
                                   strncmp(word + 7, kinds[kind], strlen(kinds[kind])) != 0))
        kind++;
    if (kind == COUNT(kinds))
        return false;
    const char *rest = word + 7 + strlen(kinds[kind]);
    size_t length = strlen(rest), ending = length < 3 ? 0 : length - 3;
    if (strcmp(rest + ending, "EXT") == 0 || strcmp(rest + ending, "ARB") == 0)
        length = ending;
    while (way < COUNT(ways) &&
           (strlen(ways[way]) != length || strncmp(rest, ways[way], length) != 0))
        way++;
    if (way < COUNT(ways))
        edits_add(&t->edits, token->begin, token->length, "texture%s", ways[way]);
    return way < COUNT(ways);
}

// True if the author declares or defines a word.
static bool is_taken(const struct glsl *code, const char *word)
{
    const struct glsl_token *t = NULL;
    do
        t = glsl_find_next(code, t, word);
    while (t != NULL && !(t[-1].kind == GLSL_WORD && glsl_is_sign(t + 1, ";,=[)")));
    return t != NULL || glsl_find_definition(code, word) != NULL;
}

static void rename_word(struct translation *t, const struct glsl_token *token, const bool taken[])
{
    const struct glsl *code = t->code;
    if (code->name[token->name].macro || rename_texture(t, token))
        return;
    if (t->wraps && glsl_is(code, token, "precision") && token[3].sign == ';')
        edits_cut(&t->edits, token, token + 3);
    for (size_t i = 0; i < COUNT(renamed); i++)
        if (is_targeted(t, renamed[i].when) && glsl_is(code, token, renamed[i].word))
            edits_replace(&t->edits, token, renamed[i].instead);
    for (size_t i = 0; i < COUNT(reserved); i++)
        if (taken[i] && glsl_is(code, token, reserved[i]) &&
            (i > 0 || glsl_code(token + 1)->sign != '('))
            edits_add(&t->edits, token->begin, 0, "own_");
    bool data = t->old && glsl_is(code, token, "gl_FragData") && token[1].sign == '[';
    if (data)
        edits_cut(&t->edits, token + 1, token + 3);
    if (data || (t->old && glsl_is(code, token, "gl_FragColor")))
        edits_replace(&t->edits, token, t->exported ? "shaderColour" : "harnessColour");
    for (int i = 0; i < t->source->input_count; i++) {
        const struct shader_input *in = &t->source->inputs[i];
        bool toy = inputs_is_shadertoy(in->input);
        if (!glsl_is(code, token, in->input->name))
            continue;
        if (in->input->meaning == INPUT_CHANNEL && !toy)
            edits_add(&t->edits, token->begin, token->length, "iChannel%d", in->input->channel);
        else if (t->exported && toy && !inputs_is_own(in))
            edits_add(&t->edits, token->begin, 0, "own_");
    }
    if (!t->toy || t->exported || !token->live || !glsl_is(code, token, "mainImage"))
        return;
    const struct glsl_token *word = glsl_code(token + 1); // the colour begins as zero: inout
    word = word->sign == '(' ? glsl_code(word + 1) : word;
    if (glsl_is(code, word, "out"))
        edits_add(&t->edits, word->begin, 0, "in");
}

// Remove a #version or an #extension. An extension that the core of 3.30 and of ES 3.00 lacks is
// handed to the driver, which knows it or refuses it.
static void take_directive(struct translation *t, const struct glsl_token *hash)
{
    static const char *const core[] = {"GL_OES_standard_derivatives",
                                       "GL_EXT_shader_texture_lod",
                                       "GL_ARB_shader_texture_lod",
                                       "GL_EXT_frag_depth",
                                       "GL_ARB_explicit_attrib_location",
                                       "GL_EXT_gpu_shader4",
                                       "GL_ARB_shader_bit_encoding",
                                       "GL_EXT_draw_buffers",
                                       "GL_ARB_draw_buffers",
                                       "GL_ARB_uniform_buffer_object",
                                       "GL_OES_texture_3D",
                                       "GL_ARB_shading_language_420pack",
                                       "GL_OES_texture_float",
                                       "GL_OES_texture_float_linear",
                                       NULL};
    const struct glsl *code = t->code;
    const struct glsl_token *end = hash;
    bool extension = glsl_is(code, hash + 1, "extension");
    if (!extension && !glsl_is(code, hash + 1, "version"))
        return;
    while (end[1].directive && end[1].kind != GLSL_HASH && end[1].kind < GLSL_COMMENT)
        end++;
    edits_cut(&t->edits, hash, end);
    if (extension && hash->live && !glsl_is_any(code, hash + 2, core))
        fprintf(t->extensions, "%.*s\n", end->begin + end->length - hash->begin,
                code->text + hash->begin);
}

// Remove the suffix of a double.
static void take_number(struct translation *t, const struct glsl_token *token)
{
    const char *end = t->code->text + token->begin + token->length;
    if (t->web && token->length > 2 && strchr("fF", end[-1]) != NULL &&
        strchr("lL", end[-2]) != NULL)
        edits_add(&t->edits, token->begin + token->length - 2, 2, "%s", "");
}

static void take_words(struct translation *t)
{
    bool taken[COUNT(reserved)] = {0};
    for (size_t i = 0; i < COUNT(reserved); i++)
        taken[i] = (t->web || i == 0) && is_taken(t->code, reserved[i]);
    for (const struct glsl_token *token = t->code->item; token->kind != GLSL_END; token++) {
        if (token->kind == GLSL_HASH)
            take_directive(t, token);
        else if (token->kind == GLSL_WORD)
            rename_word(t, token, taken);
        else if (token->kind == GLSL_NUMBER)
            take_number(t, token);
    }
}

// ---- Values that WebGL does not accept outside of functions ----

// True if a value must wait for main: it reads an input or calls a function of the text.
static bool must_wait(const struct translation *t, const struct declared *at, const bool waits[])
{
    char word[DECLARED_NAME];
    for (const struct glsl_token *v = at->value + 1; v < at->end; v++) {
        if (v->kind != GLSL_WORD)
            continue;
        snprintf(word, sizeof word, "%.*s", GLSL_TEXT(t->code, v));
        for (int i = 0; i < t->source->input_count; i++)
            if (strcmp(t->source->inputs[i].input->name, word) == 0)
                return true;
        if (waits[v->name] || (v[1].sign == '(' && glsl_find_definition(t->code, word) != NULL))
            return true;
    }
    return false;
}

static void move_values(struct translation *t)
{
    const struct glsl *code = t->code;
    bool *waits = memory_zeros((size_t)code->name_count, sizeof *waits);
    struct declared at = {.code = code};
    while (declared_next(&at)) {
        if (at.kind != DECLARED_VARIABLE || at.name->depth > 0 || at.value != at.name + 1 ||
            at.type != at.begin || !must_wait(t, &at, waits))
            continue;
        waits[at.name->name] = true;
        edits_cut(&t->edits, at.value, at.end - 1);
        fputs(at.word, t->begin);
        for (const struct glsl_token *v = at.value; v < at.end; v++)
            if (glsl_is(code, v, "gl_FragCoord") && !t->exported)
                fputs(" harnessFragCoord", t->begin);
            else
                fprintf(t->begin, "%s%.*s", v->kind == GLSL_SIGN ? "" : " ", GLSL_TEXT(code, v));
        fputc(';', t->begin);
    }
    free(waits);
}

// ---- The text ----

// A macro of the author's changes the words after it, so these are few.
static const char toy_front[] =
    "out vec4 harnessColour;\n"
    "vec4 harnessOwn = vec4(0.0);\n"
    "vec2 harnessPixel;\n"
    "void harnessBegin() { harnessPixel = harnessFragCoord.xy; }\n"
    "void harnessEnd() { harnessColour = vec4(clamp(harnessOwn.rgb, 0.0, 1.0), 1.0); }\n";
static const char toy_behind[] =
    "#undef void\n#undef main\n#undef mainImage\n"
    "void main() { harnessBegin(); mainImage(harnessOwn, harnessPixel); harnessEnd(); }\n";

// True if Shadertoy needs a mainImage that calls the file's own.
static bool must_wrap(const struct translation *t)
{
    bool wraps = t->wraps || !t->toy;
    for (int i = 0; i < t->source->input_count; i++)
        wraps |= !inputs_is_own(&t->source->inputs[i]) &&
                 t->source->inputs[i].input->meaning != INPUT_CHANNEL;
    return wraps;
}

static char *driver_prelude(const struct translation *t, const char *inputs, const char *extensions)
{
    int version = GL_IS_ES || t->toy ? 0 : t->source->version;
    char *prelude;
    FILE *text = memory_open(&prelude);
    if (version > 330)
        fprintf(text, "#version %d core\n%s", version, extensions);
    else
        fprintf(text, GL_GLSL_WITH("%s%s"),
                GL_IS_ES ? "" : "#extension GL_ARB_shading_language_420pack : enable\n",
                extensions);
    if (t->toy)
        fputs("#define HW_PERFORMANCE 1\n", text);
    if (t->blocks)
        fputs("uniform vec3 harnessResolution;\n", text);
    if (t->toy || t->blocks || glsl_mentions(t->code, "gl_FragCoord") > 0)
        fputs("uniform vec2 harnessPixelOffset;\n"
              "#define harnessFragCoord (gl_FragCoord + vec4(harnessPixelOffset, 0.0, 0.0))\n",
              text);
    fputs(inputs, text);
    fputs(t->toy ? toy_front : t->old ? "out vec4 harnessColour;\n" : "", text);
    memory_close(text);
    return prelude;
}

static void write_text(struct translation *t, const char *begin, char **body)
{
    const struct glsl_token *main = glsl_find_definition(t->code, t->toy ? "mainImage" : "main");
    if (!t->exported)
        translate_zeros(t->code, &t->edits, t->old);
    if (main != NULL && begin[0] != '\0')
        edits_add(&t->edits, glsl_next(t->code, main + 1)->begin + 1, 0, "%s", begin);
    char *text = edits_apply(&t->edits, t->source->text);
    *body = memory_text("%s%s", text, t->toy && !t->exported ? toy_behind : "");
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
    char *begin, *inputs, *extensions;
    t.begin = memory_open(&begin);
    t.inputs = memory_open(&inputs);
    t.extensions = memory_open(&extensions);
    bool done = take_declarations(&t);
    if (done) {
        add_undeclared(&t);
        t.wraps = t.exported && must_wrap(&t);
        take_words(&t);
        if (t.web)
            move_values(&t);
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
    free(begin);
    free(inputs);
    free(extensions);
    edits_free(&t.edits);
    return done;
}
