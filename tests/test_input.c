// test_input.c - what the hands do, and what becomes of it: GLFW's callbacks are called as GLFW
// calls them, without a window and at times that the test says.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#ifdef HAVE_GLFW

#include "../common/window/state.h"

// ---- In place of GLFW ----

static struct {
    double now, pointer[2]; // of the clock; where the pointer is by now
    GLFWkeyfun key;
    GLFWmousebuttonfun button;
    GLFWcursorposfun pointed;
    GLFWcursorenterfun entered;
    GLFWcharfun letter;
    GLFWscrollfun wheel;
    GLFWwindowfocusfun focus;
    GLFWwindowrefreshfun damage;
    int shown; // how often the window asked to be shown at once
} hands;

static struct window tested;

double glfwGetTime(void)
{
    return hands.now;
}

void glfwGetCursorPos(GLFWwindow *window, double *xpos, double *ypos)
{
    (void)window;
    *xpos = hands.pointer[0];
    *ypos = hands.pointer[1];
}

void glfwGetWindowSize(GLFWwindow *window, int *width, int *height)
{
    (void)window;
    *width = 320;
    *height = 200;
}

void glfwSetWindowUserPointer(GLFWwindow *window, void *pointer)
{
    (void)window, (void)pointer;
}

void *glfwGetWindowUserPointer(GLFWwindow *window)
{
    (void)window;
    return &tested.input;
}

void glfwSetInputMode(GLFWwindow *window, int mode, int value)
{
    (void)window, (void)mode, (void)value;
}

#define TAKE(function, type, member)                                                               \
    type function(GLFWwindow *window, type callback)                                               \
    {                                                                                              \
        (void)window;                                                                              \
        hands.member = callback;                                                                   \
        return NULL;                                                                               \
    }
TAKE(glfwSetKeyCallback, GLFWkeyfun, key)
TAKE(glfwSetMouseButtonCallback, GLFWmousebuttonfun, button)
TAKE(glfwSetCursorPosCallback, GLFWcursorposfun, pointed)
TAKE(glfwSetCharCallback, GLFWcharfun, letter)
TAKE(glfwSetCursorEnterCallback, GLFWcursorenterfun, entered)
TAKE(glfwSetScrollCallback, GLFWscrollfun, wheel)
TAKE(glfwSetWindowFocusCallback, GLFWwindowfocusfun, focus)
TAKE(glfwSetWindowRefreshCallback, GLFWwindowrefreshfun, damage)

// ---- Hands ----

static void press(int key, int modifiers)
{
    hands.key(NULL, key, 0, GLFW_PRESS, modifiers);
}

static void release(int key)
{
    hands.key(NULL, key, 0, GLFW_RELEASE, 0);
}

static void point(double x, double y)
{
    hands.pointer[0] = x;
    hands.pointer[1] = y;
    hands.pointed(NULL, x, y);
}

static void button(int action)
{
    hands.button(NULL, GLFW_MOUSE_BUTTON_LEFT, action, 0);
}

static void drag(double right, double down)
{
    button(GLFW_PRESS);
    point(hands.pointer[0] + right, hands.pointer[1] + down);
    button(GLFW_RELEASE);
}

// ---- A window that nobody sees ----

static GLint always_there(GLuint program, const GLchar *name)
{
    (void)program, (void)name;
    return 0;
}

static struct gl gl = {.GetUniformLocation = always_there};
static struct renderer renderer = {.gl = &gl};
static const struct window_start start = {.camera = {.position = {1, 2, 3}, .pan = 10, .tilt = 20}};

static void show(void *to)
{
    ++*(int *)to;
}

static int set_up(void **unused)
{
    (void)unused;
    memset(&hands, 0, sizeof hands);
    renderer.orthographic = 0.0;
    renderer.focal_length = RENDERER_FOCAL_LENGTH;
    tested = (struct window){.renderer = &renderer, .start = &start};
    tested.inputs = (struct renderer_inputs){.width = 320, .height = 200, .pixel = {-1, -1}};
    tested.inputs.camera = start.camera;
    window_input_open(&tested.input, NULL, show, &hands.shown);
    point(100, 100);
    return 0;
}

static void assert_turned(double pan, double tilt)
{
    window_obey(&tested);
    const struct camera *camera = &tested.inputs.camera;
    if (fabs((double)camera->pan - pan) > 1e-4 || fabs((double)camera->tilt - tilt) > 1e-4)
        fail_msg("pan %g, tilt %g, not %g, %g", (double)camera->pan, (double)camera->tilt, pan,
                 tilt);
}

// How far the eye went since the start.
static double travelled(void)
{
    window_obey(&tested);
    float way[3];
    glm_vec3_sub(tested.inputs.camera.position, (float *)start.camera.position, way);
    return (double)glm_vec3_norm(way);
}

static void a_drag_turns(void **unused)
{
    (void)unused;
    drag(40, -20);
    assert_turned(16, 23);
    assert_int_equal(tested.inputs.pixel[0], -1);
}

// All of it waits in one poll, and by then the pointer is at the drag's end.
static void a_drag_behind_a_focus_turns(void **unused)
{
    (void)unused;
    hands.focus(NULL, GLFW_TRUE);
    hands.pointer[0] = 140;
    button(GLFW_PRESS);
    point(140, 100);
    button(GLFW_RELEASE);
    assert_turned(16, 20);
}

static void the_free_pointer_turns_nothing(void **unused)
{
    (void)unused;
    point(200, 150);
    hands.focus(NULL, GLFW_FALSE);
    point(20, 50);
    assert_turned(10, 20);
}

static void a_captured_pointer_looks(void **unused)
{
    (void)unused;
    press(GLFW_KEY_M, 0);
    point(3000, 2000); // where GLFW counts from is its own affair
    point(3040, 1980);
    assert_turned(16, 23);
    hands.pointer[0] = 100;
    hands.pointer[1] = 100;
    press(GLFW_KEY_M, 0);
    assert_turned(16, 23);
    drag(-40, 20);
    assert_turned(10, 20);
}

static void a_click_chooses_a_ray(void **unused)
{
    (void)unused;
    drag(2, 1); // a hand trembles
    assert_turned(10, 20);
    assert_int_equal(tested.inputs.pixel[0], 100);
    assert_int_equal(tested.inputs.pixel[1], 99);
    press(GLFW_KEY_X, 0);
    window_obey(&tested);
    assert_true(tested.inputs.pixel[0] == -1 && tested.dirty);
}

static void what_comes_first_is_done_first(void **unused)
{
    (void)unused;
    drag(40, 0);
    press(GLFW_KEY_R, GLFW_MOD_SHIFT);
    assert_turned(10, 20);
    drag(40, 0);
    press(GLFW_KEY_R, GLFW_MOD_SHIFT);
    drag(-20, 0);
    assert_turned(7, 20);
}

static void the_wheel_zooms(void **unused)
{
    (void)unused;
    hands.wheel(NULL, 0.0, 1.0);
    hands.wheel(NULL, 0.0, 1.0);
    window_obey(&tested);
    assert_true(fabsf(renderer.focal_length - 1.21f) < 1e-5f);
    hands.wheel(NULL, 1.0, 0.0);
    tested.moved = false;
    window_obey(&tested);
    assert_false(tested.moved);
}

// The way is the time that the key was down, 2 units a second, however many turns that takes.
static void a_held_key_moves(void **unused)
{
    (void)unused;
    press(GLFW_KEY_W, 0);
    hands.now = 0.05;
    window_obey(&tested);
    hands.now = 0.125;
    release(GLFW_KEY_W);
    hands.now = 7.0;
    assert_true(fabs(travelled() - 0.25) < 1e-5);
    press(GLFW_KEY_LEFT_SHIFT, 0);
    press(GLFW_KEY_S, 0);
    hands.now = 7.03125;
    assert_true(travelled() < 1e-5);
    release(GLFW_KEY_LEFT_SHIFT);
    release(GLFW_KEY_S);
    press(GLFW_KEY_F, 0);
    assert_false(window_input_moves(&tested.input));
    press(GLFW_KEY_W, 0);
    hands.now = 7.0625;
    assert_true(fabs(travelled() - 0.25) < 1e-5);
}

// Right, up and forward, as the eye sees them; up is the world's.
static void each_key_has_its_way(void **unused)
{
    (void)unused;
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
        press(keys[i].key, 0);
        hands.now = 0.05;
        assert_true(fabs(travelled() - 0.1) < 1e-5);
        for (int axis = 0; axis < 3; axis++) {
            float expected = 0.1f * ((float)way[0] * eye.right[axis] + (float)way[1] * (axis == 1) +
                                     (float)way[2] * eye.forward[axis]);
            float went = tested.inputs.camera.position[axis] - start.camera.position[axis];
            assert_true(fabsf(went - expected) < 1e-5f);
        }
    }
}

static void keys_against_each_other_stand_still(void **unused)
{
    (void)unused;
    press(GLFW_KEY_A, 0);
    press(GLFW_KEY_D, 0);
    hands.now = 0.05;
    assert_true(travelled() <= 0.0);
    assert_false(tested.moved);
}

static void a_machine_that_stalls_throws_nothing_away(void **unused)
{
    (void)unused;
    press(GLFW_KEY_W, 0);
    hands.now = 60.0;
    assert_true(fabs(travelled() - 0.2) < 1e-5);
}

static void a_focus_lets_go(void **unused)
{
    (void)unused;
    press(GLFW_KEY_W, 0);
    hands.focus(NULL, GLFW_FALSE);
    hands.now = 0.05;
    assert_true(travelled() <= 0.0);
}

static void damage_is_shown_again(void **unused)
{
    (void)unused;
    window_obey(&tested);
    assert_false(tested.dirty);
    hands.damage(NULL);
    assert_int_equal(hands.shown, 1);
    window_obey(&tested);
    assert_true(tested.dirty);
    tested.dirty = false;
    window_obey(&tested);
    assert_false(tested.dirty);
}

static void any_number_of_keys_can_wait(void **unused)
{
    (void)unused;
    for (int i = 0; i < 10 * WINDOW_INPUT_EVENTS; i++)
        press(i % 2 == 0 ? GLFW_KEY_H : GLFW_KEY_K, 0);
    assert_int_equal(tested.input.events, WINDOW_INPUT_EVENTS);
    window_obey(&tested);
    assert_int_equal(tested.input.events, 0);
}

// Half a second from end to end, back when it is pressed on the way.
static void tab_passes_through_what_lies_between(void **unused)
{
    (void)unused;
    press(GLFW_KEY_TAB, 0);
    window_obey(&tested);
    for (int i = 1; i <= 4; i++) {
        assert_true(window_pass(&tested, 0.1));
        assert_true(fabs(renderer.orthographic - 0.2 * i) < 1e-9);
    }
    assert_true(window_pass(&tested, 0.1001));
    assert_true(renderer.orthographic == 1.0);
    assert_false(window_pass(&tested, 0.1));
    press(GLFW_KEY_TAB, 0);
    window_obey(&tested);
    assert_true(window_pass(&tested, 0.1));
    press(GLFW_KEY_TAB, 0);
    window_obey(&tested);
    assert_true(window_pass(&tested, 0.2));
    assert_true(renderer.orthographic == 1.0);
}

// What is typed in a field of a number; a French keyboard's comma is the point, its accents and
// signs are told about.
static void a_field_takes_a_number_alone(void **unused)
{
    (void)unused;
    struct parameter item[] = {{.name = "size", .components = 1, .maximum = 9.0, .value = {5.0}},
                               {.name = "way", .components = 2, .maximum = 9.0}};
    struct renderer typed_into = {.gl = &gl, .parameters = {.item = item, .count = 2}};
    tested.renderer = &typed_into;
    tested.touch.what = TOUCH_VALUE;
    tested.touch.part = -1;
    window_field_open(&tested);
    for (const char *c = "\xe9&_(wE"; *c != '\0'; c++) { // keys that do something else do nothing
        press(GLFW_KEY_H, 0);
        hands.letter(NULL, (unsigned char)*c);
        window_obey(&tested);
        assert_true((tested.touch.refused[0] != '\0') == (*c != 'E'));
    }
    assert_string_equal(tested.touch.typed, "E");
    assert_false(tested.panel.folded);
    press(GLFW_KEY_BACKSPACE, 0);
    for (const char *c = "7,25"; *c != '\0'; c++)
        hands.letter(NULL, (unsigned char)*c);
    press(GLFW_KEY_ENTER, 0);
    window_obey(&tested);
    assert_true(item[0].value[0] == 7.25 && !tested.input.typing);
    // Of a vector the comma parts the numbers, but not in a part's own field.
    snprintf(tested.parameter, sizeof tested.parameter, "way");
    window_field_open(&tested);
    for (const char *c = "1,2.5"; *c != '\0'; c++)
        hands.letter(NULL, (unsigned char)*c);
    press(GLFW_KEY_ENTER, 0);
    window_obey(&tested);
    assert_true(item[1].value[0] == 1.0 && item[1].value[1] == 2.5);
    tested.touch.part = 1;
    window_field_open(&tested);
    for (const char *c = "3,5"; *c != '\0'; c++)
        hands.letter(NULL, (unsigned char)*c);
    press(GLFW_KEY_ENTER, 0);
    window_obey(&tested);
    assert_true(item[1].value[0] == 1.0 && item[1].value[1] == 3.5);
    // A press in the picture leaves a field, and looks around.
    window_field_open(&tested);
    drag(40, 0);
    assert_turned(16, 20);
    assert_false(tested.input.typing);
}

static void the_panel_has_its_keys(void **unused)
{
    (void)unused;
    for (int i = 0; i < 4; i++) {
        assert_true(tested.panel.right == (i % 2 == 1) && tested.panel.rolled == (i % 2 == 1));
        press(GLFW_KEY_O, 0);
        press(GLFW_KEY_T, 0);
        window_obey(&tested);
        assert_true(tested.dirty && !tested.stale);
    }
}

// An open picker: Escape closes it and pauses nothing, a press elsewhere closes it and chooses no
// ray, a second Escape pauses.
static void a_picker_closes(void **unused)
{
    (void)unused;
    struct parameter colour = {.name = "tint",
                               .components = 3,
                               .maximum = 1.0,
                               .unit = "linear RGB",
                               .value = {0.5, 0.25, 0.125}};
    struct renderer coloured = {.gl = &gl, .parameters = {.item = &colour, .count = 1}};
    tested.renderer = &coloured;
    tested.panel.overlay.scale = 1.0f;
    window_pick_open(&tested);
    assert_true(tested.input.picking);
    press(GLFW_KEY_ESCAPE, 0);
    window_obey(&tested);
    assert_false(tested.input.picking || tested.paused);
    window_pick_open(&tested);
    drag(2, 1);
    assert_turned(10, 20);
    assert_false(tested.input.picking);
    assert_int_equal(tested.inputs.pixel[0], -1);
    window_pick_open(&tested);
    tested.touch.picker = (struct picker){
        .left = 50, .top = 50, .width = 104, .height = 86, .side = 72, .value = {-1.0}};
    drag(-200, -200); // from (102, 101), in the square
    window_obey(&tested);
    assert_true(tested.input.picking && tested.moved);
    for (int k = 0; k < 3; k++)
        assert_true(colour.value[k] == 1.0);
    assert_turned(10, 20);
    tested.dirty = false; // drawn, and its row was not there
    tested.touch.picker.width = 0.0f;
    window_obey(&tested);
    assert_false(tested.input.picking);
    press(GLFW_KEY_ESCAPE, 0);
    window_obey(&tested);
    assert_true(tested.paused);
    // Once it is closed a drag in the picture turns the eye again.
    drag(40, 0);
    assert_turned(16, 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(a_drag_turns, set_up),
        cmocka_unit_test_setup(a_drag_behind_a_focus_turns, set_up),
        cmocka_unit_test_setup(the_free_pointer_turns_nothing, set_up),
        cmocka_unit_test_setup(a_captured_pointer_looks, set_up),
        cmocka_unit_test_setup(a_click_chooses_a_ray, set_up),
        cmocka_unit_test_setup(what_comes_first_is_done_first, set_up),
        cmocka_unit_test_setup(the_wheel_zooms, set_up),
        cmocka_unit_test_setup(a_held_key_moves, set_up),
        cmocka_unit_test_setup(each_key_has_its_way, set_up),
        cmocka_unit_test_setup(keys_against_each_other_stand_still, set_up),
        cmocka_unit_test_setup(a_machine_that_stalls_throws_nothing_away, set_up),
        cmocka_unit_test_setup(a_focus_lets_go, set_up),
        cmocka_unit_test_setup(damage_is_shown_again, set_up),
        cmocka_unit_test_setup(any_number_of_keys_can_wait, set_up),
        cmocka_unit_test_setup(tab_passes_through_what_lies_between, set_up),
        cmocka_unit_test_setup(a_field_takes_a_number_alone, set_up),
        cmocka_unit_test_setup(the_panel_has_its_keys, set_up),
        cmocka_unit_test_setup(a_picker_closes, set_up),
    };
    return cmocka_run_group_tests_name("input", tests, NULL, NULL);
}

#else

int main(void)
{
    puts("1..1\nok 1 - the window's input # SKIP no GLFW on this machine");
    return 0;
}

#endif
