// limits.c - marches in 32-bit floats far from the origin, compared with the bounds of proof 5 of
// docs/16_fewer_steps.md.
#include "lib/test.h"
#include "lib/limits.h"

static const double positions[] = {1.0, 10.0, 100.0, 1000.0, 10000.0, 100000.0};
enum { POSITIONS = sizeof positions / sizeof *positions };

// No error exceeds the proved bound, and a fifth of the bound would be too little.
TEST(a_distance_errs_by_no_more_than_is_proved)
{
    for (int sheet = 0; sheet < LIMITS_SHEETS; sheet++)
        for (int i = 0; i < POSITIONS; i++) {
            struct limits_sums sums = limits_of(sheet, positions[i], 1.0);
            print_message("# sheet %d at %g: error %.2g, %.2f of the bound\n", sheet, positions[i],
                          sums.absolute, sums.error);
            assert_true(sums.error <= 1.0 && sums.error > 0.2);
        }
}

TEST(no_sheet_is_passed_with_the_proved_threshold)
{
    for (int sheet = 0; sheet < LIMITS_SHEETS; sheet++)
        for (int i = 0; i < POSITIONS; i++) {
            struct limits_sums sums = limits_of(sheet, positions[i], 1.0);
            assert_true(sums.rays > 1000);
            assert_int_equal(sums.passed, 0);
        }
}

// The proved threshold is not far too large: with a sixteenth of it, more than a quarter of the
// rays pass through the sheet if its middle is at x = 100 or farther away.
TEST(sheets_are_passed_with_a_sixteenth_of_the_threshold)
{
    for (int sheet = 0; sheet < LIMITS_SHEETS; sheet++)
        for (int i = 2; i < POSITIONS; i++) {
            struct limits_sums sums = limits_of(sheet, positions[i], 1.0 / 16.0);
            print_message("# sheet %d at %g: %d of %d rays pass through\n", sheet, positions[i],
                          sums.passed, sums.rays);
            assert_true(sums.passed > sums.rays / 4);
        }
}

TESTS(gpu_setup, gpu_teardown)
