// Tests of common/context/context.c and its backends, without a window.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../common/context/context.h"
#include "support_system.h"

// What a child does with the environment changed; true when it went as it should.
struct child {
    const char *variable, *value;
    enum context_backend backend;
    bool window;
    const char *expected; // in the one line that it reports
};

// Open as a child of its own, where drivers read the environment anew, and listen to the report.
// Returns true when opening failed with one line that holds the expected text.
static bool refuses(const struct child *child)
{
    char heard[4096] = "";
    int ends[2], status = -1;
    size_t length = 0;
    fflush(NULL);
    assert_int_equal(pipe(ends), 0);
    pid_t process = fork();
    if (process == 0) {
        struct context context;
        dup2(ends[1], STDERR_FILENO);
        setenv(child->variable, child->value, 1);
        unsetenv("DISPLAY");
        unsetenv("WAYLAND_DISPLAY");
        bool opened = child->window ? context_open_window(&context, child->backend, "", 64, 64)
                                    : context_open_offscreen(&context, child->backend);
        _exit(opened || context.driver != NULL ? 1 : 0);
    }
    close(ends[1]);
    for (ssize_t got = 1; got > 0; length += (size_t)got) {
        got = read(ends[0], heard + length, sizeof heard - 1 - length);
        got = got < 0 ? 0 : got;
    }
    close(ends[0]);
    waitpid(process, &status, 0);
    const char *end = strchr(heard, '\n');
    bool good = status == 0 && end != NULL && end[1] == '\0' && strstr(heard, child->expected);
    if (!good)
        print_message("# expected '%s', status %d, heard '%s'\n", child->expected, status, heard);
    return good;
}

static bool built_in(enum context_backend backend)
{
    static const bool built[] = {
#ifdef HAVE_GLFW
        [CONTEXT_GLFW] = true,
#endif
#ifdef HAVE_EGL
        [CONTEXT_EGL] = true,
#endif
#ifdef HAVE_OSMESA
        [CONTEXT_OSMESA] = true,
#endif
        [CONTEXT_ANY] = true};
    return (size_t)backend < sizeof built && built[backend];
}

static void names_of_backends_are_known(void **state)
{
    (void)state;
    enum context_backend backend = CONTEXT_ANY;
    assert_true(context_backend_from_name("glfw", &backend) && backend == CONTEXT_GLFW);
    assert_true(context_backend_from_name("egl", &backend) && backend == CONTEXT_EGL);
    assert_true(context_backend_from_name("osmesa", &backend) && backend == CONTEXT_OSMESA);
    static const char *const unknown[] = {"", "EGL", "eglx", "eg", "any", "vulkan"};
    for (size_t i = 0; i < sizeof unknown / sizeof *unknown; i++)
        assert_false(context_backend_from_name(unknown[i], &backend));
    assert_int_equal(backend, CONTEXT_OSMESA);
}

static void an_old_driver_is_refused(void **state)
{
    (void)state;
    static const enum context_backend backends[] = {CONTEXT_EGL, CONTEXT_OSMESA};
    static const char *const expected[] = {"egl: surfaceless: eglCreateContext for OpenGL 3.3",
                                           "osmesa: OSMesaCreateContextAttribs refuses"};
    for (int i = 0; i < 2; i++) {
        const struct child child = {.variable = "MESA_GL_VERSION_OVERRIDE",
                                    .value = "3.2",
                                    .backend = backends[i],
                                    .expected =
                                        built_in(backends[i]) ? expected[i] : "not built in"};
        assert_true(refuses(&child));
    }
}

static void every_backend_that_was_tried_is_named(void **state)
{
    (void)state;
    static const enum context_backend backends[] = {CONTEXT_EGL, CONTEXT_OSMESA, CONTEXT_GLFW};
    static const char *const names[] = {"egl: ", "osmesa: ", "glfw: no display"};
    for (int i = 0; i < 3; i++) {
        const struct child child = {.variable = "MESA_GL_VERSION_OVERRIDE",
                                    .value = "3.2",
                                    .backend = CONTEXT_ANY,
                                    .expected = built_in(backends[i]) ? names[i] : ""};
        assert_true(refuses(&child));
    }
}

static void a_window_needs_a_display_and_glfw(void **state)
{
    (void)state;
    const struct child hidden = {.variable = "MESA_DEBUG",
                                 .value = "",
                                 .window = true,
                                 .expected = built_in(CONTEXT_GLFW) ? "no display: DISPLAY"
                                                                    : "not built in"};
    assert_true(refuses(&hidden));
    struct child other = {.variable = "MESA_DEBUG",
                          .value = "",
                          .backend = CONTEXT_EGL,
                          .window = true,
                          .expected = "egl: cannot show a window"};
    assert_true(refuses(&other));
    other.backend = CONTEXT_OSMESA;
    other.expected = "osmesa: cannot show a window";
    assert_true(refuses(&other));
}

// What every open context must be: 3.3 core, with every function of the table, able to draw.
static void assert_works(const struct context *context, const char *name)
{
    GLint major = 0, minor = 0, profile = 0;
    char text[256];
    const gl_function *functions = (const gl_function *)(const void *)&context->gl;
    for (size_t i = 0; i < sizeof context->gl / sizeof *functions; i++)
        assert_true(functions[i] != NULL);
    context->gl.GetIntegerv(GL_MAJOR_VERSION, &major);
    context->gl.GetIntegerv(GL_MINOR_VERSION, &minor);
    context->gl.GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    assert_true(10 * major + minor >= 33);
    assert_int_equal(profile, GL_CONTEXT_CORE_PROFILE_BIT);
    context_describe(context, text, sizeof text);
    assert_memory_equal(text, name, strlen(name));
    assert_non_null(strstr(text, ", OpenGL "));
    assert_null(strstr(text, "?"));
    assert_null(context->window);
}

// Clear a float target of our own to a colour and read it back.
static void assert_draws(const struct gl *gl, float value)
{
    GLuint framebuffer = 0, texture = 0;
    float pixel[4] = {0};
    gl->GenFramebuffers(1, &framebuffer);
    gl->GenTextures(1, &texture);
    gl->BindTexture(GL_TEXTURE_2D, texture);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 4, 4, 0, GL_RGBA, GL_FLOAT, NULL);
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    assert_int_equal(gl->CheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    gl->ClearColor(value, 0.0f, -value, 1.0f);
    gl->Clear(GL_COLOR_BUFFER_BIT);
    gl->ReadPixels(3, 3, 1, 1, GL_RGBA, GL_FLOAT, pixel);
    assert_true(pixel[0] == value && pixel[2] == -value);
    assert_int_equal(gl->GetError(), GL_NO_ERROR);
    gl->DeleteFramebuffers(1, &framebuffer);
    gl->DeleteTextures(1, &texture);
}

static void backends_follow_each_other(void **state)
{
    (void)state;
    static const enum context_backend order[] = {CONTEXT_EGL, CONTEXT_OSMESA, CONTEXT_EGL,
                                                 CONTEXT_OSMESA, CONTEXT_ANY};
    static const char *const names[] = {"egl (", "osmesa, ", "egl (", "osmesa, ", ""};
    int opened = 0;
    for (int i = 0; i < 5; i++) {
        struct context context;
        if (!built_in(order[i]))
            continue;
        assert_true(context_open_offscreen(&context, order[i]));
        assert_works(&context, names[i]);
        assert_draws(&context.gl, 1.5f + (float)i);
        context_close(&context);
        assert_null(context.driver);
        context_close(&context);
        opened++;
    }
    assert_true(opened > 0);
}

static gl_function find_all_but_one(const char *name)
{
    return strcmp(name, "glViewport") == 0 ? NULL : (gl_function)backends_follow_each_other;
}

static void a_missing_function_is_named(void **state)
{
    (void)state;
    char heard[512] = "";
    struct gl gl;
    FILE *file = system_open_scratch();
    int standard_error = dup(STDERR_FILENO);
    dup2(fileno(file), STDERR_FILENO);
    bool loaded = gl_load(&gl, find_all_but_one);
    dup2(standard_error, STDERR_FILENO);
    close(standard_error);
    rewind(file);
    assert_non_null(fgets(heard, sizeof heard, file));
    fclose(file);
    assert_false(loaded);
    assert_non_null(strstr(heard, "glViewport: the driver lacks this function"));
}

int main(void)
{
    // Those that start children come first: a child must not inherit a driver's threads half.
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_of_backends_are_known),
        cmocka_unit_test(an_old_driver_is_refused),
        cmocka_unit_test(every_backend_that_was_tried_is_named),
        cmocka_unit_test(a_window_needs_a_display_and_glfw),
        cmocka_unit_test(a_missing_function_is_named),
        cmocka_unit_test(backends_follow_each_other),
    };
    return cmocka_run_group_tests_name("context", tests, NULL, NULL);
}
