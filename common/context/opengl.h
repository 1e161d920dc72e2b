// opengl.h - the types and constants of OpenGL 3.3 that this program uses. A Mac has no
// <GL/glcorearb.h>, and on Windows that header includes <windows.h>, whose macros clash with our
// names. tests/course/house.sh compares these types and constants with Khronos' header.
//
// Names and values are those of the Khronos registry,
// https://github.com/KhronosGroup/OpenGL-Registry (Copyright 2013-2020 The Khronos Group Inc.,
// SPDX-License-Identifier: MIT).
#ifndef OPENGL_H
#define OPENGL_H

#include <stddef.h>
#include <stdint.h>

// clang-format off
typedef unsigned int GLenum;
typedef unsigned int GLbitfield;
typedef unsigned int GLuint;
typedef int GLint;
typedef int GLsizei;
typedef unsigned char GLboolean;
typedef uint8_t GLubyte;
typedef char GLchar;
typedef float GLfloat;
typedef ptrdiff_t GLsizeiptr;
typedef uint64_t GLuint64;

#define GL_ARRAY_BUFFER             0x8892
#define GL_BGRA                     0x80E1
#define GL_BLEND                    0x0BE2
#define GL_CLAMP_TO_EDGE            0x812F
#define GL_COLOR_ATTACHMENT0        0x8CE0
#define GL_COLOR_BUFFER_BIT         0x00004000
#define GL_COMPILE_STATUS           0x8B81
#define GL_COMPLETION_STATUS_KHR    0x91B1
#define GL_CONSTANT_COLOR           0x8001
#define GL_CONTEXT_CORE_PROFILE_BIT 0x00000001
#define GL_CONTEXT_PROFILE_MASK     0x9126
#define GL_DRAW_FRAMEBUFFER         0x8CA9
#define GL_DRAW_FRAMEBUFFER_BINDING 0x8CA6
#define GL_EXTENSIONS               0x1F03
#define GL_FALSE                    0
#define GL_FLOAT                    0x1406
#define GL_FRAGMENT_SHADER          0x8B30
#define GL_FRAMEBUFFER              0x8D40
#define GL_FRAMEBUFFER_COMPLETE     0x8CD5
#define GL_FRAMEBUFFER_UNSUPPORTED  0x8CDD
#define GL_INFO_LOG_LENGTH          0x8B84
#define GL_LINEAR                   0x2601
#define GL_LINEAR_MIPMAP_LINEAR     0x2703
#define GL_LINK_STATUS              0x8B82
#define GL_MAJOR_VERSION            0x821B
#define GL_MAX_3D_TEXTURE_SIZE      0x8073
#define GL_MAX_TEXTURE_IMAGE_UNITS  0x8872
#define GL_MAX_TEXTURE_SIZE         0x0D33
#define GL_MINOR_VERSION            0x821C
#define GL_NEAREST                  0x2600
#define GL_NO_ERROR                 0
#define GL_ONE                      1
#define GL_ONE_MINUS_SRC_ALPHA      0x0303
#define GL_PACK_ALIGNMENT           0x0D05
#define GL_QUERY_RESULT             0x8866
#define GL_R8                       0x8229
#define GL_READ_FRAMEBUFFER         0x8CA8
#define GL_READ_FRAMEBUFFER_BINDING 0x8CAA
#define GL_RED                      0x1903
#define GL_RENDERER                 0x1F01
#define GL_REPEAT                   0x2901
#define GL_RGBA                     0x1908
#define GL_RGBA16F                  0x881A
#define GL_RGBA32F                  0x8814
#define GL_RGBA32UI                 0x8D70
#define GL_RGBA8                    0x8058
#define GL_RGBA_INTEGER             0x8D99
#define GL_SCISSOR_TEST             0x0C11
#define GL_SRGB8_ALPHA8             0x8C43
#define GL_STREAM_DRAW              0x88E0
#define GL_TEXTURE0                 0x84C0
#define GL_TEXTURE1                 0x84C1
#define GL_TEXTURE_2D               0x0DE1
#define GL_TEXTURE_3D               0x806F
#define GL_TEXTURE_CUBE_MAP         0x8513
#define GL_TEXTURE_MAG_FILTER       0x2800
#define GL_TEXTURE_MIN_FILTER       0x2801
#define GL_TEXTURE_WRAP_R           0x8072
#define GL_TEXTURE_WRAP_S           0x2802
#define GL_TEXTURE_WRAP_T           0x2803
#define GL_TIME_ELAPSED             0x88BF
#define GL_TRIANGLES                0x0004
#define GL_TRIANGLE_STRIP           0x0005
#define GL_TRUE                     1
#define GL_UNPACK_ALIGNMENT         0x0CF5
#define GL_UNSIGNED_BYTE            0x1401
#define GL_UNSIGNED_INT             0x1405
#define GL_VERSION                  0x1F02
#define GL_VERTEX_SHADER            0x8B31
#define GL_ZERO                     0
// clang-format on

#endif
