// coverage.glsl - patterns averaged over the width of a pixel: shares instead of yes or no.
//
// Widths and positions have the same unit, that of the pattern. The width of a pixel on a surface grows with
// the distance and with 1 / cosine of the angle between ray and normal.

// The share of a pixel that lies inside a straight edge.
//   inside   how far inside the edge the middle of the pixel is; negative outside
//   width    of the pixel perpendicular to the edge, >= 0
//   formula  clamp(inside / (width + 0.001) + 1/2, 0, 1): exact except for the 0.001, which avoids a division
//            by 0; with a width of 0, the result is 0 or 1 except within 0.0005 of the edge
float coverage(float inside, float width)
{
    return clamp(inside / (width + 0.001) + 0.5, 0.0, 1.0);
}

// The length that stripes of period 1 and width filled, centred at the integers, cover between 0 and x; below 0 it is
// negative.
float stripedLength(float x, float filled)
{
    float nearest = floor(x + 0.5);
    return filled * nearest + clamp(x - nearest, -0.5 * filled, 0.5 * filled);
}

// The share of a pixel covered by stripes of period 1, centred at 1/2, 3/2 and so on.
//   x        position across the stripes, in periods
//   filled   the share of each period that a stripe fills, in [0, 1]
//   width    of the pixel, >= 0. It counts as 0.001 wider, which avoids a division by 0
//   formula  the difference of stripedLength at the two ends of the pixel, divided by its width: exact
float stripes(float x, float filled, float width)
{
    float from = fract(x) - 0.5, wide = width + 0.001;
    return (stripedLength(from + 0.5 * wide, filled) - stripedLength(from - 0.5 * wide, filled)) / wide;
}

// How far a pattern of period 1 has blurred into its mean: 0 if a pixel is narrower than 0.4, 1 from a width of 1 on. The
// pattern to show is mix(stripes, filled, blurred): where a pixel is about as wide as a period, the shares of neighbouring
// pixels would show slow waves that are not in the pattern.
float blurred(float width)
{
    return smoothstep(0.4, 1.0, width);
}
