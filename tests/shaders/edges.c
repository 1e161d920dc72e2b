// edges.c - the library at arguments where a formula could divide by zero: on this driver, each
// value is finite and right.
#include "lib/test.h"
#include "lib/gpu.h"

TEST(the_edges_of_every_formula_are_finite_and_right)
{
    static const float zero[4] = {0.0f};
    enum { ROOM = 512 };
    float *values = gpu_call("tests/shaders/edges.frag", ROOM, 1, 0, zero);
    int cases = (int)values[2], wrong = 0;
    assert_true(cases > 100 && cases <= ROOM);
    for (int i = 0; i < cases; i++) {
        double value = (double)values[4 * i], right = (double)values[4 * i + 1];
        bool good =
            right <= -1e9 ? isfinite(value) : fabs(value - right) <= 2e-3 * fmax(fabs(right), 0.1);
        if (!good)
            print_message(
                "# case %d of edges.frag is %.7g instead of %.7g (-1e+09: any finite value)\n", i,
                value, right);
        wrong += good ? 0 : 1;
    }
    free(values);
    print_message("# %d values at the edges of formulas\n", cases);
    assert_int_equal(wrong, 0);
}

TESTS(gpu_setup, gpu_teardown)
