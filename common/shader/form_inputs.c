#include "shader/form_inputs.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "shader/glsl.h"
#include "report.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

struct input {
    const char *type, *name, *declaration;
};

// Shadertoy's inputs. The harness fills them in by these names.
#define INPUT(type, name)                                                                          \
    {                                                                                              \
#type, #name, #type " " #name                                                              \
    }
static const struct input toy_inputs[] = {
    INPUT(vec3, iResolution), INPUT(float, iTime), INPUT(float, iTimeDelta), INPUT(int, iFrame),
    INPUT(float, iFrameRate), INPUT(vec4, iMouse), INPUT(vec4, iDate)};

// The report's, which the vertex shader hands to a whole file.
static const struct input whole_inputs[] = {INPUT(vec2, FragCoord),  INPUT(float, Time),
                                            INPUT(vec3, Ex),         INPUT(vec3, Ey),
                                            INPUT(vec3, Ez),         INPUT(vec3, CamPos),
                                            INPUT(float, fovValue),  INPUT(float, FacteurLargeur),
                                            INPUT(float, OrthoView), INPUT(float, CustomToggle),
                                            INPUT(float, CustomInt)};

// What the course's library reads is set in every form.
static const char *const course_inputs[] = {"iCameraPosition", "iCameraRight", "iCameraUp",
                                            "iCameraForward",  "focalLength",  "iPixelOffset",
                                            "iPixelJitter",    "iOrthoView"};

const char *form_toy_input(size_t number, const char **name)
{
    if (number >= COUNT(toy_inputs))
        return NULL;
    *name = toy_inputs[number].name;
    return toy_inputs[number].declaration;
}

bool form_declares(const char *code, const char *name)
{
    const char *word = glsl_find_word(code, "uniform");
    while (word != NULL) {
        const char *end = word + strcspn(word, ";");
        while (word < end && !glsl_at_word(word, name)) {
            size_t length = glsl_word_length(word);
            word += length > 0 ? length : 1;
        }
        if (word < end)
            return true;
        word = glsl_find_word(word, "uniform");
    }
    return false;
}

const struct shader_line *form_line_at(const struct shader_source *source, const char *code,
                                       const char *place)
{
    int line = 0;
    for (const char *c = code; c < place; c++)
        line += *c == '\n';
    return &source->lines[line < source->line_count ? line : source->line_count - 1];
}

void form_refuse_name(const struct shader_source *source, const char *code, const char *place,
                      const char *name)
{
    const struct shader_line *from = form_line_at(source, code, place);
    report("%s:%d: %s is not offered: a shader gets no textures, buffers or sounds here: compute "
           "the values in the shader",
           source->files[from->file], from->line, name);
}

// ---- The declarations outside of functions ----

enum kind { NONE, IN, OUT, UNIFORM };
static const char *const kind_names[] = {"", "in", "out", "uniform"};

// One name that a text declares.
struct declared {
    enum kind kind;
    char type[64], name[64];
    const char *begin, *end; // in the code: from the first qualifier to behind the kind
    const char *layout;      // its word in the code, or NULL
    const char *after;       // behind the name
};

// A walk over the names that a text declares.
struct walk {
    const char *c;
    int depth;   // of braces and parentheses
    bool begins; // a statement, or only qualifiers stand before c
    struct declared at;
};

static enum kind kind_at(const char *c)
{
    if (glsl_at_word(c, "varying"))
        return IN;
    for (enum kind kind = IN; kind <= UNIFORM; kind++)
        if (glsl_at_word(c, kind_names[kind]))
            return kind;
    return NONE;
}

static bool is_qualifier(const char *c)
{
    static const char *const words[] = {"flat", "smooth", "noperspective", "centroid", "layout"};
    for (size_t i = 0; i < COUNT(words); i++)
        if (glsl_at_word(c, words[i]))
            return true;
    return false;
}

// Read a word of less than 64 letters. Returns what follows it; NULL where there is none.
static const char *read_word(const char *c, char word[64])
{
    c = glsl_skip_blanks(c);
    size_t length = glsl_word_length(c);
    if (length == 0 || length >= 64)
        return NULL;
    snprintf(word, 64, "%.*s", (int)length, c);
    return c + length;
}

// Type and first name of the declaration whose kind ends at c.
static bool read_first(struct declared *at, const char *c)
{
    at->end = c;
    do
        c = read_word(c, at->type);
    while (c != NULL && glsl_at_precision(at->type));
    at->after = c != NULL ? read_word(c, at->name) : NULL;
    return at->after != NULL;
}

// Another name of the same declaration.
static bool read_next(struct declared *at)
{
    const char *c = at->after != NULL ? glsl_skip_blanks(at->after) : "";
    const char *after = *c == ',' ? read_word(c + 1, at->name) : NULL;
    at->after = after != NULL ? after : at->after;
    return after != NULL;
}

// Go to the next name that is declared; false at the end.
static bool next_declared(struct walk *walk)
{
    struct declared *at = &walk->at;
    if (at->kind != NONE && read_next(at))
        return true;
    at->kind = NONE;
    while (*walk->c != '\0') {
        const char *c = walk->c;
        size_t length = glsl_word_length(c);
        bool fresh = walk->depth == 0 && walk->begins;
        enum kind kind = length > 0 && fresh ? kind_at(c) : NONE;
        bool qualifier = length > 0 && fresh && is_qualifier(c);
        if (length > 0 && fresh && (qualifier || kind != NONE) && at->begin == NULL)
            at->begin = c;
        if (qualifier && glsl_at_word(c, "layout")) {
            at->layout = c;
            length = strcspn(c, ")") + (strchr(c, ')') != NULL);
        }
        walk->c += length > 0 ? length : 1;
        walk->begins = (walk->begins && (qualifier || length == 0)) ||
                       (walk->depth == 0 && *c == ';') || (walk->depth == 1 && *c == '}');
        walk->depth += (*c == '{' || *c == '(') - (*c == '}' || *c == ')');
        if (kind != NONE && read_first(at, walk->c)) {
            at->kind = kind;
            return true;
        }
        if (!walk->begins || *c == ';' || *c == '}')
            at->begin = at->layout = NULL;
    }
    return false;
}

// A copy of the code without directives, to walk over; the caller frees it. NULL, reported.
static char *statements_of(const struct shader_source *source, const char *code)
{
    char *statements = strdup(code);
    if (statements == NULL)
        report("%s: not enough memory", source->files[0]);
    else
        glsl_blank_directives(statements);
    return statements;
}

// ---- Judgement ----

static const struct input *find_input(const struct declared *at)
{
    const struct input *inputs = at->kind == UNIFORM ? toy_inputs : whole_inputs;
    size_t count = at->kind == UNIFORM ? COUNT(toy_inputs) : COUNT(whole_inputs);
    for (size_t i = 0; i < count; i++)
        if (strcmp(at->name, inputs[i].name) == 0)
            return &inputs[i];
    return NULL;
}

static bool is_read(const struct declared *at)
{
    return glsl_find_word(at->after, at->name) != NULL;
}

// As is_read(), also in a macro, which may stand before.
//   code, statements  the same places, with directives and without
static bool is_mentioned(const char *code, const char *statements, const struct declared *at)
{
    const char *declared = code + (at->after - statements) - strlen(at->name);
    return glsl_find_word(code, at->name) < declared ||
           glsl_find_word(declared + 1, at->name) != NULL;
}

// Where a name is declared, for a message: the file, and in line the number.
static const char *where(const struct shader_source *source, const char *code,
                         const struct declared *at, int *line)
{
    const struct shader_line *from = form_line_at(source, code, at->after);
    *line = from->line;
    return source->files[from->file];
}

static void blank_text(struct shader_source *source, const char *code, const char *from,
                       const char *to)
{
    for (char *c = source->text + (from - code); c < source->text + (to - code); c++)
        if (*c != '\n')
            *c = ' ';
}

// Blank a layout that gives a location, where drivers look for the same in the vertex shader.
static void blank_location(struct shader_source *source, const char *code,
                           const struct declared *at)
{
    const char *end = at->layout != NULL ? strchr(at->layout, ')') : NULL;
    const char *location = end != NULL ? glsl_find_word(at->layout, "location") : NULL;
    if (location != NULL && location < end)
        blank_text(source, code, at->layout, end + 1);
}

// CustomToggle and CustomInt as whole numbers: a uniform that nobody sets is 0, as they are. There
// is room for the word where "flat in" stands.
static bool make_uniform(struct shader_source *source, const char *code, const struct declared *at)
{
    static const char word[] = "uniform";
    bool custom = strcmp(at->name, "CustomToggle") == 0 || strcmp(at->name, "CustomInt") == 0;
    char *text = source->text + (at->begin - code);
    if (!custom || (strcmp(at->type, "int") != 0 && strcmp(at->type, "uint") != 0) ||
        at->end - at->begin < (int)strlen(word) || memchr(text, '\n', strlen(word)) != NULL)
        return false;
    blank_text(source, code, at->begin, at->end);
    memcpy(text, word, sizeof word - 1);
    return true;
}

// Judge an input or a uniform: its type, and for the report's whether there is such a one.
static bool check_input(struct shader_source *source, const char *code, const struct declared *at)
{
    const struct input *input = find_input(at);
    const char *kind = kind_names[at->kind], *type = at->type, *name = at->name;
    int line;
    if (at->kind == IN)
        blank_location(source, code, at);
    if (input != NULL && strcmp(type, input->type) != 0) {
        if (make_uniform(source, code, at))
            return true;
        const char *file = where(source, code, at, &line);
        report("%s:%d: %s %s %s: %s is a %s here: write %s %s %s;", file, line, kind, type, name,
               name, input->type, kind, input->type, name);
        return false;
    }
    if (at->kind == UNIFORM &&
        (strstr(type, "sampler") != NULL || strncmp(name, "iChannel", strlen("iChannel")) == 0) &&
        is_read(at)) {
        form_refuse_name(source, code, at->after, name);
        return false;
    }
    if (input != NULL || at->kind == UNIFORM || strncmp(name, "gl_", 3) == 0 || !is_read(at))
        return true;
    const char *file = where(source, code, at, &line);
    report("%s:%d: in %s %s: there is no such input: there are FragCoord, Time, Ex, Ey, Ez, "
           "CamPos, fovValue, FacteurLargeur, OrthoView, CustomToggle and CustomInt",
           file, line, type, name);
    return false;
}

// What a whole file writes.
struct outputs {
    int count;
    struct declared shown;  // the one at location 0, or the first one
    struct declared second; // the first of the others
    bool placed;            // one is at location 0
};

// Where an #if stands around it, only the driver knows whether it is one.
static void add_output(struct outputs *outputs, const struct declared *at, const char *code,
                       const char *statements)
{
    bool counts = outputs->count < 2 || at->layout != NULL; // from the third on only a location
    if (!counts || !glsl_is_certain(code, (size_t)(at->after - statements)))
        return;
    const char *location = at->layout != NULL ? glsl_find_word(at->layout, "location") : NULL;
    int number = -1;
    if (location != NULL && location < at->begin + strcspn(at->begin, ";"))
        sscanf(location, "location = %d", &number);
    bool first = number == 0 || outputs->count == 0;
    if (outputs->count++ > 0 && (first || outputs->count == 2))
        outputs->second = first ? outputs->shown : *at;
    if (first)
        outputs->shown = *at;
    outputs->placed |= number == 0;
}

static bool check_outputs(struct shader_source *source, const char *code,
                          const struct outputs *outputs)
{
    const struct declared *shown = &outputs->shown;
    int line;
    if (outputs->count == 0)
        return true;
    const char *file = where(source, code, shown, &line);
    if (outputs->count > 1 && !outputs->placed) {
        file = where(source, code, &outputs->second, &line);
        report("%s:%d: out %s %s: a second output: write layout(location = 0) before the one that "
               "is the picture",
               file, line, outputs->second.type, outputs->second.name);
        return false;
    }
    if (strcmp(shown->type, "vec4") != 0 && strcmp(shown->type, "vec3") != 0) {
        report("%s:%d: out %s %s: a picture is made of colours: write out vec4 %s;", file, line,
               shown->type, shown->name, shown->name);
        return false;
    }
    if (outputs->count == 1)
        blank_location(source, code, shown);
    return true;
}

bool form_check_inputs(struct shader_source *source, const char *code)
{
    char *statements = statements_of(source, code);
    struct walk walk = {.c = statements, .begins = true};
    struct outputs outputs = {0};
    bool done = statements != NULL;
    while (done && next_declared(&walk)) {
        if (walk.at.kind == OUT)
            add_output(&outputs, &walk.at, code, statements);
        else
            done = check_input(source, statements, &walk.at);
    }
    if (done && source->form == SHADER_WHOLE)
        done = check_outputs(source, statements, &outputs);
    free(statements);
    return done;
}

// ---- What a driver takes and an author does not expect ----

// True when the code may write a colour that it does not declare in plain words.
static bool writes_otherwise(const char *code)
{
    int depth = 0;
    for (const char *c = code; *c != '\0'; c += glsl_word_length(c) > 0 ? glsl_word_length(c) : 1) {
        depth += (*c == '(') - (*c == ')');
        if (depth == 0 && glsl_at_word(c, "out"))
            return true;
    }
    return glsl_find_word(code, "gl_FragColor") != NULL ||
           glsl_find_word(code, "gl_FragData") != NULL;
}

static bool is_set(const struct declared *at)
{
    bool set = *glsl_skip_blanks(at->after) == '=' || find_input(at) != NULL ||
               strcmp(at->name, "CustomToggle") == 0 || strcmp(at->name, "CustomInt") == 0;
    for (size_t i = 0; i < COUNT(course_inputs); i++)
        set = set || strcmp(at->name, course_inputs[i]) == 0;
    return set;
}

static void warn_of_uniform(const struct shader_source *source, const char *statements,
                            const struct declared *at)
{
    int line;
    const char *file = where(source, statements, at, &line);
    report("%s:%d: warning: uniform %s %s is 0, for nothing sets it here: give it a value where it "
           "is declared; the time is iTime, the size iResolution",
           file, line, at->type, at->name);
}

bool form_check_linked(const struct shader_source *source, const char *code)
{
    char *statements = statements_of(source, code);
    struct walk walk = {.c = statements, .begins = true};
    bool done = statements != NULL, writes = writes_otherwise(code);
    struct outputs outputs = {0};
    while (done && next_declared(&walk)) {
        const struct declared *at = &walk.at;
        if (at->kind == UNIFORM && !is_set(at) && is_mentioned(code, statements, at))
            warn_of_uniform(source, statements, at);
        else if (at->kind == OUT && source->form == SHADER_WHOLE)
            add_output(&outputs, at, code, statements);
    }
    const struct declared *shown = &outputs.shown;
    if (outputs.count > 0 && !is_mentioned(code, statements, shown)) {
        int line;
        const char *file = where(source, statements, shown, &line);
        report("%s:%d: out %s %s: never gets a value: write %s = vec4(...); in main", file, line,
               shown->type, shown->name, shown->name);
        done = false;
    }
    if (done && !writes && source->form == SHADER_WHOLE)
        report("%s: writes no colour: declare out vec4 FragColor; and give it a value in main",
               source->files[0]);
    free(statements);
    return done && (writes || source->form != SHADER_WHOLE);
}
