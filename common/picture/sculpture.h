// sculpture.h - a volume that the pointer changes: the strokes drawn on a picture, and the tool
// with which a chapter's program applies them.
//
// The strokes are inputs of a picture, like its time. Before it draws, a renderer applies the
// strokes that its texture does not contain yet. A picture is therefore a function of its options,
// both in a window and in a file.
#ifndef SCULPTURE_H
#define SCULPTURE_H

#include <stdbool.h>

#include "picture/texture.h"

// A line through points, drawn with one movement of the pointer.
struct stroke {
    double amount;      // the tool's size, such as a radius; if negative, the tool works in reverse
    double (*point)[3]; // in the volume's coordinates; owned
    int points;
};

struct strokes {
    struct stroke *item; // owned
    int count;
    int taken_back; // number of strokes taken back so far that had points
};

// The ray under the pointer, with which a tool aims.
struct sculpture_aim {
    double eye[3], point[3]; // where the ray starts, and a point on it, scene units
    double time;             // seconds
    const struct parameters *parameters;
};

// The tool of a chapter. Its functions keep no state between calls.
struct sculpture_tool {
    const char *texture; // the sampler3D whose volume the tool changes
    int size[3];         // size of the volume, texels
    const char *amount;  // the parameter with a new stroke's amount; at 0, the tool is off
    // Find the point at which a stroke begins or continues.
    //   volume  the volume as it was when the stroke began: four bytes for each texel, x fastest,
    //           then y upwards, then z
    //   point   receives the point, in the volume's coordinates
    // Returns false if the ray meets nothing to work on.
    bool (*aim)(const unsigned char *volume, const struct sculpture_aim *aim, double point[3]);
    // Apply a piece of a stroke.
    //   volume  the volume to change
    //   before  the volume as it was when the stroke began
    //   from    the previous point; for the first piece of a stroke, the same as to
    //   slices  receives the indices of the first changed slice and of the slice after the last
    //           changed one
    void (*work)(unsigned char *volume, const unsigned char *before, const double from[3],
                 const double to[3], double amount, int slices[2]);
};

// The volume of a renderer. It is closed if everything but its tool is zero.
struct sculpture {
    const struct sculpture_tool *tool; // NULL if the chapter has no tool
    // The volume as it is in the file, as it was before the last stroke, and as it is now; all are
    // NULL until there is a stroke. Owned.
    unsigned char *original, *before, *now;
    // The strokes that have been applied, and their taken_back at that time; the number of whole
    // strokes applied, and the number of points applied of the next stroke.
    const struct strokes *strokes;
    int taken_back, done, points;
};

// ---- Strokes ----

// Begin a stroke, or add a point to the last one. Amounts and coordinates are rounded to multiples
// of 0.0001, so that a stroke can be printed exactly.
void strokes_begin(struct strokes *strokes, double amount);
void strokes_add(struct strokes *strokes, const double point[3]);

// Take back the last count strokes, or all if there are fewer.
void strokes_take_back(struct strokes *strokes, int count);

// Read a stroke of the form AMOUNT,X,Y,Z,X,Y,Z,... Returns false without reporting an error if the
// text is not a stroke.
bool strokes_read(struct strokes *strokes, const char *text);

// Return a stroke as text that strokes_read can read. The caller frees the text.
char *stroke_text(const struct stroke *stroke);

void strokes_free(struct strokes *strokes);

// ---- The volume ----

// Apply the strokes that the texture does not contain yet.
//   textures, samplers, source  those of the shader; if the shader lacks the tool's texture,
//                               nothing is done
//   strokes                     NULL if there are none
// Returns false after reporting the error if the volume's file cannot be read again, or if the
// volume does not have the size that the tool needs.
bool sculpture_follow(struct sculpture *sculpture, const struct gl *gl,
                      const struct textures *textures, const struct samplers *samplers,
                      const struct shader_source *source, const struct strokes *strokes);

// Free the volumes, after the texture has been deleted.
void sculpture_forget(struct sculpture *sculpture);

#endif
