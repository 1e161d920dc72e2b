#include "lib/fuzz.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "dialects/export.h"
#include "command/options.h"
#include "picture/texture.h"
#include "report.h"
#include "shader/parameter.h"
#include "command/sequence.h"
#include "shader/compile.h"
#include "lib/scratch.h"

const struct fuzz_target fuzz_targets[FUZZ_TARGETS] = {{"include", fuzz_include},
                                                       {"parameter", fuzz_parameter},
                                                       {"options", fuzz_options},
                                                       {"picture", fuzz_picture}};

// End the program if a promise is not kept.
static void promise(bool kept, const char *what)
{
    if (!kept) {
        printf("broken promise: %s\n", what);
        fflush(stdout);
        abort();
    }
}

// Check the report since capture_begin: it must be empty if the call succeeded, and one line
// otherwise.
static void promise_report(bool done)
{
    const char *said = capture_end();
    size_t length = strlen(said);
    for (const char *at = said; *at != '\0';)
        promise(report_next(&at, "\n") != 0xFFFD, "a message is harmless UTF-8");
    promise(length <= 2000, "a message is short");
    if (done)
        promise(length == 0, "an accepted input causes no message");
    else
        promise(line_count(said) == 1 && length > 1 && said[length - 1] == '\n',
                "a refused input causes a one-line message");
}

// Copy bytes into a string, in which zero bytes become spaces. The caller frees the string.
static char *string_of(const uint8_t *bytes, size_t size)
{
    char *text = malloc(size + 1);
    promise(text != NULL, "there is enough memory");
    for (size_t i = 0; i < size; i++)
        text[i] = bytes[i] == 0 ? ' ' : (char)bytes[i];
    text[size] = '\0';
    return text;
}

// ---- Includes ----

#define MAIN    "own/main.frag"
#define OUTSIDE "outside.glsl"
#define LOG     "log"

static const char *const names[] = {MAIN,
                                    "own/part.glsl",
                                    "own/deep/part.glsl",
                                    OUTSIDE,
                                    "root/shaders/library.glsl",
                                    "root/shaders/more.glsl",
                                    "own/a.png",
                                    LOG};
#define NAMES (sizeof names / sizeof *names)

// Return the name in a line "=== NAME", or NULL if the line is not of this form or the name is
// unknown.
static const char *begins(const uint8_t *line, size_t length)
{
    for (size_t i = 0; i < NAMES; i++)
        if (length == strlen(names[i]) + 4 && memcmp(line, "=== ", 4) == 0 &&
            memcmp(line + 4, names[i], length - 4) == 0)
            return names[i];
    return NULL;
}

// Split the bytes into files in the scratch folder. A file that the bytes do not name is empty.
static void write_files(const uint8_t *bytes, size_t size)
{
    const char *name = MAIN;
    const uint8_t *from = bytes, *end = bytes + size;
    for (size_t i = 0; i < NAMES; i++)
        scratch_write_bytes(names[i], "", 0);
    for (const uint8_t *line = bytes; line <= end;) {
        const uint8_t *stop = line < end ? memchr(line, '\n', (size_t)(end - line)) : NULL;
        stop = stop != NULL ? stop : end;
        const char *next = begins(line, (size_t)(stop - line));
        if (next != NULL || stop == end) {
            const uint8_t *to = next != NULL ? line : end;
            scratch_write_bytes(name, from, (size_t)(to - from));
            from = stop < end ? stop + 1 : end;
            name = next != NULL ? next : name;
        }
        line = stop + 1;
    }
}

static bool is_inside(const char *path, const char *folder)
{
    const char *whole = scratch_path(folder);
    return strncmp(path, whole, strlen(whole)) == 0 && path[strlen(whole)] == '/';
}

static void promise_source(const struct shader_source *source)
{
    int lines = 0;
    for (const char *c = source->text; *c != '\0'; c++)
        lines += *c == '\n';
    promise(lines == source->line_count && lines > 0, "each line of the text is in the table");
    promise(source->text[strlen(source->text) - 1] == '\n', "the last line ends with a line break");
    for (int i = 0; i < lines; i++)
        promise(source->lines[i].file >= 0 && source->lines[i].file < source->file_count &&
                    source->lines[i].line > 0,
                "each line comes from a line of a file");
    for (int i = 0; i < source->file_count; i++) {
        promise(is_inside(source->paths[i], "own") || is_inside(source->paths[i], "root"),
                "no file is outside the folders");
        for (int k = 0; k < i; k++)
            promise(strcmp(source->paths[i], source->paths[k]) != 0, "each file is read once");
    }
}

// Explain the driver's log in the file LOG.
static void explain(const struct shader_source *source, enum shader_view view)
{
    char log[8192];
    FILE *file = fopen(scratch_path(LOG), "rb");
    promise(file != NULL, "the log can be read");
    size_t size = fread(log, 1, sizeof log - 1, file);
    fclose(file);
    for (size_t i = 0; i < size; i++)
        log[i] = log[i] == '\0' ? ' ' : log[i];
    log[size] = '\0';
    char *words = shader_explain(source, view, log);
    promise(words != NULL, "a log is explained");
    free(words);
}

static void carry_on(struct shader_source *source)
{
    for (int view = 0; view < SHADER_PROGRAM_COUNT; view++) {
        char *text = shader_text(source, (enum shader_view)view);
        promise(text != NULL, "each view has a text");
        free(text);
        explain(source, (enum shader_view)view);
        if (source->dialect != DIALECT_COURSE)
            break;
    }
    struct parameters parameters;
    int files = source->file_count;
    struct camera camera = {.position = {0.0f, 1.0f, 4.0f}};
    capture_begin();
    bool done = parameters_read(&parameters, source);
    promise_report(done);
    for (int i = files; i < source->file_count; i++)
        promise(is_inside(source->paths[i], "own") || is_inside(source->paths[i], "root"),
                "no picture is outside the folders");
    if (!done)
        return;
    capture_begin();
    char *text = export_file(source, &parameters, &camera, 1.5f, false);
    promise_report(text != NULL);
    free(text);
    parameters_free(&parameters);
}

void fuzz_include(const uint8_t *bytes, size_t size)
{
    struct shader_source source;
    write_files(bytes, size);
    const char *shader = scratch_path(MAIN), *root = scratch_path("root");
    capture_begin();
    bool done = shader_read(&source, shader, root);
    promise_report(done);
    if (done) {
        promise_source(&source);
        carry_on(&source);
        shader_free(&source);
    }
    promise(source.text == NULL && source.files == NULL && source.lines == NULL,
            "nothing remains of a source that is refused or freed");
}

// ---- Parameters ----

// A source with this text, as shader_read would return it.
static struct shader_source source_of(char *text)
{
    struct shader_source source = {.text = text, .file_count = 1};
    for (const char *c = text; *c != '\0'; c++)
        source.line_count += *c == '\n';
    source.lines = calloc((size_t)source.line_count + 1, sizeof *source.lines);
    source.files = calloc(2, sizeof *source.files);
    source.paths = calloc(2, sizeof *source.paths);
    promise(source.lines != NULL && source.files != NULL && source.paths != NULL,
            "there is enough memory");
    source.files[0] = strdup("text");
    source.paths[0] = strdup(scratch_path("text"));
    source.root = strdup(scratch_path(""));
    source.own = strdup(scratch_path(""));
    glsl_read(&source.code, text);
    for (int i = 0; i < source.line_count; i++)
        source.lines[i].line = i + 1;
    return source;
}

static void promise_in_range(const struct parameter *p)
{
    for (int i = 0; i < p->components; i++)
        promise(p->value[i] >= p->minimum && p->value[i] <= p->maximum, "a value is in its range");
}

static void promise_parameter(struct parameters *all, int index)
{
    struct parameter *p = &all->item[index];
    char value[160], range[160], assignment[256];
    promise(p->name[0] != '\0' && p->meaning[0] != '\0', "a parameter has a name and a meaning");
    promise(parameters_find(all, p->name) == p, "a name occurs once");
    promise(p->components >= 1 && p->components <= 4, "there are one to four components");
    promise(p->minimum < p->maximum && p->step > 0.0 && isfinite(p->step),
            "range and step are valid");
    promise_in_range(p);

    parameter_value_text(p, value, sizeof value);
    parameter_range_text(p, range, sizeof range);
    snprintf(assignment, sizeof assignment, "%s=%s", p->name, value);
    struct parameter before = *p;
    promise(parameters_assign(all, assignment), "a printed value can be assigned");
    for (int i = 0; i < p->components; i++)
        promise((float)p->value[i] == (float)before.value[i],
                "assigning a printed value does not change it");
    static const int presses[] = {1, -2, 1000, -100000, 1};
    for (size_t i = 0; i < sizeof presses / sizeof *presses; i++) {
        parameter_change(p, presses[i]);
        promise_in_range(p);
    }
    parameter_reset(p);
    for (int i = 0; i < p->components; i++)
        promise(p->value[i] == p->initial[i], "a reset restores the file's value");
}

void fuzz_parameter(const uint8_t *bytes, size_t size)
{
    const uint8_t *end = size > 0 ? memchr(bytes, '\n', size) : NULL;
    size_t first = end != NULL ? (size_t)(end - bytes) : size;
    char *assignment = string_of(bytes, first);
    char *text = string_of(bytes + first, size - first);
    if (access(scratch_path("text"), F_OK) != 0)
        scratch_write("text", ""); // the file that samplers name; it is not read here
    struct shader_source source = source_of(text);
    struct parameters parameters;
    capture_begin();
    bool done = parameters_read(&parameters, &source);
    promise_report(done);
    if (done) {
        capture_begin();
        promise_report(parameters_assign(&parameters, assignment));
        for (int i = 0; i < parameters.count; i++)
            promise_parameter(&parameters, i);
        for (int i = 0; i < parameters.samplers.count; i++) {
            const struct sampler *s = &parameters.samplers.item[i];
            promise(s->name[0] != '\0' && s->meaning[0] != '\0' && s->slices >= 0 &&
                        s->slices <= SAMPLER_SLICES && s->file < source.file_count,
                    "a sampler has all its parts");
        }
        FILE *nowhere = fopen("/dev/null", "w");
        promise(nowhere != NULL, "/dev/null can be opened");
        parameters_print(&parameters, nowhere);
        samplers_print(&parameters.samplers, &source, nowhere);
        fclose(nowhere);
        parameters_free(&parameters);
    }
    shader_free(&source);
    free(text);
    free(assignment);
}

// ---- Pictures ----

// The checksum of a chunk of a PNG.
static uint32_t checksum(const uint8_t *bytes, size_t size)
{
    uint32_t sum = 0xFFFFFFFFu;
    for (size_t i = 0; i < size; i++) {
        sum ^= bytes[i];
        for (int k = 0; k < 8; k++)
            sum = sum >> 1 ^ (0xEDB88320u & (0u - (sum & 1u)));
    }
    return ~sum;
}

// Correct the checksum of each chunk, because random bytes would never have the right one.
static void mend(uint8_t *bytes, size_t size)
{
    for (size_t at = 8; at + 12 <= size;) {
        size_t length = (size_t)bytes[at] << 24 | (size_t)bytes[at + 1] << 16 |
                        (size_t)bytes[at + 2] << 8 | bytes[at + 3];
        if (length > size - at - 12)
            return;
        uint32_t sum = checksum(bytes + at + 4, length + 4);
        for (int i = 0; i < 4; i++)
            bytes[at + 8 + length + (size_t)i] = (uint8_t)(sum >> (24 - 8 * i));
        at += length + 12;
    }
}

static void promise_levels(const struct texture_image *image, int slices)
{
    promise(image->count >= 1 && image->count <= TEXTURE_LEVELS,
            "the number of levels is in its range");
    promise(image->size[0][2] == slices, "there are as many slices as requested");
    for (int i = 0; i < image->count; i++)
        for (int k = 0; k < 3; k++) {
            int side = image->size[i][k], before = i > 0 ? image->size[i - 1][k] : side;
            promise(side >= 1 && side <= IMAGE_SIDE_LIMIT, "a side is in its range");
            promise(i == 0 || side == (before > 1 ? before / 2 : 1),
                    "each side is half that of the level before");
        }
    const int *last = image->size[image->count - 1];
    promise(last[0] * last[1] * last[2] == 1, "the last level is one texel");
}

void fuzz_picture(const uint8_t *bytes, size_t size)
{
    uint8_t flags = size > 0 ? bytes[0] : 0;
    size_t length = size > 0 ? size - 1 : 0;
    uint8_t *copy = calloc(length + 1, 1);
    promise(copy != NULL, "there is enough memory");
    memcpy(copy, bytes + (size > 0), length);
    mend(copy, length);
    const char *path = scratch_write_bytes("picture.png", copy, length);
    const struct sampler sampler = {
        .srgb = flags & 1, .repeat = flags & 2, .slices = flags & 4 ? (flags >> 3) + 1 : 0};
    struct texture_image image;
    char why[IMAGE_WHY] = "";
    if (texture_image_read(&image, &sampler, path, why))
        promise_levels(&image, sampler.slices > 0 ? sampler.slices : 1);
    else
        promise(image.count == 0 && why[0] != '\0' && strchr(why, '\n') == NULL,
                "a refused picture has a reason");
    texture_image_free(&image);
    free(copy);
}

// ---- The command line ----

static void promise_options(const struct options *o, int argc)
{
    promise(o->width >= 1 && o->width <= OPTIONS_SIZE_LIMIT && o->height >= 1 &&
                o->height <= OPTIONS_SIZE_LIMIT,
            "the size is in its range");
    promise(o->samples >= 1 && o->samples <= OPTIONS_SAMPLES_LIMIT,
            "the samples are in their range");
    promise(fabs(o->time) <= 1e9, "the time is in its range");
    promise(o->setting_count >= 0 && o->setting_count < argc,
            "there are fewer settings than arguments");
    promise(o->texture_count >= 0 && o->texture_count < argc,
            "there are fewer textures than arguments");
    for (int i = 0; i < 4; i++)
        promise(o->channels[i] == NULL || o->channels[i][0] != '\0', "a channel names a file");
    promise(o->view < SHADER_VIEW_COUNT, "the view can be selected");
    promise(!o->has_camera || (fabs((double)o->camera.position[0]) <= 1e9 &&
                               fabsf(o->camera.tilt) <= CAMERA_TILT_LIMIT),
            "the camera is in its range");
    for (int i = 0; i < o->probe_count; i++)
        promise(o->probe[i][0] >= 0 && o->probe[i][0] < o->width && o->probe[i][1] >= 0 &&
                    o->probe[i][1] < o->height,
                "the probe is inside the picture");
    promise(o->frames >= 0 && o->fps >= 0.0 && o->benchmark >= 0, "counts are not negative");
    char path[512];
    if (o->frames > 0) {
        promise(fabs(o->time + o->frames / (o->fps > 0.0 ? o->fps : OPTIONS_FPS)) <= 1e9,
                "the last time is in its range");
        capture_begin();
        promise_report(sequence_path(o->output, o->frames - 1, path, sizeof path));
    }
}

void fuzz_options(const uint8_t *bytes, size_t size)
{
    char *text = string_of(bytes, size), program[] = "program";
    char *words[66] = {program};
    int count = 1;
    for (char *word = text; word != NULL && count < 65;) {
        char *end = strchr(word, '\n');
        words[count++] = word;
        if (end != NULL)
            *end++ = '\0';
        word = end;
    }
    struct options options;
    capture_begin();
    bool done = options_parse(&options, count, words);
    promise_report(done);
    if (done) {
        promise_options(&options, count);
        options_free(&options);
    }
    promise(options.settings == NULL, "nothing remains of a command line that is refused or freed");
    free(text);
}
