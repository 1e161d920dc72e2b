#include "lib/mirror.h"

#include <float.h>
#include <stddef.h>

double d3_angle(struct d3 a, struct d3 b)
{
    return atan2(d3_length(d3_cross(a, b)), d3_dot(a, b)) * 180.0 / MIRROR_PI;
}

// ---- Distances ----

double mirror_sphere(struct d3 p, double radius)
{
    return d3_length(p) - radius;
}

double mirror_plane(struct d3 p, struct d3 normal, double height)
{
    return d3_dot(p, normal) - height;
}

static double box_distance(double x, double y, double z)
{
    struct d3 out = d3(fmax(x, 0.0), fmax(y, 0.0), fmax(z, 0.0));
    return d3_length(out) + fmin(fmax(x, fmax(y, z)), 0.0);
}

double mirror_box(struct d3 p, struct d3 half_size)
{
    return box_distance(fabs(p.x) - half_size.x, fabs(p.y) - half_size.y, fabs(p.z) - half_size.z);
}

double mirror_box_frame(struct d3 p, struct d3 half_size, double beam)
{
    struct d3 o = d3(fabs(p.x) - half_size.x, fabs(p.y) - half_size.y, fabs(p.z) - half_size.z);
    struct d3 i = d3(fabs(o.x + beam) - beam, fabs(o.y + beam) - beam, fabs(o.z + beam) - beam);
    double x = box_distance(o.x, i.y, i.z);
    double y = box_distance(i.x, o.y, i.z);
    double z = box_distance(i.x, i.y, o.z);
    return fmin(x, fmin(y, z));
}

static double clamp(double x, double low, double high)
{
    return x < low ? low : (x > high ? high : x);
}

double brute_box(struct d3 p, struct d3 half_size)
{
    struct d3 nearest =
        d3(clamp(p.x, -half_size.x, half_size.x), clamp(p.y, -half_size.y, half_size.y),
           clamp(p.z, -half_size.z, half_size.z));
    double outside = d3_length(d3_sub(p, nearest));
    if (outside > 0.0)
        return outside;
    double x = half_size.x - fabs(p.x), y = half_size.y - fabs(p.y), z = half_size.z - fabs(p.z);
    return -fmin(x, fmin(y, z));
}

// The distance from a point inside the frame, folded into x, y, z >= 0, to the frame's surface.
//   inner  position of the beams' inner faces: half size - 2 beam
static double frame_depth(struct d3 p, struct d3 half_size, struct d3 inner)
{
    double x = fmax(p.x - inner.x, 0.0), y = fmax(p.y - inner.y, 0.0), z = fmax(p.z - inner.z, 0.0);
    double hole = fmin(hypot(x, y), fmin(hypot(y, z), hypot(z, x)));
    double face = fmin(half_size.x - p.x, fmin(half_size.y - p.y, half_size.z - p.z));
    return fmin(hole, face);
}

double brute_box_frame(struct d3 p, struct d3 half_size, double beam)
{
    double nearest = DBL_MAX;
    struct d3 middle = d3_sub(half_size, d3(beam, beam, beam));
    for (int k = 0; k < 12; k++) {
        double a = k & 1 ? 1.0 : -1.0, b = k & 2 ? 1.0 : -1.0;
        struct d3 centre = d3(0.0, a * middle.y, b * middle.z), half = d3(half_size.x, beam, beam);
        if (k >= 8) {
            centre = d3(a * middle.x, b * middle.y, 0.0);
            half = d3(beam, beam, half_size.z);
        } else if (k >= 4) {
            centre = d3(a * middle.x, 0.0, b * middle.z);
            half = d3(beam, half_size.y, beam);
        }
        nearest = fmin(nearest, brute_box(d3_sub(p, centre), half));
    }
    if (nearest > 0.0)
        return nearest;
    struct d3 folded = d3(fabs(p.x), fabs(p.y), fabs(p.z));
    return -frame_depth(folded, half_size, d3_sub(middle, d3(beam, beam, beam)));
}

double brute_two_balls(struct d3 p, double shift, double radius)
{
    double left = d3_length(d3_sub(p, d3(-shift, 0.0, 0.0)));
    double right = d3_length(d3_sub(p, d3(shift, 0.0, 0.0)));
    if (fmin(left, right) > radius)
        return fmin(left, right) - radius;
    // The surface consists of each sphere without the part inside the other ball, and of the circle
    // where the spheres meet.
    double around = hypot(p.y, p.z), circle = sqrt(radius * radius - shift * shift);
    double depth = hypot(p.x, around - circle);
    double left_x = -shift + radius * (p.x + shift) / left;
    double right_x = shift + radius * (p.x - shift) / right;
    if (left > 0.0 && left_x <= 0.0)
        depth = fmin(depth, fabs(radius - left));
    if (right > 0.0 && right_x >= 0.0)
        depth = fmin(depth, fabs(radius - right));
    return -depth;
}

// ---- Scenes ----

static double part_distance(const struct mirror_part *part, struct d3 p)
{
    struct d3 local = d3_sub(p, part->centre);
    switch (part->shape) {
    case MIRROR_SPHERE:
        return mirror_sphere(local, part->size);
    case MIRROR_PLANE:
        return mirror_plane(local, part->half, part->size);
    case MIRROR_BOX:
        return mirror_box(local, part->half);
    case MIRROR_FRAME:
        return mirror_box_frame(local, part->half, part->size);
    }
    return DBL_MAX;
}

double mirror_distance(const struct mirror_scene *scene, struct d3 p, int *nearest)
{
    double least = DBL_MAX;
    int ignored = 0;
    if (scene->function != NULL)
        return scene->function(p, nearest != NULL ? nearest : &ignored);
    for (int i = 0; i < scene->count; i++) {
        double distance = part_distance(&scene->part[i], p);
        if (distance < least) {
            least = distance;
            if (nearest != NULL)
                *nearest = i;
        }
    }
    return least;
}

struct d3 mirror_normal(const struct mirror_scene *scene, struct d3 p)
{
    const double h = 1e-6;
    const struct d3 x = {h, 0.0, 0.0}, y = {0.0, h, 0.0}, z = {0.0, 0.0, h};
    return d3_unit(d3(
        mirror_distance(scene, d3_add(p, x), NULL) - mirror_distance(scene, d3_sub(p, x), NULL),
        mirror_distance(scene, d3_add(p, y), NULL) - mirror_distance(scene, d3_sub(p, y), NULL),
        mirror_distance(scene, d3_add(p, z), NULL) - mirror_distance(scene, d3_sub(p, z), NULL)));
}

// ---- Rays ----

struct mirror_march mirror_march(const struct mirror_scene *scene, struct mirror_ray ray,
                                 double t_min, double t_max, double threshold, int max_steps)
{
    struct mirror_march march = {.t = t_min, .end = t_min < t_max ? MIRROR_NONE : MIRROR_PASSED};
    while (march.end == MIRROR_NONE) {
        double distance = mirror_distance(scene, mirror_at(ray, march.t), NULL);
        march.steps++;
        if (distance < threshold) {
            march.end = MIRROR_HIT;
        } else {
            march.t += distance;
            if (march.t >= t_max)
                march.end = MIRROR_PASSED;
            else if (march.steps >= max_steps)
                march.end = MIRROR_GAVE_UP;
        }
    }
    return march;
}

struct mirror_march mirror_reach(const struct mirror_scene *scene, struct mirror_ray ray,
                                 double t_min, double t_max)
{
    return mirror_march(scene, ray, t_min, t_max, 1e-10, 1000000);
}

static struct d3 direction_of(double pan, double tilt)
{
    return d3(sin(pan) * cos(tilt), sin(tilt), -cos(pan) * cos(tilt));
}

struct mirror_ray mirror_screen_ray(const struct camera *camera, double focal_length, double x,
                                    double y)
{
    double pan = (double)camera->pan * MIRROR_PI / 180.0;
    double tilt = (double)camera->tilt * MIRROR_PI / 180.0;
    struct d3 forward = direction_of(pan, tilt);
    struct d3 right = d3_unit(d3_cross(forward, d3(0.0, 1.0, 0.0)));
    struct d3 up = d3_cross(right, forward);
    struct d3 across = d3_add(d3_times(x, right), d3_times(y, up));
    struct d3 direction = d3_add(across, d3_times(focal_length, forward));
    return (struct mirror_ray){d3_of(camera->position), d3_unit(direction)};
}

bool mirror_ball_crossing(struct mirror_ray ray, double radius, double t[2])
{
    double middle = -d3_dot(ray.origin, ray.direction);
    struct d3 closest = mirror_at(ray, middle);
    double left = radius * radius - d3_dot(closest, closest);
    if (left < 0.0)
        return false;
    t[0] = middle - sqrt(left);
    t[1] = middle + sqrt(left);
    return true;
}

// Find where a ray crosses the plane of a face of the box. If that point is on the face, widen the
// interval t to include the point.
//   ray   origin, then direction
//   face  0 to 2: at low x, y, z; 3 to 5: at high x, y, z
static void cross_face(const double ray[6], const double low[3], const double high[3], int face,
                       double t[2])
{
    int axis = face % 3, a = (axis + 1) % 3, b = (axis + 2) % 3;
    double at = face < 3 ? low[axis] : high[axis];
    if (ray[3 + axis] == 0.0)
        return;
    double where = (at - ray[axis]) / ray[3 + axis];
    double on_a = ray[a] + where * ray[3 + a], on_b = ray[b] + where * ray[3 + b];
    if (where < 0.0 || on_a < low[a] || on_a > high[a] || on_b < low[b] || on_b > high[b])
        return;
    t[0] = fmin(t[0], where);
    t[1] = fmax(t[1], where);
}

bool brute_box_interval(struct mirror_ray ray, struct d3 low, struct d3 high, double t[2])
{
    const double line[6] = {ray.origin.x,    ray.origin.y,    ray.origin.z,
                            ray.direction.x, ray.direction.y, ray.direction.z};
    const double from[3] = {low.x, low.y, low.z}, to[3] = {high.x, high.y, high.z};
    t[0] = DBL_MAX;
    t[1] = -DBL_MAX;
    for (int face = 0; face < 6; face++)
        cross_face(line, from, to, face, t);
    if (t[0] > t[1])
        return false;
    struct d3 half = d3_times(0.5, d3_sub(high, low));
    if (brute_box(d3_sub(ray.origin, d3_times(0.5, d3_add(low, high))), half) <= 0.0)
        t[0] = 0.0;
    return true;
}

// ---- Light ----

double mirror_lambert(struct d3 normal, struct d3 to_light)
{
    return fmax(d3_dot(normal, to_light), 0.0);
}

double mirror_fall_off(double distance, double reference)
{
    return reference * reference / (distance * distance);
}

double mirror_clamp(double x)
{
    return clamp(x, 0.0, 1.0);
}

double mirror_encode(double light)
{
    double v = mirror_clamp(light);
    return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055;
}

double mirror_decode(double v)
{
    return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
}

double mirror_smoothstep(double low, double high, double x)
{
    double s = mirror_clamp((x - low) / (high - low));
    return s * s * (3.0 - 2.0 * s);
}

static struct d3 apply(const double m[3][3], struct d3 v)
{
    return d3(m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z,
              m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
              m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z);
}

double mirror_lightness(struct d3 colour, enum mirror_vision vision)
{
    static const double protan[3][3] = {{0.152286, 1.052583, -0.204868},
                                        {0.114503, 0.786281, 0.099216},
                                        {-0.003882, -0.048116, 1.051998}};
    static const double deutan[3][3] = {{0.367322, 0.860646, -0.227968},
                                        {0.280085, 0.672501, 0.047413},
                                        {-0.011820, 0.042940, 0.968881}};
    static const double cones[3][3] = {{0.4122214708, 0.5363325363, 0.0514459929},
                                       {0.2119034982, 0.6806995451, 0.1073969566},
                                       {0.0883024619, 0.2817188376, 0.6299787005}};
    struct d3 light = d3(mirror_decode(colour.x), mirror_decode(colour.y), mirror_decode(colour.z));
    if (vision != VISION_FULL)
        light = apply(vision == VISION_PROTAN ? protan : deutan, light);
    struct d3 seen = d3(mirror_clamp(light.x), mirror_clamp(light.y), mirror_clamp(light.z));
    struct d3 lms = apply(cones, seen);
    return 0.2104542553 * cbrt(lms.x) + 0.7936177850 * cbrt(lms.y) - 0.0040720468 * cbrt(lms.z);
}

bool mirror_ball_blocks(struct d3 direction, const void *data)
{
    const struct mirror_ball *ball = data;
    double along = d3_dot(ball->centre, direction);
    double square = d3_dot(ball->centre, ball->centre) - along * along;
    return along > 0.0 && square < ball->radius * ball->radius;
}
