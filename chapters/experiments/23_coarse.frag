// The elephant from fewer points of its grid: every third, or the fraction that 'every' sets.
#include "main.glsl"
#include "stored.glsl"

uniform int every; // 3 in [1, 9]: along each axis, one point in this many is used

// storedDistance of a coarser grid.
float coarseDistance(sampler3D grid, vec3 p)
{
    vec3 q = clamp(p, -1.0, 1.0), place = (0.5 + 0.5 * q) * float(STORED_SIDE - 1) / float(every);
    ivec3 low = clamp(ivec3(floor(place)), ivec3(0), ivec3((STORED_SIDE - 1) / every - 1));
    vec4 plane[2];
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 4; i++)
            plane[k][i] = storedValue(grid, every * (low + ivec3(i % 2, i / 2, k)));
    float value = trilinear(StoredCell(plane[0], plane[1], clamp(place - vec3(low), 0.0, 1.0)));
    float outside = length(p - q);
    return outside > 0.0 ? length(vec2(outside, value)) : value;
}

#define storedDistance coarseDistance
#include "23_stored_distances.frag"
