#include "picture/signs.h"

#include <math.h>
#include <stdlib.h>

#include "memory.h"
#include "picture/letters.h"

// In cells.
#define DIGIT 5 // its height
#define WIDE  4 // room of a digit and of the minus
#define POINT 2 // room of the point

// What stands alone in its room: digits, the point, a minus; then the words, a row each.
static const uint32_t single[] = {'0', '1', '2', '3', '4', '5', '6', '7', '8', '9', '.', 0x2013};
static const char *const words[SIGNS_ROWS - 1] = {"t",   "distance", "threshold",
                                                  "hit", "miss",     "given up"};

enum { SINGLE = sizeof single / sizeof *single };

// Copy a letter's image.
//   pixel  the table, the bottom row first, SIGNS_WIDTH * cell pixels wide
//   pen    where the letter begins, pixels from the left
//   line   row of pixels on which it stands
static void draw(unsigned char *pixel, int cell, struct letters *letters, uint32_t code, float pen,
                 int line)
{
    int begin = (int)floorf(LETTERS_PHASES * pen + 0.5f), phase = begin & (LETTERS_PHASES - 1);
    const struct letter *letter = letters_find(letters, code, phase);
    int left = (begin - phase) / LETTERS_PHASES + letter->left, row = SIGNS_WIDTH * cell;
    for (int y = 0; y < letter->height; y++)
        for (int x = 0; x < letter->width; x++) {
            unsigned char *at = pixel + (line - 1 - letter->top - y) * row + left + x;
            unsigned char cover = letters->pixel[(letter->y + y) * LETTERS_ROW + letter->x + x];
            if (left + x >= 0 && left + x < row && *at < cover)
                *at = cover;
        }
}

unsigned char *signs_draw(int cell)
{
    struct letters letters = {0};
    unsigned char *pixel =
        memory_zeros((size_t)(SIGNS_WIDTH * cell), (size_t)(SIGNS_ROWS * SIGNS_ROW * cell));
    const float capital = 7.3f; // units, see LETTERS_EM
    float scale = (float)(DIGIT * cell) / capital;
    letters_begin(&letters, scale);
    for (int i = 0; i < SINGLE; i++) {
        float room = (float)((single[i] == '.' ? POINT : WIDE) * cell);
        float pen = (float)(WIDE * i * cell) + 0.5f * (room - scale * letters_advance(single[i]));
        draw(pixel, cell, &letters, single[i], pen, SIGNS_LINE * cell);
    }
    for (int row = 1; row < SIGNS_ROWS; row++) {
        float pen = 0.0f;
        for (const char *at = words[row - 1]; *at != '\0';) {
            uint32_t code = letters_next(&at);
            draw(pixel, cell, &letters, code, pen, (SIGNS_ROW * row + SIGNS_LINE) * cell);
            pen += scale * letters_advance(code);
        }
    }
    letters_close(&letters);
    return pixel;
}

void signs_bind(struct signs *signs, const struct gl *gl, int height)
{
    int cell = height < 180 ? 1 : height / 180;
    if (signs->texture == 0)
        gl->GenTextures(1, &signs->texture);
    gl->BindTexture(GL_TEXTURE_2D, signs->texture);
    if (signs->cell == cell)
        return;
    unsigned char *pixel = signs_draw(cell);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_R8, SIGNS_WIDTH * cell, SIGNS_ROWS * SIGNS_ROW * cell, 0,
                   GL_RED, GL_UNSIGNED_BYTE, pixel);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    signs->cell = cell;
    free(pixel);
}

void signs_free(struct signs *signs, const struct gl *gl)
{
    if (signs->texture != 0)
        gl->DeleteTextures(1, &signs->texture);
    *signs = (struct signs){0};
}
