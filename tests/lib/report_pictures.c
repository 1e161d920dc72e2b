#include "lib/report_pictures.h"

#include <stdio.h>

#include "picture/benchmark.h"
#include "platform.h"

enum { FRAMES = 25, WARM_UP = 3 };

// The times of the report's engine were measured once, at 640x360. Their unit is that engine's time
// for the scene of the report's annex, measured on the same machine on the same day.
const struct report_scene report_scenes[REPORT_SCENES] = {
    {.name = "boxes",
     .shader = "chapters/experiments/16_report_boxes.frag",
     .camera = {.position = {1.085f, 0.652f, 1.289f}, .pan = -47.8f, .tilt = -19.9f},
     .setting = {"focalLength=1"},
     .engine = 8.7,
     .variant = {{"all", NULL}, {"no bounds", "clipped=false"}, {"no mirrored ray", "rays=1"}}},
    {.name = "pyramid",
     .shader = "chapters/experiments/16_report_sierpinski.frag",
     .camera = {.position = {-2.481f, 2.980f, -1.064f}, .pan = 116.5f, .tilt = -42.4f},
     .engine = 11.5,
     .variant = {{"all", NULL}, {"no bounds", "clipped=false"}, {"no footprint", "footprint=0"}}},
    {.name = "city",
     .shader = "chapters/experiments/16_report_city.frag",
     .camera = {.position = {-3.3f, 1.95f, 10.5f}, .pan = 17.7f, .tilt = 14.7f},
     .setting = {"focalLength=1.22", "timeOfDay=10.5"},
     .engine = 17.9,
     .variant = {{"all", NULL},
                 {"no bounds at the ground and the roof", "clipped=false"},
                 {"no parks in the distance function", "parks=false"},
                 {"no coarse pass", "coarsePass=false"},
                 {"no mirrored ray", "rays=1"}}},
};

bool report_load(struct renderer *renderer, const struct report_scene *scene,
                 const struct report_variant *variant)
{
    char path[8192];
    snprintf(path, sizeof path, "%s/%s", renderer->root, scene->shader);
    bool loaded = gpu_load_file(renderer, path);
    struct parameters *parameters = &renderer->parameters;
    for (int i = 0; i < parameters->count && loaded; i++)
        parameter_reset(&parameters->item[i]);
    for (int i = 0; i < REPORT_SETTINGS && loaded; i++)
        loaded = scene->setting[i] == NULL || parameters_assign(parameters, scene->setting[i]);
    if (loaded && variant != NULL && variant->setting != NULL)
        loaded = parameters_assign(parameters, variant->setting);
    return loaded;
}

struct renderer_inputs report_inputs(const struct report_scene *scene, int width, int height)
{
    return (struct renderer_inputs){
        .width = width, .height = height, .camera = scene->camera, .samples = 1};
}

// A picture to be timed: the reference scene, which is the unit, or a variant of a scene.
struct runner {
    struct renderer renderer;
    struct renderer_inputs inputs;
    double least;       // the fastest frame, seconds of process CPU time
    double evaluations; // per pixel, on average
};

static double cpu_time(void)
{
    return platform_processor_seconds();
}

static bool run_frame(struct runner *runner, bool counts)
{
    double start = cpu_time();
    bool drawn = renderer_draw(&runner->renderer, &runner->inputs, 0, runner->inputs.height);
    gpu.context.gl.Finish();
    double seconds = cpu_time() - start;
    if (counts && (runner->least == 0.0 || seconds < runner->least))
        runner->least = seconds;
    return drawn;
}

static bool open_unit(struct runner *runner)
{
    char path[8192];
    snprintf(path, sizeof path, "%s/tests/pictures/reference_scene.frag", gpu.root);
    runner->inputs =
        (struct renderer_inputs){.width = 640, .height = 360, .time = 1.0, .samples = 1};
    return renderer_open(&runner->renderer, &gpu.context.gl, gpu.root) &&
           gpu_load_file(&runner->renderer, path);
}

static bool open_variant(struct runner *runner, const struct report_scene *scene,
                         const struct report_variant *variant)
{
    runner->inputs = report_inputs(scene, 640, 360);
    struct benchmark counted = {.shader = variant->name, .frames = 1, .inputs = runner->inputs};
    bool opened = renderer_open(&runner->renderer, &gpu.context.gl, gpu.root) &&
                  report_load(&runner->renderer, scene, variant) &&
                  benchmark_run(&counted, &gpu.context, &runner->renderer);
    runner->evaluations = counted.mean;
    return opened;
}

static bool print_scene(const struct report_scene *scene)
{
    struct runner runner[1 + REPORT_VARIANTS] = {0};
    bool done = open_unit(&runner[0]);
    int count = 1;
    for (; count <= REPORT_VARIANTS && scene->variant[count - 1].name != NULL; count++)
        done = done && open_variant(&runner[count], scene, &scene->variant[count - 1]);
    for (int i = -WARM_UP; i < FRAMES && done; i++)
        for (int k = 0; k < count && done; k++)
            done = run_frame(&runner[k], i >= 0);
    for (int k = 1; k < count && done; k++) {
        double units = runner[k].least / runner[0].least;
        printf("%s,%s,%.2f,%.1f,%.1f,%.1f\n", scene->name, scene->variant[k - 1].name, units,
               runner[k].evaluations, scene->engine, scene->engine / units);
    }
    for (int k = 0; k < count; k++)
        renderer_close(&runner[k].renderer);
    return done;
}

int report_print(void)
{
    printf("# time of a frame at 640x360 divided by that of tests/pictures/reference_scene.frag: "
           "process CPU time, the fastest of %d frames; the engine's time was measured once\n",
           FRAMES);
    printf("picture,variant,units,evaluations,engine,times faster\n");
    for (int i = 0; i < REPORT_SCENES; i++)
        if (!print_scene(&report_scenes[i]))
            return 1;
    return 0;
}
