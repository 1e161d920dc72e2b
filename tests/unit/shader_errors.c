// shader_errors.c - tests that a driver's errors are reported with the author's files and lines:
// first with sample logs in the formats of three drivers, then with real mistakes and this
// machine's driver. The last test asks for views that a file does not have.
#include "lib/test.h"

#include "context/context.h"
#include "memory.h"
#include "shader/compile.h"
#include "lib/scratch.h"

static struct {
    struct context context;
    bool has_context;
} driver;

static int set_up(void **state)
{
    scratch_setup(state);
    scratch_write("root/shaders/lib.glsl", "// lib\n  float lib() { return x; }\n");
    return 0;
}

static struct shader_source read_text(const char *text)
{
    struct shader_source source;
    if (!shader_read(&source, scratch_write("root/main.frag", text), scratch_path("root")))
        fail_msg("cannot be read: %s", text);
    return source;
}

// ---- Logs ----

// Of the lines that the driver compiles, lines 1 and 2 are the prelude, line 3 is the include,
// lines 4 and 5 are lib.glsl, and lines 6 and 7 are lines 2 and 3 of main.frag. The prelude of a
// course shader has a line for each view instead, which with_prelude takes into account.
static const char course[] =
    "#include \"lib.glsl\"\n\tfloat f() { return y; }\nint g() { return 2; }\n";

// Add to the number of each line below the prelude, in a driver's log, the lines by which the
// prelude is longer than two.
static char *with_prelude(const struct shader_source *source, const char *log)
{
    char *prelude = shader_prelude(source, VIEW_PICTURE), *result;
    long more = source->dialect == DIALECT_COURSE ? -2 : 0;
    for (const char *c = prelude; source->dialect == DIALECT_COURSE && *c != '\0'; c++)
        more += *c == '\n';
    free(prelude);
    FILE *text = memory_open(&result);
    for (const char *c = log; *c != '\0'; c++) {
        bool line = c[0] == '0' && (c[1] == ':' || c[1] == '(') && c[2] >= '0' && c[2] <= '9';
        char *end = NULL;
        long number = line ? strtol(c + 2, &end, 10) : 0;
        if (line && number > 2) {
            fprintf(text, "0%c%ld", c[1], number + more);
            c = end - 1;
        } else
            fputc(*c, text);
    }
    memory_close(text);
    return result;
}

// Check the explanation of a log. Each @ in expected stands for the path of main.frag.
static void assert_explained(const char *text, const char *short_log, const char *short_expected)
{
    struct shader_source source = read_text(text);
    char *log = with_prelude(&source, short_log), *expected = with_prelude(&source, short_expected);
    char wanted[4096] = "";
    for (const char *c = expected; *c != '\0'; c++) {
        size_t size = strlen(wanted);
        if (*c == '@')
            snprintf(wanted + size, sizeof wanted - size, "%s", source.files[0]);
        else
            snprintf(wanted + size, sizeof wanted - size, "%c", *c);
    }
    char *explained = shader_explain(&source, VIEW_PICTURE, log);
    assert_non_null(explained);
    assert_string_equal(explained, wanted);
    free(explained);
    free(log);
    free(expected);
    shader_free(&source);
}

#define IN_PROJECT(name) TEST_WITH(name, set_up, scratch_teardown)

IN_PROJECT(test_a_log_of_mesa_is_explained)
{
    assert_explained(course, "0:5(24): error: `x' undeclared\n0:6(20): error: `y' undeclared\n",
                     "shaders/lib.glsl:2: error: `x' undeclared\n    float lib() { return x; }\n"
                     "@:2: error: `y' undeclared\n    float f() { return y; }\n");
    assert_explained(course, "0:7(1): preprocessor error: #error why: not\n",
                     "@:3: error: #error why: not\n    int g() { return 2; }\n");
}

IN_PROJECT(test_a_log_of_nvidia_is_explained)
{
    assert_explained(
        course,
        "0(5) : error C1503: undefined variable \"x\"\r\n0(6) : error C1503: undefined "
        "variable \"y\"\r\n",
        "shaders/lib.glsl:2: error: C1503: undefined variable \"x\"\n"
        "    float lib() { return x; }\n"
        "@:2: error: C1503: undefined variable \"y\"\n    float f() { return y; }\n");
}

IN_PROJECT(test_logs_of_other_drivers_are_explained)
{
    assert_explained(course,
                     "ERROR: 0:5: 'x' : undeclared identifier\nERROR: 0:6: 'y' : undeclared "
                     "identifier\nERROR: 2 compilation errors.  No code generated.\n",
                     "shaders/lib.glsl:2: error: 'x' : undeclared identifier\n"
                     "    float lib() { return x; }\n"
                     "@:2: error: 'y' : undeclared identifier\n    float f() { return y; }\n"
                     "ERROR: 2 compilation errors.  No code generated.\n");
    assert_explained(course, "WARNING: 0:6: odd\n",
                     "@:2: warning: odd\n    float f() { return y; }\n");
}

// Two lines precede a file with its own main, and the first of them replaces the file's #version. A
// main follows a file in Shadertoy's dialect, and an error there is reported for the file's last
// line.
IN_PROJECT(test_errors_in_other_dialects_have_the_right_line)
{
    assert_explained("#version 330 core\nint f() { return 1.0; }\n", "0:5(11): error: bad\n",
                     "@:2: error: bad\n    int f() { return 1.0; }\n");
    assert_explained("\n#version 330 core\nx\n", "0:1(1): error: bad\n",
                     "@:2: error: bad\n    #version 330 core\n");
    assert_explained(
        "#version 330 core\n#extension GL_NONE : require\n",
        "0:4(12): error: extension `GL_NONE' unsupported\n",
        "@:2: error: extension `GL_NONE' unsupported\n    #extension GL_NONE : require\n");
    assert_explained("void mainImage(out vec4 c, vec2 p) {\n", "0:99(1): error: bad\n",
                     "@:1: error: bad\n    void mainImage(out vec4 c, vec2 p) {\n");
}

IN_PROJECT(test_lines_that_cannot_be_mapped_are_kept)
{
    assert_explained(course, "", "");
    assert_explained(course, "\n \n", "");
    const char *const kept[] = {"error: fragment shader lacks `main'\n",
                                "0:1(1): error: prelude\n",
                                "0:2(1): error: prelude\n",
                                "0:0(0): error: nowhere\n",
                                "0:9(1): error: beyond\n",
                                "0:99999999999(1): error: beyond\n",
                                "0(: error\n",
                                "0:\n",
                                "ERROR:\n",
                                "0:5\n"};
    for (size_t i = 0; i < sizeof kept / sizeof *kept; i++)
        assert_explained(course, kept[i], kept[i]);
    // For a text that ends too early, the driver blames the line after the last line, but the
    // explanation names the last line.
    assert_explained(course, "0:8(1): error: unexpected end of file\n",
                     "@:3: error: unexpected end of file\n    int g() { return 2; }\n");
}

IN_PROJECT(test_repetitions_and_warnings_beside_errors_are_left_out)
{
    assert_explained(course, "0:6(1): error: a\n0:6(1): error: a\n0:6(2): error: b\n",
                     "@:2: error: a\n    float f() { return y; }\n@:2: error: b\n");
    assert_explained(course, "0:5(1): warning: w\n0:6(1): error: a\n",
                     "@:2: error: a\n    float f() { return y; }\n");
    assert_explained(course, "0:6(1): warning: w\n",
                     "@:2: warning: w\n    float f() { return y; }\n");
}

IN_PROJECT(test_an_unresolved_function_is_reported_at_its_call)
{
    scratch_write("root/shaders/lib.glsl", "float far(vec3 p);\n// far(p)\nfloat near(vec3 p)\n{\n"
                                           "    return far (p);\n}\n");
    const char text[] = "#include \"lib.glsl\"\nfloat other = 2.0 * far(p);\n";
    const char *const logs[] = {"error: unresolved reference to function `far'\n",
                                "error C3002: call to undefined function \"float far(vec3);\"\n",
                                "ERROR: Implementation of far(vf3; is not found\n"};
    const char *const expected[] = {
        "shaders/lib.glsl:5: error: unresolved reference to function `far'\n    return far (p);\n",
        "shaders/lib.glsl:5: error: C3002: call to undefined function \"float far(vec3);\"\n"
        "    return far (p);\n",
        "shaders/lib.glsl:5: error: Implementation of far(vf3; is not found\n"
        "    return far (p);\n"};
    for (int i = 0; i < 3; i++)
        assert_explained(text, logs[i], expected[i]);
    assert_explained(text, "error: unresolved reference to function `nowhere'\n",
                     "error: unresolved reference to function `nowhere'\n");
}

// ---- The driver of this machine ----

static const char library_ok[] = "float lib(float x)\n{\n    return 2.0 * x;\n}\n";
static const char main_ok[] = "#include \"lib.glsl\"\nout vec4 colour;\nvoid main()\n{\n"
                              "    colour = vec4(lib(1.0));\n}\n";

// Link a library and a main file. Returns the program, or 0 if the driver refuses the text.
//   said  receives what was reported
static GLuint link_files(const char *library, const char *text, const char **said)
{
    struct shader_source vertex;
    scratch_write("root/shaders/lib.glsl", library);
    scratch_write("root/shaders/screen.vert", "void main() { gl_Position = vec4(0.0); }\n");
    assert_true(
        shader_read(&vertex, scratch_path("root/shaders/screen.vert"), scratch_path("root")));
    struct shader_source source = read_text(text);
    capture_begin();
    GLuint program = shader_link(&driver.context.gl, &vertex, &source, VIEW_PICTURE);
    *said = capture_end();
    shader_free(&source);
    shader_free(&vertex);
    return program;
}

static void assert_blamed(const char *library, const char *text, const char *where,
                          const char *shown)
{
    const char *said;
    if (!driver.has_context)
        skip();
    assert_int_equal(link_files(library, text, &said), 0);
    const char *location = strstr(said, where);
    if (strncmp(said, scratch_path("root/main.frag"), strlen(scratch_path("root/main.frag"))) != 0)
        fail_msg("the message does not begin with the path of main.frag: %s", said);
    if (location == NULL || strstr(location, shown) == NULL)
        fail_msg("'%s', or '%s' after it, is missing in: %s", where, shown, said);
    assert_int_equal(driver.context.gl.GetError(), GL_NO_ERROR);
}

IN_PROJECT(test_good_shader_links_in_silence)
{
    const char *said;
    if (!driver.has_context)
        skip();
    GLuint program = link_files(library_ok, main_ok, &said);
    assert_int_not_equal(program, 0);
    assert_string_equal(said, "");
    driver.context.gl.DeleteProgram(program);
}

IN_PROJECT(test_syntax_errors_have_the_right_line)
{
    assert_blamed("float lib(float x)\n{\n    return 2.0 * ;\n}\n", main_ok,
                  "\nshaders/lib.glsl:3: error: ", "\n    return 2.0 * ;\n");
    assert_blamed(
        library_ok,
        "#include \"lib.glsl\"\nout vec4 colour;\nvoid main()\n{\n    colour = = lib(1.0);\n}\n",
        "/root/main.frag:5: error: ", "\n    colour = = lib(1.0);\n");
}

// The driver notices a missing semicolon only at the next token, so the message names the token's
// line and the line where the semicolon may be missing.
IN_PROJECT(test_a_missing_semicolon_is_reported_with_both_lines)
{
    assert_blamed("float lib(float x)\n{\n    float y = x\n\n    return 2.0 * y;\n}\n", main_ok,
                  "\nshaders/lib.glsl:5: error: ", ", or at the end of line 3\n");
    const char *said;
    assert_int_equal(
        link_files("float lib(float x)\n{\n    float y = x;\n    2.0 * ;\n}\n", main_ok, &said), 0);
    assert_null(strstr(said, "or at the end"));
}

IN_PROJECT(test_undeclared_names_have_the_right_line)
{
    assert_blamed("float lib(float x)\n{\n\n    return 2.0 * z;\n}\n", main_ok,
                  "\nshaders/lib.glsl:4: error: ", "\n    return 2.0 * z;\n");
    assert_blamed(
        library_ok,
        "#include \"lib.glsl\"\nout vec4 colour;\nvoid main()\n{\n    colour = vec4(none);\n}\n",
        "/root/main.frag:5: error: ", "\n    colour = vec4(none);\n");
}

IN_PROJECT(test_errors_in_a_file_with_its_own_main_have_the_right_line)
{
    assert_blamed(library_ok,
                  "#version 330 core\n#include \"lib.glsl\"\nout vec4 colour;\nvoid main()\n{\n"
                  "    colour = vec4(none);\n}\n",
                  "/root/main.frag:6: error: ", "\n    colour = vec4(none);\n");
}

IN_PROJECT(test_characters_outside_ascii_are_named)
{
    assert_blamed(library_ok,
                  "#version 330 core\nout vec4 c; // é\nvoid main()\n{\n    float \xC3\xA9t;\n"
                  "    c = vec4(1.0);\n}\n",
                  "main.frag:5: error: only ASCII characters are allowed here; found '\xC3\xA9'",
                  "float");
    assert_blamed(
        library_ok,
        "#version 330 core\nout vec4 c;\nvoid main()\n{\n    c =\xC2\xA0vec4(1.0);\n}\n",
        "main.frag:5: error: only ASCII characters are allowed here; found a no-break space",
        "vec4");
}

IN_PROJECT(test_calls_that_link_to_nothing_are_reported)
{
    assert_blamed("float gone(float x);\nfloat lib(float x)\n{\n    return gone(x);\n}\n", main_ok,
                  "\nshaders/lib.glsl:4: error: ", "gone");
    assert_blamed("float lib(float x);\n", main_ok, "/root/main.frag:5: error: ", "lib");
    assert_blamed(library_ok, "#include \"lib.glsl\"\nfloat f() { return lib(1.0); }\n",
                  "draws no picture, because it has no main", "mainImage");
    assert_blamed(library_ok, "#version 330 core\nfloat f(float x) { return x; }\n",
                  "draws no picture, because it has no main", "mainImage");
}

static int open_context(void **state)
{
    (void)state;
    driver.has_context = context_open_offscreen(&driver.context, CONTEXT_ANY);
    return 0;
}

static int close_context(void **state)
{
    (void)state;
    context_close(&driver.context);
    return 0;
}

// ---- Views ----

IN_PROJECT(test_only_files_in_the_course_s_dialect_have_all_views)
{
    enum shader_view view = VIEW_PICTURE;
    for (int i = 0; i < SHADER_VIEW_COUNT; i++) {
        assert_true(shader_view_from_name(shader_view_name((enum shader_view)i), &view));
        assert_int_equal(view, i);
    }
    assert_false(shader_view_from_name("probe", &view));
    assert_false(shader_view_from_name("", &view));
    struct shader_source source = read_text("#version 330 core\n");
    assert_true(shader_has_view(&source, VIEW_PICTURE));
    for (int i = VIEW_NORMALS; i < SHADER_PROGRAM_COUNT; i++) {
        capture_begin();
        assert_false(shader_has_view(&source, (enum shader_view)i));
        const char *said = capture_end();
        assert_int_equal(line_count(said), 1);
        assert_non_null(strstr(said, "only shaders in the course's dialect"));
        assert_non_null(strstr(said, shader_view_name((enum shader_view)i)));
    }
    shader_free(&source);
    source = read_text("x\n");
    assert_true(shader_has_view(&source, VIEW_SLICE));
    assert_true(shader_has_view(&source, VIEW_PROBE));
    shader_free(&source);
}

TESTS(open_context, close_context)
