#include "picture/letters.h"

#include <stdlib.h>
#include <string.h>

#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>

#include "memory.h"
#include "report.h"

struct letters_known {
    uint32_t code;
    int phase;
    struct letter letter;
};

static const stbtt_fontinfo *font(void)
{
    static stbtt_fontinfo info;
    if (info.data == NULL)
        stbtt_InitFont(&info, letters_font, 0);
    return &info;
}

uint32_t letters_next(const char **text)
{
    uint32_t code = report_next(text, "\t");
    return code == '\t' ? ' ' : code;
}

float letters_advance(uint32_t code)
{
    static float known[128]; // advances of the ASCII characters, which are the most common
    int advance, bearing;
    if (code < 128 && known[code] > 0.0f)
        return known[code];
    stbtt_GetCodepointHMetrics(font(), (int)code, &advance, &bearing);
    float units = stbtt_ScaleForMappingEmToPixels(font(), LETTERS_EM) * (float)advance;
    if (code < 128)
        known[code] = units;
    return units;
}

void letters_begin(struct letters *letters, float scale)
{
    if (letters->scale == scale)
        return;
    letters->count = 0;
    letters->right = letters->top = letters->bottom = 0;
    letters->scale = scale;
}

// Find room for an image, with an empty pixel to the right of it and below it.
static void place(struct letters *letters, struct letter *letter)
{
    enum { MORE_ROWS = 128 };
    if (letters->right + letter->width + 1 > LETTERS_ROW) {
        letters->right = 0;
        letters->top = letters->bottom;
    }
    letter->x = letters->right;
    letter->y = letters->top;
    letters->right += letter->width + 1;
    if (letters->bottom < letter->y + letter->height + 1)
        letters->bottom = letter->y + letter->height + 1;
    if (letters->bottom > letters->rows) {
        unsigned char *before = letters->pixel;
        letters->pixel = memory_zeros((size_t)(letters->bottom + MORE_ROWS), LETTERS_ROW);
        if (before != NULL)
            memcpy(letters->pixel, before, (size_t)letters->rows * LETTERS_ROW);
        letters->rows = letters->bottom + MORE_ROWS;
        free(before);
    }
}

const struct letter *letters_find(struct letters *letters, uint32_t code, int phase)
{
    for (int i = 0; i < letters->count; i++)
        if (letters->known[i].code == code && letters->known[i].phase == phase)
            return &letters->known[i].letter;
    float size = stbtt_ScaleForMappingEmToPixels(font(), LETTERS_EM * letters->scale);
    float shift = (float)phase / LETTERS_PHASES;
    struct letters_known new = {.code = code, .phase = phase};
    struct letter *letter = &new.letter;
    int right, bottom;
    stbtt_GetCodepointBitmapBoxSubpixel(font(), (int)code, size, size, shift, 0.0f, &letter->left,
                                        &letter->top, &right, &bottom);
    letter->width = right - letter->left;
    letter->height = bottom - letter->top;
    place(letters, letter);
    stbtt_MakeCodepointBitmapSubpixel(
        font(), letters->pixel + (size_t)letter->y * LETTERS_ROW + letter->x, letter->width,
        letter->height, LETTERS_ROW, size, size, shift, 0.0f, (int)code);
    letters->known = memory_row(letters->known, letters->count, sizeof *letters->known);
    letters->known[letters->count] = new;
    letters->grown = true;
    return &letters->known[letters->count++].letter;
}

void letters_close(struct letters *letters)
{
    free(letters->pixel);
    free(letters->known);
    *letters = (struct letters){0};
}
