#include "air.h"

#include <math.h>

#include "air_orders.h"
#include "air_path.h"
#include "paint.h"

enum { VIEW_STEPS = 120 };

// 683 lumens per watt, times the step of the wavelengths, 20 nm, divided by 4,000 cd/m^2.
static const double UNIT = 683.0 * 20.0 / 4000.0;

// The matrix from X, Y, Z to linear sRGB: IEC 61966-2-1.
static const double SCREEN[3][3] = {
    {3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}};

// Add light of one wavelength, as a screen shows it, to a colour.
static void add_wave(int wave, double light, double colour[3])
{
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++)
            colour[c] += UNIT * SCREEN[c][k] * air_waves[wave].eye[k] * air_waves[wave].sun * light;
}

// ---- Light ----

void air_shares(double sun, double view, double azimuth, double ozone, struct air_shares *shares)
{
    // The horizontal part of the cosine of the angle between the sun and the direction.
    double level = sqrt((1.0 - sun * sun) * (1.0 - view * view)) * azimuth;
    double length = air_way_out(AIR_EARTH, view);
    struct air_amount passed = {0.0, 0.0, 0.0};
    *shares = (struct air_shares){{0.0}, {0.0}, {0.0}};
    for (int i = 0; i < VIEW_STEPS; i++) { // at the middles of steps that grow with the distance
        double from = (double)i / VIEW_STEPS, to = (i + 1.0) / VIEW_STEPS, q = 0.5 * (from + to);
        double distance = length * q * q, step = length * (to * to - from * from);
        double height = air_height_at(AIR_EARTH, view, distance), radius = AIR_EARTH + height;
        struct air_amount here = air_density(height), way = passed;
        // The sine of the sun's height at this point, where the horizon differs from the eye's.
        double sine = (AIR_EARTH * sun + distance * (view * sun + level)) / radius;
        double share[AIR_WAVES] = {0.0}, again[AIR_WAVES];
        way.air += 0.5 * step * here.air;
        way.dust += 0.5 * step * here.dust;
        way.ozone += 0.5 * step * here.ozone;
        air_add_sunlight(radius, sine, way, ozone, share);
        for (int w = 0; w < AIR_WAVES; w++) {
            shares->air[w] += step * share[w] * here.air * air_depth(w);
            shares->dust[w] += step * share[w] * here.dust * air_dust_depth(w) * AIR_DUST_KEPT;
            again[w] = step * air_share_through(w, way, ozone) *
                       (here.air * air_depth(w) + here.dust * air_dust_depth(w) * AIR_DUST_KEPT);
        }
        air_add_scattered(height, sine, ozone, again, shares->more);
        passed.air += step * here.air;
        passed.dust += step * here.dust;
        passed.ozone += step * here.ozone;
    }
}

struct air_light air_scattered(double sun, double view, double azimuth, double ozone)
{
    struct air_light light = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    struct air_shares shares;
    air_shares(sun, view, azimuth, ozone, &shares);
    for (int w = 0; w < AIR_WAVES; w++) {
        add_wave(w, shares.air[w], light.air);
        add_wave(w, shares.dust[w], light.dust);
        add_wave(w, shares.more[w], light.more);
    }
    return light;
}

void air_sunlight(double sun, double colour[3])
{
    colour[0] = colour[1] = colour[2] = 0.0;
    if (sun >= 0.0)
        for (int w = 0; w < AIR_WAVES; w++)
            add_wave(w, air_share_through(w, air_amount_up(AIR_EARTH, sun), 1.0) / AIR_PI, colour);
}

// ---- The tables ----

// 0 if x is far below 0, x if x is far above 0, and a smooth transition in between.
static double beyond(double x)
{
    return 0.5 * (x + sqrt(x * x + 0.0004));
}

struct air_scale air_scale(double sun, double row)
{
    // Each kind of light has three rows: red, green and blue.
    static const double fit[3][3][7] = {{{6.72, 0.159, 67.83, 4.369, 109.6, 1.222, 0.2395},
                                         {6.92, 0.206, 69.22, 3.697, 95.2, 1.282, 0.3577},
                                         {7.07, 0.243, 67.35, 1.829, 82.36, -1.065, 0.9554}},
                                        {{5.60, 0.224, 195.4, 4.805, 0.0, -0.722, 0.0566},
                                         {5.60, 0.317, 246.6, 4.725, 0.0, -0.596, 0.1568},
                                         {4.62, 0.300, 290.0, 4.600, 0.0, -0.600, 0.3300}},
                                        {{1.05, 0.193, 73.83, 4.599, 8.42, 0.0706, 0.0450},
                                         {1.68, 0.201, 77.35, 4.292, -0.27, 0.789, 0.0744},
                                         {2.17, 0.215, 78.63, 2.956, -3.81, 0.924, 0.0687}}};
    const double log2 = 0.69314718055994531;
    double low = 1.0 / ((sun > 0.0 ? sun : 0.0) + 0.068), foot = 1.0 / (1.0 + 114.0 * row * row);
    double shaded = beyond(-sun - 0.008), deep[3] = {beyond(-sun - 0.05), shaded, shaded};
    struct air_scale scale = {{0.0}, {0.0}, {0.0}};
    for (int i = 0; i < 3 * 3; i++) {
        const double *k = fit[i / 3][i % 3], d = deep[i / 3];
        double *one = i < 3 ? scale.air : (i < 6 ? scale.dust : scale.more);
        one[i % 3] = paint_exp(log2 * (k[0] - k[1] * low - k[2] * d - row * (k[3] + k[4] * d) -
                                       foot * (k[5] + k[6] * low)));
    }
    return scale;
}

// The light at a point of a table. A table is painted from its top row down, and the light computed
// for each point of the top storey is needed again in the storeys below, so it is stored.
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
    double column = floor(u * AIR_COLUMNS) / (AIR_COLUMNS - 1), y = floor(v * 3 * AIR_ROWS);
    int storey = (int)(y / AIR_ROWS);
    double row = (y - AIR_ROWS * storey) / (AIR_ROWS - 1);
    double sun = air_drawn_back(lowest + column * (1.0 - lowest), AIR_SUN_WIDTH);
    struct air_light light = light_once(sun, row, azimuth, ozone, (int)(u * AIR_COLUMNS));
    struct air_scale scale = air_scale(sun, row);
    double *part = storey == 0 ? light.air : (storey == 1 ? light.dust : light.more);
    const double *one = storey == 0 ? scale.air : (storey == 1 ? scale.dust : scale.more);
    double all = ozone > 0.0 ? 1.0 : 0.25; // without ozone there is up to three times as much light
    for (int c = 0; c < 3; c++)
        part[c] *= all;
    double blue = part[2] / one[2];
    int byte = paint_byte(blue); // the next line rounds it down; value[3] contains the rest
    byte -= byte > 0 && paint_light(byte) > blue ? 1 : 0;
    value[0] = part[0] / one[0];
    value[1] = part[1] / one[1];
    value[2] = paint_light(byte);
    value[3] = 128.0 / 255.0 + (blue - value[2]) * one[2] / (AIR_FINE * one[0]);
}

// The air mass of chapter 09's uniform shell.
static double air_mass(double sine)
{
    double climb = 721.5 * sine, horizon = 2.0 * 721.5 + 1.0;
    return horizon / (sqrt(climb * climb + horizon) + climb);
}

// The disc is darker towards its rim, and redder: the rim has the share 1 - DARK of the light of
// the centre. Source: A. N. Cox (editor), 'Allen's astrophysical quantities' (2000), limb
// darkening, the linear term at 680, 550 and 440 nm.
static const double DARK[3] = {0.47, 0.60, 0.74};

void air_sun_table(double u, double v, double value[3])
{
    double q = floor(u * SUN_COLUMNS) / (SUN_COLUMNS - 1), x = SUN_REACH * q * q;
    double row = floor(v * SUN_ROWS) / (SUN_ROWS - 1), sine = air_drawn_back(row, SUN_ROW_WIDTH);
    double mass = air_mass(sine), scale = 15.0 * paint_exp(-0.1 * mass), colour[3];
    double rim = x < 1.0 ? sqrt(1.0 - x * x) : 0.0, left = 1.0 - x * x / (SUN_REACH * SUN_REACH);
    air_sunlight(sine, colour);
    for (int c = 0; c < 3; c++) {
        // The mean over the disc, 1 - DARK / 3 times the light of the centre, must equal the sun's
        // light.
        double middle = colour[c] / (1.0 - DARK[c] / 3.0) / scale;
        value[c] = middle * (x <= 1.0 ? 1.0 - DARK[c] * (1.0 - rim) : mass / 38.0 * left * left);
    }
}
