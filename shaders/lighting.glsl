// lighting.glsl - how much light a matt surface receives and sends to the eye.

// The share of a lamp's light that a matt surface catches: the projected area of the surface as the
// lamp sees it.
//   normal, toLight  length 1 each
//   formula          max(dot(normal, toLight), 0); 0 when the surface turns its back
// Source: J. H. Lambert, 'Photometria' (1760); report, section 1.5.3.
float lambert(vec3 normal, vec3 toLight)
{
    return max(dot(normal, toLight), 0.0);
}

// How a point light weakens with distance, as a factor that is 1 at a reference distance: the light
// of a point spreads over a sphere, whose area grows as the square of the distance.
//   distance, reference  > 0, scene units
//   formula              (reference / distance)^2
float fallOff(float distance, float reference)
{
    float ratio = reference / distance;
    return ratio * ratio;
}

// From linear light to the numbers that a screen expects, so that the screen, which decodes them,
// sends out the light that was computed.
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
