// Experiment of chapter 23: a shell of bricks. A brick is a cube of 3 x 3 x 3 cells. Only the bricks near the surface
// keep all of their points; of the others, only the corners are read.
#include "main.glsl"
#include "23_cells.glsl"
#include "shadow.glsl"

uniform float nearby; // 4 in [3.5, 16] step 0.5, cells: distance from corner to surface below which a brick is kept

const int BRICK = 3; // cells along each side of a brick
bool marching = true; // true for the ray from the eye, which needs safe steps; the light needs the distance

// The smallest absolute value at the corners of a cell.
float smallestCorner(StoredCell cell)
{
    vec4 least = min(abs(cell.near), abs(cell.far));
    return min(min(least.x, least.y), min(least.z, least.w));
}

// A value for which storedStep returns |g| - 2 sqrt(3) STORED_CELL with the sign of g.
//   g  interpolated between the corners of a brick, scene units; |g| > 2 sqrt(3) STORED_CELL. g differs by at most
//      3 sqrt(3) / 2 cells from the distance, and the finer interpolation by sqrt(3) / 2 cells: together by 2 sqrt(3)
float coarseValue(float g)
{
    float size = abs(g);
    return sign(g) * min(size - 1.732 * STORED_CELL, (size - 3.465 * STORED_CELL) / 0.577);
}

// storedDistance, computed from only those values that the shell keeps.
float brickDistance(sampler3D values, vec3 p)
{
    vec3 q = clamp(p, -1.0, 1.0);
    StoredCell brick = longCell(values, q, BRICK);
    bool kept = smallestCorner(brick) < nearby * STORED_CELL;
    float coarse = trilinear(brick);
    float value = kept ? trilinear(storedCell(values, q)) : (marching ? coarseValue(coarse) : coarse);
    float outside = length(p - q);
    return outside > 0.0 ? length(vec2(outside, value)) : value;
}

// shadowRay, which also records that the march from the eye is over: all distances that the light needs are evaluated
// after this call.
Ray lightRay(vec3 p, vec3 normal, vec3 toLamp, float offset)
{
    marching = false;
    return shadowRay(p, normal, toLamp, offset);
}

#define storedDistance brickDistance
#define shadowRay lightRay
#include "23_stored_distances.frag"
