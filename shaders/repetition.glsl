// repetition.glsl - one volume, many copies: from a coordinate to the position in its cell.
//
// Every function takes one coordinate; a scene that repeats along two axes calls the function for each axis. Cell k
// reaches from period (k - 1/2) to period (k + 1/2). Indices of cells are integers stored as floats. If
// a claim says that a volume fits in its cell, only the repeated axes count.

// The index of the cell that contains x: cell 0 is centred at 0.
//   x        a coordinate, scene units
//   period   width of a cell, scene units, > 0
//   formula  floor(x / period + 1/2)
float cellOf(float x, float period)
{
    return floor(x / period + 0.5);
}

// The position in the cell, from -period / 2 to period / 2: a volume at the origin appears in each of the infinitely
// many cells.
//   formula  x - period cellOf(x)
//   f(opRepeat(x))  exact outside if f is, the volume fits in its cell and f(-x) = f(x); a lower
//            bound if f is one and f(-x) = f(x); otherwise not a bound: evaluate cellNeighbour too
// Source: report, section 2.2.3, whose mod(x - period / 2, period) + period / 2 never reaches 0.
float opRepeat(float x, float period)
{
    return x - period * cellOf(x, period);
}

// The index of the cell from first to last that is nearest to x.
//   first, last  integers, first <= last
//   formula      clamp(cellOf(x), first, last)
float cellOfLimited(float x, float period, float first, float last)
{
    return clamp(cellOf(x, period), first, last);
}

// The position relative to the nearest cell from first to last: only those cells contain copies. Beyond the
// ends, the position leaves [-period / 2, period / 2].
//   f(opRepeatLimited(x))  as f(opRepeat(x)): exact outside if f is, the volume fits in its cell
//            and f(-x) = f(x)
//   formula  x - period cellOfLimited(x)
float opRepeatLimited(float x, float period, float first, float last)
{
    return x - period * cellOfLimited(x, period, first, last);
}

// The position in the cell, mirrored in every cell of odd index: a fold, continuous and 1-Lipschitz.
//   formula  period / 2 - |mod(x + period / 2, 2 period) - period|
//   f(opRepeatMirrored(x))  exact outside if f is and the volume fits in its cell; otherwise a lower
//            bound if f is 1-Lipschitz
float opRepeatMirrored(float x, float period)
{
    return 0.5 * period - abs(mod(x + 0.5 * period, 2.0 * period) - period);
}

// The index of the cell next to the cell of x, on the nearer side.
//   min over cellOf and cellNeighbour, f(x - period cell)  exact outside if f is, for identical
//            copies that fit in their cells; for n axes, take the minimum over 2^n cells
float cellNeighbour(float x, float period)
{
    float cell = cellOf(x, period);
    return cell + (x < period * cell ? -1.0 : 1.0);
}

// cellNeighbour among the cells from first to last: if the neighbour lies beyond one end, the cell at that end.
//   formula  clamp(cellNeighbour(x), first, last)
float cellNeighbourLimited(float x, float period, float first, float last)
{
    return clamp(cellNeighbour(x, period), first, last);
}

// The distance to the border of the block that cellOf and cellNeighbour form: everything in other
// cells is at least this far away.
//   formula  period / 2 + |opRepeat(x)|, from period / 2 to period
//   min over the block's copies and cellWall  a lower bound, for copies that vary from cell to cell
//            and fit in their cells; for n axes 2^n copies and the smallest of n borders; 1-Lipschitz
//            if every copy's function is and is at least |x - period cell| - period / 2
float cellWall(float x, float period)
{
    return 0.5 * period + abs(opRepeat(x, period));
}

// cellWall if only the cells from first to last contain copies; the distance grows beyond the ends.
//   formula  period / 2 + |opRepeatLimited(x)|
float cellWallLimited(float x, float period, float first, float last)
{
    return 0.5 * period + abs(opRepeatLimited(x, period, first, last));
}

// The distance to the other copies, if all copies stay near the middle of their cells. Then only the cell's own
// copy has to be evaluated.
//   reach    how far a copy reaches from the middle of its cell along this axis, scene units, less
//            than period / 2, or a march stops at the borders
//   formula  period - |opRepeat(x)| - reach, from period / 2 - reach to period - reach
//   min of the cell's own copy and cellOthers  a lower bound, for copies that vary from cell to cell;
//            for n axes one copy and the smallest of n values of cellOthers; 1-Lipschitz if every
//            copy's function is and is at least |x - period cell| - reach
float cellOthers(float x, float period, float reach)
{
    return period - abs(opRepeat(x, period)) - reach;
}

// A number in [0, 1) that looks random. A cell has the same number on every machine, because it comes from an
// integer hash and not from a sine. If all its values are equally likely, it is correlated with fract(64 cellRandom),
// which drops the first 6 of its 24 bits, by only 1/64: this is a second number.
//   cell  integers; exchanging the last two has no effect, so in a plane vary the first and one of the others
// Source: after pcg3d of M. Jarzynski, M. Olano, 'Hash functions for GPU rendering', JCGT 9 (2020),
// whose rounds change x, y and z one after another; here all three change at once.
float cellRandom(ivec3 cell)
{
    uvec3 v = uvec3(cell) * 1664525u + 1013904223u;
    v += v.yzx * v.zxy;
    v ^= v >> 16u;
    v += v.yzx * v.zxy;
    return float(v.x >> 8u) / 16777216.0;
}
