// combine.glsl - combinations of volumes: from two distances to one.
//
// a and b are the signed distances of two volumes at one point, or lower bounds of them, scene units. If
// both are 1-Lipschitz, so is each result. The result then never exceeds the distance to the surface on
// which it is 0, inside or outside, and a march needs no step factor anywhere.

// The points in a or b.
//   formula  min(a, b)
//   exact outside if a and b are; inside it is a lower bound of the depth: where two balls overlap, part of
//   each surface is hidden inside the other ball, but min still counts that part
// Source: report, section 2.
float opUnion(float a, float b)
{
    return min(a, b);
}

// The points in both a and b.
//   formula  max(a, b)
//   exact inside if a and b are; outside it is a lower bound: above the rim of a lens, the nearest point of
//   each ball does not belong to the other
// Source: report, section 2.
float opIntersection(float a, float b)
{
    return max(a, b);
}

// The points in a but not in b: the intersection of a with the outside of b.
//   formula  max(a, -b)
//   exact inside if a and b are; outside it is a lower bound
// Source: report, section 2.
float opSubtraction(float a, float b)
{
    return max(a, -b);
}

// The union with its crease filled in.
//   k        width of the blend, scene units, > 0: where |a - b| >= k the result is min(a, b)
//   formula  min(a, b) - h^3 / (6 k^2), h = max(k - |a - b|, 0)
//   a lower bound of the distance to the surface on which it is 0, outside and inside. Its value is at most
//   min(a, b) and at least min(a, b) - k / 6, which it reaches where a = b. It is twice continuously
//   differentiable in a and b
// Source: I. Quilez, 'Smooth minimum', the cubic version.
float opSmoothUnion(float a, float b, float k)
{
    float h = max(k - abs(a - b), 0.0);
    return min(a, b) - h * h * h / (6.0 * k * k);
}

// The weight of b in a smooth union, for mixing in its colour: 0 where only a counts, 1/2 where a = b,
// 1 where only b counts.
//   k        as for opSmoothUnion
//   formula  the slope of opSmoothUnion in b: h^2 / (2 k^2) where a < b, otherwise 1 - h^2 / (2 k^2)
//   in [0, 1]; the weight of a is 1 minus this weight, the slope of opSmoothUnion in a
float smoothUnionShare(float a, float b, float k)
{
    float h = max(k - abs(a - b), 0.0);
    float lesser = h * h / (2.0 * k * k);
    return a < b ? lesser : 1.0 - lesser;
}

// The union with its crease filled in by a parabola. It takes two products fewer than opSmoothUnion and fills the
// crease further.
//   k        width of the blend, scene units, > 0: where |a - b| >= k the result is min(a, b)
//   formula  min(a, b) - h^2 / (4 k), h = max(k - |a - b|, 0)
//   a lower bound, as opSmoothUnion is. Its value is at most min(a, b) and at least min(a, b) - k / 4, which
//   it reaches where a = b. It is once continuously differentiable in a and b, so a highlight reveals where
//   the blend begins
// Source: I. Quilez, 'Smooth minimum', the quadratic version.
float opSmoothUnionQuadratic(float a, float b, float k)
{
    float h = max(k - abs(a - b), 0.0);
    return min(a, b) - h * h / (4.0 * k);
}

// The weight of b in the quadratic union: 0 where only a counts, 1/2 where a = b, 1 where only b counts,
// and linear between.
//   k        as for opSmoothUnionQuadratic
//   formula  the slope of opSmoothUnionQuadratic in b: h / (2 k) where a < b, otherwise 1 - h / (2 k); that is
//            clamp(1/2 + (a - b) / (2 k), 0, 1)
//   in [0, 1]; the weight of a is 1 minus this weight, the slope of opSmoothUnionQuadratic in a
float smoothUnionQuadraticShare(float a, float b, float k)
{
    return clamp(0.5 + (a - b) / (2.0 * k), 0.0, 1.0);
}
