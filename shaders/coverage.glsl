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

// The share of a pixel covered by stripes of period 1, centred at 1/2, 3/2 and so on.
//   x        position across the stripes, in periods
//   filled   the share of each period that a stripe fills, in [0, 1]
//   width    of the pixel. The result is as exact as coverage while width is at most filled and at most
//            1 - filled: then the pixel crosses at most one edge
float stripes(float x, float filled, float width)
{
    return coverage(0.5 * filled - abs(fract(x) - 0.5), width);
}

// How far a pattern of period 1 has blurred into its mean: 0 if a pixel is narrower than 0.4, 1 from a width of 1 on,
// where stripes is no longer exact. The pattern to show is mix(stripes, filled, blurred).
float blurred(float width)
{
    return smoothstep(0.4, 1.0, width);
}
