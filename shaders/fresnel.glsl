// fresnel.glsl - how much light a smooth surface mirrors.

// The share of the light that the surface of water or glass sends back as a mirror does, whatever its
// polarisation.
//   facing    cosine of the angle between the normal and the way to the eye, in [0, 1]
//   straight  the share mirrored when one looks straight at it, ((n - 1) / (n + 1))^2 with the index of
//             refraction n: 0.02 for water (1.333), 0.04 for glass (1.5)
//   returns   in [straight, 1]: straight at facing = 1, 1 at facing = 0
//   formula   straight + (1 - straight) (1 - facing)^5, which stands for Fresnel's; for water it is
//             off by at most 0.060, for glass by 0.036, where one looks along the surface (facing 0.1)
// Source: C. Schlick, 'An inexpensive BRDF model for physically-based rendering', Computer Graphics
// Forum 13 (1994).
float schlickShare(float facing, float straight)
{
    float grazing = 1.0 - facing, square = grazing * grazing;
    return straight + (1.0 - straight) * square * square * grazing;
}
