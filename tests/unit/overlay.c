// overlay.c - tests that boxes, texts and panels over a picture have the right position and size,
// and change nothing outside themselves.
#include "lib/test.h"
#include "picture/overlay.h"
#include "picture/panel.h"
#include "lib/gpu.h"

enum { WIDTH = 400, HEIGHT = 240 };

static struct overlay overlay;
static const struct overlay_colour WHITE = {{255, 255, 255, 255}};

static struct image picture_of(const struct overlay *over)
{
    struct renderer_inputs inputs = {.width = WIDTH,
                                     .height = HEIGHT,
                                     .camera = {.position = {0, 0, 4}},
                                     .samples = 1,
                                     .pixel = {-1, -1}};
    struct image image = {0};
    gpu.renderer.overlay = over;
    assert_true(renderer_picture(&gpu.renderer, &inputs, &image));
    gpu.renderer.overlay = NULL;
    return image;
}

// Compare two pictures, and return the number of pixels that differ.
//   box  receives the smallest box of pixels that contains all differences: left, top, right and
//        bottom, where right and bottom are just outside the box
static int changes(const struct image *a, const struct image *b, int box[4])
{
    int count = 0;
    memcpy(box, (int[4]){WIDTH, HEIGHT, 0, 0}, 4 * sizeof *box);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            size_t at = 3 * ((size_t)y * WIDTH + (size_t)x);
            if (memcmp(a->pixel + at, b->pixel + at, 3) == 0)
                continue;
            count++;
            box[0] = x < box[0] ? x : box[0];
            box[1] = y < box[1] ? y : box[1];
            box[2] = x + 1 > box[2] ? x + 1 : box[2];
            box[3] = y + 1 > box[3] ? y + 1 : box[3];
        }
    return count;
}

// Draw the overlay over the picture, and return the number of pixels that it changes.
//   box  as for changes
static int drawn(int box[4])
{
    struct image without = picture_of(NULL), with = picture_of(&overlay);
    int count = changes(&without, &with, box);
    image_free(&without);
    image_free(&with);
    return count;
}

TEST(a_box_covers_its_pixels)
{
    int box[4];
    overlay_begin(&overlay, WIDTH, HEIGHT, 1.0f);
    overlay_box(&overlay, 10, 20, 30, 5, WHITE);
    assert_int_equal(drawn(box), 30 * 5);
    assert_memory_equal(box, ((int[4]){10, 20, 40, 25}), sizeof box);
    overlay_begin(&overlay, WIDTH, HEIGHT, 2.0f);
    overlay_box(&overlay, 10, 20, 30, 5, WHITE);
    assert_int_equal(drawn(box), 60 * 10);
    assert_memory_equal(box, ((int[4]){20, 40, 80, 50}), sizeof box);
    overlay_begin(&overlay, WIDTH, HEIGHT, 1.0f);
    assert_int_equal(drawn(box), 0);
}

// A white box that covers half of a pixel changes the pixel's value p to p + (255 - p) / 2.
TEST(an_edge_inside_a_pixel_covers_its_share)
{
    overlay_begin(&overlay, WIDTH, HEIGHT, 0.5f);
    overlay_box(&overlay, 101, 60, 1, 2, WHITE); // x 50.5 to 51, y 30 to 31
    struct image without = picture_of(NULL), with = picture_of(&overlay);
    size_t at = 3 * (30 * (size_t)WIDTH + 50);
    for (size_t k = at; k < at + 3; k++) {
        double half = without.pixel[k] + (255 - without.pixel[k]) / 2.0;
        // The values of both pictures are rounded.
        assert_true(fabs(with.pixel[k] - half) <= 1.0);
    }
    image_free(&without);
    image_free(&with);
}

TEST(text_has_the_right_position_and_size)
{
    int one[4], two[4];
    overlay_begin(&overlay, WIDTH, HEIGHT, 1.0f);
    overlay_text(&overlay, 40, 30, "march gives", WHITE);
    assert_true(drawn(one) > 100);
    assert_true(one[0] >= 40 && one[0] <= 42 && one[1] >= 30);
    assert_true(one[2] <= 40 + (int)overlay_width("march gives"));
    assert_true(one[3] <= 30 + (int)OVERLAY_LINE);
    overlay_begin(&overlay, WIDTH, HEIGHT, 2.0f);
    overlay_text(&overlay, 40, 30, "march gives", WHITE);
    drawn(two);
    // At the second scale the letters are drawn again rather than enlarged, so an edge may be up to
    // two pixels from twice its old position.
    for (int i = 0; i < 4; i++)
        assert_true(abs(two[i] - 2 * one[i]) <= 2);
}

// An L has its long stroke on the left and its bar at the bottom.
TEST(a_letter_is_upright)
{
    int box[4], upper[4];
    overlay_begin(&overlay, WIDTH, HEIGHT, 4.0f);
    overlay_text(&overlay, 10, 10, "L", WHITE);
    drawn(box);
    // Only the upper half counts: in the lower half, the two pictures are made equal.
    struct image without = picture_of(NULL), with = picture_of(&overlay);
    size_t half = 3 * (size_t)WIDTH * (size_t)((box[1] + box[3]) / 2);
    memcpy(with.pixel + half, without.pixel + half, 3 * (size_t)WIDTH * HEIGHT - half);
    changes(&without, &with, upper);
    assert_true(upper[0] == box[0] && upper[2] - upper[0] < (box[2] - box[0]) / 2);
    image_free(&without);
    image_free(&with);
}

TEST(any_text_can_be_drawn)
{
    char text[3000];
    memset(text, '@', sizeof text - 1);
    text[sizeof text - 1] = '\0';
    overlay_begin(&overlay, WIDTH, HEIGHT, 1.0f);
    overlay_text(&overlay, 0, 0, text, WHITE);
    overlay_text(&overlay, 0, 20, "", WHITE);
    int before = overlay.count;
    // The text consists of the letter é, a space, two control characters, and a byte that is not
    // UTF-8.
    overlay_text(&overlay, 0, 40, "\xc3\xa9 \n\x01\xff", WHITE);
    static const uint32_t signs[] = {0xE9, 0xFFFD, 0xFFFD, 0xFFFD};
    assert_int_equal(overlay.count - before, 4);
    for (int i = 0; i < 4; i++)
        assert_int_equal(overlay.rectangle[before + i].letter, signs[i]);
    drawn((int[4]){0});
    assert_true(overlay_width(text) <= OVERLAY_TEXT * 10.0f);
}

// A frame that is drawn after other frames looks the same as if it were the first, even if parts
// are new, missing, moved or recoloured, or the scale has changed.
TEST(a_frame_after_another_is_the_same)
{
    static const struct overlay_colour other = {{200, 40, 90, 120}};
    struct overlay fresh = {0};
    for (int i = 0; i < 8; i++) {
        struct overlay *drawn_by[] = {&overlay, &fresh};
        struct image picture[2];
        int box[4];
        assert_true(overlay_open(&fresh, &gpu.context.gl));
        for (int k = 0; k < 2; k++) {
            overlay_begin(drawn_by[k], WIDTH, HEIGHT, i < 5 ? 1.5f : 1.0f);
            overlay_box(drawn_by[k], 20, 20, 90, i < 2 ? 60 : 50, i % 2 == 0 ? WHITE : other);
            overlay_text(drawn_by[k], i < 4 ? 30.0f : 31.0f, 40, i < 3 ? "time 1" : "time 2",
                         other);
            if (i != 6)
                overlay_line(drawn_by[k], (float[]){150, 20}, (float[]){220, 130}, 3, WHITE);
            picture[k] = picture_of(drawn_by[k]);
        }
        assert_int_equal(changes(&picture[0], &picture[1], box), 0);
        image_free(&picture[0]);
        image_free(&picture[1]);
        overlay_close(&fresh);
    }
}

TEST(the_scale_follows_the_height)
{
    static const struct {
        int height;
        float scale;
    } wanted[] = {{1, 1.0f}, {360, 1.0f}, {540, 1.5f}, {720, 2.0f}, {1080, 3.0f}, {99999, 8.0f}};
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++) {
        float scale = overlay_scale_of(wanted[i].height);
        if (scale != wanted[i].scale)
            fail_msg("height %d: scale %g", wanted[i].height, (double)scale);
    }
}

// The pixels that a picture's panel changes are bounded by the panel's background, which is a box.
TEST(a_panel_changes_only_itself)
{
    int box[4];
    struct panel panel = {.title = "A title", .renderer = &gpu.renderer, .pixel = {-1, -1}};
    panel_gather(&panel, &overlay, WIDTH, HEIGHT, 1.0f);
    const struct overlay_rectangle *back = &overlay.rectangle[0];
    drawn(box);
    assert_int_equal(box[0], (int)back->left);
    assert_int_equal(box[1], (int)back->top);
    assert_int_equal(box[2], (int)back->right);
    assert_int_equal(box[3], (int)back->bottom);
    assert_true(box[2] < WIDTH && box[3] < HEIGHT);
    panel.folded = true;
    panel_gather(&panel, &overlay, WIDTH, HEIGHT, 1.0f);
    assert_int_equal(drawn(box), 0);
}

static int set_up(void **unused)
{
    (void)unused;
    return gpu_open() && gpu_load("chapters/01_normal_colouring.frag") &&
                   overlay_open(&overlay, &gpu.context.gl)
               ? 0
               : -1;
}

static int tear_down(void **unused)
{
    (void)unused;
    overlay_close(&overlay);
    overlay_close(&overlay);
    gpu_close();
    return 0;
}

TESTS(set_up, tear_down)
