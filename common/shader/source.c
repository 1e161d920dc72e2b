#include "shader/source.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "report.h"

bool shader_refuse(const struct shader_source *source, int line, const char *format, ...)
{
    const struct shader_line *from = &source->lines[line];
    char why[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(why, sizeof why, format, arguments);
    va_end(arguments);
    return report("%s:%d: %s", source->files[from->file], from->line, why);
}

bool shader_includes(const struct shader_source *source, const char *file)
{
    for (int i = 1; i < source->file_count; i++)
        if (strcmp(source->files[i], file) == 0)
            return true;
    return false;
}

const struct shader_read *shader_read_of(const struct shader_source *source, const char *sampler)
{
    for (const struct shader_read *read = source->links.read, *end = read + SHADER_PASSES;
         read < end; read++)
        if (read->pass > 0 && strcmp(read->name, sampler) == 0)
            return read;
    return NULL;
}

void shader_free(struct shader_source *source)
{
    for (int i = 0; i < source->file_count; i++) {
        free(source->files[i]);
        free(source->paths[i]);
    }
    free(source->files);
    free(source->paths);
    free(source->lines);
    free(source->prelude);
    free(source->body);
    free(source->inputs);
    free(source->samplers);
    free(source->unset);
    free(source->warned);
    free(source->root);
    free(source->own);
    free(source->include);
    for (int i = 0; i < source->pass_count && source->pass != NULL; i++)
        shader_free(&source->pass[i]);
    free(source->pass);
    glsl_free(&source->code);
    *source = (struct shader_source){0};
}
