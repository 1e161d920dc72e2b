#include "window/input.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#define LONGEST_STEP 0.1  // maximum seconds of movement per step, even if a frame is slow
#define TAP          0.03 // seconds of movement for a shorter press
#define FASTER       4.0  // factor of the speed while Left Shift or F is held
#define DRAG_BEGINS  3.0  // window units that the pointer may move during a click
#define DRAG_PATH    8.0  // window units between two points of a drag that are both kept
#define DOUBLE       0.4  // maximum time between the two presses of a double click, in seconds

// GLFW names keys after an American keyboard: GLFW_KEY_W is the key labelled Z on a French one.
static const int held_keys[HELD_KEYS] = {
    [HELD_LEFT] = GLFW_KEY_A,
    [HELD_RIGHT] = GLFW_KEY_D,
    [HELD_UP] = GLFW_KEY_SPACE,
    [HELD_DOWN] = GLFW_KEY_C,
    [HELD_DOWN_CONTROL] = GLFW_KEY_LEFT_CONTROL,
    [HELD_FORWARD] = GLFW_KEY_W,
    [HELD_BACK] = GLFW_KEY_S,
    [HELD_FASTER] = GLFW_KEY_LEFT_SHIFT,
    [HELD_FASTER_F] = GLFW_KEY_F,
};

static struct window_input *input_of(GLFWwindow *window)
{
    return glfwGetWindowUserPointer(window);
}

// Events of one kind that follow each other become one. But a drag keeps points of its path,
// because a stroke follows the path.
static void add(struct window_input *input, struct window_event event)
{
    struct window_event *last = input->events > 0 ? &input->event[input->events - 1] : NULL;
    bool far = event.kind == EVENT_DRAG && input->events < WINDOW_INPUT_EVENTS / 2 &&
               last != NULL && hypot(last->movement[0], last->movement[1]) >= DRAG_PATH;
    if (last != NULL && last->kind == event.kind && event.kind >= EVENT_WHEEL && !far) {
        for (int axis = 0; axis < 3; axis++)
            last->movement[axis] += event.movement[axis];
        memcpy(last->position, event.position, sizeof event.position);
    } else if (input->events < WINDOW_INPUT_EVENTS)
        input->event[input->events++] = event;
}

static void add_at_pointer(struct window_input *input, struct window_event event)
{
    for (int i = 0; i < 2; i++)
        event.position[i] = input->inside && !input->captured ? input->position[i] : -1.0;
    add(input, event);
}

// Movement is also counted at every press and release, not only once per frame, so that the
// distance depends on how long the key was down, not on the frame rate. A shorter press counts TAP,
// because in a slow frame the press and the release of a tap arrive together.
void window_input_count(struct window_input *input)
{
    const bool *held = input->held;
    double now = glfwGetTime();
    double seconds = fmin(now - input->counted, LONGEST_STEP);
    input->counted = now;
    if (held[HELD_FASTER] || held[HELD_FASTER_F])
        seconds *= FASTER;
    int right = held[HELD_RIGHT] - held[HELD_LEFT];
    int up = held[HELD_UP] - (held[HELD_DOWN] || held[HELD_DOWN_CONTROL]);
    int forward = held[HELD_FORWARD] - held[HELD_BACK];
    if (seconds > 0.0 && (right != 0 || up != 0 || forward != 0))
        add(input,
            (struct window_event){.kind = EVENT_MOVE,
                                  .movement = {seconds * right, seconds * up, seconds * forward}});
}

bool window_input_moves(const struct window_input *input)
{
    for (int i = 0; i < HELD_FASTER; i++)
        if (input->held[i])
            return true;
    return false;
}

void window_input_forget(struct window_input *input)
{
    input->damaged = false;
    input->events = 0;
}

// Handle a button that is released, or counts as released.
static void release(struct window_input *input, bool clicked)
{
    if (input->state != BUTTON_UP)
        add_at_pointer(input, (struct window_event){.kind = EVENT_RELEASE, .amount = clicked});
    input->state = BUTTON_UP;
}

void window_input_capture(struct window_input *input)
{
    release(input, false);
    input->captured = !input->captured;
    input->jumped = true;
    input->inside = false; // a captured pointer has no position
    glfwSetInputMode(input->window, GLFW_CURSOR,
                     input->captured ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
}

static void on_letter(GLFWwindow *window, unsigned int code)
{
    struct window_input *input = input_of(window);
    if (input->typing)
        add(input, (struct window_event){.kind = EVENT_TYPED, .amount = (int)code});
}

// While a field is open, no key has its usual action. Ctrl+V types the clipboard's text.
static void type_key(struct window_input *input, int key, int modifiers)
{
    const char *name = glfwGetKeyName(key, 0);
    bool letter = key == GLFW_KEY_V || (name != NULL && strcmp(name, "v") == 0);
    bool pastes = letter && (modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0;
    const char *text = pastes ? glfwGetClipboardString(input->window) : NULL;
    for (; text != NULL && *text != '\0'; text++)
        if ((unsigned char)*text > ' ')
            add(input, (struct window_event){.kind = EVENT_TYPED, .amount = (unsigned char)*text});
    int code = key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER ? INPUT_ENTER
               : key == GLFW_KEY_ESCAPE                          ? INPUT_ESCAPE
               : key == GLFW_KEY_BACKSPACE                       ? INPUT_BACKSPACE
                                                                 : 0;
    if (code != 0)
        add(input, (struct window_event){.kind = EVENT_TYPED, .amount = code});
}

// True if a key writes a number, or takes back what is written.
static bool writes_number(int key)
{
    return (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) ||
           (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_DECIMAL) || key == GLFW_KEY_KP_SUBTRACT ||
           key == GLFW_KEY_PERIOD || key == GLFW_KEY_COMMA || key == GLFW_KEY_MINUS ||
           key == GLFW_KEY_BACKSPACE;
}

static void on_key(GLFWwindow *window, int key, int scancode, int action, int modifiers)
{
    (void)scancode;
    struct window_input *input = input_of(window);
    if (input->armed && !input->typing && action == GLFW_PRESS && writes_number(key)) {
        input->typing = true;
        add(input, (struct window_event){.kind = EVENT_TYPED, .amount = INPUT_BEGIN});
    }
    bool closes = input->picker_open && key == GLFW_KEY_ESCAPE;
    if ((input->typing || closes) && action != GLFW_RELEASE) {
        type_key(input, key, modifiers);
        return;
    }
    int held = 0;
    while (held < HELD_KEYS && held_keys[held] != key)
        held++;
    if (held < HELD_KEYS) {
        double now = glfwGetTime();
        if (action == GLFW_RELEASE && input->held[held])
            input->counted -= fmax(TAP - (now - input->pressed[held]), 0.0);
        window_input_count(input);
        if (action == GLFW_PRESS)
            input->pressed[held] = now;
        input->held[held] = action != GLFW_RELEASE;
        return;
    }
    // A captured mouse is released at once, so that no later movement turns the camera.
    bool ends = key == GLFW_KEY_M || key == GLFW_KEY_ESCAPE;
    if (ends && action == GLFW_PRESS && input->captured)
        window_input_capture(input);
    else if (action != GLFW_RELEASE)
        add(input, (struct window_event){.kind = EVENT_KEY,
                                         .amount = key,
                                         .shifted = (modifiers & GLFW_MOD_SHIFT) != 0,
                                         .repeated = action == GLFW_REPEAT});
}

// A third press counts as the first press of another double click.
static void press(struct window_input *input, bool right)
{
    double now = glfwGetTime(), *position = input->press.position;
    bool again =
        !right && now - input->press.time <= DOUBLE &&
        hypot(input->position[0] - position[0], input->position[1] - position[1]) <= DRAG_BEGINS;
    input->state = BUTTON_PRESSED;
    input->button = right;
    add_at_pointer(input, (struct window_event){.kind = again ? EVENT_DOUBLE_PRESS : EVENT_PRESS,
                                                .amount = right});
    input->press.time = again || right ? -10.0 * DOUBLE : now;
    memcpy(position, input->position, sizeof input->position);
}

static void on_button(GLFWwindow *window, int button, int action, int modifiers)
{
    (void)modifiers;
    struct window_input *input = input_of(window);
    bool right = button == GLFW_MOUSE_BUTTON_RIGHT, pressed = action == GLFW_PRESS;
    if ((button != GLFW_MOUSE_BUTTON_LEFT && !right) || input->captured)
        return;
    // While one button is held, the other one is ignored.
    if (pressed ? input->state != BUTTON_UP : input->button != right)
        return;
    // Ask for the position only if no event has given it, because the pointer may have moved on by
    // now.
    if (!input->inside)
        glfwGetCursorPos(window, &input->position[0], &input->position[1]);
    input->inside = true;
    if (!pressed)
        release(input, input->state == BUTTON_PRESSED);
    if (pressed || input->jumped)
        memcpy(input->previous, input->position, sizeof input->position);
    input->jumped = false;
    if (pressed)
        press(input, right);
}

static void on_pointer(GLFWwindow *window, double x, double y)
{
    struct window_input *input = input_of(window);
    input->inside = true;
    input->position[0] = x;
    input->position[1] = y;
    double right = x - input->previous[0], down = y - input->previous[1];
    if (input->state == BUTTON_PRESSED && hypot(right, down) > DRAG_BEGINS)
        input->state = BUTTON_DRAGS;
    if (!input->captured && input->state != BUTTON_DRAGS)
        add_at_pointer(input, (struct window_event){.kind = EVENT_HOVER});
    if (input->state == BUTTON_PRESSED)
        return; // if this becomes a drag, the drag includes this movement
    if ((input->captured || input->state == BUTTON_DRAGS) && !input->jumped)
        add_at_pointer(input,
                       (struct window_event){.kind = input->captured ? EVENT_LOOK : EVENT_DRAG,
                                             .amount = input->button,
                                             .movement = {right, down}});
    memcpy(input->previous, input->position, sizeof input->position);
    input->jumped = false;
}

static void on_enter(GLFWwindow *window, int entered)
{
    struct window_input *input = input_of(window);
    if (entered || input->captured || input->state != BUTTON_UP)
        return;
    input->inside = false;
    add_at_pointer(input, (struct window_event){.kind = EVENT_HOVER});
}

static void on_wheel(GLFWwindow *window, double right, double up)
{
    (void)right;
    struct window_input *input = input_of(window);
    if (up != 0.0)
        add_at_pointer(input, (struct window_event){.kind = EVENT_WHEEL, .movement = {up}});
}

static void on_focus(GLFWwindow *window, int focused)
{
    (void)focused;
    struct window_input *input = input_of(window);
    window_input_count(input);
    memset(input->held, 0, sizeof input->held);
    release(input, false);
    input->jumped = true;
}

static void on_damage(GLFWwindow *window)
{
    struct window_input *input = input_of(window);
    input->damaged = true;
    if (input->show != NULL)
        input->show(input->to);
}

static void on_drop(GLFWwindow *window, int count, const char **paths)
{
    struct window_input *input = input_of(window);
    if (count > 0)
        snprintf(input->dropped, sizeof input->dropped, "%s", paths[0]);
}

void window_input_open(struct window_input *input, GLFWwindow *window, void (*show)(void *to),
                       void *to)
{
    *input = (struct window_input){.window = window,
                                   .show = show,
                                   .to = to,
                                   .counted = glfwGetTime(),
                                   .jumped = true,
                                   .press.time = -10.0 * DOUBLE};
    glfwSetWindowUserPointer(window, input);
    glfwSetKeyCallback(window, on_key);
    glfwSetCharCallback(window, on_letter);
    glfwSetMouseButtonCallback(window, on_button);
    glfwSetCursorPosCallback(window, on_pointer);
    glfwSetCursorEnterCallback(window, on_enter);
    glfwSetScrollCallback(window, on_wheel);
    glfwSetWindowFocusCallback(window, on_focus);
    glfwSetWindowRefreshCallback(window, on_damage);
    glfwSetDropCallback(window, on_drop);
}
