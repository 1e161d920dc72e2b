// Read numbers from the functions of a chapter's shader.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "lib/chapter.h"

float *chapter_numbers(const char *stem, const char *body)
{
    char text[1400];
    struct renderer_inputs inputs = gpu_inputs(CHAPTER_WIDTH, CHAPTER_HEIGHT, 1);
    snprintf(text, sizeof text,
             "#include \"main.glsl\"\n#define rayColour chapterColour\n"
             "#include \"%s.frag\"\n#undef rayColour\n"
             "vec3 rayColour(Ray ray) { vec2 pixel = vec2(iPixel); %s }\n",
             stem, body);
    inputs.camera = gpu_camera(stem);
    assert_true(gpu_load_text(text));
    return gpu_numbers(&inputs);
}
