// hue.glsl - colours from hue, saturation and value.
//
// The results are linear light, shares of red, green and blue, like the light of lighting.glsl. To treat them
// as screen values, as colour pickers do, decode them first.

// The pure colour of a hue: its largest channel is 1, and its smallest is 0.
//   hue      degrees; 0 red, 60 yellow, 120 green, 180 cyan, 240 blue, 300 magenta; any number, including
//            negative ones: the circle closes at 360
//   returns  linear red, green, blue in [0, 1]; between multiples of 60, two channels are constant and one
//            is linear
//   formula  channel = clamp(|mod(hue / 60 + o, 6) - 3| - 1, 0, 1), o = 0, 4, 2 for red, green, blue
// Source: A. R. Smith, 'Color gamut transform pairs', SIGGRAPH 1978; report, section 1.5.4, figure 5.
vec3 hueToRGB(float hue)
{
    vec3 position = mod(hue / 60.0 + vec3(0.0, 4.0, 2.0), 6.0);
    return clamp(abs(position - 3.0) - 1.0, 0.0, 1.0);
}

// The colour with a given hue, saturation and value.
//   hue         degrees, any number
//   saturation  in [0, 1]: 0 grey, 1 the pure hue
//   value       in [0, 1]: the largest channel
//   returns     linear red, green, blue; the smallest channel is value (1 - saturation)
//   formula     value (1 - saturation + saturation hueToRGB(hue))
// Source: A. R. Smith, 'Color gamut transform pairs', SIGGRAPH 1978.
vec3 hsvToRGB(float hue, float saturation, float value)
{
    return value * mix(vec3(1.0), hueToRGB(hue), saturation);
}
