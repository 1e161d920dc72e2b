#include "lib/parameter.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
// cmocka.h needs the four headers above.
#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "lib/scratch.h"

#define LINES 64

struct shader_source parameter_source(const char *text, enum shader_dialect dialect)
{
    static char name[] = "my.frag";
    static char *files[] = {name};
    static struct shader_line lines[LINES];
    static char copy[8192];
    static struct glsl code;
    snprintf(copy, sizeof copy, "%s", text);
    glsl_free(&code);
    glsl_read(&code, copy);
    int count = line_count(copy);
    assert_true(count <= LINES);
    for (int i = 0; i < count; i++)
        lines[i] = (struct shader_line){0, i + 1};
    return (struct shader_source){.dialect = dialect,
                                  .text = copy,
                                  .code = code,
                                  .lines = lines,
                                  .line_count = count,
                                  .files = files,
                                  .file_count = 1};
}

struct parameters parameter_text(const char *text)
{
    struct parameters parameters;
    struct shader_source source = parameter_source(text, DIALECT_COURSE);
    capture_begin();
    bool done = parameters_read(&parameters, &source);
    const char *said = capture_end();
    if (!done || said[0] != '\0')
        fail_msg("%s: %s", text, said);
    return parameters;
}

void parameter_said(const char *said, const char *where, const char *why)
{
    if (line_count(said) != 1 || strstr(said, where) == NULL || strstr(said, why) == NULL)
        fail_msg("expected one line with '%s' and '%s', not: %s", where, why, said);
}

void parameter_number(double value, double expected)
{
    if (!(fabs(value - expected) <= 1e-12 * fabs(expected)))
        fail_msg("%.17g is not %.17g", value, expected);
}
