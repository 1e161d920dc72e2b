// playback.c - tests one ray in the window, step by step: the slice, the plot and the picture show
// the ray as the command line does, and the ray stays in space while the camera moves.
#include "lib/session.h"
#include "lib/system.h"

#define CHAPTER "01_normal_colouring"
// The ray of the pixel that is 170 pixels from the left and 70 from the top.
#define RAY SESSION_STILL " --probe 170,129"

static void press_and_see(int key, const char *options)
{
    session_key(key);
    session_assert_shown(CHAPTER, "%s", options);
}

SESSION_TEST(a_window_opens_at_a_step)
{
    session_open_bare(CHAPTER, SESSION_STILL " --view slice --step 2");
    session_assert_shown(CHAPTER, SESSION_STILL " --view slice --step 2");
    press_and_see(GLFW_KEY_Q, SESSION_STILL " --view slice --step 1");
    session_said(1);
    session_close();
}

static int last_step(void)
{
    static char table[65536];
    int last = -1;
    assert_int_equal(system_run(CHAPTER, RAY, table, sizeof table), 0);
    for (const char *line = strtok(table, "\n"); line != NULL; line = strtok(NULL, "\n"))
        if (strchr(line, ',') != NULL && line[0] >= '0' && line[0] <= '9')
            last = atoi(line);
    return last;
}

SESSION_TEST(a_click_prints_the_table_of_the_command_line)
{
    static char told[65536], printed[65536];
    session_open_bare(CHAPTER, SESSION_STILL);
    session_keep(0);
    session_click(170, 70);
    snprintf(told, sizeof told, "%s", session_said(1));
    session_key(GLFW_KEY_H);
    session_key(GLFW_KEY_H);
    session_click(170, 70); // deselects the ray
    assert_string_equal(session_said(1), "");
    assert_true(session_off(0, NULL) <= 0.0);
    session_close();
    assert_int_equal(system_run(CHAPTER, RAY, printed, sizeof printed), 0);
    const char *table = strchr(told, '\n');
    assert_non_null(table);
    assert_memory_equal(told, "ray of pixel 170,129", 20);
    assert_non_null(strstr(printed, "# "));
    assert_memory_equal(table + 1, printed, strlen(printed));
}

SESSION_TEST(keys_step_along_the_march)
{
    char last[128], before[128];
    int steps = last_step();
    snprintf(last, sizeof last, RAY " --view slice --step %d", steps);
    snprintf(before, sizeof before, RAY " --view slice --step %d", steps - 1);
    session_open_bare(CHAPTER, SESSION_STILL);
    session_key(GLFW_KEY_5);
    session_click(170, 70);
    session_assert_shown(CHAPTER, RAY " --view slice");
    press_and_see(GLFW_KEY_Q, last); // from the whole march to its last step
    press_and_see(GLFW_KEY_Q, before);
    press_and_see(GLFW_KEY_HOME, RAY " --view slice --step 0");
    press_and_see(GLFW_KEY_E, RAY " --view slice --step 1");
    press_and_see(GLFW_KEY_Q, RAY " --view slice --step 0");
    press_and_see(GLFW_KEY_Q, RAY " --view slice --step 0");
    session_key(GLFW_KEY_PAGE_DOWN); // turns the pages of the course only, as a note says
    press_and_see(GLFW_KEY_Q, RAY " --view slice --step 0");
    user_repeat(GLFW_KEY_E, 0); // a held key repeats
    session_turn();
    session_assert_shown(CHAPTER, RAY " --view slice --step 1");
    press_and_see(GLFW_KEY_END, last);
    press_and_see(GLFW_KEY_E, last);
    session_key(GLFW_KEY_HOME);
    session_key(GLFW_KEY_E);
    press_and_see(GLFW_KEY_6, RAY " --view plot --step 1");
    session_key(GLFW_KEY_RIGHT); // the selected ray keeps its direction
    session_assert_title("focalLength = 2.1");
    session_assert_shown(CHAPTER, RAY " --view plot --step 1");
    session_key(GLFW_KEY_HOME); // goes to the first step and does not reset the parameter
    session_assert_title("focalLength = 2.1");
    session_key(GLFW_KEY_DELETE);
    session_assert_title("focalLength = 2");
    session_click(170, 70);
    session_assert_shown(CHAPTER, SESSION_STILL " --view plot");
    // The key E selects the ray of the middle pixel.
    press_and_see(GLFW_KEY_E, SESSION_STILL " --view plot --step 0");
    assert_non_null(strstr(session_said(1), "ray of pixel 160,100"));
    press_and_see(GLFW_KEY_X, SESSION_STILL " --view plot");
    session_close();
}

// A click on a line of the table shows the step of that line, and does not select the ray of the
// pixel behind the table.
SESSION_TEST(a_click_in_the_table_shows_a_step)
{
    const char *ray = "--size 640x360 --camera 1.65,1.6,3.4,-26,-23.5 --probe 400,200";
    const char *still = "--size 640x360 --camera 1.65,1.6,3.4,-26,-23.5 --overlay=1";
    session_open(CHAPTER, "%s", still);
    session_click(400, 159);
    assert_non_null(strstr(session_said(1), "ray of pixel 400,200"));
    for (int step = 0; step < 3; step += 2) {
        session_click(600, 50 + 12 * step); // the table is on the right
        assert_string_equal(session_said(1), "");
        session_key(GLFW_KEY_H);
        session_key(GLFW_KEY_5);
        session_assert_shown(CHAPTER, "%s --view slice --step %d", ray, step);
        session_key(GLFW_KEY_1);
        session_key(GLFW_KEY_H);
    }
    session_close();
}

// Both axes are scaled with the picture's height, so pixel 270,149 of 320x200 and pixel 405,224 of
// 480x300 show the same point.
SESSION_TEST(a_ray_outlives_a_new_size)
{
    session_open_bare(CHAPTER, SESSION_STILL " --view plot");
    session_click(270, 50);
    session_key(GLFW_KEY_HOME);
    session_keep(0);
    for (int width = 321; width < 330; width++) { // rounding errors must not accumulate
        user_resize(width, 200);
        session_turn();
    }
    user_resize(480, 300);
    session_assert_shown(CHAPTER, "--size 480x300 --camera 1.65,1.6,3.4,-26,-23.5 --view plot "
                                  "--probe 405,224 --step 0");
    user_resize(320, 200);
    assert_true(session_off(0, NULL) <= 0.0);
    user_resize(180, 200); // the picture no longer contains the pixel, so the ray is deselected
    session_assert_shown(CHAPTER, "--size 180x200 --camera 1.65,1.6,3.4,-26,-23.5 --view plot");
}

SESSION_TEST(a_ray_stays_in_space)
{
    char slice[128];
    snprintf(slice, sizeof slice, RAY " --view slice --step %d", last_step());
    session_open_bare(CHAPTER, SESSION_STILL);
    session_click(170, 70);
    session_key(GLFW_KEY_H); // shows a cross on the ray's pixel and, at a step, a dot in the cross
    session_keep(1);
    session_key(GLFW_KEY_HOME);
    assert_true(session_off(1, (const int[]){168, 68, 5, 5}) > 0.0);
    session_key(GLFW_KEY_H);
    session_key(GLFW_KEY_END);
    session_keep(0);
    user_press(GLFW_KEY_D, 0);
    session_wait(0.3);
    user_release(GLFW_KEY_D);
    session_turn();
    assert_true(session_off(0, NULL) > 0.01);
    press_and_see(GLFW_KEY_5, slice);
    session_keep(0);
    session_click(170, 70);
    session_click(170, 70); // selects the ray from the camera's new position
    assert_true(session_off(0, NULL) > 0.01);
}

SESSION_TEST(a_slice_follows_what_moves)
{
    session_open_bare("00_first_scene",
                      "--size 320x180 --shader chapters/experiments/00_seen.frag --view slice");
    session_keep(0);
    session_wait(0.3);
    assert_true(session_off(0, NULL) > 0.004);
    session_key(GLFW_KEY_ESCAPE);
    session_keep(0);
    session_wait(0.3);
    assert_true(session_off(0, NULL) <= 0.0);
}

// The lamp moves, so the march of the shadow ray changes, but the normals stay the same.
SESSION_TEST(the_inspector_follows_what_moves)
{
    session_open("03_shadows", "--size 640x360 --view normals");
    const int below[4] = {0, 46, 640, 314};
    session_keep(0);
    session_wait(0.5);
    assert_true(session_off(0, NULL) <= 0.0);
    session_click(380, 200);
    assert_true(session_off(0, NULL) > 0.02);
    session_keep(0);
    session_wait(0.5);
    assert_true(session_off(0, below) > 0.0);
}

// Chapter 10's handle aim follows the pointer. Half the picture's height shows 1.2 units.
SESSION_TEST(a_handle_is_dragged)
{
    const char *options = "--size 320x200 --camera 0,0,2.4,0,0";
    const double unit = 100.0 / 1.2, from[2] = {160.0 - 0.45 * unit, 100.0 + 0.06 * unit};
    session_open("10_distance_in_the_plane", "%s", options);
    session_key(GLFW_KEY_T); // the panel would cover the handle
    user_drag(from[0], from[1], 30.0, -25.0);
    session_turn();
    session_key(GLFW_KEY_H); // hides the marks of the handles; aim keeps its value
    session_assert_shown("10_distance_in_the_plane", "%s --set aim=%.3f,%.3f", options,
                         -0.45 + 30.0 / unit, -0.06 + 25.0 / unit);
}

TESTS(NULL, NULL)
