// keys.c - tests what a window shows after a key press, compared with the pictures that the command
// line writes: views, parameters, the panel, screenshots, full screen and sizes.
#include "context/context.h"
#include "lib/compare.h"
#include "lib/scratch.h"
#include "lib/session.h"
#include "platform.h"
#include "shader/view.h"
#include "window/keys.h"
#include "window/state.h"

#define CHAPTER "01_normal_colouring"

SESSION_TEST(the_window_opens_on_its_picture)
{
    session_open(CHAPTER, SESSION_STILL);
    session_assert_title(CHAPTER " - ");
    session_assert_title(" - picture - focalLength = 2");
    session_keep(0);
    session_key(GLFW_KEY_K);
    assert_true(session_off(0, NULL) > 0.06);
    session_key(GLFW_KEY_K);
    assert_true(session_off(0, NULL) <= 0.0);
    session_key(GLFW_KEY_H);
    session_assert_shown(CHAPTER, SESSION_STILL);
    assert_true(session_off(0, (const int[]){8, 8, 120, 90}) > 0.2);
    session_key(GLFW_KEY_H);
    assert_true(session_off(0, (const int[]){8, 8, 120, 90}) < 0.03);
    session_key(GLFW_KEY_BACKSPACE);
    assert_true(user.ended);
    session_close();
}

// True if a word is among the labels of a row.
static bool is_labelled(const struct key_row *row, const char *word)
{
    char labels[64], wanted[64];
    snprintf(labels, sizeof labels, " %s ", row->label);
    snprintf(wanted, sizeof wanted, " %s ", word);
    return strstr(labels, wanted) != NULL;
}

TEST(each_key_is_in_one_row)
{
    for (const struct key_row *row = window_keys; row->label != NULL; row++) {
        char labels[64];
        snprintf(labels, sizeof labels, "%s", row->label);
        for (const char *word = strtok(labels, " "); word != NULL; word = strtok(NULL, " "))
            for (const struct key_row *other = window_keys; other < row; other++)
                if (row->binding[0].key != 0 && other->binding[0].key != 0 &&
                    is_labelled(other, word))
                    fail_msg("'%s' is in two rows", word);
        for (int i = 0; i < KEY_BINDINGS; i++) {
            int key = row->binding[i].key;
            if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z &&
                !is_labelled(row, (const char[]){(char)key, '\0'}))
                fail_msg("%c is not among the labels of its row, '%s'", key, row->label);
        }
    }
}

// The list of keys shows the labels of the user's keyboard as soon as the window has the focus.
SESSION_TEST(a_french_keyboard_has_its_labels)
{
    user.unfocused = true;
    session_open(CHAPTER, "--size 640x360 --camera 1.65,1.6,3.4,-26,-23.5");
    session_key(GLFW_KEY_K);
    session_keep(0);
    session_turn();
    const int below[4] = {0, 290, 640, 70};
    assert_true(session_off(0, below) <= 0.0);
    user.unfocused = false;
    session_turn();
    assert_true(session_off(0, below) > 0.0006);
}

SESSION_TEST(keys_change_the_view)
{
    session_open_bare(CHAPTER, SESSION_STILL);
    for (int i = SHADER_VIEW_COUNT - 1; i >= 0; i--) {
        const char *name = shader_view_name((enum shader_view)i);
        char title[32];
        snprintf(title, sizeof title, " - %s - ", name);
        session_key((i % 2 == 0 ? GLFW_KEY_1 : GLFW_KEY_KP_1) + i);
        session_assert_title(title);
        session_assert_shown(CHAPTER, SESSION_STILL " --view %s", name);
    }
    session_key(GLFW_KEY_5);
    session_keep(0);
    user_wheel(1.0);
    session_turn();
    assert_true(session_off(0, NULL) > 0.01);
    user_wheel(-1.0);
    session_turn();
    assert_true(session_off(0, NULL) <= 0.0);
    session_assert_title("focalLength = 2");
}

SESSION_TEST(keys_change_parameters)
{
    static const struct {
        int key;
        bool shift;
        const char *title;
    } steps[] = {{GLFW_KEY_DOWN, false, "normalStep = 0.001"},
                 {GLFW_KEY_RIGHT, false, "normalStep = 0.002"},
                 {GLFW_KEY_RIGHT, true, "normalStep = 0.5"},
                 {GLFW_KEY_HOME, false, "normalStep = 0.001"},
                 {GLFW_KEY_LEFT, false, "normalStep = 0.0005"},
                 {GLFW_KEY_DELETE, false, "normalStep = 0.001"},
                 {GLFW_KEY_UP, false, "focalLength = 2"},
                 {GLFW_KEY_RIGHT, false, "focalLength = 2.1"}};
    session_open_bare(CHAPTER, SESSION_STILL);
    for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
        (steps[i].shift ? session_shift_key : session_key)(steps[i].key);
        session_assert_title(steps[i].title);
        if (steps[i].shift)
            session_assert_shown(CHAPTER, SESSION_STILL " --set normalStep=0.5");
    }
    session_key(GLFW_KEY_DELETE);
    user_wheel(1.0);
    session_turn();
    session_assert_title("focalLength = 2.2");
    session_assert_shown(CHAPTER, SESSION_STILL " --set focalLength=2.2");
    session_key(GLFW_KEY_DELETE);
    session_key(GLFW_KEY_TAB); // the shader has no orthographic view, so Tab has no effect
    session_wait(6.0);         // until the note on this is gone
    session_assert_shown(CHAPTER, SESSION_STILL);
}

SESSION_TEST(a_screenshot_is_the_picture)
{
    session_open(CHAPTER, SESSION_STILL);
    for (int i = 0; i < 2; i++) // the second screenshot must not replace the first
        session_assert_screenshot(CHAPTER, SESSION_STILL);
    session_close();
    struct image shot, shown;
    struct image_difference difference;
    session_open(CHAPTER, SESSION_STILL " --overlay"); // the screenshot contains the overlay
    user_look(&shown);
    session_shoot(&shot);
    assert_true(image_compare(&shot, &shown, &difference) && difference.f2 < 0.01);
    image_free(&shot);
    image_free(&shown);
    session_key(GLFW_KEY_H); // the screenshot's overlay must not stay in the window's picture
    session_assert_shown(CHAPTER, SESSION_STILL);
    session_close();
}

// A camera moved by the user shows the same picture as one placed on the command line. A drag turns
// the camera by 0.15 degrees per pixel.
SESSION_TEST(the_user_moves_the_camera)
{
    session_open_bare(CHAPTER, SESSION_STILL);
    user_drag(100, 100, 60, -40);
    session_turn();
    session_assert_shown(CHAPTER, "--size 320x200 --camera 1.65,1.6,3.4,-17,-17.5");
    session_key(GLFW_KEY_M);
    assert_true(user.captured);
    session_key(GLFW_KEY_M);
    assert_false(user.captured);
    user_press(GLFW_KEY_SPACE, 0);
    user.now += 0.05; // at 2 units per second
    user_release(GLFW_KEY_SPACE);
    session_turn();
    session_assert_shown(CHAPTER, "--size 320x200 --camera 1.65,1.7,3.4,-17,-17.5");
    session_shift_key(GLFW_KEY_R);
    session_assert_shown(CHAPTER, SESSION_STILL);
}

// The components of a vector are rows that the keys select.
SESSION_TEST(keys_change_one_component)
{
    const char *shader = scratch_write(
        "vector.frag", "#include \"main.glsl\"\n#include \"camera.glsl\"\n"
                       "uniform vec2 way; // (1, 2) in [0, 9] step 1: a way\n"
                       "uniform float far; // 5 in [0, 9] step 1: far\n"
                       "Ray pixelRay(vec2 screen) { return perspectiveRay(screen); }\n"
                       "float sceneDistance(vec3 p) { return p.y; }\n"
                       "vec3 rayColour(Ray ray) { return vec3(way, far); }\n");
    session_open_bare(CHAPTER, "--size 64x36 --shader %s --set way=1,2", shader);
    session_key(GLFW_KEY_DOWN); // from the focal length
    session_key(GLFW_KEY_RIGHT);
    session_assert_title("way = 2,3");
    session_key(GLFW_KEY_DOWN);
    session_key(GLFW_KEY_RIGHT);
    session_assert_title("way = 3,3");
    session_key(GLFW_KEY_DOWN);
    session_key(GLFW_KEY_LEFT);
    session_assert_title("way = 3,2");
    session_key(GLFW_KEY_DOWN);
    session_key(GLFW_KEY_RIGHT);
    session_assert_title("far = 6");
    session_key(GLFW_KEY_UP); // the last component
    session_key(GLFW_KEY_RIGHT);
    session_assert_title("way = 3,3");
    session_key(GLFW_KEY_UP);
    session_key(GLFW_KEY_DELETE);
    session_assert_title("way = 1,3");
    session_key(GLFW_KEY_UP);
    session_key(GLFW_KEY_DELETE);
    session_assert_title("way = 1,2");
    session_key(GLFW_KEY_UP);
    session_assert_title("focalLength = 2");
}

// A shader's cameraRoom determines where the camera stops. The command line may place the camera
// lower.
SESSION_TEST(the_camera_stops_at_the_ground)
{
    const char *shader = scratch_write(
        "ground.frag", "#include \"main.glsl\"\n#include \"camera.glsl\"\n"
                       "Ray pixelRay(vec2 screen) { return perspectiveRay(screen); }\n"
                       "float sceneDistance(vec3 p) { return p.y; }\n"
                       "float cameraRoom(vec3 p) { return sceneDistance(p) - 0.5; }\n"
                       "vec3 rayColour(Ray ray) { return vec3(ray.origin.y); }\n");
    session_open_bare(CHAPTER, "--size 64x36 --shader %s --camera 0,0.9,0,0,0", shader);
    user_press(GLFW_KEY_C, 0);
    session_wait(0.5); // at 2 units per second
    user_release(GLFW_KEY_C);
    session_turn();
    session_assert_shown(CHAPTER, "--size 64x36 --shader %s --camera 0,0.5,0,0,0", shader);
    session_close();
    session_open_bare(CHAPTER, "--size 64x36 --shader %s --camera 0,0.2,0,0,0", shader);
    session_assert_shown(CHAPTER, "--size 64x36 --shader %s --camera 0,0.2,0,0,0", shader);
    user_press(GLFW_KEY_SPACE, 0);
    session_wait(0.25);
    user_release(GLFW_KEY_SPACE);
    session_turn();
    session_assert_shown(CHAPTER, "--size 64x36 --shader %s --camera 0,0.7,0,0,0", shader);
}

SESSION_TEST(time_runs_and_can_be_paused)
{
    session_open_bare("00_first_scene", "--size 160x100");
    session_keep(0);
    session_wait(0.5);
    assert_true(session_off(0, NULL) > 0.01);
    session_assert_title(" 60 fps");
    session_key(GLFW_KEY_ESCAPE);
    session_assert_title("(paused)");
    session_keep(0);
    session_wait(0.5);
    assert_true(session_off(0, NULL) <= 0.0);
    session_key(GLFW_KEY_4); // the steps view, which a file with its own main does not have
    session_assert_title(" - picture");
    assert_true(session_off(0, NULL) > 0.01); // the overlay says why
    session_key(GLFW_KEY_R);                  // the next key removes what it says
    session_assert_shown("00_first_scene", "--size 160x100 --time 0");
    session_keep(0);
    session_key(GLFW_KEY_ESCAPE);
    session_wait(0.5);
    assert_true(session_off(0, NULL) > 0.01);
    session_key(GLFW_KEY_E); // this shader records no march, so no ray is selected
    session_close();
}

// The shader has its own main, and shows OrthoView as red.
SESSION_TEST(tab_switches_to_the_other_projection)
{
    scratch_write("whole.frag", "#version 330 core\nin float OrthoView;\nout vec4 FragColor;\n"
                                "void main() { FragColor = vec4(OrthoView, 0.0, 0.0, 1.0); }");
    session_open_bare("00_first_scene", "--size 16x10 --shader %s", scratch_path("whole.frag"));
    struct image image;
    int red[3];
    for (int i = 0; i < 3; i++) {
        user_look(&image);
        red[i] = image.pixel[0];
        image_free(&image);
        if (i == 0)
            session_key(GLFW_KEY_TAB);
        session_wait(i == 0 ? 0.2 : 0.5);
    }
    assert_true(red[0] == 0 && red[1] > 0 && red[1] < 255 && red[2] == 255);
}

// ---- Sizes ----

SESSION_TEST(f11_fills_the_monitor_below_the_window)
{
    session_open_bare(CHAPTER, SESSION_STILL);
    user.position[0] = 700;
    session_key(GLFW_KEY_F11);
    session_turn();
    assert_true(user.full && user.size[0] == 800 && user.size[1] == 600);
    session_assert_shown(CHAPTER, "--size 800x600 --camera 1.65,1.6,3.4,-26,-23.5");
    session_key(GLFW_KEY_F11);
    session_turn();
    assert_false(user.full);
    assert_true(user.position[0] == 700 && user.position[1] == 30);
    session_assert_shown(CHAPTER, SESSION_STILL);
}

// While the window's edge is dragged on Windows or macOS, GLFW's poll for events does not return,
// so the main loop does not run.
SESSION_TEST(a_size_is_shown_at_once)
{
    session_open_bare(CHAPTER, SESSION_STILL);
    static const int sizes[][2] = {{400, 260}, {240, 300}};
    for (int i = 0; i < 2; i++) {
        user_resize(sizes[i][0], sizes[i][1]);
        session_assert_shown(CHAPTER, "--size %dx%d --camera 1.65,1.6,3.4,-26,-23.5", sizes[i][0],
                             sizes[i][1]);
    }
    user_resize(0, 0); // the size of an iconified window on Windows
    session_turn();
    user_resize(320, 200);
    session_turn();
    session_assert_shown(CHAPTER, SESSION_STILL);
}

SESSION_TEST(a_dense_display_has_all_its_pixels)
{
    user.density = 2;
    session_open_bare(CHAPTER, "--size 160x100 --camera 1.65,1.6,3.4,-26,-23.5");
    session_assert_shown(CHAPTER, SESSION_STILL);
    session_click(85, 35);
    assert_non_null(strstr(session_said(1), "ray of pixel 170,129"));
    session_close();
}

// Both the picture and its slice start their marches where the coarse pass ended.
SESSION_TEST(two_passes_draw_one_picture)
{
    session_open_bare(CHAPTER, SESSION_STILL " --shader tests/shaders/coarse.frag");
    session_assert_shown(CHAPTER, SESSION_STILL " --shader tests/shaders/coarse.frag");
    session_key(GLFW_KEY_5);
    session_assert_shown(CHAPTER, SESSION_STILL " --shader tests/shaders/coarse.frag --view slice");
}

// ---- The loop ----

static void end_later(void)
{
    if (user.now > 10.0)
        user_press(GLFW_KEY_BACKSPACE, 0);
}

// A window in which nothing moves draws nothing, and waits for a tenth of a second at a time.
SESSION_TEST(a_still_window_rests)
{
    session_open(CHAPTER, SESSION_STILL);
    session_wait(1.0);
    int frames = user.frames;
    user.wait = end_later;
    assert_true(session_run());
    assert_int_equal(user.frames, frames + 1);
    assert_in_range(user.waits, 80, 100);
}

// The last value given to a hint; -1 if there was none.
static int hinted(int hint)
{
    int value = -1;
    for (int i = 0; i < user.hints; i++)
        value = user.hint[i][0] == hint ? user.hint[i][1] : value;
    return value;
}

// Check the hints for a visible window and for a hidden one.
SESSION_TEST(hints_are_those_that_a_mac_needs)
{
    session_open(CHAPTER, SESSION_STILL);
    static const int hints[][2] = {{GLFW_COCOA_MENUBAR, 1},
                                   {GLFW_CONTEXT_VERSION_MAJOR, 3},
                                   {GLFW_CONTEXT_VERSION_MINOR, 3},
                                   {GLFW_OPENGL_FORWARD_COMPAT, 1},
                                   {GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE},
                                   {GLFW_SCALE_TO_MONITOR, 1},
                                   {GLFW_VISIBLE, 1}};
    for (size_t i = 0; i < sizeof hints / sizeof *hints; i++)
        assert_int_equal(hinted(hints[i][0]), hints[i][1]);
    session_close();
    struct context hidden;
    assert_true(context_open_offscreen(&hidden, CONTEXT_GLFW));
    assert_int_equal(hinted(GLFW_COCOA_MENUBAR), 0); // a hidden window has no icon in the Dock
    assert_int_equal(hinted(GLFW_OPENGL_FORWARD_COMPAT), 1);
    assert_int_equal(hinted(GLFW_VISIBLE), 0);
    context_close(&hidden);
}

SESSION_TEST(a_key_opens_the_shader_in_an_editor)
{
    char text[4200], line[4200] = "";
    FILE *file = NULL;
    if (platform_display() == PLATFORM_OWN_DISPLAY)
        return; // $VISUAL has no meaning there
    scratch_write("flat.frag", "void mainImage(out vec4 c, in vec2 p) { c = vec4(0.3); }");
    snprintf(text, sizeof text, "echo \"$1\" >'%s'\n", scratch_path("opened"));
    scratch_write("editor", text);
    snprintf(text, sizeof text, "sh %s", scratch_path("editor"));
    platform_set("VISUAL", text, true);
    session_open(CHAPTER, "--size 320x200 --shader %s", scratch_path("flat.frag"));
    session_key(GLFW_KEY_V);
    for (double until = platform_seconds() + 60.0; platform_seconds() < until && line[0] == '\0';) {
        file = fopen(scratch_path("opened"), "r");
        if (file != NULL && fgets(line, sizeof line, file) == NULL)
            line[0] = '\0';
        if (file != NULL)
            fclose(file);
    }
    line[strcspn(line, "\n")] = '\0';
    assert_string_equal(line, scratch_path("flat.frag"));
    session_close();
    platform_set("VISUAL", "", true);
    platform_set("EDITOR", "", true);
    platform_set("PATH", scratch_path("nowhere"), true);
    session_open(CHAPTER, "--size 320x200 --shader %s", scratch_path("flat.frag"));
    session_key(GLFW_KEY_V);
    assert_non_null(strstr(session_said(2), "no editor: set VISUAL"));
    session_close();
}

TESTS(NULL, NULL)
