// form.h - the three kinds of shader file: which one a text is, what must stand before it, and what
// it can show.
#ifndef FORM_H
#define FORM_H

#include <stdbool.h>

#include "shader/source.h"

// What main() shows; the value of VIEW in shaders/main.glsl.
enum shader_view {
    SHADER_PICTURE, // the colour of rayColour
    SHADER_NORMALS, // the first normal of the pixel's ray
    SHADER_DEPTH,   // where its first march ended
    SHADER_STEPS,   // the steps of all its marches
    SHADER_SLICE,   // the march of one ray, seen from the side
    SHADER_PLOT,    // and below it the distance along that ray
    SHADER_VIEW_COUNT,
    SHADER_PROBE = SHADER_VIEW_COUNT, // the steps of one ray, as numbers; not a view to choose
    SHADER_COUNT,                     // evaluations of the scene for each pixel; not a view either
    SHADER_COARSE,                    // where the rays of a block of pixels may start; nor is this
    SHADER_PLACES,                    // where a ray's steps are in the picture; nor is this
    SHADER_PROGRAM_COUNT
};

// Read a shader, tell its form and make it ready.
//   path, root  as shader_expand
// What the preprocessor leaves out does not count. Shadertoy's form mentions mainImage and defines
// no main; a whole file has a #version otherwise, or defines main and includes nothing; everything
// else is the course's form, also what --print-shader wrote of one. A #version that must not reach
// the driver is blanked: one of GLSL ES, one in Shadertoy's form.
// Returns false, reported with file and line: what shader_expand or form_check_inputs refuse;
// nothing but comments; an array of more than 65536 elements, where the number stands in it;
// another mainImage than Shadertoy's; a #version above what includes main.glsl. Free with
// shader_free.
bool shader_read(struct shader_source *source, const char *path, const char *root);

// As shader_read, with what is asked besides.
bool shader_read_asked(struct shader_source *source, const char *path, const char *root,
                       const struct shader_request *request);

// True for the views of one ray's march, in which a pixel of the picture is nowhere.
bool form_shows_ray(enum shader_view view);

// The name of a view ("steps"), and the view of a name (false for an unknown one, not reported).
const char *shader_view_name(enum shader_view view);
bool shader_view_from_name(const char *name, enum shader_view *view);

// True when the view can be shown; else reported with the reason: a whole file or one in
// Shadertoy's form has a main of its own, which fills in no trace.
bool shader_has_view(const struct shader_source *source, enum shader_view view);

// What stands before the text for the driver, its lines ended.
//   course      #version and VIEW
//   Shadertoy   #version, Shadertoy's inputs but those that the text declares itself and channels
//               without a picture, and a main
//               that calls mainImage and clamps what it gives; it stands in front, where no macro
//               of the text reaches it. Every name there begins with "harness", so that none
//               collides
//   whole       nothing, or #version 330 core in place of one of GLSL ES
// Returns memory that the caller frees.
char *form_prelude(const struct shader_source *source, enum shader_view view);

// The text after the prelude, line by line: in the course's form the source's own, otherwise what
// form_zero makes of it. Returns memory that the caller frees.
char *form_body(const struct shader_source *source);

// Say why a shader cannot run that asks for what Shadertoy has and this harness has not (films,
// buffers, sounds) or not without --channel, that has no main, or another mainImage than
// Shadertoy's.
//   log      of the driver, which did not compile the shader
//   linking  or not link it
// Returns false, nothing reported, when the log blames nothing of the kind.
bool form_refuses(const struct shader_source *source, const char *log, bool linking);

// Judge a shader that a driver has linked: form_check_linked. The course's form is accepted.
bool form_accepts(const struct shader_source *source);

#endif
