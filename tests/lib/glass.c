#include "lib/glass.h"

#include <stdio.h>
#include <stdlib.h>

#include "shader/parameter.h"
#include "lib/gpu.h"

double glass_fresnel(double facing, double eta)
{
    double a = acos(fmin(facing, 1.0)), sine = eta * sin(a);
    if (sine >= 1.0)
        return 1.0;
    double b = asin(sine);
    if (a < 1e-9) // the limit as both angles approach 0
        return pow((1.0 - eta) / (1.0 + eta), 2.0);
    double across = sin(a - b) / sin(a + b), along = tan(a - b) / tan(a + b);
    return 0.5 * (across * across + along * along);
}

double glass_schlick(double facing, double straight)
{
    return straight + (1.0 - straight) * pow(1.0 - facing, 5.0);
}

bool glass_refract(struct d3 direction, struct d3 normal, double eta, struct d3 *bent)
{
    double facing = -d3_dot(direction, normal);
    struct d3 across = d3_add(direction, d3_times(facing, normal));
    double sine = d3_length(across), behind = eta * sine;
    if (behind >= 1.0)
        return false;
    double angle = asin(behind);
    struct d3 side = sine > 0.0 ? d3_times(1.0 / sine, across) : d3(0.0, 0.0, 0.0);
    *bent = d3_sub(d3_times(sin(angle), side), d3_times(cos(angle), normal));
    return true;
}

bool glass_march(glass_distance distance, struct mirror_ray ray, double side,
                 const double from_to[2], double threshold, int max_steps, double *t)
{
    *t = from_to[0];
    for (int step = 0; step < max_steps && *t < from_to[1]; step++) {
        double d = side * distance(mirror_at(ray, *t));
        if (d < threshold)
            return true;
        *t += d;
    }
    return false;
}

struct mirror_ray glass_leaving(struct d3 p, struct d3 normal, struct d3 direction, double offset)
{
    double side = d3_dot(normal, direction) > 0.0 ? offset : -offset;
    return (struct mirror_ray){d3_add(p, d3_times(side, normal)), direction};
}

double glass_index(double a, double b, double wavelength)
{
    return a + b / (wavelength * wavelength);
}

// ---- Colours ----

static double bell(double x, double middle, double below, double above)
{
    double part = (x - middle) * (x < middle ? below : above);
    return exp(-0.5 * part * part);
}

static void screen_colour(double wavelength, double colour[3])
{
    double w = 1000.0 * wavelength;
    double x = 1.056 * bell(w, 599.8, 0.0264, 0.0323) + 0.362 * bell(w, 442.0, 0.0624, 0.0374) -
               0.065 * bell(w, 501.1, 0.0490, 0.0382);
    double y = 0.821 * bell(w, 568.8, 0.0213, 0.0247) + 0.286 * bell(w, 530.9, 0.0613, 0.0322);
    double z = 1.217 * bell(w, 437.0, 0.0845, 0.0278) + 0.681 * bell(w, 459.0, 0.0385, 0.0725);
    colour[0] = fmax(3.2404542 * x - 1.5371385 * y - 0.4985314 * z, 0.0);
    colour[1] = fmax(-0.9692660 * x + 1.8760108 * y + 0.0415560 * z, 0.0);
    colour[2] = fmax(0.0556434 * x - 0.2040259 * y + 1.0572252 * z, 0.0);
}

void glass_wave_colour(double wavelength, double colour[3])
{
    enum { WAVES = 600 };
    double mean[3] = {0.0, 0.0, 0.0}, part[3];
    for (int k = 0; k < WAVES; k++) {
        screen_colour(0.4 + 0.3 * (k + 0.5) / WAVES, part);
        for (int c = 0; c < 3; c++)
            mean[c] += part[c] / WAVES;
    }
    screen_colour(wavelength, colour);
    for (int c = 0; c < 3; c++)
        colour[c] /= mean[c];
}

double glass_drop_turn(double offset, double index, int mirrored)
{
    double outside = asin(offset), inside = asin(offset / index);
    return mirrored * MIRROR_PI + 2.0 * outside - 2.0 * (mirrored + 1) * inside;
}

// ---- The white furnace ----

static float *furnace(int surfaces)
{
    struct renderer_inputs inputs = {
        .width = 640, .height = 360, .samples = 1, .camera = gpu_open_chapter("17_glass")};
    gpu_set("white", 1.0);
    gpu_set("surfaces", surfaces);
    return gpu_numbers(&inputs);
}

struct glass_rest glass_furnace(int surfaces)
{
    float *glass = furnace(1), *values = furnace(surfaces);
    int pixels = 0, dark = 0;
    double missing = 0.0;
    for (int i = 0; i < 640 * 360; i++) {
        if ((double)glass[4 * i] > 0.999) // with one surface, all glass is dark
            continue;
        double lacks = 1.0 - mirror_decode((double)values[4 * i]);
        pixels++;
        dark += lacks > 1.0 / 255.0;
        missing += lacks;
    }
    free(glass);
    free(values);
    return (struct glass_rest){dark / fmax(pixels, 1.0), missing / fmax(pixels, 1.0)};
}

int glass_print(void)
{
    static const double angles[] = {0.0, 30.0, 45.0, 60.0, 70.0, 80.0, 85.0, 88.0};
    static const double indices[] = {1.333, 1.5168, 1.7283};
    printf("# reflected share, from air to glass of index 1.5168, and inside the glass at the "
           "angle of the refracted ray\ndegrees,exact,schlick,degrees_inside,exact_inside\n");
    for (size_t i = 0; i < sizeof angles / sizeof angles[0]; i++) {
        double n = indices[1], angle = angles[i] * MIRROR_PI / 180.0, behind = asin(sin(angle) / n);
        printf("%g,%.4f,%.4f,%.2f,%.4f\n", angles[i], glass_fresnel(cos(angle), 1.0 / n),
               glass_schlick(cos(angle), pow((n - 1.0) / (n + 1.0), 2.0)),
               behind * 180.0 / MIRROR_PI, glass_fresnel(cos(behind), n));
    }
    printf("# Schlick's largest error, and its angle\nindex,error,degrees,critical_angle\n");
    for (int i = 0; i < 3; i++) {
        double n = indices[i], worst = 0.0, at = 0.0, straight = pow((n - 1.0) / (n + 1.0), 2.0);
        for (double a = 0.05; a < 90.0; a += 0.05) {
            double c = cos(a * MIRROR_PI / 180.0);
            double error = glass_schlick(c, straight) - glass_fresnel(c, 1.0 / n);
            at = fabs(error) > fabs(worst) ? a : at;
            worst = fabs(error) > fabs(worst) ? error : worst;
        }
        printf("%g,%.4f,%.1f,%.2f\n", n, worst, at, asin(1.0 / n) * 180.0 / MIRROR_PI);
    }
    printf("# for each wavelength in micrometres: the indices of crown and flint glass, the least "
           "deviation by a flint prism of 60 degrees, and the angle of the rainbow\n"
           "wavelength,crown,flint,deviation,rainbow\n");
    for (int k = 0; k <= 6; k++) {
        double wave = 0.40 + 0.05 * k, flint = glass_index(1.6894, 0.01341, wave);
        double water = glass_index(1.3240, 0.00310, wave),
               cosine = sqrt((water * water - 1.0) / 3.0);
        printf("%.2f,%.4f,%.4f,%.2f,%.2f\n", wave, glass_index(1.5046, 0.00420, wave), flint,
               2.0 * asin(0.5 * flint) * 180.0 / MIRROR_PI - 60.0,
               180.0 - glass_drop_turn(sqrt(1.0 - cosine * cosine), water, 1) * 180.0 / MIRROR_PI);
    }
    printf("# in a white world: the share of the glass pixels that are not white, and the missing "
           "light, averaged over all glass pixels\nsurfaces,pixels,light\n");
    for (int surfaces = 2; surfaces <= 20; surfaces += 2) {
        struct glass_rest rest = glass_furnace(surfaces);
        printf("%d,%.4f,%.5f\n", surfaces, rest.pixels, rest.mean);
    }
    return 0;
}
