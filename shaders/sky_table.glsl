// sky_table.glsl - the light of a clear sky, of the sun and of all the sky together, read from tables that a
// program has computed: shaders/textures/air.c.
//
// Light is linear, 1 is 4,000 cd/m^2, about the blue of a clear noon; light that falls on a surface is given as
// what a white matt surface sends on. So it spans from 8, a white wall at noon, to 1e-8 by night: hourStops says how
// to expose. y is up; directions have length 1; below the horizon the sky is what it is at the horizon.
//
// Each texture is to be declared in the chapter as sRGB and clamp, for it holds light.
#include "sky.glsl"

// Columns and rows of a table of the sky, in each of its two storeys: below the light that the air scatters, above
// that of the dust. The lowest sun that has a column, -16.3 degrees.
const vec2  SKY_TABLE = vec2(288.0, 160.0);
const float LOWEST_SUN = -0.28;

// How far the axes are drawn out round 0: of the sun's height (x) and of the direction's (y).
const vec2 SKY_WIDTH = vec2(0.1, 0.06);

// Columns and rows of the table of the sun, and how far it reaches, in radii of the sun.
const float SUN_TABLE = 64.0;
const float SUN_REACH = 12.0;

// What a table's fourth number adds to the blue, in this share of the red's scale; the byte NO_BLUE adds nothing.
const float BLUE_FINE = 0.06;
const float NO_BLUE = 128.0 / 255.0;

// The mean cosine of the angle by which dust scatters, for phaseDust.
const float DUST_FORWARD = 0.76;

// ---- Where to look ----

// Where the sine of a height lies in a table: drawn out round 0, where the sky changes fastest.
//   sine     in [-1, 1]
//   k        in (0, 1): near 0 it is drawn out by 1 / k
//   returns  in [-1, 1], with the sign of sine
//   formula  the x with x (k + (1 - k) |x|) = sine
float drawnOut(float sine, float k)
{
    return sign(sine) * (sqrt(k * k + 4.0 * (1.0 - k) * abs(sine)) - k) / (2.0 * (1.0 - k));
}

// Column (x) and row (y) of the sky in a table: 0 the first one's middle, 1 the last one's.
//   sun        sine of the sun's height; below LOWEST_SUN as at it
//   direction  sine of its height; below 0 as at 0
vec2 skyPlace(float sun, float direction)
{
    float lowest = drawnOut(LOWEST_SUN, SKY_WIDTH.x), column = drawnOut(max(sun, LOWEST_SUN), SKY_WIDTH.x);
    return vec2((column - lowest) / (1.0 - lowest), drawnOut(max(direction, 0.0), SKY_WIDTH.y));
}

// x where it is far above 0, 0 where it is far below, smooth between.
float beyond(float x)
{
    return 0.5 * (x + sqrt(x * x + 0.0004));
}

// How much light the number 1 of a table is, of the air and of the dust.
struct SkyScale {
    vec3 air, dust;
};

// The scale of a place: by day as thick air takes the light from the sun, blue the most, and the more the lower one
// looks; in twilight less by half for each degree that the sun sinks. Light spans decades, and a byte does not.
//   sun      sine of the sun's height
//   row      of skyPlace, in [0, 1]
//   formula  fitted; what it leaves over is in the table, and lies in [0, 1]
SkyScale skyScale(float sun, float row)
{
    float low = 1.0 / (max(sun, 0.0) + 0.068), foot = 1.0 / (1.0 + 114.0 * row * row);
    float deep = beyond(-sun - 0.038), shaded = beyond(-sun - 0.008);
    vec3 air = vec3(5.5, 5.34, 7.11) - low * vec3(0.152, 0.164, 0.244) - deep * vec3(52.6, 52.6, 60.9);
    air -= row * (vec3(4.23, 3.5, 3.66) + deep * vec3(62.8, 54.9, 43.0));
    air -= foot * (vec3(1.68, 0.8, 2.76) + low * vec3(0.118, 0.302, 0.339));
    vec3 dust = vec3(4.95, 4.89, 4.95) - low * vec3(0.192, 0.294, 0.468) - shaded * vec3(186.0, 226.0, 167.0);
    dust -= row * vec3(4.99, 4.7, 4.54) + foot * (vec3(-0.2, -0.06, 0.27) + low * vec3(0.048, 0.079, 0.168));
    return SkyScale(exp2(air), exp2(dust));
}

// ---- How much goes which way ----

// What molecules scatter into a direction, per steradian.
//   c        cosine of the angle between the direction and the sun
//   formula  3 / (16 pi) (1 + c^2); its integral over all directions is 1
// Source: J. W. Strutt (Lord Rayleigh), Philosophical Magazine 41 (1871).
float phaseAir(float c)
{
    return 0.0596831 * (1.0 + c * c);
}

// The same of dust and droplets: mostly forwards.
//   formula  (1 - g^2) / (4 pi) (1 + g^2 - 2 g c)^(-3/2), g = DUST_FORWARD; its integral is 1
// Source: L. G. Henyey, J. L. Greenstein, Astrophysical Journal 93 (1941).
float phaseDust(float c)
{
    float x = 1.0 / (1.0 + DUST_FORWARD * DUST_FORWARD - 2.0 * DUST_FORWARD * c);
    return 0.0795775 * (1.0 - DUST_FORWARD * DUST_FORWARD) * x * sqrt(x);
}

// ---- The sky ----

// The share of the table of the sun's half in a direction.
//   row      of skyPlace
//   formula  ((1 + a) / 2)^p, a the cosine of the angle to the sun in the level plane, p = 1 + (q - 1) (1 - 0.4 a),
//            log2 q = 0.43 + 0.39 d - 2.9 row, at least 0, d the degrees by which the sun is below the horizon. By day p
//            is 1, for the light that is left when the phases are taken out is linear in a; in twilight the glow
//            draws together, low down the most. At the zenith, where there is no such angle, any share will do: both
//            tables agree there
// Fitted; by how much it errs is measured in docs/18_sky_from_tables.md.
float sunwardShare(vec3 direction, vec3 sun, float row)
{
    float level = dot(direction.xz, sun.xz), size = length(direction.xz) * length(sun.xz);
    float a = clamp(level / max(size, 1e-6), -1.0, 1.0);
    float narrow = exp2(clamp(0.43 - 22.2 * sun.y - 2.9 * row, 0.0, 6.0)) - 1.0;
    return pow(0.5 + 0.5 * a, 1.0 + narrow * (1.0 - 0.4 * a));
}

// The light of a table in a direction: air and dust, each with the share that goes this way. A low sun's light is redder
// than the screen's red, its blue a little below 0, which no colour of a picture holds; and near 0 a screen tells more
// blues apart than a byte. The fourth number has what is missing.
//   place  of skyPlace
//   c      cosine of the angle to the sun
vec3 tableLight(sampler2D table, vec2 place, float c, SkyScale scale)
{
    vec2 texel = 0.5 + place * (SKY_TABLE - 1.0);
    vec4 air = textureLod(table, texel / vec2(SKY_TABLE.x, 2.0 * SKY_TABLE.y), 0.0);
    texel.y += SKY_TABLE.y;
    vec4 dust = textureLod(table, texel / vec2(SKY_TABLE.x, 2.0 * SKY_TABLE.y), 0.0);
    air.rgb *= phaseAir(c) * scale.air;
    dust.rgb *= phaseDust(c) * scale.dust;
    float fine = phaseAir(c) * scale.air.r * (air.a - NO_BLUE) + phaseDust(c) * scale.dust.r * (dust.a - NO_BLUE);
    return air.rgb + dust.rgb + vec3(0.0, 0.0, BLUE_FINE * fine);
}

// The light of the clear sky, without the sun's disc: what the air of a round Earth scatters once.
//   sunward, away  the tables sky_sunward.png and sky_away.png, sRGB clamp
//   direction      of the ray, length 1
//   sun            direction of the sun, length 1
//   returns        linear light, >= 0; 1 is 4,000 cd/m^2
//   formula        the mix of both tables by sunwardShare
vec3 tableSky(sampler2D sunward, sampler2D away, vec3 direction, vec3 sun)
{
    vec2 place = skyPlace(sun.y, direction.y);
    SkyScale scale = skyScale(sun.y, place.y);
    float c = dot(direction, sun);
    vec3 far = tableLight(away, place, c, scale), near = tableLight(sunward, place, c, scale);
    return max(mix(far, near, sunwardShare(direction, sun, place.y)), 0.0);
}

// ---- The sun ----

// The sun's light on a surface across its rays, after the air: to be multiplied by the cosine of the angle to the
// surface's normal.
//   sun      direction of the sun; 0 once its middle is 0.7 degrees below the horizon, smoothly
//   formula  light exp(-depth airMass), fitted to the integral; above 2 degrees within 7 % of the largest channel
vec3 tableSunlight(vec3 sun)
{
    vec3 through = exp(-vec3(0.1, 0.148, 0.269) * airMass(sun.y));
    return vec3(11.5, 10.3, 9.9) * through * smoothstep(-0.012, 0.03, sun.y);
}

// The sun's disc and the halo round it, to be added to the sky.
//   table      sun_halo.png, sRGB clamp
//   direction  of the ray, length 1
//   sun        direction of the sun, length 1
//   radius     of the disc, radians: 0.00466 is the real one. A larger disc sends as much light in all
//   returns    linear light: 46,000 times tableSunlight in the mean of a disc of the real radius
//   formula    the table by |direction - sun| / radius and by the direction's height, times the light of a
//              disc so large, and outside of it times 0.004 (1 + 0.054 x^2)^(-3/2), x the distance in radii: the
//              dust's coarsest grains scatter so, by phaseDust with 0.98 for DUST_FORWARD
vec3 tableSun(sampler2D table, vec3 direction, vec3 sun, float radius)
{
    float x = length(direction - sun) / radius, height = max(direction.y, 0.0);
    vec2 place = vec2(sqrt(min(x / SUN_REACH, 1.0)), drawnOut(height, 0.15));
    vec3 share = textureLod(table, (0.5 + place * (SUN_TABLE - 1.0)) / SUN_TABLE, 0.0).rgb;
    float spread = inversesqrt(1.0 + 0.054 * x * x), inside = 1.0 - smoothstep(0.95, 1.1, x);
    float profile = mix(0.004 * spread * spread * spread, 1.0, inside) * smoothstep(-4.0 * radius, -radius, sun.y);
    return 15.0 * exp(-0.1 * airMass(height)) / (radius * radius) * profile * share;
}

// ---- All the sky together, and how to expose ----

// The logarithm to base 2 of the light of all the sky on a level white surface.
//   sun      sine of the sun's height, >= -0.2
//   formula  fitted to the integral: within 0.25 above -8 degrees
float skyBrightness(float sun)
{
    float high = max(sun, 0.0), deep = max(-sun, 0.0);
    return -0.41 - 0.352 / (high + 0.1) - 36.0 * deep - 305.0 * deep * deep;
}

// The light of all the sky on a level white surface, without the sun's own.
//   sun      direction of the sun, length 1
//   formula  2^skyBrightness times a colour that is bluer at noon and in the blue hour than at sunset
vec3 tableAmbient(vec3 sun)
{
    float high = max(sun.y, 0.0);
    vec3 colour = vec3(0.92, 1.02, 1.08) + high / (high + 0.1) * vec3(-0.19, 0.0, 0.5) +
                  smoothstep(0.0, 0.1, -sun.y) * vec3(-0.19, 0.0, 0.42);
    return exp2(skyBrightness(sun.y)) * colour;
}

// By how many stops to expose at an hour, for exposed() of film.glsl. An eye and a camera follow the light, but not all
// the way: what is darker by 1 stop is shown darker by 0.15.
//   sinSunHeight  any sine
//   returns       -1.6 at noon, 1.0 at sunset, 7.1 with the sun at -6 degrees, 18.1 by night
//   formula       -2.3 - 0.85 log2(2^skyBrightness + 6e-8), the last the light of a night without a moon
float hourStops(float sinSunHeight)
{
    return -2.3 - 0.85 * log2(exp2(skyBrightness(max(sinSunHeight, -0.3))) + 6e-8);
}

// Light as a film for daylight takes it: white is what white paper is at noon, in the light of the sun alone, where
// the screen's white would be bluer. Before exposed(), after all light is added.
//   light    linear, >= 0
//   formula  light over the colour of tableSunlight with the sun 48 degrees high, of brightness 1
vec3 daylightFilm(vec3 light)
{
    return light / vec3(1.156, 0.976, 0.796);
}
