#include "dialects/translation.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "dialects/tool_inputs.h"

// The targets, and two further conditions. WRAPPED: Shadertoy gets a new mainImage that calls the
// file's main or mainImage. OLD: the output is gl_FragColor or gl_FragData.
enum { TO_DRIVER = 1, TO_TOY = 2, TO_WEB = 4, WRAPPED = 8, OLD = 16 };

static const struct {
    const char *word, *instead;
    int when;
} renamed[] = {{"gl_FragCoord", "harnessFragCoord", TO_DRIVER},
               {"gl_FragColor", "harnessColour", TO_DRIVER | OLD},
               {"gl_FragColor", "shaderColour", TO_TOY | OLD},
               {"gl_FragData", "harnessColour", TO_DRIVER | OLD},
               {"gl_FragData", "shaderColour", TO_TOY | OLD},
               {"lowp", "highp", TO_DRIVER},
               {"mediump", "highp", TO_DRIVER},
               {"varying", "in", TO_DRIVER},
               {"gl_FragDepthEXT", "gl_FragDepth", TO_DRIVER | TO_TOY},
               {"main", "shaderMain", TO_TOY | WRAPPED},
               {"mainImage", "shaderImage", TO_TOY | WRAPPED},
               {"sampler1D", "sampler2D", TO_WEB},
               {"double", "float", TO_WEB},
               {"dvec2", "vec2", TO_WEB},
               {"dvec3", "vec3", TO_WEB},
               {"dvec4", "vec4", TO_WEB},
               {"dmat2", "mat2", TO_WEB},
               {"dmat3", "mat3", TO_WEB},
               {"dmat4", "mat4", TO_WEB}};

// Words that desktop drivers, and those that WebGL defines or reserves, but that another version of
// GLSL leaves to the author.
static const char *const desktop_words[] = {"texture", "packed", "row_major", NULL},
                         *const web_words[] = {
                             "texture",   "sample", "patch", "resource",    "round",
                             "roundEven", "trunc",  "sinh",  "cosh",        "tanh",
                             "asinh",     "acosh",  "atanh", "inverse",     "isnan",
                             "transpose", "isinf",  "modf",  "determinant", "outerProduct",
                             NULL};

static bool is_targeted(const struct translation *t, int when)
{
    int target = (t->exported ? TO_TOY : TO_DRIVER) | (t->web ? TO_WEB : 0);
    return (when & target) != 0 && (t->wraps || !(when & WRAPPED)) && (t->old || !(when & OLD));
}

// The current name of a texture function from an old version of GLSL, such as textureLod for
// texture2DLodEXT, or NULL for any other word. The caller frees the name.
static char *new_texture(const char *word)
{
    static const char *const kinds[] = {"texture1D", "texture2DRect", "texture2D", "texture3D",
                                        "textureCube"};
    static const char *const ways[] = {"", "Lod", "Proj", "ProjLod", "Grad", "ProjGrad"};
    for (size_t i = 0; i < COUNT(kinds) * COUNT(ways); i++) {
        const char *kind = kinds[i / COUNT(ways)], *way = ways[i % COUNT(ways)];
        size_t begin = strlen(kind), length = strlen(way);
        if (strncmp(word, kind, begin) != 0 || strncmp(word + begin, way, length) != 0)
            continue;
        const char *end = word + begin + length;
        if (*end == '\0' || strcmp(end, "EXT") == 0 || strcmp(end, "ARB") == 0)
            return memory_text("texture%s", way);
    }
    return NULL;
}

// True for a lookup in a sampler1D, which WebGL lacks.
static bool is_line_lookup(const struct translation *t, const struct glsl_token *token)
{
    const struct glsl_token *bracket = glsl_code(token + 1), *name = glsl_code(bracket + 1);
    return bracket->sign == '(' && name->kind == GLSL_WORD && (t->mark[name->name] & MARK_LINE);
}

// The new name of a word in the target, or NULL if the word is left unchanged. The caller frees the
// name.
static char *new_name(const struct translation *t, const struct glsl_token *token)
{
    const char *word = token->text;
    bool macro = token->macro;
    for (size_t i = 0; i < COUNT(renamed); i++)
        if (is_targeted(t, renamed[i].when) && (!macro || (renamed[i].when & WRAPPED)) &&
            strcmp(word, renamed[i].word) == 0)
            return memory_text("%s", renamed[i].instead);
    if (macro)
        return NULL;
    bool lookup = strcmp(word, "texture") == 0 && glsl_code(token + 1)->sign == '(';
    if ((t->mark[token->name] & MARK_OWN) && !lookup)
        return memory_text("own_%s", word);
    for (int i = 0; i < t->source->sampler_count && t->exported; i++) {
        const struct shader_sampler *s = &t->source->samplers[i];
        bool member = token->begin > 0 && t->code->text[token->begin - 1] == '.';
        if (!member && strcmp(word, s->name) == 0)
            return memory_text("iChannel%d", s->channel);
    }
    return is_line_lookup(t, token) ? memory_text("harnessLine") : new_texture(word);
}

// True for a word that is a macro, or may be a parameter of one.
static bool may_expand(const struct glsl_token *token)
{
    return token->kind == GLSL_WORD && (token->macro || token->directive);
}

// Separate a sign from what may expand to another one directly beside it: a macro, its arguments,
// or a parameter of a macro. Mesa would take the two for -- or ++.
static void part_sign(struct translation *t, const struct glsl_token *sign)
{
    const struct glsl_token *before = sign - 1, *after = sign + 1;
    if (t->web || !glsl_is_sign(sign, "+-"))
        return;
    if (sign > t->code->item && before->begin + before->length == sign->begin &&
        (before->sign == ')' || may_expand(before)))
        edits_add(&t->edits, sign->begin, 0, " ");
    if (after->begin == sign->begin + 1 && may_expand(after))
        edits_add(&t->edits, after->begin, 0, " ");
}

static void take_word(struct translation *t, const struct glsl_token *token)
{
    bool macro = token->macro;
    char *instead = new_name(t, token);
    if (instead != NULL)
        edits_replace(&t->edits, token, instead);
    free(instead);
    if (!macro && t->wraps && glsl_is(token, "precision") && token[3].sign == ';')
        edits_cut(&t->edits, token, token + 3);
    if (!macro && t->old && glsl_is(token, "gl_FragData") && token[1].sign == '[')
        edits_cut(&t->edits, token + 1, token + 3);
    if (macro || !t->toy || t->exported || !token->live || !glsl_is(token, "mainImage"))
        return;
    // Turn out into inout, because the colour begins at 0.
    const struct glsl_token *word = glsl_code(token + 1);
    word = word->sign == '(' ? glsl_code(word + 1) : word;
    if (glsl_is(word, "out"))
        edits_add(&t->edits, word->begin, 0, "in");
}

// ---- The author's own names ----

// True if the author declares or defines a word.
static bool is_taken(const struct glsl *code, const char *word)
{
    const struct glsl_token *t = NULL;
    do
        t = glsl_find_next(code, t, word);
    while (t != NULL && !(t[-1].kind == GLSL_WORD && glsl_is_sign(t + 1, ";,=[)")));
    return t != NULL || glsl_find_definition(code, word) != NULL;
}

static void mark_own(struct translation *t, const char *word)
{
    const struct glsl_name *name = glsl_name(t->code, word);
    if (name != NULL)
        t->mark[name - t->code->name] |= MARK_OWN;
}

// Mark the names that the text uses for a global variable, a function, or an input of another type,
// although they mean something else in WebGL or in Shadertoy.
static void mark_names(struct translation *t)
{
    const struct input *input;
    struct declared at = {.code = t->code};
    for (const char *const *word = t->web ? web_words : desktop_words; *word != NULL; word++)
        if (is_taken(t->code, *word))
            mark_own(t, *word);
    if (!t->exported)
        return;
    for (int i = 0; i < t->source->input_count; i++)
        if (tool_inputs_is_shadertoy(t->source->inputs[i].input) &&
            !tool_inputs_is_own(&t->source->inputs[i]))
            mark_own(t, t->source->inputs[i].input->name);
    while (declared_next(&at))
        if (at.kind == DECLARED_VARIABLE && at.name->depth == 0 &&
            (input = tool_inputs_find(at.word)) != NULL && tool_inputs_is_shadertoy(input))
            mark_own(t, at.word);
    for (int i = 0; (input = tool_inputs_row(i)) != NULL && tool_inputs_is_shadertoy(input); i++)
        if (glsl_find_definition(t->code, input->name) != NULL)
            mark_own(t, input->name);
}

// ---- Directives and numbers ----

// Remove a #version or an #extension. An extension whose features are not part of GLSL 3.30 and ES
// 3.00 is passed to the driver, which accepts or refuses it.
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
                                       "GL_ARB_shading_language_packing",
                                       "GL_OES_texture_float",
                                       "GL_OES_texture_float_linear",
                                       NULL};
    const struct glsl *code = t->code;
    const struct glsl_token *end = hash;
    bool extension = glsl_is(hash + 1, "extension");
    if (!extension && !glsl_is(hash + 1, "version"))
        return;
    while (end[1].directive && end[1].kind != GLSL_HASH && end[1].kind < GLSL_COMMENT)
        end++;
    edits_cut(&t->edits, hash, end);
    if (extension && hash->live && !glsl_is_any(hash + 2, core))
        fprintf(t->extensions, "%.*s\n", end->begin + end->length - hash->begin,
                code->text + hash->begin);
}

// For WebGL, remove the suffix lf of a double.
static void take_number(struct translation *t, const struct glsl_token *token)
{
    const char *end = token->text + token->length;
    if (t->web && token->length > 2 && strchr("fF", end[-1]) != NULL &&
        strchr("lL", end[-2]) != NULL)
        edits_add(&t->edits, token->begin + token->length - 2, 2, "%s", "");
}

// ---- Values that WebGL does not accept outside functions ----

// True if a word has no constant value: it is an input, a function of the text, or a name that
// depends on one of these.
static bool is_variable(const struct translation *t, const struct glsl_token *v, const bool waits[])
{
    if (v->kind != GLSL_WORD)
        return false;
    for (int i = 0; i < t->source->input_count; i++)
        if (strcmp(t->source->inputs[i].input->name, v->text) == 0)
            return true;
    return waits[v->name] ||
           (glsl_code(v + 1)->sign == '(' && glsl_find_definition(t->code, v->text) != NULL);
}

// Find out which macros have no constant value.
static void learn_macros(const struct translation *t, bool waits[])
{
    const struct glsl_token *hash = NULL;
    for (const struct glsl_token *v = t->code->item; v->kind != GLSL_END; v++) {
        if (v->kind == GLSL_HASH && v->live && glsl_is(v + 1, "define"))
            hash = v;
        else if (v->kind == GLSL_HASH || !v->directive)
            hash = NULL;
        if (hash != NULL && v > hash + 2 && hash[2].kind == GLSL_WORD)
            waits[hash[2].name] |= is_variable(t, v, waits);
    }
}

// True if a variable's initial value is not constant and must be set in main.
static bool must_wait(const struct translation *t, const struct declared *at, const bool waits[])
{
    const struct glsl_token *v = at->value + 1;
    while (v < at->end && !is_variable(t, v, waits))
        v++;
    return v < at->end;
}

static void move_value(struct translation *t, const struct declared *at)
{
    edits_cut(&t->edits, at->value, at->end - 1);
    fputs(t->mark[at->name->name] & MARK_OWN ? "own_" : "", t->begin);
    fputs(at->word, t->begin);
    for (const struct glsl_token *v = at->value; v < at->end; v++) {
        char *instead = v->kind == GLSL_WORD ? new_name(t, v) : NULL;
        if (v->kind == GLSL_SIGN)
            fputc(v->sign, t->begin);
        else
            fprintf(t->begin, " %s", instead != NULL ? instead : v->text);
        free(instead);
    }
    fputc(';', t->begin);
}

static void move_values(struct translation *t)
{
    bool *waits = memory_zeros((size_t)t->code->name_count, sizeof *waits);
    struct declared at = {.code = t->code};
    learn_macros(t, waits);
    while (declared_next(&at))
        if (at.kind == DECLARED_VARIABLE && at.name->depth == 0 && at.value == at.name + 1 &&
            at.type == at.begin && must_wait(t, &at, waits)) {
            waits[at.name->name] = true;
            move_value(t, &at);
        }
    free(waits);
}

// Remove semicolons after function bodies, because WebGL refuses them.
static void take_semicolons(struct translation *t)
{
    for (const struct glsl_token *end = t->code->statement; end->kind != GLSL_END; end++) {
        if (end->sign != ';' || end->depth > 0 || end[-1].sign != '}')
            continue;
        const struct glsl_token *close = glsl_partner(t->code, end - 1) - 1;
        if (close->sign == ')' && !glsl_partner(t->code, close)[-1].macro)
            edits_cut(&t->edits, end, end);
    }
}

void translation_words(struct translation *t)
{
    mark_names(t);
    if (t->web)
        take_semicolons(t);
    for (const struct glsl_token *token = t->code->item; token->kind != GLSL_END; token++) {
        if (token->kind == GLSL_HASH)
            take_directive(t, token);
        else if (token->kind == GLSL_WORD)
            take_word(t, token);
        else if (token->kind == GLSL_NUMBER)
            take_number(t, token);
        else
            part_sign(t, token);
    }
    if (t->web && glsl_find_definition(t->code, t->toy ? "mainImage" : "main") != NULL)
        move_values(t);
}
