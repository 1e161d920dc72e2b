// repetition.glsl - one volume, many copies: from a coordinate to the place in its cell.
//
// Every function takes one coordinate: what repeats along two axes calls it for two. Cell k reaches
// from period (k - 1/2) to period (k + 1/2). Numbers of cells are whole numbers kept as floats. Where
// a claim says that a volume fits in its cell, the cell is meant along the repeated axes alone.

// The number of the cell that holds x: cell 0 is centred at 0.
//   x        a coordinate, scene units
//   period   width of a cell, scene units, > 0
//   formula  floor(x / period + 1/2)
float cellOf(float x, float period)
{
    return floor(x / period + 0.5);
}

// The place in the cell, from -period / 2 to period / 2: what is drawn at the origin returns in every
// cell, without end.
//   formula  x - period cellOf(x)
//   f(opRepeat(x))  exact outside where f is, the volume fits in its cell and f(-x) = f(x); a lower
//            bound where f is one and f(-x) = f(x); otherwise not a bound: ask cellNeighbour too
// Source: report, section 2.2.3, whose mod(x - period / 2, period) + period / 2 never reaches 0.
float opRepeat(float x, float period)
{
    return x - period * cellOf(x, period);
}

// The number of the cell from first to last that is nearest to x.
//   first, last  whole numbers, first <= last
//   formula      clamp(cellOf(x), first, last)
float cellOfLimited(float x, float period, float first, float last)
{
    return clamp(cellOf(x, period), first, last);
}

// The place relative to the nearest cell from first to last: copies in those cells alone. Beyond the
// ends it leaves [-period / 2, period / 2].
//   f(opRepeatLimited(x))  as f(opRepeat(x)): exact outside where f is, the volume fits in its cell
//            and f(-x) = f(x)
//   formula  x - period cellOfLimited(x)
float opRepeatLimited(float x, float period, float first, float last)
{
    return x - period * cellOfLimited(x, period, first, last);
}

// The place in the cell, mirrored in every cell of odd number: a fold, continuous and 1-Lipschitz.
//   formula  period / 2 - |mod(x + period / 2, 2 period) - period|
//   f(opRepeatMirrored(x))  exact outside where f is and the volume fits in its cell; else a lower
//            bound wherever f is 1-Lipschitz
float opRepeatMirrored(float x, float period)
{
    return 0.5 * period - abs(mod(x + 0.5 * period, 2.0 * period) - period);
}

// The number of the cell next to x's own, on the nearer side.
//   min over cellOf and cellNeighbour, f(x - period cell)  exact outside where f is, for identical
//            copies that fit in their cells; for n axes the minimum over 2^n cells
float cellNeighbour(float x, float period)
{
    float cell = cellOf(x, period);
    return cell + (x < period * cell ? -1.0 : 1.0);
}

// The same among the cells from first to last: where there is none, the last one again.
//   formula  clamp(cellNeighbour(x), first, last)
float cellNeighbourLimited(float x, float period, float first, float last)
{
    return clamp(cellNeighbour(x, period), first, last);
}

// How far it is to the wall of the block that cellOf and cellNeighbour form: whatever lies in other
// cells is at least so far away.
//   formula  period / 2 + |opRepeat(x)|, from period / 2 to period
//   min over the block's copies and cellWall  a lower bound, for copies that vary from cell to cell
//            and fit in their cells; for n axes 2^n copies and the smallest of n walls; 1-Lipschitz
//            where every copy's function is and is at least |x - period cell| - period / 2
float cellWall(float x, float period)
{
    return 0.5 * period + abs(opRepeat(x, period));
}

// The same where cells from first to last alone hold copies; it grows beyond the ends.
//   formula  period / 2 + |opRepeatLimited(x)|
float cellWallLimited(float x, float period, float first, float last)
{
    return 0.5 * period + abs(opRepeatLimited(x, period, first, last));
}

// How far it is to the other copies, where all stay near the middle of their cells: with it the own
// copy alone is enough.
//   reach    how far a copy reaches from the middle of its cell along this axis, scene units, less
//            than period / 2, or a march stands still at the walls
//   formula  period - |opRepeat(x)| - reach, from period / 2 - reach to period - reach
//   min of the own copy and cellOthers  a lower bound, for copies that vary from cell to cell; for n
//            axes one copy and the smallest of n; 1-Lipschitz where every copy's function is and is at
//            least |x - period cell| - reach
float cellOthers(float x, float period, float reach)
{
    return period - abs(opRepeat(x, period)) - reach;
}

// A number in [0, 1) that looks random, the same for the same cell on every machine: an integer hash,
// no sine. Its 24 bits are independent: fract(64 cellRandom) is a second number, less its first 6.
//   cell  whole numbers; to exchange the last two changes nothing, so a field takes the first and one other
// Source: after pcg3d of M. Jarzynski, M. Olano, 'Hash functions for GPU rendering', JCGT 9 (2020),
// whose rounds change x, y and z one after another; here all three at once.
float cellRandom(ivec3 cell)
{
    uvec3 v = uvec3(cell) * 1664525u + 1013904223u;
    v += v.yzx * v.zxy;
    v ^= v >> 16u;
    v += v.yzx * v.zxy;
    return float(v.x >> 8u) / 16777216.0;
}
