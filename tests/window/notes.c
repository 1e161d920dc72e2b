// notes.c - tests what a window says about its keys: the line with which a program begins, the list
// of K, and the notes of keys that do nothing here.
#include "lib/gpu.h"
#include "lib/scratch.h"
#include "lib/session.h"
#include "window/state.h"

#define CHAPTER "01_normal_colouring"

// The line that a chapter's program prints before its first picture must be this one.
static void assert_greets(const char *stem, const char *options, const char *line)
{
    session_open(stem, "--size 64x36 %s", options);
    session_said(1);
    session_key(GLFW_KEY_BACKSPACE);
    assert_true(session_run());
    assert_string_equal(session_said(1), line);
    session_close();
}

SESSION_TEST(a_program_begins_with_the_keys_that_act)
{
    assert_greets("00_first_scene", "", "K: keys, Backspace: quit\n");
    assert_greets("00_first_scene", "--shader chapters/figures/00_pixels.frag",
                  "K: keys, Backspace: quit\n");
    assert_greets(CHAPTER, "", "drag: look around, W A S D: move, K: keys, Backspace: quit\n");
}

// True if the list of keys has an entry for what a key does.
static bool lists(const char *does)
{
    const struct window *window = session_window();
    for (int i = 0; i < window->panel.key_count; i++)
        if (strcmp(window->panel.keys[i].does, does) == 0)
            return true;
    return false;
}

SESSION_TEST(the_list_has_the_keys_that_act)
{
    session_open("00_first_scene", "--size 320x200");
    assert_true(lists("pause") && !lists("move") && !lists("select ray") && !lists("view"));
    session_close();
    session_open(CHAPTER, "--size 320x200");
    assert_true(lists("move") && lists("select ray") && lists("view") && !lists("black screen"));
    session_close();
    session_open_lecture(NULL);
    assert_true(lists("black screen") && lists("chapter or scene") && !lists("part"));
    session_close();
}

// Chapter 00 does not read the camera, and the window says so once.
SESSION_TEST(a_key_that_does_nothing_says_why)
{
    session_open("00_first_scene", "--size 320x200 --time 0");
    session_key(GLFW_KEY_ESCAPE); // pauses
    session_wait(0.5);
    session_keep(0);
    for (int i = 0; i < 2; i++) {
        user_press(GLFW_KEY_W, 0);
        session_wait(0.2);
        user_release(GLFW_KEY_W);
        session_turn();
        assert_true((session_off(0, (const int[]){8, 130, 300, 60}) > 0.1) == (i == 0));
        session_wait(6.0);
        assert_true(session_off(0, (const int[]){8, 130, 300, 60}) <= 0.0);
    }
    session_close();
}

// A figure that looks from above may still have a focal length of its own, which the wheel changes.
SESSION_TEST(the_wheel_zooms_without_a_camera)
{
    session_open("00_first_scene", "--size 320x200 --shader chapters/figures/00_pixels.frag");
    assert_true(lists("zoom") && !lists("look around"));
    session_keep(0);
    user_point(250.0, 190.0);
    user_wheel(1.0);
    session_turn();
    assert_string_equal(session_window()->panel.note, "");
    assert_true(session_off(0, NULL) > 0.0);
    session_close();
    session_open("00_first_scene", "--size 320x200");
    user_wheel(1.0);
    session_turn();
    assert_non_null(strstr(session_window()->panel.note, "no focal length"));
    session_close();
}

SESSION_TEST(only_a_picture_with_a_camera_captures_the_mouse)
{
    session_open("00_first_scene", "--size 320x200 --time 0");
    session_key(GLFW_KEY_M);
    assert_false(user.captured);
    assert_non_null(strstr(session_window()->panel.note, "does not read the camera"));
    session_close();
    session_open(CHAPTER, "--size 320x200");
    for (int i = 0; i < 2; i++) {
        session_key(GLFW_KEY_M);
        assert_true(user.captured);
        assert_non_null(strstr(session_window()->panel.note, "M or Escape releases it"));
        session_key(i == 0 ? GLFW_KEY_M : GLFW_KEY_ESCAPE);
        assert_false(user.captured);
    }
    session_close();
}

SESSION_TEST(a_still_picture_is_neither_paused_nor_restarted)
{
    session_open(CHAPTER, "--size 320x200 --shader chapters/01_normal_colouring.frag");
    session_key(GLFW_KEY_ESCAPE);
    assert_false(session_titled("(paused)"));
    session_wait(6.0); // the overlay no longer says why
    session_keep(0);
    session_key(GLFW_KEY_R);
    assert_true(session_off(0, (const int[]){8, 130, 300, 60}) > 0.1); // it says what else R does
    session_close();
}

SESSION_TEST(a_selected_ray_changes_the_list_of_keys)
{
    session_open(CHAPTER, "--size 320x200 --shader chapters/01_normal_colouring.frag");
    assert_null(strstr(session_window()->panel.hint, "X: deselect ray"));
    session_key(GLFW_KEY_E); // the ray of the middle pixel
    assert_non_null(strstr(session_window()->panel.hint, "X: deselect ray"));
    session_key(GLFW_KEY_X);
    assert_null(strstr(session_window()->panel.hint, "X: deselect ray"));
    session_close();
}

// A figure without a march offers no steps and no views, and a click says why there is no ray.
SESSION_TEST(a_flat_figure_offers_no_steps)
{
    session_open("00_first_scene", "--size 320x200 --shader chapters/figures/00_distance.frag");
    struct window *window = session_window();
    assert_false(lists("view") || lists("select ray") || lists("step back, on"));
    session_key(GLFW_KEY_4);
    assert_int_equal(window->renderer->view, VIEW_PICTURE);
    assert_non_null(strstr(window->panel.note, "no ray marches in this picture"));
    session_key(GLFW_KEY_E);
    session_click(310.0, 190.0);
    assert_int_equal(window->inputs.pixel[0], -1);
    session_close();
}

SESSION_TEST(one_view_is_no_list_of_views)
{
    for (int i = 0; i < 2; i++) {
        session_open(i == 0 ? CHAPTER : "00_first_scene", "--size 640x360");
        const struct panel_row *row = session_window()->panel.rows.row;
        while (row->kind != PANEL_ROW_STATUS)
            row++;
        assert_true((row->cell[1][0] != '\0') == (i == 0)); // the mark that opens the list
        user_click((double)row->left + 20.0, (double)row->top + 4.0, GLFW_MOUSE_BUTTON_LEFT);
        session_turn();
        assert_true(session_window()->panel.views == (i == 0));
        session_close();
    }
}

// Whoever has turned away from the scene finds the key that brings it back.
SESSION_TEST(a_moved_camera_is_brought_back)
{
    session_open(CHAPTER, "--size 320x200 --set focalLength=1.5");
    struct window *window = session_window();
    session_keep(0);
    const char *hint = window->panel.hint;
    assert_null(strstr(hint, "camera back"));
    for (int i = 0; i < 2; i++) {
        user_point(250.0, 190.0);
        if (i == 0) {
            user_button(GLFW_MOUSE_BUTTON_LEFT, GLFW_PRESS);
            user_point(310.0, 100.0);
            user_button(GLFW_MOUSE_BUTTON_LEFT, GLFW_RELEASE);
        } else
            user_wheel(3.0);
        session_turn();
        assert_true(session_off(0, (const int[]){160, 0, 160, 100}) > 0.0);
        assert_non_null(strstr(hint, "Shift+R: camera back"));
        session_shift_key(GLFW_KEY_R);
        assert_null(strstr(hint, "camera back"));
        assert_true(session_off(0, (const int[]){160, 0, 160, 100}) <= 0.0);
    }
    session_close();
}

SESSION_TEST(only_the_course_has_pages_to_turn)
{
    session_open(CHAPTER, SESSION_STILL);
    struct window *window = session_window();
    session_key(GLFW_KEY_PAGE_DOWN);
    assert_non_null(strstr(window->panel.note, "make run"));
    assert_int_equal(window->inputs.pixel[0], -1);
    session_close();
}

SESSION_TEST(a_drag_without_a_camera_says_why)
{
    session_open("00_first_scene", "--size 320x200 --time 0");
    user_drag(250, 190, -40, 0);
    session_turn();
    assert_non_null(strstr(session_window()->panel.note, "does not read the camera"));
    session_close();
    // A drag that a shader follows by itself needs no note, even if only its kept frames do.
    static const char *const follows[] = {
        "void mainImage(out vec4 c, in vec2 p) { c = vec4(iMouse.xy / iResolution.xy, 0, 1); }",
        GPU_COURSE "uniform sampler2D history; // the last frame\n"
                   "vec4 frameKept(vec2 pixel) { return vec4(iMouse.xy / iResolution.xy, 0, 1); }\n"
                   "vec3 rayColour(Ray ray) { return texelFetch(history, iPixel, 0).rgb; }\n"};
    for (int i = 0; i < 2; i++) {
        session_open("00_first_scene", "--size 320x200 --shader %s",
                     scratch_write("follows.frag", follows[i]));
        user_drag(250, 190, -40, 0);
        session_turn();
        assert_string_equal(session_window()->panel.note, "");
        session_close();
    }
}

// Nobody turns a camera whose picture is not seen.
SESSION_TEST(the_slice_of_a_ray_keeps_the_camera)
{
    session_open(CHAPTER, SESSION_STILL);
    struct window *window = session_window();
    const struct camera before = window->inputs.camera;
    session_key(GLFW_KEY_5);
    session_key(GLFW_KEY_E);
    for (int i = 0; i < 2; i++) {
        user_drag(250, 190, -40, 0);
        session_turn();
        assert_non_null(strstr(window->panel.note, "1 shows the picture"));
        user_press(GLFW_KEY_W, 0);
        session_wait(0.3);
        user_release(GLFW_KEY_W);
        session_turn();
        window->panel.told = 0;
    }
    assert_memory_equal(&before, &window->inputs.camera, sizeof before);
    session_key(GLFW_KEY_1);
    user_drag(250, 190, -40, 0);
    session_turn();
    assert_memory_not_equal(&before, &window->inputs.camera, sizeof before);
    session_close();
}

// The hour that somebody chooses is the hour that is shown, however long the picture has run.
SESSION_TEST(a_chosen_hour_is_shown)
{
    session_open("09_sky_and_sunset", "--size 64x36 --time 20");
    struct window *window = session_window();
    assert_true(window->inputs.time > 19.0);
    snprintf(window->parameter, sizeof window->parameter, "timeOfDay");
    session_key(GLFW_KEY_RIGHT);
    assert_true(window->inputs.time < 10.0);
    session_close();
}

TESTS(NULL, NULL)
