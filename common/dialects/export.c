#include "dialects/export.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "shader/glsl.h"
#include "dialects/tool_inputs.h"
#include "dialects/translate.h"
#include "shader/view.h"
#include "memory.h"
#include "number.h"
#include "report.h"

// An export in progress.
struct export
{
    struct shader_source *source;
    const struct parameters *parameters;
    struct camera_basis basis;
    const struct camera *camera;
    float focal_length;
    const struct glsl *code; // the source's tokens
    bool writes;             // the file is a figure, which may write numbers
    bool page;               // parameters and textures remain uniforms, which a page sets
    FILE *text;
};

// Write a number as a float in GLSL ES, with a decimal point or an exponent.
static void put_float(struct export *e, double value)
{
    char text[NUMBER_SIZE];
    number_text(value, text, sizeof text);
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

static void put_value(struct export *e, const struct parameter *parameter)
{
    if (parameter->type == PARAMETER_BOOL)
        fprintf(e->text, "%s", parameter->value[0] > 0.5 ? "true" : "false");
    else if (parameter->type == PARAMETER_INT)
        fprintf(e->text, "%d", (int)parameter->value[0]);
    else
        put_vector(e, parameter->value, parameter->components);
}

// Write the value of an input on Shadertoy, where the camera is constant, and the picture is drawn
// as a whole, with one sample per pixel. Returns the value's number of components.
static int put_meaning(struct export *e, const struct input *input)
{
    static const struct {
        const char *text;
        int components;
    } given[INPUT_VALUES] = {[INPUT_SIZE] = {"iResolution", 3},
                             [INPUT_TIME] = {"iTime", 1},
                             [INPUT_STEP] = {"iTimeDelta", 1},
                             [INPUT_RATE] = {"iFrameRate", 1},
                             [INPUT_FRAME] = {"float(iFrame)", 1},
                             [INPUT_DATE] = {"iDate", 4},
                             [INPUT_MOUSE] = {"iMouse", 4},
                             [INPUT_POINTER] = {"iMouse", 4},
                             [INPUT_POINTER_SHARE] = {"(iMouse.xy / iResolution.xy)", 2},
                             [INPUT_SOUND_RATE] = {"iSampleRate", 1},
                             [INPUT_ASPECT] = {"(iResolution.x / iResolution.y)", 1}};
    const float *const camera[] = {[INPUT_EYE] = e->camera->position,
                                   [INPUT_RIGHT] = e->basis.right,
                                   [INPUT_UP] = e->basis.up,
                                   [INPUT_FORWARD] = e->basis.forward,
                                   [INPUT_FOCAL] = &e->focal_length};
    enum input_meaning meaning = input->meaning;
    if (meaning >= INPUT_EYE && meaning <= INPUT_FOCAL) {
        int components = meaning == INPUT_FOCAL ? 1 : 3;
        double value[3] = {0.0};
        for (int i = 0; i < components; i++)
            value[i] = (double)camera[meaning][i];
        put_vector(e, value, components);
        return components;
    }
    if (meaning == INPUT_POSITION) {
        const char *from = strstr(input->text, "harnessPosition");
        const char *screen = "(2.0 * toyPixel - iResolution.xy) / iResolution.y";
        fprintf(e->text, "(%.*s(%s)%s)", (int)(from - input->text), input->text, screen,
                from + strlen("harnessPosition"));
        return 2;
    }
    if (meaning == INPUT_CHANNEL_SIZE) {
        fprintf(e->text, "iChannelResolution[%d]", input->channel);
        return 3;
    }
    if (meaning == INPUT_DRAW) {
        bool vector = input->type[0] == 'v', count = strcmp(input->name, "iSamples") == 0;
        fputs(vector ? "vec2(0.0)" : count ? "1" : "0", e->text);
        return vector ? 2 : 1;
    }
    bool known = meaning < INPUT_VALUES && given[meaning].text != NULL;
    fprintf(e->text, "%s", known ? given[meaning].text : "0.0");
    return known ? given[meaning].components : 1;
}

// ---- The course's dialect ----

// True for files that only the harness needs: its main, the views and the probe.
static bool is_left_out(const struct export *e, const char *file)
{
    static const char *const names[] = {
        "shaders/main.glsl", "shaders/views.glsl",     "shaders/ramp.glsl",  "shaders/slice.glsl",
        "shaders/plot.glsl", "shaders/positions.glsl", "shaders/cover.glsl", "shaders/room.glsl"};
    if (strcmp(file, "shaders/signs.glsl") == 0)
        return !e->writes;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (strcmp(file, names[i]) == 0)
            return true;
    return false;
}

// How often the exported lines mention a word.
static int mentions(const struct export *e, const char *name)
{
    int count = 0;
    for (const struct glsl_token *t = e->code->item; t->kind != GLSL_END; t++)
        count +=
            glsl_is(t, name) && !is_left_out(e, e->source->files[e->source->lines[t->line].file]);
    return count;
}

// Write the constant that replaces a uniform of the course, and the rest of its line. Write nothing
// if Shadertoy declares the uniform, or if the uniform's value changes with each draw and only its
// declaration mentions it. Returns false for any other uniform.
static bool put_uniform(struct export *e, const struct glsl_token *uniform)
{
    const struct glsl_token *name = uniform + 2, *end = uniform;
    if (uniform[1].kind != GLSL_WORD || name->kind != GLSL_WORD)
        return false;
    const struct parameter *parameter = parameters_find(e->parameters, name->text);
    const struct input *input = tool_inputs_find(name->text);
    bool course = input != NULL && inputs_is_course(input);
    bool draw = course && input->meaning == INPUT_DRAW;
    bool vector = course && input->meaning >= INPUT_EYE && input->meaning <= INPUT_FORWARD;
    if ((course && tool_inputs_is_shadertoy(input)) || (draw && mentions(e, name->text) == 1))
        return true;
    if ((parameter == NULL && !vector && !draw) || (parameter != NULL && e->page))
        return false;
    while (end->kind != GLSL_END && end->sign != ';')
        end++;
    int begin = uniform->begin + uniform->length;
    const char *text = e->code->text, *rest = text + end->begin;
    fprintf(e->text, "const%.*s = ", end->begin - begin, text + begin);
    if (parameter != NULL)
        put_value(e, parameter);
    else
        put_meaning(e, input);
    fprintf(e->text, "%.*s\n", (int)strcspn(rest, "\n"), rest);
    return true;
}

// Write the shader's name without its folder. A backslash at the end of the comment would continue
// it on the next line, so every backslash becomes a question mark.
static void put_name(struct export *e, const char *before)
{
    const char *path = e->source->files[0], *slash = strrchr(path, '/');
    fprintf(e->text, "%s", before);
    for (const char *c = slash != NULL ? slash + 1 : path; *c != '\0'; c++)
        fprintf(e->text, "%c", *c == '\\' ? '?' : *c);
}

// Write the exported lines, each file's lines under the file's name.
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
            uniform = uniform == NULL && glsl_is(t, "uniform") ? t : uniform;
        if (is_left_out(e, name))
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

// Define the names of views that the exported lines mention, where VIEW_OF_TRACE mentions several.
// The view is the picture.
static void put_views(struct export *e)
{
    char *lines = shader_view_lines(VIEW_PICTURE), name[64];
    bool picture = mentions(e, "VIEW") > 0, all = mentions(e, "VIEW_OF_TRACE") > 0;
    for (const char *line = lines; sscanf(line, "#define %63s", name) == 1;
         line += strcspn(line, "\n") + 1)
        if (all || mentions(e, name) > 0 || (picture && strcmp(name, "VIEW_PICTURE") == 0))
            fprintf(e->text, "%.*s\n", (int)strcspn(line, "\n"), line);
    free(lines);
}

static void put_course(struct export *e)
{
    put_name(e, "// ");
    fprintf(
        e->text,
        e->page
            ? " for a page, in one file: the camera is constant.\n"
            : " for shadertoy.com, in one file: the camera and the parameters are constants.\n");
    put_views(e);
    if (mentions(e, "EXPORTED") > 0)
        fprintf(e->text, "#define EXPORTED\n");
    if (!e->page && mentions(e, "SHADERTOY") > 0)
        fprintf(e->text, "#define SHADERTOY\n");
    put_files(e);
    fprintf(e->text,
            "\n// ---- The function that %s calls ----\n\n"
            "void mainImage(out vec4 fragColor, in vec2 fragCoord)\n"
            "{\n"
            "    traceReset(-1);\n"
            "    iPixel = ivec2(floor(fragCoord));\n"
            "    vec3 colour = rayColour(pixelRay(screenPosition(fragCoord)));\n"
            "    fragColor = vec4(clamp(colour, 0.0, 1.0), 1.0);\n"
            "}\n",
            e->page ? "the page" : "Shadertoy");
}

// ---- Other dialects ----

// Write the statement that sets an input, with the type that the file declares, if Shadertoy lacks
// the input or declares it with another type.
static void put_input(struct export *e, const struct shader_input *in)
{
    static const char *const parts[] = {"", ".x", ".xy", ".xyz", ""};
    static const char *const zeros[] = {"", ", 0.0", ", 0.0, 0.0", ", 0.0, 0.0, 0.0"};
    fprintf(e->text, "    %s%s = %s", tool_inputs_is_shadertoy(in->input) ? "own_" : "",
            in->input->name, in->integer ? "int(" : "");
    if (in->components > 1)
        fprintf(e->text, "vec%d(", in->components);
    int count = put_meaning(e, in->input);
    if (count > in->components)
        fprintf(e->text, "%s", parts[in->components]);
    else
        fprintf(e->text, "%s", zeros[in->components - count]);
    fprintf(e->text, "%s%s;\n", in->components > 1 ? ")" : "", in->integer ? ")" : "");
}

// Undefine a name that the code after the text uses, if the text leaves it defined as a macro.
static void put_undefined(struct export *e, const char *word)
{
    const struct glsl_name *name = glsl_name(e->code, word);
    if (name != NULL && name->defined != GLSL_NEVER)
        fprintf(e->text, "#undef %s\n", word);
}

static bool put_foreign(struct export *e)
{
    struct shader_source *source = e->source;
    char *front = NULL, *body = NULL;
    if (!translate(source, TRANSLATE_SHADERTOY, &front, &body))
        return false;
    fprintf(e->text, "%s%s", front != NULL ? front : "", body + strspn(body, " \n"));
    bool wraps = front != NULL, toy = source->dialect == DIALECT_SHADERTOY;
    struct declared output = declared_output(e->code);
    bool old = output.kind == DECLARED_NONE;
    free(front);
    free(body);
    put_undefined(e, "main"); // Shadertoy's own code follows
    put_undefined(e, "gl_FragCoord");
    if (!wraps)
        return true;
    fprintf(e->text, "\n// ---- The function that Shadertoy calls ----\n\n");
    for (int i = 0; i < source->input_count; i++)
        put_undefined(e, source->inputs[i].input->name);
    for (int i = 0; i < e->parameters->count; i++)
        put_undefined(e, e->parameters->item[i].name);
    if (output.kind != DECLARED_NONE)
        put_undefined(e, output.word);
    fprintf(e->text, "void mainImage(out vec4 toyColour, in vec2 toyPixel)\n{\n");
    for (int i = 0; i < source->input_count; i++)
        if (!tool_inputs_is_own(&source->inputs[i]))
            put_input(e, &source->inputs[i]);
    for (int i = 0; i < e->parameters->count; i++) {
        fprintf(e->text, "    %s = ", e->parameters->item[i].name);
        put_value(e, &e->parameters->item[i]);
        fprintf(e->text, ";\n");
    }
    if (toy)
        fprintf(e->text, "    shaderImage(toyColour, toyPixel);\n}\n");
    else if (!old && !output.name->certain) // an #if selects one of several outputs
        fprintf(e->text, "    shaderMain();\n    toyColour = shaderShown();\n}\n");
    else
        fprintf(e->text, "    shaderMain();\n    toyColour = vec4(%s.rgb, 1.0);\n}\n",
                old ? "shaderColour" : output.word);
    return toy || !old || glsl_mentions(e->code, "gl_FragColor") > 0 ||
           glsl_mentions(e->code, "gl_FragData") > 0 ||
           report("%s: no output that Shadertoy could show: declare out vec4 FragColor;",
                  source->files[0]);
}

// The argument of picture_of.
struct pictures {
    const struct shader_source *source;
    const struct samplers *samplers;
};

static const char *picture_of(const void *pictures, int i)
{
    const struct pictures *p = pictures;
    const struct sampler *sampler = &p->samplers->item[i];
    return sampler->pass > 0 ? "the last frame" : p->source->files[sampler->file];
}

char *export_file(struct shader_source *source, const struct parameters *parameters,
                  const struct camera *camera, float focal_length, bool page)
{
    bool course = source->dialect == DIALECT_COURSE, done = true;
    struct export e = {.source = source,
                       .parameters = parameters,
                       .basis = camera_basis_of(camera),
                       .camera = camera,
                       .focal_length = focal_length,
                       .code = &source->code,
                       .writes = shader_includes(source, "shaders/figure.glsl"),
                       .page = page};
    char *text;
    if (page && !course) {
        report("%s: --print-shader=page prints shaders of the course only: use "
               "--print-shader=shadertoy",
               source->files[0]);
        return NULL;
    }
    bool keeps = samplers_keep(&parameters->samplers);
    if (page && keeps) {
        report("%s: reads the last frame: a page that draws a shader itself keeps no frames: leave "
               "out =page to print code that runs here",
               source->files[0]);
        return NULL;
    }
    if (source->pass_count > 0) {
        report("%s: has several passes, and an export has one: leave out =shadertoy to print the "
               "code of the picture",
               source->files[0]);
        return NULL;
    }
    if (!page && course && parameters->samplers.count > 0) {
        const struct pictures pictures = {source, &parameters->samplers};
        text = memory_list(parameters->samplers.count, picture_of, &pictures);
        report("%s: reads %s: Shadertoy accepts no files%s: leave out =shadertoy to print "
               "code that runs here",
               source->files[0], text, keeps ? ", and an export has no buffers" : "");
        free(text);
        return NULL;
    }
    e.text = memory_open(&text);
    if (course)
        put_course(&e);
    else
        done = put_foreign(&e);
    memory_close(e.text);
    if (done)
        return text;
    free(text);
    return NULL;
}
