// fog.glsl - light on its way through fog: what is lost, and what the fog itself sends to the eye.
//
// The fog's density is what it takes of the light per scene unit: a ray loses the share density dt on the
// way dt. It is even, or thins with the height y as exp(-y / scale). docs/15_the_picture.md proves what is
// claimed here.
#include "sky.glsl"

// The mean of exp(-s) over s in [0, x].
//   x        >= 0; what falls through the fog counts from its lower end, so no more is needed
//   returns  1 at 0, 1 / x for large x
//   formula  (1 - exp(-x)) / x; up to 0.2 the first terms of its series, for there the difference of two
//            numbers near 1 would leave few digits: 1 - x / 2 + x^2 / 6 - x^3 / 24 + x^4 / 120
float meanDecay(float x)
{
    float series = 1.0 - x * (0.5 - x * (1.0 / 6.0 - x * (1.0 / 24.0 - x / 120.0)));
    return x < 0.2 ? series : (1.0 - exp(-x)) / max(x, 0.2);
}

// The optical depth of a piece of a ray: the integral of the density along it.
//   height   y where the piece begins, scene units
//   climb    how y grows along the ray: the direction's y, in [-1, 1]
//   t        length of the piece, scene units, >= 0
//   density  at y = 0, per scene unit, >= 0
//   scale    the height over which the density falls to 1 / e, scene units, > 0; 1e6 is an even fog
//   formula  density exp(-low / scale) t meanDecay(|climb| t / scale), low the y of the lower end. Exact
float fogDepth(float height, float climb, float t, float density, float scale)
{
    float low = height + min(climb * t, 0.0);
    return density * exp(-low / scale) * t * meanDecay(abs(climb) * t / scale);
}

// The optical depth of a whole ray to the sky.
//   others   as of fogDepth
//   formula  density exp(-height / scale) scale / climb, its limit for t to infinity; from climb 1e-5 down,
//            below the horizon too, as at 1e-5. Exact above
float skyFogDepth(float height, float climb, float density, float scale)
{
    return density * exp(-height / scale) * scale / max(climb, 1e-5);
}

// Where on a ray the optical depth from its start is a given one: fogDepth the other way round.
//   depth    in [0, the depth of the whole piece]
//   others   as of fogDepth
//   returns  t, scene units. The density where the ray starts counts as at least 1e-12, so from some twenty scales
//            up it is too short; and a ray that climbs is followed up to 1 - x = 1e-6, fourteen scales high
//   formula  t = -(scale / climb) log(1 - x), x = depth climb / (density exp(-height / scale) scale); where
//            |x| < 0.02, the first terms of the series, depth / b (1 + x / 2 + x^2 / 3 + x^3 / 4), b the
//            density where the ray starts
float fogPlace(float height, float climb, float depth, float density, float scale)
{
    float start = max(density * exp(-height / scale), 1e-12);
    float x = depth * climb / (start * scale);
    float series = 1.0 + x * (0.5 + x * (1.0 / 3.0 + x / 4.0));
    float quotient = -log(max(1.0 - x, 1e-6)) / x;
    return depth / start * (abs(x) < 0.02 ? series : quotient);
}

// The light of the fog in a direction: what it sends towards the eye where it is so thick that nothing is
// seen through it.
//   direction, toSun  length 1
//   ambient  light of the sky that the fog scatters, the same to all sides
//   sun      light that it scatters straight on, away from the sun
//   g        the mean cosine of the angle of scattering, in [0, 1); mist 0.6 to 0.9
//   formula  ambient + sun glow(direction, toSun, g): light scattered once, with Henyey and Greenstein's
//            share for each angle. A model: what is scattered more than once is in the ambient part alone
vec3 fogLight(vec3 direction, vec3 toSun, vec3 ambient, vec3 sun, float g)
{
    return ambient + sun * glow(direction, toSun, g);
}

// What arrives of a light that has come through fog, with the light of the fog.
//   light    from behind the fog, linear
//   fog      light of the fog, from fogLight
//   depth    optical depth between, >= 0
//   formula  light e^-depth + fog (1 - e^-depth). Exact where the fog's light is the same along the way
// Source: P. Bouguer 1729, J. H. Lambert 1760, A. Beer 1852; with the second part H. Koschmieder 1924.
vec3 throughFog(vec3 light, vec3 fog, float depth)
{
    return mix(fog, light, exp(-depth));
}

// What thin fog round a lamp sends to the eye, for a lamp whose light falls off with the square of the way.
//   from       where the ray begins, from the lamp, scene units
//   direction  length 1
//   far        length of the ray, scene units, >= 0
//   size       added to the distance at which the ray passes the lamp, scene units, > 0: no lamp is a point
//   returns    per scene unit, to be multiplied by the lamp's light and by what the fog scatters
//   formula    (atan((far - n) / s) + atan(n / s)) / s as one atan, n where the ray is nearest to the lamp, s how
//              near it is, and size: the integral of 1 / (s^2 + (t - n)^2) along the ray. Exact but for what
//              the fog takes on the way
float lampInFog(vec3 from, vec3 direction, float far, float size)
{
    float nearest = -dot(from, direction), aside = length(from + nearest * direction) + size;
    return atan(far * aside, aside * aside - (far - nearest) * nearest) / aside;
}

// The same of a lamp whose light is a beam.
//   beam     its direction, length 1
//   wide     of the beam at the lamp (x), and what it gains for each scene unit (y)
//   returns  per scene unit
//   formula  exp(-q^2) / (w sin), w the beam's width where the ray is nearest to its axis, q how near that is, in
//            widths, sin of the angle between the two, at least 0.045; fading out where that place lies before the
//            eye or behind far. A model by eye
float beamInFog(vec3 from, vec3 direction, vec3 beam, vec2 wide, float far)
{
    float nearest = -dot(from, direction), facing = dot(beam, direction), across = max(1.0 - facing * facing, 0.002);
    float along = max((dot(from, beam) + facing * nearest) / across, 0.0), place = nearest + along * facing;
    float width = wide.x + wide.y * along, off = length(from + place * direction - along * beam) / width;
    float ahead = smoothstep(0.0, 1.0, place) * smoothstep(-0.5, 0.5, far - place);
    return exp(-off * off) / width * ahead * inversesqrt(across);
}
