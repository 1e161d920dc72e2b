// repetition.glsl - one volume, many copies: from a coordinate to the place in its cell.

// The number of the cell that holds x: cell 0 is centred at 0.
//   x       a coordinate, scene units
//   period  width of a cell, scene units, > 0
//   formula  floor(x / period + 1/2)
float cellOf(float x, float period)
{
    return floor(x / period + 0.5);
}

// The place in the cell, from -period / 2 to period / 2: what is drawn at the origin returns in every
// cell.
//   formula  x - period cellOf(x)
float opRepeat(float x, float period)
{
    return x - period * cellOf(x, period);
}

// A number in [0, 1) that looks random, the same for the same cell on every machine: an integer hash,
// no sine.
//   cell  whole numbers
// Source: M. Jarzynski, M. Olano, 'Hash functions for GPU rendering', JCGT 9 (2020): pcg3d.
float cellRandom(ivec3 cell)
{
    uvec3 v = uvec3(cell) * 1664525u + 1013904223u;
    v += v.yzx * v.zxy;
    v ^= v >> 16u;
    v += v.yzx * v.zxy;
    return float(v.x >> 8u) / 16777216.0;
}
