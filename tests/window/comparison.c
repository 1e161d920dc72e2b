// comparison.c - tests two pictures side by side in a window: the divider is dragged, both pictures
// follow the camera and the keys, and each has its own parameter values. tests/window/reload.c
// tests saved files.
#include "lib/compare.h"
#include "lib/scratch.h"
#include "lib/session.h"
#include "lib/system.h"

#define CHAPTER "01_normal_colouring"
#define PAIR    SESSION_STILL " --compare --set normalStep=0.4"

// Check that a screenshot equals the picture that the command line writes. Both have labels, but
// neither shows the handle of the window's divider.
static void assert_shot(const char *options, ...) __attribute__((format(printf, 1, 2)));
static void assert_shot(const char *options, ...)
{
    char line[1024];
    va_list values;
    va_start(values, options);
    vsnprintf(line, sizeof line, options, values);
    va_end(values);
    session_assert_screenshot(CHAPTER, line);
}

static void drag(double from, double to)
{
    user_drag(from, 150, to - from, 0);
    session_turn();
}

SESSION_TEST(the_divider_is_dragged)
{
    session_open_bare(CHAPTER, PAIR);
    assert_shot(PAIR);
    session_keep(0);
    drag(160, 96);
    assert_shot(PAIR " --divider 0.3");
    assert_true(session_off(0, (const int[]){96, 0, 64, 200}) > 0.01); // the window has changed too
    drag(96, 319);
    drag(318, 64);
    assert_shot(PAIR " --divider 0.2");
    session_keep(0);
    drag(100, 160); // a drag beside the divider turns both pictures
    assert_true(session_off(0, (const int[]){0, 0, 60, 200}) > 0.01);
    assert_true(session_off(0, (const int[]){70, 0, 250, 200}) > 0.01);
    session_shift_key(GLFW_KEY_R);
    assert_true(session_off(0, NULL) <= 0.0);
    session_key(GLFW_KEY_2);
    session_assert_title(" - normals - ");
    assert_shot(PAIR " --divider 0.2 --view normals");
    session_close();
}

SESSION_TEST(each_picture_has_its_own_values)
{
    session_open_bare(CHAPTER, PAIR " --divider 0.2");
    session_key(GLFW_KEY_RIGHT);
    session_assert_title("focalLength = 2.1");
    assert_shot(SESSION_STILL
                " --set focalLength=2.1 --compare --set normalStep=0.4 --divider 0.2");
    session_key(GLFW_KEY_DELETE);
    session_key(GLFW_KEY_DOWN);
    session_key(GLFW_KEY_RIGHT);
    session_assert_title("normalStep (left) = 0.002");
    assert_shot(SESSION_STILL
                " --set normalStep=0.002 --compare --set normalStep=0.4 --divider 0.2");
    session_key(GLFW_KEY_DELETE);
    session_key(GLFW_KEY_DOWN);
    session_assert_title("normalStep (right) = 0.4");
    session_key(GLFW_KEY_LEFT);
    session_assert_title("normalStep (right) = 0.2");
    assert_shot(SESSION_STILL " --compare --set normalStep=0.2 --divider 0.2");
    // In the panel, the parameter's row is 70 units below the top of the window.
    session_key(GLFW_KEY_H);
    session_turn();
    user_drag(60, 70, -20, 0);
    session_turn();
    session_assert_title("(right) = 0.0");
    for (int i = 0; i < 2; i++)
        user_click(40, 70, GLFW_MOUSE_BUTTON_LEFT);
    session_turn();
    session_turn();
    user_type("0.25");
    session_key(GLFW_KEY_ENTER);
    session_turn();
    session_assert_title("(right) = 0.25");
    user_wheel(-1.0);
    session_turn();
    session_assert_title("(right) = 0.125");
    session_key(GLFW_KEY_H);
    assert_shot(SESSION_STILL " --compare --set normalStep=0.125 --divider 0.2");
    session_key(GLFW_KEY_DELETE);
    session_assert_title("(right) = 0.001");
    session_close();
}

SESSION_TEST(a_click_selects_a_ray_of_the_clicked_picture)
{
    static char told[65536], printed[65536];
    session_open_bare(CHAPTER, PAIR " --divider 0.2");
    session_click(170, 100);
    snprintf(told, sizeof told, "%s", session_said(1));
    session_close();
    assert_int_equal(system_run(CHAPTER, SESSION_STILL " --set normalStep=0.4 --probe 170,99",
                                printed, sizeof printed),
                     0);
    assert_memory_equal(told, "ray of pixel 170,99", 19);
    assert_memory_equal(strchr(told, '\n') + 1, printed, strlen(printed));
}

SESSION_TEST(keys_change_a_parameter_of_only_one_picture)
{
    scratch_write("glowing.frag", "uniform float glow; // 0.25 in [0, 1]: light of the sky\n"
                                  "#include \"main.glsl\"\n#include \"camera.glsl\"\n"
                                  "Ray pixelRay(vec2 screen) { return perspectiveRay(screen); }\n"
                                  "float sceneDistance(vec3 p) { return 1.0; }\n"
                                  "vec3 rayColour(Ray ray) { return vec3(glow); }\n");
    const char *path = scratch_path("glowing.frag");
    session_open_bare(CHAPTER, SESSION_STILL " --compare %s --divider 0.2", path);
    session_key(GLFW_KEY_UP);
    session_assert_title("glow (right) = 0.25");
    session_key(GLFW_KEY_RIGHT);
    session_assert_title("glow (right) = 0.26");
    assert_shot(SESSION_STILL " --compare %s --set glow=0.26 --divider 0.2",
                scratch_path("glowing.frag"));
    session_close();
}

// This dense display has two pixels per unit of the window.
SESSION_TEST(l_shows_one_picture_after_the_other)
{
    session_open_bare(CHAPTER, PAIR " --divider 0.2");
    session_key(GLFW_KEY_L);
    assert_shot(PAIR " --divider 1");
    session_keep(0);
    session_key(GLFW_KEY_L);
    assert_true(session_off(0, (const int[]){70, 0, 180, 150}) > 0.01);
    assert_shot(PAIR " --divider 0");
    session_key(GLFW_KEY_L);
    assert_shot(PAIR " --divider 1");
    drag(319, 96); // the line is at the edge
    assert_shot(PAIR " --divider 0.3");
    session_shift_key(GLFW_KEY_L);
    assert_shot(PAIR);
    session_close();
    session_open_bare(CHAPTER, SESSION_STILL);
    session_keep(0);
    session_key(GLFW_KEY_L); // the overlay says why nothing happens
    assert_true(session_off(0, NULL) > 0.0);
    session_wait(5.0);
    assert_true(session_off(0, NULL) <= 0.0);
    session_close();
}

// A lecturer must not show whose file it is.
SESSION_TEST(labels_hide_the_names_of_the_files)
{
    static const char *const names[][2] = {{"ada.frag", "solution.frag"}, {"ben.frag", "x.frag"}};
    for (int labelled = 0; labelled < 2; labelled++)
        for (int i = 0; i < 2; i++) {
            char path[2][4096];
            for (int k = 0; k < 2; k++)
                snprintf(path[k], sizeof path[k], "%s",
                         scratch_write(names[i][k], "#include \"01_normal_colouring.frag\"\n"));
            session_open_bare(CHAPTER, SESSION_STILL " --shader %s --compare %s%s", path[0],
                              path[1], labelled ? " --labels mine,yours" : "");
            session_assert_title(labelled ? CHAPTER " - " : names[i][0]);
            if (i == 0)
                session_keep(0);
            else
                assert_int_equal(session_off(0, NULL) > 0.0, !labelled);
            session_close();
        }
}

SESSION_TEST(on_a_dense_display_the_divider_follows_the_pointer)
{
    user.density = 2;
    session_open_bare(CHAPTER, "--size 160x100 --camera 1.65,1.6,3.4,-26,-23.5 --compare --set "
                               "normalStep=0.4");
    user_drag(80, 75, -32, 0);
    session_turn();
    assert_shot(PAIR " --divider 0.3");
    session_close();
}

TESTS(NULL, NULL)
