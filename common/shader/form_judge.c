#include "shader/form_judge.h"

#include <stdlib.h>

#include "report.h"

#define ARRAY_LIMIT 65536 // elements

// ---- Sense ----

bool form_check_sense(const struct shader_source *source)
{
    const struct glsl *code = &source->code;
    bool any = false;
    for (const struct glsl_token *t = code->item; t->kind != GLSL_END && !any; t++)
        any = t->live && t->kind < GLSL_COMMENT;
    if (!any) {
        report("%s: holds nothing but comments: a shader is code", source->files[0]);
        return false;
    }
    for (const struct glsl_token *t = code->statement; t->kind != GLSL_END; t++) {
        const struct glsl_token *number = t + 1;
        if (t->sign == '[' && number->kind == GLSL_NUMBER && number[1].sign == ']' &&
            strtod(code->text + number->begin, NULL) > ARRAY_LIMIT)
            return shader_refuse(source, t->line,
                                 "an array of %.*s elements: a graphics processor has no room for "
                                 "it: %d at most",
                                 number->length < 20 ? number->length : 20,
                                 code->text + number->begin, ARRAY_LIMIT);
    }
    return true;
}

// ---- mainImage ----

bool form_refuse_image(const struct shader_source *source, const struct glsl_token *image)
{
    return shader_refuse(source, image->line,
                         "mainImage has other parameters than those it is called with: write void "
                         "mainImage(out vec4 fragColor, in vec2 fragCoord)");
}

// Pass over a parameter of a type; a colour is an out or an inout, a pixel no out.
static bool accept_parameter(const struct glsl *code, const struct glsl_token **t, const char *type,
                             bool colour)
{
    bool out = false, inout = false;
    for (;; ++*t) {
        static const char *const others[] = {"const", "in", "lowp", "mediump", "highp", NULL};
        if (glsl_is(code, *t, "out"))
            out = true;
        else if (glsl_is(code, *t, "inout"))
            inout = true;
        else if (!glsl_is_any(code, *t, others))
            break;
    }
    if (!glsl_is(code, *t, type))
        return false;
    *t += 1 + ((*t)[1].kind == GLSL_WORD);
    return colour ? out || inout : !out;
}

bool form_check_image(const struct shader_source *source)
{
    const struct glsl *code = &source->code;
    const struct glsl_token *wrong = NULL;
    const struct glsl_name *name = glsl_name(code, "mainImage");
    int seen = 0;
    for (const struct glsl_token *t = code->statement; t->kind != GLSL_END; t++) {
        if (t->kind != GLSL_WORD || &code->name[t->name] != name)
            continue;
        seen++;
        if (t->depth > 0 || t[1].sign != '(')
            continue;
        bool judged = t->certain && !t->macro;
        const struct glsl_token *end = glsl_partner(code, t + 1), *c = t + 2;
        for (const struct glsl_token *word = c; word < end; word++)
            judged &= !word->macro;
        if (!judged || (accept_parameter(code, &c, "vec4", true) && c->sign == ',' &&
                        (c++, accept_parameter(code, &c, "vec2", false)) && c == end))
            return true;
        wrong = wrong == NULL ? t : wrong;
    }
    return wrong == NULL || seen < name->count || form_refuse_image(source, wrong);
}
