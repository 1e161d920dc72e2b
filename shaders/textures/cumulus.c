#include "cumulus.h"

#include "paint.h"

#include <math.h>
#include <stdbool.h>

// Kilometres: the radius of the Earth, and the distance at which a march ends.
static const double earth = 6371.0, farthest = 70.0;

// ---- Noise, in tables that repeat ----

enum { SIDE = 64, MAP = 512, MAP_CELLS = 12 };

static struct {
    bool drawn;
    float puffs[SIDE * SIDE * SIDE];
    float ground[MAP * MAP];
} table;

// Round heaps: one minus the square of the distance to the nearest random point. There is one
// random point in each cell.
static double heaps(const double p[3], int cells, uint32_t seed)
{
    int corner[3];
    double nearest = 1.0, rest[3];
    for (int k = 0; k < 3; k++) {
        corner[k] = (int)floor(p[k] * cells);
        rest[k] = p[k] * cells - corner[k];
    }
    for (int n = 0; n < 27; n++) {
        const int side[3] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
        int cell[3];
        for (int k = 0; k < 3; k++)
            cell[k] = (corner[k] + side[k] + cells) % cells;
        uint32_t chance = paint_hash(cell[0] + cells * cell[1], cell[2], seed);
        double square = 0.0;
        for (int k = 0; k < 3; k++) {
            double away = side[k] + (chance >> 10 * k & 1023U) / 1024.0 - rest[k];
            square += away * away;
        }
        nearest = fmin(nearest, square);
    }
    return 1.0 - nearest;
}

static void draw_tables(uint32_t seed)
{
    for (int i = 0; i < SIDE * SIDE * SIDE; i++) {
        const double p[3] = {(double)(i % SIDE) / SIDE, (double)(i / SIDE % SIDE) / SIDE,
                             (double)(i / SIDE / SIDE) / SIDE};
        table.puffs[i] =
            (float)(0.55 * heaps(p, 4, 1) + 0.3 * heaps(p, 8, 2) + 0.15 * heaps(p, 16, 3));
    }
    for (int i = 0; i < MAP * MAP; i++)
        table.ground[i] = (float)paint_octaves((double)(i % MAP) / MAP, (double)(i / MAP) / MAP,
                                               MAP_CELLS, MAP_CELLS, 4, seed);
    table.drawn = true;
}

static double mix(double a, double b, double share)
{
    return a + share * (b - a);
}

// The noise along the ground, which decides where columns form; x and y are in periods.
static double ground_at(double x, double y)
{
    double i = floor(x * MAP), j = floor(y * MAP), u = x * MAP - i, v = y * MAP - j;
    int left = (int)i & (MAP - 1), right = (left + 1) & (MAP - 1);
    const float *low = table.ground + MAP * ((int)j & (MAP - 1));
    const float *high = table.ground + MAP * (((int)j + 1) & (MAP - 1));
    return mix(mix(low[left], low[right], u), mix(high[left], high[right], u), v);
}

// The noise of the puffs, with a mean of about 0.6; x, y and z are in periods.
static double puffs_at(double x, double y, double z)
{
    double k = floor(z * SIDE), w = z * SIDE - k, slice[2];
    double i = floor(x * SIDE), j = floor(y * SIDE), u = x * SIDE - i, v = y * SIDE - j;
    int left = (int)i & (SIDE - 1), right = (left + 1) & (SIDE - 1);
    int low = SIDE * ((int)j & (SIDE - 1)), high = SIDE * (((int)j + 1) & (SIDE - 1));
    for (int n = 0; n < 2; n++) {
        const float *p = table.puffs + SIDE * SIDE * (((int)k + n) & (SIDE - 1));
        slice[n] =
            mix(mix(p[low + left], p[low + right], u), mix(p[high + left], p[high + right], u), v);
    }
    return mix(slice[0], slice[1], w);
}

// ---- The field ----

#define RAGGED 16.0 // how uneven the rim of an anvil is, kilometres
#define FIBRES 60.0 // period of the noise that shapes the rim, kilometres

// How far inside a tower a point is, as a share of the field's depth. The head consists of ice: it
// is thinner and smoother, and has a soft rim.
//   ice  is raised to the share of ice at this height, unless it is larger already
static double inside_tower(const struct cumulus *field, const struct tower *tower,
                           const double p[2], double altitude, double *ice)
{
    double rise = altitude / tower->top, spread = paint_step(0.7, 0.92, rise);
    double x = p[0] - tower->north - tower->drawn * spread, z = p[1] - tower->east;
    double radius = tower->width * (1.2 - 0.4 * rise) + (tower->anvil - tower->width) * spread;
    radius += RAGGED * spread * (ground_at(p[0] / FIBRES, p[1] / FIBRES) - 0.5);
    double aside = radius - sqrt(x * x + z * z);
    *ice = fmax(*ice, paint_step(0.6, 0.9, rise));
    return fmin(aside, 0.5 * (tower->top - altitude)) / field->depth;
}

// The distance of a point from the line between the eye and a tower, as a multiple of the tower's
// clearing; 1 if the tower has no clearing.
static double beside_the_way(const struct tower *tower, double x, double z)
{
    if (tower->clearing <= 0.0)
        return 1.0;
    double way = tower->north * tower->north + tower->east * tower->east;
    double along = fmin(fmax((x * tower->north + z * tower->east) / way, 0.0), 1.0);
    double north = x - along * tower->north, east = z - along * tower->east;
    return sqrt(north * north + east * east) / tower->clearing;
}

// How much a tuft adds to the noise along the ground.
static double raised_by(const struct tuft *tuft, double x, double z)
{
    double north = x - tuft->north, east = z - tuft->east, away = sqrt(north * north + east * east);
    return away < tuft->width ? 0.16 * (1.0 - paint_step(0.0, tuft->width, away)) : 0.0;
}

// Like inside_tower, but for the ordinary columns, which keep clear of the lines from the eye to
// the towers.
static double inside_column(const struct cumulus *field, double x, double z, double altitude)
{
    double period = MAP_CELLS * field->cell, height = (altitude - field->base) / field->depth;
    double ground = ground_at(x / period, z / period);
    for (int i = 0; i < TOWERS; i++)
        ground -= 0.5 * (1.0 - paint_step(0.6, 1.0, beside_the_way(field->tower + i, x, z)));
    for (int i = 0; i < TUFTS; i++)
        ground += raised_by(field->tuft + i, x, z);
    return height < 1.0 ? field->slope * (ground - field->threshold) - height : -1.0;
}

static double ceiling_of(const struct cumulus *field)
{
    double highest = field->base + field->depth;
    for (int i = 0; i < TOWERS; i++)
        highest = fmax(highest, field->tower[i].top);
    return highest;
}

// The optical depth per kilometre at a point; x and z along the ground, y up from the eye. The
// small puffs may be left out, because they are invisible inside a cloud.
static double thickness_at(const struct cumulus *field, double x, double y, double z,
                           bool small_too)
{
    double altitude = y + (x * x + z * z) / (2.0 * earth), ice = 0.0;
    if (altitude <= field->base || altitude >= ceiling_of(field))
        return 0.0;
    const double at[2] = {x, z};
    double inside = inside_column(field, x, z, altitude);
    for (int i = 0; i < TOWERS; i++)
        if (field->tower[i].width > 0.0)
            inside = fmax(inside, inside_tower(field, field->tower + i, at, altitude, &ice));
    if (inside < -0.4 * (field->puff + field->fray))
        return 0.0;
    double large = field->size, small = 0.23 * large;
    double rough = 1.0 - 0.8 * ice;
    inside += rough * field->puff * (puffs_at(x / large, altitude / large, z / large) - 0.62);
    if (small_too)
        inside += rough * field->fray * (puffs_at(x / small, altitude / small, z / small) - 0.6);
    double edge = fmin(fmax((9.0 - 6.5 * ice) * inside, 0.0), 1.0);
    double foot = fmin((altitude - field->base) / field->depth / 0.06, 1.0);
    return field->thickness * (1.0 - 0.8 * ice) * edge * foot;
}

// The share of light that passes through a cloud after being scattered many times, a model fitted
// by eye. The second term is the law of a thick layer without absorption,
// 1 / (1 + depth (1 - g) 3/4).
static double diffused(double depth)
{
    return 0.6 / (1.0 + 0.35 * depth + 0.05 * depth * depth) + 0.4 / (1.0 + 0.06 * depth);
}

static double light_from(const struct cumulus *field, const double p[3], double x, double y,
                         double z)
{
    double depth = 0.0, t = 0.0, step = 0.016 * field->size;
    for (int i = 0; i < 5; i++) {
        double middle = t + 0.5 * step;
        depth += step * thickness_at(field, p[0] + middle * x, p[1] + middle * y, p[2] + middle * z,
                                     i < 2);
        t += step;
        step *= 2.0;
    }
    return diffused(depth);
}

// ---- The panorama ----

// The cosine and sine of u turns, combined according to the bits of u from those of a half turn, a
// quarter turn, an eighth and so on. Each of these pairs is found with square roots from the pair
// before.
static void turn(double u, double *cosine, double *sine)
{
    double c = 1.0, s = 0.0, half_c = -1.0, half_s = 0.0, rest = 2.0 * (u - floor(u));
    for (int bit = 0; bit < 24; bit++) {
        if (rest >= 1.0) {
            double before = c;
            c = before * half_c - s * half_s;
            s = before * half_s + s * half_c;
            rest -= 1.0;
        }
        rest *= 2.0;
        half_s = bit == 0 ? 1.0 : sqrt(0.5 * (1.0 - half_c));
        half_c = bit == 0 ? 0.0 : sqrt(0.5 * (1.0 + half_c));
    }
    *cosine = c;
    *sine = s;
}

// The distance at which a ray from the ground has risen to a height; bend is the Earth's curvature
// along the ray.
static double reach(double climb, double bend, double height)
{
    return 2.0 * height / (climb + sqrt(climb * climb + 2.0 * bend * height));
}

// The clouds in one direction.
static void along_ray(const struct cumulus *field, double u, double v, double value[3])
{
    if (!table.drawn)
        draw_tables(field->seed);
    double east, north, level, climb;
    turn(u, &north, &east);
    turn(0.25 * v * v, &level, &climb);
    double t = reach(climb, level * level / earth, field->base);
    double end = fmin(reach(climb, level * level / earth, ceiling_of(field)), farthest);
    double seen = 1.0, above = 0.0, side = 0.0;
    int idle = 0;
    bool inside = false;
    while (t < end && seen > 0.02) {
        double fine = fmax(0.6 / field->thickness, 0.002 * t), stride = 5.0 * fine;
        const double p[3] = {t * level * north, t * climb, t * level * east};
        double x = fine * thickness_at(field, p[0], p[1], p[2], true);
        if (x > 0.0 && !inside) { // the stride was too long
            inside = true;
            t -= 0.8 * stride;
            continue;
        }
        x *= 1.0 - paint_step(0.5 * farthest, farthest, t);
        if (x > 0.0) {
            double left = seen / (1.0 + x + 0.5 * x * x + x * x * x / 6.0), lost = seen - left;
            above += lost * light_from(field, p, 0.0, 1.0, 0.0);
            side += lost * (light_from(field, p, -east, 0.0, north) -
                            light_from(field, p, east, 0.0, -north));
            seen = left;
        }
        idle = x > 0.0 ? 0 : idle + 1;
        inside = inside && idle < 6;
        t += inside ? fine : stride;
    }
    double whole = 0.98; // the loss of light at which a ray is abandoned
    value[0] = fmin((1.0 - seen) / whole, 1.0);
    value[1] = above / whole;
    value[2] = 0.5 + 0.5 * side / whole;
}

// ---- The texels of the panorama ----

static float texel[CUMULUS_HEIGHT][CUMULUS_WIDTH][3];

static void draw_texels(const struct cumulus *field)
{
    for (int y = 0; y < CUMULUS_HEIGHT; y++)
        for (int x = 0; x < CUMULUS_WIDTH; x++) {
            double value[3];
            along_ray(field, (x + 0.5) / CUMULUS_WIDTH, (y + 0.5) / CUMULUS_HEIGHT, value);
            for (int i = 0; i < 3; i++)
                texel[y][x][i] = (float)value[i];
        }
}

// About how many texels of a row are together as wide in the sky as one texel is high, and up to
// 1.8 times as many near the zenith. At the height h = pi / 2 v^2, a texel is pi v / CUMULUS_HEIGHT
// high and 2 pi cos(h) / CUMULUS_WIDTH wide.
static double texels_wide(int row)
{
    double v = (row + 0.5) / CUMULUS_HEIGHT, level, climb;
    turn(0.25 * v * v, &level, &climb);
    double wide = 0.5 * CUMULUS_WIDTH / CUMULUS_HEIGHT * v / level;
    return fmin(fmax(wide * (0.8 + v * v), 1.0), CUMULUS_WIDTH);
}

static void average_in_row(int row, int column, double share, double value[3])
{
    double wide = texels_wide(row), sum = 0.0, mean[3] = {0.0};
    int reach = (int)(0.5 * wide + 0.5);
    for (int i = -reach; i <= reach; i++) {
        double weight = fmin(0.5 * wide + 0.5 - (i < 0 ? -i : i), 1.0);
        const float *there = texel[row][(column + i + CUMULUS_WIDTH) % CUMULUS_WIDTH];
        for (int k = 0; k < 3; k++)
            mean[k] += weight * (double)there[k];
        sum += weight;
    }
    for (int k = 0; k < 3; k++)
        value[k] += share * mean[k] / sum;
}

void cumulus_at(const struct cumulus *field, double u, double v, double value[3])
{
    int row = (int)(v * CUMULUS_HEIGHT), column = (int)(u * CUMULUS_WIDTH);
    if (!table.drawn)
        draw_texels(field);
    value[0] = value[1] = value[2] = 0.0;
    for (int i = -1; i <= 1; i++) {
        int beside = row + i < 0 ? 0 : row + i < CUMULUS_HEIGHT ? row + i : CUMULUS_HEIGHT - 1;
        average_in_row(beside, column, i == 0 ? 0.5 : 0.25, value);
    }
}
