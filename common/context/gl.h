// gl.h - the OpenGL functions that this program uses, in one table that gl_load fills.
//
// All calls go through the table (gl->DrawArrays), never to a linked libGL, because libOSMesa
// exports the same names, and one process may use two backends in turn. The table contains only
// functions that OpenGL 3.3 core and OpenGL ES 3.0 share.
#ifndef GL_H
#define GL_H

#include <stdbool.h>

#include "context/opengl.h"

// The beginning of a shader's text, the format of the driver's version, and the version that is
// needed. A browser offers OpenGL ES, whose fragment shaders have no default precision for float
// and sampler3D, and whose default precision for sampler2D is too low for a table of numbers.
//   directives  preprocessor directives that must come first, each ending in a newline; may be ""
#ifdef __EMSCRIPTEN__
#define GL_IS_ES 1
#define GL_GLSL_WITH(directives)                                                                   \
    "#version 300 es\n" directives "precision highp float;\nprecision highp int;\n"                \
    "precision highp sampler2D;\nprecision highp sampler3D;\nprecision highp usampler2D;\n"
#define GL_VERSION_READ "OpenGL ES %d.%d"
enum { GL_NEEDED_MAJOR = 3, GL_NEEDED_MINOR = 0 };
#else
#define GL_IS_ES                 0
#define GL_GLSL_WITH(directives) "#version 330 core\n" directives
#define GL_VERSION_READ          "%d.%d"
enum { GL_NEEDED_MAJOR = 3, GL_NEEDED_MINOR = 3 };
#endif
#define GL_GLSL GL_GLSL_WITH("")

// clang-format off
// X(type, name, arguments): one line for each function.
#define GL_FUNCTIONS(X) \
    X(void, ActiveTexture, (GLenum)) \
    X(void, AttachShader, (GLuint, GLuint)) \
    X(void, BindBuffer, (GLenum, GLuint)) \
    X(void, BindFramebuffer, (GLenum, GLuint)) \
    X(void, BindTexture, (GLenum, GLuint)) \
    X(void, BindVertexArray, (GLuint)) \
    X(void, BlendColor, (GLfloat, GLfloat, GLfloat, GLfloat)) \
    X(void, BlendFunc, (GLenum, GLenum)) \
    X(void, BlitFramebuffer, \
      (GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLbitfield, GLenum)) \
    X(void, BufferData, (GLenum, GLsizeiptr, const void *, GLenum)) \
    X(GLenum, CheckFramebufferStatus, (GLenum)) \
    X(void, Clear, (GLbitfield)) \
    X(void, ClearColor, (GLfloat, GLfloat, GLfloat, GLfloat)) \
    X(void, CompileShader, (GLuint)) \
    X(GLuint, CreateProgram, (void)) \
    X(GLuint, CreateShader, (GLenum)) \
    X(void, DeleteBuffers, (GLsizei, const GLuint *)) \
    X(void, DeleteFramebuffers, (GLsizei, const GLuint *)) \
    X(void, DeleteProgram, (GLuint)) \
    X(void, DeleteShader, (GLuint)) \
    X(void, DeleteTextures, (GLsizei, const GLuint *)) \
    X(void, DeleteVertexArrays, (GLsizei, const GLuint *)) \
    X(void, Disable, (GLenum)) \
    X(void, DrawArrays, (GLenum, GLint, GLsizei)) \
    X(void, DrawArraysInstanced, (GLenum, GLint, GLsizei, GLsizei)) \
    X(void, Enable, (GLenum)) \
    X(void, EnableVertexAttribArray, (GLuint)) \
    X(void, Finish, (void)) \
    X(void, Flush, (void)) \
    X(void, FramebufferTexture2D, (GLenum, GLenum, GLenum, GLuint, GLint)) \
    X(void, GenBuffers, (GLsizei, GLuint *)) \
    X(void, GenFramebuffers, (GLsizei, GLuint *)) \
    X(void, GenTextures, (GLsizei, GLuint *)) \
    X(void, GenVertexArrays, (GLsizei, GLuint *)) \
    X(void, GenerateMipmap, (GLenum)) \
    X(GLenum, GetError, (void)) \
    X(void, GetIntegerv, (GLenum, GLint *)) \
    X(void, GetProgramInfoLog, (GLuint, GLsizei, GLsizei *, GLchar *)) \
    X(void, GetProgramiv, (GLuint, GLenum, GLint *)) \
    X(void, GetShaderInfoLog, (GLuint, GLsizei, GLsizei *, GLchar *)) \
    X(void, GetShaderiv, (GLuint, GLenum, GLint *)) \
    X(const GLubyte *, GetString, (GLenum)) \
    X(GLint, GetUniformLocation, (GLuint, const GLchar *)) \
    X(void, LinkProgram, (GLuint)) \
    X(void, PixelStorei, (GLenum, GLint)) \
    X(void, ReadPixels, (GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void *)) \
    X(void, Scissor, (GLint, GLint, GLsizei, GLsizei)) \
    X(void, ShaderSource, (GLuint, GLsizei, const GLchar *const*, const GLint *)) \
    X(void, TexImage2D, \
      (GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void *)) \
    X(void, TexImage3D, \
      (GLenum, GLint, GLint, GLsizei, GLsizei, GLsizei, GLint, GLenum, GLenum, const void *)) \
    X(void, TexParameteri, (GLenum, GLenum, GLint)) \
    X(void, TexSubImage3D, \
      (GLenum, GLint, GLint, GLint, GLint, GLsizei, GLsizei, GLsizei, GLenum, GLenum, \
       const void *)) \
    X(void, Uniform1f, (GLint, GLfloat)) \
    X(void, Uniform1i, (GLint, GLint)) \
    X(void, Uniform2f, (GLint, GLfloat, GLfloat)) \
    X(void, Uniform2fv, (GLint, GLsizei, const GLfloat *)) \
    X(void, Uniform3f, (GLint, GLfloat, GLfloat, GLfloat)) \
    X(void, Uniform3fv, (GLint, GLsizei, const GLfloat *)) \
    X(void, Uniform4f, (GLint, GLfloat, GLfloat, GLfloat, GLfloat)) \
    X(void, UseProgram, (GLuint)) \
    X(void, VertexAttribDivisor, (GLuint, GLuint)) \
    X(void, VertexAttribPointer, (GLuint, GLint, GLenum, GLboolean, GLsizei, const void *)) \
    X(void, Viewport, (GLint, GLint, GLsizei, GLsizei))

// The functions of timer queries, which OpenGL ES 3.0 lacks. The functions are looked up where they
// are used.
#define GL_TIMER_FUNCTIONS(X) \
    X(void, BeginQuery, (GLenum, GLuint)) \
    X(void, DeleteQueries, (GLsizei, const GLuint *)) \
    X(void, EndQuery, (GLenum)) \
    X(void, GenQueries, (GLsizei, GLuint *)) \
    X(void, GetQueryObjectui64v, (GLuint, GLenum, GLuint64 *))
// clang-format on

// A pointer to a function of any type, to be cast to the function's real type before a call.
typedef void (*gl_function)(void);

struct gl {
// A type and a list of parameters take no parentheses. NOLINTNEXTLINE(bugprone-macro-parentheses)
#define GL_MEMBER(type, name, arguments) type(*name) arguments;
    GL_FUNCTIONS(GL_MEMBER)
#undef GL_MEMBER
};

// Fill the table for the current context.
//   find  the backend's lookup, which takes a name such as "glDrawArrays" and returns NULL if the
//         driver lacks the function
// If a function is missing, reports the name of the first one and returns false.
bool gl_load(struct gl *gl, gl_function (*find)(const char *name));

#endif
