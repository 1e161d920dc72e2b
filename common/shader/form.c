#include "shader/form.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "context/gl.h"
#include "shader/form_inputs.h"
#include "shader/form_zero.h"
#include "memory.h"
#include "report.h"

#define ARRAY_LIMIT 65536 // elements

// What Shadertoy gives besides and the harness does not, or not without --channel.
enum { TOY_CHANNELS = 5 };
static const char *const toy_refused[] = {
    "iChannel0",          "iChannel1",    "iChannel2",   "iChannel3",
    "iChannelResolution", "iChannelTime", "iSampleRate", NULL};

// ---- Which form ----

// The # of the #version, with which a text begins; or NULL.
static const struct glsl_token *version_of(const struct glsl *code)
{
    const struct glsl_token *t = code->item;
    while (t->kind >= GLSL_COMMENT)
        t++;
    return t->kind == GLSL_HASH && glsl_is(code, t + 1, "version") ? t : NULL;
}

// Blank a directive.
static void blank_directive(struct shader_source *source, const struct glsl_token *hash)
{
    form_blank(source, hash->begin, hash->begin + (int)strcspn(source->text + hash->begin, "\n"));
}

// Blank the #version, which the driver must not see, or the word compatibility in it.
//   only_es  leave one of desktop GLSL
// Returns false when it stays.
static bool blank_version(struct shader_source *source, bool only_es)
{
    const struct glsl *code = &source->code;
    const struct glsl_token *hash = version_of(code);
    if (hash == NULL || hash[2].kind != GLSL_NUMBER)
        return false;
    if (only_es && glsl_is(code, hash + 3, "compatibility"))
        form_blank(source, hash[3].begin, hash[3].begin + hash[3].length);
    if (only_es && !GL_IS_ES && !glsl_is(code, hash + 3, "es") && !glsl_is(code, hash + 2, "100"))
        return false;
    blank_directive(source, hash);
    return true;
}

// True when the file itself defines main and includes nothing: one that includes the course's
// library has its form. The vertex shader of the course has a main too, and stays as it is.
static bool has_own_main(const struct shader_source *source)
{
    return source->file_count == 1 && glsl_find_definition(&source->code, "main") != NULL &&
           glsl_mentions(&source->code, "gl_Position") == 0;
}

// Shadertoy's form gets a main in front, behind which no #extension may stand.
static void blank_extensions(struct shader_source *source)
{
    for (const struct glsl_token *t = source->code.item; t->kind != GLSL_END; t++)
        if (t->kind == GLSL_HASH && glsl_is(&source->code, t + 1, "extension"))
            blank_directive(source, t);
}

// A course file that --print-shader wrote begins with what form_prelude put there. That is blanked:
// the file is of the course's form again.
static bool blank_printed(struct shader_source *source)
{
    static const char first[] = "#version 330 core\n#define VIEW ";
    if (strncmp(source->text, first, strlen(first)) != 0 ||
        glsl_find_definition(&source->code, "rayColour") == NULL)
        return false;
    form_blank(source, 0, (int)(strlen(first) + strcspn(source->text + strlen(first), "\n")));
    return true;
}

// A course file gets its #version: one of its own would make it a whole file with a second main.
static bool check_version(const struct shader_source *source)
{
    const struct glsl_token *version = version_of(&source->code);
    for (int i = 1; i < source->file_count && version != NULL; i++)
        if (strcmp(source->files[i], "shaders/main.glsl") == 0)
            return shader_refuse(source, version->line,
                                 "take #version out: a file that includes main.glsl gets its own");
    return true;
}

// Refuse a text of nothing but comments, and an array whose number of elements, where it stands
// there, holds some drivers up for minutes. What hides behind constants and macros ends at the
// memory that guard_begin leaves to a driver.
static bool check_sense(const struct shader_source *source)
{
    const struct glsl *code = &source->code;
    bool any = false;
    for (const struct glsl_token *t = code->item; t->kind != GLSL_END && !any; t++)
        any = t->live && t->kind < GLSL_COMMENT;
    if (!any)
        return report("%s: holds nothing but comments: a shader is code", source->files[0]);
    for (const struct glsl_token *t = code->statement; t->kind != GLSL_END; t++) {
        const struct glsl_token *number = t + 1;
        if (t->sign == '[' && number->kind == GLSL_NUMBER && number[1].sign == ']' &&
            strtod(code->text + number->begin, NULL) > ARRAY_LIMIT)
            return shader_refuse(source, t->line,
                                 "an array of %.*s elements: a graphics processor has no room for "
                                 "it: %d at most",
                                 number->length < 20 ? number->length : 20,
                                 code->text + number->begin, ARRAY_LIMIT);
    }
    return true;
}

static bool refuse_image(const struct shader_source *source, const struct glsl_token *image)
{
    return shader_refuse(source, image->line,
                         "mainImage has other parameters than those it is called with: write void "
                         "mainImage(out vec4 fragColor, in vec2 fragCoord)");
}

// Pass over a parameter of a type; a colour is an out or an inout, a pixel no out.
static bool accept_parameter(const struct glsl *code, const struct glsl_token **t, const char *type,
                             bool colour)
{
    bool out = false, inout = false;
    for (;; ++*t) {
        static const char *const others[] = {"const", "in", "lowp", "mediump", "highp", NULL};
        if (glsl_is(code, *t, "out"))
            out = true;
        else if (glsl_is(code, *t, "inout"))
            inout = true;
        else if (!glsl_is_any(code, *t, others))
            break;
    }
    if (!glsl_is(code, *t, type))
        return false;
    *t += 1 + ((*t)[1].kind == GLSL_WORD);
    return colour ? out || inout : !out;
}

// Judge how mainImage is declared, in Shadertoy's form: drivers may link a call to nothing. One
// that a macro or an #if may change is taken.
static bool check_image(const struct shader_source *source)
{
    const struct glsl *code = &source->code;
    const struct glsl_token *wrong = NULL;
    const struct glsl_name *name = glsl_name(code, "mainImage");
    int seen = 0;
    for (const struct glsl_token *t = code->statement; t->kind != GLSL_END; t++) {
        if (t->kind != GLSL_WORD || &code->name[t->name] != name)
            continue;
        seen++;
        if (t->depth > 0 || t[1].sign != '(')
            continue;
        bool judged = t->certain && !t->macro;
        const struct glsl_token *end = glsl_partner(code, t + 1), *c = t + 2;
        for (const struct glsl_token *word = c; word < end; word++)
            judged &= !word->macro;
        if (!judged || (accept_parameter(code, &c, "vec4", true) && c->sign == ',' &&
                        (c++, accept_parameter(code, &c, "vec2", false)) && c == end))
            return true;
        wrong = wrong == NULL ? t : wrong;
    }
    return wrong == NULL || seen < name->count || refuse_image(source, wrong);
}

// Tell the form of an expanded text.
static bool find_form(struct shader_source *source)
{
    bool version = source->versioned;
    glsl_read(&source->code, source->text);
    const struct glsl *code = &source->code;
    bool printed = version && blank_printed(source);
    version = version && !printed;
    bool toy = glsl_mentions(code, "mainImage") > 0 && glsl_find_definition(code, "main") == NULL;
    bool whole = version || (!printed && has_own_main(source));
    bool blanked = version && blank_version(source, !toy);
    source->form = toy ? SHADER_SHADERTOY : whole ? SHADER_WHOLE : SHADER_COURSE;
    source->versioned = version && !blanked;
    if (toy)
        blank_extensions(source);
    if (!check_sense(source) || (version && !check_version(source)) ||
        (source->form != SHADER_COURSE && !form_check_inputs(source)) ||
        (toy && !check_image(source)))
        return false;
    glsl_free(&source->code);
    glsl_read(&source->code, source->text); // without what was blanked
    return true;
}

bool shader_read(struct shader_source *source, const char *path, const char *root)
{
    return shader_read_asked(source, path, root, NULL);
}

bool shader_read_asked(struct shader_source *source, const char *path, const char *root,
                       const struct shader_request *request)
{
    if (shader_expand(source, path, root, request) && find_form(source))
        return true;
    shader_free(source);
    return false;
}

// ---- Views ----

// The first SHADER_VIEW_COUNT of them can be chosen.
static const char *const view_names[SHADER_PROGRAM_COUNT] = {
    "picture", "normals", "depth", "steps",       "slice",
    "plot",    "probe",   "count", "coarse pass", "places"};

bool form_shows_ray(enum shader_view view)
{
    return view == SHADER_SLICE || view == SHADER_PLOT;
}

const char *shader_view_name(enum shader_view view)
{
    return view_names[view];
}

bool shader_view_from_name(const char *name, enum shader_view *view)
{
    for (int i = 0; i < SHADER_VIEW_COUNT; i++)
        if (strcmp(name, view_names[i]) == 0) {
            *view = (enum shader_view)i;
            return true;
        }
    return false;
}

bool shader_has_view(const struct shader_source *source, enum shader_view view)
{
    if (view == SHADER_PICTURE || source->form == SHADER_COURSE)
        return true;
    return report(
        "%s: cannot show the view %s: it has a main of its own, which records nothing of its rays: "
        "the chapters from 01 on have all views",
        source->files[0], shader_view_name(view));
}

// ---- What the driver gets ----

// The comma behind a parameter in the row of everything, or the bracket behind the last one.
static const struct glsl_token *behind(const struct glsl_token *parameter)
{
    while (parameter->kind != GLSL_END && !glsl_is_sign(parameter, ",)"))
        parameter++;
    return parameter;
}

// The first word in the brackets of mainImage where it is declared; of the one with two parameters
// where there are others. NULL where only a macro of the text declares it in other words.
static const struct glsl_token *parameters_of(const struct glsl *code)
{
    static const char *const colours[] = {"out", "inout", NULL};
    const struct glsl_token *other = NULL;
    for (const struct glsl_token *t = code->item; t->kind != GLSL_END; t++) {
        const struct glsl_token *first =
            t->live && glsl_is(code, t, "mainImage") ? form_colour(t) : NULL;
        if (first == NULL || !glsl_is_any(code, first, colours))
            continue;
        const struct glsl_token *comma = behind(first);
        if (comma->sign == ',' && behind(comma + 1)->sign == ')')
            return first;
        other = other == NULL ? first : other;
    }
    return other;
}

static char *toy_prelude(const struct shader_source *source)
{
    static const char begin[] = GL_GLSL_WITH(
        "#extension GL_ARB_shading_language_packing : enable\n") "#define HW_PERFORMANCE 1\n";
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
    const struct glsl *code = &source->code;
    char *prelude;
    FILE *stream = memory_open(&prelude);
    fputs(begin, stream);
    const char *name, *declaration, *way = "in";
    for (size_t i = 0; (declaration = form_toy_input(i, &name)) != NULL; i++)
        if (form_offers(source, name) && !form_declares(code, name))
            fprintf(stream, "uniform %s;\n", declaration);
    const struct glsl_token *parameters = parameters_of(code);
    const struct glsl_token *pixel = parameters != NULL ? behind(parameters) + 1 : code->item;
    if (parameters != NULL && glsl_is(code, pixel, "inout"))
        way = "inout";
    else if (parameters != NULL && glsl_is(code, pixel, "const"))
        way = "const in";
    // An out becomes an inout: form_zero.
    fprintf(stream, end, parameters != NULL ? "inout" : "out", way);
    memory_close(stream);
    return prelude;
}

char *form_prelude(const struct shader_source *source, enum shader_view view)
{
    if (source->form == SHADER_SHADERTOY)
        return toy_prelude(source);
    if (source->form == SHADER_COURSE)
        return memory_text(GL_GLSL "#define VIEW %d\n", (int)view);
    return memory_text("%s", source->versioned ? "" : GL_GLSL);
}

char *form_body(const struct shader_source *source)
{
    return source->form == SHADER_COURSE ? memory_text("%s", source->text) : form_zero(source);
}

bool form_refuses(const struct shader_source *source, const char *log, bool linking)
{
    const struct glsl *code = &source->code;
    bool toy = source->form == SHADER_SHADERTOY;
    for (int i = 0; toy && toy_refused[i] != NULL; i++) {
        bool blamed = strstr(log, toy_refused[i]) != NULL;
        bool offered = i < TOY_CHANNELS && form_offers(source, toy_refused[i]);
        const struct glsl_token *token =
            blamed && !offered ? glsl_find(code, toy_refused[i]) : NULL;
        if (token != NULL)
            return !form_refuse_name(source, token);
    }
    // A file without a main, or one that blames mainImage; the names of drivers' own differ.
    if (linking && toy && strstr(log, "mainImage") != NULL)
        return !refuse_image(source, glsl_find(code, "mainImage"));
    bool lacks = linking && !toy && glsl_mentions(code, "main") == 0;
    if (lacks)
        report("%s: draws no picture, for it has no main: write void main(), or mainImage as "
               "Shadertoy has it, or begin with #include \"main.glsl\" as the chapters do",
               source->files[0]);
    return lacks;
}

bool form_accepts(const struct shader_source *source)
{
    return source->form == SHADER_COURSE || form_check_linked(source);
}
