#include "picture/axis_labels.h"

#include <math.h>
#include <stdlib.h>

#include "memory.h"
#include "picture/letters.h"
#include "picture/target.h"

// Sizes in cells. The baseline of a row's letters is LINE cells above the row's lower edge.
enum { WIDTH = 48, ROW = 8, LINE = 2, DIGIT_WIDTH = 4, POINT_WIDTH = 2 };

// Row 0 of the table contains the digits, the decimal point and the minus sign, each centred in its
// cells; every other row contains a word.
static const uint32_t single[] = {'0', '1', '2', '3', '4', '5', '6', '7', '8', '9', '.', 0x2013};
static const char *const words[] = {"t", "distance", "threshold", "hit", "miss", "given up"};

enum { SINGLE = sizeof single / sizeof *single, ROWS = 1 + sizeof words / sizeof *words };

// Copy a letter's image into the table.
//   pixel  the table, WIDTH * cell pixels wide, bottom row first
//   pen    the letter's horizontal position, in pixels from the left
//   line   the row of pixels just above the letter's baseline
static void draw(unsigned char *pixel, int cell, struct letters *letters, uint32_t code, float pen,
                 int line)
{
    int begin = (int)floorf(LETTERS_PHASES * pen + 0.5f), phase = begin & (LETTERS_PHASES - 1);
    const struct letter *letter = letters_find(letters, code, phase);
    int left = (begin - phase) / LETTERS_PHASES + letter->left, row = WIDTH * cell;
    for (int y = 0; y < letter->height; y++)
        for (int x = 0; x < letter->width; x++) {
            unsigned char *at = pixel + (line - 1 - letter->top - y) * row + left + x;
            unsigned char cover = letters->pixel[(letter->y + y) * LETTERS_ROW + letter->x + x];
            if (left + x >= 0 && left + x < row && *at < cover)
                *at = cover;
        }
}

// Draw the table. Each byte is 255 times the covered fraction of a pixel. The bottom row is first.
// Returns WIDTH * cell by ROWS * ROW * cell bytes, which the caller frees.
static unsigned char *draw_table(int cell)
{
    struct letters letters = {0};
    unsigned char *pixel = memory_zeros((size_t)(WIDTH * cell), (size_t)(ROWS * ROW * cell));
    const float capital = 7.3f; // height of a digit, units; see LETTERS_EM
    float scale = (float)(AXIS_LABELS_DIGIT * cell) / capital;
    letters_begin(&letters, scale);
    for (int i = 0; i < SINGLE; i++) {
        float room = (float)((single[i] == '.' ? POINT_WIDTH : DIGIT_WIDTH) * cell);
        float pen =
            (float)(DIGIT_WIDTH * i * cell) + 0.5f * (room - scale * letters_advance(single[i]));
        draw(pixel, cell, &letters, single[i], pen, LINE * cell);
    }
    for (int row = 1; row < ROWS; row++) {
        float pen = 0.0f;
        for (const char *at = words[row - 1]; *at != '\0';) {
            uint32_t code = letters_next(&at);
            draw(pixel, cell, &letters, code, pen, (ROW * row + LINE) * cell);
            pen += scale * letters_advance(code);
        }
    }
    letters_close(&letters);
    return pixel;
}

void axis_labels_bind(struct axis_labels *labels, const struct gl *gl, int cell)
{
    if (labels->texture == 0)
        gl->GenTextures(1, &labels->texture);
    gl->BindTexture(GL_TEXTURE_2D, labels->texture);
    if (labels->cell == cell)
        return;
    unsigned char *pixel = draw_table(cell);
    target_upload(gl, WIDTH * cell, ROWS * ROW * cell, pixel);
    labels->cell = cell;
    free(pixel);
}

void axis_labels_free(struct axis_labels *labels, const struct gl *gl)
{
    gl->DeleteTextures(1, &labels->texture);
    *labels = (struct axis_labels){0};
}
