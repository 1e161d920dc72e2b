#include "lib/air.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#include "textures/air.h"
#include "lib/mirror.h"

enum { NODES = 6, VIEW_PIECES = 20, SUN_PIECES = 14 };

// Gauss-Legendre quadrature with six points on [0, 1].
static const double node[NODES] = {0.033765242898423986, 0.16939530676686774, 0.38069040695840155,
                                   0.61930959304159845,  0.83060469323313226, 0.96623475710157601};
static const double weight[NODES] = {0.085662246189585172, 0.18038078652406930,
                                     0.23395696728634552,  0.23395696728634552,
                                     0.18038078652406930,  0.085662246189585172};

static const double earth = 6371.0;

// Columns of air, dust and ozone, as multiples of the vertical columns; or their densities, as
// multiples of the vertical columns per km.
struct column {
    double of[3];
};

static struct column density(double height)
{
    double air = exp(-fmin(height, 9.0) / 9.6 - fmax(height - 9.0, 0.0) / 6.7);
    double column = 9.6 * (1.0 - exp(-9.0 / 9.6)) + 6.7 * exp(-9.0 / 9.6);
    return (struct column){
        {air / column, pow(air, 8.0) / 1.2, fmax(1.0 - fabs(height - 25.0) / 15.0, 0.0) / 15.0}};
}

static double height_of(double lowest, double along)
{
    return sqrt(lowest * lowest + along * along) - earth;
}

// Add the columns along a straight line between two distances from its lowest point, in pieces of
// increasing length.
//   lowest  the radius at the lowest point of the line
static void add_between(struct column *sum, double lowest, double from, double to, int pieces)
{
    for (int i = 0; i < pieces; i++) {
        double a = (double)i / pieces, b = (i + 1.0) / pieces;
        double begin = from + (to - from) * a * a * a,
               size = from + (to - from) * b * b * b - begin;
        for (int k = 0; k < NODES; k++) {
            struct column here = density(height_of(lowest, begin + size * node[k]));
            for (int c = 0; c < 3; c++)
                sum->of[c] += weight[k] * size * here.of[c];
        }
    }
}

// Find the columns from a point at a radius towards the sun. Returns false if the Earth hides the
// sun.
static bool to_the_sun(double radius, double sine, double tall, struct column *sum)
{
    double lowest = radius * sqrt(fmax(1.0 - sine * sine, 0.0)), from = radius * sine;
    double end = sqrt(fmax((earth + tall) * (earth + tall) - lowest * lowest, 0.0));
    *sum = (struct column){{0.0, 0.0, 0.0}};
    if (sine < 0.0 && lowest < earth)
        return false;
    add_between(sum, lowest, fmax(from, 0.0), end, SUN_PIECES);
    if (sine < 0.0) // the part before the lowest point
        add_between(sum, lowest, 0.0, -from, SUN_PIECES);
    return true;
}

static double depth(int wave, int kind)
{
    double length = 0.40 + 0.02 * wave, x = 1.0 / (length * length);
    return kind == 0   ? 0.008569 * x * x * (1.0 + 0.0113 * x + 0.00013 * x * x)
           : kind == 1 ? 0.03 * 0.55 / length
                       : air_waves[wave].ozone * 1e-25 * 300.0 * 2.687e20;
}

// Add the share of the sun's light that reaches the eye through a point, for each wavelength, after
// the losses from the sun to the point and from the point to the eye. The sun's disc is divided
// into horizontal strips, and strips below the horizon add nothing. The disc is darker towards its
// rim, like a matt ball lit from the eye. Far from the horizon, the disc is treated as a point.
static void lit(double radius, double sine, double tall, struct column past, double ozone,
                double share[AIR_WAVES])
{
    enum { STRIPS = 32 };
    const double disc = 0.00466;
    double angle = asin(fmin(fmax(sine, -1.0), 1.0)), edge = -acos(earth / radius);
    int strips = fabs(angle - edge) < 5.0 * disc ? STRIPS : 1;
    for (int i = 0; i < strips; i++) {
        double x = strips == 1 ? 0.0 : 2.0 * (i + 0.5) / STRIPS - 1.0;
        double part = strips == 1 ? 1.0 : 0.75 * (1.0 - x * x) * 2.0 / STRIPS;
        struct column beyond;
        if (!to_the_sun(radius, sin(angle + x * disc), tall, &beyond))
            continue;
        for (int w = 0; w < AIR_WAVES; w++) {
            double lost = 0.0;
            for (int j = 0; j < 3; j++)
                lost += (j == 2 ? ozone : 1.0) * depth(w, j) * (past.of[j] + beyond.of[j]);
            share[w] += part * exp(-lost);
        }
    }
}

void air_light_of(double sun, double view, double azimuth, double ozone, double tall,
                  double light[3])
{
    const double screen[3][3] = {
        {3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}};
    double level = sqrt((1.0 - sun * sun) * (1.0 - view * view)) * azimuth, c = view * sun + level;
    double phase[2] = {3.0 / (16.0 * MIRROR_PI) * (1.0 + c * c),
                       (1.0 - 0.76 * 0.76) / (4.0 * MIRROR_PI) /
                           pow(1.0 + 0.76 * 0.76 - 2.0 * 0.76 * c, 1.5)};
    double climb = earth * view, out = (earth + tall) * (earth + tall) - earth * earth;
    double length = out / (sqrt(climb * climb + out) + climb),
           lowest = earth * sqrt(1.0 - view * view);
    double shares[AIR_WAVES] = {0.0}, seen = 0.0;
    struct column past = {{0.0, 0.0, 0.0}}; // the columns from the eye to the current point
    for (int i = 0; i < VIEW_PIECES; i++) {
        double a = (double)i / VIEW_PIECES, b = (i + 1.0) / VIEW_PIECES;
        double begin = length * a * a, size = length * b * b - begin;
        for (int k = 0; k < NODES; k++) {
            double way = begin + size * node[k], radius = earth + height_of(lowest, climb + way);
            struct column here = density(radius - earth);
            add_between(&past, lowest, climb + seen, climb + way, 1);
            seen = way;
            double share[AIR_WAVES] = {0.0};
            lit(radius, (earth * sun + way * c) / radius, tall, past, ozone, share);
            for (int w = 0; w < AIR_WAVES; w++)
                shares[w] += weight[k] * size * share[w] *
                             (here.of[0] * depth(w, 0) * phase[0] +
                              0.92 * here.of[1] * depth(w, 1) * phase[1]);
        }
    }
    light[0] = light[1] = light[2] = 0.0;
    for (int w = 0; w < AIR_WAVES; w++)
        for (int k = 0; k < 9; k++)
            light[k / 3] += screen[k / 3][k % 3] * air_waves[w].eye[k % 3] * air_waves[w].sun *
                            shares[w] * 683.0 * 20.0 / 4000.0;
}

void air_ambient_of(double sun, double light[3])
{
    enum { HEIGHTS = 12, AROUND = 12 };
    light[0] = light[1] = light[2] = 0.0;
    for (int i = 0; i < HEIGHTS * AROUND; i++) {
        double view = sqrt((i / AROUND + 0.5) / HEIGHTS),
               azimuth = cos(MIRROR_PI * (i % AROUND + 0.5) / AROUND), one[3];
        air_all_of(sun, view, azimuth, 1.0, one);
        for (int c = 0; c < 3; c++)
            light[c] += one[c] / (HEIGHTS * AROUND);
    }
}

void air_all_of(double sun, double view, double azimuth, double ozone, double light[3])
{
    struct air_light program = air_scattered(sun, view, azimuth, ozone);
    air_light_of(sun, view, azimuth, ozone, 120.0, light);
    for (int c = 0; c < 3; c++)
        light[c] += program.more[c];
}

// ---- By chance ----

// A random number in (0, 1), using a generator from G. Marsaglia, 'Xorshift RNGs' (2003).
static double chance(uint64_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return ((double)(*state >> 11) + 0.5) / 9007199254740992.0;
}

// Rotate a unit vector by the angle with the given cosine, in a random direction.
static void turned(double v[3], double cosine, uint64_t *state)
{
    double angle = 2.0 * MIRROR_PI * chance(state), sine = sqrt(fmax(1.0 - cosine * cosine, 0.0));
    double a[3] = {fabs(v[0]) < 0.5 ? 1.0 : 0.0, fabs(v[0]) < 0.5 ? 0.0 : 1.0, 0.0}, b[3];
    double along = a[0] * v[0] + a[1] * v[1], size = sqrt(1.0 - along * along);
    for (int k = 0; k < 3; k++)
        a[k] = (a[k] - along * v[k]) / size;
    for (int k = 0; k < 3; k++)
        b[k] = v[(k + 1) % 3] * a[(k + 2) % 3] - v[(k + 2) % 3] * a[(k + 1) % 3];
    for (int k = 0; k < 3; k++)
        v[k] = cosine * v[k] + sine * (cos(angle) * a[k] + sin(angle) * b[k]);
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static const double forward = 0.76, kept = 0.92;

static double phase_of(double air, double dust, double c)
{
    double g = forward, of_air = 3.0 / (16.0 * MIRROR_PI) * (1.0 + c * c);
    double of_dust = (1.0 - g * g) / (4.0 * MIRROR_PI) / pow(1.0 + g * g - 2.0 * g * c, 1.5);
    return (air * of_air + dust * of_dust) / (air + dust);
}

// The cosine of a random scattering angle, drawn from the phase function of air or that of dust.
static double cosine_by(double air, double dust, uint64_t *state)
{
    double x = chance(state), g = forward;
    if (chance(state) * (air + dust) > air) {
        double y = (1.0 - g * g) / (1.0 - g + 2.0 * g * x);
        return (1.0 + g * g - y * y) / (2.0 * g);
    }
    double y = 4.0 * x - 2.0, z = cbrt(y + sqrt(y * y + 1.0));
    return z - 1.0 / z;
}

// The share of the sunlight that arrives at a point. The sun is treated as a point.
static double sunlight_at(const double p[3], const double sun[3], int wave)
{
    double radius = sqrt(dot(p, p));
    struct column beyond;
    if (!to_the_sun(radius, dot(p, sun) / radius, 120.0, &beyond))
        return 0.0;
    return exp(-depth(wave, 0) * beyond.of[0] - depth(wave, 1) * beyond.of[1] -
               depth(wave, 2) * beyond.of[2]);
}

// The length of a ray to the ground or, if the ray does not reach the ground, to the top of the
// air.
static double way_of(const double p[3], const double v[3], bool *lands)
{
    double b = dot(p, v), square = dot(p, p), ground = b * b - square + earth * earth;
    *lands = b < 0.0 && ground > 0.0;
    return *lands ? -b - sqrt(ground)
                  : sqrt(b * b - square + (earth + 120.0) * (earth + 120.0)) - b;
}

// The distance that a path covers from a point until it is scattered or reaches the ground.
//   share  is multiplied by the probability of a scattering if the ray leads out of the air
static double flight(const double p[3], const double v[3], int wave, uint64_t *state, bool *ground,
                     double *share)
{
    enum { STEPS = 64 };
    bool lands;
    double way = way_of(p, v, &lands), low = fmin(fmax(-dot(p, v), 0.0), way), depths[STEPS + 1];
    double at[STEPS + 1], passed = 0.0;
    for (int i = 0; i <= STEPS; i++) { // the steps are shortest where the ray is lowest
        double x = 2.0 * i / STEPS - 1.0, part = x < 0.0 ? low : way - low;
        at[i] = low > 0.0 ? low + part * x * fabs(x) : way * i / STEPS * i / STEPS;
    }
    depths[0] = 0.0;
    for (int i = 0; i < STEPS; i++) {
        double t = 0.5 * (at[i] + at[i + 1]), q[3];
        for (int k = 0; k < 3; k++)
            q[k] = p[k] + t * v[k];
        struct column here = density(sqrt(dot(q, q)) - earth);
        for (int k = 0; k < 3; k++)
            passed += (at[i + 1] - at[i]) * depth(wave, k) * here.of[k];
        depths[i + 1] = passed;
    }
    double all = 1.0 - exp(-passed), x = chance(state);
    if (!lands) // a path that would leave the air is scattered instead
        *share *= all;
    double target = -log(1.0 - x * (lands ? 1.0 : all));
    *ground = lands && target >= passed;
    double t = way;
    for (int i = 0; i < STEPS && !*ground; i++)
        if (depths[i + 1] >= target) {
            t = at[i] + (at[i + 1] - at[i]) * (target - depths[i]) / (depths[i + 1] - depths[i]);
            break;
        }
    return t;
}

// Follow one path backwards from the eye, and add the sunlight that arrives along it: the light
// that the air scatters once to arrived[0], and all other light to arrived[1].
static void follow(double view, double azimuth, const double sun[3], double albedo, int wave,
                   uint64_t *state, double arrived[2])
{
    double p[3] = {0.0, earth + 1e-6, 0.0}, side = sqrt(1.0 - view * view), share = 1.0;
    double v[3] = {side * azimuth, view, side * sqrt(1.0 - azimuth * azimuth)};
    for (int order = 0; order < 40; order++) {
        bool ground;
        double t = flight(p, v, wave, state, &ground, &share);
        for (int k = 0; k < 3; k++)
            p[k] += t * v[k];
        if (ground) {
            double radius = sqrt(dot(p, p)), up[3] = {p[0] / radius, p[1] / radius, p[2] / radius};
            for (int k = 0; k < 3; k++)
                p[k] = up[k] * (earth + 1e-6);
            share *= albedo;
            double high = fmax(dot(up, sun), 0.0);
            if (share > 0.0 && high > 0.0)
                arrived[1] += share * high / MIRROR_PI * sunlight_at(p, sun, wave);
            for (int k = 0; k < 3; k++)
                v[k] = up[k];
            turned(v, sqrt(chance(state)), state);
        } else {
            struct column here = density(sqrt(dot(p, p)) - earth);
            double air = depth(wave, 0) * here.of[0], dust = kept * depth(wave, 1) * here.of[1];
            share *= (air + dust) / (air + dust / kept + depth(wave, 2) * here.of[2]);
            arrived[order > 0] +=
                share * phase_of(air, dust, dot(v, sun)) * sunlight_at(p, sun, wave);
            turned(v, cosine_by(air, dust, state), state);
        }
        // Russian roulette: a dim path may end. If it does not, its share is raised.
        if (share < 0.1) {
            if (share <= 0.0 || chance(state) > share / 0.1)
                return;
            share = 0.1;
        }
    }
}

struct air_paths air_paths(double sun, double view, double azimuth, double albedo, int wave,
                           int count)
{
    const double toward[3] = {sqrt(1.0 - sun * sun), sun, 0.0};
    struct air_paths sum = {0.0, 0.0, 0.0};
    uint64_t state = 88172645463325252u;
    for (int i = 0; i < count; i++) {
        double arrived[2] = {0.0, 0.0};
        follow(view, azimuth, toward, albedo, wave, &state, arrived);
        sum.once += arrived[0] / count;
        sum.more += arrived[1] / count;
        sum.error += arrived[1] * arrived[1] / count;
    }
    sum.error = sqrt(fmax(sum.error - sum.more * sum.more, 0.0) / count);
    return sum;
}

double air_luminance(const double light[3])
{
    return 4000.0 * (0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2]);
}

void air_chromaticity(const double light[3], double xy[2])
{
    double x = 0.4124 * light[0] + 0.3576 * light[1] + 0.1805 * light[2];
    double z = 0.0193 * light[0] + 0.1192 * light[1] + 0.9505 * light[2];
    double y = air_luminance(light) / 4000.0;
    xy[0] = x / (x + y + z);
    xy[1] = y / (x + y + z);
}
