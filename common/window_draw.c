#include "window_state.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "probe.h"
#include "report.h"

#define FIGURES_SECONDS 0.25 // between two changes of the overlay's rate
#define SLOW_SECONDS    0.1  // a frame may take while something moves
#define FINER_SECONDS   0.08 // below this a finer one is tried: without a gap the two would alternate
#define REST_SECONDS                                                                               \
    0.3 // without motion until the picture sharpens: longer than between two
        // repeats of a held key
#define DIVISOR_LIMIT 4

void window_retitle(struct window *window)
{
    char text[sizeof window->shown], value[128] = "", rate[32] = "";
    const struct parameter *parameter = window_chosen(window);
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

bool window_uses_time(const struct window *window)
{
    // The linker keeps only what is used.
    static const char *const names[] = {"iTime", "iTimeDelta", "iFrame", "iFrameRate", "iDate"};
    const struct renderer *renderer = window->renderer;
    GLuint program = renderer->program[renderer->view];
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (renderer->gl->GetUniformLocation(program, names[i]) >= 0)
            return true;
    return false;
}

// ---- Keys ----

// The label of a key that GLFW names by the American keyboard, where it can be written in ASCII.
static void label_of(int key, char label[8])
{
    const char *name = glfwGetKeyName(key, 0);
    bool plain = name != NULL && name[0] > ' ' && name[0] <= '~' && name[1] == '\0';
    snprintf(label, 8, "%c", plain ? toupper((unsigned char)name[0]) : key);
}

static void add_key(struct window *window, const char *does, const char *label)
{
    if (window->key_count == WINDOW_KEYS)
        return;
    struct panel_key *key = &window->keys[window->key_count++];
    snprintf(key->label, sizeof key->label, "%s", label);
    key->does = does;
}

static void add_letter(struct window *window, const char *does, int key)
{
    char label[8];
    label_of(key, label);
    add_key(window, does, label);
}

// List the keys with the labels of the keyboard that is there.
static void name_keys(struct window *window)
{
    static const int moves[] = {GLFW_KEY_W, GLFW_KEY_A, GLFW_KEY_S, GLFW_KEY_D, GLFW_KEY_C};
    const struct parameters *parameters = &window->renderer->parameters;
    char l[5][8], text[64];
    for (int i = 0; i < 5; i++)
        label_of(moves[i], l[i]);
    window->key_count = 0;
    snprintf(text, sizeof text, "%s %s %s %s", l[0], l[1], l[2], l[3]);
    add_key(window, "move", text);
    snprintf(text, sizeof text, "Space %s", l[4]);
    add_key(window, "up, down", text);
    add_key(window, "faster", "Shift");
    add_key(window, "look", "drag");
    add_letter(window, "mouse look", GLFW_KEY_M);
    add_key(window, "ray", "click");
    add_key(window, "zoom", "wheel");
    add_key(window, "view", "1 2 3 4 5");
    if (parameters->count > 0) {
        add_key(window, "choose", "up down");
        add_key(window, "change", "left right");
        add_key(window, "reset", "Home");
    }
    if (parameters_find(parameters, "orthographic") != NULL)
        add_key(window, "orthographic", "Tab");
    add_key(window, "pause", "Esc");
    add_letter(window, "restart", GLFW_KEY_R);
    add_letter(window, "screenshot", GLFW_KEY_P);
    add_letter(window, "hide this", GLFW_KEY_H);
    add_key(window, "full screen", "F11");
    add_key(window, "end", "Backspace");
}

// ---- Overlay ----

// March the chosen pixel's ray again, for this frame's camera and parameters.
static void follow_ray(struct window *window)
{
    const struct renderer_inputs *inputs = &window->inputs;
    int *pixel = window->inputs.pixel;
    if (pixel[0] >= inputs->width || pixel[1] >= inputs->height || pixel[1] < 0)
        pixel[0] = pixel[1] = -1;
    if (pixel[0] < 0 || window->why[0] != '\0')
        return;
    if (window->renderer->fragment.form != SHADER_COURSE) {
        snprintf(window->why, sizeof window->why,
                 "no march: a file with a main of its own keeps no trace of its rays");
    } else if (!renderer_probe(window->renderer, inputs, pixel[0], pixel[1], window->probe)) {
        snprintf(window->why, sizeof window->why, "%s", report_last());
    } else if (window->tell) {
        printf("ray of pixel %d,%d\n", pixel[0], pixel[1]);
        probe_print(window->probe, stdout);
        fflush(stdout);
    }
    window->tell = false;
}

static void gather(struct window *window)
{
    const struct renderer_inputs *inputs = &window->inputs;
    const struct parameter *chosen = window_chosen(window);
    double scale = window->options->overlay;
    name_keys(window);
    struct panel panel = {
        .title = window->title,
        .renderer = window->renderer,
        .chosen = chosen != NULL ? chosen->name : NULL,
        .rate = window->figures[0],
        .milliseconds = window->figures[1],
        .divisor = window->divisor,
        .paused = window->paused,
        .folded = window->folded,
        .keys = window->keys,
        .key_count = window->key_count,
        .pixel = {inputs->pixel[0], inputs->pixel[1]},
        .probe = window->why[0] == '\0' ? window->probe : NULL,
        .why = window->why,
        .error = window->error,
        .broken = window->broken,
    };
    panel_gather(&panel, &window->overlay, inputs->width, inputs->height,
                 scale > 0.0 ? (float)scale : overlay_scale_of(inputs->height));
    window->renderer->overlay = window->options->has_overlay ? &window->overlay : NULL;
}

// ---- A frame ----

// While something moves, the finest resolution whose frame is quick enough.
static int divisor_for(const struct window *window, double now)
{
    int divisor = window->divisor > 1 ? window->divisor : 1;
    double cost = window->cost;
    if (now >= window->rest_at)
        return 1;
    while (divisor < DIVISOR_LIMIT && cost / (divisor * divisor) > SLOW_SECONDS)
        divisor++;
    while (divisor > 1 && cost / ((divisor - 1) * (divisor - 1)) < FINER_SECONDS)
        divisor--;
    return divisor;
}

// Draw the picture at the resolution that is due, and learn what a sharp one costs. The first frame
// of a program tells nothing of it: drivers finish compiling while they draw it.
static bool draw_picture(struct window *window, double now)
{
    struct renderer *renderer = window->renderer;
    struct renderer_inputs inputs = window->inputs;
    if (window->moved)
        window->rest_at = now + REST_SECONDS;
    int divisor = window->divisor = divisor_for(window, now);
    inputs.width = (inputs.width + divisor - 1) / divisor;
    inputs.height = (inputs.height + divisor - 1) / divisor;
    for (int i = 0; i < 2 && inputs.pixel[0] >= 0; i++)
        inputs.pixel[i] /= divisor;
    for (int i = 0; i < 4; i++)
        inputs.mouse[i] /= (float)divisor;
    double begin = glfwGetTime();
    if (!renderer_draw(renderer, &inputs, 0, inputs.height))
        return false;
    renderer->gl->Finish();
    window->seconds = glfwGetTime() - begin;
    GLuint program = renderer->program[renderer->view];
    if (program == window->measured)
        window->cost = window->seconds * divisor * divisor;
    window->measured = program;
    renderer_present(renderer, window->inputs.width, window->inputs.height);
    return true;
}

// The rate of frames that follow each other; while nothing changes none is drawn.
static void count(struct window *window, double now)
{
    double seconds = window->drew ? now - window->frame : 0.0;
    if (seconds > 0.0)
        window->rate += (window->rate > 0.0 ? 0.1 : 1.0) * (1.0 / seconds - window->rate);
    window->frame = now;
    window->inputs.frame++;
    if (now < window->figures_at)
        return;
    window->figures_at = now + FIGURES_SECONDS;
    window->figures[0] = window->rate;
    window->figures[1] = 1000.0 * window->seconds;
}

bool window_draw(struct window *window, double now)
{
    struct renderer_inputs *inputs = &window->inputs;
    const struct gl *gl = window->renderer->gl;
    inputs->time_delta = inputs->frame > 0 && !window->paused ? now - window->frame : 0.0;
    window_tell_date(window);
    if (!draw_picture(window, now))
        return false;
    follow_ray(window);
    gather(window);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    overlay_draw(&window->overlay, 0);
    GLenum error = gl->GetError();
    if (error != GL_NO_ERROR) {
        report("window %dx%d: OpenGL error 0x%04x while drawing: try a smaller --size",
               inputs->width, inputs->height, error);
        return false;
    }
    glfwSwapBuffers(window->handle);
    count(window, now);
    return true;
}
