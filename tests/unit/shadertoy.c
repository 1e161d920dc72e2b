// shadertoy.c - tests the text that --print-shader=shadertoy prints.
#include "lib/test.h"

#include "dialects/export.h"
#include "shader/read.h"
#include "lib/scratch.h"

// The text lacks the declarations that Shadertoy makes itself, and its camera and parameters are
// constants.
TEST(test_the_export_makes_the_camera_and_parameters_constant)
{
    scratch_write("root/shaders/main.glsl", "void main() { }\n");
    const char *path = scratch_write("root/chapters/main.frag",
                                     "#include \"main.glsl\"\n"
                                     "uniform vec3 iResolution;\n"
                                     "uniform vec3 iCameraRight;\n"
                                     "uniform vec3 iCameraForward; // ahead\n"
                                     "uniform vec2 size; // 1 in [0, 9], units: how large\n"
                                     "uniform int steps; // 7 in [1, 9]: most\n"
                                     "float twice(float x) { return 2.0 * x; }\n");
    struct shader_source source;
    assert_true(shader_read(&source, path, scratch_path("root")));
    struct parameters parameters;
    struct camera camera = {.pan = 90.0f};
    assert_true(parameters_read(&parameters, &source));
    assert_true(parameters_assign(&parameters, "size=2,0.25"));
    char *text = export_shadertoy(&source, &parameters, &camera, 1.5f);
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

TESTS(scratch_setup, scratch_teardown)
