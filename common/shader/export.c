#include "shader/export.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "shader/form_inputs.h"
#include "shader/glsl.h"
#include "report.h"

// One export under way.
struct export
{
    const struct shader_source *source;
    const struct parameters *parameters;
    struct camera_basis basis;
    const struct camera *camera;
    float focal_length;
    char *code; // the source without comments
    char *text; // what is written so far
    size_t size, capacity;
    bool failed; // for want of memory
};

__attribute__((format(printf, 2, 3))) static void put(struct export *e, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    va_start(arguments, format);
    if (e->size + (size_t)length + 1 > e->capacity) {
        e->capacity = 2 * e->capacity + (size_t)length + 4096;
        char *grown = realloc(e->text, e->capacity);
        e->failed = e->failed || grown == NULL;
        e->text = grown != NULL ? grown : e->text;
    }
    if (!e->failed)
        e->size += (size_t)vsnprintf(e->text + e->size, (size_t)length + 1, format, arguments);
    va_end(arguments);
}

// A number as GLSL ES has it: with a point or an exponent, the shortest that is the same float.
static void put_float(struct export *e, double value)
{
    char text[32];
    int digits = 1;
    do
        snprintf(text, sizeof text, "%.*g", digits, (double)(float)value);
    while (strtof(text, NULL) != (float)value && digits++ < 9);
    put(e, "%s%s", text, strpbrk(text, ".e") == NULL ? ".0" : "");
}

static void put_vector(struct export *e, const double *value, int components)
{
    if (components > 1)
        put(e, "vec%d(", components);
    for (int i = 0; i < components; i++) {
        put(e, "%s", i > 0 ? ", " : "");
        put_float(e, value[i]);
    }
    if (components > 1)
        put(e, ")");
}

static void put_vec3(struct export *e, const float v[3])
{
    const double value[3] = {(double)v[0], (double)v[1], (double)v[2]};
    put_vector(e, value, 3);
}

// ---- The course's form ----

// What only the harness needs: its main, the views and the probe.
static bool is_left_out(const char *file)
{
    static const char *const names[] = {"shaders/main.glsl", "shaders/views.glsl",
                                        "shaders/slice.glsl", "shaders/digits.glsl",
                                        "shaders/cover.glsl"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(file, names[i]) == 0)
            return true;
    return false;
}

// How often the lines that stay mention a word.
static int mentions(const struct export *e, const char *name)
{
    int count = 0, line = 0;
    const char *counted = e->code, *word = glsl_find_word(e->code, name);
    for (; word != NULL; word = glsl_find_word(word + 1, name)) {
        for (; counted < word; counted++)
            line += *counted == '\n';
        count += !is_left_out(e->source->files[e->source->lines[line].file]);
    }
    return count;
}

static void put_value(struct export *e, const struct parameter *parameter)
{
    if (parameter->type == PARAMETER_BOOL)
        put(e, "%s", parameter->value[0] > 0.5 ? "true" : "false");
    else if (parameter->type == PARAMETER_INT)
        put(e, "%d", (int)parameter->value[0]);
    else
        put_vector(e, parameter->value, parameter->components);
}

// Write the constant that stands for a uniform of the course; nothing where Shadertoy has it.
//   line, code  the line as it is, and without comments
//   uniform     the word in code
// Returns false for a line that is no such uniform.
static bool put_uniform(struct export *e, const char *line, const char *code, const char *uniform)
{
    static const char *const given[] = {"iResolution", "iTime",  "iTimeDelta",
                                        "iFrame",      "iMouse", "iDate"};
    const struct {
        const char *name;
        const float *value;
    } camera[] = {{"iCameraPosition", e->camera->position},
                  {"iCameraRight", e->basis.right},
                  {"iCameraUp", e->basis.up},
                  {"iCameraForward", e->basis.forward}};
    char type[32], name[64];
    int length = (int)strcspn(code, ";");
    if (sscanf(uniform, "uniform %31[a-zA-Z0-9_] %63[a-zA-Z0-9_]", type, name) != 2)
        return false;
    for (size_t i = 0; i < sizeof given / sizeof *given; i++)
        if (strcmp(name, given[i]) == 0)
            return true;
    // Its declaration is one mention. Shadertoy draws the picture in one part.
    bool offset = strcmp(name, "iPixelOffset") == 0;
    if (offset && mentions(e, name) == 1)
        return true;
    const struct parameter *parameter = parameters_find(e->parameters, name);
    const float *vector = NULL;
    for (int i = 0; i < 4; i++)
        if (strcmp(name, camera[i].name) == 0)
            vector = camera[i].value;
    if (parameter == NULL && vector == NULL && !offset)
        return false;
    put(e, "const%.*s = ", length - (int)(uniform - code) - 7, uniform + 7);
    if (offset)
        put(e, "vec2(0.0)");
    else if (vector != NULL)
        put_vec3(e, vector);
    else
        put_value(e, parameter);
    put(e, "%s\n", line + length);
    return true;
}

static void put_course_line(struct export *e, const char *line, size_t length, const char *code)
{
    char *text = strndup(line, length), *bare = strndup(code, length);
    if (text == NULL || bare == NULL) {
        e->failed = true;
    } else {
        const char *uniform = glsl_find_word(bare, "uniform");
        bool include = strncmp(text, "// #include", 11) == 0;
        if (!include && (uniform == NULL || !put_uniform(e, text, bare, uniform)))
            put(e, "%s\n", text);
    }
    free(text);
    free(bare);
}

// The name without its folder, which is that of this machine.
static const char *base_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

// The lines that stay, each file under its name.
static void put_files(struct export *e)
{
    const struct shader_source *source = e->source;
    const char *line = source->text;
    int file = -1;
    for (int i = 0; i < source->line_count; i++) {
        size_t length = strcspn(line, "\n");
        int from = source->lines[i].file;
        const char *name = source->files[from];
        if (!is_left_out(name)) {
            if (from != file)
                put(e, "\n// ---- %s ----\n\n", from == 0 ? base_of(name) : name);
            file = from;
            put_course_line(e, line, length, e->code + (line - source->text));
        }
        line += length + 1;
    }
}

static void put_course(struct export *e)
{
    put(e, "// %s for shadertoy.com, in one file: camera and parameters are constants here.\n",
        base_of(e->source->files[0]));
    if (mentions(e, "VIEW") > 0)
        put(e, "#define VIEW 0\n");
    put_files(e);
    put(e, "\n// ---- What Shadertoy calls ----\n\n"
           "void mainImage(out vec4 fragColor, in vec2 fragCoord)\n"
           "{\n"
           "    traceReset(-1);\n"
           "    vec3 colour = rayColour(pixelRay(screenPosition(fragCoord)));\n"
           "    fragColor = vec4(clamp(colour, 0.0, 1.0), 1.0);\n"
           "}\n");
}

// ---- A whole file ----

// Shadertoy has a main, and calls mainImage: those of the file get other names.
static const struct {
    const char *word, *instead;
} renamed[] = {{"main", "shaderMain"},
               {"mainImage", "shaderImage"},
               {"gl_FragColor", "shaderColour"},
               {"in", ""},
               {"out", ""},
               {"varying", ""},
               {"smooth", ""},
               {"flat", ""},
               {"noperspective", ""},
               {"centroid", ""}};

// Write one word of a whole file, or what stands for it. Qualifiers go where a global begins; those
// of parameters stay.
static void put_word(struct export *e, const char *word, size_t length, bool global)
{
    for (size_t i = 0; i < sizeof renamed / sizeof *renamed; i++)
        if (strlen(renamed[i].word) == length && strncmp(word, renamed[i].word, length) == 0 &&
            (i < 3 || global)) {
            put(e, "%s", renamed[i].instead);
            return;
        }
    put(e, "%.*s", (int)length, word);
}

static void blank_both(char *text, char *code, size_t from, size_t length)
{
    memset(text + from, ' ', length);
    memset(code + from, ' ', length);
}

// True for a uniform that Shadertoy declares itself.
static bool is_given(const char *uniform)
{
    const char *name;
    for (size_t i = 0; form_toy_input(i, &name) != NULL; i++) {
        const char *found = glsl_find_word(uniform, name);
        if (found != NULL && found < uniform + strcspn(uniform, ";"))
            return true;
    }
    return false;
}

// Blank what Shadertoy says itself or does not take: #version, the precision of numbers, the
// layouts of inputs and outputs, its own uniforms, and the word before a uniform that has a value.
static void blank_rest(char *text, char *code)
{
    char *version = strchr(code, '#');
    if (version != NULL && strncmp(version + 1 + strspn(version + 1, " \t"), "version", 7) == 0)
        blank_both(text, code, (size_t)(version - code), strcspn(version, "\n"));
    const char *word = code;
    while ((word = glsl_find_word(word, "precision")) != NULL)
        blank_both(text, code, (size_t)(word - code),
                   strcspn(word, ";") + (strchr(word, ';') != NULL));
    for (word = code; (word = glsl_find_word(word, "layout")) != NULL;)
        blank_both(text, code, (size_t)(word - code),
                   strcspn(word, ")") + (strchr(word, ')') != NULL));
    for (word = code; (word = glsl_find_word(word, "uniform")) != NULL; word++) {
        size_t length = strcspn(word, ";");
        if (is_given(word))
            blank_both(text, code, (size_t)(word - code), length + (word[length] == ';'));
        else if (memchr(word, '=', length) != NULL)
            blank_both(text, code, (size_t)(word - code), strlen("uniform"));
    }
}

// The text with its inputs and output as variables, comments as they are.
static void put_whole_text(struct export *e, const char *text)
{
    int depth = 0;
    for (size_t i = strspn(text, " \n"); text[i] != '\0';) {
        size_t length = 0;
        if (e->code[i] == text[i])
            while (glsl_is_word(e->code[i + length]))
                length++;
        if (length > 0) {
            put_word(e, text + i, length, depth == 0);
            i += length;
            continue;
        }
        char c = e->code[i];
        depth += (c == '{' || c == '(') - (c == '}' || c == ')');
        put(e, "%c", text[i++]);
    }
}

// The name of the output, of which the form has been judged: the first global "out", or the one at
// location 0.
static bool find_output(const char *code, char name[64])
{
    int depth = 0;
    bool found = false;
    for (const char *c = code; *c != '\0'; c++) {
        bool begins = c == code || !glsl_is_word(c[-1]);
        depth += (*c == '{' || *c == '(') - (*c == '}' || *c == ')');
        if (depth != 0 || !begins || strncmp(c, "out", 3) != 0 || glsl_is_word(c[3]))
            continue;
        const char *statement = c;
        while (statement > code && strchr(";}", statement[-1]) == NULL)
            statement--;
        const char *location = strstr(statement, "location");
        int number = 0, used = 0;
        bool placed = location != NULL && location < c &&
                      sscanf(location, "location = %d", &number) == 1 && number == 0;
        char type[32];
        const char *word = c + 3;
        while (sscanf(word, " %31[a-zA-Z0-9_]%n", type, &used) == 1 && glsl_at_precision(type))
            word += used;
        if (!found || placed)
            found = sscanf(word, " %*31[a-zA-Z0-9_] %63[a-zA-Z0-9_]", name) == 1;
    }
    return found;
}

static void put_input(struct export *e, const char *name, const char *value)
{
    if (glsl_find_word(e->code, name) != NULL && !form_declares(e->code, name))
        put(e, "    %s = %s;\n", name, value);
}

static void put_input_vector(struct export *e, const char *name, const float v[3])
{
    if (glsl_find_word(e->code, name) == NULL)
        return;
    put(e, "    %s = ", name);
    put_vec3(e, v);
    put(e, ";\n");
}

static bool put_whole(struct export *e)
{
    char output[64] = "shaderColour";
    char *text = strdup(e->source->text), *statements = strdup(e->code);
    bool found = statements != NULL;
    if (found) {
        glsl_blank_directives(statements);
        found = find_output(statements, output);
    }
    if (!found && glsl_find_word(e->code, "gl_FragColor") != NULL) {
        found = true;
        put(e, "vec4 shaderColour;\n");
    }
    free(statements);
    if (text == NULL)
        return false;
    blank_rest(text, e->code);
    put_whole_text(e, text);
    free(text);
    put(e, "\n// ---- What Shadertoy calls ----\n\n"
           "void mainImage(out vec4 toyColour, in vec2 toyPixel)\n{\n");
    put_input(e, "FragCoord", "(2.0 * toyPixel - iResolution.xy) / iResolution.y");
    put_input(e, "Time", "iTime");
    put_input_vector(e, "Ex", e->basis.right);
    put_input_vector(e, "Ey", e->basis.up);
    put_input_vector(e, "Ez", e->basis.forward);
    put_input_vector(e, "CamPos", e->camera->position);
    if (glsl_find_word(e->code, "fovValue") != NULL) {
        put(e, "    fovValue = ");
        put_float(e, (double)e->focal_length);
        put(e, ";\n");
    }
    put_input(e, "FacteurLargeur", "iResolution.x / iResolution.y");
    static const char *const zeros[] = {"OrthoView", "CustomToggle", "CustomInt"};
    for (int i = 0; i < 3; i++)
        put_input(e, zeros[i], "0.0");
    put(e, "    shaderMain();\n    toyColour = vec4(%s.rgb, 1.0);\n}\n", output);
    if (!found)
        report("%s: no output that Shadertoy could show: declare out vec4 FragColor;",
               e->source->files[0]);
    return found;
}

char *export_shadertoy(const struct shader_source *source, const struct parameters *parameters,
                       const struct camera *camera, float focal_length)
{
    struct export e = {.source = source,
                       .parameters = parameters,
                       .basis = camera_basis_of(camera),
                       .camera = camera,
                       .focal_length = focal_length,
                       .code = strdup(source->text)};
    bool done = e.code != NULL;
    if (done)
        glsl_blank_comments(e.code, false);
    if (done && source->form == SHADER_SHADERTOY)
        put(&e, "%s", source->text);
    else if (done && source->form == SHADER_COURSE)
        put_course(&e);
    else if (done)
        done = put_whole(&e);
    free(e.code);
    if (e.failed || e.text == NULL)
        report("%s: not enough memory", source->files[0]);
    if (done && !e.failed)
        return e.text;
    free(e.text);
    return NULL;
}
