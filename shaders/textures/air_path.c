#include "air_path.h"

#include <math.h>

#include "paint.h"

// Lengths are in kilometres. The density of the air falls by a factor of e with every LOW_SCALE of
// height up to BEND, and with every HIGH_SCALE above BEND, where the air is colder. This is within
// 18 % of the standard atmosphere up to 55 km. With a single scale of 8.4 there would be 3 times
// too much air at 50 km, where the light of dusk comes from. Dust falls off eight times as fast, by
// a factor of e with every 1.2 km; ozone is densest at 25 km, and there is no ozone farther than
// 15 km from that height. The air ends at AIR_TOP; a share of 2e-8 of real air is higher. Sources:
// 'U.S. standard atmosphere' (1976); E. Bruneton, F. Neyret, 'Precomputed atmospheric scattering',
// Computer Graphics Forum 27 (2008), for the height of the dust and, in Bruneton's implementation
// of 2017, the profile of ozone.
static const double LOW_SCALE = 9.6, HIGH_SCALE = 6.7, BEND = 9.0;

// The thickness that the air overhead would have if all of it were as dense as at sea level, and
// the corresponding thickness of the dust.
static const double AIR_COLUMN = 8.464, DUST_COLUMN = 1.2;

// Angular radius of the sun: 0.267 degrees.
static const double SUN_RADIUS = 0.00466;

enum { SUN_STEPS = 80 };

// Sources: sun: ASTM G-173 (2003), above the air; ozone: V. Gorshelev and others, 'High spectral
// resolution ozone absorption cross-sections', Atmospheric Measurement Techniques 7 (2014), at 233
// K; both as the means over 20 nm around the wavelength; eye: CIE 1931.
const struct air_wave air_waves[AIR_WAVES] = {
    {1.437, 0.011, {0.0143, 0.0004, 0.0679}}, {1.710, 0.041, {0.1344, 0.0040, 0.6456}},
    {1.762, 0.121, {0.3483, 0.0230, 1.7471}}, {2.028, 0.299, {0.2908, 0.0600, 1.6692}},
    {1.978, 0.634, {0.0956, 0.1390, 0.8130}}, {1.937, 1.191, {0.0049, 0.3230, 0.2720}},
    {1.849, 1.871, {0.0633, 0.7100, 0.0783}}, {1.872, 2.923, {0.2904, 0.9540, 0.0203}},
    {1.842, 3.883, {0.5945, 0.9950, 0.0039}}, {1.825, 4.535, {0.9163, 0.8700, 0.0017}},
    {1.767, 4.860, {1.0622, 0.6310, 0.0008}}, {1.689, 4.023, {0.8545, 0.3810, 0.0002}},
    {1.626, 2.939, {0.4479, 0.1750, 0.0000}}, {1.539, 2.045, {0.1649, 0.0610, 0.0000}},
    {1.493, 1.341, {0.0468, 0.0170, 0.0000}}, {1.429, 0.844, {0.0114, 0.0041, 0.0000}}};

// A cross section in 1e-25 m^2, times OZONE, is the optical depth of 300 Dobson units of ozone
// overhead; one unit is 2.687e20 molecules per square metre.
static const double OZONE = 300.0 * 2.687e20 * 1e-25;

// Optical depth of the dust overhead at 550 nm, on a clear day. The depth is proportional to 1 /
// wavelength, which means an Angstrom exponent of 1.
static const double DUST = 0.03;

static double wave_length(int wave) // micrometres
{
    return 0.40 + 0.02 * wave;
}

// Optical depth of the air overhead. Source: J. E. Hansen, L. D. Travis, 'Light scattering in
// planetary atmospheres', Space Science Reviews 16 (1974), as in chapter 09.
double air_depth(int wave)
{
    double x = 1.0 / (wave_length(wave) * wave_length(wave));
    return 0.008569 * x * x * (1.0 + 0.0113 * x + 0.00013 * x * x);
}

double air_dust_depth(int wave)
{
    return DUST * 0.55 / wave_length(wave);
}

// ---- Amounts along a path ----

// e^-x for x >= 0, computed from a table of 32 values for each factor of 1/e, and five terms of the
// series for the rest. The relative error is at most 3e-10. The result is 0 from x = 64 on.
static double fade(double x)
{
    enum { EACH = 32, COUNT = 64 * EACH };
    static double known[COUNT];
    if (known[0] == 0.0)
        for (int i = 0; i < COUNT; i++)
            known[i] = paint_exp(-(double)i / EACH);
    double position = EACH * (x > 0.0 ? x : 0.0);
    if (position >= COUNT)
        return 0.0;
    double rest = (position - (int)position) * (1.0 / EACH);
    double series = 1.0 - rest * (1.0 / 3.0) * (1.0 - rest * 0.25);
    return known[(int)position] * (1.0 - rest * (1.0 - rest * 0.5 * series));
}

struct air_amount air_density(double height)
{
    double low = height < BEND ? height : BEND;
    double air = fade(low * (1.0 / LOW_SCALE) + (height - low) * (1.0 / HIGH_SCALE));
    double square = air * air, fourth = square * square;
    double from = height > 25.0 ? height - 25.0 : 25.0 - height;
    return (struct air_amount){.air = air * (1.0 / AIR_COLUMN),
                               .dust = fourth * fourth * (1.0 / DUST_COLUMN),
                               .ozone = from < 15.0 ? (15.0 - from) * (1.0 / 225.0) : 0.0};
}

// The height is the difference of two large lengths; it is computed without loss of digits.
double air_height_at(double radius, double sine, double distance)
{
    double more = distance * (2.0 * radius * sine + distance);
    return radius - AIR_EARTH + more / (sqrt(radius * radius + more) + radius);
}

double air_way_out(double radius, double sine)
{
    double b = radius * sine, c = (AIR_EARTH + AIR_TOP) * (AIR_EARTH + AIR_TOP) - radius * radius;
    return c > 0.0 ? c / (sqrt(b * b + c) + b) : 0.0;
}

// Simpson's rule for a ray that does not descend, in the cube root of the distance: the steps are
// short near the ray's beginning, where the air is thick.
struct air_amount air_amount_up(double radius, double sine)
{
    double length = air_way_out(radius, sine);
    struct air_amount sum = {0.0, 0.0, 0.0};
    for (int i = 1; i <= SUN_STEPS; i++) { // the first point has no weight
        double q = (double)i / SUN_STEPS, weight = i == SUN_STEPS ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
        weight *= length * q * q / SUN_STEPS;
        struct air_amount here = air_density(air_height_at(radius, sine, length * q * q * q));
        sum.air += weight * here.air;
        sum.dust += weight * here.dust;
        sum.ozone += weight * here.ozone;
    }
    return sum;
}

// The amounts along any ray that does not meet the Earth. A ray that descends rises again beyond
// its lowest point. The amounts along such a ray are twice the amounts beyond that point, minus the
// amounts along the ray's extension backwards from its start.
static struct air_amount amount_along(double radius, double sine)
{
    if (sine >= 0.0)
        return air_amount_up(radius, sine);
    double lowest = radius * sqrt(1.0 - sine * sine);
    struct air_amount half = air_amount_up(lowest > AIR_EARTH ? lowest : AIR_EARTH, 0.0);
    struct air_amount behind = air_amount_up(radius, -sine);
    return (struct air_amount){.air = 2.0 * half.air - behind.air,
                               .dust = 2.0 * half.dust - behind.dust,
                               .ozone = 2.0 * half.ozone - behind.ozone};
}

double air_share_through(int wave, struct air_amount amount, double ozone)
{
    return fade(air_depth(wave) * amount.air + air_dust_depth(wave) * amount.dust +
                ozone * OZONE * air_waves[wave].ozone * amount.ozone);
}

// ---- The sun ----

// The visible part of the sun is cut into horizontal strips for Gauss's rule of three points; a sun
// that is well above the horizon is one strip. A strip at x, from -1 to 1, has the density
// 3 (1 - x^2) / 4 of the light, as on a disc that darkens towards its rim like a ball lit from the
// eye.
void air_add_sunlight(double radius, double sine, struct air_amount way, double ozone,
                      double share[AIR_WAVES])
{
    static const double position[3] = {0.11270166537925831, 0.5, 0.88729833462074169};
    static const double weight[3] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    double cosine = sqrt(1.0 - sine * sine), level = AIR_EARTH / radius;
    double dip = sqrt(1.0 - level * level), over = sine * level + cosine * dip; // above the horizon
    double lowest = -over / SUN_RADIUS, from = lowest > -1.0 ? lowest : -1.0;
    int strips = from >= 1.0 ? 0 : over > 4.0 * SUN_RADIUS ? 1 : 3;
    for (int i = 0; i < strips; i++) {
        double x = strips == 1 ? 0.0 : from + (1.0 - from) * position[i];
        double part = strips == 1 ? 1.0 : 0.75 * (1.0 - x * x) * (1.0 - from) * weight[i];
        double to = sine + x * SUN_RADIUS * cosine;
        struct air_amount all = amount_along(radius, to < 1.0 ? to : 1.0);
        all.air += way.air;
        all.dust += way.dust;
        all.ozone += way.ozone;
        for (int w = 0; w < AIR_WAVES; w++)
            share[w] += part * air_share_through(w, all, ozone);
    }
}

// ---- Tables over a height of the sun or of a direction ----

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
