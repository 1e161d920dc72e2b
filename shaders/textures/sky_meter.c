// sky_meter.c - what an exposure meter on a camera reads of a clear sky, over the sun's height: a
// camera that looks towards the sun, away from it, and sideways. Declared as linear and clamp. The
// lower row has the first two readings, the upper row has the third; each reading is two bytes, the
// high one first. shaders/sky_table.glsl reads the table.
#include <math.h>

#include "air.h"
#include "paint.h"

// The part of the sky that the meter sees: from 5 degrees to 22 degrees high, and 40 degrees to
// either side of where the camera looks. These are sines, and so are the steps between the points
// at which the sky is evaluated.
#define LOW   0.0872
#define HIGH  0.3746
#define ASIDE 0.6428
enum { ACROSS = 8, UP = 4 };

// The readings are logarithms to base 2 of the light divided by that of the whole sky, from FIRST
// to FIRST + RANGE.
#define FIRST (-2.0)
#define RANGE 8.0

static double square(double x)
{
    return x * x;
}

// Henyey and Greenstein's share for the cosine c, as phaseDust of shaders/sky_table.glsl.
static double phase_dust(double c)
{
    const double g = 0.76, x = 1.0 / (1.0 + g * g - 2.0 * g * c);
    return (1.0 - g * g) / (4.0 * AIR_PI) * x * sqrt(x);
}

// The brightness of the sky in a direction.
//   azimuth  cosine of the horizontal angle to the sun
static double bright_sky(double sun, double view, double azimuth)
{
    static const double weight[3] = {0.2126, 0.7152, 0.0722}; // IEC 61966-2-1
    struct air_light light = air_scattered(sun, view, azimuth, 1.0);
    double c = view * sun + sqrt((1.0 - view * view) * (1.0 - sun * sun)) * azimuth, sum = 0.0;
    for (int k = 0; k < 3; k++)
        sum += weight[k] * (3.0 / (16.0 * AIR_PI) * (1.0 + c * c) * light.air[k] +
                            phase_dust(c) * light.dust[k] + light.more[k]);
    return sum;
}

// What the meter reads: the mean over its part of the sky of what a screen shows, taken as the
// square root of the light.
//   facing  cosine of the horizontal angle between the camera's direction and the sun: 1, 0 or -1
static double reading(double sun, double facing)
{
    double sum = 0.0;
    for (int j = 0; j < UP; j++)
        for (int i = 0; i < ACROSS; i++) {
            double view = LOW + (HIGH - LOW) * (j + 0.5) / UP,
                   x = ASIDE * (2.0 * (i + 0.5) / ACROSS - 1.0);
            sum += sqrt(
                bright_sky(sun, view, facing * sqrt(1.0 - x * x) + (1.0 - facing * facing) * x));
        }
    return square(sum / (UP * ACROSS));
}

// The logarithm to base 2 of x > 0, using only + - * /, so that it is the same on every machine.
static double log_2(double x)
{
    double whole = 0.0, sum = 0.0;
    for (; x < 1.0; x *= 2.0)
        whole -= 1.0;
    for (; x >= 2.0; x /= 2.0)
        whole += 1.0;
    double t = (x - 1.0) / (x + 1.0), power = t;
    for (int n = 1; n < 40; n += 2, power *= t * t)
        sum += power / n;
    return whole + sum * 2.0 / 0.69314718055994531;
}

// skyBrightness of shaders/sky_table.glsl.
static double sky_brightness(double sun)
{
    double high = sun > 0.0 ? sun : 0.0, deep = sun < 0.0 ? -sun : 0.0;
    return 0.03 - 0.37 / (high + 0.1) - deep * (83.5 - 42.0 * paint_exp(-204.0 * deep * deep));
}

static void put_reading(double sun, double facing, double bytes[2])
{
    double share = (log_2(reading(sun, facing)) - sky_brightness(sun) - FIRST) / RANGE;
    int code = (int)(65535.0 * share + 0.5);
    bytes[0] = code / 256 / 255.0;
    bytes[1] = code % 256 / 255.0;
}

static void table(double u, double v, double value[4])
{
    double lowest = air_drawn_out(AIR_LOWEST_SUN, AIR_SUN_WIDTH),
           column = floor(u * AIR_COLUMNS) / (AIR_COLUMNS - 1);
    double sun = air_drawn_back(lowest + column * (1.0 - lowest), AIR_SUN_WIDTH);
    put_reading(sun, v < 0.5 ? 1.0 : 0.0, value);
    value[2] = value[3] = 0.0;
    if (v < 0.5)
        put_reading(sun, -1.0, value + 2);
}

int main(void)
{
    return paint_texture(AIR_COLUMNS, 2, 1, PAINT_BYTES, table);
}
