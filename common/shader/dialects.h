// dialects.h - what the folder dialects/ does with files that were written for other tools. Nothing
// else in shader/ knows those tools. A program that has to run only the course's own shaders
// defines an empty struct instead, and links without the folder.
#ifndef SHADER_DIALECTS_H
#define SHADER_DIALECTS_H

#include "camera.h"
#include "context/gl.h"
#include "shader/parameter.h"
#include "shader/source.h"

// Each function may be NULL.
struct dialects {
    // If the first file contains a shader's text and more, fill part with its texts, in order,
    // which the caller frees. If it is of another format, as its name or its text shows, clear done
    // after reporting the format in one line. Returns false for any other file.
    //   text  NULL if the file contains no text
    bool (*unpack)(struct shader_source *source, const char *text, char *part[2], bool *done);

    // Obey a directive that only another tool understands, such as #iUniform.
    //   at       the line of the directive
    //   word     the directive's name, which ends after length bytes; its values follow
    //   instead  receives a line that replaces the directive, which the caller frees, or NULL if
    //   the
    //            directive becomes a comment
    //   done     receives false after the report of an error
    // Returns false for any other directive.
    bool (*obey)(struct shader_source *source, struct shader_line at, const char *word,
                 size_t length, char **instead, bool *done);

    // Determine the dialect of an expanded text and, unless it is the course's, translate the text
    // for the driver: set the source's prelude, body and inputs. Returns false after reporting the
    // error.
    bool (*take)(struct shader_source *source);

    // Report in the author's terms why a shader cannot run, if the driver's log does not help: for
    // example, the shader needs something that is not supported, has no main, or is not a fragment
    // shader.
    //   log  the driver's log
    // Returns false without reporting an error if no such cause is found.
    bool (*explain)(const struct shader_source *source, const char *log);

    // A text that a driver has refused, with a decimal point after integers in expressions with
    // floats, which only desktop GLSL converts. The caller frees it.
    char *(*with_floats)(const char *text);

    // Check a shader that a driver has linked. For each uniform or block that is read but never
    // set, and for each sampler without a picture, print a warning of one line; the first warning
    // is kept in the source. Returns false after reporting the error if a whole shader has no
    // output, or gives it no value.
    bool (*accept)(struct shader_source *source, const struct gl *gl, GLuint program);

    // Write a shader as one file, in Shadertoy's dialect or for a page that calls its mainImage.
    //   parameters    of the source; on Shadertoy, their current values become constants
    //   camera        becomes constants too, because Shadertoy has no camera
    //   focal_length  the value of the input for the focal length in dialects other than the
    //   course's
    //   page          for a page: only for a course shader, whose parameters and textures remain
    //                 uniforms, with the comments that describe them; the page provides the digits
    //                 of shaders/signs.glsl
    // A course file loses the parts that only the views and the probe need, and its main becomes
    // mainImage. In a file in another dialect, the output, the parameters and the inputs that
    // Shadertoy lacks become variables, which a new mainImage sets and reads; a file that needs
    // none of this gets no new mainImage. Returns memory that the caller frees, or NULL after
    // reporting the error.
    char *(*export_file)(struct shader_source *source, const struct parameters *parameters,
                         const struct camera *camera, float focal_length, bool page);
};

// Defined in common/dialects/dialects.c.
extern const struct dialects dialects;

#endif
