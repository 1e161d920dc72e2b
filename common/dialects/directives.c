#include "dialects/directives.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "context/gl.h"
#include "memory.h"
#include "report.h"

#define BLANKS " \t\v\f"

// Rewrite the rest of #iUniform float x = 0.5 in { 0.0, 1.0 } as an annotated uniform. If no range
// is given, the range extends to four times the value's magnitude, or to 1 if the value is 0, on
// either side of 0; the range of a color3 is always [0, 1]. Returns memory that the caller frees,
// or NULL if the directive is malformed.
static char *annotated_uniform(const char *c)
{
    char type[16], name[64], words[256] = "0 ", range[64] = "";
    int begin = 0;
    if (sscanf(c, "%*[ \t]%15[A-Za-z0-9]%*[ \t]%63[A-Za-z0-9_]%n", type, name, &begin) != 2)
        return NULL;
    c += begin;
    c += strspn(c, BLANKS);
    bool colour = strncmp(type, "color", 5) == 0;
    size_t used = *c == '=' ? 0 : 2;
    c += used == 0;
    c += strspn(c, BLANKS);
    // Remove the names and parentheses of constructors and the suffix f of a float, and turn braces
    // into square brackets.
    for (; strchr("\n;", *c) == NULL && used + 1 < sizeof words; c++) {
        size_t word = strcspn(c, "( \t\n;");
        bool suffix = *c == 'f' && used > 0 && strchr(".0123456789", words[used - 1]) != NULL;
        if (c[0] == '/' && c[1] == '/')
            break;
        if (c[word] == '(' && isalpha((unsigned char)*c))
            c += word;
        else if (*c != ')' && !suffix)
            words[used++] = *c == '{' ? '[' : *c == '}' ? ']' : *c;
    }
    words[used] = '\0';
    double value = fabs(strtod(words, NULL)), end = value > 0.0 ? 4.0 * value : 1.0;
    if (strcmp(type, "color3") == 0)
        snprintf(range, sizeof range, " in [0, 1], linear RGB");
    else if (strcmp(type, "bool") != 0 && strchr(words, '[') == NULL)
        snprintf(range, sizeof range, " in [%g, %g]", -end, end);
    return memory_text("uniform %s%s %s; // %s%s: %s\n", colour ? "vec" : "",
                       type + (colour ? 5 : 0), name, words, range, name);
}

static bool ends_in(const char *text, const char *const ends[])
{
    for (size_t length = strlen(text); *ends != NULL; ends++)
        if (length >= strlen(*ends) && strcmp(text + length - strlen(*ends), *ends) == 0)
            return true;
    return false;
}

// Obey #iChannel0 "file://stone.png", which names a picture beside the file. Any other content of a
// channel (another shader, the shader itself, a sound, a cube map) is recorded for messages.
static bool take_channel(struct shader_source *source, struct shader_line at, int channel,
                         const char *rest)
{
    static const char *const shaders[] = {".glsl", ".frag", ".fs", "self", NULL},
                             *const sounds[] = {".mp3", ".wav", ".ogg", NULL};
    const char *file = source->files[at.file];
    char value[256], why[TEXT_FILE_WHY];
    bool option = *rest == ':';
    if (sscanf(rest + strcspn(rest, "\"\n"), "\"%255[^\"\n]", value) != 1 ||
        (option && strcmp(value, "CubeMap") != 0))
        return true;
    const char *was = option || strchr(value, '{') != NULL                       ? "cubemap"
                      : ends_in(value, shaders) || strncmp(value, "buf", 3) == 0 ? "buffer"
                      : ends_in(value, sounds)                                   ? "music"
                                                                                 : "";
    if (was[0] != '\0')
        strcpy(source->was[channel], was);
    if (was[0] != '\0' ||
        (source->request.channels != NULL && source->request.channels[channel] != NULL))
        return true;
    if (strncmp(value, "http", 4) == 0)
        return report("%s:%d: #iChannel%d: pictures are not downloaded: save this one and give "
                      "--channel %d=FILE.png",
                      file, at.line, channel, channel);
    const char *name = value + (strncmp(value, "file://", 7) == 0 ? 7 : 0);
    int picture = shader_find_texture(source, at.file, name, why);
    source->channel[channel] = picture > 0 ? picture : 0;
    const char *reason = picture < 0 ? why : "the shader's own file";
    if (GL_IS_ES)
        return picture > 0 || report("%s:%d: #iChannel%d: %s: this page cannot read your pictures",
                                     file, at.line, channel, reason);
    return picture > 0 || report("%s:%d: #iChannel%d: %s: give --channel %d=FILE.png instead", file,
                                 at.line, channel, reason, channel);
}

bool directives_obey(struct shader_source *source, struct shader_line at, const char *word,
                     size_t length, char **instead, bool *done)
{
    const char *rest = word + length;
    *instead = NULL;
    if (length < 2 || word[0] != 'i' || !isupper((unsigned char)word[1]))
        return false;
    int channel = length == 9 && strncmp(word, "iChannel", 8) == 0 ? word[8] - '0' : -1;
    if (length == 8 && strncmp(word, "iUniform", 8) == 0)
        *instead = annotated_uniform(rest);
    *done = channel < 0 || channel > 3 || take_channel(source, at, channel, rest);
    return true;
}
