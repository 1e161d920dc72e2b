// ramp.glsl - an ordered scale of colours that shows a number at each pixel.

// Compiled only with views.glsl, and in an exported file, which has no views.
#if !defined(VIEW) || VIEW_OF_TRACE

// Colours, encoded for the screen, from night blue through teal and green to yellow. The lightness
// L of OKLab rises linearly from 0.17 to 0.95 while the hue turns from 285 to 105 degrees: equal
// steps look equal, and the order is also visible in greys, so nobody needs to tell red from green.
// Source of OKLab: B. Ottosson, 'A perceptual color space for image processing' (2020).
const vec3 RAMP[9] = vec3[9](
    vec3(0.057, 0.020, 0.187), vec3(0.036, 0.131, 0.331), vec3(0.010, 0.263, 0.395),
    vec3(0.012, 0.390, 0.466), vec3(0.035, 0.523, 0.523), vec3(0.024, 0.666, 0.538),
    vec3(0.373, 0.791, 0.482), vec3(0.702, 0.881, 0.439), vec3(0.994, 0.957, 0.451));

// The colour of the ramp at x in [0, 1].
vec3 evenRamp(float x)
{
    int i = min(int(8.0 * x), 7);
    return mix(RAMP[i], RAMP[i + 1], 8.0 * x - float(i));
}

#endif
