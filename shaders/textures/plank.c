// plank.c - four oak boards, the grain along u, with gaps between them.
//
// Each board is cut from a log of its own: its rings are the distance from the log's axis, which
// leans against the cut, so that the board shows long pointed arches.
#include "paint.h"

#include <math.h>

enum { BOARDS = 4 };

// One board at a point.
//   x  along it from its end, 0 to 1
//   y  across it from its middle, -0.5 to 0.5, in boards
static double rings_at(double x, double y, int board)
{
    uint32_t seed = 100 * (uint32_t)(board + 1);
    double wander = paint_octaves(x, 0.25 * y, 3, 4, 3, seed) - 0.5;
    double middle = 0.9 * (paint_random(board, 1, 7) - 0.5);
    double lean = paint_random(board, 2, 7) < 0.5 ? x : 1.0 - x;
    double depth = 0.05 + 0.9 * lean * (0.4 + 0.6 * paint_random(board, 3, 7)) + 0.25 * wander;
    double from = y - middle + 0.10 * wander;
    double radius = sqrt(from * from + depth * depth);
    return 11.0 * radius + 0.5 * paint_noise(x, 0.25 * y, 6, 24, seed + 9);
}

static void plank(double u, double v, double value[3])
{
    static const uint32_t oak[4] = {0x6d4524, 0x9a6a3c, 0xc08d58, 0xdab383};
    double across = v * BOARDS;
    int board = (int)floor(across);
    double y = across - board - 0.5;
    double shift = u + 0.37 * board + 0.21 * (board % 2) + 0.1, x = shift - floor(shift);
    double ring = rings_at(x, y, board), t = ring - floor(ring);
    uint32_t seed = 10 * (uint32_t)board;
    // Late wood darkens slowly and ends at once.
    double late = paint_step(0.25, 0.92, t) * (1.0 - paint_step(0.92, 1.0, t));
    double fibre = paint_octaves(u, v, 8, 128, 2, 50) - 0.5;
    double pore = paint_step(0.72, 0.9, paint_noise(u, v, 48, 256, 61)) * (1.0 - 0.7 * late);
    double broad = paint_octaves(x, y * 0.25, 3, 8, 3, 70 + seed) - 0.5;
    double tone = 0.72 - 0.42 * late + 0.34 * fibre - 0.30 * pore + 0.25 * broad +
                  0.22 * (paint_random(board, 4, 7) - 0.5);
    paint_scale(4, oak, tone, value);
    // The gap, and the edges that it rounds.
    double side = 0.5 - fabs(y), end = BOARDS * (0.5 - fabs(x - 0.5));
    double gap = paint_step(0.006, 0.035, fmin(side, end));
    for (int c = 0; c < 3; c++)
        value[c] *= 0.06 + 0.94 * gap;
}

int main(void)
{
    return paint_texture(512, 512, 2, PAINT_COLOUR, plank);
}
