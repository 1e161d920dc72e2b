#include "shader/view.h"

#include <stdio.h>
#include <string.h>

#include "memory.h"

static const struct {
    enum view_kind kind;
    const char *id, *name;
} rows[] = {
#define VIEW_ROW(id, kind, key, name) [VIEW_##id] = {VIEW_##kind, #id, name},
    SHADER_VIEWS(VIEW_ROW) SHADER_PROGRAMS(VIEW_ROW)
#undef VIEW_ROW
};

const char *shader_view_name(enum shader_view view)
{
    return rows[view].name;
}

bool shader_view_from_name(const char *name, enum shader_view *view)
{
    for (int i = 0; i < SHADER_VIEW_COUNT; i++)
        if (strcmp(name, rows[i].name) == 0) {
            *view = (enum shader_view)i;
            return true;
        }
    return false;
}

bool shader_shows_ray(enum shader_view view)
{
    return rows[view].kind == VIEW_OF_RAY;
}

bool shader_has_legend(enum shader_view view)
{
    return rows[view].kind == VIEW_OF_COUNT;
}

char *shader_view_lines(enum shader_view view)
{
    char *lines;
    FILE *text = memory_open(&lines);
    for (int i = 0; i < SHADER_PROGRAM_COUNT; i++)
        fprintf(text, "#define VIEW_%s %d\n", rows[i].id, i);
    fprintf(text, "#define VIEW VIEW_%s\n#define VIEW_OF_TRACE (", rows[view].id);
    const char * or = "";
    for (int i = 0; i < SHADER_PROGRAM_COUNT; i++)
        if (rows[i].kind == VIEW_OF_TRACE || rows[i].kind == VIEW_OF_COUNT) {
            fprintf(text, "%sVIEW == VIEW_%s", or, rows[i].id);
            or = " || ";
        }
    fprintf(text, ")\n");
    memory_close(text);
    return lines;
}
