#include "shader/passes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"

static const char *skip_blanks(const char *c)
{
    return c + strspn(c, " \t\n\r");
}

bool passes_are(const char *text)
{
    const char *c = skip_blanks(text);
    return *c == '{' || (*c == '[' && *skip_blanks(c + 1) == '{');
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

static void read_pass(struct passes *passes, const char *pass)
{
    char *type = string(member(pass, "type"));
    bool image = strcmp(type, "image") == 0 && passes->image == NULL;
    if (image || (strcmp(type, "common") == 0 && passes->common == NULL)) {
        char *code = string(member(pass, "code"));
        *(image ? &passes->image : &passes->common) = memory_text("%s\n", code);
        free(code);
    }
    free(type);
    const char *c = image ? first_value(member(pass, "inputs")) : NULL;
    for (; c != NULL; c = next_value(c)) {
        const char *number = member(c, "channel"), *kind = member(c, "ctype");
        char *was = string(kind != NULL ? kind : member(c, "type"));
        if (number != NULL && *number >= '0' && *number <= '3')
            snprintf(passes->was[*number - '0'], sizeof passes->was[0], "%s", was);
        free(was);
    }
}

const char *passes_read(struct passes *passes, const char *text)
{
    const char *root = skip_blanks(text);
    *passes = (struct passes){0};
    root = *root == '[' ? first_value(root) : root;
    const char *shader = member(root, "Shader");
    const char *row = member(shader != NULL ? shader : root, "renderpass");
    for (const char *pass = first_value(row); pass != NULL; pass = next_value(pass))
        read_pass(passes, pass);
    if (passes->common == NULL)
        passes->common = memory_text("%s", "");
    return passes->image != NULL ? NULL
           : row == NULL         ? "JSON, but not an export from Shadertoy: a shader is GLSL code"
                                 : "an export from Shadertoy without an image pass";
}

void passes_free(struct passes *passes)
{
    free(passes->common);
    free(passes->image);
}
