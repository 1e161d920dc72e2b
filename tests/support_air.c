#include "support_air.h"

#include <math.h>
#include <stdbool.h>

#include "../shaders/textures/air.h"
#include "support_mirror.h"

enum { NODES = 6, VIEW_PIECES = 20, SUN_PIECES = 14 };

// Gauss's rule of six places on [0, 1].
static const double place[NODES] = {0.033765242898423986, 0.16939530676686774, 0.38069040695840155,
                                    0.61930959304159845,  0.83060469323313226, 0.96623475710157601};
static const double weight[NODES] = {0.085662246189585172, 0.18038078652406930,
                                     0.23395696728634552,  0.23395696728634552,
                                     0.18038078652406930,  0.085662246189585172};

static const double earth = 6371.0;

// Columns of air, dust and ozone, in shares of what is overhead.
struct column {
    double of[3];
};

static struct column density(double height)
{
    double air = exp(-height / 8.4), squared = air * air;
    double dust =
        squared * squared * squared * air; // 7 times 1.2 are 8.4: one exponential for both
    return (struct column){
        {air / 8.4, dust / 1.2, fmax(1.0 - fabs(height - 25.0) / 15.0, 0.0) / 15.0}};
}

static double height_of(double lowest, double along)
{
    return sqrt(lowest * lowest + along * along) - earth;
}

// Add what lies on a straight line whose lowest place has that radius, from one distance beyond it
// to another: in pieces that grow.
static void add_between(struct column *sum, double lowest, double from, double to, int pieces)
{
    for (int i = 0; i < pieces; i++) {
        double a = (double)i / pieces, b = (i + 1.0) / pieces;
        double begin = from + (to - from) * a * a * a,
               size = from + (to - from) * b * b * b - begin;
        for (int k = 0; k < NODES; k++) {
            struct column here = density(height_of(lowest, begin + size * place[k]));
            for (int c = 0; c < 3; c++)
                sum->of[c] += weight[k] * size * here.of[c];
        }
    }
}

// Towards the sun from a radius. False where the Earth is in the way.
static bool to_the_sun(double radius, double sine, double tall, struct column *sum)
{
    double lowest = radius * sqrt(fmax(1.0 - sine * sine, 0.0)), from = radius * sine;
    double end = sqrt(fmax((earth + tall) * (earth + tall) - lowest * lowest, 0.0));
    *sum = (struct column){{0.0, 0.0, 0.0}};
    if (sine < 0.0 && lowest < earth)
        return false;
    add_between(sum, lowest, fmax(from, 0.0), end, SUN_PIECES);
    if (sine < 0.0) // from above 0 to the end, and the part before the lowest place
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

// What the air leaves of the sun's light at a place, by wavelengths, with what lies between it and
// the eye: the mean of level strips of the disc, as dark at its rim as a ball lit from the eye, of
// those that stand above the Earth. Far from its edge the disc is a point.
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
    struct column past = {{0.0, 0.0, 0.0}}; // from the eye on, place by place
    for (int i = 0; i < VIEW_PIECES; i++) {
        double a = (double)i / VIEW_PIECES, b = (i + 1.0) / VIEW_PIECES;
        double begin = length * a * a, size = length * b * b - begin;
        for (int k = 0; k < NODES; k++) {
            double way = begin + size * place[k], radius = earth + height_of(lowest, climb + way);
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
        double one[3];
        air_light_of(sun, sqrt((i / AROUND + 0.5) / HEIGHTS),
                     cos(MIRROR_PI * (i % AROUND + 0.5) / AROUND), 1.0, 120.0, one);
        for (int c = 0; c < 3; c++)
            light[c] += one[c] / (HEIGHTS * AROUND);
    }
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
