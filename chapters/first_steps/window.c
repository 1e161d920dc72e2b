// A window, one triangle, one fragment shader: the whole way from main to a pixel, with nothing of
// common/. GLFW opens the window, OpenGL draws in it, Backspace ends. Without make:
//
//   cc -o window chapters/first_steps/window.c $(pkg-config --cflags --libs glfw3)

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define GLFW_INCLUDE_NONE // GLFW's idea of OpenGL is an old one: the right header follows
#include <GLFW/glfw3.h>
#include <GL/glcorearb.h>

// Run for each corner, 0, 1 and 2: where is it? The screen reaches from -1 to 1.
static const char vertex_text[] =
    "#version 330 core\n"
    "void main()\n"
    "{\n"
    "    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);\n"
    "    gl_Position = vec4(corner, 0.0, 1.0);\n"
    "}\n";

// Run for each pixel: what is its colour?
static const char fragment_text[] =
    "#version 330 core\n"
    "uniform vec2 size;  // of the picture, in pixels\n"
    "uniform float time; // seconds\n"
    "out vec4 colour;\n"
    "void main()\n"
    "{\n"
    "    vec2 place = (2.0 * gl_FragCoord.xy - size) / size.y;\n"
    "    colour = vec4(0.5 + 0.5 * place, 0.4 + 0.4 * sin(time), 1.0);\n"
    "}\n";

// The functions of OpenGL that this program calls: FUNCTIONS(X) becomes X(type, name) for each.
#define FUNCTIONS(X)                                                                               \
    X(PFNGLATTACHSHADERPROC, glAttachShader)                                                       \
    X(PFNGLBINDVERTEXARRAYPROC, glBindVertexArray)                                                 \
    X(PFNGLCOMPILESHADERPROC, glCompileShader)                                                     \
    X(PFNGLCREATEPROGRAMPROC, glCreateProgram)                                                     \
    X(PFNGLCREATESHADERPROC, glCreateShader)                                                       \
    X(PFNGLDRAWARRAYSPROC, glDrawArrays)                                                           \
    X(PFNGLGENVERTEXARRAYSPROC, glGenVertexArrays)                                                 \
    X(PFNGLGETPROGRAMIVPROC, glGetProgramiv)                                                       \
    X(PFNGLGETSHADERINFOLOGPROC, glGetShaderInfoLog)                                               \
    X(PFNGLGETSHADERIVPROC, glGetShaderiv)                                                         \
    X(PFNGLGETUNIFORMLOCATIONPROC, glGetUniformLocation)                                           \
    X(PFNGLLINKPROGRAMPROC, glLinkProgram)                                                         \
    X(PFNGLSHADERSOURCEPROC, glShaderSource)                                                       \
    X(PFNGLUNIFORM1FPROC, glUniform1f)                                                             \
    X(PFNGLUNIFORM2FPROC, glUniform2f)                                                             \
    X(PFNGLUSEPROGRAMPROC, glUseProgram)                                                           \
    X(PFNGLVIEWPORTPROC, glViewport)

#define DECLARE(type, name) static type name;
FUNCTIONS(DECLARE)

// Ask the driver where they are. False when it lacks one.
static bool load_functions(void)
{
    const char *missing = NULL;
#define LOAD(type, name)                                                                           \
    name = (type)glfwGetProcAddress(#name);                                                        \
    missing = (name) == NULL ? #name : missing;
    FUNCTIONS(LOAD)
    if (missing != NULL)
        fprintf(stderr, "window: the driver has no %s\n", missing);
    return missing == NULL;
}

// Let the driver compile both shaders and join them. 0 when it finds an error.
static GLuint make_program(void)
{
    const char *const text[] = {vertex_text, fragment_text};
    const GLenum kind[] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER};
    char said[1000] = "they do not fit together";
    GLint right = 0;
    GLuint program = glCreateProgram();
    for (int i = 0; i < 2; i++) {
        GLuint shader = glCreateShader(kind[i]);
        glShaderSource(shader, 1, &text[i], NULL);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glGetShaderiv(shader, GL_COMPILE_STATUS, &right);
        if (!right)
            glGetShaderInfoLog(shader, sizeof said, NULL, said);
    }
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &right);
    if (!right)
        fprintf(stderr, "window: the shaders: %.*s\n", (int)strcspn(said, "\n"), said);
    return right ? program : 0;
}

// Draw the triangle again and again, until the window is to close.
static void draw(GLFWwindow *window, GLuint program)
{
    GLuint corners = 0; // OpenGL asks for such an object even where corners have no data
    glGenVertexArrays(1, &corners);
    glBindVertexArray(corners);
    glUseProgram(program);
    while (!glfwWindowShouldClose(window) && glfwGetKey(window, GLFW_KEY_BACKSPACE) != GLFW_PRESS) {
        int width = 0, height = 0;
        glfwGetFramebufferSize(window, &width, &height);
        glViewport(0, 0, width, height);
        glUniform2f(glGetUniformLocation(program, "size"), (float)width, (float)height);
        glUniform1f(glGetUniformLocation(program, "time"), (float)glfwGetTime());
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glfwSwapBuffers(window);           // show what was drawn
        glfwWaitEventsTimeout(1.0 / 60.0); // keys, mouse, the button that closes
    }
}

static void on_error(int code, const char *text)
{
    fprintf(stderr, "window: %s (0x%08X)\n", text, (unsigned)code);
}

int main(void)
{
    glfwSetErrorCallback(on_error);
    if (!glfwInit())
        return EXIT_FAILURE;
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    GLuint program = 0;
    GLFWwindow *window = glfwCreateWindow(640, 360, "One triangle", NULL, NULL);
    if (window != NULL) {
        glfwMakeContextCurrent(window);
        program = load_functions() ? make_program() : 0;
        if (program != 0)
            draw(window, program);
    }
    glfwTerminate(); // closes the window too
    return program != 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
