#include "shader/form_inputs.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "report.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

enum { NAME_LIMIT = 64 }; // letters of a name that is judged

struct input {
    const char *type, *name, *declaration;
};

// Shadertoy's inputs. The harness fills them in by these names.
#define INPUT(type, name)                                                                          \
    {                                                                                              \
#type, #name, #type " " #name                                                              \
    }
static const struct input toy_inputs[] = {
    INPUT(vec3, iResolution),    INPUT(float, iTime),
    INPUT(float, iTimeDelta),    INPUT(int, iFrame),
    INPUT(float, iFrameRate),    INPUT(vec4, iMouse),
    INPUT(vec4, iDate),          INPUT(sampler2D, iChannel0),
    INPUT(sampler2D, iChannel1), INPUT(sampler2D, iChannel2),
    INPUT(sampler2D, iChannel3), {"vec3", "iChannelResolution", "vec3 iChannelResolution[4]"}};

// The report's, which the vertex shader hands to a whole file.
static const struct input whole_inputs[] = {INPUT(vec2, FragCoord),  INPUT(float, Time),
                                            INPUT(vec3, Ex),         INPUT(vec3, Ey),
                                            INPUT(vec3, Ez),         INPUT(vec3, CamPos),
                                            INPUT(float, fovValue),  INPUT(float, FacteurLargeur),
                                            INPUT(float, OrthoView), INPUT(float, CustomToggle),
                                            INPUT(float, CustomInt)};

// What the course's library reads is set in every form; the two others of the report stay 0.
static const char *const set_inputs[] = {
    "iCameraPosition", "iCameraRight", "iCameraUp", "iCameraForward", "focalLength",
    "iPixelOffset",    "iPixelJitter", "iSample",   "iSamples",       "iOrthoView",
    "CustomToggle",    "CustomInt",    NULL};

const char *form_toy_input(size_t number, const char **name)
{
    if (number >= COUNT(toy_inputs))
        return NULL;
    *name = toy_inputs[number].name;
    return toy_inputs[number].declaration;
}

bool form_declares(const struct glsl *code, const char *word)
{
    bool uniform = false;
    for (const struct glsl_token *t = code->item; t->kind != GLSL_END; t++) {
        uniform = t->live && t->sign != ';' && (uniform || glsl_is(code, t, "uniform"));
        if (uniform && glsl_is(code, t, word))
            return true;
    }
    return false;
}

// The channel that a name says, from 0 to 3; -1 for none.
static int channel_of(const char *name)
{
    static const char channel[] = "iChannel";
    bool one = strncmp(name, channel, strlen(channel)) == 0 && strlen(name) == sizeof channel;
    int number = one ? name[strlen(channel)] - '0' : -1;
    return number >= 0 && number < 4 ? number : -1;
}

bool form_offers(const struct shader_source *source, const char *name)
{
    const char *const *channels = source->request.channels;
    int channel = channel_of(name);
    if (channel >= 0)
        return channels != NULL && channels[channel] != NULL;
    for (int i = 0; channels != NULL && i < 4; i++)
        if (channels[i] != NULL && strcmp(name, "iChannelResolution") == 0)
            return true;
    return strncmp(name, "iChannel", strlen("iChannel")) != 0;
}

bool form_refuse_name(const struct shader_source *source, const struct glsl_token *token)
{
    static const char *const without[] = {"iChannelTime", "iSampleRate", NULL};
    char name[NAME_LIMIT];
    snprintf(name, sizeof name, "%.*s", GLSL_TEXT(&source->code, token));
    int channel = channel_of(name);
    if (glsl_is_any(&source->code, token, without))
        return shader_refuse(source, token->line,
                             "%s is not offered: a shader gets no films, buffers or sounds here: "
                             "compute the values in the shader",
                             name);
    if (channel < 0 && strcmp(name, "iChannelResolution") != 0)
        return shader_refuse(source, token->line,
                             "%s has no picture: name it iChannel0, a sampler2D, and give "
                             "--channel 0=FILE.png",
                             name);
    return shader_refuse(source, token->line, "%s has no picture: give --channel %d=FILE.png", name,
                         channel < 0 ? 0 : channel);
}

void form_blank(struct shader_source *source, int begin, int end)
{
    for (char *c = source->text + begin; c < source->text + end; c++)
        if (*c != '\n')
            *c = ' ';
}

static const struct glsl_token *skip_comments(const struct glsl_token *t)
{
    while (t->kind >= GLSL_COMMENT)
        t++;
    return t;
}

const struct glsl_token *form_colour(const struct glsl_token *image)
{
    const struct glsl_token *bracket = skip_comments(image + 1);
    return bracket->sign == '(' ? skip_comments(bracket + 1) : NULL;
}

// ---- The declarations outside of functions ----

enum kind { NONE, IN, OUT, UNIFORM, BLOCK };
static const char *const kind_names[] = {"", "in", "out", "uniform", "block"};

// A walk over the names that the statements declare.
struct walk {
    const struct glsl *code;
    const struct glsl_token *next; // what comes behind the name, or begins a statement
    enum kind kind;
    const struct glsl_token *begin;  // the first qualifier
    const struct glsl_token *layout; // among the qualifiers; NULL for none
    const struct glsl_token *type, *name;
};

static enum kind kind_of(const struct glsl *code, const struct glsl_token *t)
{
    return glsl_is(code, t, "in") || glsl_is(code, t, "varying")       ? IN
           : glsl_is(code, t, "out")                                   ? OUT
           : glsl_is(code, t, "uniform") || glsl_is(code, t, "buffer") ? UNIFORM
                                                                       : NONE;
}

// Read the beginning of a statement. Returns false when it declares nothing of the kinds.
static bool read_first(struct walk *walk)
{
    static const char *const qualifiers[] = {"flat", "smooth", "noperspective", "centroid", NULL};
    const struct glsl *code = walk->code;
    const struct glsl_token *t = walk->next;
    walk->begin = t;
    walk->layout = NULL;
    for (;; t++)
        if (glsl_is(code, t, "layout") && t[1].sign == '(') {
            walk->layout = t;
            t = glsl_partner(code, t + 1);
        } else if (!glsl_is_any(code, t, qualifiers)) {
            break;
        }
    enum kind kind = kind_of(code, t);
    if (kind == NONE)
        return false;
    for (t++; glsl_is_precision(code, t);)
        t++;
    if (t->kind != GLSL_WORD || t->length >= NAME_LIMIT)
        return false;
    walk->type = t++;
    if (kind == UNIFORM && t->sign == '{')
        kind = BLOCK;
    walk->name = kind == BLOCK ? walk->type : t->sign == '[' ? glsl_next(code, t) : t;
    if (walk->name->kind != GLSL_WORD || walk->name->length >= NAME_LIMIT)
        return false;
    walk->kind = kind;
    walk->next = walk->name + 1;
    return true;
}

// Another name of the same declaration.
static bool read_next(struct walk *walk)
{
    const struct glsl_token *t = glsl_skip(walk->code, walk->next, ",;)}");
    if (walk->kind == NONE || walk->kind == BLOCK || t->sign != ',' || t[1].kind != GLSL_WORD ||
        t[1].length >= NAME_LIMIT)
        return false;
    walk->name = t + 1;
    walk->next = t + 2;
    return true;
}

// Go to the next name that is declared; false at the end.
static bool next_declared(struct walk *walk)
{
    const struct glsl *code = walk->code;
    if (walk->next == NULL)
        walk->next = code->statement;
    else if (read_next(walk))
        return true;
    walk->kind = NONE;
    while (walk->next->kind != GLSL_END) {
        if (walk->next->depth == 0 && read_first(walk))
            return true;
        walk->next = glsl_next(code, glsl_skip(code, walk->next, ";{}"));
    }
    return false;
}

// ---- Judgement ----

static const struct input *find_input(const struct walk *at)
{
    const struct input *inputs = at->kind == UNIFORM ? toy_inputs : whole_inputs;
    size_t count = at->kind == UNIFORM ? COUNT(toy_inputs) : COUNT(whole_inputs);
    for (size_t i = 0; i < count; i++)
        if (glsl_is(at->code, at->name, inputs[i].name))
            return &inputs[i];
    return NULL;
}

static bool is_read(const struct walk *at)
{
    return at->code->name[at->name->name].last > at->name - at->code->statement;
}

// As is_read(), also in a macro.
static bool is_mentioned(const struct glsl *code, const struct glsl_token *name)
{
    return code->name[name->name].count > 1;
}

// The word location in a layout; NULL where there is none.
static const struct glsl_token *location_in(const struct walk *at)
{
    const struct glsl_token *end =
        at->layout != NULL ? glsl_partner(at->code, at->layout + 1) : NULL;
    for (const struct glsl_token *t = at->layout; end != NULL && t < end; t++)
        if (glsl_is(at->code, t, "location"))
            return t;
    return NULL;
}

// Blank a layout that gives a location, where drivers look for the same in the vertex shader.
static void blank_location(struct shader_source *source, const struct walk *at)
{
    if (location_in(at) != NULL)
        form_blank(source, at->layout->begin, glsl_partner(at->code, at->layout + 1)->begin + 1);
}

// CustomToggle and CustomInt as whole numbers: a uniform that nobody sets is 0, as they are. There
// is room for the word where "flat in" stands.
static bool make_uniform(struct shader_source *source, const struct walk *at)
{
    static const char word[] = "uniform", *const names[] = {"CustomToggle", "CustomInt", NULL},
                      *const types[] = {"int", "uint", NULL};
    char *text = source->text + at->begin->begin;
    if (!glsl_is_any(at->code, at->name, names) || !glsl_is_any(at->code, at->type, types) ||
        at->type->begin - at->begin->begin <= (int)strlen(word) ||
        memchr(text, '\n', strlen(word)) != NULL)
        return false;
    form_blank(source, at->begin->begin, at->type->begin);
    memcpy(text, word, sizeof word - 1);
    return true;
}

// Judge an input or a uniform: its type, and for the report's whether there is such a one.
static bool check_input(struct shader_source *source, const struct walk *at)
{
    const struct glsl *code = at->code;
    const struct input *input = find_input(at);
    const char *kind = kind_names[at->kind];
    bool row = at->type[1].sign == '[' || at->name[1].sign == '[';
    const char *wanted = input != NULL ? strchr(input->declaration, '[') : NULL; // of a row
    if (at->kind == IN)
        blank_location(source, at);
    if (at->kind == BLOCK || at->type->macro || at->name->macro)
        return true;
    if (input != NULL && (!glsl_is(code, at->type, input->type) || row != (wanted != NULL)))
        return make_uniform(source, at) ||
               shader_refuse(source, at->name->line,
                             "%s %.*s%s %s: %s is a %s%s here: write %s %s;", kind,
                             GLSL_TEXT(code, at->type), row ? "[]" : "", input->name, input->name,
                             input->type, wanted != NULL ? wanted : "", kind, input->declaration);
    char type[NAME_LIMIT], name[NAME_LIMIT];
    snprintf(type, sizeof type, "%.*s", GLSL_TEXT(code, at->type));
    snprintf(name, sizeof name, "%.*s", GLSL_TEXT(code, at->name));
    bool sampler = strstr(type, "sampler") != NULL;
    if (at->kind == UNIFORM && is_read(at) &&
        (!form_offers(source, name) || (sampler && input == NULL)))
        return form_refuse_name(source, at->name);
    return input != NULL || at->kind == UNIFORM || strncmp(name, "gl_", 3) == 0 || !is_read(at) ||
           shader_refuse(source, at->name->line,
                         "in %.*s %.*s: there is no such input: there are FragCoord, Time, Ex, Ey, "
                         "Ez, CamPos, fovValue, FacteurLargeur, OrthoView, CustomToggle and "
                         "CustomInt",
                         GLSL_TEXT(code, at->type), GLSL_TEXT(code, at->name));
}

// What a whole file writes.
struct outputs {
    int count;
    struct walk shown;  // the one at location 0, or the first one
    struct walk second; // the first of the others
    bool placed;        // one is at location 0
};

static bool is_at_zero(const struct walk *at)
{
    const struct glsl_token *location = location_in(at);
    return location != NULL && location[1].sign == '=' && glsl_is(at->code, location + 2, "0");
}

// Where an #if stands around it, only the driver knows whether it is one.
static void add_output(struct outputs *outputs, const struct walk *at)
{
    if (at->kind != OUT || !at->name->certain)
        return;
    bool zero = is_at_zero(at);
    bool first = zero || outputs->count == 0;
    if (outputs->count++ > 0 && (first || outputs->count == 2))
        outputs->second = first ? outputs->shown : *at;
    if (first)
        outputs->shown = *at;
    outputs->placed |= zero;
}

static struct outputs find_outputs(const struct glsl *code)
{
    struct walk walk = {.code = code};
    struct outputs outputs = {0};
    while (next_declared(&walk))
        add_output(&outputs, &walk);
    return outputs;
}

const struct glsl_token *form_output(const struct glsl *code)
{
    struct walk walk = {.code = code};
    const struct glsl_token *output = NULL;
    while (next_declared(&walk))
        if (walk.kind == OUT && (output == NULL || is_at_zero(&walk)))
            output = walk.name;
    return output;
}

static bool check_outputs(struct shader_source *source)
{
    static const char *const colours[] = {"vec4", "vec3", NULL};
    const struct glsl *code = &source->code;
    struct outputs outputs = find_outputs(code);
    const struct walk *shown = &outputs.shown, *second = &outputs.second;
    if (outputs.count > 1 && !outputs.placed)
        return shader_refuse(source, second->name->line,
                             "out %.*s %.*s: a second output: write layout(location = 0) before "
                             "the one that is the picture",
                             GLSL_TEXT(code, second->type), GLSL_TEXT(code, second->name));
    if (outputs.count > 0 && !shown->type->macro && !glsl_is_any(code, shown->type, colours))
        return shader_refuse(source, shown->name->line,
                             "out %.*s %.*s: a picture is made of colours: write out vec4 %.*s;",
                             GLSL_TEXT(code, shown->type), GLSL_TEXT(code, shown->name),
                             GLSL_TEXT(code, shown->name));
    if (outputs.count == 1)
        blank_location(source, shown);
    return true;
}

bool form_check_inputs(struct shader_source *source)
{
    struct walk walk = {.code = &source->code};
    while (next_declared(&walk))
        if (walk.kind != OUT && !check_input(source, &walk))
            return false;
    return source->form != SHADER_WHOLE || check_outputs(source);
}

// ---- What a driver takes and an author does not expect ----

// True when the code may write a colour, also one that it does not declare in plain words.
static bool writes(const struct glsl *code)
{
    for (const struct glsl_token *t = code->statement; t->kind != GLSL_END;) {
        if (glsl_is(code, t, "out"))
            return true;
        t = t->sign == '(' ? glsl_next(code, t) : t + 1;
    }
    for (const struct glsl_token *t = code->item; t->kind != GLSL_END; t++)
        if (t->directive && t->live && glsl_is(code, t, "out"))
            return true;
    return glsl_mentions(code, "gl_FragColor") > 0 || glsl_mentions(code, "gl_FragData") > 0;
}

// True when something of a block is mentioned outside of it: what it holds, or its name where it
// has one.
static bool block_is_read(const struct walk *at)
{
    const struct glsl_token *t = at->next, *end = glsl_partner(at->code, t);
    if (end[1].kind == GLSL_WORD)
        return is_mentioned(at->code, end + 1);
    for (; t < end; t++)
        if (t->kind == GLSL_WORD && t[1].kind != GLSL_WORD && is_mentioned(at->code, t))
            return true;
    return false;
}

static void warn_of_uniform(const struct shader_source *source, const struct walk *at)
{
    const struct glsl *code = at->code;
    if (at->kind == BLOCK && block_is_read(at))
        shader_refuse(source, at->name->line,
                      "warning: what the block %.*s holds is 0, for nothing sets it here: declare "
                      "variables with a value instead",
                      GLSL_TEXT(code, at->name));
    if (at->kind == UNIFORM && at->next->sign != '=' && find_input(at) == NULL &&
        !glsl_is_any(code, at->name, set_inputs) && is_mentioned(code, at->name))
        shader_refuse(source, at->name->line,
                      "warning: uniform %.*s %.*s is 0, for nothing sets it here: give it a value "
                      "where it is declared; the time is iTime, the size iResolution",
                      GLSL_TEXT(code, at->type), GLSL_TEXT(code, at->name));
}

bool form_check_linked(const struct shader_source *source)
{
    const struct glsl *code = &source->code;
    struct walk walk = {.code = code};
    while (next_declared(&walk))
        warn_of_uniform(source, &walk);
    if (source->form != SHADER_WHOLE)
        return true;
    struct outputs outputs = find_outputs(code);
    const struct walk *shown = &outputs.shown;
    if (outputs.count > 0 && !is_mentioned(code, shown->name))
        return shader_refuse(source, shown->name->line,
                             "out %.*s %.*s: never gets a value: write %.*s = vec4(...); in main",
                             GLSL_TEXT(code, shown->type), GLSL_TEXT(code, shown->name),
                             GLSL_TEXT(code, shown->name));
    if (writes(code))
        return true;
    report("%s: writes no colour: declare out vec4 FragColor; and give it a value in main",
           source->files[0]);
    return false;
}
