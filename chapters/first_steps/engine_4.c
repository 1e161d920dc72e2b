// An engine of your own, step 4: a camera (docs/engine.md). W, S, A, D, Space and C move it,
// and dragging the mouse turns it. To build the program without make:
//
// cc -o engine_4 chapters/first_steps/engine_4.c $(pkg-config --cflags --libs glfw3) -lm

#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define GLFW_INCLUDE_NONE // otherwise GLFW includes an old OpenGL header; the right one follows
#include <GLFW/glfw3.h>
#include <GL/glcorearb.h>

enum { WIDTH = 640, HEIGHT = 360, TEXT = 65536 }; // pixels; a shader has fewer than TEXT bytes

#define FOCAL      1.5f  // distance from the eye to the screen, in half screen heights
#define TILT_LIMIT 1.55f // radians, just below a right angle
#define SPEED      2.0   // scene units per second

// At pan 0 and tilt 0 the eye looks along -z. Pan turns it to the right, and tilt turns it upwards.
enum { RIGHT, UP, FORWARD }; // the rows of a basis
struct camera {
    float position[3]; // scene units; y is up
    float pan, tilt;   // radians
    float basis[3][3]; // computed from pan and tilt
    double pointer[2]; // position of the pointer in the last frame
};

// The vertex shader places corner 0, 1 or 2 of a triangle. The screen extends from -1 to 1.
// FragCoord has the same unit in both directions, half the height of the picture.
static const char vertex_text[] =
    "#version 330 core\n"
    "uniform vec2 size;  // of the picture, in pixels\n"
    "uniform float time; // seconds\n"
    "out vec2 FragCoord;\n"
    "out float Time;\n"
    "void main()\n"
    "{\n"
    "    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);\n"
    "    gl_Position = vec4(corner, 0.0, 1.0);\n"
    "    FragCoord = vec2(corner.x * size.x / size.y, corner.y);\n"
    "    Time = time;\n"
    "}\n";

// The OpenGL functions that this program calls: FUNCTIONS(X) expands to X(type, name) for each.
#define FUNCTIONS(X)                                                                               \
    X(PFNGLATTACHSHADERPROC, glAttachShader)                                                       \
    X(PFNGLBINDVERTEXARRAYPROC, glBindVertexArray)                                                 \
    X(PFNGLCOMPILESHADERPROC, glCompileShader)                                                     \
    X(PFNGLCREATEPROGRAMPROC, glCreateProgram)                                                     \
    X(PFNGLCREATESHADERPROC, glCreateShader)                                                       \
    X(PFNGLDELETEPROGRAMPROC, glDeleteProgram)                                                     \
    X(PFNGLDELETESHADERPROC, glDeleteShader)                                                       \
    X(PFNGLDRAWARRAYSPROC, glDrawArrays)                                                           \
    X(PFNGLGENVERTEXARRAYSPROC, glGenVertexArrays)                                                 \
    X(PFNGLGETPROGRAMINFOLOGPROC, glGetProgramInfoLog)                                             \
    X(PFNGLGETPROGRAMIVPROC, glGetProgramiv)                                                       \
    X(PFNGLGETSHADERINFOLOGPROC, glGetShaderInfoLog)                                               \
    X(PFNGLGETSHADERIVPROC, glGetShaderiv)                                                         \
    X(PFNGLGETUNIFORMLOCATIONPROC, glGetUniformLocation)                                           \
    X(PFNGLLINKPROGRAMPROC, glLinkProgram)                                                         \
    X(PFNGLSHADERSOURCEPROC, glShaderSource)                                                       \
    X(PFNGLUNIFORM1FPROC, glUniform1f)                                                             \
    X(PFNGLUNIFORM2FPROC, glUniform2f)                                                             \
    X(PFNGLUNIFORM3FVPROC, glUniform3fv)                                                           \
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

// Read a whole file as text. Returns false if it cannot be read or is too long.
static bool read_text(const char *path, char text[TEXT])
{
    FILE *file = fopen(path, "r");
    if (file == NULL)
        return fail(path, strerror(errno));
    size_t size = fread(text, 1, TEXT, file);
    int error = ferror(file) ? errno : 0; // a folder can be opened, but not read
    fclose(file);
    if (error != 0 || size == TEXT)
        return fail(path, error != 0 ? strerror(error) : "too long: a shader must be under 64 KiB");
    text[size] = '\0';
    return true;
}

// Find when the file was last saved, in seconds. Returns 0 if it is missing, as during a save.
static double saved_at(const char *path)
{
    struct stat about;
    if (stat(path, &about) != 0)
        return 0.0;
    return (double)about.st_mtim.tv_sec + 1e-9 * (double)about.st_mtim.tv_nsec;
}

// Report the first error in a driver's log. Drivers write line 13 as 0:13 or 0(13), before or after
// other words, and the message after the next colon and space. Always returns false.
static bool fail_at_line(const char *name, const char *log)
{
    const char *at = strpbrk(log, "0123456789");
    const char *message = at == NULL ? NULL : strstr(at, ": ");
    if (message == NULL || (at[1] != ':' && at[1] != '('))
        return fail(name, log);
    char what[1000];
    snprintf(what, sizeof what, "%s:%ld", name, strtol(at + 2, NULL, 10));
    return fail(what, message + 2);
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
    return right || fail_at_line(name, log);
}

// Make a program from the vertex shader above and a file. Returns 0 if that fails.
static GLuint make_program(const char *path)
{
    static char text[TEXT];
    if (!read_text(path, text))
        return 0;
    GLuint program = glCreateProgram();
    GLint right = add_shader(program, GL_VERTEX_SHADER, vertex_text, "vertex shader") &&
                  add_shader(program, GL_FRAGMENT_SHADER, text, path);
    if (right) {
        char log[1000] = "";
        glLinkProgram(program);
        glGetProgramiv(program, GL_LINK_STATUS, &right);
        glGetProgramInfoLog(program, sizeof log, NULL, log);
        if (!right)
            fail(path, log);
    }
    if (!right)
        glDeleteProgram(program);
    return right ? program : 0;
}

// Make a program from the file and use it if the file has been saved since the last call. Returns
// the old program if nothing changed or the file has an error, so that the last good picture stays.
static GLuint reload(GLuint program, const char *path, double *saved)
{
    double now = saved_at(path);
    if (now == *saved || (now == 0.0 && program != 0))
        return program;
    *saved = now;
    GLuint next = make_program(path);
    if (next == 0)
        return program;
    glDeleteProgram(program); // 0 is allowed
    glUseProgram(next);
    return next;
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

// Compute the camera's basis: three perpendicular vectors of length 1.
static void set_basis(struct camera *camera)
{
    float sp = sinf(camera->pan), cp = cosf(camera->pan);
    float st = sinf(camera->tilt), ct = cosf(camera->tilt);
    const float rows[3][3] = {{cp, 0.0f, sp}, {-sp * st, ct, cp * st}, {sp * ct, st, -cp * ct}};
    memcpy(camera->basis, rows, sizeof rows);
}

// Turn the camera by dragging and move it with the keys, at the same speed at any frame rate.
static void move_camera(struct camera *camera, GLFWwindow *window, double seconds)
{
    int height = 0;
    double before[] = {camera->pointer[0], camera->pointer[1]}, *now = camera->pointer;
    glfwGetCursorPos(window, &now[0], &now[1]);
    glfwGetWindowSize(window, NULL, &height);
    if (glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) {
        float angle = 2.0f / (FOCAL * fmaxf((float)height, 1.0f)); // radians per unit of motion
        camera->pan += angle * (float)(now[0] - before[0]);
        camera->tilt -= angle * (float)(now[1] - before[1]);
        camera->tilt = fmaxf(-TILT_LIMIT, fminf(TILT_LIMIT, camera->tilt));
    }
    set_basis(camera);
    static const int keys[3][2] = {{GLFW_KEY_A, GLFW_KEY_D}, // against and along each basis vector
                                   {GLFW_KEY_C, GLFW_KEY_SPACE},
                                   {GLFW_KEY_S, GLFW_KEY_W}};
    float way[3], length = 0.0f;
    for (int k = RIGHT; k <= FORWARD; k++) {
        way[k] = (float)(glfwGetKey(window, keys[k][1]) - glfwGetKey(window, keys[k][0]));
        length = hypotf(length, way[k]);
    }
    float step = length > 0.0f ? (float)(SPEED * seconds) / length : 0.0f; // no key, no step
    for (int k = RIGHT; k <= FORWARD; k++)
        for (int i = 0; i < 3; i++)
            camera->position[i] += step * way[k] * camera->basis[k][i];
}

// Draw one picture with the program that is in use.
static void draw(GLuint program, const struct camera *camera, int width, int height, double time)
{
    glViewport(0, 0, width, height);
    glUniform2f(glGetUniformLocation(program, "size"), (float)width, (float)height);
    glUniform1f(glGetUniformLocation(program, "time"), (float)time);
    glUniform1f(glGetUniformLocation(program, "focal"), FOCAL);
    glUniform3fv(glGetUniformLocation(program, "CamPos"), 1, camera->position);
    glUniform3fv(glGetUniformLocation(program, "Ex"), 1, camera->basis[RIGHT]);
    glUniform3fv(glGetUniformLocation(program, "Ey"), 1, camera->basis[UP]);
    glUniform3fv(glGetUniformLocation(program, "Ez"), 1, camera->basis[FORWARD]);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

// Draw again and again until the window is closed. Returns false if the first program is invalid.
static bool show(GLFWwindow *window, const char *path, struct camera *camera)
{
    double saved = -1.0, before = 0.0;
    GLuint program = 0;
    while (!glfwWindowShouldClose(window) && glfwGetKey(window, GLFW_KEY_BACKSPACE) != GLFW_PRESS) {
        program = reload(program, path, &saved);
        if (program == 0)
            return false;
        int width = 0, height = 0;
        glfwGetFramebufferSize(window, &width, &height);
        double now = glfwGetTime();
        move_camera(camera, window, now - before);
        draw(program, camera, width, height, now);
        before = now;
        glfwSwapBuffers(window);           // show the result
        glfwWaitEventsTimeout(1.0 / 60.0); // wait for input, for at most 1/60 s
    }
    return true;
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: engine_4 SHADER.frag\n");
        return 2;
    }
    struct camera camera = {.position = {0.0f, 1.3f, 3.2f}, .tilt = -0.2f};
    bool done = false;
    GLFWwindow *window = open_window();
    if (window != NULL && load_functions()) {
        GLuint corners = 0; // OpenGL requires this object even if the corners have no data
        glGenVertexArrays(1, &corners);
        glBindVertexArray(corners);
        done = show(window, argv[1], &camera);
    }
    glfwTerminate(); // also closes the window and frees its OpenGL objects
    return done ? EXIT_SUCCESS : EXIT_FAILURE;
}
