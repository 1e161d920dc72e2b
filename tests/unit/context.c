// context.c - tests common/context/context.c and its backends, but opens no window.
// tests/command/failures.sh tests what the programs do if a context cannot be opened.
#include "lib/test.h"

#include "context/context.h"
#include "lib/scratch.h"
#include "lib/system.h"

#ifdef HAVE_EGL
#include <EGL/egl.h>
#endif

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

TEST(names_of_backends_are_known)
{
    enum context_backend backend = CONTEXT_ANY;
    assert_true(context_backend_from_name("glfw", &backend) && backend == CONTEXT_GLFW);
    assert_true(context_backend_from_name("egl", &backend) && backend == CONTEXT_EGL);
    assert_true(context_backend_from_name("osmesa", &backend) && backend == CONTEXT_OSMESA);
    static const char *const unknown[] = {"", "EGL", "eglx", "eg", "any", "vulkan"};
    for (size_t i = 0; i < sizeof unknown / sizeof *unknown; i++)
        assert_false(context_backend_from_name(unknown[i], &backend));
    assert_int_equal(backend, CONTEXT_OSMESA);
}

// Check the properties of every context without a window: OpenGL 3.3 or later, the core profile,
// all functions of struct gl, and a complete description that begins with name.
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

// Clear a float target to a colour, and check the colour that is read back.
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

TEST(backends_follow_each_other)
{
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

#ifdef HAVE_EGL
TEST(a_closed_context_ends_egl)
{
    struct context context;
    assert_true(context_open_offscreen(&context, CONTEXT_EGL));
    EGLDisplay display = eglGetCurrentDisplay();
    assert_true(display != EGL_NO_DISPLAY && eglQueryString(display, EGL_VERSION) != NULL);
    context_close(&context);
    assert_true(eglGetCurrentDisplay() == EGL_NO_DISPLAY);
    assert_null(eglQueryString(display, EGL_VERSION));
    assert_int_equal(eglGetError(), EGL_NOT_INITIALIZED);
}
#endif

// The driver may keep files open after its first context, so the count after the first context is
// the reference.
TEST(a_closed_context_leaves_no_file_open)
{
    static const enum context_backend backends[] = {CONTEXT_EGL, CONTEXT_OSMESA};
    for (int i = 0; i < 2; i++) {
        int before = 0;
        for (int k = 0; k <= 50 && built_in(backends[i]); k++) {
            struct context context;
            assert_true(context_open_offscreen(&context, backends[i]));
            context_close(&context);
            before = k == 0 ? system_open_files() : before;
        }
        assert_true(!built_in(backends[i]) || system_open_files() == before);
    }
}

static gl_function find_all_but_one(const char *name)
{
    return strcmp(name, "glViewport") == 0 ? NULL : (gl_function)backends_follow_each_other;
}

TEST(a_missing_function_is_named)
{
    struct gl gl;
    capture_begin();
    assert_false(gl_load(&gl, find_all_but_one));
    assert_non_null(strstr(capture_end(), "glViewport: the driver lacks this function"));
}

TESTS(NULL, NULL)
