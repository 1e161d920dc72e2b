#include "shader/parameter.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "number.h"
#include "report.h"

#define TEXT_SIZE 160 // a value or a range as text

void parameters_free(struct parameters *parameters)
{
    free(parameters->item);
    samplers_free(&parameters->samplers);
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

// What a value of the parameter looks like, for messages.
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

// Read exactly as many numbers as the parameter has components, with commas between.
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

static const char *name_of(const void *parameters, int i)
{
    return ((const struct parameters *)parameters)->item[i].name;
}

// Report a name that no parameter has, with the names there are.
static void report_unknown(const struct parameters *parameters, const char *assignment)
{
    char *names = memory_list(parameters->count, name_of, parameters);
    if (parameters->count == 0)
        report("--set %s: this shader has no parameters", assignment);
    else
        report("--set %s: no parameter has this name: there %s %s", assignment,
               parameters->count == 1 ? "is" : "are", names);
    free(names);
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
    if (parameter == NULL) {
        report_unknown(parameters, assignment);
        return false;
    }
    const char *text = assignment + length + 1;
    if (parameter->type == PARAMETER_BOOL ? !read_bool(text, value)
                                          : !read_numbers(parameter, text, value))
        return report("--set %s: the value must be %s%s", assignment, expected(parameter),
                      parameter->type == PARAMETER_FLOAT ? number_hint(text) : "");
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

// A sum of steps drifts: 0.1 three times is 0.30000000000000004, less 0.3 is not 0.
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
        // A small factor must not hold a small number in place.
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

double parameter_place(const struct parameter *parameter, int part)
{
    double low = parameter->minimum, high = parameter->maximum, value = parameter->value[part];
    if (parameter->multiplies)
        return log(value / low) / log(high / low);
    return high > low ? (value - low) / (high - low) : 0.0;
}

void parameter_put(struct parameter *parameter, int part, double place)
{
    double low = parameter->minimum, high = parameter->maximum;
    double at = clamp(place, 0.0, 1.0);
    double value = parameter->multiplies ? low * pow(high / low, at) : low + (high - low) * at;
    double unit = pow(10.0, floor(log10(parameter->multiplies ? value : high - low)) -
                                (parameter->multiplies ? 2.0 : 3.0));
    if (parameter->type != PARAMETER_FLOAT)
        unit = 1.0;
    // Divided by a whole number where there is one: 3 tenths are 3 / 10, and 3 * 0.1 is another.
    value = unit < 1.0 ? round(value / unit) / round(1.0 / unit) : round(value / unit) * unit;
    parameter->value[part] = clamp(value, low, high);
}

bool parameter_is_colour(const struct parameter *parameter)
{
    return parameter->components == 3 && strcmp(parameter->unit, "linear RGB") == 0;
}

void parameter_reset(struct parameter *parameter)
{
    memcpy(parameter->value, parameter->initial, sizeof parameter->value);
}

// ---- The table ----

enum { COLUMNS = 5 };

// Characters, not bytes: a degree sign is one.
static int width_of(const char *text)
{
    int width = 0;
    for (; *text != '\0'; text++)
        width += ((unsigned char)*text & 0xC0) != 0x80;
    return width;
}

static void fill_row(const struct parameter *parameter, char value[TEXT_SIZE],
                     char range[TEXT_SIZE], const char *row[COLUMNS])
{
    static const char *const titles[COLUMNS] = {"name", "value", "range", "unit", "meaning"};
    memcpy(row, titles, sizeof titles);
    if (parameter == NULL)
        return;
    parameter_value_text(parameter, value, TEXT_SIZE);
    parameter_range_text(parameter, range, TEXT_SIZE);
    row[0] = parameter->name;
    row[1] = value;
    row[2] = range;
    row[3] = parameter->unit[0] != '\0' ? parameter->unit : "-";
    row[4] = parameter->meaning;
}

void parameters_print(const struct parameters *parameters, FILE *file)
{
    char value[TEXT_SIZE], range[TEXT_SIZE];
    const char *row[COLUMNS];
    int width[COLUMNS] = {0};
    if (parameters->count == 0) {
        fprintf(file, "This shader has no parameters.\n");
        return;
    }
    for (int i = -1; i < parameters->count; i++) {
        fill_row(i < 0 ? NULL : &parameters->item[i], value, range, row);
        for (int k = 0; k < COLUMNS; k++)
            width[k] = width_of(row[k]) > width[k] ? width_of(row[k]) : width[k];
    }
    for (int i = -1; i < parameters->count; i++) {
        fill_row(i < 0 ? NULL : &parameters->item[i], value, range, row);
        for (int k = 0; k < COLUMNS - 1; k++)
            fprintf(file, "%s%*s", row[k], width[k] - width_of(row[k]) + 2, "");
        fprintf(file, "%s\n", row[COLUMNS - 1]);
    }
}
