// sobol.glsl - pairs of numbers that fill the unit square evenly, one for each sample of a pixel.
//
// Sobol's sequence of points in the unit square: of its first 2^k points, each of the 2^k equal rectangles of any shape
// 2^-i by 2^-(k-i) contains exactly one. Scrambling gives each pixel points of its own, which keep this property, and
// each of which is uniformly distributed. docs/24_bounces.md proves the claims made here.
#include "random.glsl"

// The bits of v from last to first.
uint reverseBits(uint v)
{
    v = ((v >> 1u) & 0x55555555u) | ((v & 0x55555555u) << 1u);
    v = ((v >> 2u) & 0x33333333u) | ((v & 0x33333333u) << 2u);
    v = ((v >> 4u) & 0x0F0F0F0Fu) | ((v & 0x0F0F0F0Fu) << 4u);
    v = ((v >> 8u) & 0x00FF00FFu) | ((v & 0x00FF00FFu) << 8u);
    return (v >> 16u) | (v << 16u);
}

// The second coordinate of point n of Sobol's sequence, multiplied by 2^32, with its bits reversed. (The first
// coordinate with its bits reversed is n itself.)
//   formula  bit j of the result is the sum of C(i, j) times bit i of n over all i, modulo 2. Modulo 2, this triangle
//            of Pascal has the block form (T T; 0 T), in which T is the triangle of half the size, so five steps
//            with halves, quarters and so on replace a product with a matrix of 32 x 32 bits
// Source: I. M. Sobol' (1967) for the sequence.
uint pascalSum(uint n)
{
    n ^= n >> 16u;
    n ^= (n >> 8u) & 0x00FF00FFu;
    n ^= (n >> 4u) & 0x0F0F0F0Fu;
    n ^= (n >> 2u) & 0x33333333u;
    return n ^ ((n >> 1u) & 0x55555555u);
}

// A random permutation of the 32-bit integers in which each bit of the result depends only on this bit and the bits
// below it.
//   seed     chooses the permutation
//   formula  v + seed; then four times v ^= v c, where c is an even constant: the product moves every bit of v up
// For integers with reversed bits, this is Owen's scrambling: it exchanges the halves of the unit interval, the halves of
// these halves, and so on, each or not by a toss of a coin of its own.
// Source: A. B. Owen, 'Randomly permuted (t, m, s)-nets and (t, s)-sequences' (1995), for the scrambling; S. Laine,
// T. Karras, 'Stratified sampling for stochastic transparency', Computer Graphics Forum 30 (2011), for the products and
// their constants; B. Burley, 'Practical hash-based Owen scrambling', Journal of Computer Graphics Techniques 9 (2020),
// for their use with Sobol's points.
uint upwards(uint v, uint seed)
{
    v += seed;
    v ^= v * 0x6C50B47Cu;
    v ^= v * 0xB82F1E52u;
    v ^= v * 0xC7AFE638u;
    return v ^ (v * 0x8D22F6E6u);
}

// Point n of a scrambled Sobol sequence, both coordinates in [0, 1).
//   n        from 0; points 0 to 2^k - 1, and each later block of 2^k points, are a net: each of the 2^k equal
//            rectangles of any shape contains one
//   seeds    for the order of the points and for the two coordinates
//   formula  n is replaced with a scrambled n, which changes the order within each block, so that two sequences with
//            different seeds can be used together; then both coordinates are scrambled
vec2 sobolPoint(uint n, uvec3 seeds)
{
    uint m = reverseBits(upwards(reverseBits(n), seeds.x));
    uvec2 point = uvec2(upwards(m, seeds.y), upwards(pascalSum(m), seeds.z));
    return vec2(reverseBits(point.x) >> 8u, reverseBits(point.y) >> 8u) / 16777216.0;
}

// Two numbers for a sample of this pixel, as two calls of pixelRandom would give. In all samples of the pixel together
// they fill the unit square evenly. For a given pixel, sample and pair they are the same on every machine.
//   index    of the sample, >= 0
//   pair     index of this pair within the sample, >= 0: pairs with different indices have sequences of their own
vec2 pixelPair(int index, int pair)
{
    return sobolPoint(uint(index), hashOf(uvec4(uvec2(iPixel), uint(pair), 0x50B01u)).xyz);
}
