// sky_table.glsl - the light of a clear sky, of the sun and of the whole sky together, from tables that
// shaders/textures/air.c computes and from formulas fitted to the same integrals.
//
// Light is linear; 1 is 4,000 cd/m^2, about twice the blue overhead at a clear noon. Light that falls on a surface is
// given as the light that a white matt surface sends back. It ranges from 8.7, for a white surface that faces the noon
// sun, to 6e-8 at night; adaptedStops gives the exposure. y is up; directions have length 1; below the horizon the sky is
// the same as at the horizon.
//
// The chapter must declare each texture as sRGB and clamp, because the textures contain light.
#include "sky.glsl"

// Columns and rows of a table of the sky, in each of its three storeys, from the bottom: light scattered once by air,
// light scattered once by dust, and light scattered more than once. LOWEST_SUN is the sine of the height of the lowest
// sun that has a column, -16.3 degrees.
const vec2  SKY_TABLE = vec2(288.0, 160.0);
const float LOWEST_SUN = -0.28;

// The k of drawnOut for the two axes: the sun's height (x) and the direction's height (y).
const vec2 SKY_WIDTH = vec2(0.1, 0.06);

// Columns and rows of the table of the sun, and how far the table reaches, in radii of the sun.
const float SUN_TABLE = 64.0;
const float SUN_REACH = 12.0;

// The range of the amount that a table's fourth number adds to the blue, as a share of the red's scale: from about
// -0.03 to 0.03. NO_BLUE, the byte 128, adds nothing.
const float BLUE_FINE = 0.06;
const float NO_BLUE = 128.0 / 255.0;

// The mean cosine of the angle by which dust scatters, for phaseDust.
const float DUST_FORWARD = 0.76;

// ---- Positions in a table ----

// The position of the sine of a height in a table: stretched around 0, where the sky changes fastest.
//   sine     in [-1, 1]
//   k        in (0, 1): near sine = 0 the table is stretched by 1 / k
//   returns  in [-1, 1], with the sign of sine
//   formula  the x with x (k + (1 - k) |x|) = sine
float drawnOut(float sine, float k)
{
    return sign(sine) * (sqrt(k * k + 4.0 * (1.0 - k) * abs(sine)) - k) / (2.0 * (1.0 - k));
}

// Column (x) and row (y) of the sky in a table: 0 is the centre of the first column or row, 1 that of the last.
//   sun        sine of the sun's height; below LOWEST_SUN it counts as LOWEST_SUN
//   direction  sine of the direction's height; below 0 it counts as 0
vec2 skyUV(float sun, float direction)
{
    float lowest = drawnOut(LOWEST_SUN, SKY_WIDTH.x), column = drawnOut(max(sun, LOWEST_SUN), SKY_WIDTH.x);
    return vec2((column - lowest) / (1.0 - lowest), drawnOut(max(direction, 0.0), SKY_WIDTH.y));
}

// x if x is far above 0, 0 if x is far below 0, and a smooth transition in between.
float beyond(float x)
{
    return 0.5 * (x + sqrt(x * x + 0.0004));
}

// The light that the number 1 of a table represents, in each storey.
struct SkyScale {
    vec3 air, dust, more;
};

// The scale at a position of the table, which is needed because light spans many powers of ten and a byte does not. By
// day, thick air removes light, most of all blue light and light near the horizon; in twilight the light decreases by a
// factor of 2 to 9 for each degree that the sun sinks, and the light of dust by a factor of 11 to 33.
//   sun      sine of the sun's height
//   row      from skyUV, in [0, 1]
//   formula  fitted; the table contains the remaining factor, which is in [0, 1]. In a few texels at dusk, where dust
//            sends little of the light, the factor of the dust's green would exceed 1 and is cut off
SkyScale skyScale(float sun, float row)
{
    float low = 1.0 / (max(sun, 0.0) + 0.068), foot = 1.0 / (1.0 + 114.0 * row * row);
    float deep = beyond(-sun - 0.05), shaded = beyond(-sun - 0.008);
    vec3 air = vec3(6.72, 6.92, 7.07) - low * vec3(0.159, 0.206, 0.243) - deep * vec3(67.83, 69.22, 67.35);
    air -= row * (vec3(4.369, 3.697, 1.829) + deep * vec3(109.6, 95.2, 82.36));
    air -= foot * (vec3(1.222, 1.282, -1.065) + low * vec3(0.2395, 0.3577, 0.9554));
    vec3 dust = vec3(5.6, 5.6, 4.62) - low * vec3(0.224, 0.317, 0.3) - shaded * vec3(195.4, 246.6, 290.0);
    dust -= row * vec3(4.805, 4.725, 4.6) + foot * (vec3(-0.722, -0.596, -0.6) + low * vec3(0.0566, 0.1568, 0.33));
    vec3 more = vec3(1.05, 1.68, 2.17) - low * vec3(0.193, 0.201, 0.215) - shaded * vec3(73.83, 77.35, 78.63);
    more -= row * (vec3(4.599, 4.292, 2.956) + shaded * vec3(8.42, -0.27, -3.81));
    more -= foot * (vec3(0.0706, 0.789, 0.924) + low * vec3(0.045, 0.0744, 0.0687));
    return SkyScale(exp2(air), exp2(dust), exp2(more));
}

// ---- How much is scattered in which direction ----

// The share that molecules scatter into a direction, per steradian.
//   c        cosine of the angle between the direction and the sun
//   formula  3 / (16 pi) (1 + c^2); its integral over all directions is 1
// Source: J. W. Strutt (Lord Rayleigh), Philosophical Magazine 41 (1871).
float phaseAir(float c)
{
    return 0.0596831 * (1.0 + c * c);
}

// The share that dust and droplets, which scatter mostly forwards, scatter into a direction, per steradian.
//   formula  (1 - g^2) / (4 pi) (1 + g^2 - 2 g c)^(-3/2), g = DUST_FORWARD; its integral is 1
// Source: L. G. Henyey, J. L. Greenstein, Astrophysical Journal 93 (1941).
float phaseDust(float c)
{
    float x = 1.0 / (1.0 + DUST_FORWARD * DUST_FORWARD - 2.0 * DUST_FORWARD * c);
    return 0.0795775 * (1.0 - DUST_FORWARD * DUST_FORWARD) * x * sqrt(x);
}

// ---- The sky ----

// The cosine of the horizontal angle between a direction and the sun, in [-1, 1]; 0 at the zenith, where there is no
// such angle.
float levelCosine(vec3 direction, vec3 sun)
{
    float size = length(direction.xz) * length(sun.xz);
    return clamp(dot(direction.xz, sun.xz) / max(size, 1e-6), -1.0, 1.0);
}

// The weight of the sunward table in the light that was scattered once.
//   a        from levelCosine
//   sun      sine of the sun's height
//   row      from skyUV
//   formula  ((1 + a) / 2)^p, p = 1 + (q - 1) (1 - 0.28 a), log2 q = 0.6 + 0.37 d - 2.75 row, in [0, 6], d the
//            degrees by which the sun is below the horizon. By day p is about 1, because the light divided by its phase
//            function is almost linear in a; in twilight the glow contracts, most of all near the horizon. At the
//            zenith any share will do, because the two tables agree there. The formula is fitted;
//            docs/18_sky_from_tables.md measures its error
float sunwardShare(float a, float sun, float row)
{
    float narrow = exp2(clamp(0.6 - 21.3 * sun - 2.75 * row, 0.0, 6.0)) - 1.0;
    return pow(0.5 + 0.5 * a, 1.0 + narrow * (1.0 - 0.28 * a));
}

// sunwardShare for light that was scattered more than once. This light comes from all sides and therefore depends less
// on the position of the sun.
//   the parameters are those of sunwardShare
//   formula  ((1 + a) / 2)^p, p = 1 + 3.7 (1 - row)^2 d / (d + 0.15), d = max(-sun, 0)
float moreShare(float a, float sun, float row)
{
    float deep = max(-sun, 0.0), high = 1.0 - row;
    return pow(0.5 + 0.5 * a, 1.0 + 3.7 * high * high * deep / (deep + 0.15));
}

// The light of one storey of a table. The light of a low sun is redder than the screen's red, with a blue a little
// below 0, which no colour of a picture can represent; and near 0 a screen distinguishes more values of blue than a
// byte has. The fourth number of a texel contains the missing part of the blue.
//   uv      from skyUV
//   storey  0 air, 1 dust, 2 more
//   scale   of the storey
vec3 storeyLight(sampler2D table, vec2 uv, float storey, vec3 scale)
{
    vec2 texel = 0.5 + uv * (SKY_TABLE - 1.0) + vec2(0.0, storey * SKY_TABLE.y);
    vec4 light = textureLod(table, texel / vec2(SKY_TABLE.x, 3.0 * SKY_TABLE.y), 0.0);
    return scale * light.rgb + vec3(0.0, 0.0, BLUE_FINE * scale.r * (light.a - NO_BLUE));
}

// The light of a table in a direction after one scattering: the light of air and of dust, each with the share that is
// scattered in this direction.
//   c  cosine of the angle to the sun
vec3 onceLight(sampler2D table, vec2 uv, float c, SkyScale scale)
{
    return phaseAir(c) * storeyLight(table, uv, 0.0, scale.air) + phaseDust(c) * storeyLight(table, uv, 1.0, scale.dust);
}

// All the light of a table in a direction. The result is exact in the middle of the table's half of the sky.
vec3 tableLight(sampler2D table, vec2 uv, float c, SkyScale scale)
{
    return onceLight(table, uv, c, scale) + storeyLight(table, uv, 2.0, scale.more);
}

// The light of the clear sky, without the sun's disc: the light that the air of a round Earth scatters.
//   sunward, away  the tables sky_sunward.png and sky_away.png, sRGB clamp
//   direction      of the ray, length 1
//   sun            direction of the sun, length 1
//   returns        linear light, >= 0; 1 is 4,000 cd/m^2
//   formula        a mix of the two tables, with sunwardShare for light scattered once and moreShare for other light
vec3 tableSky(sampler2D sunward, sampler2D away, vec3 direction, vec3 sun)
{
    vec2 uv = skyUV(sun.y, direction.y);
    SkyScale scale = skyScale(sun.y, uv.y);
    float c = dot(direction, sun), a = levelCosine(direction, sun);
    vec3 farOnce = onceLight(away, uv, c, scale), nearOnce = onceLight(sunward, uv, c, scale);
    vec3 farMore = storeyLight(away, uv, 2.0, scale.more), nearMore = storeyLight(sunward, uv, 2.0, scale.more);
    vec3 light = mix(farOnce, nearOnce, sunwardShare(a, sun.y, uv.y));
    return max(light + mix(farMore, nearMore, moreShare(a, sun.y, uv.y)), 0.0);
}

// ---- The sun ----

// The sun's light on a surface perpendicular to its rays, after its path through the air. Multiply it by the cosine of
// the angle to the surface's normal.
//   sun      direction of the sun; the light falls smoothly to 0 as the sun's centre sinks to 0.7 degrees below the
//            horizon
//   formula  light exp(-depth airMass), fitted to the integral; above 2 degrees within 5 % of the largest channel
vec3 tableSunlight(vec3 sun)
{
    vec3 through = exp(-vec3(0.1, 0.148, 0.269) * airMass(sun.y));
    return vec3(11.5, 10.3, 9.9) * through * smoothstep(-0.012, 0.03, sun.y);
}

// The sun's disc and the halo around it, to be added to the sky.
//   table      sun_halo.png, sRGB clamp
//   direction  of the ray, length 1
//   sun        direction of the sun, length 1
//   radius     of the disc, radians: the real radius is 0.00466. A larger disc sends as much light in total
//   returns    linear light: 46,000 times tableSunlight on average over a disc of the real radius
//   formula    the table at |direction - sun| / radius and the direction's height, times the light of a disc of
//              this size; outside the disc also times 0.004 (1 + 0.054 x^2)^(-3/2), x the distance in radii, because
//              the coarsest grains of dust scatter as phaseDust does with 0.98 for DUST_FORWARD
vec3 tableSun(sampler2D table, vec3 direction, vec3 sun, float radius)
{
    float x = length(direction - sun) / radius, height = max(direction.y, 0.0);
    vec2 uv = vec2(sqrt(min(x / SUN_REACH, 1.0)), drawnOut(height, 0.15));
    vec3 share = textureLod(table, (0.5 + uv * (SUN_TABLE - 1.0)) / SUN_TABLE, 0.0).rgb;
    float spread = inversesqrt(1.0 + 0.054 * x * x), inside = 1.0 - smoothstep(0.95, 1.1, x);
    float profile = mix(0.004 * spread * spread * spread, 1.0, inside) * smoothstep(-4.0 * radius, -radius, sun.y);
    return 15.0 * exp(-0.1 * airMass(height)) / (radius * radius) * profile * share;
}

// ---- The whole sky together, and the exposure ----

// The logarithm to base 2 of the light of the whole sky on a horizontal white surface.
//   sun      sine of the sun's height
//   formula  fitted to the integral: within 0.25 down to -18 degrees
float skyBrightness(float sun)
{
    float high = max(sun, 0.0), deep = max(-sun, 0.0);
    return 0.03 - 0.37 / (high + 0.1) - deep * (83.5 - 42.0 * exp(-204.0 * deep * deep));
}

// The light of the whole sky on a horizontal white surface, without the light of the sun itself.
//   sun      direction of the sun, length 1
//   formula  2^skyBrightness times a colour that is bluer at noon and in the blue hour than at sunset
vec3 tableAmbient(vec3 sun)
{
    float high = max(sun.y, 0.0);
    vec3 colour = vec3(0.86, 1.01, 1.31) + high / (high + 0.1) * vec3(-0.17, 0.0, 0.52) +
                  smoothstep(0.0, 0.17, -sun.y) * vec3(-0.4, 0.0, 1.08);
    return exp2(skyBrightness(sun.y)) * colour;
}

// The brightness of a colour: how strongly an eye responds to it.
// Source: IEC 61966-2-1, the second row of the matrix from sRGB to X, Y, Z.
float brightness(vec3 light)
{
    return dot(light, vec3(0.2126, 0.7152, 0.0722));
}

// The light of the clear sky that an exposure meter on the camera reads, which is the mean brightness of the part of the
// sky in front of the camera: 80 degrees wide and from 5 to 22 degrees high.
//   meter    the table sky_meter.png, linear clamp: for each column of the sky's tables, the reading of a camera that
//            looks towards the sun, away from it, or sideways; 16 bits each
//   forward  where the camera looks, length 1
//   sun      direction of the sun, length 1
//   formula  2^(skyBrightness + q(a)), where q is the parabola through the three readings at a = 1, -1 and 0, and a is
//            the cosine of the horizontal angle to the sun, times the cosine of the camera's tilt: the more steeply the
//            camera looks up or down, the less the reading depends on where it looks
float meteredSky(sampler2D meter, vec3 forward, vec3 sun)
{
    float at = (SKY_TABLE.x - 1.0) * skyUV(sun.y, 0.0).x, first = min(floor(at), SKY_TABLE.x - 2.0);
    ivec2 column = ivec2(int(first), 0);
    vec4 ends = mix(texelFetch(meter, column, 0), texelFetch(meter, column + ivec2(1, 0), 0), at - first);
    vec4 side = mix(texelFetch(meter, column + ivec2(0, 1), 0), texelFetch(meter, column + ivec2(1, 1), 0), at - first);
    vec3 reading = 8.0 / 257.0 * (256.0 * vec3(ends.xz, side.x) + vec3(ends.yw, side.y)) - 2.0;
    float a = dot(forward.xz, sun.xz) / max(length(sun.xz), 1e-6), mean = 0.5 * (reading.x + reading.y);
    return exp2(skyBrightness(sun.y) + reading.z + a * (0.5 * (reading.x - reading.y) + a * (mean - reading.z)));
}

// The exposure for the light that a meter reads, in stops, for exposed() of film.glsl. An eye and a camera adapt to the
// light, but not completely: light that is fainter by 1 stop is shown darker by 0.16 stops. The picture of a sky with the
// brightness E is therefore proportional to a power of E, and becomes darker whenever the sky does.
//   light    as from meteredSky, > 0, with the light of the night and of the moon added
//   returns  -1.5 at E = 1, 18.7 at 6e-8
//   formula  -1.5 - 0.84 log2(light)
float adaptedStops(float light)
{
    return -1.5 - 0.84 * log2(light);
}

// Light as a daylight film records it: white is the colour of white paper at noon in sunlight alone, whereas the
// screen's white would be bluer. Call it after all light is added and before exposed().
//   light    linear, >= 0
//   formula  light divided by the colour of tableSunlight with the sun 48 degrees high, scaled to a brightness of 1
vec3 daylightFilm(vec3 light)
{
    return light / vec3(1.156, 0.976, 0.796);
}
