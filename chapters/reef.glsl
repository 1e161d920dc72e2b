// reef.glsl - the reef of chapter 22: parts and lists from a table, and a march whose steps end where a cell with a
// list ends.
//
// The table, which shaders/textures/reef.c writes, has 256 texels in a row, each of four whole numbers of 32 bits. It
// contains three reefs. For each reef, two texels at the start store where its data begin, and its grid. A part takes
// one texel. The number of a cell has 16 bits: the number of its list or, if its list is empty, 65535 less 8 times a
// lower bound of the distance from the cell's centre to the scene. A list is a number of 32 bits: where it begins among
// the indices of parts, and its length in the highest byte. An index has 16 bits. Lists overlap, and many cells share
// one list.
#include "march.glsl"  // Hit, distanceAt
#include "scene.glsl"
#include "bounds.glsl" // boxInterval

uniform usampler2D reef; // "reef.png": parts and lists
uniform int parts;       // 4096 in [64, 4096] step *8: number of parts in the reef: 64, 512 or 4096

const float BLEND = 0.024;                  // width of the blend between two parts, scene units
const float MARGIN = 2.0 * BLEND;           // least distance from a cell to the union of the parts that its list leaves out
const int   FIRST_EMPTY = 64512;            // cells with a number from here on have no list
const vec3  CORNER = vec3(-10.0, -2.0, -16.0); // positions in the table are relative to this corner

// Texel i of the table.
uvec4 reefTexel(int i)
{
    return texelFetch(reef, ivec2(i & 255, i >> 8), 0);
}

// Number i of 32 bits, counted from a texel.
uint reefWord(int texel, int i)
{
    uvec4 four = reefTexel(texel + (i >> 2));
    uvec2 two = (i & 2) == 0 ? four.xy : four.zw;
    return (i & 1) == 0 ? two.x : two.y;
}

// Number i of the eight numbers of 16 bits in a texel, where i counts modulo 8.
int indexIn(uvec4 texel, int i)
{
    uvec2 two = (i & 4) == 0 ? texel.xy : texel.zw;
    uint one = (i & 2) == 0 ? two.x : two.y;
    return int((i & 1) == 0 ? one & 65535u : one >> 16);
}

// The texels at which a reef's parts, cells, lists and indices begin, and the grid of the reef.
struct Grid {
    int   count; // number of parts
    ivec4 at;    // the texels, in this order
    ivec3 cells;
    vec3  low;
    float size;  // side of a cell
};

Grid grid;

// Read the grid of the reef that the parameter parts selects. Every pixel calls this function first.
void readGrid()
{
    int i = parts > 512 ? 2 : (parts > 64 ? 1 : 0);
    uvec4 b = reefTexel(2 * i + 1);
    vec3 low = vec3(b.z & 65535u, b.z >> 16, b.w);
    grid = Grid(64 << 3 * i, ivec4(reefTexel(2 * i)), ivec3(b.x & 1023u, b.x >> 10 & 1023u, b.x >> 20),
                CORNER + low / 64.0, float(b.y) / 4096.0);
}

// ---- Parts ----

int asked = 0; // number of parts evaluated for this pixel

// A part: the vector to p from the nearest point of its segment (xyz), and its radius (w).
vec4 partAt(int id, vec3 p)
{
    asked++;
    uvec4 w = reefTexel(grid.at.x + id);
    vec3 from = p - CORNER - vec3(w.x & 65535u, w.x >> 16, w.y & 65535u) / 2048.0;
    vec3 halfway = vec3(w.z & 255u, w.z >> 8 & 255u, w.z >> 16) / 256.0 - 0.5;
    float along = clamp(dot(from, halfway) / max(dot(halfway, halfway), 1e-9), -1.0, 1.0);
    float root = float(w.y >> 16 & 255u);
    return vec4(from - along * halfway, root * root / 65536.0);
}

// The colour of a part and its nearness to the tip, for paintColour.
int partPaint(int id)
{
    return int(reefTexel(grid.at.x + id).y >> 24);
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
    int i = (c.z * grid.cells.y + c.y) * grid.cells.x + c.x, number = indexIn(reefTexel(grid.at.y + (i >> 3)), i);
    bool empty = number >= FIRST_EMPTY;
    uint list = reefWord(grid.at.z, empty ? 0 : number);
    return Cell(grid.low + grid.size * vec3(c), grid.size, int(list & 0xffffffu), empty ? 0 : int(list >> 24),
                float(65535 - number) / 8.0);
}

// The index of the part at a position in the lists.
int listed(int position)
{
    return indexIn(reefTexel(grid.at.w + (position >> 3)), position);
}

// The smooth union of the parts in a cell's list, or 1e9 if the list is empty. Each texel of indices is read once.
float listDistance(vec3 p, Cell cell)
{
    float value = 1e9;
    int position = cell.first, end = cell.first + cell.count;
    while (position < end) {
        uvec4 texel = reefTexel(grid.at.w + (position >> 3));
        for (int last = min(end, (position | 7) + 1); position < last; position++) {
            vec4 part = partAt(indexIn(texel, position), p);
            value = blended(value, length(part.xyz) - part.w);
        }
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
        int id = listed(cell.first + i), paint = partPaint(id);
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
