// test_checkers.c - squares averaged over what a pixel sees of them, against 64 x 64 samples in
// double precision, in perspective, by parallel rays and between the two.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "support_checkers.h"

// 4096 samples along each axis are off by 1 / 4096 for each edge of a square, and edges add up to
// less than
// 2. Of 64 the same says 1 / 64: such a grid is no truth to 1 / 255, but its mean error is.
static const int fine = 4096, coarse = 64;

static void check_view(const struct checkers_view *view)
{
    double *share = checkers_shown(view, 1);
    assert_non_null(share);
    double worst = 0.0, squares = 0.0, grid = 0.0;
    int count = 0;
    for (int y = 1; y < CHECKERS_HEIGHT; y += 5)
        for (int x = 2; x < CHECKERS_WIDTH; x += 11) {
            double low[2], high[2], got = share[y * CHECKERS_WIDTH + x];
            if (checkers_hidden(view, x, y) || !checkers_rectangle(view, x, y, low, high))
                continue;
            double truth = checkers_of_rectangle(low, high, fine);
            double rough = checkers_of_rectangle(low, high, coarse);
            worst = fmax(worst, fabs(got - truth));
            squares += (got - rough) * (got - rough);
            grid = fmax(grid, fabs(truth - rough));
            count++;
        }
    free(share);
    print_message(
        "# orthographic %.1f: %d pixels; of 255: off the fine grid by at most %.3f, off 64 x 64 by "
        "%.3f in the mean; that grid itself by at most %.2f\n",
        view->orthographic, count, 255.0 * worst, 255.0 * sqrt(squares / count), 255.0 * grid);
    assert_true(count > 1500);
    assert_true(worst <= 0.2 / 255.0);
    assert_true(sqrt(squares / count) <= 1.0 / 255.0);
}

static void test_against_samples(void **unused)
{
    (void)unused;
    for (int i = 0; i < 3; i++)
        check_view(&checkers_views[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_against_samples),
    };
    return cmocka_run_group_tests_name("checkers", tests, gpu_setup, gpu_teardown);
}
