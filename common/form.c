#include "form.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "glsl.h"
#include "report.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

// What Shadertoy gives besides and the harness does not.
static const char *const toy_refused[] = {"iChannel0",  "iChannel1",    "iChannel2",
                                          "iChannel3",  "iChannelTime", "iChannelResolution",
                                          "iSampleRate"};

static bool no_memory(const struct shader_source *source)
{
    report("%s: not enough memory", source->files[0]);
    return false;
}

// The text without comments; the caller frees it. NULL, reported.
static char *code_of(const struct shader_source *source)
{
    char *code = strdup(source->text);
    if (code == NULL)
        no_memory(source);
    else
        glsl_blank_comments(code, false);
    return code;
}

static const struct shader_line *line_at(const struct shader_source *source, const char *code,
                                         const char *place)
{
    int line = 0;
    for (const char *c = code; c < place; c++)
        line += *c == '\n';
    return &source->lines[line < source->line_count ? line : source->line_count - 1];
}

static const char *skip_blanks(const char *c)
{
    return c + strspn(c, " \t\n\v\f");
}

// ---- The inputs that a text declares ----

// Say that a name of Shadertoy's is not offered, which stands at a place in the code.
static void refuse_name(const struct shader_source *source, const char *code, const char *place,
                        const char *name)
{
    const struct shader_line *from = line_at(source, code, place);
    report("%s:%d: %s is not offered: a shader gets no textures, buffers or sounds here: compute "
           "the values in the shader",
           source->files[from->file], from->line, name);
}

struct input {
    const char *type, *name;
};

// Shadertoy's inputs. The harness fills them in by these names.
static const struct input toy_inputs[] = {
    {"vec3", "iResolution"}, {"float", "iTime"}, {"float", "iTimeDelta"}, {"int", "iFrame"},
    {"float", "iFrameRate"}, {"vec4", "iMouse"}, {"vec4", "iDate"}};

// The report's, which the vertex shader hands to a whole file.
static const struct input whole_inputs[] = {{"vec2", "FragCoord"},  {"float", "Time"},
                                            {"vec3", "Ex"},         {"vec3", "Ey"},
                                            {"vec3", "Ez"},         {"vec3", "CamPos"},
                                            {"float", "fovValue"},  {"float", "FacteurLargeur"},
                                            {"float", "OrthoView"}, {"float", "CustomToggle"},
                                            {"float", "CustomInt"}};

static bool is_word(const char *word, size_t length, const char *other)
{
    return strlen(other) == length && strncmp(word, other, length) == 0;
}

static const struct input *find_input(const struct input *inputs, size_t count, const char *name)
{
    for (size_t i = 0; i < count; i++)
        if (strcmp(name, inputs[i].name) == 0)
            return &inputs[i];
    return NULL;
}

// One name that a text declares as an input.
struct declared {
    const struct shader_source *source;
    const char *code;
    bool uniform;
    char type[64];
    char name[64];
    const char *after; // the name, in the code
};

// Judge a declared input: its type, and for the report's whether there is such a one.
static bool check_input(const struct declared *declared)
{
    const char *type = declared->type, *name = declared->name;
    const char *word = declared->uniform ? "uniform" : "in";
    const struct input *input = declared->uniform
                                    ? find_input(toy_inputs, COUNT(toy_inputs), name)
                                    : find_input(whole_inputs, COUNT(whole_inputs), name);
    const struct shader_line *from = line_at(declared->source, declared->code, declared->after);
    const char *file = declared->source->files[from->file];
    if (input != NULL && strcmp(type, input->type) != 0) {
        report("%s:%d: %s %s %s: %s is a %s here: write %s %s %s;", file, from->line, word, type,
               name, name, input->type, word, input->type, name);
        return false;
    }
    if (declared->uniform && strncmp(name, "iChannel", strlen("iChannel")) == 0 &&
        glsl_find_word(declared->after, name) != NULL) {
        refuse_name(declared->source, declared->code, declared->after, name);
        return false;
    }
    if (input != NULL || declared->uniform || glsl_find_word(declared->after, name) == NULL)
        return true;
    report("%s:%d: in %s %s: there is no such input: there are FragCoord, Time, Ex, Ey, Ez, "
           "CamPos, fovValue, FacteurLargeur, OrthoView, CustomToggle and CustomInt",
           file, from->line, type, name);
    return false;
}

// Read a word of less than 64 letters. Returns what follows it; NULL where there is none.
static const char *read_word(const char *c, char word[64])
{
    size_t length = 0;
    c = skip_blanks(c);
    while (glsl_is_word(c[length]))
        length++;
    if (length == 0 || length >= 64)
        return NULL;
    snprintf(word, 64, "%.*s", (int)length, c);
    return c + length;
}

// The names of one declaration: "in TYPE name, name".
//   c  after the word "in" or "uniform"
static bool check_declaration(const struct shader_source *source, const char *code, const char *c,
                              bool uniform)
{
    struct declared declared = {.source = source, .code = code, .uniform = uniform};
    do
        c = read_word(c, declared.type);
    while (c != NULL && strstr("lowp mediump highp", declared.type) != NULL);
    if (c != NULL)
        c = read_word(c, declared.name);
    while (c != NULL) {
        declared.after = c;
        if (!check_input(&declared))
            return false;
        c = skip_blanks(c);
        c = *c == ',' ? read_word(c + 1, declared.name) : NULL;
    }
    return true;
}

// Blank the preprocessor's lines, which end no statement.
static void blank_directives(char *code)
{
    bool joined = false;
    for (char *line = code; *line != '\0';) {
        size_t length = strcspn(line, "\n");
        bool blank = joined || line[strspn(line, " \t\v\f")] == '#';
        joined = blank && length > 0 && line[length - 1] == '\\';
        if (blank)
            memset(line, ' ', length);
        line += length + (line[length] == '\n');
    }
}

// Look at the beginning of each statement outside of braces and parentheses for "in" and "uniform".
static bool check_inputs(const struct shader_source *source, char *code)
{
    int depth = 0;
    bool begins = true;
    blank_directives(code);
    for (const char *c = code; *c != '\0';) {
        size_t length = 0;
        while (glsl_is_word(c[length]))
            length++;
        bool input = is_word(c, length, "in") || is_word(c, length, "varying");
        bool uniform = is_word(c, length, "uniform");
        if (depth == 0 && begins && (input || uniform) &&
            !check_declaration(source, code, c + length, uniform))
            return false;
        // Qualifiers may stand before the word, everything else may not.
        static const char *const before[] = {"flat", "smooth", "noperspective", "centroid",
                                             "layout"};
        bool qualifier = length == 0;
        for (size_t i = 0; i < COUNT(before); i++)
            qualifier = qualifier || is_word(c, length, before[i]);
        begins = (begins && qualifier) || (depth == 0 && *c == ';') || (depth == 1 && *c == '}');
        depth += (*c == '{' || *c == '(') - (*c == '}' || *c == ')');
        c += length > 0 ? length : 1;
    }
    return true;
}

// ---- Which form ----

// Blank the #version, which the driver must not see.
//   only_es  leave one of desktop GLSL
// Returns false when it stays.
static bool blank_version(struct shader_source *source, const char *code, bool only_es)
{
    const char *hash = strchr(code, '#');
    char number[16] = "", profile[16] = "";
    if (hash == NULL || sscanf(hash, "# version %15[0-9] %15[a-z]", number, profile) < 1)
        return false;
    if (only_es && strcmp(profile, "es") != 0 && strcmp(number, "100") != 0)
        return false;
    memset(source->text + (hash - code), ' ', strcspn(hash, "\n"));
    return true;
}

bool form_find(struct shader_source *source, bool version)
{
    char *code = code_of(source);
    if (code == NULL)
        return false;
    bool toy = glsl_find_word(code, "mainImage") != NULL && !glsl_defines(code, "main");
    bool blanked = version && blank_version(source, code, !toy);
    source->form = toy ? SHADER_SHADERTOY : version ? SHADER_WHOLE : SHADER_COURSE;
    source->versioned = version && !blanked;
    bool done = source->form == SHADER_COURSE || check_inputs(source, code);
    free(code);
    return done;
}

// ---- What the driver gets ----

// True when the code declares a uniform of this name itself.
static bool declares(const char *code, const char *name)
{
    const char *word = glsl_find_word(code, "uniform");
    while (word != NULL) {
        const char *found = glsl_find_word(word, name);
        if (found != NULL && found < word + strcspn(word, ";"))
            return true;
        word = glsl_find_word(word + 1, "uniform");
    }
    return false;
}

// mainImage may take its colour as inout.
static bool takes_inout(const char *code)
{
    const char *open = glsl_find_word(code, "mainImage");
    open = open != NULL ? skip_blanks(open + strlen("mainImage")) : "";
    return *open == '(' && strncmp(skip_blanks(open + 1), "inout", 5) == 0;
}

static char *toy_prelude(const struct shader_source *source)
{
    enum { SIZE = 2048 };
    static const char begin[] = "#version 330 core\n"
                                "#extension GL_ARB_shading_language_packing : enable\n"
                                "#define HW_PERFORMANCE 1\n";
    static const char end[] =
        "uniform vec2 harnessPixelOffset;\n"
        "out vec4 harnessColour;\n"
        "vec4 harnessFragCoord;\n"
        "void mainImage(%s vec4 colour, in vec2 pixel);\n"
        "void main()\n"
        "{\n"
        "    vec4 colour = vec4(0.0, 0.0, 0.0, 1.0);\n"
        "    harnessFragCoord = gl_FragCoord + vec4(harnessPixelOffset, 0.0, 0.0);\n"
        "    mainImage(colour, harnessFragCoord.xy);\n"
        "    harnessColour = vec4(clamp(colour.rgb, 0.0, 1.0), 1.0);\n"
        "}\n";
    char *code = code_of(source), *prelude = code != NULL ? malloc(SIZE) : NULL;
    if (code != NULL && prelude == NULL)
        no_memory(source);
    if (prelude != NULL) {
        int size = snprintf(prelude, SIZE, "%s", begin);
        for (size_t i = 0; i < COUNT(toy_inputs); i++)
            if (!declares(code, toy_inputs[i].name))
                size += snprintf(prelude + size, (size_t)(SIZE - size), "uniform %s %s;\n",
                                 toy_inputs[i].type, toy_inputs[i].name);
        snprintf(prelude + size, (size_t)(SIZE - size), end, takes_inout(code) ? "inout" : "out");
    }
    free(code);
    return prelude;
}

char *form_prelude(const struct shader_source *source, enum shader_view view)
{
    if (source->form == SHADER_SHADERTOY)
        return toy_prelude(source);
    char text[64] = "";
    if (source->form == SHADER_COURSE)
        snprintf(text, sizeof text, "#version 330 core\n#define VIEW %d\n", (int)view);
    else if (!source->versioned)
        snprintf(text, sizeof text, "#version 330 core\n");
    char *prelude = strdup(text);
    if (prelude == NULL)
        no_memory(source);
    return prelude;
}

// The words that the driver gets in other words.
static const struct {
    enum shader_form form;
    const char *word, *instead;
} replaced[] = {{SHADER_SHADERTOY, "gl_FragCoord", "harnessFragCoord"},
                {SHADER_WHOLE, "smooth", ""},
                {SHADER_WHOLE, "flat", ""},
                {SHADER_WHOLE, "noperspective", ""},
                {SHADER_WHOLE, "centroid", ""}};

// Copy a text with every whole word replaced. Returns NULL without memory; frees the text.
static char *replace_word(char *text, const char *word, const char *instead)
{
    size_t count = 0;
    for (const char *c = text; (c = strstr(c, word)) != NULL; c++)
        count++;
    char *body = malloc(strlen(text) + count * strlen(instead) + 1), *to = body;
    const char *from = text;
    if (body != NULL) {
        for (const char *c; (c = glsl_find_word(from, word)) != NULL; from = c + strlen(word))
            to += sprintf(to, "%.*s%s", (int)(c - from), from, instead);
        memcpy(to, from, strlen(from) + 1);
    }
    free(text);
    return body;
}

char *form_body(const struct shader_source *source)
{
    char *body = strdup(source->text);
    for (size_t i = 0; i < COUNT(replaced) && body != NULL; i++)
        if (replaced[i].form == source->form && strstr(body, replaced[i].word) != NULL)
            body = replace_word(body, replaced[i].word, replaced[i].instead);
    if (body == NULL)
        no_memory(source);
    return body;
}

bool form_refuses(const struct shader_source *source, const char *log)
{
    if (source->form != SHADER_SHADERTOY)
        return false;
    for (size_t i = 0; i < COUNT(toy_refused); i++) {
        char *code = glsl_find_word(log, toy_refused[i]) != NULL ? code_of(source) : NULL;
        const char *place = code != NULL ? glsl_find_word(code, toy_refused[i]) : NULL;
        if (place != NULL)
            refuse_name(source, code, place, toy_refused[i]);
        free(code);
        if (place != NULL)
            return true;
    }
    return false;
}
