// reef.glsl - the reef of chapter 22: parts and lists from a table, and a march whose steps end where a cell with a
// list ends.
//
// The table is a picture of bytes, 512 texels wide, which shaders/textures/reef.c writes. It contains three reefs. For
// each reef, eight texels at the start of the table store where its data begin, and its grid. A part takes three
// texels, a cell takes one, and two indices of parts share one. Byte 0 of a cell is the number of parts in its list.
// The other bytes are a whole number: the position of the list or, if the list is empty, 4096 times a lower bound of
// the distance from the cell's centre to the scene.
#include "march.glsl"  // Hit, distanceAt
#include "scene.glsl"
#include "bounds.glsl" // boxInterval

uniform sampler2D reef; // "reef.png" linear clamp: parts and lists
uniform int parts;      // 4096 in [64, 4096] step *8: number of parts in the reef: 64, 512 or 4096

const float BLEND = 0.024;                  // width of the blend between two parts, scene units
const float MARGIN = 2.0 * BLEND;           // least distance from a cell to the union of the parts that its list leaves out
const vec3  CORNER = vec3(-10.0, -2.0, -16.0); // positions in the table are relative to this corner

// Texel i of the table, as bytes.
ivec4 reefTexel(int i)
{
    return ivec4(255.0 * texelFetch(reef, ivec2(i & 511, i >> 9), 0) + 0.5);
}

// The whole number in the last three bytes of a texel.
int reefNumber(int i)
{
    ivec4 byte = reefTexel(i);
    return byte.y | byte.z << 8 | byte.w << 16;
}

// The texels at which a reef's parts, cells and lists begin, and the grid of the reef.
struct Grid {
    int count, partsAt, cellsAt, idsAt;
    ivec3 cells;
    vec3  low;
    float size; // side of a cell
};

Grid grid;

// Read the grid of the reef that the parameter parts selects. Every pixel calls this function first.
void readGrid()
{
    int at = 8 * (parts > 512 ? 2 : (parts > 64 ? 1 : 0));
    vec3 low = vec3(reefTexel(at + 6).xyz + 256 * reefTexel(at + 7).xyz);
    grid = Grid(reefNumber(at), reefNumber(at + 1), reefNumber(at + 2), reefNumber(at + 3), reefTexel(at + 4).xyz,
                CORNER + low / 64.0, float(reefNumber(at + 5)) / 4096.0);
}

// ---- Parts ----

int asked = 0; // number of parts evaluated for this pixel

// A part: the vector to p from the nearest point of its segment (xyz), and its radius (w).
vec4 partAt(int id, vec3 p)
{
    asked++;
    int i = grid.partsAt + 3 * id, j = i + 1, k = i + 2;
    vec4 a = texelFetch(reef, ivec2(i & 511, i >> 9), 0), b = texelFetch(reef, ivec2(j & 511, j >> 9), 0);
    vec3 c = texelFetch(reef, ivec2(k & 511, k >> 9), 0).xyz;
    vec3 from = p - CORNER - (255.0 / 2048.0) * (vec3(a.xz, b.x) + 256.0 * vec3(a.yw, b.y));
    vec3 halfway = (255.0 / 256.0) * c - 0.5;
    float along = clamp(dot(from, halfway) / max(dot(halfway, halfway), 1e-9), -1.0, 1.0);
    return vec4(from - along * halfway, 0.9922 * b.z * b.z);
}

// The index of the part at a position in the lists.
int listed(int position)
{
    int i = grid.idsAt + (position >> 1);
    vec4 two = 255.0 * texelFetch(reef, ivec2(i & 511, i >> 9), 0);
    vec2 one = (position & 1) == 0 ? two.xy : two.zw;
    return int(one.x + 256.0 * one.y + 0.5);
}

// opSmoothUnion with the width BLEND.
float blended(float a, float b)
{
    float h = max(BLEND - abs(a - b), 0.0);
    return min(a, b) - h * h * h * (1.0 / (6.0 * BLEND * BLEND));
}

// ---- Lists ----

// A cell of the grid: its corner, and its list or its bound.
struct Cell {
    vec3  low;
    float size;
    int   first, count;
    float bound; // a lower bound of the distance from the centre to the scene, if count is 0
};

Cell cellAt(vec3 p)
{
    ivec3 c = clamp(ivec3((p - grid.low) / grid.size), ivec3(0), grid.cells - 1);
    ivec4 byte = reefTexel(grid.cellsAt + (c.z * grid.cells.y + c.y) * grid.cells.x + c.x);
    int number = byte.y | byte.z << 8 | byte.w << 16;
    return Cell(grid.low + grid.size * vec3(c), grid.size, number, byte.x, float(number) / 4096.0);
}

// The smooth union of the parts in a cell's list, or 1e9 if the list is empty.
float listDistance(vec3 p, Cell cell)
{
    float value = 1e9;
    for (int i = 0; i < cell.count; i++) {
        vec4 part = partAt(listed(cell.first + i), p);
        value = blended(value, length(part.xyz) - part.w);
    }
    return value;
}

Cell  here;         // the cell of the last evaluation
float listValue;    // value of the list of that cell, at the point of the last evaluation

// A lower bound of the distance to the reef: in a cell with a list, the value of the list, but at most MARGIN; in an
// empty cell, the bound that follows from the distance at the cell's centre, but at least MARGIN.
float reefDistance(vec3 p)
{
    here = cellAt(p);
    listValue = listDistance(p, here);
    float empty = here.bound - length(p - here.low - 0.5 * here.size);
    return here.count > 0 ? min(listValue, MARGIN) : max(empty, MARGIN);
}

// How far a ray may advance from p after reefDistance: in a cell with a list, by the value of the list, but no farther
// than to where the ray leaves the cell; in an empty cell, by the distance, but at least to where it leaves the cell.
float roomAlong(vec3 p, vec3 direction, float distance)
{
    vec3 to = (here.low + here.size * step(0.0, direction) - p) / direction;
    float leave = max(min(to.x, min(to.y, to.z)), 0.0) + 1e-4;
    return here.count > 0 ? min(listValue, leave) : max(distance, leave);
}

// March along a ray through the reef, as march does but with the steps of roomAlong.
//   spread  how fast the threshold grows, per scene unit
Hit marchReef(Ray ray, float tMin, float tMax, float threshold, float spread, int maxSteps)
{
    traceBegin(tMin, tMax);
    traceThreshold(threshold, spread);
    float t = tMin;
    int steps = 0;
    bool found = false, searching = tMin < tMax;
    while (searching) {
        vec3 p = ray.origin + t * ray.direction;
        float distance = distanceAt(p);
        traceStep(steps, t, distance);
        steps++;
        found = distance < threshold + spread * t;
        t += found ? 0.0 : roomAlong(p, ray.direction, distance);
        searching = !found && t < tMax && steps < maxSteps;
    }
    traceMarch(steps, t, found ? END_HIT : (t >= tMax ? END_PASSED : END_STEPS));
    return Hit(found, t);
}

// The interval in which a ray is inside the grid.
vec2 reefInterval(Ray ray)
{
    return boxInterval(ray, grid.low, grid.low + grid.size * vec3(grid.cells));
}

// The appearance of a point of the reef: the mean of the parts there, weighted by the slopes of the smooth union.
struct Skin {
    vec3  normal;
    vec3  colour;
    float stone; // the share of stone
};

const int STONE = 14; // the upper four bits of paint for stone

vec3 paintColour(int paint);

// The skin at p. One pass through the list is enough for the whole skin, whereas normalAt alone would need six.
Skin skinAt(vec3 p, bool wanted)
{
    Cell cell = cellAt(p);
    float value = 1e9;
    Skin skin = Skin(vec3(0.0, 1.0, 0.0), vec3(0.5), 0.0);
    for (int i = 0; wanted && i < cell.count; i++) {
        int id = listed(cell.first + i), paint = reefTexel(grid.partsAt + 3 * id + 1).w;
        vec4 part = partAt(id, p);
        float size = max(length(part.xyz), 1e-6), d = size - part.w;
        float h = max(BLEND - abs(value - d), 0.0) / BLEND, less = 0.5 * h * h, share = d < value ? 1.0 - less : less;
        skin.normal = mix(skin.normal, part.xyz / size, share);
        skin.colour = mix(skin.colour, paintColour(paint), share);
        skin.stone = mix(skin.stone, float(paint >> 4 == STONE), share);
        value = blended(value, d);
    }
    skin.normal = normalize(skin.normal);
    traceNormal(skin.normal);
    return skin;
}
