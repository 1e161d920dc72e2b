#include "dialects/edits.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"

struct edit {
    int begin, length; // position and length of the replaced part, in bytes
    int number;        // order among the edits at one position
    char *text;
};

void edits_add(struct edits *edits, int begin, int length, const char *format, ...)
{
    char *text;
    FILE *stream = memory_open(&text);
    va_list arguments;
    va_start(arguments, format);
    vfprintf(stream, format, arguments);
    va_end(arguments);
    memory_close(stream);
    edits->item = memory_row(edits->item, edits->count, sizeof *edits->item);
    edits->item[edits->count] = (struct edit){begin, length, edits->count, text};
    edits->count++;
    edits->size += (int)strlen(text);
}

void edits_replace(struct edits *edits, const struct glsl_token *token, const char *instead)
{
    edits_add(edits, token->begin, token->length, "%s", instead);
}

void edits_cut(struct edits *edits, const struct glsl_token *from, const struct glsl_token *to)
{
    edits_add(edits, from->begin, to->begin + to->length - from->begin, "%s", "");
}

static int by_position(const void *a, const void *b)
{
    const struct edit *first = a, *second = b;
    int order = (first->begin > second->begin) - (first->begin < second->begin);
    return order != 0 ? order : first->number - second->number;
}

char *edits_apply(struct edits *edits, const char *text)
{
    char *result;
    FILE *stream = memory_open(&result);
    int from = 0;
    if (edits->count > 0)
        qsort(edits->item, (size_t)edits->count, sizeof *edits->item, by_position);
    for (int i = 0; i < edits->count; i++) {
        const struct edit *item = &edits->item[i];
        if (item->begin < from) // this edit begins inside a part that another edit has replaced
            continue;
        fprintf(stream, "%.*s%s", item->begin - from, text + from, item->text);
        for (from = item->begin; from < item->begin + item->length; from++)
            if (text[from] == '\n')
                fputc('\n', stream);
    }
    fputs(text + from, stream);
    memory_close(stream);
    edits_free(edits);
    return result;
}

void edits_free(struct edits *edits)
{
    for (int i = 0; i < edits->count; i++)
        free(edits->item[i].text);
    free(edits->item);
    *edits = (struct edits){0};
}
