// texture.c - pictures that shaders read as textures: decoding, orientation, edges and levels on
// this driver, and pictures and samplers that are refused.
#include "lib/test.h"
#include "picture/texture.h"
#include "lib/gpu.h"
#include "lib/mirror.h"
#include "lib/png.h"
#include "lib/scratch.h"

// Draw a picture of this size in which each pixel has the value of an expression.
static float *draw_expression(const char *samplers, const char *expression, int width, int height)
{
    char text[4096];
    snprintf(text, sizeof text,
             "#include \"main.glsl\"\n%s\n"
             "Ray pixelRay(vec2 screen) { return Ray(vec3(0.0), vec3(0.0, 0.0, -1.0)); }\n"
             "float sceneDistance(vec3 p) { return 1.0; }\n"
             "vec3 rayColour(Ray ray)\n{\n"
             "    vec2 pixel = floor(gl_FragCoord.xy + iPixelOffset);\n"
             "    return %s;\n}\n",
             samplers, expression);
    if (!gpu_load_text(text))
        fail_msg("this shader does not load: %s", text);
    struct renderer_inputs inputs = {.width = width, .height = height, .samples = 1};
    float *values = gpu_numbers(&inputs);
    assert_int_equal(gpu.context.gl.GetError(), GL_NO_ERROR);
    return values;
}

// Write ramp.png, a grey ramp of all byte values, from 0 on the left to 255 on the right.
static void write_ramp(void)
{
    const struct png_kind kind = {.type = PNG_COLOR_TYPE_GRAY, .depth = 8};
    uint16_t sample[256];
    for (int i = 0; i < 256; i++)
        sample[i] = (uint16_t)i;
    png_file("ramp.png", &kind, 256, 1, sample);
}

TEST(colours_are_decoded_and_numbers_are_not)
{
    double worst = 0.0;
    write_ramp();
    float *values =
        draw_expression("uniform sampler2D a; // \"ramp.png\" sRGB clamp: colours\n"
                        "uniform sampler2D b; // \"ramp.png\" linear repeat: numbers\n",
                        "vec3(textureLod(a, vec2((pixel.x + 0.5) / 256.0, 0.5), 0.0).r,"
                        "     textureLod(b, vec2((pixel.x + 0.5) / 256.0, 0.5), 0.0).rg)",
                        256, 1);
    for (int i = 0; i < 256; i++) {
        worst = fmax(worst, fabs((double)values[4 * i] - mirror_decode(i / 255.0)));
        // Some drivers interpolate with 8-bit weights.
        assert_true(fabs((double)values[4 * i + 1] - i / 255.0) < 0.5 / 255.0);
        assert_true(values[4 * i + 2] == values[4 * i + 1]);
    }
    free(values);
    // Mesa's polynomial for sRGB decoding is off by up to 0.0012; a power of 2.2, by up to 0.0085.
    if (worst > 0.002)
        fail_msg("decoded sRGB is off by %g", worst);
}

// In a picture of two by two texels, red tells left from right and green bottom from top. In a
// volume, blue tells the slices apart.
TEST(pictures_are_upright)
{
    const struct png_kind kind = {.type = PNG_COLOR_TYPE_RGB, .depth = 8};
    static const uint16_t sample[] = {0, 255, 0,   255, 255, 0,   0, 0, 0,   255, 0, 0,
                                      0, 255, 255, 255, 255, 255, 0, 0, 255, 255, 0, 255};
    png_file("picture.png", &kind, 2, 2, sample);
    png_file("volume.png", &kind, 2, 4, sample);
    static const char samplers[] =
        "uniform sampler2D a; // \"picture.png\" linear clamp: a\n"
        "uniform highp sampler3D v; // \"volume.png\" linear clamp 2: v\n";
    for (int i = 0; i < 2; i++) {
        float *values =
            draw_expression(samplers,
                            i == 0 ? "textureLod(a, (pixel + 0.5) / 2.0, 0.0).rgb"
                                   : "textureLod(v, vec3(mod(pixel.x, 2.0) + 0.5, pixel.y + 0.5, "
                                     "floor(pixel.x / 2.0) + 0.5) / 2.0, 0.0).rgb",
                            i == 0 ? 2 : 4, 2);
        for (int y = 0; y < 2; y++)
            for (int x = 0; x < (i == 0 ? 2 : 4); x++) {
                const float *value = values + 4 * (y * (i == 0 ? 2 : 4) + x);
                assert_true(value[0] == (float)(x % 2) && value[1] == (float)y &&
                            value[2] == (float)(x / 2));
            }
        free(values);
    }
}

TEST(edges_repeat_or_are_clamped)
{
    const struct png_kind kind = {.type = PNG_COLOR_TYPE_GRAY, .depth = 8};
    static const uint16_t sample[] = {10, 60, 200, 250};
    static const int repeated[] = {200, 250, 10, 60, 200, 250, 10, 60},
                     clamped[] = {10, 10, 10, 60, 200, 250, 250, 250};
    png_file("four.png", &kind, 4, 1, sample);
    png_file("tower.png", &kind, 1, 4, sample);
    static const char samplers[] =
        "uniform sampler2D r; // \"four.png\" linear repeat: a\n"
        "uniform sampler2D c; // \"four.png\" linear clamp: b\n"
        "uniform highp sampler3D t; // \"tower.png\" linear repeat 4: c\n"
        "uniform highp sampler3D e; // \"tower.png\" linear clamp 4: d\n";
    static const char *const expressions[] = {
        "vec3(textureLod(r, vec2((pixel.x - 1.5) / 4.0, 7.5), 0.0).r,"
        "     textureLod(c, vec2((pixel.x - 1.5) / 4.0, 7.5), 0.0).r, 0.0)",
        "vec3(textureLod(t, vec3(-3.5, 9.5, (pixel.x - 1.5) / 4.0), 0.0).r,"
        "     textureLod(e, vec3(-3.5, 9.5, (pixel.x - 1.5) / 4.0), 0.0).r, 0.0)"};
    for (int i = 0; i < 2; i++) {
        float *values = draw_expression(samplers, expressions[i], 8, 1);
        for (int x = 0; x < 8; x++) {
            assert_true(fabs((double)values[4 * x] * 255.0 - repeated[x]) < 0.5);
            assert_true(fabs((double)values[4 * x + 1] * 255.0 - clamped[x]) < 0.5);
        }
        free(values);
    }
}

// At the centre of a level's texel, the value of the texel is read, whether the level is selected
// by its index or by the footprint.
TEST(the_level_is_the_one_asked_for)
{
    struct texture_image image;
    char why[IMAGE_WHY], expression[256];
    const struct sampler sampler = {.repeat = true};
    const char *path = png_file_random("levels.png", 16, 16, NULL);
    assert_true(texture_image_read(&image, &sampler, path, why));
    assert_int_equal(image.count, 5);
    for (int level = 0; level < 5; level++)
        for (int gradient = 0; gradient < 2; gradient++) {
            int side = 16 >> level;
            if (gradient == 0)
                snprintf(expression, sizeof expression,
                         "textureLod(a, (pixel + 0.5) / %d.0, %d.0).rgb", side, level);
            else
                snprintf(expression, sizeof expression,
                         "textureGrad(a, (pixel + 0.5) / %d.0, vec2(1.0 / %d.0, 0.0), "
                         "vec2(0.0, 1.0 / %d.0)).rgb",
                         side, side, side);
            float *values =
                draw_expression("uniform sampler2D a; // \"levels.png\" linear repeat: noise\n",
                                expression, side, side);
            for (int i = 0; i < 4 * side * side; i++)
                if (i % 4 < 3)
                    assert_true(fabs(255.0 * (double)values[i] - image.level[level][i]) < 0.6);
            free(values);
        }
    texture_image_free(&image);
}

// A table of two by two texels. The pixels of the file contain the bytes of its numbers, the lowest
// byte in red; the first row of the file is the upper row of the table.
TEST(whole_numbers_keep_all_their_bits)
{
    const struct png_kind kind = {.type = PNG_COLOR_TYPE_RGB_ALPHA, .depth = 8};
    uint16_t sample[64];
    char expression[512];
    for (int i = 0; i < 64; i++)
        sample[i] = (uint16_t)(i == 5 ? 0 : i == 6 ? 255 : 4 * i + 3);
    png_file("table.png", &kind, 8, 2, sample);
    for (int i = 0; i < 16; i++) {
        uint32_t word = 0;
        for (int k = 0; k < 4; k++)
            word |= (uint32_t)sample[4 * i + k] << 8 * k;
        snprintf(
            expression, sizeof expression,
            "vec3(texelFetch(t, ivec2(%d, %d), 0)[%d] == %uu, textureSize(t, 0) == ivec2(2), 0.0)",
            i / 4 % 2, 1 - i / 8, i % 4, (unsigned)word);
        float *values =
            draw_expression("uniform usampler2D t; // \"table.png\": numbers\n", expression, 1, 1);
        assert_true(values[0] == 1.0F && values[1] == 1.0F);
        free(values);
    }
}

TEST(a_table_has_four_pixels_in_each_texel)
{
    struct texture_image image;
    char why[IMAGE_WHY];
    const struct sampler sampler = {.words = true};
    const char *path = png_file_random("table.png", 6, 2, NULL);
    assert_false(texture_image_read(&image, &sampler, path, why));
    assert_non_null(strstr(why, "the width of 6 pixels is not divisible by four"));
}

// The shader declares as many samplers as the driver has units, but the harness needs the first
// unit and one for letters.
TEST(too_many_samplers_are_refused)
{
    char text[65536] = "#include \"main.glsl\"\n";
    GLint units = 0;
    gpu.context.gl.GetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
    write_ramp();
    for (int i = 0; i < units; i++)
        snprintf(text + strlen(text), sizeof text - strlen(text),
                 "uniform sampler2D a%d; // \"ramp.png\" linear repeat: one of many\n", i);
    capture_begin();
    assert_false(gpu_load_text(text));
    const char *said = capture_end();
    char expected[128];
    snprintf(expected, sizeof expected, "shader.frag:%d: sampler a%d: ", units, units - 2);
    assert_non_null(strstr(said, expected));
    assert_non_null(strstr(said, "the driver supports at most"));
    assert_int_equal(line_count(said), 1);
}

// If a picture cannot be read, the previous shader remains in use, with its textures.
TEST(a_broken_picture_keeps_the_last_good_shader)
{
    write_ramp();
    static const char samplers[] = "uniform sampler2D a; // \"ramp.png\" linear repeat: numbers\n";
    static const char expression[] = "textureLod(a, vec2((pixel.x + 0.5) / 4.0, 0.5), 6.0).rrr";
    float *before = draw_expression(samplers, expression, 4, 1);
    scratch_write_bytes("ramp.png", (const unsigned char *)"no picture", 10);
    capture_begin();
    assert_false(gpu_load_file(&gpu.renderer, scratch_path("shader.frag")));
    assert_non_null(strstr(capture_end(), "sampler a: "));
    struct renderer_inputs inputs = {.width = 4, .height = 1, .samples = 1};
    float *after = gpu_numbers(&inputs);
    assert_memory_equal(before, after, 16 * sizeof *before);
    assert_true(before[0] > 0.0f && before[12] > before[0]);
    free(before);
    free(after);
}

// The harness does not set a sampler in a structure, and says so in a warning. Such a sampler never
// reads the target that is being drawn: the third picture is drawn into the target that the second
// one left bound.
TEST(a_sampler_that_is_not_set_reads_black)
{
    struct renderer_inputs inputs = {.width = 4, .height = 2, .samples = 1};
    float values[4 * 4 * 2];
    capture_begin();
    assert_true(gpu_load_text("#version 330 core\nstruct S { sampler2D a; }; uniform S s;\n"
                              "out vec4 colour;\n"
                              "void main() { colour = texture(s.a, vec2(0.5)) + 0.25; }\n"));
    assert_non_null(strstr(capture_end(), "uniform S s is 0"));
    for (int i = 0; i < 3; i++) {
        assert_true(i == 1 ? gpu_sharpen(&gpu.renderer, &inputs, 0, 2)
                           : renderer_draw(&gpu.renderer, &inputs, 0, 2));
        target_read(i == 1 ? &gpu.renderer.sharp : &gpu.renderer.picture, gpu.renderer.gl, values);
        assert_true(values[0] == 0.25f && values[1] == 0.25f && values[2] == 0.25f);
    }
}

TESTS(gpu_setup, gpu_teardown)
