#include "support_courtyard.h"

#include <stddef.h>

#include "support_cell.h"
#include "support_noise.h"

#define SIDE  4.75
#define TOP   3.1
#define FRONT (-3.6)
#define BACK  (-6.2)
#define TILE  0.27
#define FAR   40.0

static const struct d3 low = {-4.80, -0.01, -6.35}, high = {4.80, 4.75, 1.50};
static const struct d3 well_foot = {-2.15, 0.0, 0.30}, jar_foot = {2.90, 0.0, -2.85};

// ---- Distances ----

// A figure in the plane with a right angle at 0: the quarter x < 0, y < 0.
static double quarter(double x, double y)
{
    return x > 0.0 && y > 0.0 ? hypot(x, y) : fmax(x, y);
}

static double rectangle(double x, double y, double a, double b)
{
    return quarter(fabs(x) - a, fabs(y) - b);
}

static double arcade(struct d3 p)
{
    double cell = fmin(fmax(floor(p.x / 1.9 + 0.5), -2.0), 2.0), x = p.x - 1.9 * cell;
    double opening = hypot(x, fmax(p.y - 2.05, 0.0)) - 0.72, across = fabs(p.z + 4.0) - 0.22;
    double ledge = fmax(fabs(p.y - 2.02) - 0.06, across - 0.06);
    return fmin(quarter(fmax(p.y - 3.6, -opening), across), quarter(0.66 - fabs(x), ledge));
}

static double steps(struct d3 p)
{
    double r = hypot(p.x, p.z - FRONT), nearest = quarter(p.z - FRONT, p.y - 0.6);
    for (int i = 0; i < 3; i++)
        nearest = fmin(nearest, quarter(r - 2.16 + 0.36 * i, p.y - 0.15 * (i + 1)));
    return nearest;
}

static double rear(struct d3 p)
{
    return quarter(p.z - BACK, p.y - 4.4);
}

static double roof(struct d3 p)
{
    double s = 0.3411745, c = 0.94, z = p.z + 3.3, y = p.y - 3.46;
    double down = -c * z + s * y, over = s * z + c * y; // along the slope, and across it
    double tile = hypot(p.x - TILE * floor(p.x / TILE + 0.5), over - 0.02) - 0.1;
    return quarter(-down, fmax(fmin(tile, over - 0.05), -over - 0.03));
}

static double well(struct d3 p)
{
    struct d3 q = d3_sub(p, well_foot);
    double r = fabs(hypot(q.x, q.z) - 0.62), bow = hypot(q.x, fmax(q.y - 1.65, 0.0)) - 0.62;
    double ring = fmin(quarter(r - 0.1, q.y - 0.74), quarter(r - 0.17, fabs(q.y - 0.75) - 0.06));
    return fmin(ring, rectangle(bow, q.z, 0.024, 0.024));
}

static double jar(struct d3 p)
{
    double r = hypot(fabs(p.x) - jar_foot.x, p.z - jar_foot.z), y = p.y;
    double belly = hypot(r, y - fmin(fmax(y, 0.52), 0.68)) - 0.43;
    double neck = fmin(quarter(r - 0.21, y - 1.16), quarter(r - 0.27, fabs(y - 1.16) - 0.045));
    return fmin(fmin(belly, quarter(r - 0.24, y - 0.3)), neck);
}

static double tree(struct d3 p)
{
    return fmin(d3_length(d3_sub(p, d3(3.50, 0.68, -0.5))) - 0.68,
                d3_length(d3_sub(p, d3(2.70, 0.36, 1.05))) - 0.36);
}

enum { THINGS = 7 };
static const char *const names[THINGS] = {"arcade", "steps", "rear", "roof", "well", "jar", "tree"};

double courtyard_distance(struct d3 p, const char **what)
{
    // The masonry is one thing to the shader: what is inside of one part of it is inside of all.
    const double all[THINGS] = {arcade(p), steps(p), rear(p), roof(p), well(p), jar(p), tree(p)};
    int nearest = 0;
    for (int i = 1; i < THINGS; i++)
        nearest = all[i] < all[nearest] ? i : nearest;
    if (what != NULL)
        *what = names[nearest];
    return all[nearest];
}

double courtyard_trough(struct d3 p)
{
    return fmin(p.y, quarter(SIDE - fabs(p.x), p.y - TOP));
}

// ---- Colours ----

static double coverage(double inside, double width)
{
    return mirror_clamp(inside / (width + 0.001) + 0.5);
}

// A joint of 0.018 in each flag.
static double joint(double x, double width)
{
    double share = coverage(0.009 - fabs(x - floor(x) - 0.5), width);
    return share + mirror_smoothstep(0.4, 1.0, width) * (0.018 - share);
}

static struct d3 paving(struct d3 p, struct d3 direction, double radius)
{
    double x = p.x / 0.95, z = p.z / 0.95, width = 2.0 * radius / 0.95, row = floor(z + 0.5);
    x += 0.5 * (row - 2.0 * floor(row / 2.0));
    double a = joint(x, width * (1.0 + fabs(direction.x / direction.y)));
    double b = joint(z, width * (1.0 + fabs(direction.z / direction.y)));
    double tone = cell_hash((int)floor(x + 0.5), (int)row, 3);
    return d3_times((0.88 + 0.2 * tone) * (1.0 - 0.4 * fmax(a, b)), d3(0.57, 0.53, 0.47));
}

static struct d3 masonry(struct d3 p, double grain)
{
    bool side = fabs(p.x) > SIDE - 0.02, behind = p.z < BACK + 0.02;
    if (behind && fabs(p.x) < 0.6 && p.y < 2.3)
        return d3(0.10, 0.22, 0.21);
    if (p.y < 0.62 && !side && !behind)
        return d3_times(0.92 + 0.12 * grain, d3(0.58, 0.55, 0.50));
    if (side && (p.y < 0.8 || p.y > TOP - 0.12))
        return d3_times(0.92 + 0.16 * grain, d3(0.56, 0.34, 0.23));
    return d3_times(0.93 + 0.07 * grain, d3(0.82, 0.79, 0.74));
}

static struct d3 colour_of(struct d3 p, double radius)
{
    bool leaf = tree(p) < radius;
    struct d3 scaled = leaf ? d3_times(20.0, p) : d3(1.7 * p.x, 2.6 * p.y, 1.7 * p.z);
    double grain = noise_value(scaled).value;
    double tone = cell_hash((int)floor(p.x / TILE + 0.5), (int)floor(2.4 * p.z), 1);
    if (leaf)
        return d3_times(0.6 + 0.8 * grain, d3(0.12, 0.20, 0.07));
    double stone = fmin(fmin(fmin(arcade(p), steps(p)), rear(p)), courtyard_trough(p));
    double nearest = fmin(fmin(stone, roof(p)), fmin(jar(p), well(p)));
    if (nearest == stone)
        return masonry(p, grain);
    if (nearest == roof(p))
        return d3_times(0.7 + 0.5 * tone, d3(0.60, 0.26, 0.14));
    if (nearest == jar(p))
        return d3_times(0.95 + 0.2 * grain, d3(0.60, 0.26, 0.14));
    return p.y > 0.83 ? d3(0.05, 0.055, 0.06) : d3_times(0.85 + 0.2 * grain, d3(0.58, 0.55, 0.50));
}

// ---- Rays ----

static struct d3 normal_at(struct d3 p, double h)
{
    double g[3];
    for (int k = 0; k < 3; k++) {
        struct d3 step = d3(k == 0 ? h : 0.0, k == 1 ? h : 0.0, k == 2 ? h : 0.0);
        g[k] =
            courtyard_distance(d3_add(p, step), NULL) - courtyard_distance(d3_sub(p, step), NULL);
    }
    return d3_unit(d3(g[0], g[1], g[2]));
}

// Where a ray meets floor or side wall; FAR where it meets neither.
static double trough_met(struct mirror_ray ray)
{
    double x = ray.direction.x, ground = FAR;
    double wall = ((x > 0.0 ? SIDE : -SIDE) - ray.origin.x) / x;
    if (ray.direction.y < 0.0)
        ground = -ray.origin.y / ray.direction.y;
    if (wall < ground && ray.origin.y + wall * ray.direction.y > TOP)
        return FAR;
    return fmin(fmin(wall, ground), FAR);
}

struct courtyard_place courtyard_place(struct mirror_ray ray, double threshold, double spread,
                                       int max_steps)
{
    struct courtyard_place place = {.what = "sky"};
    double trough = trough_met(ray), interval[2], t = 0.0;
    bool found = false;
    if (brute_box_interval(ray, low, high, interval)) {
        t = interval[0];
        for (int step = 0; step < max_steps && t < fmin(interval[1], trough) && !found; step++) {
            double h = courtyard_distance(mirror_at(ray, t), NULL);
            found = h < threshold + spread * t;
            t += found ? 0.0 : h;
        }
    }
    t = found ? t : trough;
    place.open = !found && t >= FAR;
    place.p = mirror_at(ray, t);
    place.radius = threshold + spread * t;
    if (place.open)
        return place;
    bool ground = place.p.y < SIDE - fabs(place.p.x);
    if (found) {
        courtyard_distance(place.p, &place.what);
        place.normal = normal_at(place.p, place.radius);
        place.colour = colour_of(place.p, place.radius);
    } else if (ground) {
        place.what = "paving";
        place.normal = d3(0.0, 1.0, 0.0);
        place.colour = paving(place.p, ray.direction, place.radius);
    } else {
        place.what = "side";
        place.normal = d3(place.p.x > 0.0 ? -1.0 : 1.0, 0.0, 0.0);
        place.colour = colour_of(place.p, place.radius);
    }
    return place;
}
