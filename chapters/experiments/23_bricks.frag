// Experiment of chapter 23: a shell of bricks. A brick is a cube of 3 x 3 x 3 cells. Only the bricks near the surface
// keep all of their points; of the others, only the corners are read.
#include "main.glsl"
#include "stored.glsl"
#include "shadow.glsl"

uniform bool shell;   // true: reads only what a shell of bricks keeps; false: the whole grid
uniform float nearby; // 4 in [3.47, 16] step 0.5, cells: a brick is kept if the value at one of its corners is smaller

const int BRICK = 3; // cells along each side of a brick
bool marching = true; // whether the ray from the eye still needs safe steps; light needs the distance

// The cell of a point q of the cube among cells that are 'side' times as long.
StoredCell cellOfSide(sampler3D values, vec3 q, int side)
{
    vec3 place = (0.5 + 0.5 * q) * float((STORED_SIDE - 1) / side);
    ivec3 low = clamp(ivec3(floor(place)), ivec3(0), ivec3((STORED_SIDE - 1) / side - 1));
    vec4 plane[2];
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 4; i++)
            plane[k][i] = storedValue(values, side * (low + ivec3(i % 2, i / 2, k)));
    return StoredCell(plane[0], plane[1], place - vec3(low));
}

// The smallest absolute value at the corners of a cell.
float smallestCorner(StoredCell cell)
{
    vec4 least = min(abs(cell.near), abs(cell.far));
    return min(min(least.x, least.y), min(least.z, least.w));
}

// A value for which storedStep returns |g| - 2 sqrt(3) STORED_CELL.
//   g  interpolated between the corners of a brick, scene units; |g| > 2 sqrt(3) STORED_CELL. It differs by at most
//      3 sqrt(3) / 2 cells from the distance, and the finer interpolation by sqrt(3) / 2 cells: together by 2 sqrt(3)
float coarseValue(float g)
{
    float size = abs(g);
    return sign(g) * min(size - 1.7320508 * STORED_CELL, 1.7320508 * size - 6.0 * STORED_CELL);
}

// storedDistance, read from the shell.
float brickDistance(sampler3D values, vec3 p)
{
    vec3 q = clamp(p, -1.0, 1.0);
    StoredCell brick = cellOfSide(values, q, BRICK);
    bool kept = !shell || smallestCorner(brick) < nearby * STORED_CELL;
    float coarse = trilinear(brick);
    float value = kept ? trilinear(storedCell(values, q)) : (marching ? coarseValue(coarse) : coarse);
    float outside = length(p - q);
    return outside > 0.0 ? length(vec2(outside, value)) : value;
}

// shadowRay, with which the light of a pixel begins.
Ray lightRay(vec3 p, vec3 normal, vec3 toLamp, float offset)
{
    marching = false;
    return shadowRay(p, normal, toLamp, offset);
}

#define storedDistance brickDistance
#define shadowRay lightRay
#include "23_stored_distances.frag"
