#include "shader/read.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "context/gl.h"
#include "memory.h"
#include "report.h"
#include "shader/dialects.h"
#include "shader/inputs.h"

#define ARRAY_LIMIT 65536 // maximum number of elements of an array
#define MACRO_LIMIT 4e6   // maximum number of a macro's tokens; Mesa needs up to 1 kB for each

// The first mention outside directives of a macro that expands to more than MACRO_LIMIT tokens, or
// NULL. A macro counts only in those defined after it, and arguments do not count.
static const struct glsl_token *find_bomb(const struct glsl *code)
{
    double *size = memory_zeros((size_t)code->name_count + 1, sizeof *size);
    const struct glsl_token *t = code->item;
    while (t->kind != GLSL_END &&
           !(t->kind == GLSL_WORD && t->live && !t->directive && size[t->name] > MACRO_LIMIT)) {
        const struct glsl_token *hash = t++;
        if (hash->kind != GLSL_HASH || !hash->live || !glsl_is(t, "define") ||
            t[1].kind != GLSL_WORD)
            continue;
        double tokens = 0.0;
        for (t += 2; t->directive && t->kind < GLSL_HASH; t++)
            tokens += t->kind == GLSL_WORD ? fmax(size[t->name], 1.0) : 1.0;
        size[hash[2].name] = tokens;
    }
    free(size);
    return t->kind != GLSL_END ? t : NULL;
}

// Refuse a text that contains only comments, and two kinds of text that cost some drivers minutes
// and all the memory: a huge array with a literal number of elements, and macros that double again
// and again. Other such texts end the program, because guard_begin limits the memory that a driver
// may use; after these two, a window keeps its last picture.
static bool check_sense(const struct shader_source *source)
{
    const struct glsl *code = &source->code;
    const struct glsl_token *t = code->item;
    while (t->kind != GLSL_END && !(t->live && t->kind < GLSL_COMMENT))
        t++;
    if (t->kind == GLSL_END)
        return report("%s: contains only comments: a shader needs code", source->files[0]);
    for (t = code->statement; t->kind != GLSL_END; t++) {
        const struct glsl_token *number = t + 1;
        if (t->sign == '[' && number->kind == GLSL_NUMBER && number[1].sign == ']' &&
            strtod(number->text, NULL) > ARRAY_LIMIT)
            return shader_refuse(source, t->line,
                                 "an array of %.20s elements: at most %d are allowed", number->text,
                                 ARRAY_LIMIT);
    }
    t = find_bomb(code);
    return t == NULL || shader_refuse(source, t->line,
                                      "%.40s: this macro expands to more than %.0f million tokens, "
                                      "more than a graphics driver can compile: shorten it",
                                      t->text, MACRO_LIMIT / 1e6);
}

// A course file that --print-shader wrote begins with the prelude. Overwrite its lines with blanks,
// so that the file is in the course's dialect again. Returns false for any other file.
static bool forget_prelude(struct shader_source *source)
{
    static const char first[] = "#version 330 core\n", next[] = "#define VIEW";
    char *line = source->text + strlen(first);
    if (strncmp(source->text, first, strlen(first)) != 0 ||
        strncmp(line, next, strlen(next)) != 0 ||
        glsl_find_definition(&source->code, "rayColour") == NULL)
        return false;
    memset(source->text, ' ', strlen(first) - 1);
    for (; strncmp(line, next, strlen(next)) == 0; line = strchr(line, '\n') + 1)
        memset(line, ' ', strcspn(line, "\n"));
    source->version = 0;
    return true;
}

// A course file gets its #version from the prelude. With a #version of its own, it would be a whole
// shader with two mains.
static bool check_version(const struct shader_source *source)
{
    return source->version == 0 || !shader_includes(source, "shaders/main.glsl") ||
           shader_refuse(source, 0,
                         "remove #version: a file that includes main.glsl gets one anyway");
}

// Without the folder dialects/, only files that include main.glsl are read.
static bool take_own(struct shader_source *source)
{
    return shader_includes(source, "shaders/main.glsl") ||
           report("%s: was written for another tool: this program runs only shaders that begin "
                  "with #include \"main.glsl\"",
                  source->files[0]);
}

// Determine the dialect of an expanded text, and translate it. The course's dialect needs no
// translation, because its library declares the inputs; those that the text mentions are added to
// the source's inputs.
static bool take_dialect(struct shader_source *source)
{
    const struct input *input;
    bool printed = source->version != 0 && forget_prelude(source);
    if (!check_sense(source) || !check_version(source))
        return false;
    if (!printed && !(dialects.take != NULL ? dialects.take : take_own)(source))
        return false;
    for (int i = 0; source->dialect == DIALECT_COURSE && (input = inputs_course(i)) != NULL; i++)
        if (glsl_mentions(&source->code, input->name) > 0)
            inputs_add(source, inputs_default(input));
    return true;
}

// Read the other passes of a file, each as if it were the file's picture.
static bool read_passes(struct shader_source *source, const char *path, const char *root)
{
    struct shader_request request = source->request;
    int count = request.pass == 0 ? source->pass_count : 0;
    source->pass_count = count;
    source->pass = memory_zeros((size_t)count + 1, sizeof *source->pass);
    for (request.pass = 1; request.pass <= count; request.pass++)
        if (!shader_read_asked(&source->pass[request.pass - 1], path, root, &request))
            return false;
    return true;
}

bool shader_read_asked(struct shader_source *source, const char *path, const char *root,
                       const struct shader_request *request)
{
    if (shader_expand(source, path, root, request) && take_dialect(source) &&
        read_passes(source, path, root))
        return true;
    shader_free(source);
    return false;
}

bool shader_read(struct shader_source *source, const char *path, const char *root)
{
    return shader_read_asked(source, path, root, NULL);
}

bool shader_has_view(const struct shader_source *source, enum shader_view view)
{
    return view == VIEW_PICTURE || source->dialect == DIALECT_COURSE ||
           report("%s: cannot show the view %s: only shaders in the course's dialect record their "
                  "rays; the chapters from 01 on have all views",
                  source->files[0], shader_view_name(view));
}

char *shader_prelude(const struct shader_source *source, enum shader_view view)
{
    if (source->prelude != NULL)
        return memory_text("%s", source->prelude);
    char *lines = shader_view_lines(view), *prelude = memory_text("%s%s", GL_GLSL, lines);
    free(lines);
    return prelude;
}
