// A picture without a window: the triangle and the shader of window.c, drawn into memory and
// written as a file. EGL brings OpenGL where there is no display. Without make:
//
//   cc -o picture chapters/first_steps/picture.c $(pkg-config --cflags --libs egl)

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>

enum { WIDTH = 640, HEIGHT = 360 };

// Run for each corner, 0, 1 and 2: where is it? The picture reaches from -1 to 1.
static const char vertex_text[] =
    "#version 330 core\n"
    "void main()\n"
    "{\n"
    "    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);\n"
    "    gl_Position = vec4(corner, 0.0, 1.0);\n"
    "}\n";

// Run for each pixel: what is its colour?
static const char fragment_text[] = "#version 330 core\n"
                                    "uniform vec2 size; // of the picture, in pixels\n"
                                    "out vec4 colour;\n"
                                    "void main()\n"
                                    "{\n"
                                    "    vec2 place = (2.0 * gl_FragCoord.xy - size) / size.y;\n"
                                    "    colour = vec4(0.5 + 0.5 * place, 0.4, 1.0);\n"
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
    X(PFNGLPIXELSTOREIPROC, glPixelStorei)                                                         \
    X(PFNGLREADPIXELSPROC, glReadPixels)                                                           \
    X(PFNGLSHADERSOURCEPROC, glShaderSource)                                                       \
    X(PFNGLUNIFORM2FPROC, glUniform2f)                                                             \
    X(PFNGLUSEPROGRAMPROC, glUseProgram)

#define DECLARE(type, name) static type name;
FUNCTIONS(DECLARE)

// Ask the driver where they are. False when it lacks one.
static bool load_functions(void)
{
    const char *missing = NULL;
#define LOAD(type, name)                                                                           \
    name = (type)eglGetProcAddress(#name);                                                         \
    missing = (name) == NULL ? #name : missing;
    FUNCTIONS(LOAD)
    if (missing != NULL)
        fprintf(stderr, "picture: the driver has no %s\n", missing);
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
        fprintf(stderr, "picture: the shaders: %.*s\n", (int)strcspn(said, "\n"), said);
    return right ? program : 0;
}

// Open OpenGL 3.3 so that it draws into a piece of memory, a 'pbuffer', of the picture's size.
static bool open_context(EGLDisplay display)
{
    const EGLint kind[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_BUFFER_SIZE, 24, EGL_NONE};
    const EGLint size[] = {EGL_WIDTH, WIDTH, EGL_HEIGHT, HEIGHT, EGL_NONE};
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
    EGLConfig config = NULL;
    EGLint count = 0;
    if (!eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API) ||
        !eglChooseConfig(display, kind, &config, 1, &count) || count == 0)
        return false;
    EGLSurface memory = eglCreatePbufferSurface(display, config, size);
    EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
    return memory != EGL_NO_SURFACE && context != EGL_NO_CONTEXT &&
           eglMakeCurrent(display, memory, memory, context);
}

static unsigned char pixels[HEIGHT][WIDTH][3]; // red, green, blue; the lowest row first

static void draw(GLuint program)
{
    GLuint corners = 0; // OpenGL asks for such an object even where corners have no data
    glGenVertexArrays(1, &corners);
    glBindVertexArray(corners);
    glUseProgram(program);
    glUniform2f(glGetUniformLocation(program, "size"), WIDTH, HEIGHT);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glPixelStorei(GL_PACK_ALIGNMENT, 1); // rows without gaps
    glReadPixels(0, 0, WIDTH, HEIGHT, GL_RGB, GL_UNSIGNED_BYTE, pixels);
}

// PPM: one line of text, then three bytes a pixel, the highest row first.
static bool write_ppm(const char *path)
{
    FILE *file = fopen(path, "wb");
    bool written = file != NULL && fprintf(file, "P6 %d %d 255\n", WIDTH, HEIGHT) > 0;
    for (int y = HEIGHT - 1; written && y >= 0; y--)
        written = fwrite(pixels[y], sizeof pixels[y], 1, file) == 1;
    if (file != NULL && fclose(file) != 0) // only now a full disk may say so
        written = false;
    if (!written)
        perror(path);
    return written;
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: picture FILE.ppm\n");
        return 2;
    }
    setenv("EGL_LOG_LEVEL", "fatal", 0); // what fails is said once, below
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, NULL, NULL);
    if (!open_context(display) && !open_context(display = eglGetDisplay(EGL_DEFAULT_DISPLAY))) {
        fprintf(stderr, "picture: no OpenGL 3.3 (EGL says 0x%04X)\n", (unsigned)eglGetError());
        return EXIT_FAILURE;
    }
    GLuint program = load_functions() ? make_program() : 0;
    if (program != 0)
        draw(program);
    bool done = program != 0 && write_ppm(argv[1]);
    eglTerminate(display);
    return done ? EXIT_SUCCESS : EXIT_FAILURE;
}
