#include "mesh_obj.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"

enum {
    LINE = 65536,  // bytes of the buffer for a line
    MOST = 1000000 // triangles
};

// ---- Reading ----

static bool add_vertex(struct triangles *to, const char *c)
{
    double p[3];
    for (int i = 0; i < 3; i++) {
        char *end;
        p[i] = strtod(c, &end);
        if (end == c || !(fabs(p[i]) <= 1e9))
            return false;
        c = end;
    }
    to->vertex = memory_row(to->vertex, to->vertices, sizeof *to->vertex);
    memcpy(to->vertex[to->vertices++], p, sizeof p);
    return true;
}

static bool add_face(struct triangles *to, const char *c)
{
    int fan[3] = {0}, corners = 0;
    for (char *end; corners <= LINE; c = end + strcspn(end, " \t\r\n")) {
        long index = strtol(c, &end, 10);
        if (end == c)
            break;
        index += index < 0 ? to->vertices : -1;
        if (index < 0 || index >= to->vertices)
            return false;
        fan[corners < 2 ? corners : 2] = (int)index;
        if (++corners < 3)
            continue;
        to->corner = memory_row(to->corner, to->count, sizeof *to->corner);
        memcpy(to->corner[to->count++], fan, sizeof fan);
        fan[1] = fan[2];
    }
    return corners >= 3;
}

// ---- Checking that a mesh is closed ----

struct edge {
    int low, high; // its vertices, low < high
    int up;        // 1 if the triangle traverses it from low to high, otherwise -1
};

static int by_vertices(const void *one, const void *other)
{
    const struct edge *a = one, *b = other;
    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    return (a->high > b->high) - (a->high < b->high);
}

static bool is_closed(const struct triangles *mesh)
{
    int count = 3 * mesh->count;
    struct edge *edge = memory_zeros((size_t)count, sizeof *edge);
    for (int i = 0; i < count; i++) {
        int from = mesh->corner[i / 3][i % 3], to = mesh->corner[i / 3][(i + 1) % 3];
        edge[i] = (struct edge){from < to ? from : to, from < to ? to : from, from < to ? 1 : -1};
    }
    qsort(edge, (size_t)count, sizeof *edge, by_vertices);
    bool closed = count % 2 == 0;
    for (int i = 0; closed && i < count; i += 2)
        closed = by_vertices(&edge[i], &edge[i + 1]) == 0 && edge[i].up + edge[i + 1].up == 0 &&
                 (i + 2 == count || by_vertices(&edge[i], &edge[i + 2]) != 0);
    free(edge);
    return closed;
}

// True if a triangle has an area: mesh_nearest needs corners that are not on one line.
static bool has_area(const double a[3], const double b[3], const double c[3])
{
    double ab = 0.0, ac = 0.0, both = 0.0;
    for (int i = 0; i < 3; i++) {
        ab += (b[i] - a[i]) * (b[i] - a[i]);
        ac += (c[i] - a[i]) * (c[i] - a[i]);
        both += (b[i] - a[i]) * (c[i] - a[i]);
    }
    return ab * ac - both * both > 1e-14 * ab * ac;
}

// Return what follows the letter with which a line begins, or NULL if the line begins otherwise.
static const char *behind(const char *line, char letter)
{
    line += strspn(line, " \t");
    return line[0] == letter && (line[1] == ' ' || line[1] == '\t') ? line + 2 : NULL;
}

const char *mesh_read_obj(FILE *file, struct triangles *triangles)
{
    static char line[LINE];
    *triangles = (struct triangles){0};
    while (fgets(line, sizeof line, file) != NULL) {
        const char *vertex = behind(line, 'v'), *face = behind(line, 'f');
        if (strpbrk(line, "\r\n") == NULL && feof(file) == 0)
            return "a line contains a zero byte or is longer than 64 kB: is this an OBJ file?";
        if (vertex != NULL && !add_vertex(triangles, vertex))
            return "a vertex needs three numbers from -1e9 to 1e9";
        if (face != NULL && !add_face(triangles, face))
            return "a face needs at least three indices of vertices that precede it";
        if (triangles->count > MOST || triangles->vertices > 3 * MOST)
            return "the mesh has more than a million triangles or three million vertices";
    }
    if (ferror(file) != 0)
        return "the file cannot be read";
    if (triangles->count == 0)
        return "the file has no faces";
    for (int i = 0; i < triangles->count; i++) {
        const int *corner = triangles->corner[i];
        if (!has_area(triangles->vertex[corner[0]], triangles->vertex[corner[1]],
                      triangles->vertex[corner[2]]))
            return "a triangle has no area";
    }
    return is_closed(triangles) ? NULL
                                : "the mesh is not closed: an edge does not belong to two faces "
                                  "that traverse it in opposite directions";
}

// ---- Fitting ----

// Six times the volume: the sum of the determinants of the corners of all triangles.
static double volume(const struct triangles *mesh)
{
    double sum = 0.0;
    for (int i = 0; i < mesh->count; i++) {
        const double *a = mesh->vertex[mesh->corner[i][0]], *b = mesh->vertex[mesh->corner[i][1]],
                     *c = mesh->vertex[mesh->corner[i][2]];
        for (int k = 0; k < 3; k++) {
            int m = (k + 1) % 3, n = (k + 2) % 3;
            sum += a[k] * (b[m] * c[n] - b[n] * c[m]);
        }
    }
    return sum;
}

void mesh_fit(struct triangles *triangles, const double low[3], const double high[3])
{
    double least[3], most[3], scale = HUGE_VAL;
    for (int i = 0; i < 3; i++) {
        least[i] = HUGE_VAL;
        most[i] = -HUGE_VAL;
        for (int k = 0; k < 3 * triangles->count; k++) {
            double x = triangles->vertex[triangles->corner[k / 3][k % 3]][i];
            least[i] = fmin(least[i], x);
            most[i] = fmax(most[i], x);
        }
        scale = fmin(scale, (high[i] - low[i]) / (most[i] - least[i]));
    }
    for (int k = 0; k < triangles->vertices; k++) {
        double *p = triangles->vertex[k];
        for (int i = 0; i < 3; i++) // along y, the mesh's lowest point is on the floor
            p[i] = i == 1 ? low[1] + scale * (p[1] - least[1])
                          : 0.5 * (low[i] + high[i]) + scale * (p[i] - 0.5 * (least[i] + most[i]));
    }
    bool inside_out = volume(triangles) < 0.0;
    for (int k = 0; inside_out && k < triangles->count; k++) {
        int *corner = triangles->corner[k], first = corner[0];
        corner[0] = corner[1];
        corner[1] = first;
    }
}
