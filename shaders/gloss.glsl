// gloss.glsl - light that a rough surface mirrors: two models of its highlight.
//
// A surface that is rough on a small scale is a crowd of little mirrors. A model says how many of them
// stand so that they send a lamp's light to the eye: those whose normal is halfway between the two ways.
// Each function returns, per steradian, the light towards the eye for light of 1 from a direction, on a
// surface of which each mirror sends back all: the share that it does, as schlickShare has it, is a
// factor of the caller's, and so is the cosine of Lambert's law.

const float GLOSS_PI = 3.14159265;

// The direction halfway between two, that of the mirrors that send light from one to the other.
//   toLight, toEye  length 1 each, not opposite
//   formula         normalize(toLight + toEye)
vec3 halfway(vec3 toLight, vec3 toEye)
{
    return normalize(toLight + toEye);
}

// Blinn's and Phong's highlight, normalised: a power of the cosine.
//   normal, toLight, toEye  length 1 each
//   exponent  n, >= 0: the larger, the smaller the highlight
//   formula   (n + 2) (n + 4) / (8 pi (n + 2^(-n/2))) dot(normal, halfway)^n; the factor makes the
//             surface send back all the light that comes straight down; of any other less, and as much
//             only where n = 0
// Source: J. F. Blinn, 'Models of light reflection for computer synthesized pictures', SIGGRAPH 1977;
// the factor by F. Giesen, 2009. The usual (n + 8) / (8 pi) sends back up to 1.08 of the light.
float blinnPhongGloss(vec3 normal, vec3 toLight, vec3 toEye, float exponent)
{
    float cosine = max(dot(normal, halfway(toLight, toEye)), 0.0);
    float factor = (exponent + 2.0) * (exponent + 4.0) /
                   (8.0 * GLOSS_PI * (exponent + exp2(-0.5 * exponent)));
    return factor * pow(cosine, exponent);
}

// How densely the little mirrors of the GGX model stand with their normals towards a direction.
//   cosine   between the surface's normal and that direction, in [0, 1]
//   alpha    in (0, 1]: tangent of a typical slope
//   formula  alpha^2 / (pi (cosine^2 (alpha^2 - 1) + 1)^2); the mirrors' area, seen along the normal, adds
//            up to 1
// Source: T. S. Trowbridge, K. P. Reitz (1975); B. Walter and others, 'Microfacet models for refraction
// through rough surfaces', EGSR 2007.
float ggxDensity(float cosine, float alpha)
{
    float a2 = alpha * alpha;
    float below = cosine * cosine * (a2 - 1.0) + 1.0;
    return a2 / (GLOSS_PI * below * below);
}

// Smith's share of the mirrors that neither the way to the lamp nor that to the eye loses behind others,
// over 4 times the product of both cosines, for which the root of the one stands beside the other.
//   cosLight, cosEye  of the angles to the normal, in [0, 1], not both 0
//   formula  1 / (2 (cosLight root(cosEye) + cosEye root(cosLight))), root(c) = sqrt(a^2 + (1 - a^2) c^2)
// Source: E. Heitz, 'Understanding the masking-shadowing function', JCGT 3 (2014): heights correlated.
float smithVisibility(float cosLight, float cosEye, float alpha)
{
    float a2 = alpha * alpha;
    float light = cosEye * sqrt(a2 + (1.0 - a2) * cosLight * cosLight);
    float eye = cosLight * sqrt(a2 + (1.0 - a2) * cosEye * cosEye);
    return 0.5 / max(light + eye, 1e-6);
}

// The highlight of the GGX model.
//   normal, toLight, toEye  length 1 each
//   roughness  in (0, 1]; its square is alpha, so that equal steps look equal. Below 0.05 a float's
//              rounding shows
//   formula    ggxDensity smithVisibility; 0 where light or eye are behind the surface
// Of the light it sends back never more than all: what meets a second mirror is left out, the more of it
// the rougher, but for grazing light (over 80 degrees). build/tests/measure gloss prints how much.
float ggxGloss(vec3 normal, vec3 toLight, vec3 toEye, float roughness)
{
    float cosLight = dot(normal, toLight), cosEye = dot(normal, toEye);
    float alpha = roughness * roughness;
    float cosine = clamp(dot(normal, halfway(toLight, toEye)), 0.0, 1.0);
    float gloss = ggxDensity(cosine, alpha) * smithVisibility(max(cosLight, 0.0), max(cosEye, 0.0), alpha);
    return cosLight > 0.0 && cosEye > 0.0 ? gloss : 0.0;
}
