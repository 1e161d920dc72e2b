#include "air.h"

#include <math.h>

#include "paint.h"

// Kilometres. The air and the dust thin out by 1/e in so many of height; ozone lies round 25 km, 15
// km up and down, thinning out evenly. TOP is where the air is taken to end: e^-9.5 of it lies
// above. Sources: E. Bruneton, F. Neyret, 'Precomputed atmospheric scattering', Computer Graphics
// Forum 27 (2008), for the dust's height and, in Bruneton's implementation of 2017, the profile of
// ozone.
static const double EARTH = 6371.0, TOP = 120.0, AIR_HEIGHT = 8.4; // of the dust: a seventh, 1.2

// Of the sun as it is seen: 0.267 degrees.
static const double SUN_RADIUS = 0.00466;

enum { VIEW_STEPS = 120, SUN_STEPS = 80 };

// Sources: sun: ASTM G-173 (2003), above the air; ozone: V. Gorshelev and others, 'High spectral
// resolution ozone absorption cross-sections', Atmospheric Measurement Techniques 7 (2014), at 233
// K; both as the means over 20 nm round the wavelength. The eye: CIE 1931.
const struct air_wave air_waves[AIR_WAVES] = {
    {1.437, 0.011, {0.0143, 0.0004, 0.0679}}, {1.710, 0.041, {0.1344, 0.0040, 0.6456}},
    {1.762, 0.121, {0.3483, 0.0230, 1.7471}}, {2.028, 0.299, {0.2908, 0.0600, 1.6692}},
    {1.978, 0.634, {0.0956, 0.1390, 0.8130}}, {1.937, 1.191, {0.0049, 0.3230, 0.2720}},
    {1.849, 1.871, {0.0633, 0.7100, 0.0783}}, {1.872, 2.923, {0.2904, 0.9540, 0.0203}},
    {1.842, 3.883, {0.5945, 0.9950, 0.0039}}, {1.825, 4.535, {0.9163, 0.8700, 0.0017}},
    {1.767, 4.860, {1.0622, 0.6310, 0.0008}}, {1.689, 4.023, {0.8545, 0.3810, 0.0002}},
    {1.626, 2.939, {0.4479, 0.1750, 0.0000}}, {1.539, 2.045, {0.1649, 0.0610, 0.0000}},
    {1.493, 1.341, {0.0468, 0.0170, 0.0000}}, {1.429, 0.844, {0.0114, 0.0041, 0.0000}}};

// Cross sections, 1e-25 m^2, times this are the depth of 300 Dobson units of ozone, of 2.687e20
// molecules per square metre each, overhead.
static const double OZONE = 300.0 * 2.687e20 * 1e-25;

// Depth of the dust overhead at 550 nm, and the share of what it takes that it sends on. In
// proportion to 1 / wavelength. A clear day: T. Angstrom's exponent 1.
static const double DUST = 0.03, DUST_KEPT = 0.92;

// 4,000 cd/m^2; 683 lumens a watt; the wavelengths' step.
static const double UNIT = 683.0 * 20.0 / 4000.0, PI = 3.14159265358979324;

// Linear sRGB of X, Y, Z, IEC 61966-2-1.
static const double SCREEN[3][3] = {
    {3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}};

static double wave_length(int wave) // micrometres
{
    return 0.40 + 0.02 * wave;
}

// Depth of the air overhead: J. E. Hansen, L. D. Travis, 'Light scattering in planetary
// atmospheres', Space Science Reviews 16 (1974), as in chapter 09.
static double air_depth(int wave)
{
    double x = 1.0 / (wave_length(wave) * wave_length(wave));
    return 0.008569 * x * x * (1.0 + 0.0113 * x + 0.00013 * x * x);
}

static double dust_depth(int wave)
{
    return DUST * 0.55 / wave_length(wave);
}

// Add to a colour what light of a wavelength is on a screen.
static void add_wave(int wave, double light, double colour[3])
{
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++)
            colour[c] += UNIT * SCREEN[c][k] * air_waves[wave].eye[k] * air_waves[wave].sun * light;
}

// ---- Amounts on a way, as shares of what is overhead ----

struct amount {
    double air, dust, ozone;
};

// e^-x for x >= 0: a table of 32 places for each 1/e, and five terms of the series for the rest.
// Off by at most a share of 3e-10; 0 from 64 on.
static double fade(double x)
{
    enum { EACH = 32, COUNT = 64 * EACH };
    static double known[COUNT];
    if (known[0] == 0.0)
        for (int i = 0; i < COUNT; i++)
            known[i] = paint_exp(-(double)i / EACH);
    double place = EACH * (x > 0.0 ? x : 0.0);
    if (place >= COUNT)
        return 0.0;
    double rest = (place - (int)place) * (1.0 / EACH);
    double series = 1.0 - rest * (1.0 / 3.0) * (1.0 - rest * 0.25);
    return known[(int)place] * (1.0 - rest * (1.0 - rest * 0.5 * series));
}

// Of one kilometre at a height, upwards.
static struct amount density(double height)
{
    double air = fade(height * (1.0 / AIR_HEIGHT)), square = air * air;
    double from = height > 25.0 ? height - 25.0 : 25.0 - height;
    return (struct amount){.air = air * (1.0 / AIR_HEIGHT),
                           .dust = square * square * square * air * (7.0 / AIR_HEIGHT),
                           .ozone = from < 15.0 ? (15.0 - from) * (1.0 / 225.0) : 0.0};
}

// Height above the sea at a distance along a ray that begins at radius with that sine of its
// height. The difference of two large roots, without its loss of digits.
static double height_at(double radius, double sine, double distance)
{
    double more = distance * (2.0 * radius * sine + distance);
    return radius - EARTH + more / (sqrt(radius * radius + more) + radius);
}

// How far it is to the top of the air.
static double way_out(double radius, double sine)
{
    double b = radius * sine, c = (EARTH + TOP) * (EARTH + TOP) - radius * radius;
    return c > 0.0 ? c / (sqrt(b * b + c) + b) : 0.0;
}

// Simpson's rule for a ray that does not go down, in the third root of the distance: the steps are
// short near the ray's beginning, where the air is thick.
static struct amount amount_up(double radius, double sine)
{
    double length = way_out(radius, sine);
    struct amount sum = {0.0, 0.0, 0.0};
    for (int i = 1; i <= SUN_STEPS; i++) { // the first place has no weight
        double q = (double)i / SUN_STEPS, weight = i == SUN_STEPS ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
        weight *= length * q * q / SUN_STEPS;
        struct amount here = density(height_at(radius, sine, length * q * q * q));
        sum.air += weight * here.air;
        sum.dust += weight * here.dust;
        sum.ozone += weight * here.ozone;
    }
    return sum;
}

// The same for any ray that does not meet the Earth. One that goes down rises again beyond its
// lowest place: what lies on it is twice what lies beyond that place, less what lies behind the
// eye.
static struct amount amount_along(double radius, double sine)
{
    if (sine >= 0.0)
        return amount_up(radius, sine);
    double lowest = radius * sqrt(1.0 - sine * sine);
    struct amount half = amount_up(lowest > EARTH ? lowest : EARTH, 0.0);
    struct amount behind = amount_up(radius, -sine);
    return (struct amount){.air = 2.0 * half.air - behind.air,
                           .dust = 2.0 * half.dust - behind.dust,
                           .ozone = 2.0 * half.ozone - behind.ozone};
}

static double share_through(int wave, struct amount amount, double ozone)
{
    return fade(air_depth(wave) * amount.air + dust_depth(wave) * amount.dust +
                ozone * OZONE * air_waves[wave].ozone * amount.ozone);
}

// ---- Light ----

// The sun's light at a place, as shares of what there is above the air: the sun is a disc, and near
// the edge of the Earth's shadow a part of it is seen. What is seen is cut into level strips, by
// Gauss's rule of three places; a strip at x, from -1 to 1, has the share 3 (1 - x^2) / 4 of the
// light, that of a disc as dark at its rim as a ball lit from the eye.
//   sine  of the height of the sun's middle
//   way   what lies between the place and the eye
static void add_sunlight(double radius, double sine, struct amount way, double ozone,
                         double share[AIR_WAVES])
{
    static const double place[3] = {0.11270166537925831, 0.5, 0.88729833462074169};
    static const double weight[3] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    double cosine = sqrt(1.0 - sine * sine), level = EARTH / radius;
    double dip = sqrt(1.0 - level * level), over = sine * level + cosine * dip; // the horizon
    double lowest = -over / SUN_RADIUS, from = lowest > -1.0 ? lowest : -1.0;
    int strips = from >= 1.0 ? 0 : over > 4.0 * SUN_RADIUS ? 1 : 3;
    for (int i = 0; i < strips; i++) {
        double x = strips == 1 ? 0.0 : from + (1.0 - from) * place[i];
        double part = strips == 1 ? 1.0 : 0.75 * (1.0 - x * x) * (1.0 - from) * weight[i];
        double to = sine + x * SUN_RADIUS * cosine;
        struct amount all = amount_along(radius, to < 1.0 ? to : 1.0);
        all.air += way.air;
        all.dust += way.dust;
        all.ozone += way.ozone;
        for (int w = 0; w < AIR_WAVES; w++)
            share[w] += part * share_through(w, all, ozone);
    }
}

struct air_light air_scattered(double sun, double view, double azimuth, double ozone)
{
    struct air_light light = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    double level =
        sqrt((1.0 - sun * sun) * (1.0 - view * view)) * azimuth; // of the cosine of their angle
    double length = way_out(EARTH, view);
    struct amount passed = {0.0, 0.0, 0.0};
    double air[AIR_WAVES] = {0.0}, dust[AIR_WAVES] = {0.0};
    for (int i = 0; i < VIEW_STEPS; i++) { // the middles of steps that grow
        double from = (double)i / VIEW_STEPS, to = (i + 1.0) / VIEW_STEPS, q = 0.5 * (from + to);
        double distance = length * q * q, step = length * (to * to - from * from);
        double height = height_at(EARTH, view, distance), radius = EARTH + height;
        struct amount here = density(height), way = passed;
        // The sun stands higher by the angle that the ray has gone round the Earth.
        double sine = (EARTH * sun + distance * (view * sun + level)) / radius;
        double share[AIR_WAVES] = {0.0};
        way.air += 0.5 * step * here.air;
        way.dust += 0.5 * step * here.dust;
        way.ozone += 0.5 * step * here.ozone;
        add_sunlight(radius, sine, way, ozone, share);
        for (int w = 0; w < AIR_WAVES; w++) {
            air[w] += step * share[w] * here.air * air_depth(w);
            dust[w] += step * share[w] * here.dust * dust_depth(w) * DUST_KEPT;
        }
        passed.air += step * here.air;
        passed.dust += step * here.dust;
        passed.ozone += step * here.ozone;
    }
    for (int w = 0; w < AIR_WAVES; w++) {
        add_wave(w, air[w], light.air);
        add_wave(w, dust[w], light.dust);
    }
    return light;
}

void air_sunlight(double sun, double colour[3])
{
    colour[0] = colour[1] = colour[2] = 0.0;
    if (sun >= 0.0)
        for (int w = 0; w < AIR_WAVES; w++)
            add_wave(w, share_through(w, amount_up(EARTH, sun), 1.0) / PI, colour);
}

// ---- The tables ----

double air_drawn_out(double sine, double k)
{
    double size = sine < 0.0 ? -sine : sine;
    double x = (sqrt(k * k + 4.0 * (1.0 - k) * size) - k) / (2.0 * (1.0 - k));
    return sine < 0.0 ? -x : x;
}

double air_drawn_back(double x, double k)
{
    return x * (k + (1.0 - k) * (x < 0.0 ? -x : x));
}

// 0 where x is far below 0, x where it is far above, smooth between.
static double beyond(double x)
{
    return 0.5 * (x + sqrt(x * x + 0.0004));
}

struct air_scale air_scale(double sun, double row)
{
    static const double air[3][7] = {{5.50, 0.152, 52.6, 4.23, 62.8, 1.68, 0.118},
                                     {5.34, 0.164, 52.6, 3.50, 54.9, 0.80, 0.302},
                                     {7.11, 0.244, 60.9, 3.66, 43.0, 2.76, 0.339}};
    static const double dust[3][6] = {{4.95, 0.192, 186.0, 4.99, -0.20, 0.048},
                                      {4.89, 0.294, 226.0, 4.70, -0.06, 0.079},
                                      {4.95, 0.468, 167.0, 4.54, 0.27, 0.168}};
    const double log2 = 0.69314718055994531;
    double low = 1.0 / ((sun > 0.0 ? sun : 0.0) + 0.068), foot = 1.0 / (1.0 + 114.0 * row * row);
    double deep = beyond(-sun - 0.038), shaded = beyond(-sun - 0.008);
    struct air_scale scale;
    for (int c = 0; c < 3; c++) {
        const double *k = air[c], *d = dust[c];
        scale.air[c] = paint_exp(log2 * (k[0] - k[1] * low - k[2] * deep -
                                         row * (k[3] + k[4] * deep) - foot * (k[5] + k[6] * low)));
        scale.dust[c] = paint_exp(
            log2 * (d[0] - d[1] * low - d[2] * shaded - row * d[3] - foot * (d[4] + d[5] * low)));
    }
    return scale;
}

// The light of a place in a table. A table is drawn from its top row down, and each place of the
// upper storey is asked for again in the lower one: it is kept.
static struct air_light light_once(double sun, double row, double azimuth, double ozone, int column)
{
    static struct {
        struct air_light light;
        double azimuth, ozone;
        int known;
    } kept[AIR_ROWS][AIR_COLUMNS];
    int i = (int)(row * (AIR_ROWS - 1) + 0.5);
    if (!kept[i][column].known || kept[i][column].azimuth != azimuth ||
        kept[i][column].ozone != ozone) {
        kept[i][column].light =
            air_scattered(sun, air_drawn_back(row, AIR_VIEW_WIDTH), azimuth, ozone);
        kept[i][column].azimuth = azimuth;
        kept[i][column].ozone = ozone;
        kept[i][column].known = 1;
    }
    return kept[i][column].light;
}

void air_table(double u, double v, double azimuth, double ozone, double value[4])
{
    double lowest = air_drawn_out(AIR_LOWEST_SUN, AIR_SUN_WIDTH);
    double column = floor(u * AIR_COLUMNS) / (AIR_COLUMNS - 1), y = floor(v * 2 * AIR_ROWS);
    double row = (y >= AIR_ROWS ? y - AIR_ROWS : y) / (AIR_ROWS - 1);
    double sun = air_drawn_back(lowest + column * (1.0 - lowest), AIR_SUN_WIDTH);
    struct air_light light = light_once(sun, row, azimuth, ozone, (int)(u * AIR_COLUMNS));
    struct air_scale scale = air_scale(sun, row);
    double *part = y < AIR_ROWS ? light.air : light.dust;
    const double *one = y < AIR_ROWS ? scale.air : scale.dust;
    double all = ozone > 0.0 ? 1.0 : 0.25; // without ozone there is up to three times as much light
    for (int c = 0; c < 3; c++)
        part[c] *= all;
    double blue = part[2] / one[2];
    int byte = paint_byte(blue); // the one below; the fourth number has the rest
    byte -= byte > 0 && paint_light(byte) > blue ? 1 : 0;
    value[0] = part[0] / one[0];
    value[1] = part[1] / one[1];
    value[2] = paint_light(byte);
    value[3] = 128.0 / 255.0 + (blue - value[2]) * one[2] / (AIR_FINE * one[0]);
}

// The air mass of chapter 09's even shell.
static double air_mass(double sine)
{
    double climb = 721.5 * sine, horizon = 2.0 * 721.5 + 1.0;
    return horizon / (sqrt(climb * climb + horizon) + climb);
}

// The disc is darker towards its rim, and redder: the share at the rim is 1 - DARK. Source: the
// sun's limb by A. N. Cox (editor), 'Allen's astrophysical quantities' (2000), the linear term at
// 680, 550 and 440 nm.
static const double DARK[3] = {0.47, 0.60, 0.74};

void air_sun_table(double u, double v, double value[3])
{
    double q = floor(u * SUN_COLUMNS) / (SUN_COLUMNS - 1), x = SUN_REACH * q * q;
    double row = floor(v * SUN_ROWS) / (SUN_ROWS - 1), sine = air_drawn_back(row, SUN_ROW_WIDTH);
    double mass = air_mass(sine), scale = 15.0 * paint_exp(-0.1 * mass), colour[3];
    double rim = x < 1.0 ? sqrt(1.0 - x * x) : 0.0, left = 1.0 - x * x / (SUN_REACH * SUN_REACH);
    air_sunlight(sine, colour);
    for (int c = 0; c < 3; c++) {
        // The mean of the disc is 1 - DARK / 3 of its middle, and is to be the sun's light.
        double middle = colour[c] / (1.0 - DARK[c] / 3.0) / scale;
        value[c] = middle * (x <= 1.0 ? 1.0 - DARK[c] * (1.0 - rim) : mass / 38.0 * left * left);
    }
}
