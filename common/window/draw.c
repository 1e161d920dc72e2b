#include "window/draw.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "picture/comparison.h"
#include "picture/pen.h"
#include "picture/probe.h"
#include "platform.h"
#include "report.h"
#include "window/condition.h"
#include "window/contents.h"
#include "window/frames.h"
#include "window/handle.h"
#include "window/keys.h"
#include "window/panel_input.h"
#include "window/ray.h"
#include "window/selection.h"

#define FIGURES_SECONDS 0.25 // between two updates of the overlay's frame rate
// The time for which the picture must be at rest before it is sharpened. It is longer than the time
// between two repeats of a held key.
#define REST_SECONDS 0.3
// The time after which a picture at rest is drawn again, with SMOOTH x SMOOTH samples for a pixel.
#define SMOOTH_SECONDS 1.0
#define SMOOTH         3
#define MOVING_SMOOTH  2 // the same for a picture that moves, if it is drawn in MOVING_SECONDS
#define MOVING_SECONDS 0.03
#define PIECE_SECONDS  0.05 // spent on sharpening between two checks of the input
#define TRIAL_SECONDS  0.02 // a trial picture that takes longer is the last
#define TRIAL_FINEST   12   // the finest level of a trial picture
#define GROWTH_TRIED   16.0 // a picture with this many times more pixels than the last is tried

// True if nothing has moved for a while, so that the rate of earlier frames is meaningless.
static bool rests(const struct window *window)
{
    return !window->moved && glfwGetTime() >= window->sharpening.due;
}

// The name of what is shown.
static const char *name_of(const struct window *window)
{
    return window->opened[0] != '\0' ? window->opened : window->start->title;
}

void window_retitle(struct window *window)
{
    char text[sizeof window->title.shown], name[76] = "", value[128] = "", rate[32] = "";
    const struct parameter *parameter = window_selected(window);
    if (parameter != NULL)
        parameter_value_text(parameter, value, sizeof value);
    if (parameter != NULL)
        comparison_parameter_name(window->renderer, parameter, name, sizeof name);
    if (window->pace.rate > 0.0 && !rests(window))
        snprintf(rate, sizeof rate, " - %.*f fps", window->pace.rate < 9.95 ? 1 : 0,
                 window->pace.rate);
    snprintf(text, sizeof text, "%.60s%s%s - %s%s%s%s%.60s%s", name_of(window),
             window->panel.error[0] != '\0' ? " - error" : "", rate,
             shader_view_name(window->renderer->view), parameter != NULL ? " - " : "", name,
             parameter != NULL ? " = " : "", value, window->paused ? " (paused)" : "");
    report_clean(text, sizeof text, text); // a name may have been cut within a character
    if (strcmp(text, window->title.shown) != 0)
        glfwSetWindowTitle(window->handle, text);
    memcpy(window->title.shown, text, sizeof text);
}

static double pixels_of(const struct renderer_inputs *inputs)
{
    return (double)inputs->width * inputs->height;
}

// ---- Overlay ----

// Return how much of the picture is sharp, in percent, rounded up: 0 before sharpening begins.
static int sharp_percent(const struct window *window)
{
    const struct renderer_inputs *inputs = &window->sharpening.inputs;
    double pixels = (double)inputs->width * window->sharpening.rows + window->sharpening.columns;
    if (window->sharpening.smooths)
        return 100;
    return pixels > 0.0 ? (int)ceil(100.0 * pixels / pixels_of(inputs)) : 0;
}

// Hide the picture and the overlay's other parts behind black. Only a lecture's audience sees
// nothing else.
static void cover(struct overlay *overlay, bool says)
{
    static const struct overlay_colour black = {{0, 0, 0, 255}};
    const float width = pen_picture_width(overlay), height = pen_picture_height(overlay);
    overlay_box(overlay, 0.0f, 0.0f, width, height, black);
    if (says)
        overlay_text(overlay, PEN_MARGIN, height - OVERLAY_LINE - PEN_MARGIN,
                     "any key ends the black screen", PEN_DIM);
}

static void fill_overlay(struct window *window)
{
    const struct renderer_inputs *inputs = &window->inputs;
    // A phone shows many pixels on a small screen, so the scale also depends on the pixel density.
    float own = fmaxf(overlay_scale_of(inputs->height),
                      fminf(window->density, (float)OVERLAY_SCALE_MAXIMUM));
    double scale = window->start->overlay_scale;
    window_list_keys(window);
    struct panel panel = {
        .title = name_of(window),
        .renderer = window->renderer,
        .selected = window_selected(window),
        .selected_part = window_selected_part(window),
        .choice = window_key_acts(window, KEY_WITH_MARCH),
        .rate = rests(window) ? 0.0 : window->panel.figures[0],
        .milliseconds = window->panel.figures[1],
        .timed = window_uses_time(window),
        .time = inputs->time,
        .averaged = window_averages(window) ? inputs->frame + 1 : 0,
        .resolution =
            (int)fmax(round(100.0 / resolution_divisor(window->pace.resolution.level)), 1.0),
        .sharp = sharp_percent(window),
        .paused = window->paused,
        .folded = window->panel.folded,
        .bare = window->panel.folded && window->panel.in_page,
        .ranges = window->panel.helps,
        .hint = window->panel.hint,
        .caption = window->panel.captioned ? window->start->caption : NULL,
        .keys = window->panel.keys,
        .key_count = window->panel.helps ? window->panel.key_count : 0,
        .pixel = {inputs->pixel[0], inputs->pixel[1]},
        .side = comparison_side_name(window->renderer, inputs->width, inputs->pixel[0]),
        .shown = inputs->shown,
        .probe = window->ray.why[0] == '\0' ? window->ray.probe : NULL,
        .why = window->ray.why,
        .note = window->panel.note[0] != '\0' ? window->panel.note : NULL,
        .note_heading = window->panel.note_heading,
        .error = window->panel.error,
        .broken = window->broken,
        .unset = window->renderer->fragment.unset,
        .rows = &window->panel.rows,
    };
    char tip[512];
    int moves = 0;
    do {
        window_panel_fill(window, &panel, tip);
        panel_gather(&panel, &window->panel.overlay, inputs->width, inputs->height,
                     scale > 0.0 ? (float)scale : own);
    } while (window_uncover_handles(window, moves++));
    window_draw_handles(window);
    if (window->black)
        cover(&window->panel.overlay, window_has_contents(window));
    window->renderer->overlay = window->start->overlay_kept ? &window->panel.overlay : NULL;
}

// ---- A frame ----

// Draw the picture at a resolution level, and store the seconds that this took.
//   samples  along each side of a pixel
//   pixels   receives the number of pixels, each as often as it was drawn
static bool draw_at(struct window *window, int level, int samples, double *pixels)
{
    struct renderer_inputs inputs = window_inputs_at(window, level);
    inputs.samples = samples;
    double begin = glfwGetTime();
    if (!renderer_draw(window->renderer, &inputs, 0, inputs.height))
        return false;
    window->renderer->gl->Finish();
    window->pace.seconds = glfwGetTime() - begin;
    *pixels = pixels_of(&inputs) * samples * samples;
    return true;
}

// Estimate the cost of a new program from pictures that are not shown, so that a slow program never
// blocks the window. The first has a few pixels, and each of the next four times as many, until one
// takes long enough to be measured. All of them see the whole scene, so each takes at most about
// four times as long as the last, even if a few pixels cost much more than the others. The first is
// drawn twice, because drivers finish compiling during the first draw. The line through the first
// and the last estimates the fixed cost and the cost of a pixel. A picture of few pixels shows
// nothing about the cost of one, so the trial is repeated when a window that was tiny grows.
static bool try_program(struct window *window)
{
    const struct renderer *renderer = window->renderer;
    GLuint program = renderer->program[renderer->view];
    bool grown = pixels_of(&window->inputs) > GROWTH_TRIED * window->pace.known;
    window->pace.known = pixels_of(&window->inputs);
    if (program == window->pace.tried && !grown)
        return true;
    window->pace.tried = program;
    double few = 0.0, pixels = 0.0, seconds = 0.0, cost = 0.0;
    int samples = window->inputs.samples;
    if (!draw_at(window, RESOLUTION_COARSEST, samples, &few) ||
        !draw_at(window, RESOLUTION_COARSEST, samples, &few))
        return false;
    seconds = window->pace.seconds;
    for (int level = RESOLUTION_COARSEST - 4; level >= TRIAL_FINEST; level -= 4) {
        if (!draw_at(window, level, samples, &pixels))
            return false;
        if (pixels > few)
            cost = fmax(window->pace.seconds - seconds, 0.0) / (pixels - few);
        if (window->pace.seconds > TRIAL_SECONDS)
            break;
    }
    resolution_guess(&window->pace.resolution, fmax(seconds - cost * few, 0.0), cost);
    return true;
}

// True if edges may be smoother than the command line asks. In a page, the picture of a program is
// compared with that of a file. Frames that are kept have one sample for each pixel.
static bool may_smooth(const struct window *window)
{
    return window->start->smooths && !window->shooting && !window->panel.in_page &&
           window->renderer->view == VIEW_PICTURE && !window_keeps(window);
}

// Draw the picture at the resolution that its cost allows, and with smooth edges if there is time.
static bool draw_picture(struct window *window, double now)
{
    if (window->moved)
        window->sharpening.due = now + REST_SECONDS;
    struct resolution *resolution = &window->pace.resolution;
    window_follow_frames(window, resolution->level);
    bool begun = window_keeps(window) && window->inputs.frame > 0;
    if (!begun && !try_program(window))
        return false;
    double drawn, pixels = pixels_of(&window->inputs);
    int before = resolution->level, level = window_choose_level(window);
    if (level < before && window->inputs.frame > 2 && window_averages(window))
        window_note(window, "The mean begins again", "with more pixels");
    int samples = window->inputs.samples;
    window_follow_frames(window, level);
    if (may_smooth(window) && level == 0 &&
        resolution_cost(resolution) * pixels * MOVING_SMOOTH * MOVING_SMOOTH < MOVING_SECONDS)
        samples = MOVING_SMOOTH;
    if (!draw_at(window, level, samples, &drawn))
        return false;
    resolution_learn(resolution, window->pace.seconds, drawn);
    window->sharpening.inputs = window->inputs;
    window->sharpening.inputs.samples = samples;
    window->sharpening.rows = window->sharpening.columns = 0;
    window->sharpening.seconds = 0.0;
    window->sharpening.smooths = false;
    window->sharpening.next =
        fmin(PIECE_SECONDS * drawn / (window->pace.seconds + 1e-9), 64.0 * window->inputs.width);
    window->inputs.frame += !window_keeps(window);
    return true;
}

// True if the picture is at rest, complete, and still to be drawn with smooth edges.
static bool begins_to_smooth(const struct window *window, double now)
{
    bool complete = window->pace.resolution.level == 0 ||
                    window->sharpening.rows == window->sharpening.inputs.height;
    return may_smooth(window) && complete && !window->sharpening.smooths &&
           now >= window->sharpening.due - REST_SECONDS + SMOOTH_SECONDS;
}

bool window_sharpens(const struct window *window, double now)
{
    bool pieces =
        (window->pace.resolution.level > 0 && !window_keeps(window)) || window->sharpening.smooths;
    return begins_to_smooth(window, now) ||
           (pieces && window->sharpening.rows < window->sharpening.inputs.height &&
            now >= window->sharpening.due);
}

// Begin to draw the picture once more. The complete picture stays below the new rows.
static void begin_to_smooth(struct window *window)
{
    struct renderer *renderer = window->renderer;
    if (window->pace.resolution.level > 0) {
        struct target complete = renderer->sharp;
        renderer->sharp = renderer->picture;
        renderer->picture = complete;
    }
    window->sharpening.smooths = true;
    window->sharpening.rows = window->sharpening.columns = 0;
    window->sharpening.inputs.samples = SMOOTH;
    window->sharpening.next /= SMOOTH * SMOOTH;
}

// Return the next piece of the sharp picture: some rows, or a part of one row if a whole row takes
// too long. The slice and the plot are always drawn in whole rows (renderer_sharpen).
static struct renderer_piece next_piece(const struct window *window)
{
    const struct renderer_inputs *inputs = &window->sharpening.inputs;
    int width = inputs->width, top = inputs->height - window->sharpening.rows;
    int left = window->sharpening.columns, pixels = (int)fmax(window->sharpening.next, 1.0);
    bool whole = left == 0 && pixels >= width;
    int rows = whole && pixels / width < top ? pixels / width : whole ? top : 1;
    int right =
        pixels < width - left && !shader_shows_ray(window->renderer->view) ? left + pixels : width;
    return (struct renderer_piece){left, right, top - rows, top};
}

// Draw some more pixels of the sharp picture, from the top down: few enough that input never has to
// wait.
static bool sharpen(struct window *window)
{
    double begin = glfwGetTime();
    if (begins_to_smooth(window, begin))
        begin_to_smooth(window);
    const struct renderer_inputs *inputs = &window->sharpening.inputs;
    struct renderer_piece piece = next_piece(window);
    int rows = piece.top - piece.bottom, columns = piece.right - piece.left;
    if (!renderer_sharpen(window->renderer, inputs, &piece))
        return false;
    window->renderer->gl->Finish();
    double seconds = glfwGetTime() - begin;
    window->sharpening.rows += piece.right == inputs->width ? rows : 0;
    window->sharpening.columns = piece.right % inputs->width;
    window->sharpening.seconds += seconds;
    window->sharpening.next =
        fmin((double)rows * columns * fmin(PIECE_SECONDS / (seconds + 1e-9), 2.0),
             4096.0 * inputs->width);
    if (window->sharpening.rows < inputs->height || window->sharpening.smooths)
        return true;
    window->pace.seconds = window->sharpening.seconds;
    resolution_learn(&window->pace.resolution, window->pace.seconds, pixels_of(inputs));
    return true;
}

// Show the picture, enlarged to the window. If it is smaller, measure how long this takes.
static void show_picture(struct window *window)
{
    const struct renderer *renderer = window->renderer;
    const struct renderer_inputs *inputs = &window->sharpening.inputs;
    double begin = glfwGetTime();
    renderer_present(renderer, inputs->width, inputs->height);
    if (window->pace.resolution.level == 0 || window->sharpening.smooths)
        return;
    renderer->gl->Finish();
    resolution_learn_enlarging(&window->pace.resolution, glfwGetTime() - begin, pixels_of(inputs));
}

// Show the picture, and over it the rows that are already sharp.
static void present(struct window *window)
{
    int height = window->sharpening.inputs.height, sharp = window->sharpening.rows;
    if (sharp < height)
        show_picture(window);
    if (sharp > 0)
        renderer_present_sharp(window->renderer, height - sharp, sharp);
}

// Update the frame rate from consecutive frames only, because no frame is drawn while nothing
// changes.
static void update_rate(struct window *window, double now)
{
    double seconds = window->pace.drew ? now - window->pace.frame : 0.0;
    if (seconds > 0.0)
        window->pace.rate +=
            (window->pace.rate > 0.0 ? 0.1 : 1.0) * (1.0 / seconds - window->pace.rate);
    window->pace.frame = now;
    if (now < window->panel.figures_due)
        return;
    window->panel.figures_due = now + FIGURES_SECONDS;
    window->panel.figures[0] = window->pace.rate;
    window->panel.figures[1] = 1000.0 * window->pace.seconds;
}

// Set Shadertoy's iDate to the local date and time.
static void update_date(struct renderer_inputs *inputs)
{
    struct tm day = {0};
    double fraction = platform_date(&day);
    inputs->date[0] = (float)(day.tm_year + 1900);
    inputs->date[1] = (float)day.tm_mon;
    inputs->date[2] = (float)day.tm_mday;
    inputs->date[3] = (float)(3600 * day.tm_hour + 60 * day.tm_min + day.tm_sec) + (float)fraction;
}

bool window_draw(struct window *window, double now)
{
    struct renderer_inputs *inputs = &window->inputs;
    const struct gl *gl = window->renderer->gl;
    bool draws = window->stale;
    if (window->contents.open) {
        if (!window_contents_draw(window))
            return false;
        glfwSwapBuffers(window->handle);
        window->dirty = false;
        return true;
    }
    if (!window_keeps(window))
        inputs->time_delta = inputs->frame > 0 && !window->paused ? now - window->pace.frame : 0.0;
    update_date(&window->inputs);
    if (draws && !draw_picture(window, now))
        return false;
    if (!draws && window_sharpens(window, now) && !sharpen(window))
        return false;
    if (draws || window->ray.follow)
        window_follow_ray(window);
    fill_overlay(window);
    present(window);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    overlay_draw(&window->panel.overlay, 0, inputs->height);
    GLenum error = gl->GetError();
    if (error != GL_NO_ERROR)
        return report("window %dx%d: OpenGL error 0x%04x while drawing: try a smaller --size",
                      inputs->width, inputs->height, error);
    glfwSwapBuffers(window->handle);
    window->stale = window->ray.follow = window->dirty = false;
    update_rate(window, now);
    return true;
}
