// The tables of docs/benchmark.md that compare the marches.
#include "lib/marches.h"

#include <stdio.h>
#include <stdlib.h>

#include "platform.h"
#include "lib/scratch.h"

enum { WIDTH = 640, HEIGHT = 360, FRAMES = 5 };

// The results for one scene.
struct row {
    struct march_costs costs[MARCH_KINDS];
    double seconds[MARCH_KINDS]; // the least processor time of a frame
    double over_bound[MARCH_KINDS];
};

static bool skipped(const struct march_scene *scene, enum march_kind kind)
{
    return kind == MARCH_SEGMENT && !scene->knows_fall;
}

static double frame_seconds(struct renderer *renderer, const struct renderer_inputs *inputs)
{
    double start = platform_processor_seconds();
    bool drawn = renderer_draw(renderer, inputs, 0, inputs->height);
    gpu.context.gl.Finish();
    return drawn ? platform_processor_seconds() - start : HUGE_VAL;
}

// The marches draw their frames in turn, so that anything that slows the machine slows all of them.
static void measure_time(struct renderer *renderers, const struct march_scene *scene,
                         struct row *row)
{
    struct renderer_inputs inputs = march_inputs(scene, WIDTH, HEIGHT);
    for (int kind = 0; kind < MARCH_KINDS; kind++)
        row->seconds[kind] = HUGE_VAL;
    for (int i = 0; i < FRAMES; i++)
        for (int kind = 0; kind < MARCH_KINDS; kind++)
            if (!skipped(scene, (enum march_kind)kind))
                row->seconds[kind] =
                    fmin(row->seconds[kind], frame_seconds(&renderers[kind], &inputs));
}

static bool open_one(struct renderer *renderer, const struct march_scene *scene,
                     enum march_kind kind)
{
    return renderer_open(renderer, &gpu.context.gl, gpu.root) && march_load(renderer, scene, kind);
}

static bool find_truth(const struct march_scene *scene, struct march_picture *truth)
{
    struct renderer renderer = {0};
    bool opened = open_one(&renderer, scene, MARCH_TIGHT);
    if (opened)
        *truth = march_draw(&renderer, scene, WIDTH, HEIGHT);
    renderer_close(&renderer);
    return opened;
}

static bool measure_scene(const struct march_scene *scene, struct row *row)
{
    struct renderer renderers[MARCH_KINDS] = {0};
    struct march_picture truth = {0};
    int *fewest = NULL;
    bool done = find_truth(scene, &truth);
    for (int kind = 0; kind < MARCH_KINDS && done; kind++) {
        if (skipped(scene, (enum march_kind)kind))
            continue;
        done = open_one(&renderers[kind], scene, (enum march_kind)kind);
        if (!done)
            break;
        if (kind == MARCH_PLAIN)
            fewest = march_fewest(&renderers[kind], scene, WIDTH, HEIGHT);
        struct march_picture picture = march_draw(&renderers[kind], scene, WIDTH, HEIGHT);
        double threshold = parameters_find(&renderers[kind].parameters, "hitThreshold")->value[0];
        row->costs[kind] = march_costs_of(&picture, &truth, threshold);
        row->over_bound[kind] = march_over_bound(&picture, fewest);
        march_free(&picture);
    }
    if (done)
        measure_time(renderers, scene, row);
    for (int kind = 0; kind < MARCH_KINDS; kind++)
        renderer_close(&renderers[kind]);
    march_free(&truth);
    free(fewest);
    return done;
}

static void print_head(const char *what)
{
    printf("| %s |", what);
    for (int kind = 0; kind < MARCH_KINDS; kind++)
        printf(" %s |", march_names[kind]);
    printf("\n|");
    for (int kind = -1; kind < MARCH_KINDS; kind++)
        printf(" --- |");
    printf("\n");
}

static void print_costs(const struct row rows[MARCH_SCENES])
{
    print_head("evaluations, march / bound, time");
    for (int i = 0; i < MARCH_SCENES; i++) {
        printf("| %s |", march_scenes[i].name);
        for (int kind = 0; kind < MARCH_KINDS; kind++) {
            if (skipped(&march_scenes[i], (enum march_kind)kind)) {
                printf(" - |");
                continue;
            }
            printf(" %.1f, ", rows[i].costs[kind].evaluations);
            if (march_scenes[i].lipschitz)
                printf("%.2f, ", rows[i].over_bound[kind]);
            else
                printf("-, ");
            printf(kind == MARCH_PLAIN ? "1 |" : "%.2f |",
                   rows[i].seconds[kind] / rows[i].seconds[MARCH_PLAIN]);
        }
        printf("\n");
    }
}

static void print_errors(const struct row rows[MARCH_SCENES])
{
    print_head("lockstep, false hits, false misses");
    for (int i = 0; i < MARCH_SCENES; i++) {
        printf("| %s |", march_scenes[i].name);
        for (int kind = 0; kind < MARCH_KINDS; kind++) {
            const struct march_costs *costs = &rows[i].costs[kind];
            if (skipped(&march_scenes[i], (enum march_kind)kind))
                printf(" - |");
            else
                printf(" %.2f, %d, %d |", costs->lockstep, costs->false_hits, costs->false_misses);
        }
        printf("\n");
    }
}

int marches_print(void)
{
    static struct row rows[MARCH_SCENES];
    char backend[256];
    scratch_make();
    bool done = true;
    for (int i = 0; i < MARCH_SCENES && done; i++) {
        fprintf(stderr, "%s, scene %d of %d\n", march_scenes[i].name, i + 1, MARCH_SCENES);
        done = measure_scene(&march_scenes[i], &rows[i]);
    }
    scratch_remove();
    if (!done)
        return 1;
    context_describe(&gpu.context, backend, sizeof backend);
    printf("%s; %dx%d, the fastest of %d frames\n\n", backend, WIDTH, HEIGHT, FRAMES);
    print_costs(rows);
    printf("\n");
    print_errors(rows);
    return 0;
}
