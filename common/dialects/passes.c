#include "dialects/passes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

// Take the text of a pass into part, the common one first, and what the image pass reads in each
// channel.
static void read_pass(struct shader_source *source, char *part[2], const char *pass)
{
    char *type = string(member(pass, "type"));
    bool image = strcmp(type, "image") == 0 && part[1] == NULL;
    if (image || (strcmp(type, "common") == 0 && part[0] == NULL)) {
        char *code = string(member(pass, "code"));
        part[image] = memory_text("%s\n", code);
        free(code);
    }
    free(type);
    const char *c = image ? first_value(member(pass, "inputs")) : NULL;
    for (; c != NULL; c = next_value(c)) {
        const char *number = member(c, "channel"), *kind = member(c, "ctype");
        char *was = string(kind != NULL ? kind : member(c, "type"));
        if (number != NULL && *number >= '0' && *number <= '3')
            snprintf(source->was[*number - '0'], sizeof source->was[0], "%s", was);
        free(was);
    }
}

bool passes_unpack(struct shader_source *source, const char *text, char *part[2], bool *done)
{
    const char *root = skip_blanks(text);
    if (*root != '{' && !(*root == '[' && *skip_blanks(root + 1) == '{'))
        return false;
    root = *root == '[' ? first_value(root) : root;
    const char *shader = member(root, "Shader");
    const char *row = member(shader != NULL ? shader : root, "renderpass");
    for (const char *pass = first_value(row); pass != NULL; pass = next_value(pass))
        read_pass(source, part, pass);
    if (part[0] == NULL)
        part[0] = memory_text("%s", "");
    *done = part[1] != NULL ||
            report("%s: %s", source->files[0],
                   row == NULL ? "JSON, but not an export from Shadertoy: a shader is GLSL code"
                               : "an export from Shadertoy without an image pass");
    return true;
}
