// dialect.c - tests how the dialect of a shader file is determined, how a file is translated for
// the driver, and that a text that cannot draw a picture is refused with one clear line.
#include "lib/test.h"

#include "memory.h"
#include "shader/compile.h"
#include "lib/scratch.h"

static int set_up(void **state)
{
    scratch_setup(state);
    scratch_write("root/shaders/leaf.glsl", "float leaf();\n");
    scratch_write("root/shaders/twig.glsl", "// twig\n#include \"leaf.glsl\"\nfloat twig();\n");
    return 0;
}

// Read a text as root/chapters/main.frag. Returns true on success; *said receives whatever was
// reported.
static bool read_text(struct shader_source *source, const char *text, const char **said)
{
    const char *path = scratch_write("root/chapters/main.frag", text);
    capture_begin();
    bool done = shader_read(source, path, scratch_path("root"));
    *said = capture_end();
    return done;
}

// Read a text. Fails the test if the text is refused or anything is reported.
static struct shader_source read_well(const char *text)
{
    struct shader_source source;
    const char *said;
    if (!read_text(&source, text, &said) || said[0] != '\0')
        fail_msg("%s: %s", text, said);
    return source;
}

static void assert_dialect(const char *text, enum shader_dialect dialect)
{
    struct shader_source source = read_well(text);
    if (source.dialect != dialect)
        fail_msg("%s: dialect %d, not %d", text, (int)source.dialect, (int)dialect);
    shader_free(&source);
}

// Check that a #version line followed by this text is refused with a single line that contains
// these words.
static void assert_refused(const char *text, const char *words)
{
    struct shader_source source;
    const char *said;
    char *whole = memory_text("#version 330 core\n%s", text);
    assert_false(read_text(&source, whole, &said));
    free(whole);
    if (line_count(said) != 1 || strstr(said, words) == NULL)
        fail_msg("%s: expected one line that contains '%s', not: %s", text, words, said);
}

// A main that writes a colour.
#define MAIN "out vec4 colour; void main() { colour = vec4(1.0); }\n"

#define IN_PROJECT(name) TEST_WITH(name, set_up, scratch_teardown)

IN_PROJECT(test_the_dialect_follows_from_the_text)
{
    assert_dialect("#version 330 core\n" MAIN, DIALECT_WHOLE);
    assert_dialect("// why\n/* and\nhow */ # version 330 core\n#include \"leaf.glsl\"\n",
                   DIALECT_WHOLE);
    assert_dialect("#version 330 core\nvoid mainImage(out vec4 c, in vec2 p) {}\n",
                   DIALECT_SHADERTOY);
    assert_dialect("#version 330 core\nvoid mainImage(out vec4 c, in vec2 p) {} " MAIN,
                   DIALECT_WHOLE);
    assert_dialect("// #version 330\n" MAIN, DIALECT_WHOLE);
    assert_dialect("void mainImage(out vec4 c, in vec2 p);\n", DIALECT_SHADERTOY);
    assert_dialect("void my_main() {}\nvoid mainImage(out vec4 c, in vec2 p) {}\n",
                   DIALECT_SHADERTOY);
    assert_dialect("void main();\nvoid mainImage(out vec4 c, in vec2 p) {}\n", DIALECT_SHADERTOY);
    assert_dialect("// void mainImage(out vec4 c, in vec2 p) {}\nfloat x;\n", DIALECT_COURSE);
    assert_dialect("void mainImage(out vec4 c, in vec2 p) {}\n" MAIN, DIALECT_WHOLE);
    assert_dialect("void mainImages(out vec4 c) {}\nvoid notmainImage() {}\n", DIALECT_COURSE);
    scratch_write("root/shaders/main.glsl", "void main()\n{\n}\n");
    assert_dialect("#include \"main.glsl\"\nvoid mainImage(int a) {}\n", DIALECT_COURSE);
    assert_dialect("#include \"main.glsl\"\nRay pixelRay(vec2 s);\n" MAIN, DIALECT_COURSE);
    assert_dialect("void mainImage( out vec4 c,\n in vec2 p )\n{ }\n", DIALECT_SHADERTOY);
    assert_dialect("uniform int iFrame; void main() { gl_Position = vec4(0.0); }\n",
                   DIALECT_COURSE);
}

// A file with its own main is a whole shader, whether it includes parts of its own, parts of the
// course's library, or a main.glsl that is not the course's.
IN_PROJECT(test_an_include_does_not_affect_the_dialect)
{
    scratch_write("root/chapters/lib/ring.glsl", "float ring(vec2 q) { return length(q); }\n");
    scratch_write("root/chapters/lib/main.glsl", "float half_of(float x) { return 0.5 * x; }\n");
    assert_dialect("uniform vec2 u_resolution;\n#include \"lib/ring.glsl\"\n" MAIN, DIALECT_WHOLE);
    assert_dialect("#include \"lib/main.glsl\"\n" MAIN, DIALECT_WHOLE);
    assert_dialect("#include \"twig.glsl\"\n" MAIN, DIALECT_WHOLE);
    assert_dialect("uniform float x = 0.5; // 0.5 in [0, 1]\n#include \"leaf.glsl\"\n" MAIN,
                   DIALECT_WHOLE);
    assert_dialect("#include \"lib/ring.glsl\"\nvoid mainImage(out vec4 c, in vec2 p) {}\n",
                   DIALECT_SHADERTOY);
}

// Text that the preprocessor skips does not affect the dialect.
IN_PROJECT(test_skipped_text_does_not_affect_the_dialect)
{
    static const char toy[] = "void mainImage(out vec4 c, in vec2 p) {}\n";
    static const struct {
        const char *before, *after;
        enum shader_dialect dialect; // of a text that consists of before, MAIN, after and toy
    } cases[] = {
        {"#if 0\n", "#endif\n", DIALECT_SHADERTOY},
        {"#if 1\n", "#endif\n", DIALECT_WHOLE},
        {"#ifdef DESKTOP\n", "#endif\n", DIALECT_SHADERTOY},
        {"#define DESKTOP\n#ifdef DESKTOP\n", "#endif\n", DIALECT_WHOLE},
        {"#define DESKTOP 1\n#undef DESKTOP\n#ifdef DESKTOP\n", "#endif\n", DIALECT_SHADERTOY},
        {"#define DESKTOP\n#if X\n#undef DESKTOP\n#endif\n#ifdef DESKTOP\n", "#endif\n",
         DIALECT_WHOLE},
        {"#ifndef DESKTOP\n", "#endif\n", DIALECT_WHOLE},
        {"#ifdef GL_ES\n", "#endif\n", DIALECT_SHADERTOY},
        {"#ifdef GL_ARB_gpu_shader5\n", "#endif\n", DIALECT_WHOLE},
        {"#if defined(DESKTOP)\n", "#endif\n", DIALECT_SHADERTOY},
        {"#if !defined DESKTOP\n", "#endif\n", DIALECT_WHOLE},
        {"#if defined(DESKTOP) || 1\n", "#endif\n", DIALECT_WHOLE},
        {"#if __VERSION__ > 100\n", "#endif\n", DIALECT_WHOLE},
        {"#if 1\n#else\n", "#endif\n", DIALECT_SHADERTOY},
        {"#if 0\n#else\n", "#endif\n", DIALECT_WHOLE},
        {"#if 1\n#elif 1\n", "#endif\n", DIALECT_SHADERTOY},
        {"#if 1\n#elif 1\n#else\n", "#endif\n", DIALECT_SHADERTOY},
        {"#if 0\n#elif X\n", "#endif\n", DIALECT_WHOLE},
        {"#if 0\n#if 1\n", "#endif\n#endif\n", DIALECT_SHADERTOY},
        {"#if 0\n#define DESKTOP\n#endif\n#ifdef DESKTOP\n", "#endif\n", DIALECT_SHADERTOY},
        {"#if 0\n#endif\n", "#endif\n#else\n", DIALECT_WHOLE},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[512];
        snprintf(text, sizeof text, "%s" MAIN "%s%s", cases[i].before, cases[i].after, toy);
        assert_dialect(text, cases[i].dialect);
    }
}

// In Shadertoy's dialect, gl_FragCoord is the pixel's position in the whole picture, whichever part
// is drawn, and mainImage's output becomes inout, because the colour is set to 0 before the call.
IN_PROJECT(test_main_image_is_adapted_to_the_renderer)
{
    struct shader_source source;
    const char *said;
    assert_true(
        read_text(&source, "void mainImage(out vec4 c, in vec2 p) { c = gl_FragCoord; }\n", &said));
    char *compiled = shader_text(&source, VIEW_PICTURE);
    assert_non_null(
        strstr(compiled,
               "\nvoid mainImage(inout vec4 c, in vec2 p) {c=vec4(0); c = harnessFragCoord; }\n"));
    free(compiled);
    shader_free(&source);
}

// Versions and extensions that the driver may not know are removed from the text that it gets.
IN_PROJECT(test_versions_and_extensions_are_removed)
{
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
        char *compiled = shader_text(&source, VIEW_PICTURE);
        if (strstr(compiled, cases[i].word) != NULL)
            fail_msg("'%s' in %s", cases[i].word, compiled);
        free(compiled);
        shader_free(&source);
    }
}

// Check that the driver gets the expected text, after the prelude, for a #version line followed by
// this text.
static void assert_driver_gets(const char *text, const char *expected)
{
    char whole[512];
    snprintf(whole, sizeof whole, "#version 330 core\n%s", text);
    struct shader_source source;
    const char *said;
    assert_true(read_text(&source, whole, &said));
    char *behind = memory_text("\n%s", expected);
    assert_string_equal(source.body, behind);
    free(behind);
    shader_free(&source);
}

IN_PROJECT(test_values_begin_at_zero)
{
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
        "#define A float x;\nuniform float u;\nprecision highp float;\nin vec2 FragCoord;\n",
        "#define A float x;\nuniform float u;\nprecision highp float;\nin vec2 FragCoord;\n");
    assert_driver_gets("out vec4 c;\nvoid main() { if (x) c = vec4(1.0); }\n",
                       "out vec4 c;\nvoid main() {c=vec4(0); if (x) c = vec4(1.0); }\n");
}

// A declaration stays as it is if a macro or an #if may change its meaning, if it is a member of a
// block, or if an initial value of zeros would be too long or too complicated.
IN_PROJECT(test_unclear_declarations_stay)
{
    static const char *const texts[] = {
        "#define float highp float\nfloat x;\nvoid f() { float y; }\n",
        "#define x y[2]\nfloat x;\n",
        "#define BLOCK(n) uniform n\nBLOCK(Data) { vec4 v; float k; };\n",
        "#define BLOCK uniform Data\nBLOCK { vec4 v; float k; } data;\n",
        "uniform Data { vec4 v; float k; };\n",
        "struct S { float[2] a; };\nS s;\n",
        "#define N 2\nstruct S {\nfloat a;\n#if N > 1\nvec3 b;\n#endif\nint c; };\nS s;\n",
        "#define N 2\nstruct S {\nfloat a;\n#if N > 1\nvec3 b;\n#endif\n};\nS s;\n",
        "#ifdef GL_X\nstruct S { float a; };\n#else\nstruct S { vec2 a; };\n#endif\nS s;\n",
        "float a[300], c[2][2];\nconst int n = 1 + 1;\nvoid f() { float b[n]; }\n",
        "uniform int count;\nvoid f() { float d[count]; }\n",
        "#define N 2\n#undef N\n#define N 3\nfloat b[N];\n",
        "#define in in b,\nin int Time;\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        assert_driver_gets(texts[i], texts[i]);
    assert_driver_gets("#define N 2\nconst int n = 1;\nfloat a[N], b[n];\n",
                       "#define N 2\nconst int n = 1;\n"
                       "float a[N]=float[2](float(0),float(0)), b[n]=float[1](float(0));\n");
    assert_driver_gets("#define IN in\nIN int Time;\n", "#define IN in\nuniform int Time;\n");
    assert_driver_gets("struct A { vec2 p; }; struct B { A a[2]; int n, m; } b, c[2]; float d;\n",
                       "struct A { vec2 p; }; struct B { A a[2]; int n, m; } "
                       "b=B(A[2](A(vec2(0)),A(vec2(0))),int(0),int(0)), "
                       "c[2]=B[2](B(A[2](A(vec2(0)),A(vec2(0))),int(0),int(0)),"
                       "B(A[2](A(vec2(0)),A(vec2(0))),int(0),int(0))); float d=float(0);\n");
}

IN_PROJECT(test_outputs_that_cannot_be_shown_are_refused)
{
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
    assert_dialect(whole, DIALECT_WHOLE);
    assert_refused("out ivec4 A; void main() { A = ivec4(1); }\n",
                   "main.frag:2: out ivec4 A: a picture is made of colours: write out vec4 A;");
    assert_refused("\nout float A; void main() { A = 1.0; }\n", "main.frag:3: out float A: a pict");
}

IN_PROJECT(test_meaningless_texts_are_refused)
{
    assert_refused("float a[65536]; int i = a[ 65537 ];\n",
                   "main.frag:2: an array of 65537 elements");
    assert_refused("\nfloat a[99999999999999999999999];\n",
                   "main.frag:3: an array of 99999999999999999999 elements");
    struct shader_source source;
    const char *said;
    assert_false(read_text(&source, "// nothing\n/* but\n */\n", &said));
    assert_non_null(strstr(said, "main.frag: contains only comments"));
}

// What grows: macros that double, an if within an if, and functions that call another one twice.
IN_PROJECT(test_only_a_macro_that_expands_too_much_is_refused)
{
    char macros[2048] = "#define A0 1.0\n", ifs[2048] = "", ends[64] = "", calls[2048] = "";
    for (int i = 1; i <= 28; i++) {
        memory_append(macros, sizeof macros, "#define A%d A%d + A%d\n", i, i - 1, i - 1);
        memory_append(ifs, sizeof ifs, "if (o.x > %d.0) { ", i);
        memory_append(ends, sizeof ends, "}");
        memory_append(calls, sizeof calls, "float f%d() { return f%d() + f%d(); }\n", i, i - 1,
                      i - 1);
    }
    char text[8192];
    snprintf(text, sizeof text, "%sout vec4 o; void main() { o = vec4(A28); }\n", macros);
    assert_refused(text, "main.frag:31: A28: this macro expands to more than 4 million");
    snprintf(text, sizeof text,
             "%sfloat f0() { return 1.0; }\n%sout vec4 o; void main() { o = vec4(A20); %s%s }\n",
             macros, calls, ifs, ends);
    struct shader_source source = read_well(text);
    shader_free(&source);
}

IN_PROJECT(test_inputs_and_textures_are_checked_and_translated)
{
#define WRITES "out vec4 A; void main() { A = vec4(k); }\n"
    assert_driver_gets("flat in int CustomInt; out vec4 A; void main(){ A = vec4(CustomInt); }\n",
                       "uniform int CustomInt; out vec4 A; void main(){A=vec4(0); A = "
                       "vec4(CustomInt); }\n");
    assert_driver_gets("layout(location = 3) in vec3 FragCoord, Time;\n",
                       "in vec3 FragCoord; uniform vec3  Time;\n");
    assert_refused("in ivec2 FragCoord; " WRITES, "in ivec2 FragCoord: FragCoord is a vec2 here");
    assert_refused("flat in mat2 Time; " WRITES,
                   "in mat2 Time: Time is a float here: declare it as");
    assert_refused("layout(location = 3) in vec2 k; " WRITES,
                   "in vec2 k: comes from a vertex shader");
    assert_refused("varying vec2 k, vTexCoor; out vec4 A; void main() { A = vTexCoor.xyxy; }\n",
                   "call it v_texcoord if");
    assert_dialect("#version 330 core\n#ifdef OLD\nin vec2 k;\n#else\nfloat k;\n#endif\n" WRITES,
                   DIALECT_WHOLE);
    assert_dialect("#version 330 core\nuniform sampler2D tex; float k; " WRITES, DIALECT_WHOLE);
    // An input that is declared as an array instead of a single value, or the reverse, would never
    // be set.
    assert_refused(
        "uniform sampler2D iChannel0[2]; out vec4 A; void main() { A = texture(iChannel0[1], "
        "vec2(0)); }\n",
        "uniform sampler2D[] iChannel0: iChannel0 is a sampler2D here");
    assert_refused("uniform vec3 iChannelResolution; " WRITES,
                   "uniform vec3 iChannelResolution: iChannelResolution is a vec3[4] here");
    assert_dialect("#version 330 core\nuniform vec3[4] iChannelResolution; " WRITES, DIALECT_WHOLE);
}

IN_PROJECT(test_main_image_must_have_the_right_parameters)
{
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
        "void mainImage(vec4 c, in vec2 p) {}\n",
    };
    for (size_t i = 0; i < sizeof good / sizeof *good; i++)
        assert_dialect(good[i], DIALECT_SHADERTOY);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_refused(bad[i], "main.frag:2: mainImage has parameters other than those it is "
                               "called with: write void mainImage(out vec4 fragColor, in vec2");
}

IN_PROJECT(test_a_version_above_a_chapter_is_refused)
{
    scratch_write("root/shaders/main.glsl", "void main()\n{\n}\n");
    scratch_write("root/chapters/01_scene.frag", "#include \"main.glsl\"\n");
    assert_refused("#include \"01_scene.frag\"\n", "main.frag:1: remove #version");
}

IN_PROJECT(test_the_driver_gets_the_expanded_text)
{
    struct shader_source source = read_well("#include \"twig.glsl\"\nx\n");
    char *text = shader_text(&source, VIEW_STEPS);
    assert_int_equal(strncmp(text, "#version 330 core\n#define VIEW_PICTURE 0\n", 41), 0);
    assert_non_null(strstr(text, "\n#define VIEW VIEW_STEPS\n"));
    assert_non_null(strstr(text,
                           ")\n// #include \"twig.glsl\"\n// twig\n// #include \"leaf.glsl\"\n"
                           "float leaf();\nfloat twig();\nx\n"));
    assert_null(strstr(text, "#line"));
    free(text);
    shader_free(&source);
    source = read_well("#version 330 core\nx\n");
    text = shader_text(&source, VIEW_PICTURE);
    assert_string_equal(text, "#version 330 core\n"
                              "#extension GL_ARB_shading_language_420pack : enable\n"
                              "#extension GL_ARB_shading_language_packing : enable\n\nx\n");
    free(text);
    shader_free(&source);
}

TESTS(NULL, NULL)
