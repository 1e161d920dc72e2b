#include "mesh.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"

void mesh_free(struct mesh *mesh)
{
    free(mesh->vertex);
    free(mesh->face);
    *mesh = (struct mesh){0};
}

void triangles_free(struct triangles *triangles)
{
    free(triangles->vertex);
    free(triangles->corner);
    *triangles = (struct triangles){0};
}

// ---- From blocks to a cage ----

enum { CORNERS = MESH_CELLS + 1, LATTICE = CORNERS * CORNERS * CORNERS };

static int corner_of(const int cell[3], int dx, int dy, int dz)
{
    return (cell[0] + dx) + CORNERS * ((cell[1] + dy) + CORNERS * (cell[2] + dz));
}

static bool filled(const struct mesh_block *block, int count, const int cell[3])
{
    for (int i = 0; i < count; i++)
        if (memcmp(block[i].cell, cell, sizeof block[i].cell) == 0)
            return true;
    return false;
}

// Add the face of a block that faces along an axis, or against the axis if side is negative.
static void add_face(struct mesh *mesh, const int cell[3], int axis, int side)
{
    // The other two axes, ordered so that the corners are counter-clockwise as seen from outside.
    int u = (axis + (side > 0 ? 1 : 2)) % 3, v = (axis + (side > 0 ? 2 : 1)) % 3;
    int *face = mesh->face[mesh->faces++];
    for (int i = 0; i < 4; i++) {
        int d[3] = {0};
        d[axis] = side > 0;
        d[u] = i == 1 || i == 2;
        d[v] = i >= 2;
        face[i] = corner_of(cell, d[0], d[1], d[2]);
    }
}

// In the faces, replace the indices of the lattice's corners with those of vertices, and set the
// positions of the vertices.
static void place_vertices(struct mesh *mesh, const struct mesh_block *block, int count)
{
    double(*sum)[4] = memory_zeros(LATTICE, sizeof *sum);
    int *name = memory_zeros(LATTICE, sizeof *name);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 8; k++) {
            int d[3] = {k & 1, k >> 1 & 1, k >> 2};
            double *at = sum[corner_of(block[i].cell, d[0], d[1], d[2])];
            for (int a = 0; a < 3; a++)
                at[a] += block[i].centre[a] + (2 * d[a] - 1) * block[i].half[a];
            at[3] += 1.0;
        }
    mesh->vertex = memory_zeros(4 * (size_t)mesh->faces, sizeof *mesh->vertex);
    for (int i = 0; i < mesh->faces; i++)
        for (int k = 0; k < 4; k++) {
            int corner = mesh->face[i][k];
            if (name[corner] == 0) {
                for (int a = 0; a < 3; a++)
                    mesh->vertex[mesh->vertices][a] = sum[corner][a] / sum[corner][3];
                name[corner] = ++mesh->vertices;
            }
            mesh->face[i][k] = name[corner] - 1;
        }
    free(sum);
    free(name);
}

struct mesh mesh_of_blocks(const struct mesh_block *block, int count)
{
    struct mesh mesh = {.face = memory_zeros(6 * (size_t)count, sizeof *mesh.face)};
    for (int i = 0; i < count; i++)
        for (int axis = 0; axis < 3; axis++)
            for (int side = -1; side <= 1; side += 2) {
                int beside[3] = {block[i].cell[0], block[i].cell[1], block[i].cell[2]};
                beside[axis] += side;
                if (!filled(block, count, beside))
                    add_face(&mesh, block[i].cell, axis, side);
            }
    place_vertices(&mesh, block, count);
    return mesh;
}

// ---- Subdivision ----

// The edges of a mesh. of[i][k] is the index of the edge from corner k to corner k + 1 of face i;
// end[e] contains the vertices of edge e, the lower index first.
struct edges {
    int (*of)[4];
    int (*end)[2];
    int count;
};

// The edges that begin at a vertex form a list, linked through next.
static struct edges find_edges(const struct mesh *mesh)
{
    size_t sides = 4 * (size_t)mesh->faces;
    struct edges edges = {.of = memory_zeros((size_t)mesh->faces, sizeof *edges.of),
                          .end = memory_zeros(sides, sizeof *edges.end)};
    int *first = memory_zeros((size_t)mesh->vertices, sizeof *first);
    int *next = memory_zeros(sides, sizeof *next);
    for (int i = 0; i < mesh->faces; i++)
        for (int k = 0; k < 4; k++) {
            int a = mesh->face[i][k], b = mesh->face[i][(k + 1) % 4];
            int low = a < b ? a : b, high = a < b ? b : a, edge = first[low];
            while (edge > 0 && edges.end[edge - 1][1] != high)
                edge = next[edge - 1];
            if (edge == 0) {
                edges.end[edges.count][0] = low;
                edges.end[edges.count][1] = high;
                next[edges.count] = first[low];
                edge = first[low] = ++edges.count;
            }
            edges.of[i][k] = edge - 1;
        }
    free(first);
    free(next);
    return edges;
}

// Add a share of one point to another.
static void add(double to[3], const double from[3], double share)
{
    for (int a = 0; a < 3; a++)
        to[a] += share * from[a];
}

// Set the points of edges and faces. The points of the edges follow the vertices; those of the
// faces come last.
static void place_points(struct mesh *fine, const struct mesh *mesh, const struct edges *edges)
{
    double(*edge)[3] = fine->vertex + mesh->vertices, (*face)[3] = edge + edges->count;
    for (int i = 0; i < edges->count; i++)
        for (int k = 0; k < 2; k++)
            add(edge[i], mesh->vertex[edges->end[i][k]], 0.25);
    for (int i = 0; i < mesh->faces; i++) {
        for (int k = 0; k < 4; k++)
            add(face[i], mesh->vertex[mesh->face[i][k]], 0.25);
        for (int k = 0; k < 4; k++)
            add(edge[edges->of[i][k]], face[i], 0.25);
    }
}

// Move the vertices, with the formula of mesh_subdivide.
static void move_vertices(struct mesh *fine, const struct mesh *mesh, const struct edges *edges)
{
    int *faces = memory_zeros((size_t)mesh->vertices, sizeof *faces);
    for (int i = 0; i < mesh->faces; i++)
        for (int k = 0; k < 4; k++)
            faces[mesh->face[i][k]]++;
    for (int i = 0; i < mesh->vertices; i++)
        add(fine->vertex[i], mesh->vertex[i], (faces[i] - 3.0) / faces[i]);
    const double(*point)[3] = (const double(*)[3])fine->vertex + mesh->vertices + edges->count;
    for (int i = 0; i < mesh->faces; i++)
        for (int k = 0; k < 4; k++) {
            int vertex = mesh->face[i][k];
            add(fine->vertex[vertex], point[i], 1.0 / ((double)faces[vertex] * faces[vertex]));
        }
    for (int i = 0; i < edges->count; i++)
        for (int k = 0; k < 2; k++) {
            int vertex = edges->end[i][k], other = edges->end[i][1 - k];
            double share = 1.0 / ((double)faces[vertex] * faces[vertex]);
            add(fine->vertex[vertex], mesh->vertex[vertex], share);
            add(fine->vertex[vertex], mesh->vertex[other], share);
        }
    free(faces);
}

struct mesh mesh_subdivide(const struct mesh *mesh)
{
    struct edges edges = find_edges(mesh);
    int first_edge = mesh->vertices, first_face = first_edge + edges.count;
    struct mesh fine = {.vertices = first_face + mesh->faces, .faces = 4 * mesh->faces};
    fine.vertex = memory_zeros((size_t)fine.vertices, sizeof *fine.vertex);
    fine.face = memory_zeros((size_t)fine.faces, sizeof *fine.face);
    place_points(&fine, mesh, &edges);
    move_vertices(&fine, mesh, &edges);
    for (int i = 0; i < mesh->faces; i++)
        for (int k = 0; k < 4; k++) {
            int *face = fine.face[4 * i + k];
            face[0] = mesh->face[i][k];
            face[1] = first_edge + edges.of[i][k];
            face[2] = first_face + i;
            face[3] = first_edge + edges.of[i][(k + 3) % 4];
        }
    free(edges.of);
    free(edges.end);
    return fine;
}

// ---- Triangles ----

static double squared_length(const double a[3], const double b[3])
{
    double sum = 0.0;
    for (int i = 0; i < 3; i++)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
}

struct triangles mesh_triangles(const struct mesh *mesh)
{
    struct triangles triangles = {.vertices = mesh->vertices, .count = 2 * mesh->faces};
    size_t bytes = (size_t)mesh->vertices * sizeof *mesh->vertex;
    triangles.vertex = memory_zeros((size_t)mesh->vertices, sizeof *triangles.vertex);
    triangles.corner = memory_zeros((size_t)triangles.count, sizeof *triangles.corner);
    memcpy(triangles.vertex, mesh->vertex, bytes);
    for (int i = 0; i < mesh->faces; i++) {
        const int *face = mesh->face[i];
        int first = squared_length(mesh->vertex[face[0]], mesh->vertex[face[2]]) <=
                            squared_length(mesh->vertex[face[1]], mesh->vertex[face[3]])
                        ? 0
                        : 1;
        for (int k = 0; k < 2; k++) {
            int *corner = triangles.corner[2 * i + k];
            corner[0] = face[first];
            corner[1] = face[(first + 1 + k) % 4];
            corner[2] = face[(first + 2 + k) % 4];
        }
    }
    return triangles;
}
