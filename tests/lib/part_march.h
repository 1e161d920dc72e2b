// part_march.h - marches through a scene of parts, in double precision, that count the parts that
// they evaluate.
#ifndef PART_MARCH_H
#define PART_MARCH_H

#include "textures/reef_parts.h"

enum { PARTS_WIDE = 24, PARTS_HIGH = 14, PART_RAYS = PARTS_WIDE * PARTS_HIGH };

// The methods of finding the parts that matter at a point.
enum part_means {
    PARTS_FLAT,    // every part is evaluated
    PARTS_TREE,    // a tree of boxes; a box is skipped if its parts cannot change the value
    PARTS_BOUNDED, // like PARTS_TREE, with an upper bound on the value from the last step
    PARTS_GRID,    // the parts of the ray's current cell; a step ends where the ray leaves the cell
    PARTS_MEANS
};

// A node of the tree. The nodes are stored in the order in which the tree is searched.
struct part_node {
    double low[3], high[3];
    int skip;         // the node that follows all nodes below this one
    int first, count; // the parts of a leaf; count is 0 if the node is not a leaf
};

struct part_scene {
    int count, nodes;
    double blend;
    struct part part[REEF_MOST]; // in the order of the tree
    struct part_node node[2 * REEF_MOST];
    struct part_grid grid;
};

// The width of the blends in a heap: a quarter of the largest radius.
double part_heap_blend(int count);

// Fill in a heap of count capsules in a dome of fixed size. The more capsules there are, the
// smaller they are, so the heap always looks much the same.
void part_heap(int count, struct part *part);

// Build a scene of count parts, with a tree and a grid. Returns NULL if there is not enough memory.
// Free the scene with part_scene_free.
//   build  reef_build or part_heap
struct part_scene *part_scene_build(void (*build)(int count, struct part *part), int count,
                                    double blend);
void part_scene_free(struct part_scene *scene);

// The distance from p to the scene, found with the tree.
//   hint   an upper bound on the distance; 1e9 if none is known
//   asked  increased by the number of parts that were evaluated
double part_tree_distance(const struct part_scene *scene, const double p[3], double hint,
                          long *asked);

struct part_ray {
    double origin[3], direction[3];
};

struct part_result {
    bool found;
    double t;
    long asked, steps;
};

struct part_result part_march(const struct part_scene *scene, enum part_means means,
                              const struct part_ray *ray);

// The ray through the position x, y, each in [0, 1], of a picture of the heap.
struct part_ray part_heap_ray(double x, double y);

// The mean number of parts that are evaluated per ray, over PART_RAYS rays of the heap's picture.
//   hits  receives the number of rays that meet the heap
double part_heap_asked(const struct part_scene *scene, enum part_means means, int *hits);

#endif
