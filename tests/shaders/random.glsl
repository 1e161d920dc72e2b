// random.glsl - random numbers for the numeric tests, the same on every machine: an integer hash, and floats that
// represent the integer exactly.

uint seed; // advances with every number

// The next 32 bits.
// Source: M. E. O'Neill, 'PCG: A family of simple fast space-efficient statistically good algorithms
// for random number generation' (2014).
uint nextBits()
{
    seed = seed * 747796405u + 2891336453u;
    uint word = ((seed >> ((seed >> 28) + 4u)) ^ seed) * 277803737u;
    return (word >> 22) ^ word;
}

// The next number in [-1, 1).
float nextSigned()
{
    return float(int(nextBits() >> 8) - 8388608) / 8388608.0;
}

vec3 nextVector()
{
    float x = nextSigned();
    float y = nextSigned();
    return vec3(x, y, nextSigned());
}

// A direction of length 1 with some distribution: no use here needs a uniform one.
vec3 nextDirection()
{
    vec3 v = nextVector();
    return v / max(length(v), 0.001);
}
