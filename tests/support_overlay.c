#include "support_overlay.h"

#include <stdio.h>

#include "../common/platform.h"
#include "../common/picture/panel.h"
#include "../common/platform.h"
#include "support_gpu.h"

enum { WIDTH = 960, HEIGHT = 540, WARM_UP = 10, FRAMES = 120, RATE = 60 };

// The framebuffer of a window: 8 bits a channel, blue first, no depth.
struct screen {
    GLuint framebuffer, texture;
};

// What a window shows beside the panel of a chapter.
static const struct {
    const char *name;
    bool keys, ray;
} cases[] = {
    {"panel", false, false}, {"panel and keys", true, false}, {"panel and ray", false, true}};
enum { CASES = sizeof cases / sizeof *cases };

static struct screen open_screen(const struct gl *gl)
{
    struct screen screen;
    gl->GenFramebuffers(1, &screen.framebuffer);
    gl->GenTextures(1, &screen.texture);
    gl->BindTexture(GL_TEXTURE_2D, screen.texture);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, WIDTH, HEIGHT, 0, GL_BGRA, GL_UNSIGNED_BYTE, NULL);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->BindFramebuffer(GL_FRAMEBUFFER, screen.framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, screen.texture,
                             0);
    return screen;
}

// Bring the picture onto the screen, and a panel over it; NULL: none.
static void show(const struct screen *screen, const struct panel *panel, struct overlay *overlay)
{
    const struct gl *gl = &gpu.context.gl;
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, gpu.renderer.picture.framebuffer);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, screen->framebuffer);
    gl->BlitFramebuffer(0, 0, WIDTH, HEIGHT, 0, 0, WIDTH, HEIGHT, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl->BindFramebuffer(GL_FRAMEBUFFER, screen->framebuffer);
    if (panel != NULL) {
        panel_gather(panel, overlay, WIDTH, HEIGHT, overlay_scale_of(HEIGHT));
        overlay_draw(overlay, 0, HEIGHT);
    }
    gl->Finish();
}

// The keys that a window lists for an American keyboard.
static const struct panel_key keys[] = {{"W A S D", "move"},      {"Space C", "up, down"},
                                        {"Shift", "faster"},      {"drag", "look"},
                                        {"M", "mouse look"},      {"click", "ray"},
                                        {"Q E", "step back, on"}, {"Home End", "first, last step"},
                                        {"wheel", "zoom"},        {"1 2 3 4 5 6", "view"},
                                        {"↑ ↓", "choose"},        {"← →", "change"},
                                        {"Delete", "reset"},      {"Tab", "orthographic"},
                                        {"Esc", "pause"},         {"R", "restart"},
                                        {"P", "screenshot"},      {"H", "hide all"},
                                        {"K", "fewer"},           {"F11", "full screen"},
                                        {"Backspace", "end"}};

// What a window's panel says in a frame: its figures change four times a second.
static struct panel panel_of(const struct renderer *chapter, int which, const struct probe *probe,
                             int frame, struct panel_rows *rows)
{
    return (struct panel){.title = "01 Normal colouring",
                          .renderer = chapter,
                          .chosen = &chapter->parameters.item[0],
                          .rate = 60.0 + frame / (RATE / 4) % 3,
                          .milliseconds = 12.3,
                          .timed = true,
                          .time = (double)frame / RATE,
                          .resolution = 100,
                          .ranges = cases[which].keys,
                          .hint = "K: keys, ranges    H: hide",
                          .keys = keys,
                          .key_count = cases[which].keys ? (int)(sizeof keys / sizeof *keys) : 0,
                          .pixel = {cases[which].ray ? WIDTH / 2 : -1, HEIGHT / 2},
                          .probe = probe,
                          .rows = rows};
}

// Frames without a panel, then with each, in turn: the seconds of all, summed up.
//   shown  of what comes after the drawing: without a panel, and with each
static bool measure(const struct renderer *chapter, const struct screen *screen,
                    struct overlay overlay[CASES], double *drawn, double shown[1 + CASES])
{
    struct renderer_inputs inputs = gpu_inputs(WIDTH, HEIGHT, 1);
    struct probe probe = {.steps = 20, .all_steps = 20, .recorded = true};
    struct panel_rows rows = {0};
    bool done = true;
    for (int i = 0; i < probe.steps; i++)
        probe.step[i] = (struct probe_step){.t = 0.25f * (float)i, .distance = 0.25f};
    for (int i = 0; i < WARM_UP + FRAMES && done; i++)
        for (int k = 0; k <= CASES && done; k++) {
            const bool counts = i >= WARM_UP;
            struct panel panel = {0};
            inputs.time = (double)i / RATE;
            double begin = platform_processor_seconds();
            done = renderer_draw(&gpu.renderer, &inputs, 0, HEIGHT);
            gpu.context.gl.Finish();
            double middle = platform_processor_seconds();
            if (k > 0)
                panel = panel_of(chapter, k - 1, &probe, i, &rows);
            show(screen, k > 0 ? &panel : NULL, &overlay[k > 0 ? k - 1 : 0]);
            shown[k] += counts ? platform_processor_seconds() - middle : 0.0;
            *drawn += counts ? (middle - begin) / (1 + CASES) : 0.0;
        }
    panel_rows_free(&rows);
    return done;
}

int overlay_print(void)
{
    const struct gl *gl = &gpu.context.gl;
    struct renderer chapter = {0};
    struct overlay overlay[CASES] = {{0}};
    struct screen screen = open_screen(gl);
    double drawn = 0.0, shown[1 + CASES] = {0.0};
    char path[8192];
    snprintf(path, sizeof path, "%s/chapters/03_shadows.frag", gpu.root);
    bool done = renderer_open(&chapter, gl, gpu.root) && gpu_load_file(&chapter, path) &&
                gpu_load("tests/reference_scene.frag");
    for (int k = 0; k < CASES; k++)
        done = done && overlay_open(&overlay[k], gl);
    done = done && measure(&chapter, &screen, overlay, &drawn, shown);
    const double frame = drawn + shown[0];
    if (done) {
        printf("# processor time over the annex scene, %dx%d, whose frame takes %.2f ms: two "
               "seconds of %d frames each\n",
               WIDTH, HEIGHT, 1000.0 * frame / FRAMES, RATE);
        printf("over the picture,ms,share of the frame %%\n");
        for (int k = 0; k < CASES; k++)
            printf("%s,%.2f,%.1f\n", cases[k].name, 1000.0 * (shown[1 + k] - shown[0]) / FRAMES,
                   100.0 * (shown[1 + k] - shown[0]) / frame);
    }
    for (int k = 0; k < CASES; k++)
        overlay_close(&overlay[k]);
    gl->DeleteTextures(1, &screen.texture);
    gl->DeleteFramebuffers(1, &screen.framebuffer);
    renderer_close(&chapter);
    return done ? 0 : 1;
}
