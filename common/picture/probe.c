#include "picture/probe.h"

#include <string.h>

// A shader may write any number into the global variable trace.
static int count_of(float value)
{
    return value >= 0.0f && value < 1e9f ? (int)value : value >= 1e9f ? 1000000000 : 0;
}

void probe_unpack(struct probe *probe, const float *values)
{
    const float(*row)[PROBE_STEPS][4] = (const float(*)[PROBE_STEPS][4])values;
    int end = count_of(row[0][0][3]);
    probe->end = end <= PROBE_GAVE_UP ? (enum probe_end)end : PROBE_NO_MARCH;
    probe->steps = count_of(row[0][0][2]);
    probe->all_steps = count_of(row[2][0][0]);
    probe->evaluations = count_of(row[2][0][1]);
    probe->recorded = true;
    memcpy(probe->interval, &row[2][0][2], sizeof probe->interval);
    for (int k = 0; k < PROBE_STEPS; k++) {
        probe->step[k].t = row[0][k][0];
        probe->step[k].distance = row[0][k][1];
        memcpy(probe->step[k].position, row[1][k], sizeof probe->step[k].position);
        probe->step[k].threshold = row[1][k][3];
    }
}

int probe_rows(const struct probe *probe)
{
    return probe->steps < PROBE_STEPS ? probe->steps : PROBE_STEPS;
}

// True if the last step was not near enough for a hit. A ground, or the top of a table, may be
// found by a formula instead.
static bool ends_far(const struct probe *probe)
{
    const struct probe_step *last = &probe->step[probe->steps > 0 ? probe->steps - 1 : 0];
    return probe->steps <= PROBE_STEPS &&
           (probe->steps == 0 ||
            (last->threshold > 0.0f && last->distance > 1.01f * last->threshold));
}

const char *probe_outcome(const struct probe *probe)
{
    static const char *const ends[] = {"no march", "hit", "miss: passed the far limit",
                                       "miss: the steps ran out"};
    return probe->end == PROBE_HIT && probe->recorded && ends_far(probe) ? "hit: found by a formula"
                                                                         : ends[probe->end];
}

static void print_march(const struct probe *probe, FILE *file)
{
    fprintf(file, "step,t,distance,x,y,z\n");
    for (int i = 0; i < probe_rows(probe); i++) {
        const struct probe_step *step = &probe->step[i];
        fprintf(file, "%d,%.9g,%.9g,%.9g,%.9g,%.9g\n", i, (double)step->t, (double)step->distance,
                (double)step->position[0], (double)step->position[1], (double)step->position[2]);
    }
    fprintf(file, "# %s; steps: %d; ", probe_outcome(probe), probe->steps);
    if (probe->all_steps > probe->steps)
        fprintf(file, "steps of further rays: %d; ", probe->all_steps - probe->steps);
    fprintf(file, "evaluations of the scene: %d; ", probe->evaluations);
}

void probe_print(const struct probe *probe, FILE *file)
{
    if (probe->recorded)
        print_march(probe, file);
    else
        fprintf(file, "# no march is recorded; ");
    fprintf(file, "colour: %d, %d, %d\n", probe->colour[0], probe->colour[1], probe->colour[2]);
}
