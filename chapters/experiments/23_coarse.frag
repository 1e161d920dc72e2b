// Experiment of chapter 23: the elephant from fewer points of its grid, one in 'every' along each
// axis.
#include "main.glsl"
#include "23_cells.glsl"

uniform int every; // 3 in [1, 9]: along each axis, one point in this many is used

// storedDistance of a coarser grid.
float coarseDistance(sampler3D values, vec3 p)
{
    vec3 q = clamp(p, -1.0, 1.0);
    float value = trilinear(longCell(values, q, every)), outside = length(p - q);
    return outside > 0.0 ? length(vec2(outside, value)) : value;
}

#define storedDistance coarseDistance
#include "23_stored_distances.frag"
