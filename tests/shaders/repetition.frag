#version 330 core
// For repetition.c and cells.c: repeated solids at random points, and the operators and the hash at given numbers. Time
// selects the function; iMouse: period, number of repeated axes, first and last cell. Each pixel is (p, f(p)), or four
// numbers.

in float Time;
out vec4 FragColor;

uniform vec4 iMouse;

#include "random.glsl"
#include "primitives.glsl"
#include "repetition.glsl"

// A solid that fits in its cell and is mirror-symmetric along every axis.
float symmetric(vec3 q)
{
    return min(sdBox(q, vec3(0.9, 0.3, 0.5)), sdSphere(q, 0.7));
}

// A plank in a cell 2.5 wide, turned by 30 degrees.
float plank(vec3 q)
{
    const float c = 0.8660254037844386;
    return sdBox(vec3(c * q.x - 0.5 * q.z, q.y, 0.5 * q.x + c * q.z), vec3(1.2, 1.0, 0.2));
}

// A ball beside the centre of a cell 4 wide.
float offset(vec3 q)
{
    return sdSphere(q - vec3(1.5, 0.0, 0.0), 0.4);
}

// A tower 1.6 wide and 0.5 to 12 high, on the plane y = 0.
float tower(vec3 p, float x, float z)
{
    float tall = 0.25 + 5.75 * cellRandom(ivec3(x, 0, z));
    return sdBox(vec3(p.x - iMouse.x * x, p.y - tall, p.z - iMouse.x * z), vec3(0.8, tall, 0.8));
}

float towers(vec3 p)
{
    vec2 own = vec2(cellOf(p.x, iMouse.x), cellOf(p.z, iMouse.x));
    vec2 next = vec2(cellNeighbour(p.x, iMouse.x), cellNeighbour(p.z, iMouse.x));
    float near = min(tower(p, own.x, own.y), tower(p, next.x, own.y));
    return min(near, min(tower(p, own.x, next.y), tower(p, next.x, next.y)));
}

// The towers of the cell and of both its neighbours along the x axis.
float row(vec3 p)
{
    float own = cellOf(p.x, iMouse.x);
    return min(tower(p, own, 0.0), min(tower(p, own - 1.0, 0.0), tower(p, own + 1.0, 0.0)));
}

float limitedPlank(vec3 p, bool clamped)
{
    float own = cellOfLimited(p.x, iMouse.x, iMouse.z, iMouse.w);
    float next = clamped ? cellNeighbourLimited(p.x, iMouse.x, iMouse.z, iMouse.w) : cellNeighbour(p.x, iMouse.x);
    vec3 aside = vec3(iMouse.x, 0.0, 0.0);
    return min(plank(p - own * aside), plank(p - next * aside));
}

float limitedTowers(vec3 p)
{
    float own = cellOfLimited(p.x, iMouse.x, iMouse.z, iMouse.w);
    float next = cellNeighbourLimited(p.x, iMouse.x, iMouse.z, iMouse.w);
    float wall = cellWallLimited(p.x, iMouse.x, iMouse.z, iMouse.w);
    return min(wall, min(tower(p, own, 0.0), tower(p, next, 0.0)));
}

// Only the tower of the cell, which reaches 0.8 from the cell's centre, and cellOthers.
float lonely(vec3 p)
{
    float own = tower(p, cellOf(p.x, iMouse.x), cellOf(p.z, iMouse.x));
    return min(own, min(cellOthers(p.x, iMouse.x, 0.8), cellOthers(p.z, iMouse.x, 0.8)));
}

float asked(vec3 p)
{
    int which = int(Time);
    float period = iMouse.x;
    vec3 aside = vec3(period, 0.0, 0.0);
    vec3 own = vec3(opRepeat(p.x, period), p.yz);
    vec3 next = p - cellNeighbour(p.x, period) * aside;
    if (which == 0) {
        vec3 all = vec3(own.x, opRepeat(p.y, period), opRepeat(p.z, period));
        return symmetric(vec3(all.x, iMouse.y > 2.0 ? all.y : p.y, iMouse.y > 1.0 ? all.z : p.z));
    }
    if (which == 1)
        return symmetric(vec3(opRepeatLimited(p.x, period, iMouse.z, iMouse.w), p.y,
                              opRepeatLimited(p.z, period, iMouse.z, iMouse.w)));
    if (which == 2)
        return plank(vec3(opRepeatMirrored(p.x, period), p.yz));
    if (which == 3)
        return plank(own);
    if (which == 4)
        return min(plank(own), plank(next));
    if (which == 5 || which == 6)
        return limitedPlank(p, which == 5);
    if (which == 7)
        return offset(own);
    if (which == 8)
        return min(offset(own), offset(next));
    if (which == 9)
        return towers(p);
    if (which == 10)
        return min(towers(p), min(cellWall(p.x, period), cellWall(p.z, period)));
    if (which == 11)
        return row(p);
    return which == 12 ? limitedTowers(p) : lonely(p);
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int item = pixel.x + 256 * pixel.y;
    seed = uint(item) * 9781u + 17u;
    if (Time < 20.0) {
        bool tall = Time > 8.5;
        vec3 p = nextVector() * vec3(4.0 * iMouse.x, tall ? 7.0 : 4.0, Time < 1.5 || tall ? 4.0 * iMouse.x : 3.0);
        p.y += tall ? 7.0 : 0.0;
        if (item % 2 == 1 && Time > 1.5 && Time < 8.5)
            p.yz = vec2(0.0, 0.5 * p.z);
        if (item % 4 == 1 && Time > 6.5 && Time < 8.5)
            p.z = 0.0;
        if (Time == 11.0)
            p.z = 0.0;
        FragColor = vec4(p, asked(p));
    } else if (Time < 21.0) {
        // Multiples of 1/16, which include the walls and the centres of cells, and points on both sides of them.
        float x = 0.0625 * float(item - 8192);
        FragColor = vec4(x, cellOf(x, iMouse.x), opRepeat(x, iMouse.x), opRepeatMirrored(x, iMouse.x));
    } else if (Time < 22.0) {
        float x = 0.0625 * float(item - 8192);
        FragColor = vec4(cellNeighbour(x, iMouse.x), cellWall(x, iMouse.x), cellOthers(x, iMouse.x, iMouse.y), mod(x, iMouse.x));
    } else if (Time < 23.0) {
        float x = 0.0625 * float(item - 8192);
        FragColor = vec4(cellOfLimited(x, iMouse.x, iMouse.z, iMouse.w), opRepeatLimited(x, iMouse.x, iMouse.z, iMouse.w),
                         cellNeighbourLimited(x, iMouse.x, iMouse.z, iMouse.w), cellWallLimited(x, iMouse.x, iMouse.z, iMouse.w));
    } else {
        ivec3 cell = ivec3(pixel.x - 128, int(iMouse.x), pixel.y - 128);
        FragColor = vec4(cellRandom(cell), cellRandom(cell.zxy), cellRandom(cell.yzx), cellRandom(8191 * cell));
    }
}
