// mirror.h - the shaders' mathematics in double precision: the truth against which the tests check
// the GPU, and brute-force methods that share no formula with the shaders or with this truth.
#ifndef TESTS_MIRROR_H
#define TESTS_MIRROR_H

#include <math.h>
#include <stdbool.h>

#include "camera.h"

#define MIRROR_PI 3.14159265358979323846

static inline double degrees(double angle)
{
    return angle * 180.0 / MIRROR_PI;
}

static inline double radians(double angle)
{
    return angle * MIRROR_PI / 180.0;
}

// Half the distance from 1 to the next float: the largest relative error of one rounding.
#define MIRROR_FLOAT_ROUNDING 5.9604644775390625e-8

struct d3 {
    double x, y, z;
};

static inline struct d3 d3(double x, double y, double z)
{
    return (struct d3){x, y, z};
}

static inline struct d3 d3_of(const float v[3])
{
    return d3((double)v[0], (double)v[1], (double)v[2]);
}

static inline struct d3 d3_add(struct d3 a, struct d3 b)
{
    return d3(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline struct d3 d3_sub(struct d3 a, struct d3 b)
{
    return d3(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline struct d3 d3_times(double k, struct d3 a)
{
    return d3(k * a.x, k * a.y, k * a.z);
}

static inline struct d3 d3_product(struct d3 a, struct d3 b)
{
    return d3(a.x * b.x, a.y * b.y, a.z * b.z);
}

static inline double d3_dot(struct d3 a, struct d3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline struct d3 d3_cross(struct d3 a, struct d3 b)
{
    return d3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static inline double d3_length(struct d3 a)
{
    return sqrt(d3_dot(a, a));
}

static inline struct d3 d3_unit(struct d3 a)
{
    return d3_times(1.0 / d3_length(a), a);
}

// The angle between two vectors in degrees, accurate for small angles, where acos is not.
double d3_angle(struct d3 a, struct d3 b);

// ---- shaders/primitives.glsl ----

double mirror_sphere(struct d3 p, double radius);
double mirror_plane(struct d3 p, struct d3 normal, double height);
double mirror_box(struct d3 p, struct d3 half_size);
double mirror_box_frame(struct d3 p, struct d3 half_size, double beam);

// The distance to a box, found with another method: it is measured to the closest point of the
// surface, from outside and inside.
double brute_box(struct d3 p, struct d3 half_size);
// The same for a frame. Outside, it is the distance to the closest of the twelve beams. Inside, it
// is the true depth: the distance to the closest point outside the frame, which is beyond an outer
// face or has at least two coordinates that are further in than the beams.
double brute_box_frame(struct d3 p, struct d3 half_size, double beam);
// The same for the union of two balls of equal radius with centres (-shift, 0, 0) and
// (shift, 0, 0), where shift < radius.
double brute_two_balls(struct d3 p, double shift, double radius);

// ---- scenes ----

enum mirror_shape { MIRROR_SPHERE, MIRROR_PLANE, MIRROR_BOX, MIRROR_FRAME };

// One solid of a scene.
struct mirror_part {
    const char *name;
    enum mirror_shape shape;
    struct d3 centre;
    struct d3 half; // box, frame: half sizes; plane: the normal
    double size;    // sphere: radius; frame: half thickness of a beam; plane: height
};

// A scene: a union of solids, or any function that bounds the distance from below.
struct mirror_scene {
    const struct mirror_part *part;
    int count;
    // Returns the distance at p, and replaces the parts; NULL if the scene has parts. nearest
    // receives an index whose meaning the function defines.
    double (*function)(struct d3 p, int *nearest);
};

// A ball that may hide a lamp or a part of the sky.
struct mirror_ball {
    struct d3 centre; // relative to the viewpoint, scene units
    double radius;    // scene units, > 0
};

// True if a ray from the viewpoint in this direction meets the ball.
//   direction  a unit vector
//   data       a struct mirror_ball
bool mirror_ball_blocks(struct d3 direction, const void *data);

// The distance to a scene.
//   nearest  receives the index of the nearest part; may be NULL
double mirror_distance(const struct mirror_scene *scene, struct d3 p, int *nearest);

// The unit normal: the direction of the gradient of mirror_distance, from central differences in
// double precision.
struct d3 mirror_normal(const struct mirror_scene *scene, struct d3 p);

// ---- rays ----

struct mirror_ray {
    struct d3 origin, direction;
};

static inline struct d3 mirror_at(struct mirror_ray ray, double t)
{
    return d3_add(ray.origin, d3_times(t, ray.direction));
}

// Why a march ended, as in shaders/scene.glsl.
enum mirror_end { MIRROR_NONE, MIRROR_HIT, MIRROR_PASSED, MIRROR_GAVE_UP };

struct mirror_march {
    double t;
    int steps; // evaluations of the distance
    enum mirror_end end;
};

// The march of shaders/march.glsl in double precision.
struct mirror_march mirror_march(const struct mirror_scene *scene, struct mirror_ray ray,
                                 double t_min, double t_max, double threshold, int max_steps);

// March to the limit of double precision: to the point where the ray meets the surface, or past
// t_max.
struct mirror_march mirror_reach(const struct mirror_scene *scene, struct mirror_ray ray,
                                 double t_min, double t_max);

// The ray through a position on the screen, using the formulas of common/camera.h and
// shaders/camera.glsl.
struct mirror_ray mirror_screen_ray(const struct camera *camera, double focal_length, double x,
                                    double y);

// Convert a position in the picture, in pixels, to the screen's coordinates: y runs from -1 to 1.
static inline double mirror_screen_x(double x, int width, int height)
{
    return (2.0 * x - width) / height;
}

static inline double mirror_screen_y(double y, int height)
{
    return (2.0 * y - height) / height;
}

// Find where the line of a ray crosses a ball around the origin: t[0] <= t[1], and either may be
// negative. Returns false if the line misses the ball.
bool mirror_ball_crossing(struct mirror_ray ray, double radius, double t[2]);

// Find where a ray enters and leaves a box, from its crossings with the six faces; t[0] is 0 if the
// ray starts inside. Returns false if there is no crossing at t >= 0.
bool brute_box_interval(struct mirror_ray ray, struct d3 low, struct d3 high, double t[2]);

// ---- shaders/lighting.glsl ----

double mirror_lambert(struct d3 normal, struct d3 to_light);
double mirror_fall_off(double distance, double reference);
double mirror_encode(double light); // one channel of encodeSRGB
double mirror_decode(double v);     // the inverse of mirror_encode
double mirror_smoothstep(double low, double high, double x);
double mirror_clamp(double x);

// ---- colour vision ----

enum mirror_vision { VISION_FULL, VISION_PROTAN, VISION_DEUTAN };

// The OKLab lightness L of a colour, which is encoded as the screen expects it, as seen by an eye
// with all kinds of cones, without L cones (protan) or without M cones (deutan).
// Sources: B. Ottosson, 'A perceptual color space for image processing' (2020); G. M. Machado, M.
// M. Oliveira, L. A. F. Fernandes, 'A physiologically-based model for simulation of color vision
// deficiency', IEEE TVCG 15 (2009), severity 1.
double mirror_lightness(struct d3 colour, enum mirror_vision vision);

// ---- the chapters ----

// The viewpoint and the time of one pixel.
struct mirror_eye {
    struct camera camera;
    double time; // seconds
    double x, y; // position on the screen
};

// What is seen in one pixel, in double precision.
struct mirror_sample {
    struct d3 colour; // as the screen expects it, in [0, 1]
    const char *what; // the name of the visible part, or "sky"
    bool faces;       // the surface faces the warm lamp
    bool shadowed;    // the surface faces the warm lamp, but an object is in between
};

// What a pixel of chapter 03 shows, to the limit of double precision.
struct mirror_sample mirror_stage(const struct mirror_eye *eye);

// The scene of chapters 02 and 03.
extern const struct mirror_scene mirror_scene_02;
#define MIRROR_FOCAL_LENGTH 2.0
#define MIRROR_FAR          40.0

// Read the starting camera of a chapter from chapters/STEM.c below root. Returns false if there is
// no such file, or no camera in it.
bool mirror_camera(const char *root, const char *stem, struct camera *camera);

#endif
