// fog.glsl - light on its way through fog: the light that is lost, and the light that the fog itself sends to the eye.
//
// The fog's density is the share of the light that it removes per scene unit: a ray loses the share density dt over
// the length dt. The density is uniform or falls with the height y as exp(-y / scale). docs/15_the_picture.md proves
// the claims made here.
#include "sky.glsl"

// The mean of exp(-s) over s in [0, x].
//   x        >= 0; a ray that descends is measured from its lower end, so no other x is needed
//   returns  1 at 0, 1 / x for large x
//   formula  (1 - exp(-x)) / x; below 0.2 the first terms of its series, because the difference of two
//            numbers near 1 would leave few digits: 1 - x / 2 + x^2 / 6 - x^3 / 24 + x^4 / 120
float meanDecay(float x)
{
    float series = 1.0 - x * (0.5 - x * (1.0 / 6.0 - x * (1.0 / 24.0 - x / 120.0)));
    return x < 0.2 ? series : (1.0 - exp(-x)) / max(x, 0.2);
}

// The optical depth of a piece of a ray: the integral of the density along the piece.
//   height   y where the piece begins, scene units
//   climb    how y grows along the ray: the direction's y, in [-1, 1]
//   t        length of the piece, scene units, >= 0
//   density  at y = 0, per scene unit, >= 0
//   scale    the height over which the density falls to 1 / e, scene units, > 0; 1e6 gives a uniform fog
//   formula  density exp(-low / scale) t meanDecay(|climb| t / scale), where low is the y of the lower end. It is exact
float fogDepth(float height, float climb, float t, float density, float scale)
{
    float low = height + min(climb * t, 0.0);
    return density * exp(-low / scale) * t * meanDecay(abs(climb) * t / scale);
}

// The optical depth of a whole ray to the sky.
//   the parameters are those of fogDepth
//   formula  density exp(-height / scale) scale / climb, the limit as t tends to infinity. If climb is less than 1e-5,
//            as it is below the horizon, 1e-5 replaces it. The formula is exact otherwise
float skyFogDepth(float height, float climb, float density, float scale)
{
    return density * exp(-height / scale) * scale / max(climb, 1e-5);
}

// The point of a ray at which the optical depth from its start has a given value: the inverse of fogDepth.
//   depth    in [0, the depth of the whole piece]
//   the other parameters are those of fogDepth
//   returns  t, scene units. The density at the start of the ray counts as at least 1e-12, so above some twenty scales
//            t is too short; and a ray that climbs is followed up to 1 - x = 1e-6, fourteen scales higher
//   formula  t = -(scale / climb) log(1 - x), x = depth climb / (density exp(-height / scale) scale); where
//            |x| < 0.02, the first terms of the series, depth / b (1 + x / 2 + x^2 / 3 + x^3 / 4), b the
//            density at the start of the ray
float inverseFogDepth(float height, float climb, float depth, float density, float scale)
{
    float start = max(density * exp(-height / scale), 1e-12);
    float x = depth * climb / (start * scale);
    float series = 1.0 + x * (0.5 + x * (1.0 / 3.0 + x / 4.0));
    float quotient = -log(max(1.0 - x, 1e-6)) / x;
    return depth / start * (abs(x) < 0.02 ? series : quotient);
}

// The light of the fog in a direction: the light that the fog sends to the eye where it is too thick to see through.
//   direction, toSun  length 1
//   ambient  light of the sky that the fog scatters, the same in all directions
//   sun      light of the sun that the fog scatters straight ahead
//   g        the mean cosine of the scattering angle, in [0, 1): 0.6 to 0.9 for mist
//   formula  ambient + sun glow(direction, toSun, g): light scattered once, with Henyey and Greenstein's
//            share for each angle. This is a model: light scattered more than once is only in the ambient part
vec3 fogLight(vec3 direction, vec3 toSun, vec3 ambient, vec3 sun, float g)
{
    return ambient + sun * glow(direction, toSun, g);
}

// The light that remains after a path through fog, plus the light of the fog.
//   light    from behind the fog, linear
//   fog      light of the fog, from fogLight
//   depth    optical depth of the path, >= 0
//   formula  light e^-depth + fog (1 - e^-depth). Exact if the fog's light is the same along the path
// Source: P. Bouguer 1729, J. H. Lambert 1760, A. Beer 1852; the second term: H. Koschmieder 1924.
vec3 throughFog(vec3 light, vec3 fog, float depth)
{
    return mix(fog, light, exp(-depth));
}

// The light that thin fog around a lamp sends to the eye, for a lamp whose light falls off with the square of the
// distance.
//   from       start of the ray, relative to the lamp, scene units
//   direction  length 1
//   far        length of the ray, scene units, >= 0
//   size       added to the distance at which the ray passes the lamp, scene units, > 0, because no lamp is a point
//   returns    per scene unit, to be multiplied by the lamp's light and by the fog's scattering
//   formula    (atan((far - n) / s) + atan(n / s)) / s as one atan, where the ray is nearest to the lamp at n, and s is
//              its distance there plus size: the integral of 1 / (s^2 + (t - n)^2) along the ray. Exact except for
//              the light that the fog removes on the way
float lampInFog(vec3 from, vec3 direction, float far, float size)
{
    float nearest = -dot(from, direction), aside = length(from + nearest * direction) + size;
    return atan(far * aside, aside * aside - (far - nearest) * nearest) / aside;
}

// lampInFog for a lamp whose light is a beam.
//   beam     direction of the beam, length 1
//   wide     width of the beam at the lamp (x), and its growth per scene unit (y)
//   density  share of the light that the fog removes per scene unit
//   the other parameters are those of lampInFog
//   returns  per scene unit
//   formula  exp(-q^2) / (w sin) exp(-density (a + t)): w is the beam's width where the ray is nearest to its axis, q the
//            distance there, in widths, sin the sine of the angle between ray and beam, at least 0.045, a and t the
//            distances from there to the lamp and to the eye. The beam fades out where that point is behind the eye or
//            beyond far. The model is fitted by eye
float beamInFog(vec3 from, vec3 direction, vec3 beam, vec2 wide, float far, float density)
{
    float nearest = -dot(from, direction), facing = dot(beam, direction), across = max(1.0 - facing * facing, 0.002);
    float along = max((dot(from, beam) + facing * nearest) / across, 0.0), t = nearest + along * facing;
    float width = wide.x + wide.y * along, off = length(from + t * direction - along * beam) / width;
    float ahead = smoothstep(0.0, 1.0, t) * smoothstep(-0.5, 0.5, far - t);
    return exp(-off * off - density * (along + max(t, 0.0))) / width * ahead * inversesqrt(across);
}
