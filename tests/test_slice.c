// test_slice.c - the slice view: the march that it draws is the one of the table, and its colours
// are those of the scene's distance in double precision.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "../common/picture/slice.h"
#include "support_gpu.h"
#include "support_mirror.h"
#include "support_scratch.h"

enum { WIDTH = 640, HEIGHT = 360, AXIS = 29, LABELS = 20 }; // pixels

// Half of shaders/slice.glsl's ink lies on a light pixel: less red than this.
#define INKED 0.55f

// One slice: its table, its frame, its pixels.
struct slice {
    struct renderer_inputs inputs;
    struct probe probe;
    struct slice_frame frame;
    float *values;
};

// What the picture must show, told once more: a hit and 0.35 of the way to it beyond; of a ray that
// passes, as far as its nearest place and half of that, and twice the distance there, or all of it
// where the eye is nearest. A tenth of that lies behind the eye, the ray runs through the middle,
// and the place where the scene was nearest stays where it is in every zoom.
static struct slice_frame frame_expected(const struct probe *probe, double zoom)
{
    const struct probe_step *step = probe->step;
    int nearest = 0, last = probe->steps - 1;
    for (int k = 1; k <= last; k++)
        nearest = step[k].distance < step[nearest].distance ? k : nearest;
    double t = (double)step[nearest].t, end = 1.35 * (double)step[last].t;
    if (probe->end == PROBE_PASSED && nearest > 0)
        end = fmin((double)step[last].t, 1.5 * t + 2.0 * (double)step[nearest].distance);
    else if (probe->end == PROBE_PASSED)
        end = 1.05 * (double)step[last].t;
    double left = t + (-0.1 * end - t) / zoom, unit = 1.1 * end / zoom / WIDTH;
    return (struct slice_frame){
        .left = (float)left, .unit = (float)unit, .bottom = (float)(-0.5 * HEIGHT * unit)};
}

static struct slice *slice_of(const struct camera *camera, int x, int y, float zoom)
{
    struct slice *slice = calloc(1, sizeof *slice);
    assert_non_null(slice);
    slice->inputs = (struct renderer_inputs){.width = WIDTH,
                                             .height = HEIGHT,
                                             .camera = *camera,
                                             .samples = 1,
                                             .pixel = {x, y},
                                             .zoom = zoom};
    assert_true(renderer_set_view(&gpu.renderer, SHADER_SLICE));
    slice->values = gpu_numbers(&slice->inputs);
    assert_non_null(slice->values);
    assert_true(renderer_probe(&gpu.renderer, &slice->inputs, x, y, &slice->probe));
    slice->frame = frame_expected(&slice->probe, (double)zoom);
    assert_true(renderer_set_view(&gpu.renderer, SHADER_PICTURE));
    return slice;
}

static void slice_free(struct slice *slice)
{
    free(slice->values);
    free(slice);
}

// The pixel that holds a point of the plane, or NULL outside of the picture and on the axis.
//   offset  receives (along, across) of the pixel's centre; may be NULL
static const float *pixel_at(const struct slice *slice, double along, double across, double at[2])
{
    const struct slice_frame *frame = &slice->frame;
    double x = floor((along - (double)frame->left) / (double)frame->unit);
    double y = floor((across - (double)frame->bottom) / (double)frame->unit);
    if (x < 0.0 || x >= WIDTH || y < AXIS || y >= HEIGHT)
        return NULL;
    if (at != NULL) {
        at[0] = (double)frame->left + (x + 0.5) * (double)frame->unit;
        at[1] = (double)frame->bottom + (y + 0.5) * (double)frame->unit;
    }
    return slice->values + 4 * ((int)y * WIDTH + (int)x);
}

// How far a point is from what the march draws, in pixels.
static double from_march(const struct slice *slice, const double at[2])
{
    double nearest = fabs(at[1]);
    for (int k = 0; k < slice->probe.steps; k++) {
        const struct probe_step *step = &slice->probe.step[k];
        double centre = hypot(at[0] - (double)step->t, at[1]);
        nearest = fmin(nearest, fabs(centre - fabs((double)step->distance)));
        nearest = fmin(nearest, centre);
    }
    return nearest / (double)slice->frame.unit;
}

// Below the ray, where no number stands: the pixels of each circle are covered by 1.15 - their
// distance to it, for its pen is 1.3 pixels wide.
static int check_circle(const struct slice *slice, const struct probe_step *step)
{
    int seen = 0;
    double middle = ((double)step->t - (double)slice->frame.left) / (double)slice->frame.unit;
    double ink = middle >= 0.0 && middle <= WIDTH ? 0.95 : 0.4 * 0.95; // pale off the picture
    for (int degrees = 10; degrees <= 170; degrees += 4) {
        double angle = degrees * MIRROR_PI / 180.0, radius = fabs((double)step->distance), at[2];
        const float *pixel =
            pixel_at(slice, (double)step->t + radius * cos(angle), -radius * sin(angle), at);
        if (pixel == NULL)
            continue;
        double off = fabs(hypot(at[0] - (double)step->t, at[1]) - radius);
        double cover = fmax(0.0, 1.15 - off / (double)slice->frame.unit);
        // 0.03: the float's rounding of a place, 2e-5 of a pixel, and nothing lighter than 1.
        assert_true((double)pixel[0] <= 1.0 - ink * fmin(cover, 1.0) + 0.03);
        seen += cover > 0.9;
    }
    return seen;
}

static void check_march(const struct slice *slice)
{
    int positions = 0, points = 0;
    for (int k = 0; k < slice->probe.steps; k++) {
        const struct probe_step *step = &slice->probe.step[k];
        const float *pixel = pixel_at(slice, (double)step->t, 0.0, NULL);
        if (pixel != NULL) {
            assert_true(pixel[0] < INKED);
            positions++;
        }
        points += check_circle(slice, step);
    }
    print_message("# %d steps: %d positions and %d points of circles are drawn\n",
                  slice->probe.steps, positions, points);
    assert_true(positions >= 5 && points >= 50);
}

static double random_share(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) / 16777216.0;
}

// What check_field saw on one side of the surface.
struct side {
    int pixels;
    double darkest[3], lightest[3]; // for each eye
};

static void add_colour(struct side *side, const float *colour)
{
    for (int eye = 0; eye < 3; eye++) {
        double lightness = mirror_lightness(d3_of(colour), (enum mirror_vision)eye);
        side->darkest[eye] = side->pixels > 0 ? fmin(side->darkest[eye], lightness) : lightness;
        side->lightest[eye] = fmax(side->lightest[eye], lightness);
    }
    side->pixels++;
}

// The plane of the slice: along is the ray, across the camera's up without its part along the ray.
static struct mirror_ray plane_of(const struct slice *slice, struct d3 *across)
{
    const int *pixel = slice->inputs.pixel;
    struct mirror_ray ray = mirror_screen_ray(&slice->inputs.camera, MIRROR_FOCAL_LENGTH,
                                              mirror_screen_x(pixel[0] + 0.5, WIDTH, HEIGHT),
                                              mirror_screen_y(pixel[1] + 0.5, HEIGHT));
    struct d3 up = d3_of(camera_basis_of(&slice->inputs.camera).up);
    *across = d3_unit(d3_sub(up, d3_times(d3_dot(up, ray.direction), ray.direction)));
    return ray;
}

// True where something is drawn over the field: the eye, the march, a number.
static bool is_covered(const struct slice *slice, const double at[2])
{
    double unit = (double)slice->frame.unit;
    return hypot(at[0], at[1]) < 8.0 * unit || (at[1] >= 0.0 && at[1] < LABELS * unit) ||
           from_march(slice, at) < 8.0;
}

// Where the field is bare: warm outside, blue inside, and every pixel outside lighter than every
// one inside, for each eye.
static void check_field(const struct slice *slice, const struct mirror_scene *scene)
{
    struct d3 across;
    struct mirror_ray ray = plane_of(slice, &across);
    struct side outside = {0}, inside = {0};
    double unit = (double)slice->frame.unit;
    uint32_t state = 1;
    for (int i = 0; i < 100000; i++) {
        double along = (double)slice->frame.left + random_share(&state) * WIDTH * unit, at[2];
        double up = (double)slice->frame.bottom + random_share(&state) * HEIGHT * unit;
        const float *seen = pixel_at(slice, along, up, at);
        if (seen == NULL || is_covered(slice, at))
            continue;
        struct d3 p = d3_add(mirror_at(ray, at[0]), d3_times(at[1], across));
        double distance = mirror_distance(scene, p, NULL);
        if (fabs(distance) < 2.2 * unit) // the surface is a line 3.2 pixels wide
            continue;
        assert_true(distance > 0.0 ? seen[0] > seen[2] : seen[2] > seen[0]);
        add_colour(distance > 0.0 ? &outside : &inside, seen);
    }
    print_message("# %d pixels outside from lightness %.2f up, %d inside to %.2f\n", outside.pixels,
                  outside.darkest[0], inside.pixels, inside.lightest[0]);
    assert_true(outside.pixels > 5000 && inside.pixels > 500);
    for (int eye = 0; eye < 3; eye++)
        assert_true(outside.darkest[eye] > inside.lightest[eye]);
}

// The rays of tests/images.txt.
static const struct {
    const char *stem;
    const struct mirror_scene *scene;
    int x, y;
    float zoom;
} rays[] = {
    {"01_normal_colouring", &mirror_scene_01, 320, 180, 1.0f},
    {"01_normal_colouring", &mirror_scene_01, 340, 140, 1.0f},
    {"01_normal_colouring", &mirror_scene_01, 340, 140, 6.0f},
    {"02_lighting", &mirror_scene_02, 360, 130, 1.0f},
    {"03_shadows", &mirror_scene_02, 380, 130, 1.0f},
};

static struct slice *load_slice(size_t i)
{
    char shader[128];
    struct camera camera;
    snprintf(shader, sizeof shader, "chapters/%s.frag", rays[i].stem);
    assert_true(gpu_load(shader));
    assert_true(mirror_camera(gpu.root, rays[i].stem, &camera));
    return slice_of(&camera, rays[i].x, rays[i].y, rays[i].zoom);
}

static void the_march_of_the_table_is_drawn(void **unused)
{
    (void)unused;
    for (size_t i = 0; i < sizeof rays / sizeof *rays; i++) {
        struct slice *slice = load_slice(i);
        check_march(slice);
        slice_free(slice);
    }
}

static void the_colours_tell_outside_from_inside(void **unused)
{
    (void)unused;
    for (size_t i = 0; i < sizeof rays / sizeof *rays; i++) {
        struct slice *slice = load_slice(i);
        check_field(slice, rays[i].scene);
        slice_free(slice);
    }
}

// ---- The number of steps ----

// Nothing within 0.5 of anywhere: step k stands at 0.5 k, and ends at the column's own limit.
static const char equal_steps[] = "#include \"main.glsl\"\n"
                                  "#include \"march.glsl\"\n"
                                  "Ray pixelRay(vec2 screen)\n"
                                  "{\n"
                                  "    float column = screen.x * iResolution.y * 0.5 +\n"
                                  "                   iResolution.x * 0.5 - 0.5;\n"
                                  "    return Ray(vec3(column, 0.0, 0.0), vec3(0.0, 0.0, -1.0));\n"
                                  "}\n"
                                  "float sceneDistance(vec3 p) { return 0.5; }\n"
                                  "vec3 rayColour(Ray ray)\n"
                                  "{\n"
                                  "    float far = 0.5 * ray.origin.x + 0.25;\n"
                                  "    march(ray, 0.0, far, 0.001, 1000);\n"
                                  "    return vec3(0.0);\n"
                                  "}\n";

// Each circle's lowest point is drawn, and there is none for a step that was not made.
static void every_step_has_one_circle(void **unused)
{
    (void)unused;
    const struct camera camera = {.position = {0.0f, 0.0f, 0.0f}};
    assert_true(gpu_load_text(equal_steps));
    struct slice *slice = slice_of(&camera, 2, 180, 0.5f);
    assert_int_equal(slice->probe.steps, 3);
    for (int k = -2; k <= 5; k++) {
        const float *pixel = pixel_at(slice, 0.5 * k, -0.5, NULL);
        if (pixel != NULL)
            assert_int_equal(pixel[0] < INKED, k >= 0 && k < 3);
    }
    slice_free(slice);
}

// The colour of n steps in the steps view is learnt from the columns of a scene where step n is
// known; the table has that number for the same pixel of a chapter, and the slice draws that table.
static void the_steps_view_agrees_with_the_table(void **unused)
{
    (void)unused;
    struct renderer_inputs inputs = {.width = WIDTH, .height = HEIGHT, .samples = 1};
    assert_true(gpu_load_text(equal_steps));
    assert_true(renderer_set_view(&gpu.renderer, SHADER_STEPS));
    float *colours = gpu_numbers(&inputs);
    assert_non_null(colours);
    assert_true(gpu_load("chapters/01_normal_colouring.frag"));
    assert_true(mirror_camera(gpu.root, "01_normal_colouring", &inputs.camera));
    float *view = gpu_numbers(&inputs);
    assert_non_null(view);
    struct probe *probe = malloc(sizeof *probe);
    assert_non_null(probe);
    static const int pixel[][2] = {{320, 180}, {340, 140}, {250, 60}, {274, 180}, {10, 300}};
    for (size_t i = 0; i < sizeof pixel / sizeof *pixel; i++) {
        assert_true(renderer_probe(&gpu.renderer, &inputs, pixel[i][0], pixel[i][1], probe));
        int shown = probe->steps < 64 ? probe->steps : 64;
        const float *seen = view + 4 * (pixel[i][1] * WIDTH + pixel[i][0]);
        const float *expected = colours + 4 * (HEIGHT / 2 * WIDTH + shown - 1);
        assert_memory_equal(seen, expected, 4 * sizeof(float));
    }
    free(probe);
    free(view);
    free(colours);
    assert_true(renderer_set_view(&gpu.renderer, SHADER_PICTURE));
}

// ---- The frame ----

static struct slice_frame frame_of(enum probe_end end, const float *t, const float *distance,
                                   int steps, float zoom)
{
    struct probe *probe = calloc(1, sizeof *probe);
    assert_non_null(probe);
    probe->steps = steps;
    probe->end = end;
    for (int i = 0; i < steps; i++) {
        probe->step[i].t = t[i];
        probe->step[i].distance = distance[i];
    }
    struct slice_frame frame = slice_frame_of(probe, WIDTH, HEIGHT, zoom);
    free(probe);
    return frame;
}

static void assert_shows(struct slice_frame frame, double from, double to)
{
    double right = (double)frame.left + WIDTH * (double)frame.unit;
    assert_true((double)frame.left <= from && right >= to);
    double tick = (double)frame.digits[0] / pow(10.0, frame.digits[1]);
    assert_true(fabs(tick - (double)frame.tick) <= 1e-6 * tick);
    double ticks = (right - (double)frame.left) / (double)frame.tick;
    assert_true(ticks > 3.0 && ticks < 9.0);
}

static void the_frame_shows_the_march(void **unused)
{
    (void)unused;
    const float hit_t[] = {0.0f, 3.0f, 4.0f}, hit[] = {3.0f, 1.0f, 1e-4f};
    assert_shows(frame_of(PROBE_HIT, hit_t, hit, 3, 1.0f), 0.0, 4.2);
    const float miss_t[] = {0.0f, 2.0f, 4.0f, 12.0f, 30.0f},
                miss[] = {2.0f, 0.1f, 8.0f, 18.0f, 40.0f};
    struct slice_frame frame = frame_of(PROBE_PASSED, miss_t, miss, 5, 1.0f);
    assert_shows(frame, 0.0, 2.2);
    assert_true((double)frame.left + WIDTH * (double)frame.unit < 12.0);
    for (int i = 0; i <= 100; i++) {
        double zooms = (double)SLICE_ZOOM_MAXIMUM / (double)SLICE_ZOOM_MINIMUM;
        float zoom = SLICE_ZOOM_MINIMUM * (float)pow(zooms, i / 100.0);
        assert_shows(frame_of(PROBE_PASSED, miss_t, miss, 5, zoom), 2.0, 2.0);
    }
    // A ray that leaves a surface, as a shadow ray does: the circles grow, and the last is shown.
    const float leave_t[] = {0.0f, 0.002f, 0.006f, 1.0f, 3.5f},
                leave[] = {0.002f, 0.004f, 0.994f, 2.5f, 4.0f};
    assert_shows(frame_of(PROBE_PASSED, leave_t, leave, 5, 1.0f), 0.0, 3.4);
    // No march, one that ends where it starts, and distances that are no numbers.
    assert_shows(frame_of(PROBE_NO_MARCH, NULL, NULL, 0, 1.0f), 0.0, 1.0);
    const float zero[] = {0.0f}, nan[] = {NAN};
    assert_shows(frame_of(PROBE_HIT, zero, zero, 1, 1.0f), 0.0, 0.5);
    assert_shows(frame_of(PROBE_GAVE_UP, zero, nan, 1, 1.0f), 0.0, 0.5);
    assert_shows(frame_of(PROBE_GAVE_UP, nan, nan, 1, 1.0f), 0.0, 0.5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_march_of_the_table_is_drawn),
        cmocka_unit_test(the_colours_tell_outside_from_inside),
        cmocka_unit_test(every_step_has_one_circle),
        cmocka_unit_test(the_steps_view_agrees_with_the_table),
        cmocka_unit_test(the_frame_shows_the_march),
    };
    return cmocka_run_group_tests_name("slice", tests, gpu_setup, gpu_teardown);
}
