// test_probe.c - the table of --probe against the march in double precision, step by step.
//
// The march is repeated in intervals: [low, high] holds every t that rounding allows. The distance
// is 1-Lipschitz, so t -> t + f(t) never decreases, and the ends of an interval go to the ends of
// the next, widened by what the rounding of one step may add. So the tolerance grows exactly where
// the ray makes errors grow.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_gpu.h"
#include "support_mirror.h"
#include "support_system.h"

enum { WIDTH = 640, HEIGHT = 360 };

static struct probe probe; // too large for the stack

// A march of which only intervals are known.
struct walk {
    const struct mirror_scene *scene;
    struct mirror_ray ray;
    double moved;           // how far the origin may be off, scene units
    double turned;          // how far the direction may be off, radians
    double low, high;       // bounds of t
    double nearest, widest; // bounds of the distance at the last step
};

// What one step's rounding adds: position and distance are off by at most 8 roundings of numbers no
// larger than |origin| + t.
static double step_rounding(const struct walk *walk)
{
    double size = d3_length(walk->ray.origin) + walk->high + 1.0;
    return 8.0 * MIRROR_FLOAT_ROUNDING * size + walk->moved + walk->turned * walk->high;
}

static void walk_ask(struct walk *walk)
{
    double a = mirror_distance(walk->scene, mirror_at(walk->ray, walk->low), NULL);
    double b = mirror_distance(walk->scene, mirror_at(walk->ray, walk->high), NULL);
    double slack = step_rounding(walk) + 0.5 * (walk->high - walk->low);
    walk->nearest = fmin(a, b) - slack;
    walk->widest = fmax(a, b) + slack;
}

static void walk_on(struct walk *walk)
{
    double slack = step_rounding(walk);
    walk->low += mirror_distance(walk->scene, mirror_at(walk->ray, walk->low), NULL) - slack;
    walk->high += mirror_distance(walk->scene, mirror_at(walk->ray, walk->high), NULL) + slack;
}

// Steps of a march and why it ended; end is MIRROR_NONE where rounding decides.
struct outcome {
    int steps;
    enum mirror_end end;
};

struct limits {
    double t_max, threshold;
    int max_steps;
};

static void check_row(const struct walk *walk, const struct probe_step *row)
{
    assert_true((double)row->t >= walk->low && (double)row->t <= walk->high);
    assert_true((double)row->distance >= walk->nearest && (double)row->distance <= walk->widest);
    struct d3 p = mirror_at(walk->ray, (double)row->t);
    assert_true(d3_length(d3_sub(p, d3_of(row->position))) <= step_rounding(walk));
}

// Walk to the end; with a table, every row of it must lie in its interval.
static struct outcome walk_to_end(struct walk *walk, const struct limits *limits,
                                  const struct probe *table)
{
    struct outcome outcome = {0, walk->low < limits->t_max ? MIRROR_NONE : MIRROR_PASSED};
    double edge = 8.0 * MIRROR_FLOAT_ROUNDING * limits->t_max;
    while (outcome.end == MIRROR_NONE) {
        walk_ask(walk);
        if (table != NULL && outcome.steps < table->steps)
            check_row(walk, &table->step[outcome.steps]);
        outcome.steps++;
        if (walk->widest < limits->threshold) {
            outcome.end = MIRROR_HIT;
            break;
        }
        if (walk->nearest < limits->threshold)
            break;
        walk_on(walk);
        if (walk->low >= limits->t_max + edge)
            outcome.end = MIRROR_PASSED;
        else if (walk->high >= limits->t_max - edge)
            break;
        else if (outcome.steps >= limits->max_steps)
            outcome.end = MIRROR_GAVE_UP;
    }
    return outcome;
}

// ---- One pixel
// -----------------------------------------------------------------------------------

struct subject {
    const char *stem;
    const struct mirror_scene *scene;
    bool clipped, shadows;
    struct renderer_inputs inputs;
    int decided, undecided; // pixels whose counts were compared, and those that rounding decides
    int ends[4];
    double widest; // interval of t at a hit
};

static double value_of(const char *name)
{
    const struct parameter *parameter = parameters_find(&gpu.renderer.parameters, name);
    assert_non_null(parameter);
    return parameter->value[0];
}

static double far_of(const struct subject *subject, struct mirror_ray ray, double *start)
{
    double t[2] = {0.0, MIRROR_FAR};
    if (subject->clipped && !brute_box_interval(ray, mirror_low, mirror_high, t)) {
        t[0] = 0.0;
        t[1] = -1.0;
    }
    *start = t[0];
    return t[1];
}

// The shadow ray from the point where the first march ended.
static struct outcome shadow_walk(const struct subject *subject, const struct walk *first,
                                  const struct limits *limits)
{
    double t = 0.5 * (first->low + first->high), start;
    struct d3 p = mirror_at(first->ray, t);
    struct d3 normal = mirror_normal(subject->scene, p);
    struct d3 to_lamp = d3_sub(mirror_lamp(subject->inputs.time), p);
    double away = d3_length(to_lamp), facing = d3_dot(normal, to_lamp) / away;
    double moved = 0.5 * (first->high - first->low) + step_rounding(first);
    if (fabs(facing) < 0.001)
        return (struct outcome){0, MIRROR_NONE};
    if (facing < 0.0)
        return (struct outcome){0, MIRROR_PASSED};
    double offset = value_of("shadowOffset") * limits->threshold;
    struct walk walk = {.scene = subject->scene,
                        .ray = {d3_add(p, d3_times(offset, normal)), d3_times(1.0 / away, to_lamp)},
                        .moved = 2.0 * moved,
                        .turned = 2.0 * moved / away};
    struct limits to_light = *limits;
    to_light.t_max = fmin(away, far_of(subject, walk.ray, &start));
    return walk_to_end(&walk, &to_light, NULL);
}

static void compare_pixel(struct subject *subject, struct walk *walk, const struct limits *limits)
{
    struct outcome first = walk_to_end(walk, limits, &probe), second = {0, MIRROR_PASSED};
    if (first.end != MIRROR_NONE) {
        assert_int_equal(probe.steps, first.steps);
        assert_int_equal((int)probe.end, (int)first.end);
    }
    if (subject->shadows && first.end == MIRROR_HIT)
        second = shadow_walk(subject, walk, limits);
    bool decided = first.end != MIRROR_NONE && second.end != MIRROR_NONE;
    if (decided)
        assert_int_equal(probe.all_steps, first.steps + second.steps);
    subject->decided += decided;
    subject->undecided += !decided;
    if (first.end == MIRROR_HIT)
        subject->widest = fmax(subject->widest, walk->high - walk->low);
}

static void check_pixel(struct subject *subject, int x, int y)
{
    struct mirror_ray ray = mirror_screen_ray(&subject->inputs.camera, MIRROR_FOCAL_LENGTH,
                                              mirror_screen_x(x + 0.5, WIDTH, HEIGHT),
                                              mirror_screen_y(y + 0.5, HEIGHT));
    struct limits limits = {.threshold = value_of("hitThreshold"),
                            .max_steps = (int)value_of("maxSteps")};
    double start;
    limits.t_max = far_of(subject, ray, &start);
    double width = start > 0.0 ? 2e-6 * (1.0 + start) : 0.0;
    // The direction is the camera's basis, rounded, summed and normalised: 6 roundings.
    struct walk walk = {.scene = subject->scene,
                        .ray = ray,
                        .turned = 6.0 * MIRROR_FLOAT_ROUNDING,
                        .low = start - width,
                        .high = start + width};
    assert_true(renderer_probe(&gpu.renderer, &subject->inputs, x, y, &probe));
    subject->ends[probe.end]++;
    assert_int_equal(probe.evaluations, probe.all_steps + (probe.end == PROBE_HIT ? 6 : 0));
    compare_pixel(subject, &walk, &limits);
}

static void check_chapter(struct subject *subject)
{
    char shader[128];
    snprintf(shader, sizeof shader, "chapters/%s.frag", subject->stem);
    subject->inputs = (struct renderer_inputs){.width = WIDTH, .height = HEIGHT, .samples = 1};
    assert_true(mirror_camera(gpu.root, subject->stem, &subject->inputs.camera));
    assert_true(gpu_load(shader));
    for (int y = 8; y < HEIGHT; y += 20)
        for (int x = 10; x < WIDTH; x += 31)
            check_pixel(subject, x, y);
    print_message("# %s: %d pixels compared, %d that rounding decides; %d hits, known to %.1g; %d "
                  "passed\n",
                  subject->stem, subject->decided, subject->undecided, subject->ends[PROBE_HIT],
                  subject->widest, subject->ends[PROBE_PASSED]);
    assert_true(subject->decided > 5 * subject->undecided && subject->widest < 0.001);
    assert_true(subject->ends[PROBE_HIT] > 20 && subject->ends[PROBE_PASSED] > 20);
}

static void test_probe_of_chapter_01(void **unused)
{
    (void)unused;
    struct subject subject = {.stem = "01_normal_colouring", .scene = &mirror_scene_01};
    check_chapter(&subject);
}

static void test_probe_of_chapter_02(void **unused)
{
    (void)unused;
    struct subject subject = {.stem = "02_lighting", .scene = &mirror_scene_02};
    check_chapter(&subject);
}

static void test_probe_of_chapter_03(void **unused)
{
    (void)unused;
    struct subject subject = {
        .stem = "03_shadows", .scene = &mirror_scene_02, .clipped = true, .shadows = true};
    check_chapter(&subject);
}

static void load_chapter(const char *stem, struct renderer_inputs *inputs)
{
    char shader[128];
    snprintf(shader, sizeof shader, "chapters/%s.frag", stem);
    *inputs = (struct renderer_inputs){.width = WIDTH, .height = HEIGHT, .samples = 1};
    assert_true(mirror_camera(gpu.root, stem, &inputs->camera));
    assert_true(gpu_load(shader));
}

// ---- The view of the steps
// -----------------------------------------------------------------------

// The steps view paints a pixel with the ramp at all_steps / 64: the same colour for the same
// count.
static void test_steps_view_shows_what_the_probe_counts(void **unused)
{
    (void)unused;
    struct image image = {0};
    struct renderer_inputs inputs;
    double lightness[65];
    for (int i = 0; i <= 64; i++)
        lightness[i] = -1.0;
    load_chapter("03_shadows", &inputs);
    assert_true(renderer_set_view(&gpu.renderer, SHADER_STEPS));
    assert_true(renderer_picture(&gpu.renderer, &inputs, &image));
    assert_true(renderer_set_view(&gpu.renderer, SHADER_PICTURE));
    for (int y = 50; y < HEIGHT; y += 31) // above the legend
        for (int x = 10; x < WIDTH; x += 47) {
            assert_true(renderer_probe(&gpu.renderer, &inputs, x, y, &probe));
            int steps = probe.all_steps < 64 ? probe.all_steps : 64;
            const unsigned char *c = image.pixel + 3 * ((HEIGHT - 1 - y) * WIDTH + x);
            struct d3 colour = {c[0] / 255.0, c[1] / 255.0, c[2] / 255.0};
            double seen = mirror_lightness(colour, VISION_FULL);
            // The ramp is at most 0.0033 from even (test_numeric.c); the bytes' rounding adds as
            // much in the dark. One step is 0.012.
            assert_true(fabs(seen - (0.17 + (0.95 - 0.17) * steps / 64.0)) < 0.01);
            assert_true(lightness[steps] < 0.0 || lightness[steps] == seen);
            lightness[steps] = seen;
        }
    image_free(&image);
}

// ---- The colour
// -----------------------------------------------------------------------------------

// At some pixels the probe's colour is the picture's, to the bit, whatever bands and samples that
// is made of; in the slice view the one that the picture has.
static void check_colours(const struct renderer_inputs *inputs, enum shader_view view)
{
    struct image image = {0};
    assert_true(renderer_set_view(&gpu.renderer, view));
    assert_true(renderer_picture(&gpu.renderer, inputs, &image));
    if (view == SHADER_PICTURE && gpu.renderer.fragment.form == SHADER_COURSE)
        assert_true(renderer_set_view(&gpu.renderer, SHADER_SLICE));
    for (int i = 0; i < 40; i++) {
        int x = i * 7919 % image.width, y = i * 6271 % image.height;
        assert_true(renderer_probe(&gpu.renderer, inputs, x, y, &probe));
        assert_int_equal(probe.recorded, gpu.renderer.fragment.form == SHADER_COURSE);
        assert_memory_equal(probe.colour,
                            image.pixel + 3 * ((image.height - 1 - y) * image.width + x), 3);
    }
    image_free(&image);
    assert_true(renderer_set_view(&gpu.renderer, SHADER_PICTURE));
}

static void test_colour_is_the_picture_s(void **unused)
{
    (void)unused;
    static const char *const stems[] = {"03_shadows", "06_sierpinski_symmetry",
                                        "08_orthographic_view", "09_sky_and_sunset",
                                        "00_first_scene"};
    struct renderer_inputs inputs;
    for (int i = 0; i < 5; i++) {
        load_chapter(stems[i], &inputs);
        inputs.width = 150 + i;
        inputs.height = 85;
        inputs.samples = 1 + i % 3;
        inputs.time = i;
        check_colours(&inputs, SHADER_PICTURE);
        if (gpu.renderer.fragment.form == SHADER_COURSE)
            check_colours(&inputs, i == 3 ? SHADER_STEPS : SHADER_NORMALS);
    }
    inputs = (struct renderer_inputs){.width = 16384, .height = 300, .samples = 1}; // two bands
    assert_true(gpu_load("chapters/first_steps/1_screen.frag"));
    check_colours(&inputs, SHADER_PICTURE);
    assert_true(gpu_load_text("void mainImage(out vec4 c, vec2 p)\n"
                              "{ c = vec4(fract(sin(p.x * 12.9 + p.y * 78.2) * 43758.5)); }\n"));
    inputs = gpu_inputs(61, 47, 3);
    check_colours(&inputs, SHADER_PICTURE);
}

// ---- Through the program
// -------------------------------------------------------------------------

static void check_line(const char *line, int step)
{
    int number;
    float v[5];
    assert_non_null(line);
    assert_int_equal(sscanf(line, "%d,%f,%f,%f,%f,%f", &number, &v[0], &v[1], &v[2], &v[3], &v[4]),
                     6);
    assert_int_equal(number, step);
    assert_true(v[0] == probe.step[step].t && v[1] == probe.step[step].distance);
    for (int k = 0; k < 3; k++)
        assert_true(v[2 + k] == probe.step[step].position[k]);
}

static void test_program_prints_the_table(void **unused)
{
    (void)unused;
    char text[65536];
    struct renderer_inputs inputs;
    assert_int_equal(system_run("01_normal_colouring", "--probe 320,180", text, sizeof text), 0);
    load_chapter("01_normal_colouring", &inputs);
    assert_true(renderer_probe(&gpu.renderer, &inputs, 320, 180, &probe));
    const char *line = strtok(text, "\n");
    assert_non_null(line);
    assert_string_equal(line, "step,t,distance,x,y,z");
    for (int i = 0; i < probe.steps; i++)
        check_line(strtok(NULL, "\n"), i);
    line = strtok(NULL, "\n");
    assert_true(line != NULL && line[0] == '#');
    assert_null(strtok(NULL, "\n"));
}

static void test_program_tells_the_colour_of_a_whole_file(void **unused)
{
    (void)unused;
    char text[4096];
    assert_int_equal(system_run("00_first_scene", "--probe 320,180", text, sizeof text), 0);
    int colour[3], length = 0;
    assert_int_equal(sscanf(text, "# no march is recorded; colour: %d, %d, %d\n%n", &colour[0],
                            &colour[1], &colour[2], &length),
                     3);
    assert_int_equal(length, strlen(text));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_probe_of_chapter_01),
        cmocka_unit_test(test_probe_of_chapter_02),
        cmocka_unit_test(test_probe_of_chapter_03),
        cmocka_unit_test(test_steps_view_shows_what_the_probe_counts),
        cmocka_unit_test(test_colour_is_the_picture_s),
        cmocka_unit_test(test_program_prints_the_table),
        cmocka_unit_test(test_program_tells_the_colour_of_a_whole_file),
    };
    return cmocka_run_group_tests_name("probe", tests, gpu_setup, gpu_teardown);
}
