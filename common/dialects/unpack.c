#include "dialects/unpack.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dialects/formats.h"
#include "memory.h"
#include "report.h"

static const char *skip_blanks(const char *c)
{
    return c + strspn(c, " \t\n\r");
}

// The closing quote of a string, or the end of the text.
static const char *end_of_string(const char *c)
{
    for (c++; *c != '\0' && *c != '"'; c++)
        c += *c == '\\' && c[1] != '\0';
    return c;
}

// The end of a value, after any brackets that it opens.
static const char *skip_value(const char *c)
{
    int depth = 0;
    for (c = skip_blanks(c); *c != '\0'; c++) {
        if (depth == 0 && strchr(",]}", *c) != NULL)
            break;
        depth += (*c == '{' || *c == '[') - (*c == '}' || *c == ']');
        if (*c == '"')
            c = end_of_string(c);
        if (*c == '\0')
            break;
    }
    return c;
}

// The value after this one in an array or an object; NULL at the end.
static const char *next_value(const char *c)
{
    c = skip_value(c);
    return *c == ',' ? skip_blanks(c + 1) : NULL;
}

// The first value of an array or an object, or NULL if there is none.
static const char *first_value(const char *c)
{
    if (c == NULL || (*c != '[' && *c != '{'))
        return NULL;
    c = skip_blanks(c + 1);
    return *c == ']' || *c == '}' || *c == '\0' ? NULL : c;
}

// The value of an object's member, or NULL if there is none.
static const char *member(const char *object, const char *name)
{
    size_t length = strlen(name);
    for (const char *c = first_value(object); c != NULL && *c == '"'; c = next_value(c)) {
        const char *end = end_of_string(c), *colon = *end == '"' ? skip_blanks(end + 1) : end;
        if (*colon == ':' && (size_t)(end - c) == length + 1 && strncmp(c + 1, name, length) == 0)
            return skip_blanks(colon + 1);
    }
    return NULL;
}

// The text of a string, which the caller frees; "" for any other value.
static char *string(const char *c)
{
    static const char escapes[] = "nrtbf", meanings[] = "\n\r\t  ";
    char *text;
    FILE *stream = memory_open(&text);
    if (c != NULL && *c == '"')
        for (const char *end = end_of_string(c++); c < end; c++) {
            unsigned code = '?';
            const char *escape = *c == '\\' ? strchr(escapes, c[1]) : NULL;
            if (*c != '\\')
                fputc(*c, stream);
            else if (*++c == 'u' && end - c > 4 && sscanf(c + 1, "%4x", &code) == 1)
                fputc(code > 0 && code < 128 ? (int)code : '?', stream), c += 4;
            else
                fputc(escape != NULL ? meanings[escape - escapes] : *c, stream);
        }
    memory_close(stream);
    return text;
}

// ---- Shadertoy and GLSL Sandbox ----

// The text of a shader in a string, with an end of its last line. The caller frees it.
static char *shader_of(const char *c)
{
    char *code = string(c), *text = memory_text("%s\n", code);
    free(code);
    return text;
}

// True if two values are the same number or string.
static bool is_same(const char *a, const char *b)
{
    size_t length = a != NULL && b != NULL ? (size_t)(skip_value(a) - a) : 0;
    return length > 0 && (size_t)(skip_value(b) - b) == length && strncmp(a, b, length) == 0;
}

static bool has_word(const char *object, const char *name, const char *word)
{
    char *text = string(member(object, name));
    bool same = strcmp(text, word) == 0;
    free(text);
    return same;
}

// The passes of an export. Each pointer is NULL if there is no such pass.
struct row {
    const char *common, *image, *buffer[SHADER_PASSES];
    const char *id[SHADER_PASSES]; // of the buffers' pictures
    int count;                     // number of buffers, in the order in which they are drawn
};

static struct row read_row(const char *c)
{
    struct row row = {0};
    for (c = first_value(c); c != NULL; c = next_value(c)) {
        if (row.common == NULL && has_word(c, "type", "common"))
            row.common = c;
        else if (row.image == NULL && has_word(c, "type", "image"))
            row.image = c;
        else if (row.count < SHADER_PASSES && has_word(c, "type", "buffer")) {
            row.id[row.count] = member(first_value(member(c, "outputs")), "id");
            row.buffer[row.count++] = c;
        }
    }
    return row;
}

// The number of the buffer that an input reads, from 1; 0 if it reads none.
static int buffer_of(const struct row *row, const char *input)
{
    const char *id = member(input, "id");
    for (int i = 0; i < row->count; i++)
        if (is_same(row->id[i], id))
            return i + 1;
    return 0;
}

// Find what a pass reads in each channel. If two channels read one buffer, Shadertoy uses the
// filter of the second for both.
static void read_inputs(struct shader_source *source, const struct row *row, const char *pass)
{
    struct shader_read *read = source->links.read;
    for (const char *c = first_value(member(pass, "inputs")); c != NULL; c = next_value(c)) {
        const char *number = member(c, "channel"), *kind = member(c, "ctype");
        if (number == NULL || *number < '0' || *number > '3')
            continue;
        int channel = *number - '0';
        char *was = string(kind != NULL ? kind : member(c, "type"));
        char *how = string(member(member(c, "sampler"), "filter"));
        snprintf(source->was[channel], sizeof source->was[0], "%s", was);
        snprintf(read[channel].name, sizeof read->name, "iChannel%d", channel);
        read[channel].pass = strcmp(was, "buffer") == 0 ? buffer_of(row, c) : 0;
        read[channel].filter = how[0];
        free(was);
        free(how);
    }
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < k; i++)
            if (read[i].pass == read[k].pass)
                read[i].filter = read[k].filter;
}

// Find how a buffer is read: its edge is as the last input that names it asks.
static void read_readers(struct shader_pass *links, const struct row *row, const char *passes,
                         int number)
{
    for (const char *pass = first_value(passes); pass != NULL; pass = next_value(pass))
        for (const char *c = first_value(member(pass, "inputs")); c != NULL; c = next_value(c))
            if (buffer_of(row, c) == number) {
                links->repeat = has_word(member(c, "sampler"), "wrap", "repeat");
                links->mip_levels |= has_word(member(c, "sampler"), "filter", "mipmap");
            }
}

// Take the texts of the common pass and of the one that is asked for.
static void unpack_row(struct shader_source *source, const char *passes, char *part[2])
{
    const struct row row = read_row(passes);
    int asked = source->request.pass;
    const char *pass = asked == 0 ? row.image : asked > row.count ? NULL : row.buffer[asked - 1];
    source->pass_count = row.count;
    if (row.common != NULL)
        part[0] = shader_of(member(row.common, "code"));
    if (pass == NULL)
        return;
    part[1] = shader_of(member(pass, "code"));
    read_inputs(source, &row, pass);
    read_readers(&source->links, &row, passes, asked);
}

static bool unpack_json(struct shader_source *source, const char *root, char *part[2])
{
    root = *root == '[' ? first_value(root) : root;
    const char *shader = member(root, "Shader"), *code = member(root, "code");
    const char *row = member(shader != NULL ? shader : root, "renderpass");
    unpack_row(source, row, part);
    if (row == NULL && code != NULL) // an item of GLSL Sandbox
        part[1] = shader_of(code);
    if (part[0] == NULL)
        part[0] = memory_text("%s", "");
    return part[1] != NULL ||
           report("%s: %s", source->files[0],
                  row == NULL ? "JSON, but not an export from Shadertoy or GLSL Sandbox: a shader "
                                "is GLSL code"
                              : "an export from Shadertoy without an image pass");
}

// ---- ISF ----

enum { PARTS = 256 }; // the maximum number of values of an input

// Read a number or an array of numbers, where true is 1. Returns the number of values.
static int numbers(const char *c, double value[PARTS])
{
    int count = 0;
    const char *first = c != NULL && *c == '[' ? first_value(c) : c;
    for (; first != NULL && count < PARTS; first = *c == '[' ? next_value(first) : NULL)
        value[count++] = *first == 't' ? 1.0 : strtod(first, NULL);
    return count;
}

// Declare an input as an annotated uniform. The range, if none is given, is [0, 1]; it is extended
// to contain the value.
static void declare(FILE *text, const char *input)
{
    static const struct {
        const char *type, *glsl;
        int components; // 0 for a bool; -1 for a sampler
    } types[] = {
        {"float", "float", 1},      {"long", "int", 1},         {"bool", "bool", 0},
        {"event", "bool", 0},       {"point2D", "vec2", 2},     {"color", "vec4", 4},
        {"image", "sampler2D", -1}, {"audio", "sampler2D", -1}, {"audioFFT", "sampler2D", -1}};
    static const char *const limits[] = {"MIN", "MAX", "VALUES"};
    char *name = string(member(input, "NAME")), *type = string(member(input, "TYPE"));
    double value[PARTS] = {0.0}, limit[PARTS], low = 0.0, high = 1.0;
    size_t i = 0, length = 0;
    while (glsl_is_word(name[length]))
        length++;
    while (i < sizeof types / sizeof *types && strcmp(type, types[i].type) != 0)
        i++;
    if (i < sizeof types / sizeof *types && length > 0 && name[length] == '\0') {
        numbers(member(input, "DEFAULT"), value);
        for (int k = 0; k < 3; k++)
            for (int n = numbers(member(input, limits[k]), limit); n > 0; n--) {
                low = k == 0 ? limit[n - 1] : fmin(low, limit[n - 1]);
                high = k == 1 ? limit[n - 1] : fmax(high, limit[n - 1]);
            }
        fprintf(text, "uniform %s %s;", types[i].glsl, name);
        if (types[i].components == 0)
            fprintf(text, " // %s: %s", value[0] != 0.0 ? "true" : "false", name);
        for (int k = 0; k < types[i].components; k++) {
            fprintf(text, "%s%g", k == 0 ? " // " : ", ", value[k]);
            low = fmin(low, value[k]);
            high = fmax(high, value[k]);
        }
        if (types[i].components > 0)
            fprintf(text, " in [%g, %g]: %s", low, fmax(high, low + 1.0), name);
        fputc('\n', text);
    }
    free(name);
    free(type);
}

// Declare what ISF declares for the text after a header.
static void unpack_isf(const char *header, const char *text, char *part[2])
{
    static const char pictures[] =
        "#define IMG_NORM_PIXEL(image, p) texture(image, p)\n"
        "#define IMG_PIXEL(image, p) texture(image, (p) / RENDERSIZE)\n"
        "#define IMG_THIS_NORM_PIXEL(image) texture(image, isf_FragNormCoord)\n"
        "#define IMG_THIS_PIXEL(image) texture(image, isf_FragNormCoord)\n"
        "#define IMG_SIZE(image) RENDERSIZE\n";
    FILE *declarations = memory_open(&part[0]);
    const char *input = first_value(member(header, "INPUTS"));
    for (; input != NULL; input = next_value(input))
        declare(declarations, input);
    bool reads = strstr(text, "IMG_") != NULL;
    if ((reads || strstr(text, "isf_FragNormCoord") != NULL) &&
        strstr(text, "vec2 isf_FragNormCoord") == NULL)
        fputs("varying vec2 isf_FragNormCoord;\n", declarations);
    fputs(reads ? pictures : "", declarations);
    memory_close(declarations);
    part[1] = memory_text("%s", text);
}

// ---- glslViewer ----

// True if a directive mentions a word, even where the preprocessor skips the directive.
static bool asks_for(const struct glsl *code, const char *word)
{
    const struct glsl_token *t = code->item;
    while (t->kind != GLSL_END && !(t->directive && strcmp(t->text, word) == 0))
        t++;
    return t->kind != GLSL_END;
}

// Take a text that is compiled once more for each of its buffers, with the buffer's word defined.
// The double buffers come last. Returns false for any other text.
static bool unpack_buffers(struct shader_source *source, const char *text, char *part[2])
{
    static const char *const kinds[] = {"", "DOUBLE_"}, *const names[] = {"u_b", "u_doubleB"};
    struct glsl code;
    glsl_read(&code, text);
    for (int kind = 0; kind < 2; kind++)
        for (int i = 0; source->pass_count < SHADER_PASSES; i++) {
            struct shader_read *read = &source->links.read[source->pass_count];
            char *define = memory_text("%sBUFFER_%d", kinds[kind], i);
            snprintf(read->name, sizeof read->name, "%suffer%d", names[kind], i);
            bool is = asks_for(&code, define) && glsl_mentions(&code, read->name) > 0;
            if (is) {
                read->filter = 'l';
                read->pass = ++source->pass_count;
                source->links.repeat = true;
            }
            if (is && read->pass == source->request.pass)
                part[0] = memory_text("#define %s\n", define);
            free(define);
            if (!is)
                break;
        }
    glsl_free(&code);
    if (source->pass_count == 0)
        return false;
    part[1] = memory_text("%s", text);
    if (part[0] == NULL)
        part[0] = memory_text("%s", "");
    return true;
}

bool unpack(struct shader_source *source, const char *text, char *part[2], bool *done)
{
    *done = formats_check(source->files[0], text);
    if (text == NULL || !*done)
        return !*done;
    const char *root = skip_blanks(text), *header = root + strspn(root, "/* \t\n");
    bool json = *root == '{' || (*root == '[' && *skip_blanks(root + 1) == '{');
    if (json)
        *done = unpack_json(source, root, part);
    else if (strncmp(root, "/*", 2) == 0 && *header == '{')
        unpack_isf(header, text, part);
    else
        return unpack_buffers(source, text, part);
    return true;
}
