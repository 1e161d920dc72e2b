// noise.glsl - random numbers at the points of a lattice, and smooth functions between them: the basis of
// rough stone, veined marble or gusts of wind.
//
// The lattice consists of the points with integer coordinates. One cell is 1 scene unit wide; noise(k p) has k
// cells per unit, and its gradient is k times as long. Every noise function returns its value in x and its exact
// gradient in yzw. The compiler removes the gradient where only x is used.

// The differences between the hash inputs of neighbouring lattice points.
const uvec3 LATTICE_STEP = uvec3(2376512323u, 3625334849u, 3407524639u);

// Bits that look random, for four inputs at once.
//   formula  v ^= v >> 16, v *= 0x7feb352d, v ^= v >> 15, v *= 0x846ca68b, v ^= v >> 16: every step is
//            invertible, so different v give different bits
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
    uvec4 far;  // z = 1: the corners in the same order
};

// The bits of the cell with the given lowest corner.
//   corner   integers, |corner| < 2^31
//   formula  stirredBits(dot(corner, LATTICE_STEP)), integers modulo 2^32
// Two lattice points have the same bits if the product of their difference and LATTICE_STEP is 0 modulo 2^32. The
// nearest two such points are 1,565 cells apart, so within a ball of radius 780 cells all points have different bits.
CellBits cellBits(ivec3 corner)
{
    uvec3 steps = uvec3(corner) * LATTICE_STEP;
    uint lowest = steps.x + steps.y + steps.z;
    uvec4 near = lowest + uvec4(0u, LATTICE_STEP.x, LATTICE_STEP.y, LATTICE_STEP.x + LATTICE_STEP.y);
    return CellBits(stirredBits(near), stirredBits(near + LATTICE_STEP.z));
}

// A smooth step from 0 to 1 whose slope and curvature are 0 at both ends.
//   x        in [0, 1], per component
//   formula  6 x^5 - 15 x^4 + 10 x^3
// Source: K. Perlin, 'Improving noise', SIGGRAPH 2002.
vec3 quinticFade(vec3 x)
{
    return x * x * x * (x * (6.0 * x - 15.0) + 10.0);
}

// The slope of quinticFade: at most 15/8, at x = 1/2.
//   formula  30 x^2 (1 - x)^2
vec3 quinticSlope(vec3 x)
{
    vec3 q = x * (1.0 - x);
    return 30.0 * q * q;
}

// A smooth interpolation of eight numbers at the corners of a cell.
//   x          position in the cell, in [0, 1] per component
//   near, far  the numbers, in the order of CellBits
//   returns    value (x), gradient (yzw). The gradient is never longer than 15/8 times the range of the eight
//              numbers. It reaches this length in the middle of a cell with one number at the corners of a face
//              and another number at the corners of the opposite face
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

// Value noise: random numbers at the lattice points, interpolated between the points.
//   p        scene units
//   returns  value in [0, 1), gradient; twice continuously differentiable; the gradient is never longer than
//            VALUE_STRETCH. Rounding may take the value out of this range by about 1e-6
vec4 valueNoise(vec3 p)
{
    vec3 corner = floor(p);
    CellBits bits = cellBits(ivec3(corner));
    ivec4 near = ivec4(bits.near >> 8u), far = ivec4(bits.far >> 8u); // int to float is faster than uint to float
    return blendedValues(p - corner, vec4(near) / 16777216.0, vec4(far) / 16777216.0);
}

// Two Lipschitz constants, each the smallest that holds for all numbers and directions at the corners. The first
// is proved in docs/12_textures.md, where a computation on a grid shows that the second is never exceeded.
const float VALUE_STRETCH = 1.875;        // 15/8: of the fade on one axis, and of valueNoise in space
const float GRADIENT_STRETCH = 2.7922885; // sqrt(499) / 8: of gradientNoise

// The direction of the gradient at a lattice point, length 1, from the point's bits.
//   formula  three odd numbers from -1023 to 1023, ten bits each, normalised: never (0, 0, 0)
vec3 latticeDirection(uint bits)
{
    ivec3 k = ivec3(uvec3(bits, bits >> 10u, bits >> 20u) & 1023u);
    return normalize(vec3(2 * k - 1023));
}

// The contribution of one corner to gradient noise: a linear function that is 0 at the corner, multiplied by
// the corner's weight.
//   x          position in the cell
//   corner     0 or 1 per component
//   direction  of the gradient at that corner, length 1
//   formula    weight(x) dot(direction, x - corner), and its gradient
vec4 cornerSlope(vec3 x, vec3 corner, vec3 direction)
{
    vec3 u = quinticFade(x), away = x - corner;
    vec3 share = mix(1.0 - u, u, corner), slope = (2.0 * corner - 1.0) * quinticSlope(x);
    float weight = share.x * share.y * share.z, height = dot(direction, away);
    return vec4(weight * height, weight * direction + height * slope * share.yzx * share.zxy);
}

// Gradient noise: 0 at every lattice point, with a gradient of length 1 in a random direction there.
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

// The offset of the next octave's lattice, so that the lattices of two octaves have no common points: at such
// points all octaves of gradient noise would be 0, and so would all gradients of value noise.
const vec3 OCTAVE_SHIFT = vec3(17.17, 5.31, 29.73);

// The sum of the first count terms of 1, ratio, ratio^2 and so on.
//   count    >= 1
//   formula  added term by term; the limit for a large count is 1 / (1 - ratio) if |ratio| < 1
float geometricSum(float ratio, int count)
{
    float sum = 0.0, term = 1.0;
    for (int i = 0; i < count; i++) {
        sum += term;
        term *= ratio;
    }
    return sum;
}

// A sum of octaves of value noise, each finer and weaker than the octave before, divided by the sum of their weights.
//   count       number of octaves, >= 1
//   gain        weight of an octave divided by that of the octave before, in (0, 1]
//   lacunarity  cells per unit of an octave divided by those of the octave before, >= 1
//   returns     value in [0, 1) up to rounding, about 1e-6; gradient, never longer than octaveStretch
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

// A Lipschitz constant of octaveNoise: an upper bound. It would be reached only where the steepest points of
// all octaves coincide, which is very unlikely.
//   formula  VALUE_STRETCH sum of (gain lacunarity)^i / sum of gain^i; for gain < 1, this is bounded for all
//            counts if and only if gain lacunarity < 1
float octaveStretch(int count, float gain, float lacunarity)
{
    return VALUE_STRETCH * geometricSum(gain * lacunarity, count) / geometricSum(gain, count);
}
