// sky.glsl - the position of the sun, the share of its light that passes through the air, and the light of the sky.
//
// The air is a shell of uniform density around the Earth. Heights are given by their sine, which is
// the y of a direction of length 1.

// Optical depth of the air overhead for red, green and blue: for light of 680, 550 and 440 nm.
// Source: J. E. Hansen, L. D. Travis, 'Light scattering in planetary atmospheres', Space Science
// Reviews 16 (1974), section 2.1, at sea level: 0.041, 0.097, 0.243, rounded. Scaled from 0.1 for green with the
// wavelength to the power -4 alone, they would be 0.043, 0.1, 0.244.
const vec3 RAYLEIGH = vec3(0.04, 0.1, 0.25);

// Radius of the Earth in thicknesses of the shell: with this value the air mass at the horizon is
// sqrt(2 EARTH + 1) = 38.
const float EARTH = 721.5;

// How much air a ray passes through, as a multiple of the air overhead.
//   sinHeight  sine of the height above the horizon, in [-1, 1]; a negative value counts as 0
//   returns    1 at the zenith, 38 at the horizon; about 1 / sinHeight far above the horizon
//   formula    (2 E + 1) / (sqrt((E y)^2 + 2 E + 1) + E y), E = EARTH, y = max(sinHeight, 0)
float airMass(float sinHeight)
{
    float climb = EARTH * max(sinHeight, 0.0);
    float horizon = 2.0 * EARTH + 1.0;
    return horizon / (sqrt(climb * climb + horizon) + climb);
}

// The share of the light that passes through the air, per channel.
//   depth    optical depth of the air overhead, >= 0
//   mass     air mass of the ray, as from airMass, >= 0
//   formula  exp(-depth mass)
// Source: P. Bouguer 1729, J. H. Lambert 1760, A. Beer 1852.
vec3 transmittance(vec3 depth, float mass)
{
    return exp(-depth * mass);
}

// The light that the air scatters once towards the eye, as a share of the sunlight above the air. The air is assumed
// to scatter equally in all directions.
//   depth     optical depth of the air overhead, per channel, > 0
//   viewMass  air mass of the ray from the eye
//   sunMass   air mass of the ray from the sun
//   formula   v (exp(-depth s) - exp(-depth v)) / (v - s), v = viewMass, s = sunMass; where v and s
//             differ by less than 0.02, s + 0.02 replaces v in the quotient, which causes an error of
//             at most about depth / 50 of the light
//   The formula assumes that every slanting path is v or s times the vertical path, at every height. This is exact
//   over a flat Earth; with the air masses of a round Earth, the formula is only a model.
// Source: S. Chandrasekhar, 'Radiative transfer' (1950): the first order of a plane layer.
vec3 scatteredLight(vec3 depth, float viewMass, float sunMass)
{
    float apart = viewMass - sunMass;
    apart = abs(apart) < 0.02 ? 0.02 : apart;
    vec3 light = transmittance(depth, sunMass) - transmittance(depth, sunMass + apart);
    return viewMass / apart * light;
}

// The direction to the sun, length 1: x north, y up, z east.
//   hour         solar time, 12 when the sun is highest, any value
//   latitude     degrees, north positive, in [-90, 90]
//   declination  of the sun, degrees, in [-23.44, 23.44]: 0 at the equinoxes
//   formula      with H = 15 (hour - 12) degrees, p the latitude, d the declination:
//                (cos p sin d - sin p cos d cos H, sin p sin d + cos p cos d cos H, -cos d sin H);
//                cos H and sin H from the sine k of H / 2: 1 - 2 k^2 and 2 k sqrt(1 - k^2), exact except
//                within a minute of midnight, where rounding moves the sun by up to 0.0005
vec3 sunDirection(float hour, float latitude, float declination)
{
    float k = sin(radians(7.5 * (mod(hour, 24.0) - 12.0))); // sine of H / 2, whose cosine is not negative
    vec2 turn = vec2(1.0 - 2.0 * k * k, 2.0 * k * sqrt(max(1.0 - k * k, 0.0)));
    vec2 observer = vec2(cos(radians(latitude)), sin(radians(latitude)));
    vec2 season = vec2(cos(radians(declination)), sin(radians(declination)));
    return vec3(observer.x * season.y - observer.y * season.x * turn.x,
                observer.y * season.y + observer.x * season.x * turn.x, -season.x * turn.y);
}

// The coverage of a direction by the disc of the sun or the moon: 1 inside, 0 outside, soft at the rim.
//   direction, centre  length 1
//   radius             radians, small
float disc(vec3 direction, vec3 centre, float radius)
{
    return 1.0 - smoothstep(0.9 * radius, 1.1 * radius, length(direction - centre));
}

// The glow around the sun: light that dust scatters forward, 1 towards the sun.
//   direction, sun  length 1
//   g        mean cosine of the scattering angle, in [0, 1): the nearer to 1, the narrower the glow
//   formula  ((1 - g)^2 / (1 + g^2 - 2 g c))^(3/2), c the cosine of the angle to the sun
// Source: L. G. Henyey, J. L. Greenstein, 'Diffuse radiation in the galaxy', Astrophysical Journal
// 93 (1941).
float glow(vec3 direction, vec3 sun, float g)
{
    float x = (1.0 - g) * (1.0 - g) / (1.0 + g * g - 2.0 * g * dot(direction, sun));
    return x * sqrt(x);
}

// The strength of daylight: 1 while the sun is more than 3.4 degrees high, 0 once it is 14.5 degrees
// below the horizon. This model, fitted by eye, replaces the rising shadow of the Earth.
//   sinHeight  of the sun
float daylight(float sinHeight)
{
    return smoothstep(-0.25, 0.06, sinHeight);
}

// The light of the sky in a direction, from the sun alone: light that the air scatters, and the halo of the
// dust. 1 is about the brightness of a sky at noon.
//   direction  length 1; below the horizon it counts as horizontal
//   sun        direction of the sun, length 1
//   depth      optical depth of the air overhead, per channel, > 0
//   formula    gain day^2 (0.6 + 0.4 c^2) scatteredLight + day transmittance glow, c the cosine of the
//              angle to the sun; the gain, a colour chosen by eye, represents light scattered more than
//              once and the effect of ozone: the blue of the zenith at sunset comes only from the gain
vec3 sunlitSky(vec3 direction, vec3 sun, vec3 depth)
{
    float view = airMass(direction.y), sunMass = airMass(sun.y), day = daylight(sun.y);
    float c = dot(direction, sun);
    vec3 gain = vec3(1.4, 1.75, 3.1) * day * day * (0.6 + 0.4 * c * c);
    vec3 halo = day * transmittance(depth, sunMass) * glow(direction, sun, 0.8);
    return gain * scatteredLight(depth, view, sunMass) + halo;
}

// The share of the air in a direction that the Earth shades: its shadow rises opposite the sun as the sun sinks.
//   direction, sun  as for sunlitSky
//   returns   0 by day and on the side of the sun
//   formula   opposite the sun, the edge of the shadow is as high as the sun is low; it sinks towards the sides, and is
//             about as soft as it is high. A model fitted by eye
float earthShadow(vec3 direction, vec3 sun)
{
    float away = 0.5 - 0.5 * dot(direction.xz, sun.xz) / max(length(direction.xz) * length(sun.xz), 1e-6);
    float low = max(-sun.y, 0.0), edge = low * away, soft = 0.03 + low;
    return smoothstep(0.3, 1.0, away) * smoothstep(0.0, 0.04, low) * (1.0 - smoothstep(edge - soft, edge + soft, direction.y));
}

// The sky's own light at night, a model fitted by eye. This light is brightest at the horizon.
//   direction, sun  as for sunlitSky
vec3 nightSky(vec3 direction, vec3 sun)
{
    float low = airMass(direction.y) / 38.0;
    return (1.0 - daylight(sun.y)) * mix(vec3(0.002, 0.004, 0.011), vec3(0.016, 0.014, 0.016), low);
}

// The light of the whole sky on a matt surface: scatteredLight for an air mass of 4, times daylight
// squared and a colour chosen by eye, plus a little light that remains at night.
//   sun, depth  as for sunlitSky
vec3 skyAmbient(vec3 sun, vec3 depth)
{
    float day = daylight(sun.y);
    vec3 light = scatteredLight(depth, 4.0, airMass(sun.y));
    return vec3(0.45, 0.52, 0.72) * day * day * light + vec3(0.003, 0.004, 0.008);
}

// The light of the sun on a surface perpendicular to its rays, or at night that of the moon, which is always
// full and opposite the sun.
//   sun, depth  as for sunlitSky
vec3 sunOrMoonLight(vec3 sun, vec3 depth)
{
    vec3 moonlight = vec3(0.02, 0.03, 0.05) * smoothstep(0.0, 0.15, -sun.y);
    return 2.6 * transmittance(depth, airMass(sun.y)) * smoothstep(0.0, 0.04, sun.y) + moonlight;
}
