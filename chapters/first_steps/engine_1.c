// An engine of your own, step 1: a window and a triangle (docs/engine.md). GLFW opens the window,
// OpenGL draws in it, and Backspace closes the window. To build the program without make:
//
// cc -o engine_1 chapters/first_steps/engine_1.c $(pkg-config --cflags --libs glfw3)

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define GLFW_INCLUDE_NONE // otherwise GLFW includes an old OpenGL header; the right one follows
#include <GLFW/glfw3.h>
#include <GL/glcorearb.h>

enum { WIDTH = 640, HEIGHT = 360 };

// The vertex shader places corner 0, 1 or 2 of a triangle. The screen extends from -1 to 1.
static const char vertex_text[] =
    "#version 330 core\n"
    "out vec2 FragCoord;\n"
    "void main()\n"
    "{\n"
    "    FragCoord = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);\n"
    "    gl_Position = vec4(FragCoord, 0.0, 1.0);\n"
    "}\n";

// The fragment shader computes the colour of each pixel.
static const char fragment_text[] = "#version 330 core\n"
                                    "in vec2 FragCoord;\n"
                                    "out vec4 FragColor;\n"
                                    "void main()\n"
                                    "{\n"
                                    "    FragColor = vec4(0.5 + 0.5 * FragCoord, 0.4, 1.0);\n"
                                    "}\n";

// The OpenGL functions that this program calls: FUNCTIONS(X) expands to X(type, name) for each.
#define FUNCTIONS(X)                                                                               \
    X(PFNGLATTACHSHADERPROC, glAttachShader)                                                       \
    X(PFNGLBINDVERTEXARRAYPROC, glBindVertexArray)                                                 \
    X(PFNGLCOMPILESHADERPROC, glCompileShader)                                                     \
    X(PFNGLCREATEPROGRAMPROC, glCreateProgram)                                                     \
    X(PFNGLCREATESHADERPROC, glCreateShader)                                                       \
    X(PFNGLDELETESHADERPROC, glDeleteShader)                                                       \
    X(PFNGLDRAWARRAYSPROC, glDrawArrays)                                                           \
    X(PFNGLGENVERTEXARRAYSPROC, glGenVertexArrays)                                                 \
    X(PFNGLGETPROGRAMINFOLOGPROC, glGetProgramInfoLog)                                             \
    X(PFNGLGETPROGRAMIVPROC, glGetProgramiv)                                                       \
    X(PFNGLGETSHADERINFOLOGPROC, glGetShaderInfoLog)                                               \
    X(PFNGLGETSHADERIVPROC, glGetShaderiv)                                                         \
    X(PFNGLLINKPROGRAMPROC, glLinkProgram)                                                         \
    X(PFNGLSHADERSOURCEPROC, glShaderSource)                                                       \
    X(PFNGLUSEPROGRAMPROC, glUseProgram)                                                           \
    X(PFNGLVIEWPORTPROC, glViewport)

#define DECLARE(type, name) static type name;
FUNCTIONS(DECLARE)

// Report a failure in one line: what failed, and why. Always returns false.
static bool fail(const char *what, const char *why)
{
    fprintf(stderr, "engine: %s: %.*s\n", what, (int)strcspn(why, "\n"), why);
    return false;
}

// Get the addresses of the functions from the driver. Returns false if the driver lacks one.
static bool load_functions(void)
{
    const char *missing = NULL;
#define LOAD(type, name)                                                                           \
    name = (type)glfwGetProcAddress(#name);                                                        \
    missing = (name) == NULL ? #name : missing;
    FUNCTIONS(LOAD)
    return missing == NULL || fail(missing, "the driver lacks this function: update the driver");
}

// Compile a shader and attach it to the program. Returns false if the shader has an error.
static bool add_shader(GLuint program, GLenum kind, const char *text, const char *name)
{
    GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &text, NULL);
    glCompileShader(shader);
    GLint right = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &right);
    char log[1000] = "";
    if (!right)
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
    glAttachShader(program, shader);
    glDeleteShader(shader); // takes effect once the program no longer needs the shader
    return right || fail(name, log);
}

// Make a program from both shaders. Returns 0 if that fails.
static GLuint make_program(void)
{
    GLuint program = glCreateProgram();
    GLint right = add_shader(program, GL_VERTEX_SHADER, vertex_text, "vertex shader") &&
                  add_shader(program, GL_FRAGMENT_SHADER, fragment_text, "fragment shader");
    if (right) {
        char log[1000] = "";
        glLinkProgram(program);
        glGetProgramiv(program, GL_LINK_STATUS, &right);
        glGetProgramInfoLog(program, sizeof log, NULL, log);
        if (!right)
            fail("the shaders do not fit together", log);
    }
    return right ? program : 0;
}

// Open a window with an OpenGL 3.3 context. Returns NULL if that fails.
static GLFWwindow *open_window(void)
{
    GLFWwindow *window = NULL;
    if (glfwInit()) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        window = glfwCreateWindow(WIDTH, HEIGHT, "Engine", NULL, NULL);
    }
    const char *why = "unknown reason";
    if (window == NULL && glfwGetError(&why) != GLFW_NO_ERROR)
        fail("no window with OpenGL 3.3", why);
    if (window != NULL) {
        glfwMakeContextCurrent(window);
        glfwSetInputMode(window, GLFW_STICKY_KEYS, GLFW_TRUE); // a press counts, however short
    }
    return window;
}

// Draw again and again until the window is closed.
static void show(GLFWwindow *window, GLuint program)
{
    glUseProgram(program);
    while (!glfwWindowShouldClose(window) && glfwGetKey(window, GLFW_KEY_BACKSPACE) != GLFW_PRESS) {
        int width = 0, height = 0;
        glfwGetFramebufferSize(window, &width, &height);
        glViewport(0, 0, width, height);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glfwSwapBuffers(window);           // show the result
        glfwWaitEventsTimeout(1.0 / 60.0); // wait for input, for at most 1/60 s
    }
}

int main(void)
{
    bool done = false;
    GLFWwindow *window = open_window();
    if (window != NULL && load_functions()) {
        GLuint corners = 0; // OpenGL requires this object even if the corners have no data
        glGenVertexArrays(1, &corners);
        glBindVertexArray(corners);
        GLuint program = make_program();
        if (program != 0)
            show(window, program);
        done = program != 0;
    }
    glfwTerminate(); // also closes the window and frees its OpenGL objects
    return done ? EXIT_SUCCESS : EXIT_FAILURE;
}
