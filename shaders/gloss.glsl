// gloss.glsl - light that a rough surface reflects: two models of its highlight.
//
// A surface that is rough on a small scale consists of many tiny mirrors. A model determines how many of them
// send a lamp's light to the eye: those whose normal is halfway between the directions to lamp and eye.
// Each function returns the light that is sent towards the eye, per steradian, for light of 1 from one direction
// on a surface whose mirrors reflect all light. The caller multiplies it by the share that real mirrors reflect, as
// given by schlickShare, and by the cosine of Lambert's law.

const float GLOSS_PI = 3.14159265;

// The direction halfway between two directions: the normal of the mirrors that send light from one to the other.
//   toLight, toEye  length 1 each, not opposite
//   formula         normalize(toLight + toEye)
vec3 halfway(vec3 toLight, vec3 toEye)
{
    return normalize(toLight + toEye);
}

// The Blinn-Phong highlight, normalised: a power of the cosine.
//   normal, toLight, toEye  length 1 each
//   exponent  n, >= 0: the larger the exponent, the smaller the highlight
//   formula   (n + 2) (n + 4) / (8 pi (n + 2^(-n/2))) dot(normal, halfway)^n. With this factor the surface
//             reflects all light that arrives along the normal, and less of the light from any other direction,
//             except for n = 0, where it reflects all light
// Source: J. F. Blinn, 'Models of light reflection for computer synthesized pictures', SIGGRAPH 1977;
// the factor by F. Giesen, 2009. With the usual factor (n + 8) / (8 pi), up to 1.08 times the light that arrives is
// reflected.
float blinnPhongGloss(vec3 normal, vec3 toLight, vec3 toEye, float exponent)
{
    float cosine = max(dot(normal, halfway(toLight, toEye)), 0.0);
    float factor = (exponent + 2.0) * (exponent + 4.0) /
                   (8.0 * GLOSS_PI * (exponent + exp2(-0.5 * exponent)));
    return factor * pow(max(cosine, 1e-6), exponent); // pow(0, 0) is undefined
}

// How densely the normals of the GGX model's mirrors are distributed around a direction.
//   cosine   between the surface's normal and that direction, in [0, 1]
//   alpha    in (0, 1]: a typical slope of the mirrors
//   formula  alpha^2 / (pi (cosine^2 (alpha^2 - 1) + 1)^2); the areas of the mirrors, projected along the
//            normal, sum to 1
// Source: T. S. Trowbridge, K. P. Reitz (1975); B. Walter and others, 'Microfacet models for refraction
// through rough surfaces', EGSR 2007.
float ggxDensity(float cosine, float alpha)
{
    float a2 = alpha * alpha;
    float below = cosine * cosine * (a2 - 1.0) + 1.0;
    return a2 / (GLOSS_PI * below * below);
}

// Smith's share of mirrors that other mirrors hide neither from the lamp nor from the eye, divided by 4 times
// the product of both cosines. The product cancels, which leaves each cosine beside the root of the other.
//   cosLight, cosEye  of the angles to the normal, in [0, 1], not both 0
//   formula  1 / (2 (cosLight root(cosEye) + cosEye root(cosLight))), root(c) = sqrt(a^2 + (1 - a^2) c^2), a = alpha
// Source: E. Heitz, 'Understanding the masking-shadowing function', JCGT 3 (2014): its height-correlated form.
float smithVisibility(float cosLight, float cosEye, float alpha)
{
    float a2 = alpha * alpha;
    float light = cosEye * sqrt(a2 + (1.0 - a2) * cosLight * cosLight);
    float eye = cosLight * sqrt(a2 + (1.0 - a2) * cosEye * cosEye);
    return 0.5 / max(light + eye, 1e-6);
}

// The highlight of the GGX model.
//   normal, toLight, toEye  length 1 each
//   roughness  in (0, 1]; its square is alpha, so that equal steps of roughness look equal. Below 0.05 the
//              rounding of floats is visible
//   formula    ggxDensity smithVisibility; 0 if lamp or eye is behind the surface
// The model never reflects more light than arrives. It leaves out the light that meets a second mirror: the rougher
// the surface, the more light is left out, except at grazing angles (over 80 degrees). build/tests/measure gloss
// prints how much.
float ggxGloss(vec3 normal, vec3 toLight, vec3 toEye, float roughness)
{
    float cosLight = dot(normal, toLight), cosEye = dot(normal, toEye);
    float alpha = roughness * roughness;
    float cosine = clamp(dot(normal, halfway(toLight, toEye)), 0.0, 1.0);
    float gloss = ggxDensity(cosine, alpha) * smithVisibility(max(cosLight, 0.0), max(cosEye, 0.0), alpha);
    return cosLight > 0.0 && cosEye > 0.0 ? gloss : 0.0;
}
