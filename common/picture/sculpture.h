// sculpture.h - a volume that the pointer changes: the strokes that were made over a picture, and
// the tool with which a chapter's program carries them out.
//
// The strokes are inputs of a picture, like its time. Before it draws, a renderer follows them: it
// carries out those that its texture does not have yet. So a picture is a function of its options,
// both in a window and in a file.
#ifndef SCULPTURE_H
#define SCULPTURE_H

#include <stdbool.h>

#include "picture/texture.h"

// A line through points, drawn with one movement of the pointer.
struct stroke {
    double amount;      // of the tool; a negative one does the opposite
    double (*point)[3]; // in the volume's own coordinates; owned
    int points;
};

struct strokes {
    struct stroke *item; // owned
    int count;
    int taken_back; // number of strokes taken back so far
};

// The ray at the pointer, with which a tool aims.
struct sculpture_aim {
    double eye[3], point[3]; // where the ray starts, and a point on it, scene units
    double time;             // seconds
    const struct parameters *parameters;
};

// The tool of a chapter. Its functions keep no state between calls.
struct sculpture_tool {
    const char *texture; // the sampler3D whose volume it changes
    int size[3];         // texels of the volume
    const char *amount;  // the parameter that is a new stroke's amount; 0 puts the tool away
    // Find the point of a stroke.
    //   volume  as it was when the stroke began: four bytes for each texel, x fastest, then y
    //           upwards, then z
    //   point   receives it, in the volume's own coordinates
    // Returns false if there is nothing to work on.
    bool (*aim)(const unsigned char *volume, const struct sculpture_aim *aim, double point[3]);
    // Carry out a piece of a stroke.
    //   volume  is changed
    //   before  as it was when the stroke began
    //   from    the previous point; for the first piece of a stroke, the same as to
    //   slices  receives the index of the first slice that has changed, and that after the last
    void (*work)(unsigned char *volume, const unsigned char *before, const double from[3],
                 const double to[3], double amount, int slices[2]);
};

// The volume of a renderer. It is closed if everything but its tool is zero.
struct sculpture {
    const struct sculpture_tool *tool; // NULL if there is none
    // The volume as in the file, before the last stroke, and now; NULL until there is a stroke.
    // Owned.
    unsigned char *original, *before, *now;
    const struct strokes *strokes; // the strokes carried out so far:
    int taken_back, done, points;  // their taken_back, whole strokes, and points of the next one
};

// ---- Strokes ----

// Begin a stroke, or add a point to the last one. Amounts and coordinates are rounded to 0.0001, so
// that a stroke can be printed exactly.
void strokes_begin(struct strokes *strokes, double amount);
void strokes_add(struct strokes *strokes, const double point[3]);

// Take back the last strokes, at most this many.
void strokes_take_back(struct strokes *strokes, int count);

// Read a stroke, AMOUNT,X,Y,Z,X,Y,Z,... Returns false without reporting an error if the
// text is not a stroke.
bool strokes_read(struct strokes *strokes, const char *text);

// The text that strokes_read reads; the caller frees it.
char *stroke_text(const struct stroke *stroke);

void strokes_free(struct strokes *strokes);

// ---- The volume ----

// Carry out the strokes that the texture does not have yet.
//   textures, samplers, source  of the shader, which may lack the tool's texture: then nothing is
//                               done
//   strokes                     NULL if there is none
// Returns false after reporting the error if the picture cannot be read again, or its size is not
// the one that the tool needs.
bool sculpture_follow(struct sculpture *sculpture, const struct gl *gl,
                      const struct textures *textures, const struct samplers *samplers,
                      const struct shader_source *source, const struct strokes *strokes);

// Free the volumes once the texture is gone.
void sculpture_forget(struct sculpture *sculpture);

#endif
