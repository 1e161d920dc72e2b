#include "shader/annotation.h"

#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "number.h"
#include "report.h"

#define EXAMPLE2      "uniform sampler2D NAME; // \"stone.png\" sRGB repeat: meaning"
#define EXAMPLEF      "uniform sampler2D history; // the last frame"
#define EXAMPLE3      "uniform sampler3D NAME; // \"noise.png\" linear repeat 64: meaning"
#define EXAMPLE_WORDS "uniform usampler2D NAME; // \"table.png\": meaning"

// Read one of two words.
//   what  explains the two words, for messages
static bool read_choice(struct annotation *a, const char *first, const char *second,
                        const char *what, bool *is_first)
{
    *is_first = annotation_accept_word(a, first);
    if (*is_first || annotation_accept_word(a, second))
        return true;
    size_t length = strcspn(a->c, BLANKS ":");
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
        return annotation_refuse(
            a, "a volume needs the number of its slices: write it as in \"%s\"", a->example);
    if (!(value >= 1.0 && value <= SAMPLER_SLICES && value == (double)(int)value))
        return annotation_refuse(a, "the number of slices must be a whole number from 1 to %d",
                                 SAMPLER_SLICES);
    sampler->slices = (int)value;
    return true;
}

// Read how texels are encoded, what lies outside the picture, and the number of slices.
static bool read_form(struct annotation *a, struct sampler *sampler, bool volume)
{
    return read_choice(a, "sRGB", "linear", "sRGB is for colours, linear for numbers",
                       &sampler->srgb) &&
           read_choice(a, "repeat", "clamp", "repeat tiles the picture, clamp continues its edge",
                       &sampler->repeat) &&
           read_slices(a, sampler, volume);
}

static bool read_picture(struct annotation *a, bool volume, char file[256])
{
    struct sampler *sampler = &a->sampler;
    if (!annotation_accept(a, '"'))
        return annotation_refuse(a, "no picture is named: name one as in \"%s\"", a->example);
    size_t length = strcspn(a->c, "\"");
    if (a->c[length] == '\0')
        return annotation_refuse(a, "the file's name has no closing quote: write it as in \"%s\"",
                                 a->example);
    return annotation_copy(a, "file's name", file, 256, length) && annotation_accept(a, '"') &&
           (sampler->words || read_form(a, sampler, volume)) &&
           (annotation_accept(a, ':') || *a->c == '\0' ||
            annotation_refuse(a, "'%.20s' is not understood: write it as in \"%s\"", a->c,
                              a->example)) &&
           annotation_copy(a, "meaning", sampler->meaning, sizeof sampler->meaning, strlen(a->c));
}

// Read the words for a sampler of what the last frame has kept. Returns false without reporting an
// error if the comment does not begin with them.
//   good  receives false after the report of an error
static bool read_last_frame(struct annotation *a, bool volume, bool *good)
{
    struct sampler *sampler = &a->sampler;
    if (!annotation_accept_word(a, "the") || !annotation_accept_word(a, "last") ||
        !annotation_accept_word(a, "frame"))
        return false;
    a->example = EXAMPLEF;
    sampler->pass = 1;
    sampler->file = -1;
    snprintf(sampler->meaning, sizeof sampler->meaning, "what frameKept returned");
    if (volume)
        *good = annotation_refuse(a, "the last frame is no volume: use a sampler2D");
    else if (glsl_find_definition(&a->source->code, "frameKept") == NULL)
        *good = annotation_refuse(a, "reads the last frame, but no function says what a frame "
                                     "keeps: define vec4 frameKept(vec2 pixel)");
    else if (annotation_accept(a, ':'))
        *good =
            annotation_copy(a, "meaning", sampler->meaning, sizeof sampler->meaning, strlen(a->c));
    else
        *good = *a->c == '\0' ||
                annotation_refuse(a, "'%.20s' is not understood: write it as in \"%s\"", a->c,
                                  a->example);
    return true;
}

// The FILE of the last --texture NAME=FILE for this name, or NULL if there is none.
static const char *other_file(const struct shader_source *source, const char *name)
{
    const struct shader_request *request = &source->request;
    size_t length = strlen(name);
    for (int i = request->texture_count - 1; i >= 0; i--)
        if (strncmp(request->textures[i], name, length) == 0 && request->textures[i][length] == '=')
            return request->textures[i] + length + 1;
    return NULL;
}

const char *sampler_given(const struct shader_source *source, const struct shader_sampler *sampler)
{
    const char *const *channels = source->request.channels;
    const char *other = other_file(source, sampler->name);
    bool has = other == NULL && channels != NULL && sampler->channel >= 0;
    return has ? channels[sampler->channel] : other;
}

bool sampler_has_picture(const struct shader_source *source, const struct shader_sampler *sampler)
{
    return sampler_given(source, sampler) != NULL ||
           shader_read_of(source, sampler->name) != NULL ||
           (sampler->channel >= 0 && source->channel[sampler->channel] > 0);
}

static bool find_file(struct annotation *a, struct shader_source *source, const char *file)
{
    char why[TEXT_FILE_WHY];
    const char *other = other_file(source, a->name);
    if (a->sampler.pass > 0)
        return other == NULL ||
               annotation_refuse(a, "reads the last frame, not the picture of --texture");
    a->sampler.file = other != NULL
                          ? shader_take_texture(source, other, why)
                          : shader_find_texture(source, source->lines[a->line].file, file, why);
    return a->sampler.file >= 0 ||
           annotation_refuse(a, "%s: %s", other != NULL ? other : file, why);
}

static bool add_sampler(struct samplers *samplers, const struct sampler *sampler)
{
    samplers->item = memory_row(samplers->item, samplers->count, sizeof *samplers->item);
    samplers->item[samplers->count++] = *sampler;
    return true;
}

// The type token of a uniform if its type is a sampler of any kind, otherwise NULL.
static const struct glsl_token *sampler_type(const struct glsl_token *uniform)
{
    const struct glsl_token *t = uniform + 1;
    while (t->kind >= GLSL_COMMENT || glsl_is_precision(t))
        t++;
    return strstr(t->text, "sampler") != NULL ? t : NULL;
}

// A correct declaration of a sampler of this type, or of a sampler2D.
static const char *example_of(const struct glsl_token *type)
{
    return glsl_is(type, "sampler3D")    ? EXAMPLE3
           : glsl_is(type, "usampler2D") ? EXAMPLE_WORDS
                                         : EXAMPLE2;
}

static bool read_sampler(struct samplers *samplers, struct shader_source *source,
                         const struct glsl_token *uniform, const struct glsl_token *type)
{
    // The samplers of the march, of the coarse pass and of the axis labels, which the harness sets
    // itself.
    static const char *const own[] = {"iMarch", "iCoarse", "iSigns", NULL};
    bool volume = glsl_is(type, "sampler3D"), words = glsl_is(type, "usampler2D"), twice = false,
         good = true;
    struct annotation a;
    char file[256];
    if (glsl_is_any(type + 1, own))
        return true;
    annotation_begin(&a, source, uniform, "sampler", example_of(type));
    a.sampler.line = a.line;
    a.sampler.channel = -1;
    a.sampler.words = words;
    bool done =
        annotation_declaration(&a) &&
        (volume || words || glsl_is(type, "sampler2D") ||
         annotation_refuse(&a,
                           "the type %s cannot be a texture: use sampler2D, sampler3D for a "
                           "volume, or usampler2D for whole numbers",
                           type->text)) &&
        (read_last_frame(&a, volume, &good) ? good : read_picture(&a, volume, file));
    memcpy(a.sampler.name, a.name, sizeof a.name);
    for (int i = 0; i < samplers->count; i++)
        twice |= strcmp(samplers->item[i].name, a.name) == 0;
    done = done && (!twice || annotation_refuse(&a, "is declared twice: remove one declaration")) &&
           find_file(&a, source, file) && add_sampler(samplers, &a.sampler);
    free(a.words);
    return done;
}

// Add the samplers of another tool's dialect that have a picture. These pictures repeat, as they do
// by default in Shadertoy.
static bool add_others(struct samplers *samplers, struct shader_source *source)
{
    char why[TEXT_FILE_WHY];
    for (int i = 0; i < source->sampler_count; i++) {
        const struct shader_sampler *from = &source->samplers[i];
        const char *given = sampler_given(source, from);
        const struct shader_read *read = given == NULL ? shader_read_of(source, from->name) : NULL;
        struct sampler sampler = {.file = -1,
                                  .line = from->line,
                                  .channel = from->channel,
                                  .repeat = true,
                                  .slices = strcmp(from->type, "sampler3D") == 0,
                                  .cube = strcmp(from->type, "samplerCube") == 0,
                                  .pass = read != NULL ? read->pass : 0,
                                  .filter = read != NULL ? read->filter : '\0'};
        snprintf(sampler.name, sizeof sampler.name, "%s", from->name);
        bool has = sampler_has_picture(source, from);
        if (has && sampler.pass == 0)
            sampler.file = given != NULL ? shader_take_texture(source, given, why)
                                         : source->channel[from->channel];
        else if (!has && !sampler.cube && sampler.slices == 0)
            continue; // black without a texture unit of its own
        if (has && sampler.pass == 0 && sampler.file < 0)
            return shader_refuse(source, from->line, "sampler %s: %s: %s", from->name, given, why);
        add_sampler(samplers, &sampler);
    }
    return true;
}

// Refuse a sampler that is declared in a structure or a macro, because no picture can be assigned
// to it. A function's parameter is allowed, because it refers to a sampler declared elsewhere.
static bool check_hidden(const struct shader_source *source, const struct glsl_token *type)
{
    static const char *const types[] = {"sampler2D", "sampler3D", "usampler2D", NULL};
    static const char *const parameter[] = {"in", "const", "precision", NULL};
    const struct glsl *code = &source->code;
    const struct glsl_token *t = type - 1;
    if (!type->live || !glsl_is_any(type, types))
        return true;
    while (t >= code->item && (t->kind >= GLSL_COMMENT || glsl_is_precision(t)))
        t--;
    return (t >= code->item && (glsl_is_sign(t, "(,") || glsl_is_any(t, parameter) ||
                                (!type->directive && glsl_is(t, "uniform")))) ||
           shader_refuse(source, type->line,
                         "a %s must be a separate uniform, not in a structure or macro: write "
                         "it as in \"%s\"",
                         type->text, example_of(type));
}

bool samplers_read(struct samplers *samplers, struct shader_source *source)
{
    const struct glsl *code = &source->code;
    bool course = source->dialect == DIALECT_COURSE;
    bool done = course || add_others(samplers, source);
    for (const struct glsl_token *t = code->item; course && done && t->kind != GLSL_END; t++) {
        bool uniform = glsl_is(t, "uniform") && t->live && !t->directive;
        const struct glsl_token *type = uniform ? sampler_type(t) : NULL;
        done = (type == NULL || read_sampler(samplers, source, t, type)) && check_hidden(source, t);
    }
    return done;
}
