// Samples of the squares of a plane; see checkers.h.
#include <math.h>
#include <stdlib.h>

#include "lib/checkers.h"

#define FRAMING 4.0
#define TILE    0.5

const struct checkers_view checkers_views[3] = {
    {{.position = {0.3f, 1.4f, 4.0f}, .pan = 0.0f, .tilt = -14.0f}, 0.0, 20.0},
    {{.position = {1.5f, 2.2f, 3.0f}, .pan = -24.0f, .tilt = -31.0f}, 1.0, 20.0},
    {{.position = {-1.0f, 1.1f, 3.5f}, .pan = 15.0f, .tilt = -20.0f}, 0.5, 45.0},
};

static struct mirror_ray ray_of(const struct checkers_view *view, double x, double y)
{
    struct camera_basis basis = camera_basis_of(&view->camera);
    double sx = mirror_screen_x(x, CHECKERS_WIDTH, CHECKERS_HEIGHT),
           sy = mirror_screen_y(y, CHECKERS_HEIGHT);
    double u = view->orthographic;
    struct d3 v = d3_add(d3_times(sx, d3_of(basis.right)), d3_times(sy, d3_of(basis.up)));
    struct d3 direction =
        d3_add(d3_times((1.0 - u) / MIRROR_FOCAL_LENGTH, v), d3_of(basis.forward));
    return (struct mirror_ray){
        d3_add(d3_of(view->camera.position), d3_times(u * FRAMING / MIRROR_FOCAL_LENGTH, v)),
        d3_unit(direction)};
}

// Find the position in the pattern that is seen at a position in the picture. Returns false if the
// ray does not meet the plane.
static bool tile_of(const struct checkers_view *view, double x, double y, double tile[2])
{
    struct mirror_ray ray = ray_of(view, x, y);
    if (ray.direction.y >= 0.0)
        return false;
    struct d3 p = mirror_at(ray, -ray.origin.y / ray.direction.y);
    double angle = view->turn * MIRROR_PI / 180.0;
    tile[0] = (cos(angle) * p.x + sin(angle) * p.z) / TILE;
    tile[1] = (cos(angle) * p.z - sin(angle) * p.x) / TILE;
    return true;
}

bool checkers_rectangle(const struct checkers_view *view, int x, int y, double low[2],
                        double high[2])
{
    low[0] = low[1] = HUGE_VAL;
    high[0] = high[1] = -HUGE_VAL;
    for (int i = 0; i < 4; i++) {
        double tile[2];
        if (!tile_of(view, x + i % 2, y + i / 2, tile))
            return false;
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], tile[k]);
            high[k] = fmax(high[k], tile[k]);
        }
    }
    return true;
}

static bool even(const double tile[2])
{
    return fmod(floor(tile[0]) + floor(tile[1]), 2.0) == 0.0;
}

// The share of positions in even cells, among `side` positions along one axis.
static double even_share(double low, double high, int side)
{
    int count = 0;
    for (int i = 0; i < side; i++)
        count += fmod(floor(low + (high - low) * (i + 0.5) / side), 2.0) == 0.0;
    return count / (double)side;
}

double checkers_of_grid(const double low[2], const double high[2], int side)
{
    double x = even_share(low[0], high[0], side), y = even_share(low[1], high[1], side);
    return x * y + (1.0 - x) * (1.0 - y);
}

// Reverse the six bits of a number from 0 to 63, and divide the result by 64.
static double reversed(int i)
{
    double value = 0.0;
    for (int bit = 0; bit < 6; bit++)
        value += (i >> bit & 1) / (double)(2 << bit);
    return value;
}

double checkers_of_samples(const double low[2], const double high[2])
{
    const double n = CHECKERS_SIDE, half = 0.5 / n;
    int count = 0;
    for (int i = 0; i < CHECKERS_SIDE; i++)
        for (int k = 0; k < CHECKERS_SIDE; k++) {
            double x = (i + reversed(k) + half) / n, y = (k + reversed(i) + half) / n;
            double tile[2] = {low[0] + (high[0] - low[0]) * x, low[1] + (high[1] - low[1]) * y};
            count += even(tile);
        }
    return count / (n * n);
}

double checkers_of_pixel(const struct checkers_view *view, int x, int y)
{
    const double n = CHECKERS_SIDE;
    int count = 0;
    for (int i = 0; i < CHECKERS_SIDE; i++)
        for (int k = 0; k < CHECKERS_SIDE; k++) {
            double tile[2];
            if (tile_of(view, x + (i + (k + 0.5) / n) / n, y + (k + (i + 0.5) / n) / n, tile))
                count += even(tile);
        }
    return count / (n * n);
}

bool checkers_hidden(const struct checkers_view *view, int x, int y)
{
    for (int i = 0; i < 9; i++) {
        struct mirror_ray ray = ray_of(view, x + 2.0 * (i % 3) - 1.5, y + 2.0 * (i / 3) - 1.5);
        struct mirror_ray a = {d3_sub(ray.origin, d3(-0.8, 0.6, 0.0)), ray.direction};
        struct mirror_ray b = {d3_sub(ray.origin, d3(0.7, 0.35, 0.9)), ray.direction};
        double t[2];
        if (mirror_ball_crossing(a, 0.62, t) || mirror_ball_crossing(b, 0.37, t))
            return true;
    }
    return false;
}

double *checkers_shown(const struct checkers_view *view, int way)
{
    struct renderer_inputs inputs = {
        .width = CHECKERS_WIDTH, .height = CHECKERS_HEIGHT, .samples = 1, .camera = view->camera};
    gpu_open_shader("chapters/experiments/11_checkers.frag");
    gpu_set("orthographic", view->orthographic);
    gpu_set("turn", view->turn);
    gpu_set("way", way);
    float *values = gpu_numbers(&inputs);
    double *share = malloc(sizeof *share * CHECKERS_WIDTH * CHECKERS_HEIGHT);
    for (int i = 0; share != NULL && i < CHECKERS_WIDTH * CHECKERS_HEIGHT; i++)
        share[i] = (mirror_decode((double)values[4 * i + 1]) - 0.02) / 0.78;
    free(values);
    return share;
}
