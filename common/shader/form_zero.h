// form_zero.h - variables that an author left without a value.
#ifndef FORM_ZERO_H
#define FORM_ZERO_H

#include "shader/source.h"

// The source's text in which every variable that is declared without a value begins at 0, as a
// browser has it: "float d, t = 1.0;" becomes "float d=float(0), t = 1.0;". Arrays and structures
// get their 0 too, where their parts can be counted and are at most a hundred or so. What an #if
// divides stays as it is, and what a macro may say: its type, its name, its size. An output gets
// its 0 where main begins, before its branches; not one that is declared behind main or inside an
// #if, nor where a macro or another function has the name main too. The colour of mainImage, an
// out, becomes an inout, which begins with what is handed to it. What GLSL defines stays as it was:
// only what it leaves undefined becomes 0.
//
// And some words in other words: in Shadertoy's form gl_FragCoord, for the renderer draws in parts
// and samples, and the shader must see one picture; a whole file loses smooth, flat, noperspective
// and centroid, which drivers want to find in the vertex shader too, and which change nothing on a
// triangle that covers the screen. Every precision is the high one: a browser's driver links no
// input that the vertex shader has in another, and the desktop has one only. Lines keep their
// numbers. Returns memory that the caller frees.
char *form_zero(const struct shader_source *source);

#endif
