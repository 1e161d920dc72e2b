#include "lib/part_march.h"

#include <math.h>
#include <stdlib.h>

#include "textures/paint.h"

enum { LEAF = 4, MOST_STEPS = 400 };

static const double FAR = 20.0, THRESHOLD = 0.001;

// ---- The tree ----

static int axis; // the axis along which by_axis compares; qsort cannot pass it on

static int by_axis(const void *a, const void *b)
{
    const struct part *p = a, *q = b;
    double d = p->centre[axis] - q->centre[axis];
    return d < 0.0 ? -1 : d > 0.0;
}

static void grow(struct part_scene *scene, int first, int count)
{
    struct part_node *node = &scene->node[scene->nodes++];
    double low[3], high[3], widest = -1.0;
    for (int i = 0; i < 3; i++) {
        node->low[i] = low[i] = 1e9;
        node->high[i] = high[i] = -1e9;
        for (int k = first; k < first + count; k++) {
            const struct part *part = &scene->part[k];
            double reach = fabs(part->half[i]) + part->radius;
            node->low[i] = fmin(node->low[i], part->centre[i] - reach);
            node->high[i] = fmax(node->high[i], part->centre[i] + reach);
            low[i] = fmin(low[i], part->centre[i]);
            high[i] = fmax(high[i], part->centre[i]);
        }
    }
    node->first = first;
    node->count = count <= LEAF ? count : 0;
    if (node->count == 0) {
        for (int i = 0; i < 3; i++)
            if (high[i] - low[i] > widest) {
                widest = high[i] - low[i];
                axis = i;
            }
        qsort(scene->part + first, (size_t)count, sizeof *scene->part, by_axis);
        grow(scene, first, count / 2);
        grow(scene, first + count / 2, count - count / 2);
    }
    node->skip = scene->nodes;
}

double part_heap_blend(int count)
{
    return 0.10 * cbrt(230.0 / count);
}

void part_heap(int count, struct part *part)
{
    double most = 4.0 * part_heap_blend(count);
    for (int n = 0, i = 0; n < count; i++) {
        double random[6];
        for (int k = 0; k < 6; k++)
            random[k] = paint_random(i, k, 7U);
        double x = 10.0 * random[0] - 5.0, y = 4.0 * random[1], z = 10.0 * random[2] - 5.0;
        if (y > 4.0 - 4.0 * (x * x + z * z) / 30.0)
            continue;
        double radius = most * (0.5 + 0.5 * random[3]), turn = 2.0 * random[4] - 1.0,
               lift = 2.0 * random[5] - 1.0;
        part[n++] = part_stored((struct part){
            {x, y, z}, {0.8 * radius * turn, 0.5 * radius * lift, 0.4 * radius}, radius, 0});
    }
}

struct part_scene *part_scene_build(void (*build)(int count, struct part *part), int count,
                                    double blend)
{
    struct part_scene *scene = calloc(1, sizeof *scene);
    if (scene == NULL)
        return NULL;
    scene->count = count;
    scene->blend = blend;
    build(count, scene->part);
    grow(scene, 0, count);
    if (!part_grid_build(&scene->grid, scene->part, count, blend, PART_FINENESS)) {
        free(scene);
        return NULL;
    }
    return scene;
}

void part_scene_free(struct part_scene *scene)
{
    if (scene != NULL)
        part_grid_free(&scene->grid);
    free(scene);
}

double part_tree_distance(const struct part_scene *scene, const double p[3], double hint,
                          long *asked)
{
    double value = 1e9;
    for (int i = 0; i < scene->nodes;) {
        const struct part_node *node = &scene->node[i];
        double square = 0.0, cut = fmin(value + scene->blend, hint + PART_REACH * scene->blend);
        for (int k = 0; k < 3; k++) {
            double away = fmax(fmax(node->low[k] - p[k], p[k] - node->high[k]), 0.0);
            square += away * away;
        }
        bool skip = sqrt(square) > fmax(cut, 0.0);
        for (int k = 0; !skip && k < node->count; k++, (*asked)++)
            value =
                part_union(value, part_distance(&scene->part[node->first + k], p), scene->blend);
        i = skip ? node->skip : i + 1;
    }
    return value;
}

// ---- The march ----

// How far a ray may advance before it leaves a cell, plus a little.
static double exit_of(const struct part_grid *grid, const double p[3], const double direction[3])
{
    double leave = 1e9;
    for (int i = 0; i < 3; i++) {
        double at = floor((p[i] - grid->low[i]) / grid->size);
        at = fmin(fmax(at, 0.0), grid->cells[i] - 1.0) + (direction[i] > 0.0 ? 1.0 : 0.0);
        if (direction[i] != 0.0)
            leave = fmin(leave, (grid->low[i] + at * grid->size - p[i]) / direction[i]);
    }
    return fmax(leave, 0.0) + 1e-9;
}

static double grid_step(const struct part_scene *scene, const struct part_ray *ray,
                        const double p[3], long *asked, bool *found)
{
    const struct part_grid *grid = &scene->grid;
    const struct part_cell *cell = part_grid_cell(grid, p);
    double leave = exit_of(grid, p, ray->direction);
    if (cell->count == 0)
        return leave;
    double d = parts_distance(scene->part, grid->id + cell->first, cell->count, scene->blend, p);
    *asked += cell->count;
    *found = d < THRESHOLD;
    return fmin(d, leave);
}

// Find the interval of a ray inside the grid.
static void clip(const struct part_grid *grid, const struct part_ray *ray, double interval[2])
{
    interval[0] = 0.0;
    interval[1] = FAR;
    for (int i = 0; i < 3; i++) {
        double high = grid->low[i] + grid->cells[i] * grid->size;
        double a = (grid->low[i] - ray->origin[i]) / ray->direction[i];
        double b = (high - ray->origin[i]) / ray->direction[i];
        interval[0] = fmax(interval[0], fmin(a, b));
        interval[1] = fmin(interval[1], fmax(a, b));
    }
}

struct part_result part_march(const struct part_scene *scene, enum part_means means,
                              const struct part_ray *ray)
{
    struct part_result result = {0};
    double interval[2], hint = 1e9;
    clip(&scene->grid, ray, interval);
    if (ray->direction[1] < 0.0) // the ray ends at the sand
        interval[1] = fmin(interval[1], -ray->origin[1] / ray->direction[1]);
    for (result.t = interval[0];
         !result.found && result.t < interval[1] && result.steps < MOST_STEPS; result.steps++) {
        double p[3], d = 0.0;
        for (int i = 0; i < 3; i++)
            p[i] = ray->origin[i] + result.t * ray->direction[i];
        if (means == PARTS_GRID)
            d = grid_step(scene, ray, p, &result.asked, &result.found);
        else if (means == PARTS_FLAT) {
            d = parts_distance(scene->part, NULL, scene->count, scene->blend, p);
            result.asked += scene->count;
        } else
            d = part_tree_distance(scene, p, means == PARTS_BOUNDED ? hint : 1e9, &result.asked);
        hint = 2.0 * fmax(d, 0.0); // an upper bound on the distance after a step of d
        result.found |= means != PARTS_GRID && d < THRESHOLD;
        result.t += result.found ? 0.0 : d;
    }
    return result;
}

struct part_ray part_heap_ray(double x, double y)
{
    // The eye looks down by 20.9 degrees, towards positive x and z.
    const double forward[3] = {0.3830, -0.3569, 0.8520}, right[3] = {0.9119, 0.0, -0.4103},
                 up[3] = {0.1464, 0.9341, 0.3255};
    struct part_ray ray = {{-4.4, 5.4, -9.6}, {0.0, 0.0, 0.0}};
    double square = 0.0;
    for (int i = 0; i < 3; i++) {
        ray.direction[i] =
            (2.0 * x - 1.0) * right[i] + 0.5625 * ((2.0 * y - 1.0) * up[i] + 2.6 * forward[i]);
        square += ray.direction[i] * ray.direction[i];
    }
    for (int i = 0; i < 3; i++)
        ray.direction[i] /= sqrt(square);
    return ray;
}

double part_heap_asked(const struct part_scene *scene, enum part_means means, int *hits)
{
    long asked = 0;
    *hits = 0;
    for (int i = 0; i < PART_RAYS; i++) {
        struct part_ray ray =
            part_heap_ray((i % PARTS_WIDE + 0.5) / PARTS_WIDE, (i / PARTS_WIDE + 0.5) / PARTS_HIGH);
        struct part_result result = part_march(scene, means, &ray);
        asked += result.asked;
        *hits += result.found;
    }
    return (double)asked / PART_RAYS;
}
