// last_frame.c - tests a shader that reads what it has kept of the last frame, in a window: each
// turn of the loop draws the next frame, with a fixed time from frame to frame.
#include "lib/gpu.h"
#include "lib/scratch.h"
#include "lib/session.h"
#include "picture/passes.h"
#include "shader/text_file.h"
#include "window/frames.h"
#include "window/state.h"

#define CHAPTER "01_normal_colouring"

static const char text[] =
    "#include \"main.glsl\"\n#include \"march.glsl\"\n#include \"random.glsl\"\n"
    "uniform float gain; // 1 in [0, 4]: brightness\n"
    "uniform float seed; // 3 in [0, 100]: other numbers\n"
    "uniform sampler2D history; // the last frame\n"
    "Ray pixelRay(vec2 screen) { return Ray(vec3(screen, 4.0), vec3(0.0, 0.0, -1.0)); }\n"
    "float sceneDistance(vec3 p) { return p.z; }\n"
    "vec4 frameKept(vec2 pixel)\n"
    "{\n"
    "    float number = fract(pixelRandom(int(seed)) + iTime);\n"
    "    return mix(texelFetch(history, iPixel, 0), vec4(number), 1.0 / float(iFrame + 1));\n"
    "}\n"
    "vec3 rayColour(Ray ray)\n"
    "{\n"
    "    march(ray, 0.0, 9.0, 0.001, 64);\n"
    "    return gain * texelFetch(history, iPixel, 0).rgb;\n"
    "}\n";

// The same without the time.
static const char still[] =
    GPU_COURSE "#include \"random.glsl\"\n"
               "uniform sampler2D history; // the last frame\n"
               "uniform float gain; // 1 in [0, 4]: brightness\n"
               "vec4 frameKept(vec2 pixel)\n"
               "{\n"
               "    return mix(texelFetch(history, iPixel, 0), vec4(gain * pixelRandom(3)),\n"
               "               1.0 / float(iFrame + 1));\n"
               "}\n"
               "vec3 rayColour(Ray ray) { return texelFetch(history, iPixel, 0).rgb; }\n";

static int frame(void)
{
    return session_window()->inputs.frame;
}

// The number of frames that the window's renderer has kept.
static int kept(void)
{
    return session_window()->renderer->kept.frames;
}

static void open(const char *options)
{
    scratch_write("mean.frag", text);
    session_open_bare(CHAPTER, "--size 320x200 --shader %s %s", scratch_path("mean.frag"), options);
}

// Check that the window shows a frame of the command line, as does a screenshot.
static void assert_frame(int number, const char *options)
{
    char line[1024];
    assert_int_equal(frame(), number);
    assert_int_equal(kept(), number + 1);
    snprintf(line, sizeof line, "--size 320x200 --shader %s --frame %d %s",
             scratch_path("mean.frag"), number, options);
    session_assert_shown(CHAPTER, "%s", line);
    session_assert_screenshot(CHAPTER, line);
    session_said(1);
    assert_int_equal(frame(), number);
}

// The clock of the test moves a sixtieth of a second in each turn; a slow machine changes nothing.
SESSION_TEST(each_turn_draws_one_frame)
{
    open("");
    int first = frame();
    for (int i = 1; i < 6; i++) {
        user.now += 0.25 * (i % 2);
        session_turn();
        assert_int_equal(frame(), first + i);
    }
    session_key(GLFW_KEY_ESCAPE);
    assert_frame(first + 6, "");
    session_close();
    open("--time 2 --fps 10 --frame 30");
    session_wait(0.1);
    session_key(GLFW_KEY_ESCAPE);
    assert_frame(frame(), "--time 2 --fps 10");
    session_close();
}

SESSION_TEST(a_pause_keeps_the_frame)
{
    open("");
    session_wait(0.2);
    session_key(GLFW_KEY_ESCAPE);
    int paused = frame();
    session_wait(2.0);
    assert_frame(paused, "");
    session_key(GLFW_KEY_4);
    session_key(GLFW_KEY_1);
    session_click(100, 100);
    session_click(100, 100);
    session_said(1);
    assert_frame(paused, "");
    session_close();
}

// A change of what a frame reads begins again, and a change of what only the picture reads does
// not.
SESSION_TEST(a_change_begins_again)
{
    open("--set seed=3");
    session_wait(0.3);
    session_key(GLFW_KEY_RIGHT); // gain
    int before = frame();
    assert_true(before > 10);
    session_key(GLFW_KEY_DOWN); // seed
    session_key(GLFW_KEY_RIGHT);
    session_turn();
    assert_true(frame() < 4);
    session_wait(0.2);
    assert_true(frame() > 8);
    session_key(GLFW_KEY_R);
    session_turn();
    assert_true(frame() < 4);
    session_wait(0.2);
    user_resize(300, 200);
    session_turn();
    assert_true(frame() < 4);
    session_close();
}

SESSION_TEST(a_saved_shader_begins_again)
{
    open("");
    session_wait(0.5);
    assert_true(frame() > 20);
    scratch_write("mean.frag", text);
    session_wait(0.3);
    session_said(1);
    assert_true(frame() < 20);
    session_key(GLFW_KEY_ESCAPE);
    assert_frame(frame(), "");
    session_close();
}

SESSION_TEST(a_window_stops_at_the_frame_that_was_asked_for)
{
    open("--frame 12");
    session_wait(1.0);
    int shown = user.frames;
    assert_frame(12, "");
    session_wait(1.0);
    assert_true(user.frames - shown < 10);
    session_key(GLFW_KEY_DOWN);
    session_key(GLFW_KEY_RIGHT);
    session_wait(0.05);
    assert_true(frame() < 8);
    session_wait(1.0);
    assert_int_equal(frame(), 12);
    session_close();
}

// A slow picture is drawn small. Its size is chosen in the first frames and then stays, because
// frames of another size would begin again.
SESSION_TEST(a_slow_picture_keeps_its_size)
{
    user.pixel_seconds = 0.15 / (320 * 200);
    open("");
    while (frame() < 70) // earlier, a level that is far too coarse is given up
        session_turn();
    int level = session_window()->pace.resolution.level, before = frame();
    assert_true(level > 0);
    assert_true(before > 5);
    user.pixel_seconds /= 8.0;
    session_wait(1.0);
    assert_int_equal(session_window()->pace.resolution.level, level);
    assert_true(frame() > before);
    session_key(GLFW_KEY_ESCAPE);
    before = frame();
    session_wait(2.0); // a picture at rest would be sharpened
    assert_int_equal(frame(), before);
    assert_int_equal(kept(), before + 1);
    assert_int_equal(session_window()->sharpening.rows, 0);
    session_click(100, 120);
    session_said(1);
    assert_true(session_window()->renderer->kept.target[0].width < 320);
    float pixel = session_window()->ray.probe->step[0].pixel[0]; // where the overlay marks the step
    assert_true(fabsf(pixel - 100.0f) < 4.0f);
    session_click(100, 120);
    struct image image;
    session_shoot(&image);
    assert_true(image.width < 320);
    assert_non_null(strstr(session_window()->panel.note, "% of the window's width"));
    image_free(&image);
    session_close();
}

// Kept frames have one sample for each pixel, so there is nothing to smooth.
// While a driver is still compiling, each pixel seems to take long. The frames that are kept do not
// hold the coarse resolution that this costs.
SESSION_TEST(a_slow_beginning_is_forgotten)
{
    user.pixel_seconds = 0.005;
    open("");
    for (int i = 0; i < 8; i++)
        session_turn();
    assert_true(session_window()->pace.resolution.level > 16 && frame() > 3);
    user.pixel_seconds = 0.0;
    session_wait(1.0);
    assert_int_equal(session_window()->pace.resolution.level, 0);
    assert_true(frame() > 3 && kept() == frame() + 1);
}

// Open a mean whose pixels take long, and draw some frames. Returns the level that has been chosen.
static int open_slow_mean(int frames)
{
    scratch_write("still.frag", still);
    user.pixel_seconds = 4e-5;
    session_open_bare(CHAPTER, "--size 320x200 --shader %s", scratch_path("still.frag"));
    for (int i = 0; i < frames; i++)
        session_turn();
    return session_window()->pace.resolution.level;
}

// A mean that is calm begins again with more pixels, however slow its frames become; a picture that
// somebody changes is quick again.
SESSION_TEST(a_calm_mean_becomes_finer)
{
    int level = open_slow_mean(100);
    assert_true(level > 6 && frame() > 90);
    for (int i = 0; i < 100; i++)
        session_turn();
    assert_int_equal(session_window()->pace.resolution.level, level - 6);
    assert_true(frame() > 60 && frame() < 80 && kept() == frame() + 1);
    session_key(GLFW_KEY_RIGHT);
    for (int i = 0; i < 10; i++)
        session_turn();
    assert_true(session_window()->pace.resolution.level >= level - 1);
    user.pixel_seconds = 0.0;
    session_close();
}

// Only the frames that are kept follow the camera here, as in chapter 24.
SESSION_TEST(a_kept_frame_follows_the_camera)
{
    scratch_write("kept.frag", GPU_COURSE
                  "uniform sampler2D history; // the last frame\n"
                  "vec4 frameKept(vec2 pixel) { return vec4(fract(iCameraPosition), 1); }\n"
                  "vec3 rayColour(Ray ray) { return texelFetch(history, iPixel, 0).rgb; }\n");
    session_open_bare(CHAPTER, "--size 320x200 --shader %s", scratch_path("kept.frag"));
    session_wait(0.2);
    session_keep(0);
    user_press(GLFW_KEY_W, 0);
    session_wait(0.1);
    user_release(GLFW_KEY_W);
    session_turn();
    assert_true(session_off(0, NULL) > 0.9);
    session_close();
}

// Nothing moves in a mean, so a pause lets it become finer at once, as it sharpens other pictures.
SESSION_TEST(a_paused_mean_becomes_finer)
{
    int level = open_slow_mean(20), before = frame();
    session_key(GLFW_KEY_ESCAPE);
    session_assert_title("(paused)");
    for (int i = 0; i < 10; i++)
        session_turn();
    assert_int_equal(session_window()->pace.resolution.level, level - 6);
    assert_true(frame() > 3 && frame() < before && kept() == frame() + 1);
    before = frame();
    session_key(GLFW_KEY_ESCAPE);
    for (int i = 0; i < 10; i++)
        session_turn();
    assert_true(frame() > before); // the mean goes on
    user.pixel_seconds = 0.0;
    session_close();
}

SESSION_TEST(a_kept_frame_is_not_smoothed)
{
    session_smooths = true;
    open("");
    session_wait(0.2);
    session_key(GLFW_KEY_ESCAPE);
    session_wait(2.0);
    assert_int_equal(session_window()->sharpening.inputs.samples, 1);
    assert_false(session_window()->sharpening.smooths);
    session_close();
    session_smooths = false;
}

// An export with buffers, whose frames do not depend on the time or the camera.
SESSION_TEST(an_export_runs_in_a_window)
{
    char path[512], copy[512], *export = NULL;
    snprintf(path, sizeof path, "%s/tests/shaders/buffers/AB.json", gpu_project_root());
    export = text_file_read(path, copy);
    assert_non_null(export);
    snprintf(copy, sizeof copy, "%s", scratch_write("AB.json", export));
    session_open_bare(CHAPTER, "--size 320x200 --shader %s --frame 40", copy);
    session_wait(0.2);
    int before = frame();
    assert_true(before > 5 && before < 40);
    session_click(120, 100); // the pointer and the ray are no part of the key
    session_click(120, 100);
    session_said(1);
    assert_true(frame() > before);
    session_wait(1.0);
    assert_int_equal(frame(), 40);
    session_assert_shown(CHAPTER, "--size 320x200 --shader %s --frame 40", copy);
    user_resize(300, 200);
    session_turn();
    assert_true(frame() < 4);
    session_wait(1.0);
    session_assert_shown(CHAPTER, "--size 300x200 --shader %s --frame 40", copy);
    scratch_write("AB.json", export);
    session_wait(0.3);
    session_said(1);
    assert_true(frame() < 20);
    session_wait(1.0);
    assert_int_equal(frame(), 40);
    session_key(GLFW_KEY_R);
    session_turn();
    assert_true(frame() < 4);
    session_close();
    free(export);
}

// Rounding would darken a mean in half floats, which telephones may have instead of floats.
SESSION_TEST(a_mean_in_half_floats_stops)
{
    open("");
    struct kept *kept = &session_window()->renderer->kept;
    assert_int_equal(window_last_frame(session_window()), -1);
    for (int i = 0; i < 2; i++)
        kept->target[i].format = GL_RGBA16F;
    assert_int_equal(window_last_frame(session_window()), -1); // it depends on the time
    session_close();
    scratch_write("mean.frag", still);
    session_open_bare(CHAPTER, "--size 320x200 --shader %s", scratch_path("mean.frag"));
    kept = &session_window()->renderer->kept;
    assert_int_equal(window_last_frame(session_window()), -1);
    for (int i = 0; i < 2; i++)
        kept->target[i].format = GL_RGBA16F;
    session_wait(2.0);
    assert_int_equal(frame(), 63);
    session_close();
}

// Scenes with the same shader pass their renderer on, and each begins with its frame 0.
SESSION_TEST(each_scene_of_a_lecture_begins_again)
{
    char list[2048], path[512];
    scratch_write("mean.frag", text);
    snprintf(path, sizeof path, "%s", scratch_path("mean.frag"));
    snprintf(list, sizeof list, "01 --shader %s --frame 40\n01 --shader %s --frame 9\n", path,
             path);
    session_open_lecture(scratch_write("list.txt", list));
    session_wait(1.0);
    assert_int_equal(frame(), 40);
    session_key(GLFW_KEY_PAGE_DOWN);
    session_wait(0.06);
    assert_true(frame() < 8);
    session_wait(1.0);
    assert_int_equal(frame(), 9);
    assert_int_equal(kept(), 10);
    session_said(1);
    session_close();
}

TESTS(NULL, NULL)
