// stored.glsl - a distance that is stored in a grid: the values at its points, and the interpolation between them.
//
// A grid has STORED_SIDE points on each axis, from -1 to 1, and stores distances up to STORED_RANGE. The grid is a
// texture; shaders/textures/clay.c writes an example. docs/23_stored_distances.md proves the claims made here.
#include "scene.glsl"

const int   STORED_SIDE = 64;   // points on each axis
const float STORED_RANGE = 0.5; // the largest distance that is stored, scene units
const float STORED_CELL = 2.0 / float(STORED_SIDE - 1); // side of a cell, scene units

// The value at a point of the grid.
//   grid     the red channel has the high byte, the green channel the low byte; never filtered, because a filter of
//            8 bits would lose the low byte
//   point    indices of the point, each in [0, STORED_SIDE)
//   formula  (2 code / 65535 - 1) STORED_RANGE, code = 256 red + green
//   returns  scene units; the rounding to 16 bits errs by at most STORED_RANGE / 65535
float storedValue(sampler3D grid, ivec3 point)
{
    const vec2 weight = 255.0 / 65535.0 * STORED_RANGE * vec2(512.0, 2.0);
    return dot(texelFetch(grid, point, 0).rg, weight) - STORED_RANGE;
}

// The eight values around a point.
struct StoredCell {
    vec4 near, far; // at the lower and at the higher z: (0, 0), (1, 0), (0, 1), (1, 1) in x and y
    vec3 share;     // position in the cell, each in [0, 1]
};

// Look up the cell of a point.
//   q  in the cube from -1 to 1
StoredCell storedCell(sampler3D grid, vec3 q)
{
    vec3 position = (0.5 + 0.5 * q) * float(STORED_SIDE - 1);
    ivec3 low = clamp(ivec3(floor(position)), ivec3(0), ivec3(STORED_SIDE - 2));
    vec4 plane[2];
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 4; i++)
            plane[k][i] = storedValue(grid, low + ivec3(i % 2, i / 2, k));
    return StoredCell(plane[0], plane[1], position - vec3(low));
}

// Trilinear interpolation: a mean of the eight values, weighted by products of the shares.
//   formula  linear interpolation along z, y and x, one after the other
//   returns  scene units. If the grid has the values of a distance, the result errs by at most
//            sqrt(3) / 2 STORED_CELL and, where the distance has a curvature, by at most 3 / 8 STORED_CELL^2 times
//            the curvature. The result is sqrt(3)-Lipschitz, and 1.0005 sqrt(3)-Lipschitz if the values are rounded to
//            16 bits. It is not a bound, but divided by this constant it is a lower bound of the distance to the surface
//            on which it is 0
float trilinear(StoredCell cell)
{
    vec4 between = mix(cell.near, cell.far, cell.share.z);
    vec2 line = mix(between.xy, between.zw, cell.share.y);
    return mix(line.x, line.y, cell.share.x);
}

// The gradient of trilinear, which jumps from one cell to the next.
//   returns  scene units per scene unit; its length is at most 1.0005 sqrt(3)
vec3 trilinearGradient(StoredCell cell)
{
    vec4 between = mix(cell.near, cell.far, cell.share.z), rise = cell.far - cell.near;
    vec2 along = vec2(between.y - between.x, between.w - between.z);
    vec2 up = between.zw - between.xy, back = mix(rise.xy, rise.zw, cell.share.y);
    return vec3(mix(along.x, along.y, cell.share.y), mix(up.x, up.y, cell.share.x), mix(back.x, back.y, cell.share.x)) /
           STORED_CELL;
}

// The stored distance at any point.
//   p        scene units; the stored surface must lie in the cube from -1 to 1
//   formula  F(p) in the cube, F the trilinear interpolation; outside, sqrt(a^2 + F(q)^2), q the nearest point of the
//            cube and a its distance from p
//   returns  scene units; outside the cube, a lower bound wherever F is one, because the angle at q between p and
//            any point of the cube is at least a right angle
float storedDistance(sampler3D grid, vec3 p)
{
    vec3 q = clamp(p, -1.0, 1.0);
    float value = trilinear(storedCell(grid, q)), outside = length(p - q);
    return outside > 0.0 ? length(vec2(outside, value)) : value;
}

// A step towards the surface of an interpolated distance that never crosses the surface.
//   value    of storedDistance, scene units
//   formula  the larger of 0.577 value and value - 1.733 STORED_CELL: the first because of the Lipschitz constant, the
//            second because the stored values belong to a distance, which is itself 1-Lipschitz; inside, the same with
//            the opposite sign. The factors would be 1 / sqrt(3) and sqrt(3) if the values were not rounded
//   returns  scene units; a lower bound of the distance to the surface where storedDistance is 0
float storedStep(float value)
{
    float size = abs(value);
    return sign(value) * max(0.577 * size, size - 1.733 * STORED_CELL);
}
