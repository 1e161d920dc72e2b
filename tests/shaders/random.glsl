// random.glsl - random numbers for the tests. They are the same on every machine, because they come from integers that
// a float represents exactly.

uint seed; // advances with every number

// The next 32 random bits.
// Source: M. E. O'Neill, 'PCG: A family of simple fast space-efficient statistically good algorithms
// for random number generation' (2014).
uint nextBits()
{
    seed = seed * 747796405u + 2891336453u;
    uint word = ((seed >> ((seed >> 28) + 4u)) ^ seed) * 277803737u;
    return (word >> 22) ^ word;
}

// The next random number in [-1, 1).
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

// A random direction of length 1. Its distribution is not uniform, and no test needs a uniform one.
vec3 nextDirection()
{
    vec3 v = nextVector();
    return v / max(length(v), 0.001);
}
