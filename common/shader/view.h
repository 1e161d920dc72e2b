// view.h - the table of views: what main() of shaders/main.glsl shows. Each row is a name in C and
// in GLSL (VIEW_STEPS), which the prelude of a course shader defines; no other file writes its
// number.
#ifndef SHADER_VIEW_H
#define SHADER_VIEW_H

#include <stdbool.h>

// What the pixels of a view are.
enum view_kind {
    VIEW_OF_SCENE, // the colour of each pixel's ray
    VIEW_OF_TRACE, // what the march of each pixel's ray has recorded
    VIEW_OF_COUNT, // a number among these records, on a ramp with a legend
    VIEW_OF_RAY,   // the march of the selected ray alone
    VIEW_NUMBERS   // not to be looked at: read by the harness, and never chosen by a user
};

// The views that can be chosen, in the order of their keys: name in C and in GLSL, kind, key from 1
// to 9, and name for users.
#define SHADER_VIEWS(ROW)                                                                          \
    ROW(PICTURE, OF_SCENE, 1, "picture") /* the colour that rayColour returns */                   \
    ROW(NORMALS, OF_TRACE, 2, "normals") /* the first normal of the pixel's ray */                 \
    ROW(DEPTH, OF_TRACE, 3, "depth")     /* the distance at which the pixel's first march ended */ \
    ROW(STEPS, OF_COUNT, 4, "steps")     /* the total number of steps of the pixel's marches */    \
    ROW(SLICE, OF_RAY, 5, "slice")       /* the march of one ray, seen from the side */            \
    ROW(PLOT, OF_RAY, 6, "plot")         /* below it, a plot of the distance along that ray */     \
    ROW(EVALUATIONS, OF_COUNT, 7,                                                                  \
        "evaluations") /* of the scene, by the pixel's march, normal and shadow */

// The other programs of a course shader. Their names for users appear in messages.
#define SHADER_PROGRAMS(ROW)                                                                       \
    ROW(PROBE, NUMBERS, 0, "probe")             /* the steps of one ray, as numbers */             \
    ROW(COVER, NUMBERS, 0, "evaluation counts") /* of each pixel: the taken and the needed ones */ \
    ROW(COARSE, NUMBERS, 0, "coarse pass")  /* where the rays of a block of pixels may start */    \
    ROW(POSITIONS, NUMBERS, 0, "positions") /* of points, such as a ray's steps, in the picture */ \
    ROW(ROOM, NUMBERS, 0, "camera stop")    /* where a moving camera stops */                      \
    ROW(KEPT, NUMBERS, 0, "kept frame")     /* what a frame keeps for the next one */

enum shader_view {
#define VIEW_NAME(id, kind, key, name) VIEW_##id,
    SHADER_VIEWS(VIEW_NAME)
    // Only the first SHADER_VIEW_COUNT can be chosen.
    SHADER_VIEW_COUNT,
    VIEW_LAST_CHOSEN = SHADER_VIEW_COUNT - 1,
    SHADER_PROGRAMS(VIEW_NAME) SHADER_PROGRAM_COUNT
#undef VIEW_NAME
};

// Convert a view to its name ("steps"), and a name to its view. The latter returns false without
// reporting an error if no view that can be chosen has this name.
const char *shader_view_name(enum shader_view view);
bool shader_view_from_name(const char *name, enum shader_view *view);

// True for the views of one ray's march, whose pixels are not those of the picture.
bool shader_shows_ray(enum shader_view view);

// True for a view with a legend at the bottom left, which no panel may cover.
bool shader_has_legend(enum shader_view view);

// The lines that precede a course shader: a definition of each view's name; VIEW, which is one of
// these names; and VIEW_OF_TRACE, which is true if the view shows what each pixel's march has
// recorded. Returns memory that the caller frees.
char *shader_view_lines(enum shader_view view);

#endif
