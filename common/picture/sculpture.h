// sculpture.h - a volume that the pointer changes: the strokes that were made over a picture, and
// the tool with which a chapter's program carries them out.
//
// The strokes are inputs of a picture, like its time. Before it draws, a renderer follows them: it
// carries out those that its texture does not have yet. So a picture is a function of its options,
// in a window as in a file.
#ifndef SCULPTURE_H
#define SCULPTURE_H

#include <stdbool.h>

#include "picture/texture.h"

// A line through points, drawn in one go.
struct stroke {
    double amount;      // of the tool; negative: the opposite
    double (*point)[3]; // in the volume's own coordinates; owned
    int points;
};

struct strokes {
    struct stroke *item; // owned
    int count;
    int taken_back; // how many were, so far
};

// What the pointer is on, for a tool to aim at.
struct sculpture_aim {
    double eye[3], point[3]; // where the ray starts, and a point on it, scene units
    double time;             // seconds
    const struct parameters *parameters;
};

// The tool of a chapter. Its functions keep no state between two calls.
struct sculpture_tool {
    const char *texture; // the sampler3D whose volume it changes
    int size[3];         // texels of the volume
    const char *amount;  // the parameter that is a new stroke's amount; 0: the tool is put away
    // Find the point of a stroke.
    //   volume  as it was when the stroke began: four bytes for each texel, x fastest, then y
    //           upwards, then z
    //   point   receives it, in the volume's own coordinates
    // Returns false if there is nothing to work on.
    bool (*aim)(const unsigned char *volume, const struct sculpture_aim *aim, double point[3]);
    // Carry out a piece of a stroke.
    //   volume  is changed
    //   before  as it was when the stroke began
    //   from    the point before; for the first piece of a stroke, the same as to
    //   slices  receives the first slice that has changed, and the one after the last
    void (*work)(unsigned char *volume, const unsigned char *before, const double from[3],
                 const double to[3], double amount, int slices[2]);
};

// The volume of a renderer. One of zeros, but for its tool, is closed.
struct sculpture {
    const struct sculpture_tool *tool; // NULL: none
    // As the file has it, before the last stroke, and now; NULL until there is a stroke. Owned.
    unsigned char *original, *before, *now;
    const struct strokes *strokes; // that were carried out so far:
    int taken_back, done, points;  // whole strokes, and points of the next one
};

// ---- Strokes ----

// Begin a stroke, or add a point to the last one. Coordinates are rounded to 0.0001, so that a
// printed stroke is the same.
void strokes_begin(struct strokes *strokes, double amount);
void strokes_add(struct strokes *strokes, const double point[3]);

// Take back the last strokes, at most this many.
void strokes_take_back(struct strokes *strokes, int count);

// Read a stroke, AMOUNT,X,Y,Z,X,Y,Z,... Returns false, not reported: it is not one.
bool strokes_read(struct strokes *strokes, const char *text);

// The text that strokes_read reads; the caller frees it.
char *stroke_text(const struct stroke *stroke);

void strokes_free(struct strokes *strokes);

// ---- The volume ----

// Carry out what the texture does not have yet.
//   textures, samplers, source  of the shader, which may lack the tool's texture: then nothing is
//                               done
//   strokes                     NULL: none
// Returns false, reported: the picture cannot be read again, or has another size than the tool
// needs.
bool sculpture_follow(struct sculpture *sculpture, const struct gl *gl,
                      const struct textures *textures, const struct samplers *samplers,
                      const struct shader_source *source, const struct strokes *strokes);

// Free the volumes, when the texture is gone.
void sculpture_forget(struct sculpture *sculpture);

#endif
