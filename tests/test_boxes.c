// test_boxes.c - the panels over every chapter's picture, in every view, with the keys of several
// keyboards, at sizes and scales that people use: none covers another, none is cut off, and each
// letter stands in its panel. Places are compared; nothing is drawn.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <glob.h>

#include <cmocka.h>

#include "../common/picture/pair.h"
#include "../common/picture/panel.h"
#include "../common/shader/source.h"
#include "support_gpu.h"

enum { KEYS = 21, BOARDS = 4, BACKS = 16 };

// What stands on the keys of four keyboards; the last one's names are as long as they may be.
static const char *const labels[BOARDS][KEYS] = {
    {"W A S D",  "Space C", "Shift",       "drag", "M",   "click",  "Q E",
     "Home End", "wheel",   "1 2 3 4 5 6", "↑ ↓",  "← →", "Delete", "Tab",
     "Esc",      "R",       "P",           "H",    "K",   "F11",    "Backspace"},
    {"Z Q S D",  "Space C", "Shift",    "drag",  "\",\"",
     "click",    "A E",     "Home End", "wheel", "& É \" ' ( -",
     "↑ ↓",      "← →",     "Delete",   "Tab",   "Esc",
     "R",        "P",       "H",        "K",     "F11",
     "Backspace"},
    {"W A S D",  "Space C", "Shift",       "drag", "M",   "click",  "Q E",
     "Home End", "wheel",   "1 2 3 4 5 6", "↑ ↓",  "← →", "Delete", "Tab",
     "Esc",      "R",       "P",           "H",    "K",   "F11",    "Backspace"},
    {"WWWW WWWW WWWW WWWW",
     "Space WWWW",
     "Shift",
     "drag",
     "WWWW",
     "click",
     "WWWW WWWW",
     "Home End",
     "wheel",
     "WWWW WWWW WWWW WWWW WWWW WWWW",
     "↑ ↓",
     "← →",
     "Delete",
     "Tab",
     "Esc",
     "WWWW",
     "WWWW",
     "WWWW",
     "WWWW",
     "F11",
     "Backspace"}};
static const char *const does[KEYS] = {
    "move",          "up, down",         "faster", "look",    "mouse look", "ray",
    "step back, on", "first, last step", "zoom",   "view",    "choose",     "change",
    "reset",         "orthographic",     "pause",  "restart", "screenshot", "hide all",
    "fewer",         "full screen",      "end"};

static struct overlay overlay;
static struct panel_key keys[KEYS];

static void name_keys(int board)
{
    for (int i = 0; i < KEYS; i++) {
        snprintf(keys[i].label, sizeof keys[i].label, "%s", labels[board][i]);
        keys[i].does = does[i];
    }
}

static bool inside(const struct overlay_rectangle *a, const struct overlay_rectangle *in)
{
    return a->left >= in->left && a->top >= in->top && a->right <= in->right &&
           a->bottom <= in->bottom;
}

static bool meet(const struct overlay_rectangle *a, const struct overlay_rectangle *b)
{
    return a->left < b->right && b->left < a->right && a->top < b->bottom && b->top < a->bottom;
}

// The panels are the boxes of their ground's colour.
static int backs_of(const struct overlay_rectangle *back[BACKS])
{
    int count = 0;
    for (int i = 0; i < overlay.count && count < BACKS; i++) {
        const struct overlay_rectangle *box = &overlay.rectangle[i];
        if (box->letter == 0 && box->width == 0.0f && box->colour.channel[0] == 10 &&
            box->colour.channel[3] == 192)
            back[count++] = box;
    }
    return count;
}

static void judge(const char *where)
{
    const struct overlay_rectangle *back[BACKS];
    int count = backs_of(back);
    const struct overlay_rectangle picture = {.right = (float)overlay.width / overlay.scale,
                                              .bottom = (float)overlay.height / overlay.scale};
    for (int i = 0; i < count; i++) {
        if (!inside(back[i], &picture))
            fail_msg("%s: panel %d is cut off", where, i);
        for (int k = 0; k < i; k++)
            if (meet(back[i], back[k]))
                fail_msg("%s: panels %d and %d overlap", where, k, i);
    }
    for (int i = 0; i < overlay.count; i++) {
        bool held = overlay.rectangle[i].letter == 0;
        for (int k = 0; k < count && !held; k++)
            held = inside(&overlay.rectangle[i], back[k]);
        if (!held)
            fail_msg("%s: the letter %c stands in no panel", where,
                     (char)overlay.rectangle[i].letter);
    }
}

// One picture of a chapter, with each keyboard's keys and without, with a ray and without.
static void try_picture(struct renderer *chapter, const char *name, const int size[2], float scale)
{
    static struct probe probe = {.steps = 40, .all_steps = 60, .recorded = true};
    struct panel_rows rows = {0};
    const struct parameters *all = &chapter->parameters;
    for (int way = 0; way < (BOARDS + 1) * 4; way++) {
        int board = way / 4 - 1;
        bool ray = way % 2 == 1, right = way / 2 % 2 == 1;
        char where[256];
        if (board >= 0)
            name_keys(board);
        struct panel panel = {.title = "21 A chapter with a name",
                              .renderer = chapter,
                              .chosen = all->count > 0 ? &all->item[all->count - 1] : NULL,
                              .rate = 123.0,
                              .milliseconds = 123.4,
                              .timed = true,
                              .time = 1234.5,
                              .paused = true,
                              .ranges = board >= 0,
                              .right = right,
                              .hint = "WWWW: keys, ranges    WWWW: hide",
                              .keys = keys,
                              .key_count = board >= 0 ? KEYS : 0,
                              .pixel = {ray ? size[0] / 2 : -1, size[1] / 2},
                              .probe = &probe,
                              .rows = &rows};
        panel_gather(&panel, &overlay, size[0], size[1], scale);
        snprintf(where, sizeof where, "%s, %s, %dx%d at %g, keyboard %d%s%s", name,
                 shader_view_name(chapter->view), size[0], size[1], (double)scale, board,
                 ray ? ", with a ray" : "", right ? ", at the right" : "");
        judge(where);
    }
    panel_rows_free(&rows);
}

static void no_panel_covers_another(void **unused)
{
    (void)unused;
    static const int sizes[][2] = {{320, 180},  {480, 270},   {640, 360},   {960, 540},
                                   {1280, 720}, {1920, 1080}, {3840, 2160}, {640, 1000}};
    static const float scales[] = {1.0f, 1.5f, 2.0f, 3.0f};
    char pattern[4200];
    glob_t found;
    snprintf(pattern, sizeof pattern, "%s/chapters/[0-9][0-9]_*.frag", gpu_project_root());
    assert_int_equal(glob(pattern, 0, NULL, &found), 0);
    assert_true(found.gl_pathc > 20);
    for (size_t c = 0; c < found.gl_pathc; c++) {
        struct shader_source source = {0};
        struct renderer chapter = {0};
        const char *path = found.gl_pathv[c];
        assert_true(shader_read(&source, path, gpu_project_root()) &&
                    parameters_read(&chapter.parameters, &source));
        for (int i = 0; i < 8 * 4 * (SHADER_PLOT + 1); i++) {
            const int *size = sizes[i % 8];
            float scale = scales[i / 8 % 4];
            chapter.view = (enum shader_view)(i / 32);
            if ((float)size[0] / scale >= 320.0f && (float)size[1] / scale >= 180.0f)
                try_picture(&chapter, strrchr(path, '/') + 1, size, scale);
        }
        parameters_free(&chapter.parameters);
        shader_free(&source);
    }
    globfree(&found);
}

// Two pictures: the divider at several places, labels of any length, an error above the keys, the
// panel folded to its title.
static void labels_of_two_pictures_cover_nothing(void **unused)
{
    (void)unused;
    static const int sizes[][2] = {{320, 180}, {640, 360}, {960, 540}, {1920, 1080}};
    static const double dividers[] = {0.0, 0.1, 0.5, 0.9, 1.0};
    static const char *const own[] = {"maxSteps=2"};
    struct shader_source source = {0};
    struct renderer chapter = {0}, other = {0};
    struct panel_rows rows = {0};
    static struct probe probe = {.steps = 40, .all_steps = 60, .recorded = true};
    char path[4200], where[128];
    snprintf(path, sizeof path, "%s/chapters/01_normal_colouring.frag", gpu_project_root());
    assert_true(shader_read(&source, path, gpu_project_root()) &&
                parameters_read(&chapter.parameters, &source) &&
                parameters_read(&other.parameters, &source));
    struct pair pair = {.other = &other, .own = own, .own_count = 1, .gripped = true};
    pair.label[0] = pair.label[1] = "a_file_with_a_name_that_is_rather_long.frag";
    chapter.pair = &pair;
    for (int way = 0; way < 4 * 5 * 2 * 2 * 2 * (SHADER_PLOT + 1); way++) {
        const int *size = sizes[way % 4];
        pair.divider = dividers[way / 4 % 5];
        bool ray = way / 20 % 2 == 1, error = way / 40 % 2 == 1, rolled = way / 80 % 2 == 1;
        chapter.view = (enum shader_view)(way / 160);
        struct panel panel = {.title = "01 A chapter with a name",
                              .renderer = &chapter,
                              .chosen = &other.parameters.item[2],
                              .rolled = rolled,
                              .error = error ? "a.frag:3: wrong\nb.frag:4: wrong too\n" : "",
                              .broken = true,
                              .pixel = {ray ? size[0] / 2 : -1, size[1] / 2},
                              .side = "right",
                              .shown = 38.0f,
                              .probe = &probe,
                              .rows = &rows};
        panel_gather(&panel, &overlay, size[0], size[1], 1.0f);
        snprintf(where, sizeof where, "%s, %dx%d, divider %g%s%s%s", shader_view_name(chapter.view),
                 size[0], size[1], pair.divider, ray ? ", a ray" : "", error ? ", an error" : "",
                 rolled ? ", the title" : "");
        judge(where);
    }
    panel_rows_free(&rows);
    parameters_free(&chapter.parameters);
    parameters_free(&other.parameters);
    shader_free(&source);
}

static int close_overlay(void **unused)
{
    (void)unused;
    overlay_close(&overlay);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(no_panel_covers_another),
                                       cmocka_unit_test(labels_of_two_pictures_cover_nothing)};
    return cmocka_run_group_tests_name("boxes", tests, NULL, close_overlay);
}
