#include "lib/sky_table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "lib/air.h"
#include "lib/gpu.h"
#include "lib/mirror.h"
#include "textures/air.h"

bool sky_table_open(void)
{
    return gpu_load("tests/shaders/sky_table.frag");
}

double sky_table_sun(int column)
{
    double s = (double)column / (SKY_SUNS - 1);
    return -0.14 + 1.14 * s * s;
}

float *sky_table_read(int way, int function, double number, bool encoded)
{
    struct renderer_inputs inputs = {
        .width = SKY_SUNS, .height = SKY_HEIGHTS, .time = (float)function, .samples = 1};
    inputs.mouse[0] = (float)number;
    gpu_set("way", way);
    gpu_set("encoded", encoded);
    float *values = gpu_numbers(&inputs);
    for (int i = 0; i < 4 * SKY_SUNS * SKY_HEIGHTS; i++)
        values[i] = fmaxf(exp2f(60.0f * values[i] - 30.0f) - 1e-9f, 0.0f);
    return values;
}

// domeStops of chapters/experiments/18_ways.glsl, in double precision.
static double stops(double sun)
{
    double high = fmax(sun, 0.0), deep = fmax(-sun, 0.0);
    double bright = 0.03 - 0.37 / (high + 0.1) - deep * (83.5 - 42.0 * exp(-204.0 * deep * deep));
    return -2.0 - 0.85 * log2(exp2(bright) + 6e-8);
}

static double shown(double light, double sun)
{
    return 255.0 * mirror_encode(fmin(fmax(exp2(stops(sun)) * light, 0.0), 1.0));
}

struct truth {
    double azimuth;
    double light[SKY_HEIGHTS][SKY_SUNS][3];
};

static double height_of(int row)
{
    double s = (double)row / (SKY_HEIGHTS - 1);
    return s * s;
}

// The integral at an azimuth, which is given by its cosine. The integration takes most of the time,
// so the result is stored for the next method.
static const struct truth *truth_at(double azimuth)
{
    static struct truth truth = {.azimuth = 2.0};
    if (truth.azimuth == azimuth)
        return &truth;
    truth.azimuth = azimuth;
    for (int i = 0; i < SKY_SUNS; i++)
        for (int j = 0; j < SKY_HEIGHTS; j++)
            air_all_of(sky_table_sun(i), height_of(j), azimuth, 1.0, truth.light[j][i]);
    return &truth;
}

struct sky_table_error sky_table_error(int way, double azimuth, bool encoded)
{
    struct sky_table_error error = {.most = -1.0};
    float *values = sky_table_read(way, 0, azimuth, encoded);
    int count = 0, over = 0;
    const struct truth *at = truth_at(azimuth);
    for (int i = 0; i < SKY_SUNS; i++)
        for (int j = 0; j < SKY_HEIGHTS; j++) {
            const double *truth = at->light[j][i];
            double sun = sky_table_sun(i);
            double largest = 0.0;
            for (int c = 0; c < 3; c++) {
                double value = (double)values[4 * (SKY_SUNS * j + i) + c];
                double off = fabs(shown(value, sun) - shown(truth[c], sun));
                error.mean += off / 3.0;
                largest = fmax(largest, off);
                if (off > error.most) {
                    error.most = off;
                    error.sun = asin(sun) * 180.0 / MIRROR_PI;
                    error.height = asin(height_of(j)) * 180.0 / MIRROR_PI;
                }
            }
            count++;
            over += largest > 1.0;
            error.by_day =
                sun >= sin(5.0 * MIRROR_PI / 180.0) ? fmax(error.by_day, largest) : error.by_day;
        }
    error.mean /= count;
    error.over = (double)over / count;
    free(values);
    return error;
}

// ---- For build/tests/measure ----

static long bytes_of(const char *name)
{
    char path[8192];
    snprintf(path, sizeof path, "%s/shaders/textures/%s.png", gpu.root, name);
    FILE *file = fopen(path, "rb");
    long bytes = -1;
    if (file != NULL) {
        bytes = fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
        fclose(file);
    }
    return bytes;
}

double sky_measured_lux(double degrees)
{
    static const double fit[6][5] = {
        {20.0, 3.74, 3.97, -4.07, 1.47},         {5.0, 3.05, 13.28, -45.98, 64.33},
        {-0.8, 2.88, 22.26, -207.64, 1034.30},   {-5.0, 2.88, 21.81, -258.11, -858.36},
        {-12.0, 2.70, 12.17, -431.69, -1899.83}, {-18.0, 13.84, 262.72, 1447.42, 2797.93}};
    int i = 0;
    while (i < 5 && degrees < fit[i][0])
        i++;
    double x = degrees / 90.0;
    return pow(10.0, fit[i][1] + x * (fit[i][2] + x * (fit[i][3] + x * fit[i][4])));
}

struct sky_lux sky_lux(double degrees)
{
    enum { HEIGHTS = 12, AROUND = 12 };
    double sun = sin(degrees * MIRROR_PI / 180.0), light[3];
    struct sky_lux lux = {.night = MIRROR_PI * 4000.0 * 5e-8};
    air_sunlight(sun, light);
    lux.sun = MIRROR_PI * air_luminance(light) * fmax(sun, 0.0);
    for (int i = 0; i < HEIGHTS * AROUND; i++) {
        double view = sqrt((i / AROUND + 0.5) / HEIGHTS),
               azimuth = cos(MIRROR_PI * (i % AROUND + 0.5) / AROUND);
        air_light_of(sun, view, azimuth, 1.0, 120.0, light);
        lux.once += MIRROR_PI * air_luminance(light) / (HEIGHTS * AROUND);
    }
    air_ambient_of(sun, light);
    lux.more = MIRROR_PI * air_luminance(light) - lux.once;
    return lux;
}

static void print_hours(void)
{
    static const double suns[] = {48.4, 20.0, 5.0,   0.0,   -0.83, -4.0,
                                  -6.0, -8.0, -10.0, -12.0, -15.0, -18.0};
    printf(
        "# light on level ground, lux: from the sky after one scattering and after more, from the "
        "sun, from all these and the night sky, and as measured\n");
    printf("sun,once,more,sun,all,measured\n");
    for (size_t i = 0; i < sizeof suns / sizeof suns[0]; i++) {
        struct sky_lux lux = sky_lux(suns[i]);
        printf("%g,%.3g,%.3g,%.3g,%.3g,%.3g\n", suns[i], lux.once, lux.more, lux.sun,
               lux.once + lux.more + lux.sun + lux.night, sky_measured_lux(suns[i]));
    }
    printf("# luminance of the zenith, cd/m^2, and its colour\n");
    printf("sun,zenith,x,y,no ozone,x,y\n");
    for (size_t i = 0; i < 10; i++) {
        printf("%g", suns[i]);
        for (int ozone = 1; ozone >= 0; ozone--) {
            double light[3], xy[2] = {0.0, 0.0};
            air_all_of(sin(suns[i] * MIRROR_PI / 180.0), 1.0, 1.0, ozone, light);
            air_chromaticity(light, xy);
            printf(",%.3g,%.3f,%.3f", air_luminance(light), xy[0], xy[1]);
        }
        printf("\n");
    }
    printf(
        "# all the light of the zenith divided by the light scattered once, at 560 nm, from "
        "random paths, with the sun 48.4 degrees high, for a ground of albedo 0, 0.15 and 0.3\n");
    for (int i = 0; i < 3; i++) {
        struct air_paths paths =
            air_paths(sin(48.4 * MIRROR_PI / 180.0), 1.0, 1.0, 0.15 * i, 8, 50000);
        printf("%.2f,%.3f\n", 0.15 * i, 1.0 + paths.more / paths.once);
    }
}

int sky_table_print(void)
{
    static const char *const names[] = {"tables", "angle", "dot product", "chapter 09"};
    if (!sky_table_open())
        return 1;
    printf(
        "# difference from the integral in steps of 1/255, exposed and encoded; the sun is from -8 "
        "to 90 degrees high, by day at least 5\n");
    printf("azimuth,way,mean,most,over 1,at sun,at height,most by day\n");
    for (int azimuth = 0; azimuth <= 180; azimuth += 45)
        for (int way = 0; way < 4; way++) {
            struct sky_table_error e =
                sky_table_error(way, cos(azimuth * MIRROR_PI / 180.0), false);
            printf("%d,%s,%.2f,%.1f,%.1f %%,%.1f,%.1f,%.1f\n", azimuth, names[way], e.mean, e.most,
                   100.0 * e.over, e.sun, e.height, e.by_day);
        }
    print_hours();
    printf("# bytes on disk: sky_sunward %ld, sky_away %ld, sun_halo %ld\n",
           bytes_of("sky_sunward"), bytes_of("sky_away"), bytes_of("sun_halo"));
    return 0;
}
