// lighting.glsl - how much light a matt surface receives and sends to the eye.

// The share of a lamp's light that a matt surface receives: the projected area of the surface as seen from
// the lamp.
//   normal, toLight  length 1 each
//   formula          max(dot(normal, toLight), 0); 0 if the surface faces away
// Source: J. H. Lambert, 'Photometria' (1760); report, section 1.5.3.
float lambert(vec3 normal, vec3 toLight)
{
    return max(dot(normal, toLight), 0.0);
}

// How the light of a point lamp weakens with distance, relative to a reference distance: the light spreads over a
// sphere, whose area grows as the square of the distance.
//   distance, reference  > 0, scene units
//   formula              (reference / distance)^2
float fallOff(float distance, float reference)
{
    float ratio = reference / distance;
    return ratio * ratio;
}

// Encode linear light as the values that a screen expects: the screen decodes them and then sends out the light
// that was computed.
//   light    linear red, green, blue; clamped to [0, 1] first, per channel
//   formula  12.92 v up to 0.0031308, 1.055 v^(1/2.4) - 0.055 above
// Source: IEC 61966-2-1 (sRGB).
vec3 encodeSRGB(vec3 light)
{
    vec3 v = clamp(light, 0.0, 1.0);
    vec3 low = 12.92 * v;
    vec3 high = 1.055 * pow(v, vec3(1.0 / 2.4)) - 0.055;
    return mix(high, low, vec3(lessThanEqual(v, vec3(0.0031308))));
}
