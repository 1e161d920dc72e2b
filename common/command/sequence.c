#include "command/sequence.h"

#include <stdio.h>
#include <string.h>

#include "report.h"

// Return the end of the conversion that begins at a '%', or NULL if the conversion is not allowed.
//   width  receives the minimum number of digits; 0 for %d
static const char *conversion_end(const char *c, int *width)
{
    *width = 0;
    if (c[1] == 'd')
        return c + 2;
    if (c[1] != '0' || c[2] < '1' || c[2] > '9' || c[3] != 'd')
        return NULL;
    *width = c[2] - '0';
    return c + 4;
}

bool sequence_is_name(const char *name)
{
    int width;
    const char *sign = strchr(name, '%');
    const char *end = sign != NULL ? conversion_end(sign, &width) : NULL;
    return end != NULL && strchr(end, '%') == NULL;
}

bool sequence_path(const char *name, int number, char *path, size_t size)
{
    int width = 0;
    const char *sign = strchr(name, '%');
    const char *end = conversion_end(sign, &width);
    int length = snprintf(path, size, "%.*s%0*d%s", (int)(sign - name), name, width, number, end);
    if (length >= 0 && (size_t)length < size)
        return true;
    return report("%.40s...: the name is too long", name);
}
