#include "lib/marches.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "lib/scratch.h"

enum { BLOCK = 8, TEXT = 4096 };

const char *const march_macros[MARCH_KINDS + 1] = {"PLAIN",    "RELAXED", "ENHANCED", "SEGMENT",
                                                   "OVERSTEP", "CONE",    "COARSE",   "TIGHT"};
const char *const march_names[MARCH_KINDS] = {"plain",    "relaxed", "enhanced",   "segment",
                                              "overstep", "cone",    "coarse pass"};

#define MARGIN    "float coarseMargin(float t) { return hitThreshold; }\n"
#define STRESS(n) "#define STRESS " #n "\n"

const struct march_scene march_scenes[MARCH_SCENES] = {
    {"03", "03_shadows", "", "03_shadows.frag", MARGIN, "", NULL, false, true},
    {"06", "06_sierpinski_symmetry", "", "06_sierpinski_symmetry.frag", MARGIN, "", NULL, false,
     true},
    {"07", "07_repetition", "", "07_repetition.frag", MARGIN, "", NULL, false, true},
    {"09", "09_sky_and_sunset", "", "09_sky_and_sunset.frag", MARGIN, "", NULL, false, true},
    {"16", "16_fewer_steps", "", "16_fewer_steps.frag", "", "", "divider=1", false, true},
    // In chapters 21 and 22, the march already begins where the coarse pass ended, in chapter 21 at
    // the water if the water is nearer.
    {"21", "21_a_landscape", "#define PASS_DONE\n", "21_a_landscape.frag", "",
     "asked = 0; way = oneWay(max(abs(ray.direction.y), bend.direction.y));\n", NULL, false, true},
    {"22", "22_many_parts", "#define PASS_DONE\n#include \"reef.glsl\"\n", "22_many_parts.frag", "",
     "", NULL, false, false},
    {"torus", "16_fewer_steps", STRESS(0), "experiments/16_stress.frag", NULL, "", NULL, true,
     true},
    {"plane", "16_fewer_steps", STRESS(1), "experiments/16_stress.frag", NULL, "", NULL, true,
     true},
    {"hollow cube", "16_fewer_steps", STRESS(2), "experiments/16_stress.frag", NULL, "", NULL, true,
     true},
    {"plates", "16_fewer_steps", STRESS(3), "experiments/16_stress.frag", NULL, "", NULL, true,
     true},
};

// The camera from which all four scenes of 16_stress.frag are seen.
static const struct camera stress_camera = {.position = {0.0f, 1.0f, 3.2f}, .tilt = -14.0f};

static bool is_stress(const struct march_scene *scene)
{
    return scene->after == NULL;
}

struct renderer_inputs march_inputs(const struct march_scene *scene, int width, int height)
{
    return (struct renderer_inputs){.width = width,
                                    .height = height,
                                    .time = 1.0,
                                    .camera =
                                        is_stress(scene) ? stress_camera : gpu_camera(scene->stem),
                                    .samples = 1};
}

static bool set(struct renderer *renderer, const char *setting)
{
    return setting == NULL || parameters_assign(&renderer->parameters, setting);
}

bool march_load(struct renderer *renderer, const struct march_scene *scene, enum march_kind kind)
{
    static char text[TEXT];
    if (is_stress(scene))
        snprintf(text, sizeof text, "#define MARCH %s\n%s#include \"%s\"\n", march_macros[kind],
                 scene->before, scene->source);
    else
        snprintf(
            text, sizeof text,
            "#define MARCH %s\n#include \"main.glsl\"\n%s#include \"experiments/16_marches.glsl\"\n"
            "#define rayColour chapterColour\n#include \"%s\"\n#undef rayColour\n%s"
            "vec3 rayColour(Ray ray)\n{\n    chapterColour(ray);\n    %s    return "
            "marchColour();\n}\n",
            march_macros[kind], scene->before, scene->source, scene->after, scene->restore);
    if (!gpu_load_file(renderer, scratch_write("march.frag", text)))
        return false;
    for (int i = 0; i < renderer->parameters.count; i++)
        parameter_reset(&renderer->parameters.item[i]);
    const char *pass = kind == MARCH_COARSE ? "coarsePass=true" : "coarsePass=false";
    bool has_pass = parameters_find(&renderer->parameters, "coarsePass") != NULL;
    return set(renderer, scene->setting) && set(renderer, "numbers=true") &&
           (!has_pass || set(renderer, pass));
}

// ---- What a march found ----

// The number of evaluations in the coarse pass, which the last frame left in the pass's target.
static double coarse_evaluations(struct renderer *renderer)
{
    int blocks = renderer->coarse.width * renderer->coarse.height;
    float *values = malloc(4 * sizeof *values * (size_t)blocks);
    double sum = 0.0;
    assert_non_null(values);
    target_read(&renderer->coarse, renderer->gl, values);
    for (int i = 0; i < blocks; i++)
        sum += (double)values[4 * i + 1];
    free(values);
    return sum;
}

static float *draw(struct renderer *renderer, const struct march_scene *scene, int width,
                   int height)
{
    struct renderer_inputs inputs = march_inputs(scene, width, height);
    float *values = malloc(4 * sizeof *values * (size_t)width * (size_t)height);
    assert_non_null(values);
    assert_true(renderer_draw(renderer, &inputs, 0, height));
    target_read(&renderer->picture, renderer->gl, values);
    return values;
}

struct march_picture march_draw(struct renderer *renderer, const struct march_scene *scene,
                                int width, int height)
{
    size_t pixels = (size_t)width * (size_t)height;
    struct march_picture picture = {.width = width,
                                    .height = height,
                                    .evaluations = malloc(pixels * sizeof(int)),
                                    .t = malloc(pixels * sizeof(double)),
                                    .found = malloc(pixels * sizeof(bool))};
    assert_non_null(picture.evaluations);
    assert_non_null(picture.t);
    assert_non_null(picture.found);
    float *values = draw(renderer, scene, width, height);
    for (size_t i = 0; i < pixels; i++) {
        picture.evaluations[i] = (int)(4096.0f * values[4 * i] + 0.5f);
        picture.t[i] = 1024.0 * (double)values[4 * i + 1];
        picture.found[i] = values[4 * i + 2] > 0.5f;
    }
    free(values);
    if (renderer_wants_coarse(renderer, VIEW_PICTURE))
        picture.shared = coarse_evaluations(renderer) / (double)pixels;
    return picture;
}

void march_free(struct march_picture *picture)
{
    free(picture->evaluations);
    free(picture->t);
    free(picture->found);
    *picture = (struct march_picture){0};
}

static int largest_of_block(const struct march_picture *picture, int left, int bottom)
{
    int largest = 0;
    for (int y = bottom; y < bottom + BLOCK && y < picture->height; y++)
        for (int x = left; x < left + BLOCK && x < picture->width; x++) {
            int here = picture->evaluations[y * picture->width + x];
            largest = here > largest ? here : largest;
        }
    return largest;
}

struct march_costs march_costs_of(const struct march_picture *picture,
                                  const struct march_picture *truth, double threshold)
{
    struct march_costs costs = {0};
    int pixels = picture->width * picture->height, blocks = 0;
    double sum = 0.0, largest = 0.0;
    for (int i = 0; i < pixels; i++) {
        sum += picture->evaluations[i];
        costs.false_hits += picture->found[i] && !truth->found[i];
        costs.false_misses +=
            truth->found[i] && (!picture->found[i] || picture->t[i] > truth->t[i] + threshold);
    }
    for (int y = 0; y < picture->height; y += BLOCK)
        for (int x = 0; x < picture->width; x += BLOCK, blocks++)
            largest += largest_of_block(picture, x, y);
    costs.evaluations = sum / pixels + picture->shared;
    costs.lockstep = (largest / blocks + picture->shared) / costs.evaluations;
    return costs;
}

int *march_fewest(struct renderer *renderer, const struct march_scene *scene, int width, int height)
{
    int *fewest = malloc(sizeof *fewest * (size_t)width * (size_t)height);
    assert_non_null(fewest);
    assert_true(renderer_set_view(renderer, VIEW_COVER));
    float *values = draw(renderer, scene, width, height);
    for (int i = 0; i < width * height; i++)
        fewest[i] =
            values[4 * i + 3] > 0.5f && values[4 * i + 1] > 0.0f ? (int)values[4 * i + 2] : -1;
    free(values);
    assert_true(renderer_set_view(renderer, VIEW_PICTURE));
    return fewest;
}

double march_over_bound(const struct march_picture *picture, const int *fewest)
{
    double march = 0.0, bound = 0.0;
    for (int i = 0; i < picture->width * picture->height; i++)
        if (fewest[i] > 0) {
            march += picture->evaluations[i] + picture->shared;
            bound += fewest[i];
        }
    return march / bound;
}
