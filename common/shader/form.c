#include "shader/form.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "shader/form_inputs.h"
#include "shader/form_zero.h"
#include "shader/glsl.h"
#include "report.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

#define ARRAY_LIMIT 65536 // elements

// What Shadertoy gives besides and the harness does not.
static const char *const toy_refused[] = {"iChannel0",  "iChannel1",    "iChannel2",
                                          "iChannel3",  "iChannelTime", "iChannelResolution",
                                          "iSampleRate"};

static bool no_memory(const struct shader_source *source)
{
    report("%s: not enough memory", source->files[0]);
    return false;
}

// The text without comments and without what the preprocessor leaves out; the caller frees it.
// NULL, reported.
static char *code_of(const struct shader_source *source)
{
    char *code = strdup(source->text);
    if (code == NULL) {
        no_memory(source);
    } else {
        glsl_blank_comments(code, false);
        glsl_blank_inactive(code);
    }
    return code;
}

// ---- Which form ----

// Blank the #version, which the driver must not see, or the word compatibility in it.
//   only_es  leave one of desktop GLSL
// Returns false when it stays.
static bool blank_version(struct shader_source *source, const char *code, bool only_es)
{
    const char *hash = strchr(code, '#');
    char number[16] = "", profile[16] = "";
    if (hash == NULL || sscanf(hash, "# version %15[0-9] %15[a-z]", number, profile) < 1)
        return false;
    char *version = source->text + (hash - code);
    if (only_es && strcmp(profile, "compatibility") == 0)
        memset(strstr(version, profile), ' ', strlen(profile));
    if (only_es && strcmp(profile, "es") != 0 && strcmp(number, "100") != 0)
        return false;
    memset(version, ' ', strcspn(version, "\n"));
    return true;
}

// Refuse what no driver answers well: a text of comments, and arrays at which some run for minutes
// and out of memory.
static bool check_sense(const struct shader_source *source, const char *code)
{
    if (*glsl_skip_blanks(code) == '\0') {
        report("%s: holds nothing but comments: a shader is code", source->files[0]);
        return false;
    }
    for (const char *c = strchr(code, '['); c != NULL; c = strchr(c + 1, '[')) {
        const char *number = glsl_skip_blanks(c + 1);
        size_t digits = strspn(number, "0123456789");
        if (*glsl_skip_blanks(number + digits) != ']' || strtod(number, NULL) <= ARRAY_LIMIT)
            continue;
        const struct shader_line *from = form_line_at(source, code, c);
        report("%s:%d: an array of %.*s elements: a graphics processor has no room for it: %d at "
               "most",
               source->files[from->file], from->line, digits < 20 ? (int)digits : 20, number,
               ARRAY_LIMIT);
        return false;
    }
    return true;
}

// True when the file itself defines main and includes nothing: one that includes the course's
// library has its form. The vertex shader of the course has a main too, and stays as it is.
static bool has_own_main(const struct shader_source *source, const char *code)
{
    return source->file_count == 1 && glsl_find_definition(code, "main") != NULL &&
           glsl_find_word(code, "gl_Position") == NULL;
}

// Shadertoy's form gets a main in front, behind which no #extension may stand.
static void blank_extensions(struct shader_source *source, const char *code)
{
    for (const char *line = code; *line != '\0'; line += strcspn(line, "\n") + 1) {
        const char *hash = line + strspn(line, " \t\v\f");
        const char *word = *hash == '#' ? hash + 1 + strspn(hash + 1, " \t\v\f") : "";
        if (glsl_at_word(word, "extension"))
            memset(source->text + (hash - code), ' ', strcspn(hash, "\n"));
    }
}

// A course file that --print-shader wrote begins with what form_prelude put there. That is blanked:
// the file is of the course's form again.
static bool blank_printed(struct shader_source *source, char *code)
{
    static const char first[] = "#version 330 core\n#define VIEW ";
    if (strncmp(code, first, strlen(first)) != 0 || glsl_find_definition(code, "rayColour") == NULL)
        return false;
    size_t line = strcspn(code, "\n"), end = line + 1 + strcspn(code + line + 1, "\n");
    for (size_t i = 0; i < end; i++)
        if (i != line) // the line ends stay
            source->text[i] = code[i] = ' ';
    return true;
}

bool form_find(struct shader_source *source, bool version)
{
    char *code = code_of(source);
    if (code == NULL)
        return false;
    bool printed = version && blank_printed(source, code);
    version = version && !printed;
    bool toy =
        glsl_find_word(code, "mainImage") != NULL && glsl_find_definition(code, "main") == NULL;
    bool whole = version || (!printed && has_own_main(source, code));
    bool blanked = version && blank_version(source, code, !toy);
    source->form = toy ? SHADER_SHADERTOY : whole ? SHADER_WHOLE : SHADER_COURSE;
    source->versioned = version && !blanked;
    if (toy)
        blank_extensions(source, code);
    bool done = check_sense(source, code) &&
                (source->form == SHADER_COURSE || form_check_inputs(source, code));
    free(code);
    return done;
}

// ---- What the driver gets ----

// What stands in the parentheses of mainImage where it is declared, to its end; of the one with two
// parameters where there are others. NULL where only a macro of the text declares it.
static const char *parameters_of(const char *code)
{
    const char *other = NULL;
    for (const char *c = code; (c = glsl_find_word(c, "mainImage")) != NULL;) {
        c = glsl_skip_blanks(c + strlen("mainImage"));
        const char *first = *c == '(' ? glsl_skip_blanks(c + 1) : "";
        if (!glsl_at_word(first, "out") && !glsl_at_word(first, "inout"))
            continue;
        const char *comma = first + strcspn(first, ",)");
        if (*comma == ',' && comma[1 + strcspn(comma + 1, ",)")] == ')')
            return first;
        other = other == NULL ? first : other;
    }
    return other;
}

// How mainImage takes its pixel: the words before the parameter.
static const char *pixel_way(const char *parameters)
{
    const char *c = parameters != NULL ? parameters + strcspn(parameters, ",)") : "";
    c = glsl_skip_blanks(c + (*c == ','));
    return glsl_at_word(c, "inout") ? "inout" : glsl_at_word(c, "const") ? "const in" : "in";
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
        "void mainImage(%s vec4 colour, %s vec2 pixel);\n"
        "void main()\n"
        "{\n"
        "    vec4 colour = vec4(0.0);\n"
        "    harnessFragCoord = gl_FragCoord + vec4(harnessPixelOffset, 0.0, 0.0);\n"
        "    vec2 pixel = harnessFragCoord.xy;\n"
        "    mainImage(colour, pixel);\n"
        "    harnessColour = vec4(clamp(colour.rgb, 0.0, 1.0), 1.0);\n"
        "}\n";
    char *code = code_of(source), *prelude = code != NULL ? malloc(SIZE) : NULL;
    if (code != NULL && prelude == NULL)
        no_memory(source);
    if (prelude != NULL) {
        int size = snprintf(prelude, SIZE, "%s", begin);
        const char *name, *declaration;
        for (size_t i = 0; (declaration = form_toy_input(i, &name)) != NULL; i++)
            if (!form_declares(code, name))
                size +=
                    snprintf(prelude + size, (size_t)(SIZE - size), "uniform %s;\n", declaration);
        // An out becomes an inout: form_zero.
        const char *parameters = parameters_of(code);
        snprintf(prelude + size, (size_t)(SIZE - size), end, parameters != NULL ? "inout" : "out",
                 pixel_way(parameters));
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
    char *code = source->form != SHADER_COURSE ? code_of(source) : NULL;
    char *body = code != NULL                    ? form_zero(source->text, code)
                 : source->form == SHADER_COURSE ? strdup(source->text)
                                                 : NULL;
    free(code);
    for (size_t i = 0; i < COUNT(replaced) && body != NULL; i++)
        if (replaced[i].form == source->form && strstr(body, replaced[i].word) != NULL)
            body = replace_word(body, replaced[i].word, replaced[i].instead);
    if (body == NULL)
        no_memory(source);
    return body;
}

// Blame a text in which the linker finds no main, or another mainImage than is called.
static bool refuses_main(const struct shader_source *source, const char *code)
{
    const char *main = glsl_find_word(code, "main"), *image = glsl_find_word(code, "mainImage");
    if (source->form == SHADER_SHADERTOY) {
        const struct shader_line *from = form_line_at(source, code, image);
        report("%s:%d: mainImage has other parameters than those it is called with: write void "
               "mainImage(out vec4 fragColor, in vec2 fragCoord)",
               source->files[from->file], from->line);
    } else if (main == NULL) {
        report("%s: draws no picture, for it has no main: write void main(), or mainImage as "
               "Shadertoy has it, or begin with #include \"main.glsl\" as the chapters do",
               source->files[0]);
    }
    return source->form == SHADER_SHADERTOY || main == NULL;
}

bool form_refuses(const struct shader_source *source, const char *log, bool linking)
{
    char *code = code_of(source);
    bool refused = false;
    for (size_t i = 0; i < COUNT(toy_refused) && code != NULL && !refused; i++) {
        const char *place =
            source->form == SHADER_SHADERTOY && glsl_find_word(log, toy_refused[i]) != NULL
                ? glsl_find_word(code, toy_refused[i])
                : NULL;
        if (place != NULL)
            form_refuse_name(source, code, place, toy_refused[i]);
        refused = place != NULL;
    }
    // A file without a main, or one that blames mainImage; the names of drivers' own differ.
    if (!refused && code != NULL && linking &&
        (source->form != SHADER_SHADERTOY || glsl_find_word(log, "mainImage") != NULL))
        refused = refuses_main(source, code);
    free(code);
    return refused;
}

bool form_accepts(const struct shader_source *source)
{
    char *code = source->form != SHADER_COURSE ? code_of(source) : NULL;
    bool accepted =
        source->form == SHADER_COURSE || (code != NULL && form_check_linked(source, code));
    free(code);
    return accepted;
}
