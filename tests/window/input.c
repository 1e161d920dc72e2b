// input.c - tests the effects of the keys and the pointer. The test calls GLFW's callbacks as GLFW
// would, without a window and at times that it sets.
#include "dialects/tool_inputs.h"
#include "lib/test.h"
#include "lib/user.h"
#include "window/actions.h"
#include "window/colour_picker.h"
#include "window/field.h"
#include "window/keys.h"
#include "window/lens.h"
#include "window/state.h"

static struct window tested;

static void drag(double right, double down)
{
    user_drag(user.pointer[0], user.pointer[1], right, down);
}

// ---- The tested window ----

static GLint always_there(GLuint program, const GLchar *name)
{
    (void)program, (void)name;
    return 0;
}

static struct gl gl = {.GetUniformLocation = always_there};
static struct renderer renderer = {.gl = &gl};
static int shown; // the number of immediate redraws that were requested
static const struct window_start start = {.camera = {.position = {1, 2, 3}, .pan = 10, .tilt = 20}};

static void show(void *to)
{
    ++*(int *)to;
}

static int set_up(void **unused)
{
    (void)unused;
    // Make the shader appear to read the camera, the time and OrthoView, so that Tab changes the
    // projection.
    static const char *const names[] = {"OrthoView", "iCameraPosition", "iTime", "focalLength"};
    static struct shader_input read[4];
    for (int i = 0; i < 4; i++)
        read[i] = inputs_default(tool_inputs_find(names[i]));
    renderer.fragment.inputs = read;
    renderer.fragment.input_count = 4;
    renderer.fragment.marches = true;
    renderer.program[VIEW_PICTURE] = 1;
    user_reset();
    shown = 0;
    renderer.orthographic = 0.0;
    renderer.focal_length = RENDERER_FOCAL_LENGTH;
    tested = (struct window){.renderer = &renderer, .start = &start};
    tested.inputs = (struct renderer_inputs){.width = 320, .height = 200, .pixel = {-1, -1}};
    tested.inputs.camera = start.camera;
    window_input_open(&tested.input, NULL, show, &shown);
    user_point(100, 100);
    return 0;
}

static void assert_turned(double pan, double tilt)
{
    window_act(&tested);
    const struct camera *camera = &tested.inputs.camera;
    if (fabs((double)camera->pan - pan) > 1e-4 || fabs((double)camera->tilt - tilt) > 1e-4)
        fail_msg("pan %g, tilt %g; expected %g, %g", (double)camera->pan, (double)camera->tilt, pan,
                 tilt);
}

// Act on the input. Returns the camera's distance from its starting position.
static double travelled(void)
{
    window_act(&tested);
    float way[3];
    glm_vec3_sub(tested.inputs.camera.position, (float *)start.camera.position, way);
    return (double)glm_vec3_norm(way);
}

// If all these events arrive in one poll, the pointer is already at the end of the drag when GLFW
// reports the focus.
TEST_WITH(a_drag_right_after_the_focus_turns_the_camera, set_up, NULL)
{
    user_focus(true);
    user.pointer[0] = 140;
    user_button(GLFW_MOUSE_BUTTON_LEFT, GLFW_PRESS);
    user_point(140, 100);
    user_button(GLFW_MOUSE_BUTTON_LEFT, GLFW_RELEASE);
    assert_turned(16, 20);
}

TEST_WITH(a_free_pointer_does_not_turn_the_camera, set_up, NULL)
{
    user_point(200, 150);
    user_focus(false);
    user_point(20, 50);
    assert_turned(10, 20);
}

TEST_WITH(a_captured_pointer_turns_the_camera, set_up, NULL)
{
    user_press(GLFW_KEY_M, 0);
    assert_turned(10, 20);
    user_point(3000, 2000); // the origin of a captured pointer's position is arbitrary
    user_point(3040, 1980);
    assert_turned(16, 23);
    user.pointer[0] = 100;
    user.pointer[1] = 100;
    user_press(GLFW_KEY_M, 0);
    user_point(140, 90); // in the same iteration
    assert_turned(16, 23);
    user_point(100, 100);
    drag(-40, 20);
    assert_turned(10, 20);
}

TEST_WITH(a_click_selects_a_ray, set_up, NULL)
{
    drag(2, 1); // a hand may tremble during a click
    assert_turned(10, 20);
    assert_int_equal(tested.inputs.pixel[0], 100);
    assert_int_equal(tested.inputs.pixel[1], 99);
    user_press(GLFW_KEY_X, 0);
    window_act(&tested);
    assert_true(tested.inputs.pixel[0] == -1 && tested.dirty);
}

// A click's position is measured in the window's units from the top left, but a pixel's from the
// bottom left. On a dense display, a unit is 2 or 1.5 pixels wide.
TEST_WITH(a_click_finds_its_pixel_on_any_display, set_up, NULL)
{
    static const struct {
        int picture[2];
        double position[2];
        int pixel[2];
    } cases[] = {
        {{640, 360}, {0.0, 0.0}, {0, 359}},        {{640, 360}, {639.0, 359.0}, {639, 0}},
        {{640, 360}, {380.9, 200.2}, {380, 159}},  {{1280, 720}, {380.0, 200.0}, {760, 319}},
        {{1280, 720}, {380.5, 200.5}, {761, 318}}, {{1280, 720}, {639.5, 359.5}, {1279, 0}},
        {{960, 540}, {100.0, 100.0}, {150, 389}},  {{960, 540}, {0.7, 359.9}, {1, 0}}};
    user.size[0] = 640;
    user.size[1] = 360;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        tested.inputs.width = cases[i].picture[0];
        tested.inputs.height = cases[i].picture[1];
        user_click(cases[i].position[0], cases[i].position[1], GLFW_MOUSE_BUTTON_LEFT);
        window_act(&tested);
        for (int k = 0; k < 2; k++)
            assert_int_equal(tested.inputs.pixel[k], cases[i].pixel[k]);
    }
}

TEST_WITH(events_take_effect_in_their_order, set_up, NULL)
{
    drag(40, 0);
    user_press(GLFW_KEY_R, GLFW_MOD_SHIFT);
    assert_turned(10, 20);
    drag(40, 0);
    user_press(GLFW_KEY_R, GLFW_MOD_SHIFT);
    drag(-20, 0);
    assert_turned(7, 20);
}

TEST_WITH(the_wheel_zooms, set_up, NULL)
{
    user.calls.wheel(NULL, 0.0, 1.0);
    user.calls.wheel(NULL, 0.0, 1.0);
    window_act(&tested);
    assert_true(fabsf(renderer.focal_length - 1.21f) < 1e-5f);
    user.calls.wheel(NULL, 1.0, 0.0);
    tested.moved = false;
    window_act(&tested);
    assert_false(tested.moved);
}

// The camera moves at 2 units per second while the key is down, or at 8 while Shift or F is held
// too, however many iterations of the main loop run in that time.
TEST_WITH(a_held_key_moves, set_up, NULL)
{
    user_press(GLFW_KEY_W, 0);
    user.now = 0.05;
    window_act(&tested);
    user.now = 0.125;
    user_release(GLFW_KEY_W);
    user.now = 7.0;
    assert_true(fabs(travelled() - 0.25) < 1e-5);
    user_press(GLFW_KEY_LEFT_SHIFT, 0);
    user_press(GLFW_KEY_S, 0);
    user.now = 7.03125;
    assert_true(travelled() < 1e-5);
    user_release(GLFW_KEY_LEFT_SHIFT);
    user_release(GLFW_KEY_S);
    user_press(GLFW_KEY_F, 0);
    assert_false(window_input_moves(&tested.input));
    user_press(GLFW_KEY_W, 0);
    user.now = 7.0625;
    assert_true(fabs(travelled() - 0.25) < 1e-5);
}

// In a slow frame, the press and the release of a tap arrive at the same time; it moves the camera.
TEST_WITH(a_tap_moves_however_slow_the_frames_are, set_up, NULL)
{
    user.now = 1.0;
    user_press(GLFW_KEY_W, 0);
    user_release(GLFW_KEY_W);
    assert_true(fabs(travelled() - 0.06) < 1e-5);
    user.now = 2.0;
    user_release(GLFW_KEY_W); // of a press in another window
    assert_true(fabs(travelled() - 0.06) < 1e-5);
}

// A key's way is its direction: how far to the right, up and forward. Right and forward are those
// of the camera, but up is that of the world.
TEST_WITH(each_key_has_its_direction, set_up, NULL)
{
    static const struct {
        int key, way[3];
    } keys[] = {{GLFW_KEY_W, {0, 0, 1}},
                {GLFW_KEY_S, {0, 0, -1}},
                {GLFW_KEY_D, {1, 0, 0}},
                {GLFW_KEY_A, {-1, 0, 0}},
                {GLFW_KEY_SPACE, {0, 1, 0}},
                {GLFW_KEY_C, {0, -1, 0}},
                {GLFW_KEY_LEFT_CONTROL, {0, -1, 0}}};
    struct camera_basis eye = camera_basis_of(&start.camera);
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        const int *way = keys[i].way;
        set_up(NULL);
        user_press(keys[i].key, 0);
        user.now = 0.05;
        assert_true(fabs(travelled() - 0.1) < 1e-5);
        for (int axis = 0; axis < 3; axis++) {
            float expected = 0.1f * ((float)way[0] * eye.right[axis] + (float)way[1] * (axis == 1) +
                                     (float)way[2] * eye.forward[axis]);
            float went = tested.inputs.camera.position[axis] - start.camera.position[axis];
            assert_true(fabsf(went - expected) < 1e-5f);
        }
    }
}

TEST_WITH(opposite_keys_do_not_move, set_up, NULL)
{
    user_press(GLFW_KEY_A, 0);
    user_press(GLFW_KEY_D, 0);
    user.now = 0.05;
    assert_true(travelled() <= 0.0);
    assert_false(tested.moved);
}

TEST_WITH(a_stall_of_the_machine_hardly_moves_the_camera, set_up, NULL)
{
    user_press(GLFW_KEY_W, 0);
    user.now = 60.0;
    assert_true(fabs(travelled() - 0.2) < 1e-5);
}

TEST_WITH(losing_the_focus_releases_the_keys, set_up, NULL)
{
    user_press(GLFW_KEY_W, 0);
    user_focus(false);
    user.now = 0.05;
    assert_true(travelled() <= 0.0);
}

TEST_WITH(damage_is_shown_again, set_up, NULL)
{
    window_act(&tested);
    assert_false(tested.dirty);
    user.calls.damage(NULL);
    assert_int_equal(shown, 1);
    window_act(&tested);
    assert_true(tested.dirty);
    tested.dirty = false;
    window_act(&tested);
    assert_false(tested.dirty);
}

TEST_WITH(any_number_of_keys_can_wait, set_up, NULL)
{
    for (int i = 0; i < 10 * WINDOW_INPUT_EVENTS; i++)
        user_press(i % 2 == 0 ? GLFW_KEY_H : GLFW_KEY_K, 0);
    assert_int_equal(tested.input.events, WINDOW_INPUT_EVENTS);
    window_act(&tested);
    assert_int_equal(tested.input.events, 0);
}

// The transition takes half a second. Pressing Tab during the transition reverses it.
TEST_WITH(tab_changes_the_projection_gradually, set_up, NULL)
{
    user_press(GLFW_KEY_TAB, 0);
    window_act(&tested);
    for (int i = 1; i <= 4; i++) {
        assert_true(window_continue_transition(&tested, 0.1));
        assert_true(fabs(renderer.orthographic - 0.2 * i) < 1e-9);
    }
    assert_true(window_continue_transition(&tested, 0.1001));
    assert_true(renderer.orthographic == 1.0);
    assert_false(window_continue_transition(&tested, 0.1));
    user_press(GLFW_KEY_TAB, 0);
    window_act(&tested);
    assert_true(window_continue_transition(&tested, 0.1));
    user_press(GLFW_KEY_TAB, 0);
    window_act(&tested);
    assert_true(window_continue_transition(&tested, 0.2));
    assert_true(renderer.orthographic == 1.0);
}

// In a field for one number, a comma counts as a decimal point, as on a French keyboard. A
// character that no number contains is refused with a message.
TEST_WITH(a_field_accepts_only_numbers, set_up, NULL)
{
    struct parameter item[] = {{.name = "size", .components = 1, .maximum = 9.0, .value = {5.0}},
                               {.name = "way", .components = 2, .maximum = 9.0}};
    struct renderer typed_into = {.gl = &gl,
                                  .fragment = renderer.fragment,
                                  .program[VIEW_PICTURE] = 1,
                                  .parameters = {.item = item, .count = 2}};
    tested.renderer = &typed_into;
    tested.grab.what = GRAB_VALUE;
    tested.grab.part = -1;
    window_field_open(&tested);
    for (const char *c = "\xe9&_(wE"; *c != '\0'; c++) { // the key H must not hide the panel
        user_press(GLFW_KEY_H, 0);
        user.calls.letter(NULL, (unsigned char)*c);
        window_act(&tested);
        assert_true((tested.grab.refused[0] != '\0') == (*c != 'E'));
    }
    assert_string_equal(tested.grab.typed, "E");
    assert_false(tested.panel.folded);
    user_press(GLFW_KEY_BACKSPACE, 0);
    for (const char *c = "7,25"; *c != '\0'; c++)
        user.calls.letter(NULL, (unsigned char)*c);
    user_press(GLFW_KEY_ENTER, 0);
    window_act(&tested);
    assert_true(item[0].value[0] == 7.25 && !tested.input.typing);
    // A comma separates numbers in the field of a vector, but not in that of a single component.
    snprintf(tested.parameter, sizeof tested.parameter, "way");
    window_field_open(&tested);
    for (const char *c = "1,2.5"; *c != '\0'; c++)
        user.calls.letter(NULL, (unsigned char)*c);
    user_press(GLFW_KEY_ENTER, 0);
    window_act(&tested);
    assert_true(item[1].value[0] == 1.0 && item[1].value[1] == 2.5);
    tested.grab.part = 1;
    window_field_open(&tested);
    for (const char *c = "3,5"; *c != '\0'; c++)
        user.calls.letter(NULL, (unsigned char)*c);
    user_press(GLFW_KEY_ENTER, 0);
    window_act(&tested);
    assert_true(item[1].value[0] == 1.0 && item[1].value[1] == 3.5);
    // A press in the picture closes the field, and a drag turns the camera.
    window_field_open(&tested);
    drag(40, 0);
    assert_turned(16, 20);
    assert_false(tested.input.typing);
}

// Escape closes an open picker and does not resume. A press elsewhere closes the picker and selects
// no ray. When the picker is closed, Escape resumes.
TEST_WITH(a_picker_closes, set_up, NULL)
{
    struct parameter colour = {.name = "tint",
                               .components = 3,
                               .maximum = 1.0,
                               .unit = "linear RGB",
                               .value = {0.5, 0.25, 0.125}};
    struct renderer coloured = {.gl = &gl,
                                .fragment = renderer.fragment,
                                .program[VIEW_PICTURE] = 1,
                                .parameters = {.item = &colour, .count = 1}};
    tested.renderer = &coloured;
    tested.panel.overlay.scale = 1.0f;
    tested.paused = true;
    window_picker_open(&tested);
    assert_true(tested.input.picker_open);
    user_press(GLFW_KEY_ESCAPE, 0);
    window_act(&tested);
    assert_true(!tested.input.picker_open && tested.paused);
    window_picker_open(&tested);
    drag(2, 1);
    assert_turned(10, 20);
    assert_false(tested.input.picker_open);
    assert_int_equal(tested.inputs.pixel[0], -1);
    window_picker_open(&tested);
    tested.grab.picker = (struct picker){
        .left = 50, .top = 50, .width = 104, .height = 86, .side = 72, .value = {-1.0}};
    drag(-200, -200); // the drag starts at (102, 101), in the picker's square
    window_act(&tested);
    assert_true(tested.input.picker_open && tested.moved);
    for (int k = 0; k < 3; k++)
        assert_true(colour.value[k] == 1.0);
    assert_turned(10, 20);
    tested.dirty = false; // as if the panel had been drawn without the picker's row
    tested.grab.picker.width = 0.0f;
    window_act(&tested);
    assert_false(tested.input.picker_open);
    user_press(GLFW_KEY_ESCAPE, 0);
    window_act(&tested);
    assert_false(tested.paused);
    // Once the picker is closed, a drag in the picture turns the camera again.
    drag(40, 0);
    assert_turned(16, 20);
}

// Each effect is listed with its keys, labelled as on a French keyboard.
TEST_WITH(every_key_is_listed, set_up, NULL)
{
    char views[64] = "1 \u00e9";
    for (int i = 3; i <= SHADER_VIEW_COUNT; i++)
        snprintf(views + strlen(views), sizeof views - strlen(views), " %d", i);
    const char *const listed[][2] = {
        {"move", "Z Q S D"},      {"up, down", "Space C"},
        {"look around", "drag"},  {"capture mouse", "\",\""},
        {"step back, on", "A E"}, {"select ray", "click"},
        {"zoom", "wheel"},        {"view", views},
        {"pause", "Esc"},         {"orthographic", "Tab"},
        {"screenshot", "P"},      {"full screen", "F11"},
        {"quit", "Backspace"},    {"restart, with camera", "R Shift+R"}};
    tested.has_keyboard = true;
    window_list_keys(&tested);
    int usual = 0;
    for (const struct key_row *row = window_keys; row->label != NULL; row++)
        usual += row->condition <= KEY_WITH_TIME || row->condition == KEY_WITH_EDITOR ||
                 row->condition == KEY_WITH_PROJECTIONS;
    assert_int_equal(tested.panel.key_count, usual);
    for (size_t i = 0; i < sizeof listed / sizeof *listed; i++) {
        int at = 0;
        while (at < tested.panel.key_count && strcmp(tested.panel.keys[at].does, listed[i][0]) != 0)
            at++;
        assert_true(at < tested.panel.key_count);
        assert_string_equal(tested.panel.keys[at].label, listed[i][1]);
    }
}

// While a ray is selected, Home goes to its first step and does not show the contents.
TEST_WITH(the_contents_are_offered_without_a_ray, set_up, NULL)
{
    const struct contents contents = {0};
    struct window_start course = start;
    course.contents = &contents;
    tested.start = &course;
    assert_true(window_key_acts(&tested, KEY_WITH_CONTENTS));
    tested.inputs.pixel[0] = 3;
    assert_false(window_key_acts(&tested, KEY_WITH_CONTENTS));
}

TESTS(NULL, NULL)
