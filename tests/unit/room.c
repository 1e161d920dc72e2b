// room.c - tests that the camera stops at the ground and at the water. During random walks, the
// shader's cameraRoom is checked in double precision at the end of each move.
#include <dirent.h>

#include "lib/test.h"
#include "lib/gpu.h"
#include "picture/room.h"

enum { GROUND, BALL, CORNER, HILLS, SCENES };

static const char *const rooms[SCENES] = {
    [GROUND] = "p.y - 0.1",
    [BALL] = "length(p) - 1.1",
    [CORNER] = "min(p.y, p.x + 2.0) - 0.1",
    [HILLS] = "(p.y - 0.3 * sin(2.0 * p.x) * cos(p.z)) / 1.2 - 0.1", // a lower bound on the room
};

static double room_at(int scene, const float p[3])
{
    double x = (double)p[0], y = (double)p[1], z = (double)p[2];
    const double room[SCENES] = {y - 0.1, sqrt(x * x + y * y + z * z) - 1.1, fmin(y, x + 2.0) - 0.1,
                                 (y - 0.3 * sin(2.0 * x) * cos(z)) / 1.2 - 0.1};
    return room[scene];
}

static void load(const char *room)
{
    char text[1024];
    snprintf(text, sizeof text,
             GPU_COURSE "vec3 rayColour(Ray r) { return vec3(0.0); }\n"
                        "float cameraRoom(vec3 p) { return %s; }\n",
             room);
    assert_true(gpu_load_text(text));
    assert_int_equal(gpu.renderer.program[VIEW_ROOM], 0);
}

static void keep(const float from[3], float to[3])
{
    struct renderer_inputs inputs = {.width = 64, .height = 36, .samples = 1};
    memcpy(inputs.camera.position, from, sizeof inputs.camera.position);
    assert_true(glsl_find_definition(&gpu.renderer.fragment.code, "cameraRoom") == NULL ||
                renderer_link(&gpu.renderer, VIEW_ROOM));
    assert_true(room_keep(&gpu.renderer, &inputs, to));
}

static float random_from(unsigned *seed, float low, float high)
{
    *seed = *seed * 1664525u + 1013904223u;
    return low + (high - low) * (float)(*seed >> 8) / 16777216.0f;
}

// A move to a position with room is unchanged, bit for bit.
TEST(a_move_with_room_is_unchanged)
{
    unsigned seed = 7;
    int moves = 0;
    for (int scene = 0; scene < SCENES; scene++) {
        load(rooms[scene]);
        for (int i = 0; i < 100; i++) {
            float from[3], to[3], kept[3];
            for (int k = 0; k < 3; k++)
                from[k] = to[k] = kept[k] = random_from(&seed, -3.0f, 3.0f);
            to[0] = kept[0] += 0.03f;
            if (room_at(scene, to) < 0.001)
                continue;
            moves++;
            keep(from, kept);
            assert_memory_equal(to, kept, sizeof to);
        }
    }
    assert_true(moves > 100);
}

// Random walks, in which some steps are long, never reach a position without room.
TEST(no_walk_leads_into_the_scene)
{
    unsigned seed = 3;
    for (int scene = 0; scene < SCENES; scene++) {
        float at[3] = {0.0f, 2.0f, 0.0f};
        load(rooms[scene]);
        for (int i = 0; i < 300; i++) {
            float to[3], length = i % 10 == 0 ? 0.8f : 0.05f;
            for (int k = 0; k < 3; k++)
                to[k] = at[k] + random_from(&seed, -length, length) - (k == 1 ? 0.03f : 0.0f);
            keep(at, to);
            if (room_at(scene, to) < -1e-5)
                fail_msg("scene %d, step %d: the room at %g, %g, %g is %g", scene, i, (double)to[0],
                         (double)to[1], (double)to[2], room_at(scene, to));
            memcpy(at, to, sizeof at);
        }
        assert_true(at[1] < 1.0f || scene == BALL);
    }
}

// A camera that flies down at an angle stops above the ground, but continues sideways.
TEST(the_camera_slides_along_the_ground)
{
    float at[3] = {0.0f, 0.2f, 0.0f};
    load(rooms[GROUND]);
    for (int i = 0; i < 50; i++) {
        float to[3] = {at[0] + 0.02f, at[1] - 0.03f, at[2]};
        keep(at, to);
        memcpy(at, to, sizeof at);
    }
    assert_float_equal(at[0], 1.0f, 1e-4f);
    assert_float_equal(at[1], 0.1f, 0.001f);
}

// A camera that begins below the ground can move sideways and upwards, but goes no deeper.
TEST(a_camera_below_the_ground_can_leave_it)
{
    const float from[3] = {0.0f, -2.0f, 0.0f};
    float to[3] = {0.5f, -2.3f, 0.0f};
    load(rooms[GROUND]);
    keep(from, to);
    assert_float_equal(to[0], 0.5f, 1e-4f);
    assert_float_equal(to[1], -2.0f, 0.005f);
    float up[3] = {0.0f, -1.5f, 0.0f};
    keep(from, up);
    assert_float_equal(up[1], -1.5f, 1e-6f);
}

// If the room has no gradient to follow, the camera stays at its position.
TEST(without_a_gradient_the_camera_stays)
{
    const float from[3] = {0.0f, 0.5f, 0.0f};
    float to[3] = {0.0f, -0.5f, 0.0f};
    load("p.y > 0.0 ? 1.0 : -1.0");
    keep(from, to);
    assert_memory_equal(to, from, sizeof to);
}

// cameraRoom can read the scene's parameters and the variables that pixelRay sets.
TEST(the_room_depends_on_the_scene)
{
    const float from[3] = {0.0f, 5.0f, 0.0f};
    assert_true(gpu_load_text(
        "#include \"main.glsl\"\nuniform float level; // 1 in [0, 9]: height of the water\n"
        "float ready = 0.0;\nvec3 rayColour(Ray r) { return vec3(0.0); }\n"
        "Ray pixelRay(vec2 s) { ready = 1.0; return Ray(vec3(s, 0), vec3(0, 0, -1)); }\n"
        "float sceneDistance(vec3 p) { return p.y - level * ready; }\n"
        "float cameraRoom(vec3 p) { return sceneDistance(p); }\n"));
    for (int level = 1; level < 4; level++) {
        float to[3] = {0.0f, 0.9f, 0.0f};
        gpu_set("level", level);
        keep(from, to);
        assert_float_equal(to[1], (float)level, 0.05f);
    }
}

// If a shader has no cameraRoom, no program is compiled for it, and no move is changed.
TEST(a_scene_without_the_function_is_open)
{
    const float from[3] = {0.0f, 1.0f, 0.0f};
    float to[3] = {0.0f, -1.0f, 0.0f};
    assert_true(gpu_load_text(GPU_COURSE "vec3 rayColour(Ray r) { return vec3(0.0); }\n"));
    keep(from, to);
    assert_true(to[1] == -1.0f);
    assert_int_equal(gpu.renderer.program[VIEW_ROOM], 0);
}

// Every chapter's camera begins at a position with room: a camera that comes down to this position
// from the sky is not stopped.
TEST(every_chapter_begins_with_room)
{
    int asking = 0;
    DIR *folder = opendir("chapters");
    assert_non_null(folder);
    for (struct dirent *entry = readdir(folder); entry != NULL; entry = readdir(folder)) {
        char stem[sizeof entry->d_name];
        snprintf(stem, sizeof stem, "%s", entry->d_name);
        char *end = strstr(stem, ".frag");
        if (end == NULL || stem[0] < '0' || stem[0] > '9')
            continue;
        *end = '\0';
        struct camera camera = gpu_open_chapter(stem);
        float high[3] = {camera.position[0], 1000.0f, camera.position[2]}, to[3];
        memcpy(to, camera.position, sizeof to);
        keep(high, to);
        if (glm_vec3_distance(to, camera.position) > 0.0f)
            fail_msg("%s: the camera has no room at its start", stem);
        asking += gpu.renderer.program[VIEW_ROOM] != 0;
    }
    closedir(folder);
    assert_int_equal(asking, 18);
}

TESTS(gpu_setup, gpu_teardown)
