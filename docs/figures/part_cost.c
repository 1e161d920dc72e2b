// part_cost.c - the mean number of parts that are evaluated for a ray, against the number of parts
// in the scene, for four methods. With any argument, the program prints the means as a table.
#include <stdio.h>
#include <stdlib.h>

#include "lib/part_march.h"
#include "svg.h"

enum { SIZES = 8 };

static double mean[PARTS_MEANS][SIZES][2];

static bool measure(void)
{
    for (int i = 0; i < SIZES; i++) {
        struct part_scene *heap = part_scene_build(part_heap, 64 << i, part_heap_blend(64 << i));
        if (heap == NULL)
            return false;
        for (int means = 0; means < PARTS_MEANS; means++) {
            int hits;
            mean[means][i][0] = 64 << i;
            mean[means][i][1] = part_heap_asked(heap, (enum part_means)means, &hits);
        }
        part_scene_free(heap);
    }
    return true;
}

static void print(void)
{
    puts("| parts | flat | tree | tree with a bound | grid |\n| --- | --- | --- | --- | --- |");
    for (int i = 0; i < SIZES; i++)
        printf("| %d | %.0f | %.0f | %.0f | %.0f |\n", 64 << i, mean[PARTS_FLAT][i][1],
               mean[PARTS_TREE][i][1], mean[PARTS_BOUNDED][i][1], mean[PARTS_GRID][i][1]);
}

static void draw(void)
{
    static const char *const colour[PARTS_MEANS] = {SVG_ORANGE, SVG_PALE, SVG_BLUE, SVG_TEAL};
    static const char *const name[PARTS_MEANS] = {"flat loop", "tree", "tree with a bound",
                                                  "grid of lists"};
    const struct svg_plot plot = {90.0, 40.0, 480.0, 300.0, {10.0, 10000.0}, {1.0, 1000000.0},
                                  true, true};
    svg_begin(760.0, 410.0, "The cost of a scene against its number of parts",
              "A plot with logarithmic axes from 64 to 8,192 parts. The number of parts evaluated "
              "for a ray grows in proportion to the number of parts in the scene with a flat loop, "
              "more slowly with a tree, and hardly at all with a grid of lists.");
    svg_plot_frame(&plot, 0.0, 0.0, "parts in the scene", "parts evaluated for a ray");
    for (int means = 0; means < PARTS_MEANS; means++) {
        svg_plot_curve(&plot, SIZES, (const double(*)[2])mean[means],
                       (struct svg_pen){.stroke = colour[means], .width = 2.4});
        for (int i = 0; i < SIZES; i++)
            svg_circle(svg_plot_x(&plot, mean[means][i][0]), svg_plot_y(&plot, mean[means][i][1]),
                       3.5, (struct svg_pen){.fill = colour[means]});
        svg_text(580.0, svg_plot_y(&plot, mean[means][SIZES - 1][1]) + 4.0, 'l', 14.0,
                 means == PARTS_TREE ? SVG_INK : colour[means], name[means]);
    }
    svg_end();
}

int main(int argc, char **argv)
{
    (void)argv;
    if (!measure()) {
        fputs("part_cost: not enough memory\n", stderr);
        return EXIT_FAILURE;
    }
    if (argc > 1)
        print();
    else
        draw();
    return EXIT_SUCCESS;
}
