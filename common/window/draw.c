#include "window/state.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "picture/pair.h"
#include "picture/probe.h"
#include "report.h"

#define FIGURES_SECONDS 0.25 // between two changes of the overlay's rate
#define REST_SECONDS                                                                               \
    0.3                   // without motion until the picture sharpens: longer than between two
                          // repeats of a held key
#define BAND_SECONDS 0.05 // of sharpening between two looks at what the hands do

void window_retitle(struct window *window)
{
    char text[sizeof window->title.shown], name[76] = "", value[128] = "", rate[32] = "";
    const struct parameter *parameter = window_chosen(window);
    if (parameter != NULL)
        parameter_value_text(parameter, value, sizeof value);
    if (parameter != NULL)
        pair_parameter_name(window->renderer, parameter, name, sizeof name);
    if (window->pace.rate > 0.0)
        snprintf(rate, sizeof rate, " - %.0f fps", window->pace.rate);
    snprintf(text, sizeof text, "%.60s%s%s - %s%s%s%s%.60s%s", window->start->title,
             window->broken ? " - error: see terminal" : "", rate,
             shader_view_name(window->renderer->view), parameter != NULL ? " - " : "", name,
             parameter != NULL ? " = " : "", value, window->paused ? " (paused)" : "");
    if (strcmp(text, window->title.shown) != 0)
        glfwSetWindowTitle(window->handle, text);
    memcpy(window->title.shown, text, sizeof text);
}

// The linker keeps only what is used.
static bool program_uses_time(const struct renderer *renderer, enum shader_view view)
{
    static const char *const names[] = {"iTime", "iTimeDelta", "iFrame", "iFrameRate", "iDate"};
    GLuint program = renderer->program[view];
    for (size_t i = 0; i < sizeof names / sizeof *names && program != 0; i++)
        if (renderer->gl->GetUniformLocation(program, names[i]) >= 0)
            return true;
    return renderer->pair != NULL && program_uses_time(renderer->pair->other, view);
}

bool window_uses_time(const struct window *window)
{
    const struct renderer *renderer = window->renderer;
    bool slice = form_shows_ray(renderer->view), chosen = window->inputs.pixel[0] >= 0;
    return program_uses_time(renderer, renderer->view) ||
           ((chosen || slice) && program_uses_time(renderer, SHADER_PROBE)) ||
           (chosen && slice && program_uses_time(renderer, SHADER_PICTURE));
}

// ---- Overlay ----

static void gather(struct window *window)
{
    const struct renderer_inputs *inputs = &window->inputs;
    double scale = window->start->overlay_scale;
    window_name_keys(window);
    struct panel panel = {
        .title = window->start->title,
        .renderer = window->renderer,
        .chosen = window_chosen(window),
        .rate = window->panel.figures[0],
        .milliseconds = window->panel.figures[1],
        .timed = window_uses_time(window),
        .time = inputs->time,
        .resolution = (int)lround(100.0 / resolution_divisor(window->pace.resolution.level)),
        .sharp = window->sharpening.inputs.height > 0
                     ? 100 * window->sharpening.rows / window->sharpening.inputs.height
                     : 0,
        .paused = window->paused,
        .folded = window->panel.folded,
        .bare = window->panel.folded && window->panel.elsewhere,
        .ranges = window->panel.helps,
        .hint = window->panel.hint,
        .keys = window->panel.keys,
        .key_count = window->panel.helps ? window->panel.key_count : 0,
        .pixel = {inputs->pixel[0], inputs->pixel[1]},
        .side = pair_side_name(window->renderer, inputs->width, inputs->pixel[0]),
        .shown = inputs->shown,
        .probe = window->ray.why[0] == '\0' ? window->ray.probe : NULL,
        .why = window->ray.why,
        .error = window->panel.error,
        .broken = window->broken,
        .rows = &window->panel.rows,
    };
    char tip[512];
    window_touch_tell(window, &panel, tip);
    panel_gather(&panel, &window->panel.overlay, inputs->width, inputs->height,
                 scale > 0.0 ? (float)scale : overlay_scale_of(inputs->height));
    window->renderer->overlay = window->start->overlay_kept ? &window->panel.overlay : NULL;
}

// ---- A frame ----

static double pixels_of(const struct renderer_inputs *inputs)
{
    return (double)inputs->width * inputs->height;
}

// Draw the picture at a level of the resolution.
//   cost  takes the seconds that a pixel took
static bool draw_at(struct window *window, int level, double *cost)
{
    struct renderer_inputs inputs = window->inputs;
    double divisor = resolution_divisor(level);
    inputs.width = resolution_side(level, inputs.width);
    inputs.height = resolution_side(level, inputs.height);
    for (int i = 0; i < 2 && inputs.pixel[0] >= 0; i++)
        inputs.pixel[i] = (int)(inputs.pixel[i] / divisor);
    for (int i = 0; i < 4; i++)
        inputs.mouse[i] /= (float)divisor;
    double begin = glfwGetTime();
    if (!renderer_draw(window->renderer, &inputs, 0, inputs.height))
        return false;
    window->renderer->gl->Finish();
    window->pace.seconds = glfwGetTime() - begin;
    *cost = window->pace.seconds / pixels_of(&inputs);
    return true;
}

// Learn what a pixel of a new program costs by a small picture that nobody sees, so that a heavy
// one never holds the window up. Drivers finish compiling in the first. What each draw costs beside
// its pixels counts much in so small a one: hence the half. A slice costs little in any scene.
static bool try_program(struct window *window)
{
    const struct renderer *renderer = window->renderer;
    GLuint program = renderer->program[renderer->view];
    if (program == window->pace.tried)
        return true;
    window->pace.tried = program;
    double cost = 0.0;
    bool slice = form_shows_ray(renderer->view);
    for (int i = 0; i < 2 && !slice; i++)
        if (!draw_at(window, RESOLUTION_COARSEST, &cost))
            return false;
    resolution_guess(&window->pace.resolution, 0.5 * cost);
    return true;
}

// Draw the picture at the resolution that is due.
static bool draw_picture(struct window *window, double now)
{
    if (window->moved)
        window->sharpening.rest_at = now + REST_SECONDS;
    if (!try_program(window))
        return false;
    double cost, pixels = pixels_of(&window->inputs);
    double beside = enlarging_choose(&window->pace.enlarging, pixels);
    if (!draw_at(window, resolution_choose(&window->pace.resolution, pixels, beside), &cost))
        return false;
    resolution_learn(&window->pace.resolution, cost);
    window->sharpening.inputs = window->inputs;
    window->sharpening.rows = 0;
    window->sharpening.seconds = 0.0;
    window->sharpening.band =
        (int)fmin(BAND_SECONDS / (cost * window->sharpening.inputs.width + 1e-9), 64.0) + 1;
    window->inputs.frame++;
    return true;
}

bool window_sharpens(const struct window *window, double now)
{
    return window->pace.resolution.level > 0 &&
           window->sharpening.rows < window->sharpening.inputs.height &&
           now >= window->sharpening.rest_at;
}

// Draw a few more rows of the sharp picture, from the top down: so many that what the hands do is
// never left waiting.
static bool sharpen(struct window *window)
{
    const struct renderer_inputs *inputs = &window->sharpening.inputs;
    int left = inputs->height - window->sharpening.rows;
    int rows = window->sharpening.band < left ? window->sharpening.band : left;
    double begin = glfwGetTime();
    if (!renderer_sharpen(window->renderer, inputs, left - rows, rows))
        return false;
    window->renderer->gl->Finish();
    double seconds = glfwGetTime() - begin;
    window->sharpening.rows += rows;
    window->sharpening.seconds += seconds;
    window->sharpening.band =
        (int)fmin(rows * fmin(BAND_SECONDS / (seconds + 1e-9), 2.0), 4096.0) + 1;
    if (window->sharpening.rows < inputs->height)
        return true;
    window->pace.seconds = window->sharpening.seconds;
    resolution_learn(&window->pace.resolution, window->pace.seconds / pixels_of(inputs));
    return true;
}

// Fill the window from the picture, and learn what that takes where the picture is smaller.
static bool enlarge(struct window *window)
{
    struct renderer *renderer = window->renderer;
    struct enlarging *enlarging = &window->pace.enlarging;
    const struct renderer_inputs *inputs = &window->sharpening.inputs;
    enum enlarge_filter filter = enlarging->plain ? ENLARGE_BILINEAR : ENLARGE_EDGE;
    double begin = glfwGetTime();
    if (!renderer_present(renderer, filter, inputs->width, inputs->height))
        return false;
    if (window->pace.resolution.level == 0)
        return true;
    renderer->gl->Finish();
    enlarging_learn(enlarging, (glfwGetTime() - begin) / pixels_of(inputs));
    return true;
}

// Show what there is: the picture, and over it what is sharp already.
static bool present(struct window *window)
{
    int height = window->sharpening.inputs.height, sharp = window->sharpening.rows;
    if (sharp < height && !enlarge(window))
        return false;
    if (sharp > 0)
        renderer_present_sharp(window->renderer, height - sharp, sharp);
    return true;
}

// The rate of frames that follow each other; while nothing changes none is drawn.
static void count(struct window *window, double now)
{
    double seconds = window->pace.drew ? now - window->pace.frame : 0.0;
    if (seconds > 0.0)
        window->pace.rate +=
            (window->pace.rate > 0.0 ? 0.1 : 1.0) * (1.0 / seconds - window->pace.rate);
    window->pace.frame = now;
    if (now < window->panel.figures_at)
        return;
    window->panel.figures_at = now + FIGURES_SECONDS;
    window->panel.figures[0] = window->pace.rate;
    window->panel.figures[1] = 1000.0 * window->pace.seconds;
}

bool window_draw(struct window *window, double now)
{
    struct renderer_inputs *inputs = &window->inputs;
    const struct gl *gl = window->renderer->gl;
    bool draws = window->stale;
    inputs->time_delta = inputs->frame > 0 && !window->paused ? now - window->pace.frame : 0.0;
    window_tell_date(window);
    if (draws && !draw_picture(window, now))
        return false;
    if (!draws && window_sharpens(window, now) && !sharpen(window))
        return false;
    if (draws || window->ray.follow)
        window_follow_ray(window);
    gather(window);
    if (!present(window))
        return false;
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    overlay_draw(&window->panel.overlay, 0, inputs->height);
    GLenum error = gl->GetError();
    if (error != GL_NO_ERROR)
        return report("window %dx%d: OpenGL error 0x%04x while drawing: try a smaller --size",
                      inputs->width, inputs->height, error);
    glfwSwapBuffers(window->handle);
    window->stale = window->ray.follow = window->dirty = false;
    count(window, now);
    return true;
}
