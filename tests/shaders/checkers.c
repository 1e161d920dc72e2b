// checkers.c - squares averaged over the part of the plane that a pixel sees, compared with samples
// in double precision: in perspective, with parallel rays, and halfway between the two.
#include "lib/test.h"
#include "lib/checkers.h"

// With samples at the centres of a grid's cells, each edge of a square contributes an error of up
// to half a cell. With 64 cells per side, that is about 2 / 255 for each edge, so such a grid is
// not accurate to 1 / 255. With 4096 per side it is. So are 64 x 64 samples with no common rows or
// columns if the pixel sees at most a hundred squares; in the last rows below the horizon, a pixel
// sees thousands.
static const int fine = 4096, coarse = 64;
static const double few = 100.0;

static void check_view(const struct checkers_view *view)
{
    double *share = checkers_shown(view, 1);
    assert_non_null(share);
    double worst = 0.0, off = 0.0, grid = 0.0;
    int count = 0, near = 0;
    for (int y = 1; y < CHECKERS_HEIGHT; y += 5)
        for (int x = 2; x < CHECKERS_WIDTH; x += 11) {
            double low[2], high[2], got = share[y * CHECKERS_WIDTH + x];
            if (checkers_hidden(view, x, y) || !checkers_rectangle(view, x, y, low, high))
                continue;
            double truth = checkers_of_grid(low, high, fine);
            count++;
            worst = fmax(worst, fabs(got - truth));
            if ((high[0] - low[0]) * (high[1] - low[1]) > few)
                continue;
            near++;
            off = fmax(off, fabs(got - checkers_of_samples(low, high)));
            grid = fmax(grid, fabs(got - checkers_of_grid(low, high, coarse)));
        }
    free(share);
    print_message(
        "# orthographic %.1f: %d pixels differ from the fine grid by at most %.3f / 255; the %d "
        "with at most 100 squares differ from 64 x 64 samples by at most %.3f / 255, and from a "
        "64 x 64 grid by at most %.2f / 255\n",
        view->orthographic, count, 255.0 * worst, near, 255.0 * off, 255.0 * grid);
    assert_true(count > 1500 && near > 0.9 * count);
    assert_true(worst <= 0.2 / 255.0);
    assert_true(off <= 1.0 / 255.0);
}

TEST(test_checkers_agree_with_samples)
{
    for (int i = 0; i < 3; i++)
        check_view(&checkers_views[i]);
}

TESTS(gpu_setup, gpu_teardown)
