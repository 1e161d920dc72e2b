#include "window.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "image.h"
#include "report.h"
#include "slice.h"
#include "watch.h"
#include "window_input.h"

// A little less than 1/60 s, so that the display's own beat sets the pace where there is one.
#define FRAME_SECONDS 0.0163
#define LOOK_SECONDS  0.1  // between two looks at the shader's files
#define TITLE_SECONDS 0.25 // between two changes of the title bar

#define SPEED           2.0f  // scene units a second
#define DEGREES         0.15f // of a turn, for each pixel of the pointer
#define ZOOM            1.1   // focal length or slice, for each notch of the wheel
#define FOCAL_MINIMUM   0.2   // of a shader that declares no focalLength
#define FOCAL_MAXIMUM   10.0
#define LAST_SCREENSHOT 9999

struct window {
    GLFWwindow *handle;
    struct renderer *renderer;
    const struct options *options;
    const char *title, *stem, *shader;
    struct window_input input;
    struct watch watch;
    struct renderer_inputs inputs; // of the frame on the screen
    char parameter[64];            // the one that the arrows change
    bool paused, broken, dirty;
    bool drew;          // the last turn of the loop drew a frame
    double turn, frame; // when the last turn began, when the last frame began
    double rate;        // frames a second, 0 before it is known
    double look_at, retitle_at;
    int place[4]; // x, y, width, height before full screen
    char shown[256];
};

// ---- The title bar ----

// The parameter that the arrows change: the one last chosen, as long as the shader has it.
static struct parameter *chosen(struct window *window)
{
    const struct parameters *all = &window->renderer->parameters;
    struct parameter *parameter = parameters_find(all, window->parameter);
    return parameter != NULL || all->count == 0 ? parameter : &all->item[0];
}

static void show_title(struct window *window)
{
    char text[sizeof window->shown], value[128] = "", rate[32] = "";
    const struct parameter *parameter = chosen(window);
    if (parameter != NULL)
        parameter_value_text(parameter, value, sizeof value);
    if (window->rate > 0.0)
        snprintf(rate, sizeof rate, " - %.0f fps", window->rate);
    snprintf(text, sizeof text, "%.60s%s%s - %s%s%.63s%s%.60s%s", window->title,
             window->broken ? " - error: see terminal" : "", rate,
             shader_view_name(window->renderer->view), parameter != NULL ? " - " : "",
             parameter != NULL ? parameter->name : "", parameter != NULL ? " = " : "", value,
             window->paused ? " (paused)" : "");
    if (strcmp(text, window->shown) != 0)
        glfwSetWindowTitle(window->handle, text);
    memcpy(window->shown, text, sizeof text);
}

// ---- What keys and wheel do ----

static void zoom(struct window *window, double notches)
{
    float *own = &window->renderer->focal_length, *slice = &window->inputs.zoom;
    struct parameter *parameter = parameters_find(&window->renderer->parameters, "focalLength");
    double factor = pow(ZOOM, notches);
    if (window->renderer->view == SHADER_SLICE)
        *slice = (float)fmin(fmax((double)*slice * factor, (double)SLICE_ZOOM_MINIMUM),
                             (double)SLICE_ZOOM_MAXIMUM);
    else if (parameter != NULL)
        parameter->value[0] =
            fmin(fmax(parameter->value[0] * factor, parameter->minimum), parameter->maximum);
    else
        *own = (float)fmin(fmax((double)*own * factor, FOCAL_MINIMUM), FOCAL_MAXIMUM);
}

static void toggle_orthographic(struct window *window)
{
    struct parameter *parameter = parameters_find(&window->renderer->parameters, "orthographic");
    if (parameter == NULL)
        return;
    double middle = 0.5 * (parameter->minimum + parameter->maximum);
    parameter->value[0] = parameter->value[0] > middle ? parameter->minimum : parameter->maximum;
}

static void choose(struct window *window, int by)
{
    const struct parameters *all = &window->renderer->parameters;
    const struct parameter *parameter = chosen(window);
    if (parameter == NULL)
        return;
    int index = ((int)(parameter - all->item) + by + all->count) % all->count;
    snprintf(window->parameter, sizeof window->parameter, "%s", all->item[index].name);
}

// Write the picture under the first free name. That a disk is full is reported and ends nothing.
static void save_screenshot(struct window *window)
{
    char path[256];
    int number = 1;
    do
        snprintf(path, sizeof path, "%.200s-%04d.png", window->stem, number);
    while (access(path, F_OK) == 0 && ++number <= LAST_SCREENSHOT);
    if (number > LAST_SCREENSHOT) {
        report("%s: all names up to this one are taken: move some screenshots away", path);
        return;
    }
    struct image image = {0};
    if (renderer_picture(window->renderer, &window->inputs, &image) &&
        image_write_png(&image, path)) {
        printf("%s: written, %dx%d\n", path, image.width, image.height);
        fflush(stdout);
    }
    image_free(&image);
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
    int *place = window->place;
    if (glfwGetWindowMonitor(handle) != NULL) {
        glfwSetWindowMonitor(handle, NULL, place[0], place[1], place[2], place[3], GLFW_DONT_CARE);
        return;
    }
    GLFWmonitor *monitor = monitor_below(handle);
    const GLFWvidmode *mode = monitor != NULL ? glfwGetVideoMode(monitor) : NULL;
    if (mode == NULL) {
        report("full screen: the window system names no monitor");
        return;
    }
    glfwGetWindowPos(handle, &place[0], &place[1]);
    glfwGetWindowSize(handle, &place[2], &place[3]);
    glfwSetWindowMonitor(handle, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

static void act(struct window *window, struct window_event event)
{
    struct parameter *parameter = chosen(window);
    switch (event.action) {
    case WINDOW_END:
        glfwSetWindowShouldClose(window->handle, GLFW_TRUE);
        break;
    case WINDOW_PAUSE:
        window->paused = !window->paused;
        break;
    case WINDOW_RESTART:
        window->inputs.time = window->options->time;
        break;
    case WINDOW_SCREENSHOT:
        save_screenshot(window);
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
        if (parameter != NULL)
            parameter_change(parameter, event.amount);
        break;
    case WINDOW_RESET:
        if (parameter != NULL)
            parameter_reset(parameter);
        break;
    case WINDOW_VIEW:
        renderer_set_view(window->renderer, (enum shader_view)event.amount);
        break;
    }
}

// ---- Reload ----

static void watch_files(struct window *window, const struct shader_source *source)
{
    for (int i = 0; i < source->file_count; i++)
        watch_add(&window->watch, source->paths[i]);
}

// Load the shader again. One that is broken leaves the last good picture; then its files, and those
// of the last good one, are all watched for the repair.
static void reload(struct window *window)
{
    struct renderer *renderer = window->renderer;
    struct shader_source source = {0};
    bool loaded = false;
    if (shader_read(&source, window->shader, renderer->root)) {
        watch_files(window, &source);
        loaded = renderer_load(renderer, window->shader);
        shader_free(&source);
    }
    window->broken = !loaded;
    window->dirty = true;
    window->retitle_at = 0.0;
    if (loaded) {
        const struct shader_source *good = &renderer->fragment;
        watch_keep(&window->watch, window->shader, good->paths, good->file_count);
        printf("%s: loaded again\n", window->shader);
        fflush(stdout);
    }
}

// ---- The loop ----

// Carry out what the hands did since the last turn.
static void obey(struct window *window)
{
    struct window_input *input = &window->input;
    struct camera *camera = &window->inputs.camera;
    window_input_count(input);
    float travel[3], longest = 0.0f;
    for (int axis = 0; axis < 3; axis++) {
        travel[axis] = (float)input->travel[axis];
        longest = fmaxf(longest, fabsf(travel[axis]));
    }
    bool looked = input->look[0] != 0.0 || input->look[1] != 0.0;
    // A pointer that goes right turns the view right, dragging or captured.
    if (looked)
        camera_turn(camera, DEGREES * (float)input->look[0], -DEGREES * (float)input->look[1]);
    if (longest > 0.0f)
        camera_move(camera, travel, SPEED * longest);
    if (input->wheel != 0.0)
        zoom(window, input->wheel);
    for (int i = 0; i < input->events; i++)
        act(window, input->event[i]);
    if (looked || longest > 0.0f || input->wheel != 0.0 || input->events > 0 || input->damaged)
        window->dirty = true;
    if (input->events > 0 || input->wheel != 0.0)
        window->retitle_at = 0.0;
    window_input_forget(input);
}

// True when the picture on the screen depends on the time: the linker keeps only what is used.
static bool uses_time(const struct renderer *renderer)
{
    static const char *const names[] = {"iTime", "iTimeDelta", "iFrame"};
    GLuint program = renderer->program[renderer->view];
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (renderer->gl->GetUniformLocation(program, names[i]) >= 0)
            return true;
    return false;
}

static bool draw(struct window *window, double now)
{
    struct renderer_inputs *inputs = &window->inputs;
    const struct gl *gl = window->renderer->gl;
    inputs->time_delta = inputs->frame > 0 && !window->paused ? now - window->frame : 0.0;
    if (!renderer_draw(window->renderer, inputs, 0, inputs->height))
        return false;
    renderer_present(window->renderer, inputs->width, inputs->height);
    GLenum error = gl->GetError();
    if (error != GL_NO_ERROR) {
        report("window %dx%d: OpenGL error 0x%04x while drawing: try a smaller --size",
               inputs->width, inputs->height, error);
        return false;
    }
    glfwSwapBuffers(window->handle);
    // The rate of frames that follow each other; while nothing changes none is drawn.
    double seconds = window->drew ? now - window->frame : 0.0;
    if (seconds > 0.0)
        window->rate += (window->rate > 0.0 ? 0.1 : 1.0) * (1.0 / seconds - window->rate);
    window->frame = now;
    inputs->frame++;
    return true;
}

// Take over the size of the framebuffer, which on a high-density display is larger than the
// window's. Returns false while there is nothing to draw on.
static bool take_size(struct window *window)
{
    int width = 0, height = 0;
    glfwGetFramebufferSize(window->handle, &width, &height);
    bool hidden = glfwGetWindowAttrib(window->handle, GLFW_ICONIFIED) != 0;
    if (width < 1 || height < 1 || hidden) {
        window->dirty = true;
        return false;
    }
    if (width != window->inputs.width || height != window->inputs.height)
        window->dirty = true;
    window->inputs.width = width;
    window->inputs.height = height;
    return true;
}

// Wait until the next frame is due, or, while the picture stands still, until something happens.
static void wait_for_turn(const struct window *window)
{
    double due = window->frame + FRAME_SECONDS;
    if (window->drew || window_input_moves(&window->input))
        glfwPollEvents();
    else
        glfwWaitEventsTimeout(LOOK_SECONDS);
    double left = due - glfwGetTime();
    while (left > 0.0) {
        glfwWaitEventsTimeout(left);
        left = due - glfwGetTime();
    }
}

static bool turn(struct window *window)
{
    double now = glfwGetTime();
    bool visible = take_size(window);
    if (!window->paused) {
        window->inputs.time += now - window->turn;
        window->dirty |= uses_time(window->renderer);
    }
    window->turn = now;
    obey(window);
    if (now >= window->look_at) {
        window->look_at = now + LOOK_SECONDS;
        if (watch_look(&window->watch))
            reload(window);
    }
    bool drawing = visible && window->dirty;
    if (drawing && !draw(window, now))
        return false;
    window->drew = drawing;
    if (drawing)
        window->dirty = false;
    if (now >= window->retitle_at) {
        window->retitle_at = now + TITLE_SECONDS;
        show_title(window);
    }
    return true;
}

bool window_run(struct context *context, struct renderer *renderer, const struct options *options,
                const char *title, const char *stem, const char *shader)
{
    struct window window = {
        .handle = context->window,
        .renderer = renderer,
        .options = options,
        .title = title,
        .stem = stem,
        .shader = shader,
        .inputs = {.camera = options->camera,
                   .time = options->time,
                   .samples = options->samples,
                   .pixel = {-1, -1},
                   .zoom = 1.0f},
        .dirty = true,
    };
    glfwSwapInterval(1);
    window_input_open(&window.input, window.handle);
    watch_add(&window.watch, shader);
    watch_files(&window, &renderer->fragment);
    while (renderer->gl->GetError() != GL_NO_ERROR)
        continue; // of what came before the first frame
    window.turn = glfwGetTime();
    bool done = true;
    while (done && !glfwWindowShouldClose(window.handle)) {
        wait_for_turn(&window);
        done = turn(&window);
    }
    watch_clear(&window.watch);
    return done;
}
