#include "shader/export.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "shader/form_inputs.h"
#include "shader/glsl.h"
#include "memory.h"
#include "report.h"

// One export under way.
struct export
{
    const struct shader_source *source;
    const struct parameters *parameters;
    struct camera_basis basis;
    const struct camera *camera;
    float focal_length;
    const struct glsl *code; // of the source
    FILE *text;              // what is written so far
};

// A number as GLSL ES has it: with a point or an exponent, the shortest that is the same float.
static void put_float(struct export *e, double value)
{
    char text[32];
    int digits = 1;
    do
        snprintf(text, sizeof text, "%.*g", digits, (double)(float)value);
    while (strtof(text, NULL) != (float)value && digits++ < 9);
    fprintf(e->text, "%s%s", text, strpbrk(text, ".e") == NULL ? ".0" : "");
}

static void put_vector(struct export *e, const double *value, int components)
{
    if (components > 1)
        fprintf(e->text, "vec%d(", components);
    for (int i = 0; i < components; i++) {
        fprintf(e->text, "%s", i > 0 ? ", " : "");
        put_float(e, value[i]);
    }
    if (components > 1)
        fprintf(e->text, ")");
}

static void put_floats(struct export *e, const float *value, int components)
{
    double all[3] = {0.0};
    for (int i = 0; i < components; i++)
        all[i] = (double)value[i];
    put_vector(e, all, components);
}

// ---- The course's form ----

// What only the harness needs: its main, the views and the probe.
static bool is_left_out(const char *file)
{
    static const char *const names[] = {
        "shaders/main.glsl", "shaders/views.glsl",  "shaders/ramp.glsl",  "shaders/slice.glsl",
        "shaders/plot.glsl", "shaders/places.glsl", "shaders/signs.glsl", "shaders/cover.glsl"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(file, names[i]) == 0)
            return true;
    return false;
}

static bool is_named(const struct export *e, const struct glsl_token *t, const char *const names[])
{
    return t->kind == GLSL_WORD && glsl_is_any(e->code, t, names);
}

// How often the lines that stay mention a word.
static int mentions(const struct export *e, const char *name)
{
    int count = 0;
    for (const struct glsl_token *t = e->code->item; t->kind != GLSL_END; t++)
        count += glsl_is(e->code, t, name) &&
                 !is_left_out(e->source->files[e->source->lines[t->line].file]);
    return count;
}

static void put_value(struct export *e, const struct parameter *parameter)
{
    if (parameter->type == PARAMETER_BOOL)
        fprintf(e->text, "%s", parameter->value[0] > 0.5 ? "true" : "false");
    else if (parameter->type == PARAMETER_INT)
        fprintf(e->text, "%d", (int)parameter->value[0]);
    else
        put_vector(e, parameter->value, parameter->components);
}

// Write the constant that stands for a uniform of the course, and the rest of its line; nothing
// where Shadertoy has it. Returns false for what is no such uniform.
static bool put_uniform(struct export *e, const struct glsl_token *uniform)
{
    static const char *const given[] = {"iResolution", "iTime", "iTimeDelta", "iFrame",
                                        "iMouse",      "iDate", NULL};
    // Shadertoy draws the picture in one part, with one sample.
    const struct constant {
        const char *name, *text;
        const float *vector;
    } constants[] = {{"iPixelOffset", "vec2(0.0)", NULL},
                     {"iSample", "0", NULL},
                     {"iSamples", "1", NULL},
                     {"iCameraPosition", NULL, e->camera->position},
                     {"iCameraRight", NULL, e->basis.right},
                     {"iCameraUp", NULL, e->basis.up},
                     {"iCameraForward", NULL, e->basis.forward}};
    const struct glsl_token *type = uniform + 1, *end = type;
    while (end->kind != GLSL_END && end->sign != ';')
        end++;
    if (type->kind != GLSL_WORD || type[1].kind != GLSL_WORD || is_named(e, type + 1, given))
        return type->kind == GLSL_WORD && type[1].kind == GLSL_WORD;
    char name[64];
    snprintf(name, sizeof name, "%.*s", GLSL_TEXT(e->code, type + 1));
    const struct constant *constant = NULL;
    for (size_t i = 0; i < sizeof constants / sizeof *constants; i++)
        if (strcmp(name, constants[i].name) == 0)
            constant = &constants[i];
    const struct parameter *parameter = parameters_find(e->parameters, name);
    if (constant != NULL && constant->text != NULL && mentions(e, name) == 1)
        return true; // its declaration
    if (parameter == NULL && constant == NULL)
        return false;
    int begin = uniform->begin + uniform->length;
    const char *text = e->code->text, *rest = text + end->begin;
    fprintf(e->text, "const%.*s = ", end->begin - begin, text + begin);
    if (constant == NULL)
        put_value(e, parameter);
    else if (constant->text != NULL)
        fprintf(e->text, "%s", constant->text);
    else
        put_floats(e, constant->vector, 3);
    fprintf(e->text, "%.*s\n", (int)strcspn(rest, "\n"), rest);
    return true;
}

// Begin a comment with the shader's name without its folder, which is that of this machine. A
// backslash at its end would draw the next line in.
static void put_name(struct export *e, const char *before)
{
    const char *path = e->source->files[0], *slash = strrchr(path, '/');
    fprintf(e->text, "%s", before);
    for (const char *c = slash != NULL ? slash + 1 : path; *c != '\0'; c++)
        fprintf(e->text, "%c", *c == '\\' ? '?' : *c);
}

// The lines that stay, each file under its name.
static void put_files(struct export *e)
{
    const struct shader_source *source = e->source;
    const char *line = source->text;
    const struct glsl_token *t = e->code->item;
    int file = -1;
    for (int i = 0; i < source->line_count; i++, line += strcspn(line, "\n") + 1) {
        int from = source->lines[i].file;
        const char *name = source->files[from];
        const struct glsl_token *uniform = NULL;
        for (; t->kind != GLSL_END && t->line == i; t++)
            uniform = uniform == NULL && glsl_is(e->code, t, "uniform") ? t : uniform;
        if (is_left_out(name))
            continue;
        if (from != file && from == 0)
            put_name(e, "\n// ---- ");
        else if (from != file)
            fprintf(e->text, "\n// ---- %s", name);
        if (from != file)
            fprintf(e->text, " ----\n\n");
        file = from;
        if (strncmp(line, "// #include", 11) != 0 && (uniform == NULL || !put_uniform(e, uniform)))
            fprintf(e->text, "%.*s\n", (int)strcspn(line, "\n"), line);
    }
}

static void put_course(struct export *e)
{
    put_name(e, "// ");
    fprintf(e->text,
            " for shadertoy.com, in one file: camera and parameters are constants here.\n");
    if (mentions(e, "VIEW") > 0)
        fprintf(e->text, "#define VIEW 0\n");
    if (mentions(e, "EXPORTED") > 0)
        fprintf(e->text, "#define EXPORTED\n");
    put_files(e);
    fprintf(e->text, "\n// ---- What Shadertoy calls ----\n\n"
                     "void mainImage(out vec4 fragColor, in vec2 fragCoord)\n"
                     "{\n"
                     "    traceReset(-1);\n"
                     "    iPixel = ivec2(floor(fragCoord));\n"
                     "    vec3 colour = rayColour(pixelRay(screenPosition(fragCoord)));\n"
                     "    fragColor = vec4(clamp(colour, 0.0, 1.0), 1.0);\n"
                     "}\n");
}

// ---- A whole file ----

// Shadertoy has a main, and calls mainImage: those of the file get other names. Qualifiers go where
// a global begins; those of parameters stay.
static const struct {
    const char *word, *instead;
    bool global;
} renamed[] = {{"main", "shaderMain", false},
               {"mainImage", "shaderImage", false},
               {"gl_FragColor", "shaderColour", false},
               {"in", "", true},
               {"out", "", true},
               {"varying", "", true},
               {"smooth", "", true},
               {"flat", "", true},
               {"noperspective", "", true},
               {"centroid", "", true}};

// What stands for a word of a whole file; NULL for the word itself.
static const char *instead_of(const struct export *e, const struct glsl_token *t)
{
    for (size_t i = 0; t->kind == GLSL_WORD && i < sizeof renamed / sizeof *renamed; i++)
        if (glsl_is(e->code, t, renamed[i].word) && (!renamed[i].global || t->depth == 0))
            return renamed[i].instead;
    return NULL;
}

// The last token of what begins here and is left out, what Shadertoy says itself or does not take:
// #version, the precision of numbers, layouts, its own uniforms, and the word before a uniform that
// has a value. NULL for what stays.
static const struct glsl_token *end_of_omission(const struct export *e, const struct glsl_token *t)
{
    const struct glsl *code = e->code;
    const struct glsl_token *end = t;
    bool layout = glsl_is(code, t, "layout"), uniform = glsl_is(code, t, "uniform");
    bool value = false, given = false;
    if (t->kind == GLSL_HASH && glsl_is(code, t + 1, "version")) {
        while (end[1].directive && end[1].kind < GLSL_COMMENT)
            end++;
        return end;
    }
    if (!layout && !uniform && !glsl_is(code, t, "precision"))
        return NULL;
    while (end[1].kind != GLSL_END && end->sign != (layout ? ')' : ';')) {
        end++;
        value |= end->sign == '=';
        const char *name;
        for (size_t i = 0; uniform && form_toy_input(i, &name) != NULL; i++)
            given |= glsl_is(code, end, name);
    }
    return !uniform || given ? end : value ? t : NULL;
}

// The text with its inputs and output as variables, comments as they are.
static void put_whole_text(struct export *e)
{
    const char *text = e->code->text;
    int from = (int)strspn(text, " \n");
    for (const struct glsl_token *t = e->code->item; t->kind != GLSL_END; t++) {
        const struct glsl_token *end = end_of_omission(e, t);
        const char *instead = end != NULL ? "" : instead_of(e, t);
        if (instead == NULL)
            continue;
        fprintf(e->text, "%.*s%s", t->begin - from, text + from, instead);
        t = end != NULL ? end : t;
        from = t->begin + t->length;
    }
    fprintf(e->text, "%s", text + from);
}

static void put_input(struct export *e, const char *name, const char *value)
{
    if (glsl_mentions(e->code, name) > 0 && !form_declares(e->code, name))
        fprintf(e->text, "    %s = %s;\n", name, value);
}

static void put_constant(struct export *e, const char *name, const float *value, int components)
{
    if (glsl_mentions(e->code, name) == 0)
        return;
    fprintf(e->text, "    %s = ", name);
    put_floats(e, value, components);
    fprintf(e->text, ";\n");
}

static bool put_whole(struct export *e)
{
    const struct glsl_token *output = form_output(e->code);
    bool old = output == NULL && glsl_mentions(e->code, "gl_FragColor") > 0;
    if (old)
        fprintf(e->text, "vec4 shaderColour;\n");
    put_whole_text(e);
    fprintf(e->text, "\n// ---- What Shadertoy calls ----\n\n"
                     "void mainImage(out vec4 toyColour, in vec2 toyPixel)\n{\n");
    put_input(e, "FragCoord", "(2.0 * toyPixel - iResolution.xy) / iResolution.y");
    put_input(e, "Time", "iTime");
    put_constant(e, "Ex", e->basis.right, 3);
    put_constant(e, "Ey", e->basis.up, 3);
    put_constant(e, "Ez", e->basis.forward, 3);
    put_constant(e, "CamPos", e->camera->position, 3);
    put_constant(e, "fovValue", &e->focal_length, 1);
    put_input(e, "FacteurLargeur", "iResolution.x / iResolution.y");
    static const char *const zeros[] = {"OrthoView", "CustomToggle", "CustomInt"};
    for (int i = 0; i < 3; i++)
        put_input(e, zeros[i], "0.0");
    fprintf(e->text, "    shaderMain();\n    toyColour = vec4(");
    if (output != NULL)
        fprintf(e->text, "%.*s", GLSL_TEXT(e->code, output));
    else
        fprintf(e->text, "shaderColour");
    fprintf(e->text, ".rgb, 1.0);\n}\n");
    return output != NULL || old ||
           report("%s: no output that Shadertoy could show: declare out vec4 FragColor;",
                  e->source->files[0]);
}

struct reader {
    const struct shader_source *source;
    const struct samplers *samplers;
};

static const char *picture_of(const void *reader, int i)
{
    const struct reader *r = reader;
    return r->source->files[r->samplers->item[i].file];
}

// A shader of the course that reads pictures.
static void refuse_textures(const struct shader_source *source, const struct samplers *samplers)
{
    const struct reader reader = {source, samplers};
    char *names = memory_list(samplers->count, picture_of, &reader);
    report("%s: reads %s: Shadertoy takes no files: leave =shadertoy out for a text that runs here",
           source->files[0], names);
    free(names);
}

char *export_shadertoy(const struct shader_source *source, const struct parameters *parameters,
                       const struct camera *camera, float focal_length)
{
    struct export e = {.source = source,
                       .parameters = parameters,
                       .basis = camera_basis_of(camera),
                       .camera = camera,
                       .focal_length = focal_length,
                       .code = &source->code};
    char *text;
    bool done = true;
    if (source->form == SHADER_COURSE && parameters->samplers.count > 0) {
        refuse_textures(source, &parameters->samplers);
        return NULL;
    }
    e.text = memory_open(&text);
    if (source->form == SHADER_SHADERTOY)
        fputs(source->text, e.text);
    else if (source->form == SHADER_COURSE)
        put_course(&e);
    else
        done = put_whole(&e);
    memory_close(e.text);
    if (done)
        return text;
    free(text);
    return NULL;
}
