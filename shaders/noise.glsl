// noise.glsl - random numbers on the points of a lattice, and smooth functions between them: what a
// rough stone, a vein of marble or a gust of wind is made from.
//
// The lattice is that of the whole numbers: one cell is 1 scene unit wide; noise(k p) has k cells a
// unit, and its gradient is k times as long. Every function returns its value in x and its gradient
// in yzw, computed and not by differences; whoever takes x alone pays for x alone.

// What the random numbers of neighbouring lattice points differ by, before they are stirred.
const uvec3 LATTICE_STEP = uvec3(2376512323u, 3625334849u, 3407524639u);

// Bits that look random, four at once.
//   formula  v ^= v >> 16, v *= 0x7feb352d, v ^= v >> 15, v *= 0x846ca68b, v ^= v >> 16: every step
//            can be undone, so different v give different bits
// Source: C. Wellons, 'Prospecting for hash functions' (2018), lowbias32.
uvec4 stirredBits(uvec4 v)
{
    v = (v ^ (v >> 16u)) * 2146121005u;
    v = (v ^ (v >> 15u)) * 2221713035u;
    return v ^ (v >> 16u);
}

// The bits of the eight corners of a cell.
struct CellBits {
    uvec4 near; // z = 0: the corners (0, 0), (1, 0), (0, 1), (1, 1) in x and y
    uvec4 far;  // z = 1: the same
};

// The bits of the cell whose lowest corner is given.
//   corner   whole numbers, |corner| < 2^31
//   formula  stirredBits(dot(corner, LATTICE_STEP)), whole numbers modulo 2^32
// Two lattice points have the same bits where their difference times LATTICE_STEP is 0 modulo 2^32; the
// nearest two such points are 1,565 cells apart: within a ball of 780 cells no two points agree by this.
CellBits cellBits(ivec3 corner)
{
    uvec3 steps = uvec3(corner) * LATTICE_STEP;
    uint lowest = steps.x + steps.y + steps.z;
    uvec4 near = lowest + uvec4(0u, LATTICE_STEP.x, LATTICE_STEP.y, LATTICE_STEP.x + LATTICE_STEP.y);
    return CellBits(stirredBits(near), stirredBits(near + LATTICE_STEP.z));
}

// The way from 0 to 1 that begins and ends with slope and curvature 0.
//   x        in [0, 1], per component
//   formula  6 x^5 - 15 x^4 + 10 x^3
// Source: K. Perlin, 'Improving noise', SIGGRAPH 2002.
vec3 quinticFade(vec3 x)
{
    return x * x * x * (x * (6.0 * x - 15.0) + 10.0);
}

// Its slope: at most 15/8, at x = 1/2.
//   formula  30 x^2 (1 - x)^2
vec3 quinticSlope(vec3 x)
{
    vec3 q = x * (1.0 - x);
    return 30.0 * q * q;
}

// Between eight numbers at the corners of a cell.
//   x          place in the cell, in [0, 1] per component
//   near, far  the numbers, in the order of CellBits
//   returns    value (x), gradient (yzw); the gradient is never longer than 15/8 times the range of
//              the eight numbers, and is so long in the middle of a cell with one number on a face
//              and the other on the face across
//   formula    sum of weight times number; the weight of a corner is the product over the axes of
//              fade(x) or 1 - fade(x)
vec4 blendedValues(vec3 x, vec4 near, vec4 far)
{
    vec3 u = quinticFade(x), slope = quinticSlope(x);
    vec4 along = far - near, level = near + u.z * along;
    vec2 rise = level.zw - level.xy, row = level.xy + u.y * rise;
    vec2 deep = along.xy + u.y * (along.zw - along.xy);
    vec3 growth = vec3(row.y - row.x, rise.x + u.x * (rise.y - rise.x), deep.x + u.x * (deep.y - deep.x));
    return vec4(row.x + u.x * growth.x, slope * growth);
}

// Value noise: a random number at every lattice point, blended between.
//   p        scene units
//   returns  value in [0, 1), gradient; twice continuously differentiable; the gradient is never
//            longer than VALUE_STRETCH
vec4 valueNoise(vec3 p)
{
    vec3 corner = floor(p);
    CellBits bits = cellBits(ivec3(corner));
    ivec4 near = ivec4(bits.near >> 8u), far = ivec4(bits.far >> 8u); // from int a float is made faster
    return blendedValues(p - corner, vec4(near) / 16777216.0, vec4(far) / 16777216.0);
}

// Lipschitz constants, both the least that hold for all numbers and directions at the corners. The first
// is proved in docs/12_textures.md; that the second is nowhere exceeded is computed there, on a grid.
const float VALUE_STRETCH = 1.875;        // 15/8: of the fade on one axis, and of valueNoise in space
const float GRADIENT_STRETCH = 2.7922885; // sqrt(499) / 8: of gradientNoise

// A direction for the bits of a lattice point, length 1.
//   formula  three odd numbers from -1023 to 1023, ten bits each, made of length 1: never (0, 0, 0)
vec3 latticeDirection(uint bits)
{
    ivec3 k = ivec3(uvec3(bits, bits >> 10u, bits >> 20u) & 1023u);
    return normalize(vec3(2 * k - 1023));
}

// What one corner adds to gradient noise: a slope through the corner, as far as the corner's weight
// reaches.
//   x          place in the cell
//   corner     0 or 1 per component
//   direction  of that corner, length 1
//   formula    weight(x) dot(direction, x - corner), and its gradient
vec4 cornerSlope(vec3 x, vec3 corner, vec3 direction)
{
    vec3 u = quinticFade(x), away = x - corner;
    vec3 share = mix(1.0 - u, u, corner), slope = (2.0 * corner - 1.0) * quinticSlope(x);
    float weight = share.x * share.y * share.z, height = dot(direction, away);
    return vec4(weight * height, weight * direction + height * slope * share.yzx * share.zxy);
}

// Gradient noise: 0 at every lattice point, with a random slope of length 1 there.
//   p        scene units
//   returns  value in [-sqrt(3) / 2, sqrt(3) / 2], gradient; twice continuously differentiable; the
//            gradient is never longer than GRADIENT_STRETCH
// Source: K. Perlin, 'An image synthesizer', SIGGRAPH 1985; with his fade of 2002.
vec4 gradientNoise(vec3 p)
{
    vec3 corner = floor(p);
    CellBits bits = cellBits(ivec3(corner));
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; i++) {
        vec2 side = vec2(i % 2, i / 2);
        sum += cornerSlope(p - corner, vec3(side, 0.0), latticeDirection(bits.near[i]));
        sum += cornerSlope(p - corner, vec3(side, 1.0), latticeDirection(bits.far[i]));
    }
    return sum;
}

// Where the lattice of the next octave stands, so that the lattices of two octaves do not meet: where
// they do, all octaves of gradient noise are 0, and all gradients of value noise.
const vec3 OCTAVE_SHIFT = vec3(17.17, 5.31, 29.73);

// The sum of 1, ratio, ratio^2 and so on, count terms.
//   count    >= 1
//   formula  added up; 1 / (1 - ratio) without end, where |ratio| < 1
float geometricSum(float ratio, int count)
{
    float sum = 0.0, term = 1.0;
    for (int i = 0; i < count; i++) {
        sum += term;
        term *= ratio;
    }
    return sum;
}

// Octaves of value noise, one finer and weaker than the other, divided by the sum of their weights.
//   count       of octaves, >= 1
//   gain        weight of an octave over that of the one before, in (0, 1]
//   lacunarity  the same for the number of cells a unit, >= 1
//   returns     value in [0, 1), gradient, never longer than octaveStretch
//   formula     sum of gain^i valueNoise(p_i) / sum of gain^i, p_0 = p, p_(i+1) = lacunarity p_i + shift
vec4 octaveNoise(vec3 p, int count, float gain, float lacunarity)
{
    vec4 sum = vec4(0.0);
    float weight = 1.0, weights = 0.0, scale = 1.0;
    for (int i = 0; i < count; i++) {
        sum += weight * vec4(1.0, vec3(scale)) * valueNoise(p);
        p = lacunarity * p + OCTAVE_SHIFT;
        weights += weight;
        weight *= gain;
        scale *= lacunarity;
    }
    return sum / weights;
}

// The Lipschitz constant of octaveNoise: a bound; it is reached where the steepest places of all octaves
// meet, which chance does not arrange.
//   formula  VALUE_STRETCH sum of (gain lacunarity)^i / sum of gain^i; for gain < 1 bounded for every
//            count if, and only if, gain lacunarity < 1
float octaveStretch(int count, float gain, float lacunarity)
{
    return VALUE_STRETCH * geometricSum(gain * lacunarity, count) / geometricSum(gain, count);
}
