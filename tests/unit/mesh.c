// mesh.c - tests mesh.c, mesh_distance.c, mesh_obj.c, elephant.c and sweep.c of shaders/textures:
// the distance to the clay elephant's mesh is compared with the distances to all triangles, and its
// sign with the solid angle that the whole mesh subtends. Other tests check the sign at a sharp
// corner, distances that are restored by sweeping, and meshes from files.
#include "lib/test.h"

#include "textures/elephant.h"
#include "textures/mesh_distance.h"
#include "textures/mesh_obj.h"
#include "textures/paint.h"
#include "textures/sweep.h"
#include "lib/mirror.h"
#include "memory.h"
#include "lib/system.h"

enum { POINTS = 10000 };

static struct d3 vertex_of(const struct triangles *t, int triangle, int k)
{
    const double *v = t->vertex[t->corner[triangle][k]];
    return d3(v[0], v[1], v[2]);
}

static double random_in(double low, double high, int i, uint32_t seed)
{
    return low + (high - low) * paint_random(i, 0, seed);
}

// A random point. Every other point is near the surface, where a wrong sign would be visible.
static struct d3 point_of(const struct triangles *t, int i)
{
    struct d3 p =
        d3(random_in(-1.0, 1.0, i, 1), random_in(-1.0, 1.0, i, 2), random_in(-1.0, 1.0, i, 3));
    if (i % 2 == 0)
        return p;
    struct d3 at = vertex_of(t, (int)(paint_hash(i, 0, 4) % (uint32_t)t->count), i % 3);
    return d3_add(at, d3_times(0.02, p));
}

// ---- Reference distances ----

static double to_segment(struct d3 p, struct d3 a, struct d3 b)
{
    struct d3 ab = d3_sub(b, a);
    double share = d3_dot(d3_sub(p, a), ab) / d3_dot(ab, ab);
    return d3_length(d3_sub(p, d3_add(a, d3_times(fmin(fmax(share, 0.0), 1.0), ab))));
}

// The distance to a triangle: the distance to its plane if p is on the inner side of all three
// edges, otherwise the distance to the nearest edge.
static double to_triangle(struct d3 p, const struct d3 v[3])
{
    struct d3 normal = d3_cross(d3_sub(v[1], v[0]), d3_sub(v[2], v[0]));
    double edge = INFINITY;
    bool above = true;
    for (int k = 0; k < 3; k++) {
        struct d3 a = v[k], b = v[(k + 1) % 3];
        above = above && d3_dot(d3_cross(normal, d3_sub(b, a)), d3_sub(p, a)) >= 0.0;
        edge = fmin(edge, to_segment(p, a, b));
    }
    return above ? fabs(d3_dot(normal, d3_sub(p, v[0]))) / d3_length(normal) : edge;
}

// The signed solid angle that a triangle subtends at p. Source: A. van Oosterom, J. Strackee, IEEE
// Transactions on Biomedical Engineering 30 (1983).
static double solid_angle(struct d3 p, const struct d3 v[3])
{
    struct d3 a = d3_sub(v[0], p), b = d3_sub(v[1], p), c = d3_sub(v[2], p);
    double la = d3_length(a), lb = d3_length(b), lc = d3_length(c);
    double under = la * lb * lc + d3_dot(a, b) * lc + d3_dot(b, c) * la + d3_dot(c, a) * lb;
    return 2.0 * atan2(d3_dot(a, d3_cross(b, c)), under);
}

// The signed distance to the mesh, from the distance to each triangle. p is inside if the triangles
// subtend the whole sphere of directions.
static double true_distance(const struct triangles *t, struct d3 p)
{
    double least = INFINITY, angle = 0.0;
    for (int i = 0; i < t->count; i++) {
        const struct d3 v[3] = {vertex_of(t, i, 0), vertex_of(t, i, 1), vertex_of(t, i, 2)};
        least = fmin(least, to_triangle(p, v));
        angle += solid_angle(p, v);
    }
    return angle > 2.0 * MIRROR_PI ? -least : least;
}

// ---- The elephant ----

// Every distance is exact except for rounding errors, and no sign is wrong.
TEST(the_distance_is_the_distance_to_all_triangles)
{
    struct triangles t = elephant_mesh(2);
    struct mesh_tree tree = mesh_tree_build(&t);
    double worst = 0.0;
    int inside = 0;
    for (int i = 0; i < POINTS; i++) {
        struct d3 p = point_of(&t, i);
        double d = mesh_distance(&tree, (const double[3]){p.x, p.y, p.z}),
               truth = true_distance(&t, p);
        worst = fmax(worst, fabs(d - truth));
        inside += truth < 0.0;
    }
    print_message("# %d triangles; %d points, of which %d are inside; largest error %.2g\n",
                  t.count, POINTS, inside, worst);
    assert_true(worst < 1e-12);
    assert_in_range(inside, POINTS / 10, POINTS / 2);
    mesh_tree_free(&tree);
    triangles_free(&t);
}

// Each edge belongs to two triangles, which traverse it in opposite directions, and V - E + F = 2,
// as for a sphere.
TEST(the_mesh_is_closed)
{
    for (int steps = 0; steps < 3; steps++) {
        struct triangles t = elephant_mesh(steps);
        int *next = memory_zeros((size_t)t.vertices * 16, sizeof *next);
        for (int i = 0; i < 3 * t.count; i++) {
            int from = t.corner[i / 3][i % 3], to = t.corner[i / 3][(i + 1) % 3], k = 0;
            while (next[16 * from + k] != 0)
                assert_int_not_equal(next[16 * from + k++], to + 1);
            next[16 * from + k] = to + 1;
        }
        for (int i = 0; i < 3 * t.count; i++) {
            int from = t.corner[i / 3][i % 3], to = t.corner[i / 3][(i + 1) % 3], found = 0;
            for (int k = 0; k < 16; k++)
                found += next[16 * to + k] == from + 1;
            assert_int_equal(found, 1);
        }
        assert_int_equal(t.vertices - t.count / 2, 2);
        for (int i = 0; steps > 1 && i < 3 * t.vertices; i++) // the grid must contain the mesh
            assert_true(fabs(t.vertex[i / 3][i % 3]) < 1.0 - 2.0 / (ELEPHANT_SIDE - 1));
        free(next);
        triangles_free(&t);
    }
}

// The two bytes store the representable value nearest to a distance. A distance outside the range
// is stored as the nearer end of the range.
TEST(two_bytes_store_a_distance)
{
    for (int i = 0; i < POINTS; i++) {
        double d = random_in(-1.2, 1.2, i, 9),
               kept = fmin(fmax(d, -ELEPHANT_RANGE), ELEPHANT_RANGE);
        unsigned char byte[2];
        elephant_encode(d, byte);
        double read = (2.0 * (256.0 * byte[0] + byte[1]) / 65535.0 - 1.0) * ELEPHANT_RANGE;
        assert_true(fabs(read - kept) <= ELEPHANT_RANGE / 65535.0 + 1e-12);
    }
}

// The square of the distance to a box of the tree.
static double squared_to(const struct mesh_box *box, struct d3 p)
{
    double sum = 0.0;
    for (int k = 0; k < 3; k++) {
        const double *axis = box->axis[k];
        double x = d3_dot(p, d3(axis[0], axis[1], axis[2]));
        double outside = fmax(fmax(box->low[k] - x, x - box->high[k]), 0.0);
        sum += outside * outside;
    }
    return sum;
}

// Two cones of 2,000 long, thin triangles each, which share their base. Few of the tree's boxes may
// be nearer than the surface, or a search would try them all.
TEST(a_fan_is_searched_fast)
{
    enum { RIM = 2000, FEW = 200 };
    static double vertex[RIM + 2][3] = {{0.0, 0.8, 0.0}, {0.0, -0.8, 0.0}};
    static int corner[2 * RIM][3];
    for (int i = 0; i < RIM; i++) {
        double angle = 2.0 * MIRROR_PI * i / RIM;
        vertex[i + 2][0] = 0.8 * cos(angle);
        vertex[i + 2][1] = 0.0;
        vertex[i + 2][2] = 0.8 * sin(angle);
        int here = i + 2, next = (i + 1) % RIM + 2;
        memcpy(corner[2 * i], (const int[3]){0, next, here}, sizeof corner[0]);
        memcpy(corner[2 * i + 1], (const int[3]){1, here, next}, sizeof corner[0]);
    }
    const struct triangles t = {vertex, RIM + 2, corner, 2 * RIM};
    struct mesh_tree tree = mesh_tree_build(&t);
    double nearer = 0.0;
    for (int i = 0; i < FEW; i++) {
        struct d3 p = d3(random_in(-1, 1, i, 50), random_in(-1, 1, i, 51), random_in(-1, 1, i, 52));
        double d = mesh_distance(&tree, (const double[3]){p.x, p.y, p.z});
        assert_true(fabs(d - true_distance(&t, p)) < 1e-12);
        for (int k = 0; k < tree.boxes; k++)
            nearer += squared_to(&tree.box[k], p) < d * d - 1e-9;
    }
    nearer /= FEW;
    print_message("# of %d boxes, %.1f are nearer than the surface on average\n", tree.boxes,
                  nearer);
    assert_true(nearer < 60.0);
    mesh_tree_free(&tree);
}

// ---- Normals ----

TEST(angles_agree_with_atan2)
{
    for (int i = 0; i < POINTS; i++) {
        double a[3], b[3];
        for (uint32_t k = 0; k < 3; k++) {
            a[k] = random_in(-1.0, 1.0, i, 20 + k);
            b[k] = random_in(-1.0, 1.0, i, 30 + k) + (i % 2 == 0 ? 0.0 : 20.0 * a[k]);
        }
        struct d3 u = d3(a[0], a[1], a[2]), v = d3(b[0], b[1], b[2]);
        assert_true(fabs(mesh_angle(a, b) - atan2(d3_length(d3_cross(u, v)), d3_dot(u, v))) <
                    1e-12);
    }
    assert_true(fabs(mesh_angle((const double[3]){1, 0, 0}, (const double[3]){-3, 0, 0}) -
                     MIRROR_PI) < 1e-12);
}

// Near the tip of a spike, the normal of a single face, or the unweighted sum of the normals of the
// faces around the tip, would give the wrong sign for many points that are outside.
TEST(a_sharp_corner_has_the_right_sign)
{
    static double vertex[5][3] = {
        {0, 2, 0}, {1, 0, 0}, {-0.4, 0, 0.1}, {-0.5, 0, 0.0}, {-0.4, 0, -0.1}};
    static int corner[6][3] = {{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 1, 4}, {1, 2, 3}, {1, 3, 4}};
    const struct triangles t = {.vertex = vertex, .vertices = 5, .corner = corner, .count = 6};
    struct mesh_tree tree = mesh_tree_build(&t);
    int near_tip = 0, by_face = 0, by_sum = 0;
    for (int i = 0; i < POINTS; i++) {
        struct d3 aside =
            d3(random_in(-1, 1, i, 40), random_in(-1, 1, i, 41), random_in(-1, 1, i, 42));
        struct d3 p = d3_add(d3(0, 2, 0), d3_times(0.2, aside));
        double truth = true_distance(&t, p),
               d = mesh_distance(&tree, (const double[3]){p.x, p.y, p.z});
        assert_true(fabs(d - truth) < 1e-12);
        if (truth < 0.0 || fabs(truth - 0.2 * d3_length(aside)) > 1e-9)
            continue;
        struct d3 sum = d3(0, 0, 0);
        for (int k = 0; k < 4; k++) {
            const double *n = tree.normal[k][MESH_FACE];
            sum = d3_add(sum, d3(n[0], n[1], n[2]));
            by_face += d3_dot(aside, d3(n[0], n[1], n[2])) < 0.0;
        }
        by_sum += d3_dot(aside, sum) < 0.0;
        near_tip++;
    }
    print_message("# %d points are nearest to the tip; the normal of a face is wrong in %d of %d "
                  "cases, the unweighted sum in %d\n",
                  near_tip, by_face, 4 * near_tip, by_sum);
    assert_true(near_tip > 100 && by_face > near_tip / 10);
    mesh_tree_free(&tree);
}

// ---- Distances restored by sweeping ----

// Distort the distances to a ball on a grid with side points on each axis, restore them by
// sweeping, and return the largest error in cells.
static double swept_error(int side)
{
    double *value = memory_zeros((size_t)side * (size_t)side * (size_t)side, sizeof *value);
    double cell = 2.0 / (side - 1), worst = 0.0;
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < side * side * side; i++) {
            double x = cell * (i % side) - 1.0, y = cell * (i / side % side) - 1.0;
            double z = cell * (i / side / side) - 1.0, d = sqrt(x * x + y * y + z * z) - 0.6;
            if (pass == 0)
                value[i] = d * (3.0 + x);
            else
                worst = fmax(worst, fabs(value[i] - d) / cell);
        }
        if (pass == 0)
            sweep_distances(value, NULL, (const int[]){side, side, side}, cell);
    }
    free(value);
    return worst;
}

// The error is less than a cell on the coarsest grid, and grows by no more than the logarithm of
// the ratio of the grids' sides.
TEST(sweeping_restores_distances)
{
    double coarse = swept_error(16), middle = swept_error(32), fine = swept_error(64);
    print_message(
        "# largest error in cells: %.3f with 16 points on each axis, %.3f with 32, %.3f with 64\n",
        coarse, middle, fine);
    assert_true(coarse < 1.0 && fine < 1.0 + log(4.0));
    assert_true(fine < coarse + log(4.0));
}

// The distances to a plane are restored exactly from values that are five times as large.
TEST(sweeping_restores_a_plane_exactly)
{
    enum { FEW = 12 };
    double value[FEW * FEW * FEW];
    for (int i = 0; i < FEW * FEW * FEW; i++)
        value[i] = 5.0 * (i % FEW - 4.3);
    sweep_distances(value, NULL, (const int[]){FEW, FEW, FEW}, 1.0);
    for (int i = 0; i < FEW * FEW * FEW; i++)
        assert_true(fabs(value[i] - (i % FEW - 4.3)) < 1e-12);
}

// ---- Meshes from files ----

static const char *read_text(const char *text, struct triangles *triangles)
{
    FILE *file = system_open_scratch();
    fputs(text, file);
    rewind(file);
    const char *why = mesh_read_obj(file, triangles);
    fclose(file);
    return why;
}

// The same mesh with tabs, and with lines that begin with blanks.
static const char indented[] = "\tv\t1\t1\t1\n  v 1 -1 -1\n v -1 1 -1\n\t v -1 -1 1\r\n"
                               "  f\t1\t2\t3\nf  1 3 4\n\tf 1 4 2\n f\t2 4 3";

static const char tetrahedron[] = "# a comment\nv 1 1 1\nv 1 -1 -1\nv -1 1 -1 1.0\r\nv -1 -1 1\n"
                                  "vn 0 0 1\nf 1/1/1 2//1 3\nf 1 3 4\nf -4 -1 -3\nf 2 4 3\n";

// The elephant's mesh is written with four corners per face, and read back.
TEST(an_obj_file_gives_the_mesh_that_was_written)
{
    struct triangles t = elephant_mesh(1), read;
    FILE *file = system_open_scratch();
    for (int i = 0; i < t.vertices; i++)
        fprintf(file, "v %.17g %.17g %.17g\n", t.vertex[i][0], t.vertex[i][1], t.vertex[i][2]);
    for (int i = 0; i < t.count; i += 2) { // the two triangles of a face share a diagonal
        const int *a = t.corner[i], *b = t.corner[i + 1];
        int lone = 0, k = 0; // corner of b that a lacks, and corner of a that b lacks
        while (b[lone] == a[0] || b[lone] == a[1] || b[lone] == a[2])
            lone++;
        while (a[k] == b[0] || a[k] == b[1] || a[k] == b[2])
            k++;
        fprintf(file, "f %d %d %d %d\n", b[(lone + 2) % 3] + 1, b[lone] + 1, b[(lone + 1) % 3] + 1,
                a[k] + 1);
    }
    rewind(file);
    assert_null(mesh_read_obj(file, &read));
    fclose(file);
    assert_int_equal(read.count, t.count);
    assert_memory_equal(read.vertex, t.vertex, (size_t)t.vertices * sizeof *t.vertex);
    struct mesh_tree tree = mesh_tree_build(&t), other = mesh_tree_build(&read);
    for (int i = 0; i < 100; i++) {
        struct d3 p = point_of(&t, 2 * i);
        const double q[3] = {p.x, p.y, p.z};
        assert_true(fabs(mesh_distance(&tree, q) - mesh_distance(&other, q)) < 1e-12);
    }
    mesh_tree_free(&tree);
    mesh_tree_free(&other);
    triangles_free(&t);
    triangles_free(&read);
}

// The file has several forms of indices. A mesh that is inside out is reversed, and the mesh rests
// on the floor of its box.
TEST(a_mesh_fits_into_its_box)
{
    static const double low[3] = {-0.5, -0.4, -0.5}, high[3] = {0.5, 0.8, 0.5};
    for (int flip = 0; flip < 2; flip++) {
        struct triangles t;
        assert_null(read_text(flip == 0 ? tetrahedron : indented, &t));
        assert_int_equal(t.count, 4);
        for (int i = 0; flip == 1 && i < t.count; i++) {
            int *corner = t.corner[i], first = corner[0];
            corner[0] = corner[2];
            corner[2] = first;
        }
        mesh_fit(&t, low, high);
        struct mesh_tree tree = mesh_tree_build(&t);
        // The corners are four corners of a cube with sides of 1, with y from -0.4 to 0.6. A face
        // is a third as far from the cube's centre as a corner.
        assert_true(fabs(mesh_distance(&tree, (const double[3]){0.0, 0.1, 0.0}) +
                         sqrt(0.75) / 3.0) < 1e-12);
        assert_true(fabs(mesh_distance(&tree, (const double[3]){0.5, 0.6, 0.5})) < 1e-12);
        assert_true(fabs(mesh_distance(&tree, (const double[3]){0.5, -1.4, -0.5}) - 1.0) < 1e-12);
        mesh_tree_free(&tree);
        triangles_free(&t);
    }
}

TEST(files_that_are_not_meshes_are_refused)
{
    static const char *const refused[][2] = {
        {"", "no faces"},
        {"v1 2 3\nface\nvt\t1 2\n", "no faces"},
        {"v\t1 2\n", "three numbers"},
        {"v 1 2\n", "three numbers"},
        {"v 1 2 nan\n", "three numbers"},
        {"v 1 2 3\nf 1 1\n", "three indices"},
        {"v 1 2 3\nf 1 1 2\n", "precede"},
        {"v 1 2 3\nf -1 -1 -2\n", "precede"},
        {"v 1 2 3\nf 0 1 1\n", "precede"},
        {"v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n", "no area"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "not closed"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 3\n", "not closed"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\nf 1 2 3\nf 3 2 1\n", "not closed"},
    };
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
        struct triangles t;
        const char *why = read_text(refused[i][0], &t);
        assert_non_null(why);
        assert_non_null(why != NULL ? strstr(why, refused[i][1]) : NULL);
        triangles_free(&t);
    }
}

// A line that never ends, or that only contains zero bytes, may be as long as a disk.
TEST(a_line_without_an_end_is_refused)
{
    for (int byte = 0; byte <= 'x'; byte += 'x') {
        struct triangles t;
        FILE *file = system_open_scratch();
        for (int i = 0; i < 200000; i++)
            fputc(byte, file);
        rewind(file);
        const char *why = mesh_read_obj(file, &t);
        assert_non_null(why != NULL ? strstr(why, "zero byte or is longer") : NULL);
        fclose(file);
        triangles_free(&t);
    }
}

TESTS(NULL, NULL)
