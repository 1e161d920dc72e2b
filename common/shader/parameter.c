#include "shader/parameter.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "number.h"
#include "report.h"

#define TEXT_SIZE 160 // size of a value or a range as text, in bytes

enum { COLUMNS = 6 }; // maximum number of columns of a table

void parameters_free(struct parameters *parameters)
{
    free(parameters->item);
    free(parameters->samplers.item);
    *parameters = (struct parameters){0};
}

struct parameter *parameters_find(const struct parameters *parameters, const char *name)
{
    for (int i = 0; i < parameters->count; i++)
        if (strcmp(parameters->item[i].name, name) == 0)
            return &parameters->item[i];
    return NULL;
}

// ---- Values ----

void parameter_value_text(const struct parameter *parameter, char *text, size_t size)
{
    size_t used = 0;
    if (parameter->type == PARAMETER_BOOL) {
        snprintf(text, size, "%s", parameter->value[0] != 0.0 ? "true" : "false");
        return;
    }
    for (int i = 0; i < parameter->components && used < size; i++) {
        char number[32];
        number_text(parameter->value[i], number, sizeof number);
        used += (size_t)snprintf(text + used, size - used, "%s%s", i > 0 ? "," : "", number);
    }
}

void parameter_range_text(const struct parameter *parameter, char *text, size_t size)
{
    char minimum[32], maximum[32];
    if (parameter->type == PARAMETER_BOOL) {
        snprintf(text, size, "true or false");
        return;
    }
    number_text(parameter->minimum, minimum, sizeof minimum);
    number_text(parameter->maximum, maximum, sizeof maximum);
    snprintf(text, size, "[%s, %s]", minimum, maximum);
}

// A description of the parameter's values, for messages.
static const char *expected(const struct parameter *parameter)
{
    static const char *const numbers[] = {"one number", "two numbers, as in 1,0.5",
                                          "three numbers, as in 1,0.9,0.5",
                                          "four numbers, as in 1,0.9,0.5,1"};
    if (parameter->type == PARAMETER_BOOL)
        return "true or false";
    if (parameter->type == PARAMETER_INT)
        return "one whole number";
    return numbers[parameter->components - 1];
}

static bool read_bool(const char *text, double *value)
{
    *value = strcmp(text, "true") == 0 || strcmp(text, "1") == 0;
    return *value != 0.0 || strcmp(text, "false") == 0 || strcmp(text, "0") == 0;
}

// Read exactly as many numbers as the parameter has components, separated by commas.
static bool read_numbers(const struct parameter *parameter, const char *text, double value[4])
{
    for (int i = 0; i < parameter->components; i++) {
        text += strspn(text, " ");
        size_t length = number_begin(text, &value[i]);
        if (length == 0 || !isfinite(value[i]))
            return false;
        text += length;
        text += strspn(text, " ");
        if (*text != (i + 1 < parameter->components ? ',' : '\0'))
            return false;
        text += *text == ',';
        if (parameter->type == PARAMETER_INT && value[i] != floor(value[i]))
            return false;
    }
    return true;
}

static const char *parameter_name(const void *parameters, int i)
{
    return ((const struct parameters *)parameters)->item[i].name;
}

// Report an assignment to an unknown name, list the known names, and free the list. Always returns
// false.
static bool report_unknown(const char *option, const char *assignment, const char *what, int count,
                           char *names)
{
    if (count == 0)
        report("--%s %s: this shader has no %ss", option, assignment, what);
    else
        report("--%s %s: unknown %s: this shader has %s", option, assignment, what, names);
    free(names);
    return false;
}

bool parameters_assign(const struct parameters *parameters, const char *assignment)
{
    char name[sizeof parameters->item->name] = "", range[TEXT_SIZE];
    double value[4] = {0};
    size_t length = strcspn(assignment, "=");
    if (assignment[length] == '\0' || length == 0)
        return report("--set %s: not of the form NAME=VALUE", assignment);
    if (length < sizeof name)
        memcpy(name, assignment, length);
    struct parameter *parameter = parameters_find(parameters, name);
    if (parameter == NULL)
        return report_unknown("set", assignment, "parameter", parameters->count,
                              memory_list(parameters->count, parameter_name, parameters));
    const char *text = assignment + length + 1;
    if (parameter->type == PARAMETER_BOOL ? !read_bool(text, value)
                                          : !read_numbers(parameter, text, value))
        return report("--set %s: the value must be %s%s", assignment, expected(parameter),
                      parameter->type == PARAMETER_FLOAT && parameter->components == 1
                          ? number_hint(text)
                          : "");
    parameter_range_text(parameter, range, TEXT_SIZE);
    for (int i = 0; i < parameter->components; i++)
        if (value[i] < parameter->minimum || value[i] > parameter->maximum)
            return report("--set %s: out of range: %s takes %s%s%s", assignment, name, range,
                          parameter->unit[0] != '\0' ? " " : "", parameter->unit);
    memcpy(parameter->value, value, sizeof value);
    return true;
}

static double clamp(double value, double minimum, double maximum)
{
    return value < minimum ? minimum : value > maximum ? maximum : value;
}

void parameters_keep(const struct parameters *new_ones, const struct parameters *old_ones)
{
    for (int i = 0; i < new_ones->count; i++) {
        struct parameter *to = &new_ones->item[i];
        const struct parameter *from = parameters_find(old_ones, to->name);
        if (from == NULL || from->type != to->type || from->components != to->components)
            continue;
        for (int k = 0; k < to->components; k++)
            if (to->initial[k] == from->initial[k])
                to->value[k] = clamp(from->value[k], to->minimum, to->maximum);
    }
}

// Remove the rounding errors of a sum of steps: 0.1 + 0.1 + 0.1 is 0.30000000000000004, and this
// minus 0.3 is not 0.
static double without_drift(double value, double step)
{
    if (fabs(value) < 1e-6 * step)
        return 0.0;
    double scale = pow(10.0, 11.0 - floor(log10(fabs(value))));
    return isfinite(scale) && scale > 0.0 ? round(value * scale) / scale : value;
}

static double changed(const struct parameter *parameter, double value, int presses)
{
    double next = parameter->multiplies ? value * pow(parameter->step, presses)
                                        : value + parameter->step * presses;
    if (parameter->type == PARAMETER_INT) {
        next = round(next);
        // Even a small factor must change a small integer.
        if (next == value && presses != 0)
            next += presses > 0 ? 1.0 : -1.0;
    } else
        next = without_drift(next, parameter->multiplies ? 0.0 : parameter->step);
    return clamp(next, parameter->minimum, parameter->maximum);
}

void parameter_change(struct parameter *parameter, int presses)
{
    if (parameter->type == PARAMETER_BOOL) {
        parameter->value[0] = (parameter->value[0] != 0.0) != (presses != 0) ? 1.0 : 0.0;
        return;
    }
    for (int i = 0; i < parameter->components; i++)
        parameter->value[i] = changed(parameter, parameter->value[i], presses);
}

double parameter_fraction(const struct parameter *parameter, int part)
{
    double low = parameter->minimum, high = parameter->maximum, value = parameter->value[part];
    if (parameter->multiplies)
        return log(value / low) / log(high / low);
    return high > low ? (value - low) / (high - low) : 0.0;
}

void parameter_put(struct parameter *parameter, int part, double fraction)
{
    double low = parameter->minimum, high = parameter->maximum;
    double at = clamp(fraction, 0.0, 1.0);
    double value = parameter->multiplies ? low * pow(high / low, at) : low + (high - low) * at;
    double unit = pow(10.0, floor(log10(parameter->multiplies ? value : high - low)) -
                                (parameter->multiplies ? 2.0 : 3.0));
    if (parameter->type != PARAMETER_FLOAT)
        unit = 1.0;
    // Divide by a whole number if possible: 3 / 10 is the double nearest to 0.3, but 3 * 0.1 is
    // not.
    value = unit < 1.0 ? round(value / unit) / round(1.0 / unit) : round(value / unit) * unit;
    parameter->value[part] = clamp(value, low, high);
}

bool parameter_is_hour(const struct parameter *parameter)
{
    return strcmp(parameter->unit, "hour of the day") == 0;
}

bool parameter_is_colour(const struct parameter *parameter)
{
    return parameter->components == 3 && strcmp(parameter->unit, "linear RGB") == 0;
}

void parameter_reset(struct parameter *parameter)
{
    memcpy(parameter->value, parameter->initial, sizeof parameter->value);
}

// ---- Samplers ----

// The argument of sampler_name.
struct readers {
    const struct samplers *samplers;
    const struct shader_source *source;
};

static const char *sampler_name(const void *readers, int i)
{
    const struct readers *r = readers;
    return r->source->dialect == DIALECT_COURSE ? r->samplers->item[i].name
                                                : r->source->samplers[i].name;
}

// True if a sampler has the name in NAME=FILE; otherwise reports an error.
static bool knows(const struct readers *readers, int count, const char *assignment)
{
    size_t length = strcspn(assignment, "=");
    for (int i = 0; i < count; i++) {
        const char *name = sampler_name(readers, i);
        if (strlen(name) == length && strncmp(name, assignment, length) == 0)
            return true;
    }
    return report_unknown("texture", assignment, "texture", count,
                          memory_list(count, sampler_name, readers));
}

bool samplers_fit(const struct samplers *samplers, const struct shader_source *source)
{
    const struct shader_request *request = &source->request;
    const struct readers readers = {samplers, source};
    bool course = source->dialect == DIALECT_COURSE;
    for (int i = 0; i < request->texture_count; i++)
        if (!knows(&readers, course ? samplers->count : source->sampler_count,
                   request->textures[i]))
            return false;
    for (int i = 0; request->channels != NULL && i < 4; i++) {
        int sampler = 0;
        while (sampler < source->sampler_count && source->samplers[sampler].channel != i)
            sampler++;
        if (request->channels[i] != NULL && course)
            return report("--channel %d=%s: the shader is in the course's dialect: use "
                          "--texture NAME=FILE.png for its samplers",
                          i, request->channels[i]);
        if (request->channels[i] != NULL && sampler == source->sampler_count)
            return report("--channel %d=%s: the shader does not read iChannel%d", i,
                          request->channels[i], i);
    }
    return true;
}

bool samplers_keep(const struct samplers *samplers)
{
    for (int i = 0; i < samplers->count; i++)
        if (samplers->item[i].pass > 0)
            return true;
    return false;
}

bool sampler_refuse(const struct shader_source *source, const struct sampler *sampler,
                    const char *format, ...)
{
    char why[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(why, sizeof why, format, arguments);
    va_end(arguments);
    return shader_refuse(source, sampler->line, "sampler %s: %s%s%s", sampler->name,
                         sampler->file < 0 ? "" : source->files[sampler->file],
                         sampler->file < 0 ? "" : ": ", why);
}

// ---- The tables ----

// The width in characters, not bytes: a degree sign counts once.
static int width_of(const char *text)
{
    int width = 0;
    for (; *text != '\0'; text++)
        width += ((unsigned char)*text & 0xC0) != 0x80;
    return width;
}

// Print rows of cells, each column as wide as its widest cell, and free the cells.
//   cell  the titles, then one row for each parameter or sampler
static void print_table(FILE *file, int columns, int rows, char *cell[])
{
    int width[COLUMNS] = {0};
    for (int i = 0; i < columns * rows; i++)
        if (width_of(cell[i]) > width[i % columns])
            width[i % columns] = width_of(cell[i]);
    for (int i = 0; i < columns * rows; i++) {
        bool last = (i + 1) % columns == 0;
        fprintf(file, "%s%*s%s", cell[i], last ? 0 : width[i % columns] - width_of(cell[i]) + 2, "",
                last ? "\n" : "");
        free(cell[i]);
    }
    free(cell);
}

// Begin a table with its titles.
static char **new_table(int columns, int rows, const char *const titles[])
{
    char **cell = memory_zeros((size_t)(columns * (rows + 1)), sizeof *cell);
    for (int i = 0; i < columns; i++)
        cell[i] = memory_text("%s", titles[i]);
    return cell;
}

void parameters_print(const struct parameters *parameters, FILE *file)
{
    static const char *const titles[] = {"name", "value", "range", "unit", "meaning"};
    if (parameters->count == 0) {
        fprintf(file, "This shader has no parameters.\n");
        return;
    }
    char **cell = new_table(5, parameters->count, titles), text[TEXT_SIZE];
    for (int i = 0; i < parameters->count; i++) {
        const struct parameter *p = &parameters->item[i];
        char **row = cell + 5 * (i + 1);
        bool unit = p->unit[0] != '\0', handle = p->handle != HANDLE_NONE;
        row[0] = memory_text("%s", p->name);
        parameter_value_text(p, text, sizeof text);
        row[1] = memory_text("%s", text);
        parameter_range_text(p, text, sizeof text);
        row[2] = memory_text("%s", text);
        row[3] = memory_text("%s%s%s", unit || handle ? p->unit : "-", unit && handle ? ", " : "",
                             handle ? "handle" : "");
        row[4] = memory_text("%s", p->meaning);
    }
    print_table(file, 5, parameters->count + 1, cell);
}

void samplers_print(const struct samplers *samplers, const struct shader_source *source, FILE *file)
{
    static const char *const titles[] = {"texture", "file",   "colour",
                                         "edge  ",  "slices", "meaning"};
    if (samplers->count == 0)
        return;
    char **cell = new_table(6, samplers->count, titles);
    for (int i = 0; i < samplers->count; i++) {
        const struct sampler *s = &samplers->item[i];
        char **row = cell + 6 * (i + 1);
        row[0] = memory_text("%s", s->name);
        row[1] = memory_text("%s", s->pass > 0   ? "the last frame"
                                   : s->file < 0 ? "-"
                                                 : source->files[s->file]);
        row[2] = memory_text("%s", s->words ? "words" : s->srgb ? "sRGB" : "linear");
        row[3] = memory_text("%s", s->words ? "-" : s->repeat ? "repeat" : "clamp");
        row[4] = s->slices > 0 ? memory_text("%d", s->slices) : memory_text("-");
        row[5] = memory_text("%s", s->meaning);
    }
    fputc('\n', file);
    print_table(file, 6, samplers->count + 1, cell);
}
