// test_scene_08.c - chapter 08 in double precision: pixels of its picture, the march of its rays in
// every projection, and the plane of its slice.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "../common/picture/slice.h"
#include "support_pixels.h"

#define STEM   "08_orthographic_view"
#define SHADER "chapters/08_orthographic_view.frag"

static const struct d3 low = {-1.3, -0.4, -4.8}, high = {6.3, 3.55, 2.8};
static const double framing = 9.5, wall = 0.5, top = 0.5, climb = 3.0, deep = 0.1, water = 0.32;

// ---- The scene, told once more ----

static double max2(double a, double b)
{
    return a > b ? a : b;
}

static double max3(double a, double b, double c)
{
    return max2(a, max2(b, c));
}

static double beside_loop(struct d3 p)
{
    return fabs(max2(fabs(p.x - 2.5) - 2.5, fabs(p.z + 1.0) - 2.0));
}

static double channel(struct d3 p)
{
    double beside = beside_loop(p);
    double walls = max2(beside - wall, p.y - top);
    double missing = p.x - 2.5 < p.z - 0.5 ? 0.5 - p.z : 2.5 - p.x; // the smaller of both
    return max3(walls, missing, -max2(beside - water, top - deep - p.y));
}

static double tower(struct d3 p)
{
    double bed = max2(fabs(p.x < p.z ? p.x : p.z) - water, top + climb - deep - p.y);
    return max2(max3(fabs(p.x) - wall, fabs(p.z) - wall, p.y - top - climb), -bed);
}

// A cube of side 1.1 whose beams are 0.15 thick: outside of it, or inside where two coordinates or
// more are farther than a beam from the faces.
static double frame_at(struct d3 p, double x, double z)
{
    double a = fabs(p.x - x), b = fabs(p.y - 0.55), c = fabs(p.z - z);
    double hole = max3(fmin(a, b), fmin(b, c), fmin(a, c)); // the middle one
    return max2(max3(a, b, c) - 0.55, 0.4 - hole);
}

enum { PLINTH, CHANNEL, TOWER, FRAMES, PARTS };

static double scene_distance(struct d3 p, int *nearest)
{
    double part[PARTS] = {
        [PLINTH] = max3(fabs(p.x - 2.5) - 3.75, fabs(p.z + 1.0) - 3.75, p.y),
        [CHANNEL] = channel(p),
        [TOWER] = tower(p),
        [FRAMES] = fmin(frame_at(p, -0.65, 2.15), frame_at(p, 5.65, -4.15)),
    };
    return mirror_nearest(part, PARTS, nearest);
}

static const struct mirror_scene scene = {.function = scene_distance};

static struct mirror_ray projection_ray(const struct camera *camera, double u, double x, double y)
{
    struct camera_basis basis = camera_basis_of(camera);
    struct d3 v = d3_add(d3_times(x, d3_of(basis.right)), d3_times(y, d3_of(basis.up)));
    struct d3 direction = d3_add(d3_times((1.0 - u) / 2.0, v), d3_of(basis.forward));
    return (struct mirror_ray){d3_add(d3_of(camera->position), d3_times(u * framing / 2.0, v)),
                               d3_unit(direction)};
}

// ---- Its colours ----

static double foam(double along, double aside)
{
    double lane = floor(12.0 * aside), line = 0.5 * along + 0.37 * lane * lane;
    line -= floor(line);
    return mirror_smoothstep(0.75, 0.9, line) * (1.0 - mirror_smoothstep(0.9, 1.0, line));
}

// From one side of the channel to the next, and over the tower's top.
static double stream(struct d3 p, bool on_tower)
{
    double x = p.x - 2.5, z = p.z + 1.0;
    if (on_tower)
        return p.z > wall - 0.02 ? -p.y : -0.5 - p.x;
    return fabs(x) - 2.5 > fabs(z) - 2.0 ? -z : (z > 0.0 ? x : -x);
}

static bool is_water(struct d3 p, int part, double *beside)
{
    bool falls = part == TOWER && p.z > wall - 0.02;
    double level = part == TOWER ? top + climb - deep : top - deep;
    *beside = part == TOWER ? (falls ? p.x : fabs(fmin(p.x, p.z))) : beside_loop(p);
    return (part == TOWER || part == CHANNEL) && fabs(*beside) < water && p.y < level + 0.02 &&
           (falls || p.y > level - 0.02);
}

static struct d3 colour_at(struct d3 p, int part, const char **what)
{
    static const char *const names[PARTS] = {"plinth", "channel", "tower", "frame"};
    double beside;
    *what = names[part];
    if (is_water(p, part, &beside)) {
        double white = 0.25 * foam(stream(p, part == TOWER), beside);
        *what = "water";
        return d3(0.03 + white, 0.26 + white, 0.38 + white);
    }
    if (part == FRAMES)
        return d3(0.72, 0.20, 0.11);
    if (part != PLINTH)
        return d3(0.86, 0.78, 0.67);
    bool odd = ((int)floor(p.x) + (int)floor(p.z)) % 2 != 0;
    return odd ? d3(0.70, 0.52, 0.42) : d3(0.56, 0.36, 0.31);
}

static struct d3 backdrop(double x, double y)
{
    double s = 0.5 + 0.5 * y;
    double rim = mirror_smoothstep(0.285, 0.295, hypot(x - 1.0, y - 0.45));
    struct d3 air =
        d3_add(d3_times(1.0 - s, d3(0.11, 0.21, 0.24)), d3_times(s, d3(0.012, 0.04, 0.08)));
    return d3_add(d3_times(1.0 - rim, d3(0.85, 0.48, 0.22)), d3_times(rim, air));
}

static struct d3 surface_light(struct d3 p, struct d3 normal, struct mirror_sample *sample)
{
    const struct d3 sun = d3(-0.6149, 0.7549, 0.228);
    struct mirror_ray up = {d3_add(p, d3_times(0.02, normal)), sun};
    double caught = mirror_lambert(normal, sun), sky = 0.7 + 0.3 * normal.y;
    sample->faces = caught > 0.0;
    sample->shadowed = sample->faces && mirror_reach(&scene, up, 0.0, 12.0).end == MIRROR_HIT;
    struct d3 light = d3_times(sky, d3(0.13, 0.17, 0.24));
    return sample->shadowed ? light : d3_add(light, d3_times(caught, d3(1.30, 0.95, 0.60)));
}

static struct mirror_sample sample_at(const struct mirror_eye *eye)
{
    struct mirror_ray ray = projection_ray(&eye->camera, 1.0, eye->x, eye->y);
    struct mirror_sample sample = {.what = "backdrop"};
    struct d3 light = backdrop(eye->x, eye->y);
    double t[2];
    if (brute_box_interval(ray, low, high, t)) {
        struct mirror_march hit = mirror_reach(&scene, ray, t[0], t[1]);
        if (hit.end == MIRROR_HIT) {
            int part;
            struct d3 p = mirror_at(ray, hit.t);
            mirror_distance(&scene, p, &part);
            struct d3 colour = colour_at(p, part, &sample.what);
            light = d3_product(colour, surface_light(p, mirror_normal(&scene, p), &sample));
        }
    }
    sample.colour = d3(mirror_encode(light.x), mirror_encode(light.y), mirror_encode(light.z));
    return sample;
}

static const struct mirror_picture picture = {
    .name = STEM, .shader = SHADER, .chapter = STEM, .time = 0.0, .sample = sample_at};

static struct probe probe; // too large for the stack

// ---- Pixels ----

static const struct pixel pixels[] = {
    {STEM, 40, 40, "backdrop-"},  {STEM, 500, 260, "backdrop-"}, {STEM, 560, 330, "backdrop-"},
    {STEM, 294, 96, "frame+"},    {STEM, 318, 72, "frame+"},     {STEM, 298, 280, "frame+"},
    {STEM, 342, 308, "frame+"},   {STEM, 298, 128, "water+"},    {STEM, 290, 152, "water+"},
    {STEM, 298, 188, "water+"},   {STEM, 330, 140, "water+"},    {STEM, 370, 160, "water+"},
    {STEM, 418, 192, "water+"},   {STEM, 310, 156, "plinth#"},   {STEM, 338, 180, "plinth#"},
    {STEM, 286, 116, "channel+"}, {STEM, 410, 168, "channel+"},  {STEM, 406, 196, "channel+"},
    {STEM, 258, 128, "tower+"},   {STEM, 274, 188, "tower+"},    {STEM, 370, 92, "plinth+"},
    {STEM, 206, 180, "plinth+"},  {STEM, 250, 120, "plinth+"},   {STEM, 478, 196, "plinth+"},
    {STEM, 346, 76, "plinth+"},   {STEM, 222, 208, "plinth+"},
};

// All faces are flat and the sun is a direction, so a colour does not depend on where exactly the
// march ends; only in the rims of the water's lines it does: 0.1 of 255 without them.
static void test_pixels(void **unused)
{
    (void)unused;
    struct pixel_list list = {pixels, sizeof pixels / sizeof pixels[0], 0.4 / 255.0};
    pixels_check(&picture, &list);
}

// ---- The march of a ray ----

enum { WIDTH = 640, HEIGHT = 360 };

static struct renderer_inputs load(double u)
{
    struct renderer_inputs inputs = {.width = WIDTH, .height = HEIGHT, .samples = 1};
    assert_true(mirror_camera(gpu.root, STEM, &inputs.camera));
    assert_true(gpu_load(SHADER));
    struct parameter *parameter = parameters_find(&gpu.renderer.parameters, "orthographic");
    assert_non_null(parameter);
    parameter->value[0] = u;
    return inputs;
}

static struct mirror_ray ray_of(const struct renderer_inputs *inputs, double u, int x, int y)
{
    return projection_ray(&inputs->camera, u, mirror_screen_x(x + 0.5, WIDTH, HEIGHT),
                          mirror_screen_y(y + 0.5, HEIGHT));
}

// Every row of the table against the march in double, whose t is known between two ends: t + f(t)
// never decreases, so the ends of one step give those of the next, widened by rounding.
static void check_rows(struct mirror_ray ray, double start, int steps)
{
    const double slack = 4e-6;
    double least = start - slack, most = start + slack;
    for (int k = 0; k < steps; k++) {
        const struct probe_step *row = &probe.step[k];
        double t = (double)row->t;
        double distance = mirror_distance(&scene, mirror_at(ray, t), NULL);
        assert_true(t >= least && t <= most);
        assert_true(fabs((double)row->distance - distance) < slack);
        assert_true(d3_length(d3_sub(d3_of(row->position), mirror_at(ray, t))) < slack);
        least += mirror_distance(&scene, mirror_at(ray, least), NULL) - slack;
        most += mirror_distance(&scene, mirror_at(ray, most), NULL) + slack;
    }
}

// Returns true when the number of steps is that of the march in double; at a threshold or at the
// box's faces rounding may decide.
static bool check_march(const struct renderer_inputs *inputs, double u, int x, int y)
{
    struct mirror_ray ray = ray_of(inputs, u, x, y);
    double t[2];
    assert_true(renderer_probe(&gpu.renderer, inputs, x, y, &probe));
    if (!brute_box_interval(ray, low, high, t))
        return probe.steps == 0 && probe.end == PROBE_PASSED;
    struct mirror_march march = mirror_march(&scene, ray, t[0], t[1], 0.001, 128);
    check_rows(ray, t[0], march.steps < probe.steps ? march.steps : probe.steps);
    return march.steps == probe.steps && (int)march.end == (int)probe.end;
}

static void check_projection(double u)
{
    struct renderer_inputs inputs = load(u);
    int agree = 0, all = 0, hits = 0;
    for (int y = 8; y < HEIGHT; y += 20)
        for (int x = 10; x < WIDTH; x += 31) {
            agree += check_march(&inputs, u, x, y);
            hits += probe.end == PROBE_HIT;
            all++;
        }
    print_message("# u = %.2f: %d rays, %d hits; the number of steps agrees on %d\n", u, all, hits,
                  agree);
    assert_true(hits > 50 && all - hits > 50);
    assert_true(agree >= all - 4);
}

static void test_the_march_of_every_projection(void **unused)
{
    (void)unused;
    check_projection(0.0);
    check_projection(0.5);
    check_projection(1.0);
}

// The views show what the probe counts: depth is the end of that march.
static void test_depth_view(void **unused)
{
    (void)unused;
    for (int k = 0; k < 3; k++) {
        struct renderer_inputs inputs = load(0.5 * k);
        assert_true(renderer_set_view(&gpu.renderer, SHADER_DEPTH));
        float *values = gpu_numbers(&inputs);
        assert_true(renderer_set_view(&gpu.renderer, SHADER_PICTURE));
        assert_non_null(values);
        for (int y = 40; y < HEIGHT; y += 40)
            for (int x = 140; x < 500; x += 45) {
                assert_true(renderer_probe(&gpu.renderer, &inputs, x, y, &probe));
                double t = probe.steps > 0 ? (double)probe.step[probe.steps - 1].t : 0.0;
                double grey = 1.0 / (1.0 + pow(t / 6.0, 4.0));
                if (probe.end == PROBE_HIT)
                    assert_true(fabs((double)values[4 * (y * WIDTH + x)] - grey) < 1e-5);
            }
        free(values);
    }
}

// ---- The slice ----

// Blue inside, orange outside, in the plane that holds the ray, wherever it starts, and the
// camera's up. Ink is left out: circles, lines and letters cover less than a tenth.
static void check_slice(double u, int x, int y)
{
    struct renderer_inputs inputs = load(u);
    inputs.pixel[0] = x;
    inputs.pixel[1] = y;
    assert_true(renderer_set_view(&gpu.renderer, SHADER_SLICE));
    float *values = gpu_numbers(&inputs);
    assert_true(renderer_set_view(&gpu.renderer, SHADER_PICTURE));
    assert_non_null(values);
    assert_true(renderer_probe(&gpu.renderer, &inputs, x, y, &probe));
    struct slice_frame frame = slice_frame_of(&probe, WIDTH, HEIGHT, 0.0f);
    struct mirror_ray ray = ray_of(&inputs, u, x, y);
    struct d3 up = d3_of(camera_basis_of(&inputs.camera).up);
    struct d3 across = d3_unit(d3_sub(up, d3_times(d3_dot(up, ray.direction), ray.direction)));
    int seen = 0, wrong = 0, inside = 0;
    for (int row = 40; row < HEIGHT; row += 3)
        for (int column = 2; column < WIDTH; column += 3) {
            const float *v = values + 4 * (row * WIDTH + column);
            double along = (double)frame.left + (column + 0.5) * (double)frame.unit;
            double aside = (double)frame.bottom + (row + 0.5) * (double)frame.unit;
            struct d3 p = d3_add(mirror_at(ray, along), d3_times(aside, across));
            double distance = mirror_distance(&scene, p, NULL);
            if (fabs(distance) < 4.0 * (double)frame.unit)
                continue;
            seen++;
            inside += distance < 0.0;
            wrong += (v[0] < v[2]) != (distance < 0.0);
        }
    print_message("# slice of %d,%d at u = %.2f: %d places, %d inside, %d have another colour\n", x,
                  y, u, seen, inside, wrong);
    assert_true(inside > seen / 50 && wrong < seen / 10 && wrong < inside);
    free(values);
}

static void test_the_slice_holds_the_ray(void **unused)
{
    (void)unused;
    check_slice(0.0, 300, 160);
    check_slice(0.5, 420, 200);
    check_slice(1.0, 300, 160);
    check_slice(1.0, 200, 190);
}

// ---- What the page says of the scene ----

static double depth_of(const struct camera *camera, struct d3 p)
{
    struct camera_basis basis = camera_basis_of(camera);
    return d3_dot(d3_sub(p, d3_of(camera->position)), d3_of(basis.forward));
}

// The row of the picture in which a point of the world is shown, and its column.
static void place_of(const struct camera *camera, double u, struct d3 p, double at[2])
{
    struct camera_basis basis = camera_basis_of(camera);
    struct d3 from = d3_sub(p, d3_of(camera->position));
    double scale = HEIGHT / 2 * 2.0 / ((1.0 - u) * depth_of(camera, p) + u * framing);
    at[0] = WIDTH / 2 + scale * d3_dot(from, d3_of(basis.right));
    at[1] = HEIGHT / 2 + scale * d3_dot(from, d3_of(basis.up));
}

// The frames are orange, alone in the scene: more than twice as much red as blue.
static bool is_orange(const float *values, const double at[2], double above)
{
    const float *v = values + 4 * ((int)(at[1] + above) * WIDTH + (int)at[0]);
    return v[0] > 2.2f * v[2];
}

// A frame's upper far corner is the highest point of its outline: two pixels below it the picture
// is orange, two above it is not.
static void check_frame_corner(const float *values, const struct camera *camera, double u,
                               struct d3 middle)
{
    double at[2];
    place_of(camera, u, d3_add(middle, d3(0.55, 0.55, -0.55)), at);
    assert_true(is_orange(values, at, -2.0));
    assert_false(is_orange(values, at, 2.0));
}

static void test_the_frames_have_the_sizes_of_their_depths(void **unused)
{
    (void)unused;
    const struct d3 near = {-0.65, 0.55, 2.15}, far = {5.65, 0.55, -4.15};
    for (int k = 0; k <= 4; k++) {
        double u = 0.25 * k;
        struct renderer_inputs inputs = load(u);
        double m[2] = {depth_of(&inputs.camera, near), depth_of(&inputs.camera, far)};
        for (int i = 0; i < 2; i++)
            m[i] = (1.0 - u) * m[i] + u * framing;
        print_message("# u = %.2f: near frame %.3f, far frame %.3f, ratio %.3f\n", u,
                      framing / m[0], framing / m[1], m[1] / m[0]);
        float *values = gpu_numbers(&inputs);
        assert_non_null(values);
        check_frame_corner(values, &inputs.camera, u, near);
        check_frame_corner(values, &inputs.camera, u, far);
        free(values);
    }
}

// The tower's top and the end of the channel behind it are one place of the picture, for parallel
// rays alone.
static void test_the_tower_meets_the_channel(void **unused)
{
    (void)unused;
    struct camera camera;
    assert_true(mirror_camera(gpu.root, STEM, &camera));
    struct camera_basis basis = camera_basis_of(&camera);
    struct d3 apart = d3(climb, -climb, -climb);
    assert_true(fabs(d3_dot(apart, d3_of(basis.right))) < 1e-6);
    assert_true(fabs(d3_dot(apart, d3_of(basis.up))) < 1e-6);
    print_message("# the tower's top and the channel's end are %.3f apart along the view\n",
                  d3_dot(apart, d3_of(basis.forward)));
    for (int axis = 0; axis < 3; axis++) {
        struct d3 e = d3(axis == 0, axis == 1, axis == 2);
        double shown = hypot(d3_dot(e, d3_of(basis.right)), d3_dot(e, d3_of(basis.up)));
        assert_true(fabs(shown - sqrt(2.0 / 3.0)) < 1e-6);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pixels),
        cmocka_unit_test(test_the_march_of_every_projection),
        cmocka_unit_test(test_depth_view),
        cmocka_unit_test(test_the_slice_holds_the_ray),
        cmocka_unit_test(test_the_frames_have_the_sizes_of_their_depths),
        cmocka_unit_test(test_the_tower_meets_the_channel),
    };
    return cmocka_run_group_tests_name("scene_08", tests, gpu_setup, gpu_teardown);
}
