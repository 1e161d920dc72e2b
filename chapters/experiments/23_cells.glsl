// 23_cells.glsl - longer cells of the grid of chapter 23, for 23_bricks.frag and 23_coarse.frag.
#include "stored.glsl"

// storedCell for cells that are 'every' times as long.
//   q  in the cube from -1 to 1
StoredCell longCell(sampler3D values, vec3 q, int every)
{
    vec3 position = (0.5 + 0.5 * q) * float(STORED_SIDE - 1) / float(every);
    ivec3 low = clamp(ivec3(floor(position)), ivec3(0), ivec3((STORED_SIDE - 1) / every - 1));
    vec4 plane[2];
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 4; i++)
            plane[k][i] = storedValue(values, every * (low + ivec3(i % 2, i / 2, k)));
    return StoredCell(plane[0], plane[1], clamp(position - vec3(low), 0.0, 1.0));
}
