// combine.glsl - volumes made of volumes: from two distances to one.
//
// a and b are signed distances of the two volumes at one point, or lower bounds, scene units. Where
// both are 1-Lipschitz so is each result.

// What belongs to a or to b. Outside exact where a and b are; inside a lower bound of the depth.
//   formula  min(a, b)
float opUnion(float a, float b)
{
    return min(a, b);
}

// What belongs to a and to b. Inside exact where a and b are; outside a lower bound.
//   formula  max(a, b)
float opIntersection(float a, float b)
{
    return max(a, b);
}

// What belongs to a and not to b. A lower bound outside, as the intersection of a with the outside
// of b.
//   formula  max(a, -b)
float opSubtraction(float a, float b)
{
    return max(a, -b);
}

// The union with its crease filled in: a lower bound of the distance to the union's surface as it is
// drawn, never more than min(a, b), and equal to it where |a - b| >= k.
//   k        width of the blend, scene units, > 0; the surface rises by k / 6 where a = b
//   formula  min(a, b) - h^3 / (6 k^2), h = max(k - |a - b|, 0)
// Source: I. Quilez's cubic smooth minimum; report, section 1.5.5 and its smooth union.
float opSmoothUnion(float a, float b, float k)
{
    float h = max(k - abs(a - b), 0.0);
    return min(a, b) - h * h * h / (6.0 * k * k);
}

// The share of b in a smooth union, with which its colour is mixed in: 0 where a alone counts, 1/2
// where a = b, 1 where b alone counts.
//   formula  the slope of opSmoothUnion in b: h^2 / (2 k^2) where a < b, else 1 - h^2 / (2 k^2)
float smoothUnionShare(float a, float b, float k)
{
    float h = max(k - abs(a - b), 0.0);
    float lesser = h * h / (2.0 * k * k);
    return a < b ? lesser : 1.0 - lesser;
}
