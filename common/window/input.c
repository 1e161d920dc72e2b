#include "window/input.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "shader/form.h"

#define LONGEST_STEP 0.1 // seconds: a machine that stalls must not throw the camera away
#define FASTER       4.0 // times the speed while Left Shift or F is held
#define TEN_STEPS    10  // key presses that one press with Shift counts for
#define DRAG_BEGINS  3.0 // pixels: a hand that clicks trembles less
#define DOUBLE       0.4 // seconds between two presses that are one double click, at most

// GLFW names positions by the American keyboard: GLFW_KEY_W is the key labelled Z on a French one.
static const struct {
    int key;
    enum window_key as;
} held_keys[] = {
    {GLFW_KEY_A, WINDOW_KEY_LEFT},       {GLFW_KEY_D, WINDOW_KEY_RIGHT},
    {GLFW_KEY_SPACE, WINDOW_KEY_UP},     {GLFW_KEY_C, WINDOW_KEY_DOWN},
    {GLFW_KEY_W, WINDOW_KEY_FORWARD},    {GLFW_KEY_LEFT_CONTROL, WINDOW_KEY_DOWN_TOO},
    {GLFW_KEY_S, WINDOW_KEY_BACK},       {GLFW_KEY_LEFT_SHIFT, WINDOW_KEY_FASTER},
    {GLFW_KEY_F, WINDOW_KEY_FASTER_TOO},
};

static const struct {
    int key;
    enum window_action action;
    int amount;
    bool repeats;
} pressed_keys[] = {
    {GLFW_KEY_BACKSPACE, WINDOW_END, 0, false},
    {GLFW_KEY_ESCAPE, WINDOW_PAUSE, 0, false},
    {GLFW_KEY_R, WINDOW_RESTART, 0, false},
    {GLFW_KEY_P, WINDOW_SCREENSHOT, 0, false},
    {GLFW_KEY_H, WINDOW_FOLD, 0, false},
    {GLFW_KEY_K, WINDOW_HELP, 0, false},
    {GLFW_KEY_O, WINDOW_SIDE, 0, false},
    {GLFW_KEY_T, WINDOW_ROLL, 0, false},
    {GLFW_KEY_F11, WINDOW_FULL_SCREEN, 0, false},
    {GLFW_KEY_TAB, WINDOW_ORTHOGRAPHIC, 0, false},
    {GLFW_KEY_UP, WINDOW_CHOOSE, -1, true},
    {GLFW_KEY_DOWN, WINDOW_CHOOSE, 1, true},
    {GLFW_KEY_LEFT, WINDOW_CHANGE, -1, true},
    {GLFW_KEY_RIGHT, WINDOW_CHANGE, 1, true},
    {GLFW_KEY_DELETE, WINDOW_RESET, 0, false},
    {GLFW_KEY_E, WINDOW_STEP, 1, true},
    {GLFW_KEY_Q, WINDOW_STEP, -1, true},
    {GLFW_KEY_PAGE_DOWN, WINDOW_STEP, 1, true}, // a presenter's remote has these two
    {GLFW_KEY_PAGE_UP, WINDOW_STEP, -1, true},
    {GLFW_KEY_HOME, WINDOW_FIRST, 0, false},
    {GLFW_KEY_END, WINDOW_LAST, 0, false},
    {GLFW_KEY_X, WINDOW_LEAVE, 0, false},
    {GLFW_KEY_1, WINDOW_VIEW, SHADER_PICTURE, false},
    {GLFW_KEY_2, WINDOW_VIEW, SHADER_NORMALS, false},
    {GLFW_KEY_3, WINDOW_VIEW, SHADER_DEPTH, false},
    {GLFW_KEY_4, WINDOW_VIEW, SHADER_STEPS, false},
    {GLFW_KEY_5, WINDOW_VIEW, SHADER_SLICE, false},
    {GLFW_KEY_6, WINDOW_VIEW, SHADER_PLOT, false},
};

#define COUNT(array) (sizeof(array) / sizeof *(array))

static struct window_input *input_of(GLFWwindow *window)
{
    return glfwGetWindowUserPointer(window);
}

static void add(struct window_input *input, struct window_event event)
{
    struct window_event *last = input->events > 0 ? &input->event[input->events - 1] : NULL;
    if (last != NULL && last->action == event.action && event.action >= WINDOW_ZOOM) {
        for (int axis = 0; axis < 3; axis++)
            last->way[axis] += event.way[axis];
        memcpy(last->place, event.place, sizeof event.place);
    } else if (input->events < WINDOW_INPUT_EVENTS)
        input->event[input->events++] = event;
}

// Movement is counted at every press and release, not once a frame: so the way travelled is the
// time the key was down, whatever the frame rate.
void window_input_count(struct window_input *input)
{
    const bool *held = input->held;
    double now = glfwGetTime();
    double seconds = fmin(now - input->counted, LONGEST_STEP);
    input->counted = now;
    if (held[WINDOW_KEY_FASTER] || held[WINDOW_KEY_FASTER_TOO])
        seconds *= FASTER;
    int right = held[WINDOW_KEY_RIGHT] - held[WINDOW_KEY_LEFT];
    int up = held[WINDOW_KEY_UP] - (held[WINDOW_KEY_DOWN] || held[WINDOW_KEY_DOWN_TOO]);
    int forward = held[WINDOW_KEY_FORWARD] - held[WINDOW_KEY_BACK];
    if (seconds > 0.0 && (right != 0 || up != 0 || forward != 0))
        add(input,
            (struct window_event){.action = WINDOW_TRAVEL,
                                  .way = {seconds * right, seconds * up, seconds * forward}});
}

bool window_input_moves(const struct window_input *input)
{
    for (int i = 0; i < WINDOW_KEY_COUNT; i++)
        if (input->held[i] && i != WINDOW_KEY_FASTER && i != WINDOW_KEY_FASTER_TOO)
            return true;
    return false;
}

void window_input_forget(struct window_input *input)
{
    input->damaged = false;
    input->events = 0;
}

// An event where the pointer is.
static void add_here(struct window_input *input, enum window_action action, int amount)
{
    struct window_event event = {.action = action, .amount = amount, .place = {-1.0, -1.0}};
    if (input->seen)
        memcpy(event.place, input->at, sizeof event.place);
    add(input, event);
}

// The button is up, or counts as such.
//   clicked  it was one press at one place
static void let_go(struct window_input *input, bool clicked)
{
    if (input->state != WINDOW_POINTER_FREE)
        add_here(input, WINDOW_RELEASE, clicked);
    input->state = WINDOW_POINTER_FREE;
}

static void release_all(struct window_input *input)
{
    window_input_count(input);
    for (int i = 0; i < WINDOW_KEY_COUNT; i++)
        input->held[i] = false;
    let_go(input, false);
    input->jumped = true;
}

static void capture(struct window_input *input)
{
    let_go(input, false);
    input->captured = !input->captured;
    input->jumped = true;
    input->seen = false; // a captured pointer is anywhere
    glfwSetInputMode(input->window, GLFW_CURSOR,
                     input->captured ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
}

// While somebody types no key does what it does else.
static void type_key(struct window_input *input, int key)
{
    int code = 0;
    if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER)
        code = WINDOW_TYPED_ENTER;
    else if (key == GLFW_KEY_ESCAPE)
        code = WINDOW_TYPED_ESCAPE;
    else if (key == GLFW_KEY_BACKSPACE)
        code = WINDOW_TYPED_BACK;
    if (code != 0)
        add(input, (struct window_event){.action = WINDOW_TYPED, .amount = code});
}

static void on_letter(GLFWwindow *window, unsigned int code)
{
    struct window_input *input = input_of(window);
    if (input->typing)
        add(input, (struct window_event){.action = WINDOW_TYPED, .amount = (int)code});
}

static void on_key(GLFWwindow *window, int key, int scancode, int action, int modifiers)
{
    (void)scancode;
    struct window_input *input = input_of(window);
    bool closes = input->picking && key == GLFW_KEY_ESCAPE;
    if ((input->typing || closes) && action != GLFW_RELEASE) {
        type_key(input, key);
        return;
    }
    for (size_t i = 0; i < COUNT(held_keys); i++)
        if (held_keys[i].key == key && action != GLFW_REPEAT) {
            window_input_count(input);
            input->held[held_keys[i].as] = action == GLFW_PRESS;
        }
    if (key == GLFW_KEY_M && action == GLFW_PRESS)
        capture(input);
    for (size_t i = 0; i < COUNT(pressed_keys); i++) {
        bool acts = action == GLFW_PRESS || (action == GLFW_REPEAT && pressed_keys[i].repeats);
        if (pressed_keys[i].key != key || !acts)
            continue;
        struct window_event event = {.action = pressed_keys[i].action,
                                     .amount = pressed_keys[i].amount};
        bool shifted = (modifiers & GLFW_MOD_SHIFT) != 0;
        if (shifted && event.action == WINDOW_CHANGE)
            event.amount *= TEN_STEPS;
        if (shifted && event.action == WINDOW_RESTART)
            event.action = WINDOW_BEGIN;
        add(input, event);
    }
}

static void on_button(GLFWwindow *window, int button, int action, int modifiers)
{
    (void)modifiers;
    struct window_input *input = input_of(window);
    bool right = button == GLFW_MOUSE_BUTTON_RIGHT, pressed = action == GLFW_PRESS;
    if ((button != GLFW_MOUSE_BUTTON_LEFT && !right) || input->captured)
        return;
    // One button at a time: another one means nothing while it is held.
    if (pressed ? input->state != WINDOW_POINTER_FREE : input->button != right)
        return;
    // Asked for now, the pointer may be further on than it was when the button went down.
    if (!input->seen)
        glfwGetCursorPos(window, &input->at[0], &input->at[1]);
    input->seen = true;
    if (!pressed)
        let_go(input, input->state == WINDOW_POINTER_PRESSED);
    if (pressed || input->jumped)
        memcpy(input->pointer, input->at, sizeof input->at);
    input->jumped = false;
    if (!pressed)
        return;
    input->state = WINDOW_POINTER_PRESSED;
    input->button = right;
    double now = glfwGetTime(), *place = input->press.place;
    bool again = !right && now - input->press.at <= DOUBLE &&
                 hypot(input->at[0] - place[0], input->at[1] - place[1]) <= DRAG_BEGINS;
    add_here(input, again ? WINDOW_DOUBLE : WINDOW_PRESS, right);
    // A third press begins anew.
    input->press.at = again || right ? -10.0 * DOUBLE : now;
    memcpy(place, input->at, sizeof input->at);
}

static void on_pointer(GLFWwindow *window, double x, double y)
{
    struct window_input *input = input_of(window);
    input->seen = true;
    input->at[0] = x;
    input->at[1] = y;
    double right = x - input->pointer[0], down = y - input->pointer[1];
    if (input->state == WINDOW_POINTER_PRESSED && hypot(right, down) > DRAG_BEGINS)
        input->state = WINDOW_POINTER_DRAGS;
    if (!input->captured && input->state != WINDOW_POINTER_DRAGS)
        add_here(input, WINDOW_POINT, 0);
    if (input->state == WINDOW_POINTER_PRESSED)
        return; // what it went until now is a part of the drag
    if ((input->captured || input->state == WINDOW_POINTER_DRAGS) && !input->jumped)
        add(input, (struct window_event){.action = input->captured ? WINDOW_LOOK : WINDOW_DRAG,
                                         .amount = input->button,
                                         .way = {right, down},
                                         .place = {x, y}});
    input->pointer[0] = x;
    input->pointer[1] = y;
    input->jumped = false;
}

static void on_leaving(GLFWwindow *window, int entered)
{
    struct window_input *input = input_of(window);
    if (entered || input->captured || input->state != WINDOW_POINTER_FREE)
        return;
    input->seen = false;
    add_here(input, WINDOW_POINT, 0);
}

static void on_wheel(GLFWwindow *window, double right, double up)
{
    (void)right;
    struct window_input *input = input_of(window);
    struct window_event event = {.action = WINDOW_ZOOM, .way = {up}, .place = {-1.0, -1.0}};
    if (input->seen && !input->captured)
        memcpy(event.place, input->at, sizeof event.place);
    if (up != 0.0)
        add(input, event);
}

static void on_focus(GLFWwindow *window, int focused)
{
    (void)focused;
    release_all(input_of(window));
}

static void on_damage(GLFWwindow *window)
{
    struct window_input *input = input_of(window);
    input->damaged = true;
    if (input->show != NULL)
        input->show(input->to);
}

void window_input_open(struct window_input *input, GLFWwindow *window, void (*show)(void *to),
                       void *to)
{
    *input = (struct window_input){.window = window,
                                   .show = show,
                                   .to = to,
                                   .counted = glfwGetTime(),
                                   .jumped = true,
                                   .press.at = -10.0 * DOUBLE};
    glfwSetWindowUserPointer(window, input);
    glfwSetKeyCallback(window, on_key);
    glfwSetCharCallback(window, on_letter);
    glfwSetMouseButtonCallback(window, on_button);
    glfwSetCursorPosCallback(window, on_pointer);
    glfwSetCursorEnterCallback(window, on_leaving);
    glfwSetScrollCallback(window, on_wheel);
    glfwSetWindowFocusCallback(window, on_focus);
    glfwSetWindowRefreshCallback(window, on_damage);
}
