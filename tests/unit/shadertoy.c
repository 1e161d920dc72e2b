// shadertoy.c - tests the texts that --print-shader=shadertoy and --print-shader=page print.
#include "lib/test.h"

#include "dialects/export.h"
#include "shader/read.h"
#include "memory.h"
#include "lib/scratch.h"

// Read a shader with a camera, parameters and a texture.
static void read_shader(struct shader_source *source, struct parameters *parameters,
                        const char *more)
{
    scratch_write("root/shaders/main.glsl", "void main() { }\n");
    char *text = memory_text("#include \"main.glsl\"\n"
                             "uniform vec3 iResolution;\n"
                             "uniform vec3 iCameraRight;\n"
                             "uniform vec3 iCameraForward; // ahead\n"
                             "uniform vec2 size; // 1 in [0, 9], units: how large\n"
                             "uniform int steps; // 7 in [1, 9]: most\n%s"
                             "float twice(float x) { return 2.0 * x; }\n",
                             more);
    const char *path = scratch_write("root/chapters/main.frag", text);
    free(text);
    assert_true(shader_read(source, path, scratch_path("root")));
    assert_true(parameters_read(parameters, source));
}

// The text lacks the declarations that Shadertoy makes itself, and its camera and parameters are
// constants.
TEST(test_the_export_makes_the_camera_and_parameters_constant)
{
    struct shader_source source;
    struct parameters parameters;
    struct camera camera = {.pan = 90.0f};
    read_shader(&source, &parameters, "");
    assert_true(parameters_assign(&parameters, "size=2,0.25"));
    char *text = export_file(&source, &parameters, &camera, 1.5f, false);
    assert_non_null(text);
    assert_null(strstr(text, "void main()"));
    assert_null(strstr(text, "iResolution;"));
    const char *const lines[] = {"\nconst vec3 iCameraRight = vec3(",
                                 "\nconst vec2 size = vec2(2.0, 0.25);", "\nconst int steps = 7;",
                                 "\nfloat twice(float x) { return 2.0 * x; }\n",
                                 "\nvoid mainImage(out vec4 fragColor, in vec2 fragCoord)\n"};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++)
        if (strstr(text, lines[i]) == NULL)
            fail_msg("no '%s' in %s", lines[i], text);
    const char *right = strstr(text, lines[0]) + strlen(lines[0]);
    float x, y, z;
    assert_int_equal(sscanf(right, "%f, %f, %f", &x, &y, &z), 3);
    assert_true(x * x + y * y < 1e-9f && z > 0.999f);
    free(text);
    parameters_free(&parameters);
    shader_free(&source);
}

// For a page, the parameters and the textures remain uniforms, each with its comment.
TEST(test_the_export_for_a_page_keeps_parameters_and_textures)
{
    scratch_write("root/shaders/textures/stone.png", "");
    struct shader_source source;
    struct parameters parameters;
    struct camera camera = {.pan = 90.0f};
    read_shader(&source, &parameters,
                "uniform sampler2D stone; // \"stone.png\" sRGB repeat: granite\n"
                "#ifdef SHADERTOY\nint toy;\n#endif\n");
    assert_null(export_file(&source, &parameters, &camera, 1.5f, false));
    char *text = export_file(&source, &parameters, &camera, 1.5f, true);
    assert_non_null(text);
    assert_null(strstr(text, "iResolution;"));
    assert_null(strstr(text, "#define SHADERTOY"));
    const char *const lines[] = {
        "\nconst vec3 iCameraRight = vec3(",
        "\nuniform vec2 size; // 1 in [0, 9], units: how large\n",
        "\nuniform int steps; // 7 in [1, 9]: most\n",
        "\nuniform sampler2D stone; // \"stone.png\" sRGB repeat: granite\n",
        "\nvoid mainImage(out vec4 fragColor, in vec2 fragCoord)\n"};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++)
        if (strstr(text, lines[i]) == NULL)
            fail_msg("no '%s' in %s", lines[i], text);
    free(text);
    parameters_free(&parameters);
    shader_free(&source);
}

// The export for a page refuses a shader in another dialect, in one line.
TEST(test_the_export_for_a_page_refuses_other_dialects)
{
    const char *path =
        scratch_write("root/toy.frag", "void mainImage(out vec4 c, vec2 p) { c = vec4(1.0); }\n");
    struct shader_source source;
    struct parameters parameters;
    assert_true(shader_read(&source, path, scratch_path("root")));
    assert_true(parameters_read(&parameters, &source));
    assert_null(export_file(&source, &parameters, &(struct camera){0}, 1.5f, true));
    parameters_free(&parameters);
    shader_free(&source);
}

TESTS(scratch_setup, scratch_teardown)
