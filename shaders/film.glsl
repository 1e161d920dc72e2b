// film.glsl - from the light of a picture to the values that are written: exposure, vignette, the film's
// curve, contrast, dither. Light is linear except where contrast and dither say otherwise.
// docs/15_the_picture.md proves the claims made here.

// The light of a picture with a longer or shorter exposure.
//   light    linear, >= 0
//   stops    any value; each stop doubles the light
//   formula  2^stops light
vec3 exposed(vec3 light, float stops)
{
    return exp2(stops) * light;
}

// The share of the light that a simple lens sends to a point off its axis.
//   screen       y from -1 to 1, x from -aspect to aspect
//   focalLength  half screen heights, > 0
//   returns      1 in the middle
//   formula      cos^4 a = (f^2 / (f^2 + |screen|^2))^2, where a is the angle between ray and axis. Exact for
//                a flat film behind a small opening, with no lens to correct the loss
float cosineFourth(vec2 screen, float focalLength)
{
    float square = focalLength * focalLength;
    float cosineSquare = square / (square + dot(screen, screen));
    return cosineSquare * cosineSquare;
}

// Raise the contrast in the middle of the range and lower it at both ends.
//   v        per channel, clamped to [0, 1] first; encoded for the screen, where 1/2 is close to middle grey (in
//            linear light, 1/2 is bright, and the picture would become dark)
//   amount   in [0, 1]: 0 leaves v unchanged, 1 is smoothstep(0, 1, v)
//   formula  v + amount (3 v^2 - 2 v^3 - v): 0, 1/2 and 1 are fixed, the slope in the middle is
//            1 + amount / 2 and at both ends 1 - amount. The result increases with v
vec3 contrast(vec3 v, float amount)
{
    return mix(clamp(v, 0.0, 1.0), smoothstep(0.0, 1.0, v), amount);
}

// The response of a film to light: a straight line in the middle of a logarithmic scale, with a toe in the
// dark range and a shoulder in the bright range, where the contrast is lower.
//   x        linear light, per channel; negative values count as 0
//   gamma    >= 1: how steep the line is. On a logarithmic scale, its slope at middle grey is
//            0.82 gamma / (1 - (0.18 / white)^gamma)
//   white    > 1: the light that becomes 1, as does all brighter light
//   formula  (1 + kappa / w) / (1 + kappa / h), h = x^gamma, w = white^gamma, with kappa = 0.82 g w /
//            (0.18 w - g), g = 0.18^gamma, so that middle grey, 0.18, is unchanged. The result increases with x
//            from 0 to 1
// Source: the shape of F. Hurter and V. C. Driffield's curves (1890), as a logistic function.
vec3 filmCurve(vec3 x, float gamma, float white)
{
    float g = pow(0.18, gamma), w = pow(white, gamma);
    float kappa = 0.82 * g * w / (0.18 * w - g);
    vec3 h = pow(clamp(x, 1e-6, white), vec3(gamma));
    return (1.0 + kappa / w) / (1.0 + kappa / h);
}

// filmCurve applied to the largest channel. The other channels are scaled by the same factor, which keeps their ratios
// and therefore the hue.
//   light    linear, >= 0
//   gamma, white  as for filmCurve
//   formula  light filmCurve(m) / m, m the largest channel
vec3 filmOfLargest(vec3 light, float gamma, float white)
{
    float largest = max(max(light.r, max(light.g, light.b)), 1e-6);
    return light * (filmCurve(vec3(largest), gamma, white).r / largest);
}

// The dither value to add to a pixel's colour before it is rounded, from a pattern of 8 x 8 pixels that repeats.
//   pixel    of the picture, as iPixel; any integers
//   returns  one of (j + 1/2) / 64 - 1/2, j = 0 to 63: each once in every 8 x 8 pixels, with mean 0. Multiply
//            by one step of the file, 1 / 255, and add to an encoded colour
//   formula  the bits of j, from the highest: bit 0 of x ^ y, bit 0 of y, bit 1 of x ^ y, and so on
// Source: B. E. Bayer, 'An optimum method for two-level rendition of continuous-tone pictures', ICC 1973.
float ditherStep(ivec2 pixel)
{
    int y = pixel.y, both = pixel.x ^ pixel.y;
    int j = ((both & 1) << 5) | ((y & 1) << 4) | ((both & 2) << 2) | ((y & 2) << 1) | ((both & 4) >> 1) |
            ((y & 4) >> 2);
    return (float(j) + 0.5) / 64.0 - 0.5;
}
