#include "shader/dialect.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "context/gl.h"
#include "memory.h"
#include "report.h"
#include "shader/inputs.h"
#include "shader/parameter.h"
#include "shader/translate.h"

#define ARRAY_LIMIT  65536 // maximum number of elements of an array
#define MACRO_LIMIT  4e6   // maximum number of a macro's tokens; Mesa needs up to 1 kB for each
#define COUNT(array) (sizeof(array) / sizeof *(array))

// ---- Files of other kinds ----

struct kind {
    const char *word, *why;
};

// Words that occur in only one kind of file.
static const struct kind kinds[] = {
    {"gl_GlobalInvocationID", "a compute shader: a picture needs a fragment shader"},
    {"EmitVertex", "a geometry shader: a picture needs a fragment shader"},
    {"gl_TessCoord", "a tessellation shader: a picture needs a fragment shader"},
    {"SV_Target", "HLSL, the language of DirectX: a shader must be in GLSL"},
    {"SV_POSITION", "HLSL, the language of DirectX: a shader must be in GLSL"},
    {"CGPROGRAM", "a shader for Unity: a shader must be in GLSL"},
    {"metal_stdlib", "the language of Metal: a shader must be in GLSL"},
    {"shader_type", "a shader for Godot: write void main() or mainImage, and name the inputs as "
                    "docs/using.md does"},
    {"isf_vertShaderInit", "a vertex shader for ISF: a picture needs a fragment shader"},
    {"IMG_PIXEL", "an ISF file, because it uses IMG_PIXEL: ISF is not supported"},
    {"IMG_NORM_PIXEL", "an ISF file, because it uses IMG_NORM_PIXEL: ISF is not supported"}};

// Functions that a file of another kind defines instead of main or mainImage.
static const struct kind functions[] = {
    {"mainSound",
     "a sound shader for Shadertoy, because it defines mainSound: sound is not supported"},
    {"mainCubemap", "a cube map for Shadertoy, because it defines mainCubemap: cube maps are not "
                    "supported"},
    {"transition", "a GL Transition, which blends two pictures: transitions are not supported"}};

// The kind of file that a JSON comment at its beginning describes, or NULL if there is no such
// comment.
static const char *what_of_header(const struct glsl *code)
{
    static const char isf[] = "an ISF file, as its first comment shows; ISF is not supported: "
                              "declare its inputs as uniforms with a value, and use iResolution "
                              "and iTime";
    static const struct kind members[] = {
        {"\"INPUTS\"", isf},
        {"\"ISFVSN\"", isf},
        {"\"CATEGORIES\"", isf},
        {"\"DESCRIPTION\"", isf},
        {"\"CREDIT\"", isf},
        {"PASSES", "a file with several passes, as its first comment shows: only a single pass "
                   "can be drawn"}};
    const char *c = code->text + code->item->begin + 2, *end = c + code->item->length;
    if (code->item->kind != GLSL_COMMENTED || c[strspn(c, "* \t\n")] != '{')
        return NULL;
    for (size_t i = 0; i < COUNT(members); i++) {
        const char *member = strstr(c, members[i].word);
        if (member != NULL && member < end)
            return members[i].why;
    }
    return NULL;
}

static bool refuse_vertex(const struct shader_source *source)
{
    return report(
        "%s: a vertex shader, because it sets gl_Position: give the fragment shader instead",
        source->files[0]);
}

// Refuse a file of another kind, in one line that names the kind.
static bool check_kind(const struct shader_source *source)
{
    const struct glsl *code = &source->code;
    const char *why = what_of_header(code);
    for (size_t i = 0; i < COUNT(kinds) && why == NULL; i++)
        if (glsl_mentions(code, kinds[i].word) > 0)
            why = kinds[i].why;
    bool draws = source->dialect == DIALECT_SHADERTOY || glsl_mentions(code, "main") > 0;
    for (size_t i = 0; i < COUNT(functions) && why == NULL && !draws; i++)
        if (glsl_find_definition(code, functions[i].word) != NULL)
            why = functions[i].why;
    if (why != NULL)
        return report("%s: %s", source->files[0], why);
    const struct glsl_token *glslify = glsl_find(code, "glslify");
    if (glslify != NULL && glslify->directive && glsl_is(glslify - 1, "pragma"))
        return shader_refuse(source, glslify->line,
                             "#pragma glslify: this file needs glslify, a JavaScript tool: run "
                             "glslify first and use its output");
    return source->dialect != DIALECT_WHOLE || glsl_mentions(code, "gl_Position") == 0 ||
           refuse_vertex(source);
}

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

static bool refuse_image(const struct shader_source *source, const struct glsl_token *image)
{
    return shader_refuse(source, image->line,
                         "mainImage has parameters other than those it is called with: write void "
                         "mainImage(out vec4 fragColor, in vec2 fragCoord)");
}

// Check that mainImage returns its colour in an out parameter, and that the text does not mention
// gl_FragColor.
static bool check_image(const struct shader_source *source)
{
    const struct glsl *code = &source->code;
    const struct glsl_token *image = glsl_find_definition(code, "mainImage");
    const struct glsl_token *old = glsl_find(code, "gl_FragColor");
    if (image == NULL || !image->certain || image[2].macro)
        return true;
    if (!glsl_is_any(image + 2, (const char *const[]){"out", "inout", NULL}))
        return refuse_image(source, image);
    const struct glsl_token *colour = glsl_skip(code, image + 2, ",)") - 1;
    return old == NULL || !old->certain ||
           shader_refuse(source, old->line,
                         "gl_FragColor: mainImage returns its colour in %s: write %s = ...",
                         colour->text, colour->text);
}

// ---- The dialect ----

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
    for (int i = 1; i < source->file_count && source->version != 0; i++)
        if (strcmp(source->files[i], "shaders/main.glsl") == 0)
            return shader_refuse(source, 0,
                                 "remove #version: a file that includes main.glsl gets one anyway");
    return true;
}

// Determine the dialect. A file that defines main and includes nothing is a whole shader, unless it
// is the course's vertex shader.
static enum shader_dialect dialect_of(struct shader_source *source)
{
    const struct glsl *code = &source->code;
    bool printed = source->version != 0 && forget_prelude(source), includes = false;
    bool main = glsl_find_definition(code, "main") != NULL;
    if (glsl_mentions(code, "mainImage") > 0 && !main)
        return DIALECT_SHADERTOY;
    for (int i = 0; i < source->line_count; i++)
        includes |= source->lines[i].file > 0;
    bool whole = main && !printed && !includes && glsl_mentions(code, "gl_Position") == 0;
    return source->version != 0 || whole ? DIALECT_WHOLE : DIALECT_COURSE;
}

// Determine the dialect of an expanded text, and translate it. The course's dialect needs no
// translation, because its library declares the inputs; those that the text mentions are added to
// the source's inputs.
static bool take_dialect(struct shader_source *source)
{
    const struct input *input;
    source->dialect = dialect_of(source);
    if (!check_sense(source) || !check_version(source) || !check_kind(source) ||
        (source->dialect == DIALECT_SHADERTOY && !check_image(source)))
        return false;
    if (source->dialect != DIALECT_COURSE)
        return translate(source, TRANSLATE_DRIVER, &source->prelude, &source->body);
    for (int i = 0; (input = inputs_row(i)) != NULL; i++)
        if (inputs_is_course(input) && glsl_mentions(&source->code, input->name) > 0)
            inputs_add(source, inputs_default(input));
    return true;
}

bool shader_read_asked(struct shader_source *source, const char *path, const char *root,
                       const struct shader_request *request)
{
    if (shader_expand(source, path, root, request) && take_dialect(source))
        return true;
    shader_free(source);
    return false;
}

bool shader_read(struct shader_source *source, const char *path, const char *root)
{
    return shader_read_asked(source, path, root, NULL);
}

// ---- Views ----

bool shader_has_view(const struct shader_source *source, enum shader_view view)
{
    return view == VIEW_PICTURE || source->dialect == DIALECT_COURSE ||
           report("%s: cannot show the view %s: only shaders in the course's dialect record their "
                  "rays; the chapters from 01 on have all views",
                  source->files[0], shader_view_name(view));
}

// ---- Checks after the driver's ----

char *dialect_prelude(const struct shader_source *source, enum shader_view view)
{
    if (source->prelude != NULL)
        return memory_text("%s", source->prelude);
    char *lines = shader_view_lines(view), *prelude = memory_text("%s%s", GL_GLSL, lines);
    free(lines);
    return prelude;
}

bool dialect_refuses(const struct shader_source *source, const char *log, bool linking)
{
    const struct glsl *code = &source->code;
    const struct glsl_token *cube = inputs_cube_map(code), *image = glsl_find(code, "mainImage");
    const struct input *input;
    if (glsl_mentions(code, "gl_Position") > 0)
        return !refuse_vertex(source);
    if (cube != NULL)
        return !shader_refuse(source, cube->line,
                              "%s is read as a cube map, which is not supported here: a picture is "
                              "read at a vec2",
                              cube->text);
    for (int i = 0; source->dialect != DIALECT_COURSE && (input = inputs_row(i)) != NULL; i++) {
        bool lacks = !inputs_offers(source, input) && strstr(log, input->name) != NULL;
        const struct glsl_token *token = lacks ? glsl_find(code, input->name) : NULL;
        if (token != NULL)
            return !inputs_refuse(source, input, token->line);
    }
    bool toy = source->dialect == DIALECT_SHADERTOY;
    const struct glsl_token *pixel = glsl_find(code, "FC");
    if (pixel != NULL && !code->name[pixel->name].macro && source->file_count == 1)
        return !shader_refuse(
            source, pixel->line,
            "FC: a short name from twigl: write gl_FragCoord, declare uniform vec2 "
            "resolution; and uniform float time; and put everything into void "
            "main()");
    if (toy && image != NULL && strstr(log, "mainImage") != NULL)
        return !refuse_image(source, image);
    return !toy && (linking || strstr(log, "Missing main()") != NULL) &&
           glsl_mentions(code, "main") == 0 &&
           !report("%s: draws no picture, because it has no main: write void main(), or mainImage "
                   "as in Shadertoy, or begin with #include \"main.glsl\" as the chapters do",
                   source->files[0]);
}

// True if the code may write a colour, perhaps through a macro.
static bool writes(const struct glsl *code)
{
    for (const struct glsl_token *t = code->statement; t->kind != GLSL_END;
         t = t->sign == '(' ? glsl_next(code, t) : t + 1) // an out parameter is not an output
        if (glsl_is(t, "out"))
            return true;
    for (const struct glsl_token *t = code->item; t->kind != GLSL_END; t++)
        if (t->directive && t->live && glsl_is(t, "out"))
            return true;
    return glsl_mentions(code, "gl_FragColor") + glsl_mentions(code, "gl_FragData") > 0;
}

// Warn that nothing sets a uniform or a block, and say how to give it a value. The first warning is
// kept.
static void warn(struct shader_source *source, const struct declared *at)
{
    static const char *const types[][3] = {{"float", "1.0", "1 in [0, 4]"},
                                           {"int", "1", "1 in [0, 4]"},
                                           {"bool", "true", "true"},
                                           {"vec2", "vec2(1.0)", "1 in [0, 4]"},
                                           {"vec3", "vec3(1.0)", "1 in [0, 4]"},
                                           {"vec4", "vec4(1.0)", "1 in [0, 4]"}};
    const struct input *input = inputs_find(at->word);
    bool silent = input != NULL && input->meaning == INPUT_SILENT;
    const char *type = at->type->text;
    size_t i = 0;
    while (i < COUNT(types) && strcmp(type, types[i][0]) != 0)
        i++;
    char *why;
    if (at->kind == DECLARED_BLOCK)
        why = memory_text("the members of the block %s are 0: nothing sets them; declare variables "
                          "with a value instead",
                          at->word);
    else if (!silent && i < COUNT(types) && at->name[1].sign != '[')
        why = memory_text("uniform %s %s is 0: nothing sets it; give it a value: uniform %s %s = "
                          "%s; // %s",
                          type, at->word, type, at->word, types[i][1], types[i][2]);
    else
        why = memory_text("uniform %s %s is 0: %s", type, at->word,
                          silent                          ? input->text
                          : strstr(type, "image") != NULL ? "images that a shader writes to are "
                                                            "not supported"
                                                          : "nothing sets it; give it a value "
                                                            "where it is declared");
    shader_refuse(source, at->name->line, "warning: %s", why);
    if (source->unset != NULL)
        free(why);
    else
        source->unset = why;
}

static void warn_of_unset(struct shader_source *source)
{
    struct declared at = {.code = &source->code};
    while (declared_next(&at)) {
        const struct input *input = inputs_find(at.word);
        bool set =
            input != NULL && input->meaning != INPUT_SILENT && input->meaning != INPUT_POSITION;
        bool unset = at.kind == DECLARED_UNIFORM && !set && at.value == NULL;
        bool block = at.kind == DECLARED_BLOCK && !glsl_is(at.type - 1, "in");
        if ((block || unset) && declared_is_read(&at) && !parameter_declared(source, at.name))
            warn(source, &at);
    }
}

bool dialect_accepts(struct shader_source *source)
{
    const struct glsl *code = &source->code;
    if (source->dialect != DIALECT_COURSE && source->unset == NULL)
        warn_of_unset(source);
    if (source->dialect != DIALECT_WHOLE)
        return true;
    struct declared shown = declared_output(code);
    if (shown.kind != DECLARED_NONE && shown.name->certain && !declared_is_read(&shown))
        return shader_refuse(source, shown.name->line,
                             "out %s %s never gets a value: write %s = vec4(...); in main",
                             shown.type->text, shown.word, shown.word);
    return writes(code) ||
           report("%s: writes no colour: declare out vec4 FragColor; and give it a value in main",
                  source->files[0]);
}
