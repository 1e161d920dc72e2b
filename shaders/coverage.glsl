// coverage.glsl - patterns seen through the width of a pixel: shares in place of yes and no.
//
// Widths and places have one unit, that of the pattern. The width of a pixel on a surface grows with the
// distance and with 1 / cosine of the angle between ray and normal.

// The share of a pixel that lies inside a straight edge.
//   inside   how far inside the edge the middle of the pixel lies, negative outside
//   width    of the pixel across the edge, >= 0
//   formula  clamp(inside / (width + 0.001) + 1/2, 0, 1): exact but for the 0.001, which keeps a width
//            of 0 from dividing; then it is 0 or 1 but within 0.0005 of the edge
float coverage(float inside, float width)
{
    return clamp(inside / (width + 0.001) + 0.5, 0.0, 1.0);
}

// The share of a pixel that stripes of period 1 cover, one around 1/2, 3/2 and so on.
//   filled   the share of each period that a stripe fills, in [0, 1]
//   width    exact, as coverage is, while it is at most filled and at most 1 - filled: then one edge at
//            most cuts the pixel
float stripes(float x, float filled, float width)
{
    return coverage(0.5 * filled - abs(fract(x) - 0.5), width);
}

// How far a pattern of period 1 has become its mean: 0 where a pixel is narrower than 0.4, 1 from 1 on,
// where stripes is no longer exact. The pattern to show is mix(stripes, filled, blurred).
float blurred(float width)
{
    return smoothstep(0.4, 1.0, width);
}
