// root.c - chapters/experiments/23_exact_root.frag: the first root of the interpolation along a
// ray, compared with samples in double precision, and the points at which the march ends.
#include "lib/test.h"

#include "lib/chapter.h"

enum { COUNT = CHAPTER_WIDTH * CHAPTER_HEIGHT, CELLS = 40000, SAMPLES = 1500 };

static const char *const experiment = "#include \"main.glsl\"\n"
                                      "#define rayColour chapterColour\n"
                                      "#include \"experiments/23_exact_root.frag\"\n"
                                      "#undef rayColour\n";

// ---- One cell ----

// The next random number in [-1, 1), the same in C and in the shader.
static double next(uint32_t *seed)
{
    *seed = *seed * 747796405u + 2891336453u;
    uint32_t word = ((*seed >> ((*seed >> 28) + 4u)) ^ *seed) * 277803737u;
    word = (word >> 22) ^ word;
    return ((int)(word >> 8) - 8388608) / 8388608.0;
}

static const char *const one_cell =
    "uint seed;\n"
    "float next() {\n"
    "    seed = seed * 747796405u + 2891336453u;\n"
    "    uint word = ((seed >> ((seed >> 28) + 4u)) ^ seed) * 277803737u;\n"
    "    return float(int(((word >> 22) ^ word) >> 8) - 8388608) / 8388608.0;\n"
    "}\n"
    "vec3 rayColour(Ray ray) {\n"
    "    seed = uint(iPixel.x + 640 * iPixel.y);\n"
    "    float v[14];\n"
    "    for (int k = 0; k < 14; k++) v[k] = next();\n"
    "    StoredCell cell = StoredCell(vec4(v[0], v[1], v[2], v[3]), vec4(v[4], v[5], v[6], v[7]),\n"
    "                                 0.5 + 0.5 * vec3(v[8], v[9], v[10]));\n"
    "    vec3 along = normalize(vec3(v[11], v[12], v[13]));\n"
    "    float turned = trilinear(cell) < 0.0 ? -1.0 : 1.0;\n"
    "    cell.near *= turned, cell.far *= turned;\n"
    "    float last = cellExit(cell.share, along);\n"
    "    float root = firstRoot(cubicAlong(cell, along), last);\n"
    "    return vec3(0.5 + 0.25 * root, 0.25 * last, 0.0);\n"
    "}\n";

// The values at the corners of a cell, and a ray from a point in the cell.
struct cell {
    double value[8], from[3], along[3];
};

// The interpolation at a distance t along the ray: a sum over the eight corners.
static double value_along(const struct cell *c, double t)
{
    double sum = 0.0;
    for (int k = 0; k < 8; k++) {
        double weight = 1.0;
        for (int a = 0; a < 3; a++) {
            double share = c->from[a] + t * c->along[a];
            weight *= (k >> a & 1) == 1 ? share : 1.0 - share;
        }
        sum += weight * c->value[k];
    }
    return sum;
}

static struct cell random_cell(int n)
{
    uint32_t seed = (uint32_t)n;
    struct cell c;
    for (int k = 0; k < 8; k++)
        c.value[k] = next(&seed);
    for (int a = 0; a < 3; a++)
        c.from[a] = 0.5 + 0.5 * next(&seed);
    for (int a = 0; a < 3; a++)
        c.along[a] = next(&seed);
    double size = sqrt(c.along[0] * c.along[0] + c.along[1] * c.along[1] + c.along[2] * c.along[2]);
    for (int a = 0; a < 3; a++)
        c.along[a] /= size;
    double turned = value_along(&c, 0.0) < 0.0 ? -1.0 : 1.0;
    for (int k = 0; k < 8; k++)
        c.value[k] *= turned;
    return c;
}

// The distance along the ray to the border of the cell.
static double end_of(const struct cell *c)
{
    double end = 2.0;
    for (int a = 0; a < 3; a++)
        end = fmin(end, ((c->along[a] > 0.0) - c->from[a]) / c->along[a]);
    return end;
}

TEST(the_root_is_the_first_one)
{
    char text[4000];
    struct renderer_inputs inputs = gpu_inputs(CHAPTER_WIDTH, CHAPTER_HEIGHT, 1);
    snprintf(text, sizeof text, "%s%s", experiment, one_cell);
    assert_true(gpu_load_text(text));
    float *number = gpu_numbers(&inputs);
    int hits = 0, misses = 0, grazes = 0, again = 0;
    double residual = 0.0, behind = 0.0;
    for (int n = 0; n < CELLS; n++) {
        struct cell c = random_cell(n);
        double root = 4.0 * ((double)number[4 * n] - 0.5), end = end_of(&c), least = 1.0;
        bool hit = root > -0.5;
        assert_true(fabs(4.0 * (double)number[4 * n + 1] - end) < 1e-5);
        double last = hit ? root : end;
        for (int i = 0; i <= SAMPLES; i++)
            least = fmin(least, value_along(&c, last * i / SAMPLES));
        behind = fmax(behind, -least);
        if (hit)
            residual = fmax(residual, fabs(value_along(&c, root)));
        hits += hit;
        misses += !hit;
        grazes += !hit && least < 0.01;
        again += hit && value_along(&c, end) > 0.0;
    }
    print_message("# %d roots, %d of them followed by another one; %d misses, %d of them by less "
                  "than 0.01\n# largest residual %.2g, deepest sample before the root %.2g\n",
                  hits, again, misses, grazes, residual, behind);
    assert_true(hits > 8000 && misses > 8000 && grazes > 500 && again > 300);
    assert_true(residual < 4e-6);
    assert_true(behind < 4e-6);
    free(number);
}

// ---- The march ----

static const char *const whole_march =
    "vec3 rayColour(Ray ray) {\n"
    "    vec3 colour = chapterColour(ray), p = ray.origin + trace.t * ray.direction;\n"
    "    bool clay = trace.end == END_HIT && turntableDistance(p) > 0.02;\n"
    "    int steps = trace.steps;\n"
    "    float value = storedDistance(grid, onTurntable(p)), least = 0.0, from = "
    "trace.interval.x;\n"
    "    for (int i = 0; i < 400 && trace.end != END_NONE; i++)\n"
    "        least = min(least, storedDistance(grid, onTurntable(ray.origin +\n"
    "                           mix(from, min(trace.t, trace.interval.y), i / 400.0) * "
    "ray.direction)));\n"
    "    return vec3(clay ? 0.5 + 25.0 * value : 0.0, steps / 256.0, 0.5 + 25.0 * least);\n"
    "}\n";

struct ends {
    int clay;                      // pixels that show clay
    double residual, least, steps; // largest |value| at the end, smallest value before, mean steps
};

static struct ends ends_of(double exact)
{
    struct ends e = {0, 0.0, 0.0, 0.0};
    struct renderer_inputs inputs = gpu_inputs(CHAPTER_WIDTH, CHAPTER_HEIGHT, 1);
    inputs.camera = gpu_camera("23_stored_distances");
    gpu_set("exact", exact);
    float *number = gpu_numbers(&inputs);
    for (int n = 0; n < COUNT; n++) {
        e.least = fmin(e.least, ((double)number[4 * n + 2] - 0.5) / 25.0);
        if (number[4 * n] > 0.0f) {
            e.clay++;
            e.residual = fmax(e.residual, fabs((double)number[4 * n] - 0.5) / 25.0);
            e.steps += 256.0 * (double)number[4 * n + 1];
        }
    }
    e.steps /= e.clay;
    free(number);
    return e;
}

TEST(the_march_ends_at_the_surface)
{
    char text[4000];
    snprintf(text, sizeof text, "%s%s", experiment, whole_march);
    assert_true(gpu_load_text(text));
    struct ends march = ends_of(0.0), root = ends_of(1.0);
    print_message("# pixels of clay: %d; mean evaluations of the march %.2f, with the root %.2f\n",
                  root.clay, march.steps, root.steps);
    print_message(
        "# largest residual: march %.2g, root %.2g; deepest sample before the root %.2g\n",
        march.residual, root.residual, fabs(root.least));
    assert_true(root.clay > 10000);
    assert_true(root.residual < 2e-6);
    assert_true(root.least > -2e-6);
    assert_true(march.residual > 1e-3);
    assert_true(root.steps < march.steps);
}

TESTS(gpu_setup, gpu_teardown)
