// coarse.c - tests of the coarse pass. Brute force in double precision checks that no ray of a
// block meets anything before the block's start. Pictures of a wire half a pixel thick may differ
// with and without the pass only where a ray grazes the scene, and the wire has no holes if the
// threshold grows along the ray.
#include "lib/test.h"
#include "lib/coarse.h"

// Follow a ray to the first point where the scene is nearer than coarseMargin, in steps that cannot
// pass this point. Returns the distance along the ray, or infinity if there is no such point before
// the limit.
static double reach(const struct coarse_scene *scene, const struct renderer_inputs *inputs,
                    struct mirror_ray ray, double limit)
{
    for (double t = 0.0; t < limit;) {
        double over = coarse_distance(scene, mirror_at(ray, t)) - coarse_margin(scene, inputs, t);
        if (over < -coarse_slack(ray, t))
            return t;
        t += fmax(over / (1.0 + scene->growth), 0.0) + coarse_slack(ray, t);
    }
    return INFINITY;
}

// ---- Chance ----

static uint64_t chance;

// A random number in [low, high].
static double any(double low, double high)
{
    chance = chance * 6364136223846793005u + 1442695040888963407u;
    return coarse_float(low + (high - low) * (double)(chance >> 40) / (double)(1 << 24));
}

static struct d3 random_position(double reach)
{
    return d3(any(-reach, reach), any(-reach, reach), any(-reach, reach));
}

static struct coarse_scene any_scene(double orthographic)
{
    struct coarse_scene scene = {.orthographic = orthographic,
                                 .framing = any(3.0, 9.0),
                                 .focal_length = any(0.6, 3.0),
                                 .threshold = any(0.0002, 0.01),
                                 .growth = any(0.0, 1.0) < 0.5 ? 0.0 : any(0.5, 2.0),
                                 .factor = any(0.0, 1.0) < 0.5 ? 1.0 : any(0.4, 0.9),
                                 .wire_radius = any(0.002, 0.02)};
    for (int i = 0; i < COARSE_BALLS; i++) {
        scene.ball[i] = random_position(2.5);
        scene.radius[i] = any(0.05, 0.8);
    }
    scene.wire[0] = random_position(3.0);
    scene.wire[1] = random_position(3.0);
    return scene;
}

// A random camera around the scene that looks roughly towards its middle.
static struct camera any_camera(void)
{
    double pan = any(-180.0, 180.0), tilt = any(-70.0, 70.0), away = any(3.0, 8.0);
    struct camera camera = {.pan = (float)pan, .tilt = (float)tilt};
    struct camera_basis basis = camera_basis_of(&camera);
    for (int i = 0; i < 3; i++)
        camera.position[i] = (float)(any(-1.0, 1.0) - away * (double)basis.forward[i]);
    return camera;
}

// Counts and sums over the blocks of pictures. Here, a ray meets something where the scene is
// nearer than coarseMargin.
struct starts {
    int rays;          // rays that were followed
    int early;         // rays that meet something before the start of their block
    double start, met; // sums over the blocks that meet something: the start, the first meeting
};

// Follow 40 rays of a block: through its corners, which it shares with its neighbours, and through
// random points inside it.
static void look_at(const struct coarse_scene *scene, const struct renderer_inputs *inputs,
                    int block[2], double start, struct starts *starts)
{
    double low[2] = {8.0 * block[0], 8.0 * block[1]}, first = INFINITY;
    double high[2] = {fmin(low[0] + 8.0, inputs->width), fmin(low[1] + 8.0, inputs->height)};
    for (int i = 0; i < 40; i++) {
        double x = i < 4 ? (i % 2 == 0 ? low[0] : high[0]) : any(low[0], high[0]);
        double y = i < 4 ? (i < 2 ? low[1] : high[1]) : any(low[1], high[1]);
        double met = reach(scene, inputs, coarse_ray(scene, inputs, x, y), 60.0);
        starts->rays++;
        starts->early += met < start;
        first = fmin(first, met);
    }
    if (first < INFINITY &&
        inputs->height > 20) { // a cone around the whole picture is too wide for a good start
        starts->start += start;
        starts->met += first;
    }
}

static void look_at_picture(double orthographic, int width, int height, struct starts *starts)
{
    struct coarse_scene scene = any_scene(orthographic);
    struct renderer_inputs inputs = {
        .width = width, .height = height, .camera = any_camera(), .samples = 1};
    coarse_set_scene(&scene);
    float *table = coarse_table(&inputs);
    for (int y = 0; y < coarse_blocks(height); y++)
        for (int x = 0; x < coarse_blocks(width); x++) {
            const float *texel = table + 4 * (coarse_blocks(width) * y + x);
            assert_true(texel[0] >= 0.0f && texel[1] >= 1.0f && texel[1] <= 64.0f);
            look_at(&scene, &inputs, (int[2]){x, y}, (double)texel[0], starts);
        }
    free(table);
}

// The views are perspective, parallel and two in between. Only some of the pictures consist of
// whole blocks.
TEST(test_nothing_is_before_the_start_of_a_block)
{
    static const int sizes[][2] = {{96, 56}, {67, 37}, {160, 45}, {5, 3}, {1, 1}};
    static const double views[] = {0.0, 0.4, 0.9, 1.0};
    assert_true(gpu_load(COARSE_SHADER));
    for (size_t v = 0; v < sizeof views / sizeof *views; v++) {
        struct starts starts = {0};
        chance = 20 + v;
        for (size_t i = 0; i < 25; i++)
            look_at_picture(views[v], sizes[i % 5][0], sizes[i % 5][1], &starts);
        print_message(
            "# orthographic %g: of %d rays, %d meet something before the start of their block; on "
            "average, a block starts at %.3f of the distance to the first meeting\n",
            views[v], starts.rays, starts.early, starts.start / starts.met);
        assert_int_equal(starts.early, 0);
        assert_true(starts.start > 0.75 * starts.met);
    }
}

// ---- A wire half a pixel thick ----

// The events along a ray, up to its first hit.
struct course {
    bool meets;  // the ray meets the scene
    bool nears;  // the scene comes nearer to the ray than the margin
    bool grazes; // the scene comes nearer than the margin, and recedes before the ray meets it
};

static struct course course_of(const struct coarse_scene *scene,
                               const struct renderer_inputs *inputs, struct mirror_ray ray)
{
    struct course course = {false, false, false};
    for (double t = 0.0; t < 60.0 && !course.meets;) {
        double distance = coarse_distance(scene, mirror_at(ray, t));
        bool near = distance < coarse_margin(scene, inputs, t);
        course.meets = distance < -coarse_slack(ray, t);
        course.grazes = course.grazes || (course.nears && !near);
        course.nears = course.nears || near;
        t += fmax(0.02 * fabs(distance), 1e-4);
    }
    return course;
}

// The picture shows every ray that meets the scene as a hit, and no ray that stays farther away
// than the margin.
static void check_rays(const struct coarse_scene *scene, const struct renderer_inputs *inputs,
                       const float *picture, int row)
{
    for (int x = 0; x < COARSE_WIDE; x += 7) {
        bool found = picture[4 * (COARSE_WIDE * row + x)] > 0.5f;
        struct mirror_ray ray = coarse_ray(scene, inputs, x + 0.5, row + 0.5);
        struct course course = course_of(scene, inputs, ray);
        assert_true(course.nears || !found);
        assert_true(!course.meets || found);
    }
}

// The number of columns of the picture in which no pixel shows the wire. No ball covers a whole
// column.
static int holes_of(const float *picture)
{
    int holes = 0;
    for (int x = 0; x < COARSE_WIDE; x++) {
        bool wire = false;
        for (int y = 0; y < COARSE_HIGH; y++)
            wire = wire || picture[4 * (COARSE_WIDE * y + x) + 1] > 0.5f;
        holes += !wire;
    }
    return holes;
}

static float *wire_picture(const struct renderer_inputs *inputs, bool pass)
{
    gpu_set("coarsePass", pass);
    return gpu_numbers(inputs);
}

// The number of pixels in which only one of the two pictures shows anything, or only one shows the
// wire. Such a pixel is allowed only where the ray comes nearer to the scene than the margin and
// then moves away again: there, one march may stop and the other may step past.
static int differences_of(const struct coarse_scene *scene, const struct renderer_inputs *inputs,
                          const float *a, const float *b)
{
    int count = 0;
    for (int i = 0; i < COARSE_WIDE * COARSE_HIGH; i++) {
        if (a[4 * i] == b[4 * i] && a[4 * i + 1] == b[4 * i + 1])
            continue;
        double x = i % COARSE_WIDE + 0.5, y = i / COARSE_WIDE + 0.5;
        assert_true(course_of(scene, inputs, coarse_ray(scene, inputs, x, y)).grazes);
        count++;
    }
    return count;
}

// Check a wire from a grid of 7 x 7 cameras, each a fraction of a pixel from the next.
static void check_wire(double growth, double lean, double orthographic)
{
    int differ = 0, holes = 0, alone_holes = 0;
    for (int i = 0; i < 49; i++) {
        struct coarse_scene scene = coarse_wire(growth, lean);
        struct renderer_inputs inputs = {.width = COARSE_WIDE, .height = COARSE_HIGH, .samples = 1};
        inputs.camera.position[0] = (float)(0.031 * (i % 7));
        inputs.camera.position[1] = (float)(0.0173 * (i / 7));
        inputs.camera.position[2] = 7.0f;
        scene.orthographic = orthographic;
        coarse_set_scene(&scene);
        float *with = wire_picture(&inputs, true), *without = wire_picture(&inputs, false);
        check_rays(&scene, &inputs, with, 55 + i % 12);
        differ += differences_of(&scene, &inputs, with, without);
        holes += holes_of(with);
        alone_holes += holes_of(without);
        free(with);
        free(without);
    }
    print_message("# growth %g, lean %g, orthographic %g: %d pixels differ, %d holes in the wire "
                  "(%d without the pass)\n",
                  growth, lean, orthographic, differ, holes, alone_holes);
    assert_true(differ < 49 * COARSE_WIDE * COARSE_HIGH / 2000); // 0.05 %
    assert_true(growth == 0.0 || holes == 0);
}

TEST(test_a_wire_of_half_a_pixel_stays_whole)
{
    assert_true(gpu_load(COARSE_SHADER));
    for (int view = 0; view < 3; view++)
        for (int lean = 0; lean < 2; lean++) {
            check_wire(0.0, 0.17 * lean, 0.5 * view);
            check_wire(1.0, 0.17 * lean, 0.5 * view);
        }
}

TESTS(gpu_setup, gpu_teardown)
