#include "shader/sampler.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "number.h"
#include "report.h"
#include "shader/annotation.h"

#define EXAMPLE2 "uniform sampler2D NAME; // \"stone.png\" sRGB repeat: meaning"
#define EXAMPLE3 "uniform sampler3D NAME; // \"noise.png\" linear repeat 64: meaning"

// One annotated sampler being read.
struct reading {
    struct annotation a;
    struct sampler sampler;
    char file[256];
};

void samplers_free(struct samplers *samplers)
{
    free(samplers->item);
    *samplers = (struct samplers){0};
}

static bool has_name(const struct samplers *samplers, const char *name, size_t length)
{
    for (int i = 0; i < samplers->count; i++)
        if (strlen(samplers->item[i].name) == length &&
            strncmp(samplers->item[i].name, name, length) == 0)
            return true;
    return false;
}

static const char *name_of(const void *samplers, int i)
{
    return ((const struct samplers *)samplers)->item[i].name;
}

// Judge NAME=FILE.
static bool know(const struct samplers *samplers, bool course, const char *assignment)
{
    if (course && has_name(samplers, assignment, strcspn(assignment, "=")))
        return true;
    char *names = memory_list(samplers->count, name_of, samplers);
    if (!course)
        report("--texture %s: the shader is not of the course's form: --channel N=FILE.png is for "
               "iChannelN",
               assignment);
    else if (samplers->count == 0)
        report("--texture %s: this shader has no textures", assignment);
    else
        report("--texture %s: no sampler has this name: there %s %s", assignment,
               samplers->count == 1 ? "is" : "are", names);
    free(names);
    return false;
}

bool samplers_fit(const struct samplers *samplers, const struct shader_source *source)
{
    const struct shader_request *request = &source->request;
    bool course = source->form == SHADER_COURSE;
    for (int i = 0; i < request->texture_count; i++)
        if (!know(samplers, course, request->textures[i]))
            return false;
    for (int i = 0; request->channels != NULL && i < 4; i++) {
        char name[] = "iChannel0";
        name[strlen(name) - 1] = (char)('0' + i);
        if (request->channels[i] == NULL || (!course && glsl_mentions(&source->code, name) > 0))
            continue;
        return report("--channel %d=%s: %s%s", i, request->channels[i],
                      course ? "the shader is of the course's form: --texture NAME=FILE.png is for "
                               "its samplers"
                             : "the shader does not mention ",
                      course ? "" : name);
    }
    return true;
}

bool sampler_refuse(const struct shader_source *source, const struct sampler *sampler,
                    const char *format, ...)
{
    char why[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(why, sizeof why, format, arguments);
    va_end(arguments);
    return sampler->line < 0 ? report("--channel %s=%s: %s", sampler->name + strlen("iChannel"),
                                      source->files[sampler->file], why)
                             : shader_refuse(source, sampler->line, "sampler %s: %s: %s",
                                             sampler->name, source->files[sampler->file], why);
}

// ---- The comment ----

// Read one of two words.
//   what  what the first and the second one are for
static bool read_choice(struct annotation *a, const char *first, const char *second,
                        const char *what, bool *is_first)
{
    *is_first = annotation_accept_word(a, first);
    if (*is_first || annotation_accept_word(a, second))
        return true;
    size_t length = strcspn(a->c, ANNOTATION_BLANKS ":");
    return length == 0
               ? annotation_refuse(a, "%s or %s is missing: %s", first, second, what)
               : annotation_refuse(a, "'%.*s' is not understood: write %s or %s: %s",
                                   (int)(length < 20 ? length : 20), a->c, first, second, what);
}

static bool read_slices(struct annotation *a, struct sampler *sampler, bool volume)
{
    double value = 0.0;
    size_t length = number_begin(a->c, &value);
    a->c += length;
    if (!volume)
        return length == 0 || annotation_refuse(a, "a sampler2D has no slices: a volume is a "
                                                   "sampler3D");
    if (length == 0)
        return annotation_refuse(a, "a volume needs the number of its slices: write as in \"%s\"",
                                 a->example);
    if (!(value >= 1.0 && value <= SAMPLER_SLICES && value == (double)(int)value))
        return annotation_refuse(a, "the number of slices must be a whole one from 1 to %d",
                                 SAMPLER_SLICES);
    sampler->slices = (int)value;
    return true;
}

static bool read_annotation(struct reading *reading, bool volume)
{
    struct annotation *a = &reading->a;
    if (!annotation_accept(a, '"'))
        return annotation_refuse(a, "no picture is named: write as in \"%s\"", a->example);
    size_t length = strcspn(a->c, "\"");
    if (a->c[length] == '\0')
        return annotation_refuse(a, "the file's name is not closed: write as in \"%s\"",
                                 a->example);
    if (!annotation_copy(a, "file", reading->file, sizeof reading->file, length))
        return false;
    a->c++;
    if (!read_choice(a, "sRGB", "linear", "a colour is sRGB, a number linear",
                     &reading->sampler.srgb) ||
        !read_choice(a, "repeat", "clamp", "a picture repeats, or its edge goes on",
                     &reading->sampler.repeat) ||
        !read_slices(a, &reading->sampler, volume))
        return false;
    if (!annotation_accept(a, ':') && *a->c != '\0')
        return annotation_refuse(a, "'%.20s' is not understood: write as in \"%s\"", a->c,
                                 a->example);
    return annotation_copy(a, "meaning", reading->sampler.meaning, sizeof reading->sampler.meaning,
                           strlen(a->c));
}

// ---- The file ----

// The FILE of --texture NAME=FILE, the last one; NULL for none.
static const char *other_file(const struct shader_source *source, const char *name)
{
    const struct shader_request *request = &source->request;
    size_t length = strlen(name);
    for (int i = request->texture_count - 1; i >= 0; i--)
        if (strncmp(request->textures[i], name, length) == 0 && request->textures[i][length] == '=')
            return request->textures[i] + length + 1;
    return NULL;
}

static bool find_file(struct reading *reading, struct shader_source *source)
{
    char why[TEXT_FILE_WHY];
    struct sampler *sampler = &reading->sampler;
    const char *other = other_file(source, sampler->name);
    sampler->file = other != NULL ? shader_take_texture(source, other, why)
                                  : shader_find_texture(source, source->lines[sampler->line].file,
                                                        reading->file, why);
    return sampler->file >= 0 ||
           annotation_refuse(&reading->a, "%s: %s", other != NULL ? other : reading->file, why);
}

// ---- The text ----

static void add(struct samplers *samplers, const struct sampler *sampler)
{
    samplers->item = memory_row(samplers->item, samplers->count, sizeof *samplers->item);
    samplers->item[samplers->count++] = *sampler;
}

// The type that a uniform has, where it is a sampler of any kind; else NULL.
static const struct glsl_token *sampler_type(const struct glsl *code,
                                             const struct glsl_token *uniform)
{
    const struct glsl_token *t = uniform + 1;
    while (t->kind >= GLSL_COMMENT || glsl_is_precision(code, t))
        t++;
    char type[ANNOTATION_NAME] = "";
    if (t->kind == GLSL_WORD && t->length < ANNOTATION_NAME)
        snprintf(type, sizeof type, "%.*s", GLSL_TEXT(code, t));
    return strstr(type, "sampler") != NULL ? t : NULL;
}

static bool read_sampler(struct samplers *samplers, struct shader_source *source,
                         const struct glsl_token *uniform, const struct glsl_token *type)
{
    const struct glsl *code = &source->code;
    struct reading reading = {.sampler = {.line = uniform->line}};
    struct annotation *a = &reading.a;
    bool volume = glsl_is(code, type, "sampler3D");
    if (glsl_is(code, type + 1, "iMarch") || glsl_is(code, type + 1, "iCoarse") ||
        glsl_is(code, type + 1, "iSigns"))
        return true; // the harness's own: tables of the slice, of the coarse pass, of letters
    annotation_begin(a, source, uniform);
    a->what = "sampler";
    a->example = volume ? EXAMPLE3 : EXAMPLE2;
    bool done = annotation_declaration(a, uniform);
    if (done && !volume && !glsl_is(code, type, "sampler2D"))
        done = annotation_refuse(
            a,
            "the type %.*s cannot be filled in: use sampler2D, or sampler3D for a "
            "volume",
            GLSL_TEXT(code, type));
    memcpy(reading.sampler.name, a->name, sizeof reading.sampler.name);
    done = done && read_annotation(&reading, volume);
    if (done && has_name(samplers, a->name, strlen(a->name)))
        done = annotation_refuse(a, "is declared twice: take one declaration out");
    done = done && find_file(&reading, source);
    if (done)
        add(samplers, &reading.sampler);
    free(a->words);
    return done;
}

// Those of --channel, read as Shadertoy reads a picture unless told otherwise.
static bool read_channels(struct samplers *samplers, struct shader_source *source)
{
    const char *const *channels = source->request.channels;
    char why[TEXT_FILE_WHY];
    for (int i = 0; channels != NULL && i < 4; i++) {
        if (channels[i] == NULL)
            continue;
        struct sampler sampler = {.line = -1, .repeat = true};
        snprintf(sampler.name, sizeof sampler.name, "iChannel%d", i);
        sampler.file = shader_take_texture(source, channels[i], why);
        if (sampler.file < 0)
            return report("--channel %d=%s: %s", i, channels[i], why);
        add(samplers, &sampler);
    }
    return true;
}

// True for a type that would declare a sampler in a structure or a macro, which no picture fills
// in. A parameter of a function is another's sampler.
static bool is_hidden(const struct glsl *code, const struct glsl_token *type)
{
    static const char *const types[] = {"sampler2D", "sampler3D", NULL};
    static const char *const parameter[] = {"in", "const", "precision", NULL};
    const struct glsl_token *t = type - 1;
    if (!type->live || !glsl_is_any(code, type, types))
        return false;
    while (t >= code->item && (t->kind >= GLSL_COMMENT || glsl_is_precision(code, t)))
        t--;
    return t < code->item ||
           !(t->sign == '(' || t->sign == ',' || glsl_is_any(code, t, parameter) ||
             (!type->directive && glsl_is(code, t, "uniform")));
}

bool samplers_read(struct samplers *samplers, struct shader_source *source)
{
    const struct glsl *code = &source->code;
    *samplers = (struct samplers){0};
    bool course = source->form == SHADER_COURSE;
    bool done = course || read_channels(samplers, source);
    for (const struct glsl_token *t = code->item; course && done && t->kind != GLSL_END; t++) {
        const struct glsl_token *type =
            t->live && !t->directive && glsl_is(code, t, "uniform") ? sampler_type(code, t) : NULL;
        done = type == NULL || read_sampler(samplers, source, t, type);
        if (done && is_hidden(code, t))
            done = shader_refuse(
                source, t->line,
                "a %.*s must be a uniform of its own, in no structure or macro: write as in \"%s\"",
                GLSL_TEXT(code, t), glsl_is(code, t, "sampler3D") ? EXAMPLE3 : EXAMPLE2);
    }
    if (!done)
        samplers_free(samplers);
    return done;
}

// ---- The table ----

void samplers_print(const struct samplers *samplers, const struct shader_source *source, FILE *file)
{
    int name = (int)strlen("texture"), path = (int)strlen("file");
    for (int i = 0; i < samplers->count; i++) {
        const struct sampler *sampler = &samplers->item[i];
        int wide[2] = {(int)strlen(sampler->name), (int)strlen(source->files[sampler->file])};
        name = wide[0] > name ? wide[0] : name;
        path = wide[1] > path ? wide[1] : path;
    }
    if (samplers->count > 0)
        fprintf(file, "\n%-*s  %-*s  colour  edge    slices  meaning\n", name, "texture", path,
                "file");
    for (int i = 0; i < samplers->count; i++) {
        const struct sampler *sampler = &samplers->item[i];
        char slices[16] = "-";
        if (sampler->slices > 0)
            snprintf(slices, sizeof slices, "%d", sampler->slices);
        fprintf(file, "%-*s  %-*s  %-6s  %-6s  %-6s  %s\n", name, sampler->name, path,
                source->files[sampler->file], sampler->srgb ? "sRGB" : "linear",
                sampler->repeat ? "repeat" : "clamp", slices, sampler->meaning);
    }
}
