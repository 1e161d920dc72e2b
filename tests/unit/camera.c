// camera.c - tests that the eye's frame is orthonormal and right-handed, the tilt stops at its
// limit, the pan wraps, and the path of a moving camera does not depend on the frame rate.
#include "lib/test.h"
#include "camera.h"

#define ANGLES 20000
#define NEAR   1e-6

// A random number in [0, 1), from a linear congruential generator with Knuth's constants, so that
// the angles are the same on every machine.
static double next_random(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) / 9007199254740992.0;
}

static struct camera random_camera(uint64_t *seed)
{
    return (struct camera){.pan = (float)(720.0 * next_random(seed) - 360.0),
                           .tilt = (float)(178.0 * next_random(seed) - 89.0)};
}

static double dot(const float a[3], const float b[3])
{
    return (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] + (double)a[2] * (double)b[2];
}

static void assert_near(double value, double expected, double tolerance)
{
    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%.9g differs from %.9g by more than %g", value, expected, tolerance);
}

static void assert_vector(const float v[3], double x, double y, double z, double tolerance)
{
    assert_near((double)v[0], x, tolerance);
    assert_near((double)v[1], y, tolerance);
    assert_near((double)v[2], z, tolerance);
}

TEST(test_basis_is_orthonormal)
{
    uint64_t seed = 1;
    for (int i = 0; i < ANGLES; i++) {
        struct camera camera = random_camera(&seed);
        struct camera_basis b = camera_basis_of(&camera);
        assert_near(dot(b.right, b.right), 1.0, NEAR);
        assert_near(dot(b.up, b.up), 1.0, NEAR);
        assert_near(dot(b.forward, b.forward), 1.0, NEAR);
        assert_near(dot(b.right, b.up), 0.0, NEAR);
        assert_near(dot(b.up, b.forward), 0.0, NEAR);
        assert_near(dot(b.forward, b.right), 0.0, NEAR);
    }
}

TEST(test_basis_is_right_handed_and_upright)
{
    uint64_t seed = 2;
    for (int i = 0; i < ANGLES; i++) {
        struct camera camera = random_camera(&seed);
        struct camera_basis b = camera_basis_of(&camera);
        vec3 cross;
        glm_vec3_cross(b.right, b.up, cross);
        assert_vector(cross, -(double)b.forward[0], -(double)b.forward[1], -(double)b.forward[2],
                      NEAR);
        assert_near((double)b.right[1], 0.0, 0.0);
        assert_true(b.up[1] > 0.0f);
        assert_near((double)b.forward[1], sin((double)camera.tilt * GLM_PI / 180.0), NEAR);
    }
}

TEST(test_pan_and_tilt_turn_the_frame)
{
    struct camera camera = {.pan = 0.0f};
    struct camera_basis b = camera_basis_of(&camera);
    assert_vector(b.forward, 0.0, 0.0, -1.0, NEAR);
    assert_vector(b.right, 1.0, 0.0, 0.0, NEAR);
    assert_vector(b.up, 0.0, 1.0, 0.0, NEAR);
    camera.pan = 90.0f;
    assert_vector(camera_basis_of(&camera).forward, 1.0, 0.0, 0.0, NEAR);
    camera = (struct camera){.tilt = 30.0f};
    assert_vector(camera_basis_of(&camera).forward, 0.0, 0.5, -sqrt(0.75), NEAR);
}

TEST(test_tilt_stops_at_its_limit)
{
    struct camera camera = {.tilt = 80.0f};
    camera_turn(&camera, 0.0f, 30.0f);
    assert_true(camera.tilt == CAMERA_TILT_LIMIT);
    camera_turn(&camera, 0.0f, -1.0f);
    assert_near((double)camera.tilt, 88.0, NEAR);
    camera_turn(&camera, 0.0f, -1e6f);
    assert_true(camera.tilt == -CAMERA_TILT_LIMIT);
}

TEST(test_pan_wraps)
{
    const double turns[][3] = {{170.0, 20.0, -170.0}, {-170.0, -20.0, 170.0},
                               {0.0, 180.0, -180.0},  {0.0, -180.0, -180.0},
                               {10.0, 3600.0, 10.0},  {-10.0, -3600.0, -10.0}};
    for (size_t i = 0; i < sizeof turns / sizeof *turns; i++) {
        struct camera camera = {.pan = (float)turns[i][0]};
        camera_turn(&camera, (float)turns[i][1], 0.0f);
        assert_near((double)camera.pan, turns[i][2], 1e-4);
    }
    uint64_t seed = 3;
    struct camera camera = {.pan = 0.0f};
    for (int i = 0; i < ANGLES; i++) {
        camera_turn(&camera, (float)(2000.0 * next_random(&seed) - 1000.0), 0.0f);
        assert_true(camera.pan >= -180.0f && camera.pan < 180.0f);
    }
    camera.pan = nextafterf(180.0f, 0.0f);
    camera_turn(&camera, 1e-5f, 0.0f);
    assert_true(camera.pan >= -180.0f && camera.pan < 180.0f);
}

TEST(test_wrapping_keeps_the_view)
{
    struct camera wrapped = {.pan = 170.0f}, plain = {.pan = 215.0f};
    camera_turn(&wrapped, 45.0f, 0.0f);
    struct camera_basis a = camera_basis_of(&wrapped), b = camera_basis_of(&plain);
    assert_vector(a.forward, (double)b.forward[0], (double)b.forward[1], (double)b.forward[2],
                  NEAR);
}

// Move the camera for one second at a speed of 3, in steps of equal length, and return it.
static struct camera walk(struct camera camera, const float direction[3], int steps)
{
    for (int i = 0; i < steps; i++)
        camera_move(&camera, direction, 3.0f / (float)steps);
    return camera;
}

TEST(test_path_does_not_depend_on_the_frame_rate)
{
    uint64_t seed = 4;
    for (int i = 0; i < 100; i++) {
        struct camera start = random_camera(&seed);
        const float direction[3] = {(float)(i % 3 - 1), (float)(i / 3 % 3 - 1),
                                    (float)(i / 9 % 3 - 1)};
        struct camera one = walk(start, direction, 1);
        const float *end = one.position;
        struct camera ten = walk(start, direction, 10), thousand = walk(start, direction, 1000);
        assert_vector(ten.position, (double)end[0], (double)end[1], (double)end[2], 1e-4);
        assert_vector(thousand.position, (double)end[0], (double)end[1], (double)end[2], 1e-4);
    }
}

TEST(test_every_direction_is_equally_fast)
{
    uint64_t seed = 5;
    for (int i = 0; i < 27 * 100; i++) {
        const float direction[3] = {(float)(i % 3 - 1), (float)(i / 3 % 3 - 1),
                                    (float)(i / 9 % 3 - 1)};
        bool still = direction[0] == 0.0f && direction[1] == 0.0f && direction[2] == 0.0f;
        struct camera camera = random_camera(&seed);
        camera_move(&camera, direction, 3.0f);
        assert_near(sqrt(dot(camera.position, camera.position)), still ? 0.0 : 3.0, 1e-5);
    }
}

TEST(test_movement_follows_the_view)
{
    struct camera camera = {.pan = 90.0f};
    camera_move(&camera, (const float[3]){0.0f, 0.0f, 1.0f}, 2.0f);
    assert_vector(camera.position, 2.0, 0.0, 0.0, NEAR);
    camera_move(&camera, (const float[3]){1.0f, 0.0f, 0.0f}, 2.0f);
    assert_vector(camera.position, 2.0, 0.0, 2.0, NEAR);
    camera.tilt = 60.0f;
    camera_move(&camera, (const float[3]){0.0f, 5.0f, 0.0f}, 1.0f);
    assert_vector(camera.position, 2.0, 1.0, 2.0, NEAR);
    camera_move(&camera, (const float[3]){0.0f, 0.0f, -1.0f}, 1.0f);
    assert_vector(camera.position, 1.5, 1.0 - sqrt(0.75), 2.0, NEAR);
}

TESTS(NULL, NULL)
