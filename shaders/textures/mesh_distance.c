#include "mesh_distance.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"

// ---- Vectors ----

static void subtract(const double a[3], const double b[3], double result[3])
{
    for (int i = 0; i < 3; i++)
        result[i] = a[i] - b[i];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double result[3])
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        result[i] = a[j] * b[k] - a[k] * b[j];
    }
}

static void add(double to[3], const double from[3], double share)
{
    for (int i = 0; i < 3; i++)
        to[i] += share * from[i];
}

static void normalize(double v[3])
{
    double size = sqrt(dot(v, v));
    for (int i = 0; i < 3; i++)
        v[i] /= size;
}

// The tangent of half the angle is the length of the difference of the unit vectors divided by that
// of their sum. The angle is halved six more times, so that the series of the arctangent is short.
double mesh_angle(const double a[3], const double b[3])
{
    double u[3], v[3], sum[3], difference[3];
    memcpy(u, a, sizeof u);
    memcpy(v, b, sizeof v);
    normalize(u);
    normalize(v);
    memcpy(sum, u, sizeof sum);
    add(sum, v, 1.0);
    subtract(u, v, difference);
    double x = sqrt(dot(sum, sum)), y = sqrt(dot(difference, difference)), series = 0.0;
    for (int i = 0; i < 6; i++)
        x += sqrt(x * x + y * y);
    double t = y / x;
    for (int k = 6; k >= 0; k--)
        series = 1.0 / (2 * k + 1) - t * t * series;
    return 128.0 * t * series;
}

// ---- The nearest point of a triangle ----

// Set nearest to the point from + share (to - from) of an edge. Returns feature.
static int on_edge(const double from[3], const double to[3], double share, double nearest[3],
                   int feature)
{
    for (int i = 0; i < 3; i++)
        nearest[i] = from[i] + share * (to[i] - from[i]);
    return feature;
}

int mesh_nearest(const double *const corner[3], const double p[3], double nearest[3])
{
    const double *a = corner[0], *b = corner[1], *c = corner[2];
    double ab[3], ac[3], ap[3], bp[3], cp[3];
    subtract(b, a, ab);
    subtract(c, a, ac);
    subtract(p, a, ap);
    subtract(p, b, bp);
    subtract(p, c, cp);
    double ab_a = dot(ab, ap), ac_a = dot(ac, ap), ab_b = dot(ab, bp), ac_b = dot(ac, bp);
    double ab_c = dot(ab, cp), ac_c = dot(ac, cp);
    if (ab_a <= 0.0 && ac_a <= 0.0)
        return on_edge(a, b, 0.0, nearest, MESH_VERTEX_0);
    if (ab_b >= 0.0 && ac_b <= ab_b)
        return on_edge(b, c, 0.0, nearest, MESH_VERTEX_0 + 1);
    if (ac_c >= 0.0 && ab_c <= ac_c)
        return on_edge(c, a, 0.0, nearest, MESH_VERTEX_0 + 2);
    // The signed areas of the triangles between the projected point and each side, all times the
    // same factor.
    double area_c = ab_a * ac_b - ab_b * ac_a, area_b = ab_c * ac_a - ab_a * ac_c;
    double area_a = ab_b * ac_c - ab_c * ac_b;
    if (area_c <= 0.0 && ab_a >= 0.0 && ab_b <= 0.0)
        return on_edge(a, b, ab_a / (ab_a - ab_b), nearest, MESH_EDGE_01);
    if (area_b <= 0.0 && ac_a >= 0.0 && ac_c <= 0.0)
        return on_edge(c, a, ac_c / (ac_c - ac_a), nearest, MESH_EDGE_20);
    double to_c = ac_b - ab_b, to_b = ab_c - ac_c;
    if (area_a <= 0.0 && to_c >= 0.0 && to_b >= 0.0)
        return on_edge(b, c, to_c / (to_c + to_b), nearest, MESH_EDGE_12);
    double all = area_a + area_b + area_c;
    for (int i = 0; i < 3; i++)
        nearest[i] = a[i] + (area_b * ab[i] + area_c * ac[i]) / all;
    return MESH_FACE;
}

// ---- Normals ----

// Add each face's normal to the normals of its vertices, weighted by the face's angle at each
// vertex.
static void add_faces(struct mesh_tree *tree, double (*vertex_sum)[3])
{
    const struct triangles *triangles = tree->triangles;
    for (int i = 0; i < triangles->count; i++) {
        const int *corner = triangles->corner[i];
        double *face = tree->normal[i][MESH_FACE];
        for (int k = 0; k < 3; k++) {
            double ahead[3], back[3];
            const double *here = triangles->vertex[corner[k]];
            subtract(triangles->vertex[corner[(k + 1) % 3]], here, ahead);
            subtract(triangles->vertex[corner[(k + 2) % 3]], here, back);
            if (k == 0) {
                cross(ahead, back, face);
                normalize(face);
            }
            add(vertex_sum[corner[k]], face, mesh_angle(ahead, back));
        }
    }
}

// A side of a triangle: side 3 i + k begins at corner k of triangle i.
struct side {
    int low, high; // its vertices, low < high
    int name;
};

static int by_vertices(const void *one, const void *other)
{
    const struct side *a = one, *b = other;
    int first = (a->low > b->low) - (a->low < b->low);
    return first != 0 ? first : (a->high > b->high) - (a->high < b->high);
}

// Set the normal of each edge to the sum of the normals of its two faces.
static void add_edges(struct mesh_tree *tree)
{
    int count = 3 * tree->triangles->count;
    struct side *side = memory_zeros((size_t)count, sizeof *side);
    for (int i = 0; i < count; i++) {
        const int *corner = tree->triangles->corner[i / 3];
        int from = corner[i % 3], to = corner[(i + 1) % 3];
        side[i] = (struct side){from < to ? from : to, from < to ? to : from, i};
    }
    qsort(side, (size_t)count, sizeof *side, by_vertices);
    for (int i = 0; i < count; i++)
        for (int k = -1; k <= 1; k++)
            if (i + k >= 0 && i + k < count && by_vertices(&side[i], &side[i + k]) == 0)
                add(tree->normal[side[i].name / 3][MESH_EDGE_01 + side[i].name % 3],
                    tree->normal[side[i + k].name / 3][MESH_FACE], 1.0);
    free(side);
}

static void find_normals(struct mesh_tree *tree)
{
    const struct triangles *triangles = tree->triangles;
    double(*vertex_sum)[3] = memory_zeros((size_t)triangles->vertices, sizeof *vertex_sum);
    tree->normal = memory_zeros((size_t)triangles->count, sizeof *tree->normal);
    add_faces(tree, vertex_sum);
    add_edges(tree);
    for (int i = 0; i < triangles->count; i++)
        for (int k = 0; k < 3; k++)
            memcpy(tree->normal[i][MESH_VERTEX_0 + k], vertex_sum[triangles->corner[i][k]],
                   sizeof vertex_sum[0]);
    free(vertex_sum);
}

// ---- The tree ----

static const double *corner_of(const struct mesh_tree *tree, int triangle, int k)
{
    return tree->triangles->vertex[tree->triangles->corner[triangle][k]];
}

// Return the corner of a box's triangles that is farthest from a line, or from a point.
//   from   a point of the line
//   along  its direction, of length 1; (0, 0, 0) for a point
//   way    receives the shortest way to that corner
static const double *farthest(const struct mesh_tree *tree, const struct mesh_box *box,
                              const double from[3], const double along[3], double way[3])
{
    const double *far = from;
    double most = -1.0;
    for (int i = 0; i < 3 * box->count; i++) {
        const double *corner = corner_of(tree, tree->order[box->first + i / 3], i % 3);
        double aside[3];
        subtract(corner, from, aside);
        add(aside, along, -dot(aside, along));
        if (dot(aside, aside) > most) {
            most = dot(aside, aside);
            far = corner;
            memcpy(way, aside, sizeof aside);
        }
    }
    return far;
}

// Turn a box along its triangles: its first axis joins two corners that are far apart, and its
// second axis points to the corner that is farthest from the first one. A box along the axes of
// space would be far too large for a long, thin triangle that lies across them, as in a fan.
static void turn_box(const struct mesh_tree *tree, struct mesh_box *box)
{
    static const double none[3] = {0.0, 0.0, 0.0};
    const double *any = corner_of(tree, tree->order[box->first], 0);
    const double *from = farthest(tree, box, any, none, box->axis[0]);
    farthest(tree, box, from, none, box->axis[0]);
    normalize(box->axis[0]);
    farthest(tree, box, from, box->axis[0], box->axis[1]);
    normalize(box->axis[1]);
    cross(box->axis[0], box->axis[1], box->axis[2]);
}

static void fit_box(const struct mesh_tree *tree, struct mesh_box *box)
{
    turn_box(tree, box);
    for (int k = 0; k < 3; k++) {
        box->low[k] = DBL_MAX;
        box->high[k] = -DBL_MAX;
        for (int i = 0; i < 3 * box->count; i++) {
            const double *corner = corner_of(tree, tree->order[box->first + i / 3], i % 3);
            double x = dot(corner, box->axis[k]);
            box->low[k] = fmin(box->low[k], x);
            box->high[k] = fmax(box->high[k], x);
        }
    }
}

// The coordinate of a triangle's middle on an axis.
static double middle_of(const struct mesh_tree *tree, int triangle, const double axis[3])
{
    double sum = 0.0;
    for (int k = 0; k < 3; k++)
        sum += dot(corner_of(tree, triangle, k), axis);
    return sum / 3.0;
}

// Sort the triangles of a box into two parts, at the plane that halves the longest side of the box
// around their middles. If all are in one part, because their middles are the same, the list is
// halved instead. Returns the number of triangles in the first part.
static int split(const struct mesh_tree *tree, const struct mesh_box *box)
{
    int *order = tree->order + box->first, count = 0;
    const double *axis = box->axis[0];
    double border = 0.0, longest = -1.0;
    for (int k = 0; k < 3; k++) {
        double low = DBL_MAX, high = -DBL_MAX;
        for (int i = 0; i < box->count; i++) {
            double x = middle_of(tree, order[i], box->axis[k]);
            low = fmin(low, x);
            high = fmax(high, x);
        }
        if (high - low > longest) {
            longest = high - low;
            axis = box->axis[k];
            border = 0.5 * (low + high);
        }
    }
    for (int i = 0; i < box->count; i++)
        if (middle_of(tree, order[i], axis) < border) {
            int triangle = order[i];
            order[i] = order[count];
            order[count++] = triangle;
        }
    return count > 0 && count < box->count ? count : box->count / 2;
}

struct mesh_tree mesh_tree_build(const struct triangles *triangles)
{
    struct mesh_tree tree = {.triangles = triangles, .boxes = 1};
    tree.order = memory_zeros((size_t)triangles->count, sizeof *tree.order);
    tree.box = memory_zeros(2 * (size_t)triangles->count, sizeof *tree.box);
    for (int i = 0; i < triangles->count; i++)
        tree.order[i] = i;
    tree.box[0].count = triangles->count;
    // The list of boxes is also the list of boxes that are still to be split.
    for (int i = 0; i < tree.boxes; i++) {
        struct mesh_box *box = &tree.box[i];
        fit_box(&tree, box);
        if (box->count <= MESH_LEAF)
            continue;
        int count = split(&tree, box);
        box->left = tree.boxes;
        tree.box[tree.boxes++] = (struct mesh_box){.first = box->first, .count = count};
        tree.box[tree.boxes++] =
            (struct mesh_box){.first = box->first + count, .count = box->count - count};
    }
    find_normals(&tree);
    return tree;
}

void mesh_tree_free(struct mesh_tree *tree)
{
    free(tree->normal);
    free(tree->order);
    free(tree->box);
    *tree = (struct mesh_tree){0};
}

// ---- The distance ----

// The nearest point found so far.
struct search {
    double squared;  // square of the distance
    double aside[3]; // from the nearest point to p
    int triangle;
    int feature;
};

// The square of the distance to a box, made a little smaller because of rounding.
static double squared_to_box(const struct mesh_box *box, const double p[3])
{
    double sum = 0.0;
    for (int i = 0; i < 3; i++) {
        double x = dot(p, box->axis[i]);
        double outside = fmax(fmax(box->low[i] - x, x - box->high[i]) - 1e-12, 0.0);
        sum += outside * outside;
    }
    return sum;
}

static void try_triangle(const struct mesh_tree *tree, int triangle, const double p[3],
                         struct search *search)
{
    const double *corner[3];
    double nearest[3], aside[3];
    for (int k = 0; k < 3; k++)
        corner[k] = corner_of(tree, triangle, k);
    int feature = mesh_nearest(corner, p, nearest);
    subtract(p, nearest, aside);
    double squared = dot(aside, aside);
    if (squared < search->squared) {
        *search = (struct search){.squared = squared, .triangle = triangle, .feature = feature};
        memcpy(search->aside, aside, sizeof aside);
    }
}

// Search a box, the nearer of its two parts first; a box that is farther away than the nearest
// point so far is skipped.
static void search_box(const struct mesh_tree *tree, int index, const double p[3],
                       struct search *search)
{
    const struct mesh_box *box = &tree->box[index];
    if (squared_to_box(box, p) >= search->squared)
        return;
    if (box->left == 0) {
        for (int i = 0; i < box->count; i++)
            try_triangle(tree, tree->order[box->first + i], p, search);
        return;
    }
    double left = squared_to_box(&tree->box[box->left], p);
    bool right_first = squared_to_box(&tree->box[box->left + 1], p) < left;
    search_box(tree, box->left + right_first, p, search);
    search_box(tree, box->left + !right_first, p, search);
}

double mesh_distance(const struct mesh_tree *tree, const double p[3])
{
    struct search search = {.squared = DBL_MAX};
    search_box(tree, 0, p, &search);
    bool inside = dot(search.aside, tree->normal[search.triangle][search.feature]) < 0.0;
    return inside ? -sqrt(search.squared) : sqrt(search.squared);
}
