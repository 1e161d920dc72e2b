#include "window/state.h"

#include <math.h>
#include <stdio.h>

#include "picture/image.h"
#include "picture/pair.h"
#include "platform.h"
#include "report.h"
#include "picture/slice.h"

#define SPEED           2.0f // scene units a second
#define ZOOM            1.1  // focal length or slice, for each notch of the wheel
#define FOCAL_MINIMUM   0.2  // of a shader that declares no focalLength
#define FOCAL_MAXIMUM   10.0
#define PASSAGE         0.5 // seconds from one projection to the other
#define LAST_SCREENSHOT 9999

// ---- What keys and wheel do ----

static void zoom(struct window *window, double notches)
{
    float *own = &window->renderer->focal_length, *slice = &window->inputs.zoom;
    struct parameter *parameter = parameters_find(&window->renderer->parameters, "focalLength");
    double factor = pow(ZOOM, notches);
    if (form_shows_ray(window->renderer->view))
        *slice = (float)fmin(fmax((double)*slice * factor, (double)SLICE_ZOOM_MINIMUM),
                             (double)SLICE_ZOOM_MAXIMUM);
    else if (parameter != NULL)
        parameter->value[0] =
            fmin(fmax(parameter->value[0] * factor, parameter->minimum), parameter->maximum);
    else
        *own = (float)fmin(fmax((double)*own * factor, FOCAL_MINIMUM), FOCAL_MAXIMUM);
}

// What Tab drives, and between which ends; NULL where there is nothing.
static double *orthographic_of(struct window *window, double end[2])
{
    struct renderer *renderer = window->renderer;
    struct parameter *parameter = parameters_find(&renderer->parameters, "orthographic");
    end[0] = parameter != NULL ? parameter->minimum : 0.0;
    end[1] = parameter != NULL ? parameter->maximum : 1.0;
    if (parameter != NULL)
        return &parameter->value[0];
    // The linker keeps only what is used: the uniform is there where OrthoView is read.
    GLuint program = renderer->program[renderer->view];
    bool read = renderer->gl->GetUniformLocation(program, "iOrthoView") >= 0;
    return read ? &renderer->orthographic : NULL;
}

bool window_has_orthographic(struct window *window)
{
    double end[2];
    return orthographic_of(window, end) != NULL;
}

// Towards the farther end; pressed again on the way, back.
static void toggle_orthographic(struct window *window)
{
    double end[2];
    const double *value = orthographic_of(window, end);
    if (value == NULL)
        return;
    double from = window->passage.on ? window->passage.towards : *value;
    window->passage.towards = from > 0.5 * (end[0] + end[1]) ? end[0] : end[1];
    window->passage.on = true;
}

// A switch has no values between its ends.
static bool is_switch(const struct parameter *parameter)
{
    return parameter != NULL && parameter->type != PARAMETER_FLOAT;
}

bool window_pass(struct window *window, double seconds)
{
    double end[2];
    double *value = window->passage.on ? orthographic_of(window, end) : NULL;
    window->passage.on = value != NULL;
    if (value == NULL)
        return false;
    double left = window->passage.towards - *value;
    double step = seconds / PASSAGE * (end[1] - end[0]);
    bool arrived = fabs(left) <= step ||
                   is_switch(parameters_find(&window->renderer->parameters, "orthographic"));
    *value = arrived ? window->passage.towards : *value + copysign(step, left);
    window->passage.on = !arrived;
    window->title.due = 0.0;
    return true;
}

static void choose(struct window *window, int by)
{
    const struct renderer *renderer = window->renderer;
    const struct parameter *parameter = window_chosen(window);
    int count = pair_parameter_count(renderer), index = 0;
    if (parameter == NULL)
        return;
    while (pair_parameter(renderer, index) != parameter)
        index++;
    window_choose(window, pair_parameter(renderer, (index + by + count) % count));
}

// The first name that is free. Returns false, reported, when there is none.
static bool find_name(const struct window *window, char path[256])
{
    struct platform_file there;
    int number = 1;
    do
        snprintf(path, 256, "%.200s-%04d.png", window->start->stem, number);
    while (platform_look(path, &there) && ++number <= LAST_SCREENSHOT);
    if (number > LAST_SCREENSHOT)
        report("%s: all names up to this one are taken: move some screenshots away", path);
    return number <= LAST_SCREENSHOT;
}

// Write a picture. That a disk is full is reported and ends nothing.
//   made  the image is there
static void save(const struct window *window, struct image *image, bool made)
{
    char path[256];
    if (made && find_name(window, path) && image_write_png(image, path)) {
        printf("%s: written, %dx%d\n", path, image->width, image->height);
        fflush(stdout);
    }
    image_free(image);
}

bool window_shoots(const struct window *window)
{
    return window->shooting && (window->pace.resolution.level == 0 ||
                                window->sharpening.rows == window->sharpening.inputs.height);
}

void window_shoot(struct window *window)
{
    struct image image = {0};
    window->shooting = false;
    window_label_pair(window);
    save(window, &image,
         window->pace.resolution.level > 0
             ? renderer_sharp_picture(window->renderer, &image)
             : renderer_picture(window->renderer, &window->inputs, &image));
    // The screenshot was drawn where the picture on the screen was; a sharpened one is elsewhere.
    window->stale |= window->sharpening.rows < window->sharpening.inputs.height;
}

// A view that the shader has not is refused where the eyes are: in the overlay.
static void show_view(struct window *window, enum shader_view view)
{
    bool shown = renderer_set_view(window->renderer, view);
    if (!shown || !window->broken)
        snprintf(window->panel.error, sizeof window->panel.error, "%s", shown ? "" : report_last());
}

static GLFWmonitor *monitor_below(GLFWwindow *handle)
{
    int count = 0, x = 0, y = 0, width = 0, height = 0;
    GLFWmonitor **monitors = glfwGetMonitors(&count);
    glfwGetWindowPos(handle, &x, &y);
    glfwGetWindowSize(handle, &width, &height);
    for (int i = 0; i < count; i++) {
        int left, top;
        glfwGetMonitorPos(monitors[i], &left, &top);
        const GLFWvidmode *mode = glfwGetVideoMode(monitors[i]);
        int right = x + width / 2 - left, down = y + height / 2 - top;
        if (mode != NULL && right >= 0 && right < mode->width && down >= 0 && down < mode->height)
            return monitors[i];
    }
    return glfwGetPrimaryMonitor();
}

static void toggle_full_screen(struct window *window)
{
    GLFWwindow *handle = window->handle;
    int *rectangle = window->rectangle;
    if (glfwGetWindowMonitor(handle) != NULL) {
        glfwSetWindowMonitor(handle, NULL, rectangle[0], rectangle[1], rectangle[2], rectangle[3],
                             GLFW_DONT_CARE);
        return;
    }
    GLFWmonitor *monitor = monitor_below(handle);
    const GLFWvidmode *mode = monitor != NULL ? glfwGetVideoMode(monitor) : NULL;
    if (mode == NULL) {
        report("full screen: the window system names no monitor");
        return;
    }
    glfwGetWindowPos(handle, &rectangle[0], &rectangle[1]);
    glfwGetWindowSize(handle, &rectangle[2], &rectangle[3]);
    glfwSetWindowMonitor(handle, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

static void reset(struct window *window)
{
    struct parameter *parameter = window_chosen(window);
    window->passage.on = false;
    if (parameter != NULL)
        parameter_reset(parameter);
}

static void change(struct window *window, int presses)
{
    struct parameter *parameter = window_chosen(window);
    window->passage.on = false;
    if (parameter != NULL)
        parameter_change(parameter, presses);
    window->moved = true;
}

// To the first step of the ray; without one the parameter's first value.
static void go_first(struct window *window)
{
    if (window_step_to(window, false))
        return;
    window->stale = true;
    reset(window);
}

static void press_panel(struct window *window, enum window_action action)
{
    switch (action) {
    case WINDOW_FOLD:
        window->panel.folded = !window->panel.folded;
        break;
    case WINDOW_HELP:
        window->panel.helps = !window->panel.helps;
        break;
    case WINDOW_SIDE:
        window->panel.right = !window->panel.right;
        break;
    case WINDOW_ROLL:
        window->panel.rolled = !window->panel.rolled;
        break;
    default:
        break;
    }
}

static void press(struct window *window, struct window_event event)
{
    window->stale |= event.action >= WINDOW_PAUSE;
    switch (event.action) {
    case WINDOW_END:
        glfwSetWindowShouldClose(window->handle, GLFW_TRUE);
        break;
    case WINDOW_PAUSE:
        window->paused = !window->paused;
        break;
    case WINDOW_RESTART:
        window->inputs.time = window->start->time;
        break;
    case WINDOW_BEGIN:
        window->inputs.time = window->start->time;
        window->inputs.camera = window->start->camera;
        break;
    case WINDOW_SCREENSHOT:
        window->shooting = true;
        break;
    case WINDOW_FULL_SCREEN:
        toggle_full_screen(window);
        break;
    case WINDOW_ORTHOGRAPHIC:
        toggle_orthographic(window);
        break;
    case WINDOW_CHOOSE:
        choose(window, event.amount);
        break;
    case WINDOW_CHANGE:
        change(window, event.amount);
        break;
    case WINDOW_STEP:
        window_step(window, event.amount);
        break;
    case WINDOW_LAST:
        window_step_to(window, true);
        break;
    case WINDOW_LEAVE:
        window_leave_ray(window);
        break;
    case WINDOW_FIRST:
        go_first(window);
        break;
    case WINDOW_RESET:
        reset(window);
        break;
    case WINDOW_TYPED:
        window_field_type(window, event.amount);
        break;
    case WINDOW_VIEW:
        show_view(window, (enum shader_view)event.amount);
        break;
    default:
        press_panel(window, event.action);
        break;
    }
}

static void act(struct window *window, const struct window_event *event)
{
    struct camera *camera = &window->inputs.camera;
    float way[3], longest = 0.0f;
    for (int axis = 0; axis < 3; axis++) {
        way[axis] = (float)event->way[axis];
        longest = fmaxf(longest, fabsf(way[axis]));
    }
    if (window_hand(window, event))
        return;
    if (event->action == WINDOW_TRAVEL)
        camera_move(camera, way, SPEED * longest);
    else if (event->action == WINDOW_ZOOM)
        zoom(window, event->way[0]);
    else
        press(window, *event);
    window->moved |= event->action >= WINDOW_ZOOM;
    window->dirty = true;
    if (event->action != WINDOW_TRAVEL)
        window->title.due = 0.0;
}

// One after the other: what Shift and R bring back, a drag that follows in the same turn moves on.
void window_obey(struct window *window)
{
    struct window_input *input = &window->input;
    window_input_count(input);
    window->hand.pressed = false;
    for (int i = 0; i < input->events; i++)
        act(window, &input->event[i]);
    window_let_go(window);
    window_touch_rest(window);
    window_follow_mouse(window);
    window->dirty = window->dirty || input->damaged;
    window_input_forget(input);
}
