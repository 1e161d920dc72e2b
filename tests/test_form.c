// test_form.c - the three kinds of shader file: which one a text is, what other people's need,
// what is compiled of it and which views it has, and one clear line for each that cannot be a
// picture.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
// cmocka needs the four above.
#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../common/shader/compile.h"
#include "support_scratch.h"

static int set_up(void **state)
{
    scratch_setup(state);
    scratch_write("root/shaders/leaf.glsl", "float leaf();\n");
    scratch_write("root/shaders/twig.glsl", "// twig\n#include \"leaf.glsl\"\nfloat twig();\n");
    return 0;
}

// Read a text as root/chapters/main.frag. Returns whether it can be; said is what was said.
static bool read_text(struct shader_source *source, const char *text, const char **said)
{
    const char *path = scratch_write("root/chapters/main.frag", text);
    capture_begin();
    bool done = shader_read(source, path, scratch_path("root"));
    *said = capture_end();
    return done;
}

// Read a text that is a shader.
static struct shader_source read_well(const char *text)
{
    struct shader_source source;
    const char *said;
    if (!read_text(&source, text, &said) || said[0] != '\0')
        fail_msg("%s: %s", text, said);
    return source;
}

static void assert_form(const char *text, enum shader_form form)
{
    struct shader_source source = read_well(text);
    if (source.form != form)
        fail_msg("%s: form %d, not %d", text, (int)source.form, (int)form);
    shader_free(&source);
}

// A whole file with this text behind its #version is refused in one line that says this.
static void assert_refused(const char *text, const char *words)
{
    struct shader_source source;
    const char *said;
    char whole[512];
    snprintf(whole, sizeof whole, "#version 330 core\n%s", text);
    assert_false(read_text(&source, whole, &said));
    if (line_count(said) != 1 || strstr(said, words) == NULL)
        fail_msg("%s: '%s' is missing in: %s", text, words, said);
}

// A main that writes a colour.
#define MAIN "out vec4 colour; void main() { colour = vec4(1.0); }\n"

static void test_forms(void **state)
{
    (void)state;
    assert_form("#version 330 core\n" MAIN, SHADER_WHOLE);
    assert_form("// why\n/* and\nhow */ # version 330 core\n#include \"leaf.glsl\"\n",
                SHADER_WHOLE);
    assert_form("#version 330 core\nvoid mainImage(out vec4 c, in vec2 p) {}\n", SHADER_SHADERTOY);
    assert_form("#version 330 core\nvoid mainImage(out vec4 c, in vec2 p) {} " MAIN, SHADER_WHOLE);
    assert_form("// #version 330\n" MAIN, SHADER_WHOLE);
    assert_form("void mainImage(out vec4 c, in vec2 p);\n", SHADER_SHADERTOY);
    assert_form("void my_main() {}\nvoid mainImage(out vec4 c, in vec2 p) {}\n", SHADER_SHADERTOY);
    assert_form("void main();\nvoid mainImage(out vec4 c, in vec2 p) {}\n", SHADER_SHADERTOY);
    assert_form("// void mainImage(out vec4 c, in vec2 p) {}\nfloat x;\n", SHADER_COURSE);
    assert_form("void mainImage(out vec4 c, in vec2 p) {}\n" MAIN, SHADER_WHOLE);
    assert_form("void mainImages(out vec4 c) {}\nvoid notmainImage() {}\n", SHADER_COURSE);
    scratch_write("root/shaders/main.glsl", "void main()\n{\n}\n");
    assert_form("#include \"leaf.glsl\"\n" MAIN, SHADER_COURSE);
    assert_form("#include \"main.glsl\"\nvoid mainImage(int a) {}\n", SHADER_COURSE);
    assert_form("void mainImage( out vec4 c,\n in vec2 p )\n{ }\n", SHADER_SHADERTOY);
    assert_form("uniform int iFrame; void main() { gl_Position = vec4(0.0); }\n", SHADER_COURSE);
}

// What the preprocessor leaves out decides nothing.
static void test_forms_behind_conditions(void **state)
{
    (void)state;
    static const char toy[] = "void mainImage(out vec4 c, in vec2 p) {}\n";
    static const struct {
        const char *before, *after;
        enum shader_form form; // of main between them, and Shadertoy's behind
    } cases[] = {
        {"#if 0\n", "#endif\n", SHADER_SHADERTOY},
        {"#if 1\n", "#endif\n", SHADER_WHOLE},
        {"#ifdef DESKTOP\n", "#endif\n", SHADER_SHADERTOY},
        {"#define DESKTOP\n#ifdef DESKTOP\n", "#endif\n", SHADER_WHOLE},
        {"#define DESKTOP 1\n#undef DESKTOP\n#ifdef DESKTOP\n", "#endif\n", SHADER_WHOLE},
        {"#ifndef DESKTOP\n", "#endif\n", SHADER_WHOLE},
        {"#ifdef GL_ES\n", "#endif\n", SHADER_SHADERTOY},
        {"#ifdef GL_ARB_gpu_shader5\n", "#endif\n", SHADER_WHOLE},
        {"#if defined(DESKTOP)\n", "#endif\n", SHADER_SHADERTOY},
        {"#if !defined DESKTOP\n", "#endif\n", SHADER_WHOLE},
        {"#if defined(DESKTOP) || 1\n", "#endif\n", SHADER_WHOLE},
        {"#if __VERSION__ > 100\n", "#endif\n", SHADER_WHOLE},
        {"#if 1\n#else\n", "#endif\n", SHADER_SHADERTOY},
        {"#if 0\n#else\n", "#endif\n", SHADER_WHOLE},
        {"#if 1\n#elif 1\n", "#endif\n", SHADER_SHADERTOY},
        {"#if 1\n#elif 1\n#else\n", "#endif\n", SHADER_SHADERTOY},
        {"#if 0\n#elif X\n", "#endif\n", SHADER_WHOLE},
        {"#if 0\n#if 1\n", "#endif\n#endif\n", SHADER_SHADERTOY},
        {"#if 0\n#define DESKTOP\n#endif\n#ifdef DESKTOP\n", "#endif\n", SHADER_SHADERTOY},
        {"#if 0\n#endif\n", "#endif\n#else\n", SHADER_WHOLE},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[512];
        snprintf(text, sizeof text, "%s" MAIN "%s%s", cases[i].before, cases[i].after, toy);
        assert_form(text, cases[i].form);
    }
}

// Shadertoy's pixel is that of the picture, whatever part is drawn, and its colour begins at 0.
static void test_shadertoy_s_words(void **state)
{
    (void)state;
    struct shader_source source;
    const char *said;
    assert_true(
        read_text(&source, "void mainImage(out vec4 c, in vec2 p) { c = gl_FragCoord; }\n", &said));
    char *compiled = shader_text(&source, SHADER_PICTURE);
    assert_non_null(
        strstr(compiled, "\nvoid mainImage(inout vec4 c, in vec2 p) { c = harnessFragCoord; }\n"));
    free(compiled);
    shader_free(&source);
}

// What only OpenGL ES knows does not reach the driver.
static void test_versions(void **state)
{
    (void)state;
    static const struct {
        const char *text, *word;
    } cases[] = {{"#version 300 es\nprecision highp float;\n" MAIN, "300 es"},
                 {"#version 100\nvoid main() { gl_FragColor = vec4(1.0); }\n", "100\n"},
                 {"#version 330 compatibility\n" MAIN, "compatibility"},
                 {"#extension GL_OES_standard_derivatives : enable\n"
                  "void mainImage(out vec4 c, in vec2 p) {}\n",
                  "GL_OES"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct shader_source source;
        const char *said;
        assert_true(read_text(&source, cases[i].text, &said));
        char *compiled = shader_text(&source, SHADER_PICTURE);
        if (strstr(compiled, cases[i].word) != NULL)
            fail_msg("'%s' in %s", cases[i].word, compiled);
        free(compiled);
        shader_free(&source);
    }
}

// The text for the driver, of a whole file.
static void assert_driver_gets(const char *text, const char *expected)
{
    char whole[512];
    snprintf(whole, sizeof whole, "#version 330 core\n%s", text);
    struct shader_source source;
    const char *said;
    assert_true(read_text(&source, whole, &said));
    char *compiled = shader_text(&source, SHADER_PICTURE);
    assert_string_equal(compiled + strlen("#version 330 core\n"), expected);
    free(compiled);
    shader_free(&source);
}

static void test_values_begin_at_zero(void **state)
{
    (void)state;
    assert_driver_gets("float a, b = 1.0, c; // float d;\n",
                       "float a=float(0), b = 1.0, c=float(0); // float d;\n");
    assert_driver_gets("vec3 f(vec3 p, float r);\nstruct S { float d; vec3 c; };\nS s;\n",
                       "vec3 f(vec3 p, float r);\nstruct S { float d; vec3 c; };\nS "
                       "s=S(float(0),vec3(0));\n");
    assert_driver_gets(
        "void f() { for (float i, d = g(1, 2), s; i < 3.0; i++) { highp mat2 m; } }\n",
        "void f() { for (float i=float(0), d = g(1, 2), s=float(0); i < 3.0; i++) { "
        "highp mat2 m=mat2(0); } }\n");
    assert_driver_gets("const float a = 1.0; float h[3]; float[2] v; int\ni\n;\n",
                       "const float a = 1.0; float h[3]=float[3](float(0),float(0),float(0)); "
                       "float[2] v; int\ni=int(0)\n;\n");
    assert_driver_gets(
        "#define A float x;\nuniform float u;\nprecision highp float;\nin float Time;\n",
        "#define A float x;\nuniform float u;\nprecision highp float;\nin float Time;\n");
    assert_driver_gets("out vec4 c;\nvoid main() { if (x) c = vec4(1.0); }\n",
                       "out vec4 c;\nvoid main() {c=vec4(0); if (x) c = vec4(1.0); }\n");
}

// Where a macro may say something else, a declaration stays as it is.
static void test_what_cannot_be_judged_is_left_alone(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "#define float highp float\nfloat x;\nvoid f() { float y; }\n",
        "#define x y[2]\nfloat x;\n",
        "#define BLOCK(n) uniform n\nBLOCK(Data) { vec4 v; float k; };\n",
        "#define BLOCK uniform Data\nBLOCK { vec4 v; float k; } data;\n",
        "uniform Data { vec4 v; float k; };\n",
        "struct S { float[2] a; };\nS s;\n",
        "#ifdef GL_X\nstruct S { float a; };\n#else\nstruct S { vec2 a; };\n#endif\nS s;\n",
        "float a[300];\n#define N 2\nfloat b[N], c[2][2];\n",
        "#define in varying\nin int Time;\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        assert_driver_gets(texts[i], texts[i]);
    assert_driver_gets("struct A { vec2 p; }; struct B { A a[2]; int n, m; } b, c[2]; float d;\n",
                       "struct A { vec2 p; }; struct B { A a[2]; int n, m; } "
                       "b=B(A[2](A(vec2(0)),A(vec2(0))),int(0),int(0)), "
                       "c[2]=B[2](B(A[2](A(vec2(0)),A(vec2(0))),int(0),int(0)),"
                       "B(A[2](A(vec2(0)),A(vec2(0))),int(0),int(0))); float d=float(0);\n");
}

static void test_outputs(void **state)
{
    (void)state;
    static const char body[] = "void main() { A = vec4(1); B = vec4(1); }\n";
    char text[256];
    snprintf(text, sizeof text, "out vec4 A; out vec4 B; %s", body);
    assert_refused(text, "main.frag:2: out vec4 B: a second output: write layout(location = 0)");
    snprintf(text, sizeof text, "out vec4 A, B; %s", body);
    assert_refused(text, "main.frag:2: out vec4 B: a second output");
    snprintf(text, sizeof text,
             "layout(location = 1) out vec4 A; layout(location=0) out vec4 B; %s", body);
    char whole[300];
    snprintf(whole, sizeof whole, "#version 330 core\n%s", text);
    assert_form(whole, SHADER_WHOLE);
    assert_refused("out ivec4 A; void main() { A = ivec4(1); }\n",
                   "main.frag:2: out ivec4 A: a picture is made of colours: write out vec4 A;");
    assert_refused("\nout float A; void main() { A = 1.0; }\n", "main.frag:3: out float A: a pict");
}

static void test_texts_without_sense(void **state)
{
    (void)state;
    assert_refused("float a[65536]; int i = a[ 65537 ];\n",
                   "main.frag:2: an array of 65537 elements");
    assert_refused("\nfloat a[99999999999999999999999];\n",
                   "main.frag:3: an array of 99999999999999999999 elements");
    struct shader_source source;
    const char *said;
    assert_false(read_text(&source, "// nothing\n/* but\n */\n", &said));
    assert_non_null(strstr(said, "main.frag: holds nothing but comments"));
}

static void test_inputs_and_textures(void **state)
{
    (void)state;
#define WRITES "out vec4 A; void main() { A = vec4(k); }\n"
    assert_driver_gets("flat in int CustomInt; out vec4 A; void main(){ A = vec4(CustomInt); }\n",
                       "uniform int CustomInt; out vec4 A; void main(){A=vec4(0); A = "
                       "vec4(CustomInt); }\n");
    assert_driver_gets("layout(location = 3) in float Time;\n",
                       "                     in float Time;\n");
    assert_refused("in int CustomInt; " WRITES, "CustomInt is a float here: write in float");
    assert_refused("flat in int Time; " WRITES, "Time is a float here: write in float Time;");
    assert_refused("layout(location = 3) in vec2 k; " WRITES, "in vec2 k: there is no such input");
    assert_form("#version 330 core\n#ifdef OLD\nin vec2 k;\n#else\nfloat k;\n#endif\n" WRITES,
                SHADER_WHOLE);
    assert_refused(
        "uniform sampler2D tex; out vec4 A; void main() { A = texture(tex, vec2(0)); }\n",
        "main.frag:2: tex has no picture: name it iChannel0");
    assert_form("#version 330 core\nuniform sampler2D tex; float k; " WRITES, SHADER_WHOLE);
    // A row where there is one picture, and one where there is a row: neither would be filled in.
    assert_refused("uniform sampler2D iChannel0[2]; " WRITES,
                   "uniform sampler2D[] iChannel0: iChannel0 is a sampler2D here: write uniform "
                   "sampler2D iChannel0;");
    assert_refused("uniform vec3 iChannelResolution; " WRITES,
                   "iChannelResolution is a vec3[4] here: write uniform vec3 "
                   "iChannelResolution[4];");
    assert_form("#version 330 core\nuniform vec3[4] iChannelResolution; " WRITES, SHADER_WHOLE);
}

static void test_forms_of_main_image(void **state)
{
    (void)state;
    static const char *const good[] = {
        "void mainImage(inout highp vec4 c, const in mediump vec2 p) {}\n",
        "void mainImage(out vec4, vec2);\n",
        "void mainImage(out vec4 c) {}\nvoid mainImage(out vec4 c, inout vec2 p) {}\n",
        "#define PARAMETERS out vec4 c, vec2 p\nvoid mainImage(PARAMETERS) {}\n",
        "#define vec5 vec4\nvoid mainImage(out vec5 c, vec2 p) {}\n",
        "#define HEAD void mainImage(out vec4 c, vec2 p)\nHEAD { }\nfloat mainImage(float x);\n",
        "#if GL_X\nvoid mainImage(out vec3 c) {}\n#endif\n",
    };
    static const char *const bad[] = {
        "vec4 mainImage(in vec2 p) { return p.xyxy; }\n",
        "void mainImage(out vec3 c, in vec2 p) {}\n",
        "void mainImage(vec4 c, in vec2 p) {}\n",
        "void mainImage(out vec4 c, out vec2 p) {}\n",
        "void mainImage(out vec4 c, vec2 p, float t) {}\n",
    };
    for (size_t i = 0; i < sizeof good / sizeof *good; i++)
        assert_form(good[i], SHADER_SHADERTOY);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_refused(bad[i], "main.frag:2: mainImage has other parameters than those it is "
                               "called with: write void mainImage(out vec4 fragColor, in vec2");
}

static void test_version_above_a_chapter(void **state)
{
    (void)state;
    scratch_write("root/shaders/main.glsl", "void main()\n{\n}\n");
    scratch_write("root/chapters/01_scene.frag", "#include \"main.glsl\"\n");
    assert_refused("#include \"01_scene.frag\"\n", "main.frag:1: take #version out");
}

static void test_compiled_text(void **state)
{
    (void)state;
    struct shader_source source = read_well("#include \"twig.glsl\"\nx\n");
    char *text = shader_text(&source, SHADER_STEPS);
    assert_string_equal(text,
                        "#version 330 core\n#define VIEW 3\n// #include \"twig.glsl\"\n// twig\n"
                        "// #include \"leaf.glsl\"\nfloat leaf();\nfloat twig();\nx\n");
    assert_null(strstr(text, "#line"));
    free(text);
    shader_free(&source);
    source = read_well("#version 330 core\nx\n");
    text = shader_text(&source, SHADER_PICTURE);
    assert_string_equal(text, "#version 330 core\nx\n");
    free(text);
    shader_free(&source);
}

static void test_views(void **state)
{
    (void)state;
    enum shader_view view = SHADER_PICTURE;
    for (int i = 0; i < SHADER_VIEW_COUNT; i++) {
        assert_true(shader_view_from_name(shader_view_name((enum shader_view)i), &view));
        assert_int_equal(view, i);
    }
    assert_false(shader_view_from_name("probe", &view));
    assert_false(shader_view_from_name("", &view));
    struct shader_source source = read_well("#version 330 core\n");
    assert_true(shader_has_view(&source, SHADER_PICTURE));
    for (int i = SHADER_NORMALS; i < SHADER_PROGRAM_COUNT; i++) {
        capture_begin();
        assert_false(shader_has_view(&source, (enum shader_view)i));
        const char *said = capture_end();
        assert_int_equal(line_count(said), 1);
        assert_non_null(strstr(said, "main of its own"));
        assert_non_null(strstr(said, shader_view_name((enum shader_view)i)));
    }
    shader_free(&source);
    source = read_well("x\n");
    assert_true(shader_has_view(&source, SHADER_SLICE));
    assert_true(shader_has_view(&source, SHADER_PROBE));
    shader_free(&source);
}

int main(void)
{
#define UNIT(test) cmocka_unit_test_setup_teardown(test, set_up, scratch_teardown)
    const struct CMUnitTest tests[] = {
        UNIT(test_forms),
        UNIT(test_forms_behind_conditions),
        UNIT(test_versions),
        UNIT(test_shadertoy_s_words),
        UNIT(test_values_begin_at_zero),
        UNIT(test_texts_without_sense),
        UNIT(test_what_cannot_be_judged_is_left_alone),
        UNIT(test_outputs),
        UNIT(test_forms_of_main_image),
        UNIT(test_version_above_a_chapter),
        UNIT(test_inputs_and_textures),
        UNIT(test_compiled_text),
        UNIT(test_views),
    };
    return cmocka_run_group_tests_name("form", tests, NULL, NULL);
}
