// projection.c - the rays of shaders/orthographic.glsl compared with their formulas in double
// precision, and their effect on a picture: sizes, parallel edges, and the plane that keeps its
// size.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

#define RAYS   "tests/shaders/projection.frag"
#define PLATES "tests/shaders/plates.frag"

// ---- Rays ----

enum { COLUMNS = 65, ROWS = 33, RAYS_COUNT = COLUMNS * ROWS };

// The values of Time for which projection.frag writes the origins of rays; the next value gives the
// directions.
enum { PROJECTION = 0, PERSPECTIVE = 2, ORTHOGRAPHIC = 4 };

struct view {
    struct camera camera;
    double focal_length, framing;
};

static const struct view views[] = {
    {{{0.0f, 0.0f, 0.0f}, 0.0f, 0.0f}, 1.0, 4.0},
    {{{-3.45f, 6.25f, 4.95f}, 45.0f, -35.26439f}, 2.0, 9.5},
    {{{1.5f, 2.75f, 5.3f}, -117.0f, 22.5f}, 0.5, 3.0},
    {{{7.0f, -1.0f, -2.0f}, 179.0f, -88.0f}, 5.0, 20.0},
};
static const double passage[] = {0.0, 0.25, 0.5, 0.75, 1.0};

enum { VIEWS = sizeof views / sizeof views[0], PASSAGE = sizeof passage / sizeof passage[0] };

// All rays of a view: rays[0] receives the origins, rays[1] the directions. The caller frees both.
static void rays_of(const struct view *view, double u, int which, float *rays[2])
{
    const struct gl *gl = gpu.renderer.gl;
    GLuint program = gpu.renderer.program[VIEW_PICTURE];
    gl->UseProgram(program);
    gl->Uniform1f(gl->GetUniformLocation(program, "orthographic"), (float)u);
    gpu.renderer.focal_length = (float)view->focal_length;
    for (int part = 0; part < 2; part++) {
        struct renderer_inputs inputs = {.width = COLUMNS,
                                         .height = ROWS,
                                         .camera = view->camera,
                                         .time = which + part,
                                         .mouse = {(float)view->framing},
                                         .samples = 1};
        rays[part] = gpu_numbers(&inputs);
    }
}

static void free_rays(float *rays[2])
{
    free(rays[0]);
    free(rays[1]);
}

TEST(test_u_0_is_the_perspective_ray_to_the_bit)
{
    assert_true(gpu_load(RAYS));
    for (int i = 0; i < VIEWS; i++) {
        float *ours[2], *perspective[2];
        rays_of(&views[i], 0.0, PROJECTION, ours);
        rays_of(&views[i], 0.0, PERSPECTIVE, perspective);
        for (int part = 0; part < 2; part++)
            assert_memory_equal(ours[part], perspective[part],
                                sizeof(float[4]) * (size_t)RAYS_COUNT);
        free_rays(ours);
        free_rays(perspective);
    }
}

// projectionRay normalises the direction once more, so its result may differ from that of
// orthographicRay by rounding.
TEST(test_u_1_is_the_orthographic_ray)
{
    assert_true(gpu_load(RAYS));
    for (int i = 0; i < VIEWS; i++) {
        float *ours[2], *parallel[2];
        rays_of(&views[i], 1.0, PROJECTION, ours);
        rays_of(&views[i], 1.0, ORTHOGRAPHIC, parallel);
        assert_memory_equal(ours[0], parallel[0], sizeof(float[4]) * (size_t)RAYS_COUNT);
        for (int k = 0; k < RAYS_COUNT; k++) {
            struct d3 a = d3_of(ours[1] + 4 * k), b = d3_of(parallel[1] + 4 * k);
            assert_true(d3_length(d3_sub(a, b)) < 4e-7);
            assert_memory_equal(parallel[1] + 4 * k, parallel[1], sizeof(float[3]));
        }
        free_rays(ours);
        free_rays(parallel);
    }
}

// Find where a ray crosses the plane that is perpendicular to the view at a depth. `at` receives
// how far the crossing is to the right of the view's axis and above this axis.
static void crossing(const struct view *view, struct d3 origin, struct d3 direction, double depth,
                     double at[2])
{
    struct camera_basis basis = camera_basis_of(&view->camera);
    struct d3 from = d3_sub(origin, d3_of(view->camera.position)), forward = d3_of(basis.forward);
    double t = (depth - d3_dot(from, forward)) / d3_dot(direction, forward);
    struct d3 p = d3_add(from, d3_times(t, direction));
    at[0] = d3_dot(p, d3_of(basis.right));
    at[1] = d3_dot(p, d3_of(basis.up));
}

// The largest error of a crossing, in half heights of the picture. At depth d, the ray through
// (x, y) is at (x, y) mix(d, framing, u) / focalLength. On the framing plane it is therefore at the
// same point for all u, and for u < 1 all rays meet at one point at or behind the camera, the eye.
static double worst_crossing(const struct view *view, double u, double depth)
{
    float *rays[2];
    double worst = 0.0;
    rays_of(view, u, PROJECTION, rays);
    for (int k = 0; k < RAYS_COUNT; k++) {
        double at[2], scale = (depth + u * (view->framing - depth)) / view->focal_length;
        crossing(view, d3_of(rays[0] + 4 * k), d3_of(rays[1] + 4 * k), depth, at);
        double x = mirror_screen_x(k % COLUMNS + 0.5, COLUMNS, ROWS);
        double y = mirror_screen_y(k / COLUMNS + 0.5, ROWS);
        double size = view->framing / view->focal_length;
        worst = fmax(worst, hypot(at[0] - scale * x, at[1] - scale * y) / size);
    }
    free_rays(rays);
    return worst;
}

TEST(test_rays_cross_every_plane_where_the_formula_says)
{
    assert_true(gpu_load(RAYS));
    double framing = 0.0, others = 0.0;
    for (int i = 0; i < VIEWS; i++)
        for (int k = 0; k < PASSAGE; k++) {
            double u = passage[k], d = views[i].framing;
            framing = fmax(framing, worst_crossing(&views[i], u, d));
            others = fmax(others, worst_crossing(&views[i], u, 0.4 * d));
            others = fmax(others, worst_crossing(&views[i], u, 3.0 * d));
            if (u < 1.0)
                others = fmax(others, worst_crossing(&views[i], u, -u * d / (1.0 - u)));
        }
    print_message(
        "# framing plane: off by at most %.1g half heights; other planes and the eye by at "
        "most %.1g\n",
        framing, others);
    assert_true(framing < 4e-6);
    assert_true(others < 2e-5);
}

// ---- Pictures ----

enum { WIDTH = 640, HEIGHT = 360, SAMPLES = 4 };

static void set(const char *name, double value)
{
    struct parameter *parameter = parameters_find(&gpu.renderer.parameters, name);
    assert_non_null(parameter);
    parameter->value[0] = value;
}

// The white share of each pixel. The caller frees the result.
static float *coverage(const struct camera *camera, double u)
{
    struct renderer_inputs inputs = {
        .width = WIDTH, .height = HEIGHT, .camera = *camera, .samples = SAMPLES};
    set("orthographic", u);
    return gpu_numbers(&inputs);
}

// The width of the white part of a row, in pixels.
static double row_width(const float *values, int row)
{
    double width = 0.0;
    for (int x = 0; x < WIDTH; x++)
        width += (double)values[4 * (row * WIDTH + x)];
    return width;
}

static double widest_row(const float *values, int from, int to)
{
    double widest = 0.0;
    for (int row = from; row < to; row++)
        widest = fmax(widest, row_width(values, row));
    return widest;
}

// Check the widths of the two plates, which are 1 wide and whose faces are at the depths 4.999 and
// 8.999.
static void check_sizes(double aside, double u)
{
    const struct camera camera = {.position = {0.0f, 0.0f, 0.0f}};
    const double depth[2] = {4.999, 8.999}, framing = 5.0;
    set("aside", aside);
    float *values = coverage(&camera, u);
    double width[2] = {widest_row(values, 0, HEIGHT / 2), widest_row(values, HEIGHT / 2, HEIGHT)};
    for (int i = 0; i < 2; i++) {
        double expected = 2.0 * HEIGHT / 2 / (depth[i] + u * (framing - depth[i]));
        assert_true(fabs(width[i] - expected) < 0.3);
    }
    double ratio = width[0] / width[1];
    print_message("# %g beside the axis, u = %.2f: widths %.2f and %.2f pixels, ratio %.4f\n",
                  aside, u, width[0], width[1], ratio);
    if (u == 0.0)
        assert_true(fabs(ratio / (depth[1] / depth[0]) - 1.0) < 0.006);
    if (u == 1.0)
        assert_true(fabs(ratio - 1.0) < 0.002);
    free(values);
}

TEST(test_equal_plates_have_the_sizes_of_their_depths)
{
    assert_true(gpu_load(PLATES));
    for (int k = 0; k < PASSAGE; k++) {
        check_sizes(0.0, passage[k]);
        check_sizes(1.7, passage[k]);
    }
}

// Find the edges of the white part of a row, to a fraction of a pixel, outwards from a pixel that
// is completely white.
static void row_edges(const float *values, int row, double edge[2])
{
    int inside = 0;
    double left = 0.0, right = 0.0;
    while (inside < WIDTH && values[4 * (row * WIDTH + inside)] < 0.999f)
        inside++;
    assert_true(inside < WIDTH);
    for (int x = 0; x < WIDTH; x++)
        *(x < inside ? &left : &right) += (double)values[4 * (row * WIDTH + x)];
    edge[0] = inside - left;
    edge[1] = inside + right;
}

// Find the angles between the strip's two edges and the vertical in the picture, in degrees, from
// straight lines fitted to the edges of the rows.
static void edge_angles(const float *values, int from, int to, double angle[2])
{
    double n = to - from, row_sum = 0.0, row_square = 0.0, sum[2] = {0.0}, product[2] = {0.0};
    for (int row = from; row < to; row++) {
        double edge[2];
        row_edges(values, row, edge);
        row_sum += row;
        row_square += (double)row * row;
        for (int i = 0; i < 2; i++) {
            sum[i] += edge[i];
            product[i] += row * edge[i];
        }
    }
    for (int i = 0; i < 2; i++) {
        double slope = (n * product[i] - row_sum * sum[i]) / (n * row_square - row_sum * row_sum);
        angle[i] = atan(slope) * 180.0 / MIRROR_PI;
    }
}

// The position of a point of the world in the picture, in pixels, from the formula of
// docs/08_orthographic_view.md.
static void project(const struct camera *camera, double u, struct d3 p, double at[2])
{
    struct camera_basis basis = camera_basis_of(camera);
    struct d3 from = d3_sub(p, d3_of(camera->position));
    double depth = d3_dot(from, d3_of(basis.forward)), framing = 8.0;
    double scale = 2.0 / (depth + u * (framing - depth)) * HEIGHT / 2;
    at[0] = WIDTH / 2 + scale * d3_dot(from, d3_of(basis.right));
    at[1] = HEIGHT / 2 + scale * d3_dot(from, d3_of(basis.up));
}

static void check_edges(const struct camera *camera, double u, double angle[2])
{
    double near[2], far[2];
    project(camera, u, d3(0.0, -1.5, -6.0), near);
    project(camera, u, d3(0.0, -1.5, -14.0), far);
    float *values = coverage(camera, u);
    edge_angles(values, (int)near[1], (int)far[1], angle);
    for (int i = 0; i < 2; i++) {
        double a[2], b[2], x = i == 0 ? -0.5 : 0.5;
        project(camera, u, d3(x, -1.5, -6.0), a);
        project(camera, u, d3(x, -1.5, -14.0), b);
        double expected = atan2(b[0] - a[0], b[1] - a[1]) * 180.0 / MIRROR_PI;
        assert_true(fabs(angle[i] - expected) < 0.15);
    }
    free(values);
}

TEST(test_parallel_edges_stay_parallel)
{
    const struct camera camera = {.position = {2.0f, 1.5f, 0.0f}, .pan = -12.0f, .tilt = -20.0f};
    assert_true(gpu_load(PLATES));
    set("strip", 1.0);
    set("framingDistance", 8.0);
    for (int k = 0; k < PASSAGE; k++) {
        double angle[2];
        check_edges(&camera, passage[k], angle);
        print_message("# u = %.2f: the strip's edges are at %.2f and %.2f degrees to the vertical, "
                      "%.2f degrees apart\n",
                      passage[k], angle[0], angle[1], angle[1] - angle[0]);
        if (passage[k] == 1.0)
            assert_true(fabs(angle[1] - angle[0]) < 0.05);
        else
            assert_true(fabs(angle[1] - angle[0]) > 0.5);
    }
}

// ---- Chapter 08 ----

#define CHAPTER "08_orthographic_view"

static const double framing = 9.5;

static double depth_of(const struct camera *camera, struct d3 p)
{
    struct camera_basis basis = camera_basis_of(camera);
    return d3_dot(d3_sub(p, d3_of(camera->position)), d3_of(basis.forward));
}

// The column and the row, in pixels, at which the picture shows a point of the world.
static void pixel_of(const struct camera *camera, double u, struct d3 p, double at[2])
{
    struct camera_basis basis = camera_basis_of(camera);
    struct d3 from = d3_sub(p, d3_of(camera->position));
    double scale = HEIGHT / 2 * 2.0 / ((1.0 - u) * depth_of(camera, p) + u * framing);
    at[0] = WIDTH / 2 + scale * d3_dot(from, d3_of(basis.right));
    at[1] = HEIGHT / 2 + scale * d3_dot(from, d3_of(basis.up));
}

// True if the pixel at a position, moved up by `above` rows, is orange: more than twice as much red
// as blue. In this scene, only the frames are orange.
static bool is_orange(const float *values, const double at[2], double above)
{
    const float *v = values + 4 * ((int)(at[1] + above) * WIDTH + (int)at[0]);
    return v[0] > 2.2f * v[2];
}

// The upper far corner of a frame is the highest point of its outline: two pixels below the corner,
// the picture is orange; two pixels above, it is not.
static void check_frame_corner(const float *values, const struct camera *camera, double u,
                               struct d3 middle)
{
    double at[2];
    pixel_of(camera, u, d3_add(middle, d3(0.55, 0.55, -0.55)), at);
    assert_true(is_orange(values, at, -2.0));
    assert_false(is_orange(values, at, 2.0));
}

TEST(test_the_frames_have_the_sizes_of_their_depths)
{
    const struct d3 near = {-0.65, 0.55, 2.15}, far = {5.65, 0.55, -4.15};
    struct renderer_inputs inputs = {.width = WIDTH, .height = HEIGHT, .samples = 1};
    inputs.camera = gpu_open_chapter(CHAPTER);
    for (int k = 0; k <= 4; k++) {
        double u = 0.25 * k;
        set("orthographic", u);
        double m[2] = {depth_of(&inputs.camera, near), depth_of(&inputs.camera, far)};
        for (int i = 0; i < 2; i++)
            m[i] = (1.0 - u) * m[i] + u * framing;
        print_message(
            "# u = %.2f: scale of the near frame %.3f, of the far frame %.3f, ratio %.3f\n", u,
            framing / m[0], framing / m[1], m[1] / m[0]);
        float *values = gpu_numbers(&inputs);
        check_frame_corner(values, &inputs.camera, u, near);
        check_frame_corner(values, &inputs.camera, u, far);
        free(values);
    }
}

// The tower's top and the end of the channel behind it coincide in the picture only with parallel
// rays.
TEST(test_the_tower_meets_the_channel)
{
    struct camera camera;
    camera = gpu_camera(CHAPTER);
    struct camera_basis basis = camera_basis_of(&camera);
    struct d3 apart = d3(3.0, -3.0, -3.0);
    assert_true(fabs(d3_dot(apart, d3_of(basis.right))) < 1e-6);
    assert_true(fabs(d3_dot(apart, d3_of(basis.up))) < 1e-6);
    print_message(
        "# the tower's top and the channel's end are %.3f apart along the viewing direction\n",
        d3_dot(apart, d3_of(basis.forward)));
    for (int axis = 0; axis < 3; axis++) {
        struct d3 e = d3(axis == 0, axis == 1, axis == 2);
        double shown = hypot(d3_dot(e, d3_of(basis.right)), d3_dot(e, d3_of(basis.up)));
        assert_true(fabs(shown - sqrt(2.0 / 3.0)) < 1e-6);
    }
}

TESTS(gpu_setup, gpu_teardown)
