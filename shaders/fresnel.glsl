// fresnel.glsl - how much light a smooth surface reflects.

// The share of the light that a surface of water or glass reflects, averaged over polarisations.
//   facing    cosine of the angle between the normal and the direction to the eye, in [0, 1]
//   straight  the share reflected at normal incidence, ((n - 1) / (n + 1))^2 with the index of
//             refraction n: 0.02 for water (1.333), 0.04 for glass (1.5)
//   returns   in [straight, 1]: straight at facing = 1, 1 at facing = 0
//   formula   straight + (1 - straight) (1 - facing)^5, which approximates Fresnel's formula with an error
//             of at most 0.060 for water and 0.036 for glass, at a grazing angle (facing 0.1)
// Source: C. Schlick, 'An inexpensive BRDF model for physically-based rendering', Computer Graphics
// Forum 13 (1994).
float schlickShare(float facing, float straight)
{
    float grazing = 1.0 - facing, square = grazing * grazing;
    return straight + (1.0 - straight) * square * square * grazing;
}

// The exact share of light that a smooth boundary between two clear media reflects, for unpolarised light:
// the mean over the two polarisations.
//   facing   cosine of the angle between the normal and the ray, on the side from which it comes, in [0, 1]
//   eta      index of refraction on that side divided by the index on the other, > 0, as for GLSL's refract
//   returns  in [0, 1]; 1 where no light is transmitted: total reflection, eta^2 (1 - facing^2) >= 1
//   formula  with c = facing, g = sqrt(1 - eta^2 (1 - c^2)), the cosine behind the boundary:
//            1/2 ((eta c - g) / (eta c + g))^2 + 1/2 ((c - eta g) / (c + eta g))^2
// The share is the same from both sides: fresnelShare(c, eta) = fresnelShare(g, 1 / eta). At c = 1 it is
// ((1 - eta) / (1 + eta))^2.
// Source: A. Fresnel, 'Mémoire sur la loi des modifications que la réflexion imprime à la lumière polarisée'
// (1823); M. Born, E. Wolf, 'Principles of Optics', section 1.5.
float fresnelShare(float facing, float eta)
{
    float square = 1.0 - eta * eta * (1.0 - facing * facing);
    float behind = sqrt(max(square, 0.0));
    float across = (eta * facing - behind) / (eta * facing + behind);
    float along = (facing - eta * behind) / (facing + eta * behind);
    return square > 0.0 ? 0.5 * (across * across + along * along) : 1.0;
}
