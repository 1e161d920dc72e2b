// Pairs of random numbers as points of a square: set `sequence` and the number of points. With `across`, a point has the
// first numbers of two pairs, such as those of two bounces. The other number counts the cells of the grid that have no
// point, and these cells are grey. Drag the handle to count the pairs in a cell.
#include "figure.glsl"
#include "sobol.glsl"

uniform int sequence; // 0 in [0, 2]: 0 hash, 1 one good pair for everything, 2 scrambled Sobol pairs
uniform bool across;  // false: show the first numbers of two pairs instead of the two numbers of one
uniform int count;    // 64 in [1, 64]: number of points
uniform int columns;  // 3 in [0, 6]: the grid has 2 to this power columns, and 64 cells
uniform int seed;     // 1 in [0, 100]: another pixel of the picture
uniform vec2 chosen;  // (-0.42, -0.07) handle: a point of the cell whose pairs are counted

const vec2 MIDDLE = vec2(0.0, 0.07);
const float SIDE = 1.6;

float sceneDistance(vec3 p)
{
    return p.z;
}

vec2 pairOf(int index, int pair)
{
    uvec4 lots = hashOf(uvec4(seed, pair, sequence, 24));
    if (sequence == 2)
        return sobolPoint(uint(index), lots.xyz);
    if (sequence == 1)
        return vec2((lots.xy + uint(index) * uvec2(3242174889u, 2447445414u)) >> 8u) / 16777216.0;
    return vec2(hashOf(uvec4(seed, pair, index, 25)).xy >> 8u) / 16777216.0;
}

vec2 pointOf(int index)
{
    vec2 one = pairOf(index, 1);
    return across ? vec2(one.x, pairOf(index, 2).x) : one;
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), here = (p - MIDDLE) / SIDE + 0.5, grid = exp2(vec2(columns, 6 - columns));
    uvec2 full = uvec2(0u); // one bit for each cell
    ivec2 held = ivec2(clamp((chosen - MIDDLE) / SIDE + 0.5, 0.0, 0.9999) * grid);
    int inside = 0;
    float nearest = 1e6;
    for (int i = 0; i < count; i++) {
        vec2 at = pointOf(i);
        ivec2 cell = ivec2(at * grid);
        int index = cell.y * int(grid.x) + cell.x;
        full |= index < 32 ? uvec2(1u << uint(index), 0u) : uvec2(0u, 1u << uint(index - 32));
        inside += cell == held ? 1 : 0;
        nearest = min(nearest, length((here - at) * SIDE));
    }
    int empty = 0;
    for (int i = 0; i < 64; i++)
        empty += ((i < 32 ? full.x >> uint(i) : full.y >> uint(i - 32)) & 1u) == 0u ? 1 : 0;
    ivec2 mine = ivec2(clamp(here, 0.0, 0.9999) * grid);
    int index = mine.y * int(grid.x) + mine.x;
    bool none = ((index < 32 ? full.x >> uint(index) : full.y >> uint(index - 32)) & 1u) == 0u;
    float outside = sdRectangle(p - MIDDLE, vec2(0.5 * SIDE));
    fill(outside, none ? SHADE : SKY, none ? 0.55 : 0.5);
    vec2 lines = abs(fract(here * grid + 0.5) - 0.5) * SIDE / grid;
    fill(max(outside, min(lines.x, lines.y) - 0.5 * penWidth(0.8)), PALE, 1.0);
    stroke(outside, 2.0, INK);
    fill(max(nearest - penWidth(3.0), outside), ORANGE, 1.0);
    vec2 middle = MIDDLE + SIDE * ((vec2(held) + 0.5) / grid - 0.5);
    stroke(sdRectangle(p - middle, 0.5 * SIDE / grid), 2.0, BLUE);
    fill(length(p - chosen) - penWidth(5.0), BLUE, 1.0);
    number(p, vec2(-0.3, -0.87), float(empty), 0, INK); // # empty cell(s)
    number(p, vec2(0.3, -0.87), float(inside), 0, BLUE); // # pair(s) in the blue cell
    return sheetColour;
}
