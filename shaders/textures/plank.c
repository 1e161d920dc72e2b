// plank.c - four weathered oak boards, with the grain along u and gaps between them.
//
// Each board is cut from a different log. Its rings are lines of equal distance from the log's
// axis, which is inclined to the cut, so that the board shows long pointed arches.
#include "paint.h"

#include <math.h>

enum { BOARDS = 4 };

// The number of rings between the log's axis and a point of a board.
//   x  along the board from its end, 0 to 1
//   y  across the board, 0 to 1
static double rings_at(double x, double y, int board)
{
    uint32_t seed = 100 * (uint32_t)(board + 1);
    double chance[4];
    for (int i = 0; i < 4; i++)
        chance[i] = paint_random(board, i, 14);
    double along = chance[0] < 0.5 ? x : 1.0 - x; // grows towards the root
    double bend = paint_octaves(x, 0.25 * y, 3, 8, 2, seed) - 0.5;
    double deep = 0.05 + 0.22 * chance[1] + (0.16 + 0.20 * chance[2]) * along + 0.10 * bend;
    double from = y - 0.5 - 0.7 * (chance[3] - 0.5) + 0.06 * bend;
    double ripple = paint_noise(x, 0.25 * y, 14, 64, seed + 9) - 0.5;
    return 21.0 * sqrt(from * from + deep * deep) + 0.35 * ripple;
}

static void plank(double u, double v, double value[3])
{
    static const uint32_t oak[5] = {0x452d20, 0x75513b, 0xa27a5b, 0xc19c78, 0xdabd9d};
    double across = v * BOARDS;
    int board = (int)floor(across);
    double y = across - board;
    double shift = u + 0.37 * board + 0.21 * (board % 2) + 0.1, x = shift - floor(shift);
    double ring = rings_at(x, y, board), t = ring - floor(ring);
    uint32_t seed = 10 * (uint32_t)board;
    // Late wood darkens slowly and ends abruptly; no two years are alike.
    double year = paint_random((int)floor(ring), board, 8);
    double late = paint_step(0.15, 0.85, t) * (1.0 - paint_step(0.88, 1.0, t)) * (0.5 + 0.7 * year);
    double fibre = paint_octaves(u, v, 10, 256, 2, 50) - 0.5;
    double vessel = paint_step(0.66, 0.90, paint_noise(u, v, 26, 512, 61)) * (1.0 - 0.8 * late);
    double stain = paint_octaves(x, y * 0.25, 2, 6, 3, 70 + seed) - 0.5;
    double tone = 0.70 - 0.30 * late + 0.30 * fibre - 0.26 * vessel + 0.30 * stain +
                  0.24 * (paint_random(board, 4, 7) - 0.5);
    paint_scale(5, oak, tone, value);
    // Darken the gap and the rounded edges of the boards.
    double side = 0.5 - fabs(y - 0.5), end = BOARDS * (0.5 - fabs(x - 0.5));
    double near = fmin(side, end);
    double light = (0.08 + 0.92 * paint_step(0.004, 0.014, near)) *
                   (0.78 + 0.22 * paint_step(0.0, 0.05, near));
    for (int c = 0; c < 3; c++)
        value[c] *= light;
}

int main(void)
{
    return paint_texture(512, 512, 2, PAINT_COLOUR, plank);
}
