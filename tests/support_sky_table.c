#include "support_sky_table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "support_air.h"
#include "support_gpu.h"
#include "support_mirror.h"

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
    char setting[2][32];
    struct renderer_inputs inputs = {
        .width = SKY_SUNS, .height = SKY_HEIGHTS, .time = (float)function, .samples = 1};
    inputs.mouse[0] = (float)number;
    snprintf(setting[0], sizeof setting[0], "way=%d", way);
    snprintf(setting[1], sizeof setting[1], "encoded=%s", encoded ? "true" : "false");
    bool set = parameters_assign(&gpu.renderer.parameters, setting[0]) &&
               parameters_assign(&gpu.renderer.parameters, setting[1]);
    float *values = set ? gpu_numbers(&inputs) : NULL;
    for (int i = 0; values != NULL && i < 4 * SKY_SUNS * SKY_HEIGHTS; i++)
        values[i] = fmaxf(exp2f(60.0f * values[i] - 30.0f) - 1e-9f, 0.0f);
    return values;
}

// As hourStops and skyBrightness of shaders/sky_table.glsl.
static double stops(double sun)
{
    double high = fmax(sun, 0.0), deep = fmax(-sun, 0.0);
    double bright = -0.41 - 0.352 / (high + 0.1) - 36.0 * deep - 305.0 * deep * deep;
    return -2.3 - 0.85 * log2(exp2(bright) + 6e-8);
}

static double shown(double light, double sun)
{
    return 255.0 * mirror_encode(fmin(fmax(exp2(stops(sun)) * light, 0.0), 1.0));
}

enum { EVERY_SUN = 3, EVERY_HEIGHT = 2 }; // of the places: they lie on all parts of the cells

struct truth {
    double azimuth;
    double light[SKY_HEIGHTS / EVERY_HEIGHT][SKY_SUNS / EVERY_SUN + 1][3];
};

static double height_of(int row)
{
    double s = (double)row / (SKY_HEIGHTS - 1);
    return s * s;
}

// The integral at an angle to the sun, kept for the next way to mix: it is what takes the time.
static const struct truth *truth_at(double azimuth)
{
    static struct truth truth = {.azimuth = 2.0};
    if (truth.azimuth == azimuth)
        return &truth;
    truth.azimuth = azimuth;
    for (int i = 0; i < SKY_SUNS; i += EVERY_SUN)
        for (int j = 0; j < SKY_HEIGHTS; j += EVERY_HEIGHT)
            air_light_of(sky_table_sun(i), height_of(j), azimuth, 1.0, 120.0,
                         truth.light[j / EVERY_HEIGHT][i / EVERY_SUN]);
    return &truth;
}

struct sky_table_error sky_table_error(int way, double azimuth, bool encoded)
{
    struct sky_table_error error = {.most = -1.0};
    float *values = sky_table_read(way, 0, azimuth, encoded);
    int count = 0, over = 0;
    const struct truth *at = truth_at(azimuth);
    for (int i = 0; values != NULL && i < SKY_SUNS; i += EVERY_SUN)
        for (int j = 0; j < SKY_HEIGHTS; j += EVERY_HEIGHT) {
            const double *truth = at->light[j / EVERY_HEIGHT][i / EVERY_SUN];
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
    error.mean /= count > 0 ? count : 1;
    error.over = count > 0 ? (double)over / count : 1.0;
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

static void print_hours(void)
{
    static const double suns[] = {48.4, 20.0, 5.0, 0.0, -0.83, -4.0, -6.0, -12.0};
    printf("# the integral: light of the sky on level ground, and the zenith\n");
    printf("sun,lux,zenith_cd,x,y,zenith_cd_no_ozone,x_no_ozone,y_no_ozone\n");
    for (size_t i = 0; i < sizeof suns / sizeof suns[0]; i++) {
        double sun = sin(suns[i] * MIRROR_PI / 180.0), light[3], xy[2] = {0.0, 0.0};
        air_ambient_of(sun, light);
        printf("%g,%.3g", suns[i], MIRROR_PI * air_luminance(light));
        for (int ozone = 1; ozone >= 0; ozone--) {
            air_light_of(sun, 1.0, 1.0, ozone, 120.0, light);
            if (air_luminance(light) > 0.0)
                air_chromaticity(light, xy);
            printf(",%.3g,%.3f,%.3f", air_luminance(light), xy[0], xy[1]);
            xy[0] = xy[1] = 0.0;
        }
        printf("\n");
    }
}

int sky_table_print(void)
{
    static const char *const names[] = {"tables", "angle", "dot product", "chapter 09"};
    if (!sky_table_open())
        return 1;
    printf("# off the integral, steps of 255, exposed and encoded; sun from -8 to 90 degrees, by "
           "day from 5\n");
    printf("azimuth,way,mean,most,over 1,at sun,at height,most by day\n");
    for (int azimuth = 0; azimuth <= 180; azimuth += 45)
        for (int way = 0; way < 4; way++) {
            struct sky_table_error e =
                sky_table_error(way, cos(azimuth * MIRROR_PI / 180.0), false);
            if (e.most < 0.0)
                return 1;
            printf("%d,%s,%.2f,%.1f,%.1f %%,%.1f,%.1f,%.1f\n", azimuth, names[way], e.mean, e.most,
                   100.0 * e.over, e.sun, e.height, e.by_day);
        }
    print_hours();
    printf("# bytes on disk: sky_sunward %ld, sky_away %ld, sun_halo %ld\n",
           bytes_of("sky_sunward"), bytes_of("sky_away"), bytes_of("sun_halo"));
    return 0;
}
