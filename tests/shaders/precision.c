// precision.c - the precision of the driver's built-in functions. The test prints the errors and
// accepts all of them, because GLSL 3.30 guarantees nothing, and the weakest documented bounds,
// those of Vulkan, are wide.
#include "lib/test.h"
#include "lib/gpu.h"

static double inverse_root(double x)
{
    return 1.0 / sqrt(x);
}

static double power(double x)
{
    return pow(x, 2.4);
}

TEST(the_built_in_functions_are_measured)
{
    static const struct {
        const char *name;
        double (*exact)(double);
        bool relative; // true if Vulkan bounds the relative error
    } functions[] = {{"sin", sin, false},
                     {"cos", cos, false},
                     {"tan", tan, false},
                     {"asin", asin, false},
                     {"acos", acos, false},
                     {"atan", atan, false},
                     {"exp", exp, true},
                     {"log", log, false},
                     {"pow", power, true},
                     {"sqrt", sqrt, true},
                     {"inversesqrt", inverse_root, true}};
    for (int f = 0; f < (int)(sizeof functions / sizeof *functions); f++) {
        static const float none[4] = {0.0f};
        float *values = gpu_call("tests/shaders/precision.frag", 1024, 4, f, none);
        double worst = 0.0, at = 0.0;
        for (int i = 0; i < 4096; i++) {
            double x = (double)values[4 * i], right = functions[f].exact(x);
            double off = fabs((double)values[4 * i + 1] - right);
            off /= functions[f].relative && right != 0.0 ? fabs(right) : 1.0;
            at = off > worst ? x : at;
            worst = fmax(worst, off);
        }
        free(values);
        print_message("# %s: worst %s error %.2g, at %.4g\n", functions[f].name,
                      functions[f].relative ? "relative" : "absolute", worst, at);
    }
}

TESTS(gpu_setup, gpu_teardown)
