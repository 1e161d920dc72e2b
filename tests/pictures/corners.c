// corners.c - tests that no chapter computes a colour that is not a number, at either end of any
// parameter's range and with a camera that looks straight up or down.
#include <glob.h>

#include "lib/test.h"
#include "lib/gpu.h"

enum { WIDTH = 48, HEIGHT = 27 };

// Load a chapter with a picture that is 1 where a light that the chapter encodes for the screen is
// not a number. After the encoding it would be black, or anything else.
static void load(const char *stem)
{
    char text[640];
    snprintf(text, sizeof text,
             "#include \"main.glsl\"\n#include \"lighting.glsl\"\nbool bad = false;\n"
             "vec3 checkedSRGB(vec3 light)\n{\n"
             "    bad = bad || any(isnan(light));\n    return encodeSRGB(light);\n}\n"
             "#define encodeSRGB checkedSRGB\n#define rayColour chapterColour\n"
             "#include \"%s.frag\"\n#undef rayColour\n"
             "vec3 rayColour(Ray ray)\n{\n    vec3 colour = chapterColour(ray);\n"
             "    return vec3(bad || any(isnan(colour)) ? 1.0 : 0.0);\n}\n",
             stem);
    assert_true(gpu_load_text(text));
}

// The number of bad pixels with the chapter's camera, and with the same camera tilted up and down.
static int bad_pixels(const struct camera *camera)
{
    struct renderer_inputs inputs = {
        .width = WIDTH, .height = HEIGHT, .samples = 1, .camera = *camera};
    int bad = 0;
    for (int i = 0; i < 3; i++) {
        inputs.camera.tilt = i == 0 ? camera->tilt : (i == 1 ? 90.0f : -90.0f);
        float *values = gpu_numbers(&inputs);
        for (int k = 0; k < WIDTH * HEIGHT; k++)
            bad += values[4 * k] != 0.0f;
        free(values);
    }
    return bad;
}

// Try both ends of a parameter's range, and leave it as it was.
static int bad_at_ends(const struct camera *camera, const char *stem, struct parameter *parameter)
{
    int bad = 0;
    for (int end = 0; end < 2; end++) {
        for (int k = 0; k < parameter->components; k++)
            parameter->value[k] = end == 0 ? parameter->minimum : parameter->maximum;
        int here = bad_pixels(camera);
        if (here > 0)
            print_error("%s: %s=%g: %d pixels are not numbers\n", stem, parameter->name,
                        parameter->value[0], here);
        bad += here;
    }
    memcpy(parameter->value, parameter->initial, sizeof parameter->value);
    return bad;
}

TEST(test_no_chapter_computes_what_is_not_a_number)
{
    glob_t found;
    int bad = 0;
    assert_int_equal(glob("chapters/[0-9][0-9]_*.frag", 0, NULL, &found), 0);
    assert_true(found.gl_pathc >= 24);
    for (size_t i = 1; i < found.gl_pathc; i++) { // chapter 00 is a complete program
        char stem[64];
        snprintf(stem, sizeof stem, "%s", found.gl_pathv[i] + strlen("chapters/"));
        *strchr(stem, '.') = '\0';
        struct camera camera = gpu_camera(stem);
        load(stem);
        int here = bad_pixels(&camera);
        for (int k = 0; k < gpu.renderer.parameters.count; k++)
            here += bad_at_ends(&camera, stem, &gpu.renderer.parameters.item[k]);
        printf("# drawn: %s: %d pixels are not numbers\n", stem, here);
        fflush(stdout);
        bad += here;
    }
    globfree(&found);
    assert_int_equal(bad, 0);
}

// The sun at the zenith and at the nadir, where it has no horizontal direction.
TEST(test_the_sun_may_be_straight_above_or_below)
{
    struct camera camera = gpu_camera("19_moon_and_stars");
    load("19_moon_and_stars");
    gpu_set("latitude", 2.0); // the sun's declination in that chapter
    gpu_set("timeOfDay", 12.0);
    assert_int_equal(bad_pixels(&camera), 0);
    gpu_set("latitude", -2.0);
    gpu_set("timeOfDay", 0.0);
    assert_int_equal(bad_pixels(&camera), 0);
}

TESTS(gpu_setup, gpu_teardown)
