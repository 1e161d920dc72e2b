// night.glsl - the sky of the night: the positions of the stars and the moon, their brightness, and the light of
// a dark sky and of dusk.
//
// Light is linear; 1 is 4,000 cd/m^2, about twice the blue overhead at a clear noon. Directions have length
// 1; x points north, y up, z east. In the frame of the stars, z points towards the celestial pole and x towards the
// position of the sun at the March equinox. docs/19_moon_and_stars.md proves the claims made here.
#include "noise.glsl"

const float NIGHT_PI = 3.14159265;

// ---- Positions in the sky ----

// The time in which the stars turn once around the pole, hours: 23 h 56 min 4 s.
const float SIDEREAL_DAY = 23.9344696;

// The time from new moon to new moon, days.
const float MONTH = 29.530589;

// The angle between the celestial equator and the sun's path among the stars, degrees.
const float OBLIQUITY = 23.4393;

// The rotation that takes directions to the stars' frame: starDirection = skyTurn(hour, latitude) * direction.
//   hour      solar time on the day of the March equinox; any value: adding 24 gives the next day
//   latitude  degrees, north positive
//   returns   a rotation
//   formula   rows cos L M + sin L W, sin L M - cos L W, P, with L = 360 (hour - 12) / SIDEREAL_DAY degrees,
//             M where the celestial equator crosses the meridian, W west, P the pole
mat3 skyTurn(float hour, float latitude)
{
    float angle = 2.0 * NIGHT_PI / SIDEREAL_DAY * (hour - 12.0), c = cos(angle), s = sin(angle);
    float phi = radians(latitude);
    vec3 meridian = vec3(-sin(phi), cos(phi), 0.0), pole = vec3(cos(phi), sin(phi), 0.0);
    vec3 west = vec3(0.0, 0.0, -1.0);
    return transpose(mat3(c * meridian + s * west, s * meridian - c * west, pole));
}

// The hour for skyTurn at which the stars have the same positions as at an hour of another day.
//   hour         solar time, any value
//   declination  of the sun, degrees, in [-23.43, 23.43], in the half of the year when the declination increases
//   formula      since the March equinox, the sun has moved among the stars by an angle, measured along the celestial
//                equator, whose sine is tan declination / tan OBLIQUITY. The stars are ahead by this angle
float hourOfStars(float hour, float declination)
{
    float sine = clamp(tan(radians(declination)) / tan(radians(OBLIQUITY)), -1.0, 1.0);
    return hour + SIDEREAL_DAY / 360.0 * degrees(atan(sine, sqrt(1.0 - sine * sine)));
}

// The direction to the moon, as if the moon moved along the sun's path among the stars. The true path is inclined to
// the sun's by 5 degrees.
//   hour, latitude  as for sunDirection in sky.glsl
//   declination     of the sun, degrees, in [-23.43, 23.43], in the half of the year when the declination increases
//   age             days since new moon; any value
//   formula         the sun's longitude l has sin l = sin declination / sin OBLIQUITY; the moon's is
//                   l + 360 age / MONTH. Both directions are turned so that the sun has its position at this hour
vec3 moonDirection(float hour, float latitude, float declination, float age)
{
    float lean = radians(OBLIQUITY), sine = clamp(sin(radians(declination)) / sin(lean), -1.0, 1.0);
    float cosine = sqrt(1.0 - sine * sine), moon = atan(sine, cosine) + 2.0 * NIGHT_PI / MONTH * age;
    vec3 there = vec3(cos(moon), cos(lean) * sin(moon), sin(lean) * sin(moon)); // in the stars' frame
    float turn = atan(cos(lean) * sine, cosine) + radians(15.0 * (hour - 12.0));
    float meridian = there.x * cos(turn) + there.y * sin(turn), west = there.x * sin(turn) - there.y * cos(turn);
    float phi = radians(latitude);
    return vec3(there.z * cos(phi) - meridian * sin(phi), there.z * sin(phi) + meridian * cos(phi), -west);
}

// ---- Stars ----

// The sphere is divided into 8 STAR_RINGS^2 cells of equal solid angle, each with one star. Seen from above the
// pole, each hemisphere is a disc of STAR_RINGS rings of equal width; ring i has 4 (2 i + 1) cells.
const int STAR_RINGS = 64;

// The light of the faintest star, of magnitude 7.61, in the unit of light times steradians: 2.54e-6 10^(-0.4 7.61) lx.
const float STAR_FAINTEST = 5.75e-13;

// The light of the stars, averaged over the footprint of a pixel.
//   direction  in the stars' frame: from skyTurn
//   width      of the pixel, radians, > 0; above 0.0031, the spot of a star no longer grows
//   returns    linear light, above the air. The sum over the pixels of light times solid angle is the same for all
//              positions of the stars relative to the pixels, within 0.7 %
//   formula    the sum over the stars of flux colour (1 - d^2 / r^2)^3 4 / (pi r^2), d the distance to the star, r
//              = 1.761 width. A share u of all stars is brighter than STAR_FAINTEST u^(-0.4 / 0.51): the number
//              of stars grows as 10^(0.51 m) with the magnitude m. The colour is that of a black body by Wien's law,
//              exp(14388 (1/0.55 - 1/wavelength) (1/T - 1/6500)), T from 3,300 to 14,000 K
// The radius of a spot is less than half of a cell's side, so only the four cells nearest to the direction are
// evaluated, all at once, one in each component. Beyond the pole is the same ring, half a turn farther on, and beyond
// the equator the same ring of the other hemisphere.
// Source: counts of the Hipparcos catalogue (ESA 1997); 2.54e-6 lx: C. W. Allen, 'Astrophysical quantities' (1973).
vec3 starLight(vec3 direction, float width)
{
    float rings = float(STAR_RINGS), radius = min(1.761 * width, 0.3536 / rings);
    float fromPole = rings * sqrt(1.0 - min(abs(direction.z), 1.0)), outer = floor(fromPole + 0.5);
    vec4 ring = vec4(outer - 1.0, outer - 1.0, outer, outer);
    vec4 past = step(rings, ring), before = step(ring, vec4(-0.5)); // 1 beyond the equator; 1 beyond the pole
    ring = clamp(ring, 0.0, rings - 1.0);
    vec4 count = 8.0 * ring + 4.0;
    bool pole = direction.x == 0.0 && direction.y == 0.0; // atan(0, 0) is undefined
    float turn = atan(direction.y, pole ? 1.0 : direction.x) / (2.0 * NIGHT_PI);
    vec4 column = floor(turn * count - 0.5) + vec4(0.0, 1.0, 0.0, 1.0) + 2.0 * before;
    column -= count * floor(column / count);

    float half_ = direction.z < 0.0 ? 1.0 : 0.0;
    vec4 name = (abs(half_ - past) * rings + ring) * 512.0 + column;
    uvec4 bits = stirredBits(uvec4(name) + 1u), more = stirredBits(bits);
    vec4 ahead = ring * ring + vec4(bits & 65535u) / 65536.0 * (2.0 * ring + 1.0); // evenly over the cell's area
    vec4 low = ahead / (rings * rings), out_ = sqrt(low * (2.0 - low));
    vec4 around = 2.0 * NIGHT_PI * (column + vec4(bits >> 16u) / 65536.0) / count;

    float flat_ = length(direction.xy);
    vec4 rise = abs(direction.z) - (1.0 - 2.0 * past) * (1.0 - low), aside = out_ - flat_;
    vec4 bow = sin(NIGHT_PI * turn - 0.5 * around);
    vec4 square = rise * rise + aside * aside + 4.0 * flat_ * out_ * bow * bow;
    vec4 near = max(1.0 - square / (radius * radius), 0.0);
    vec4 light = near * near * near * exp2(-0.4 / 0.51 * log2(vec4((more >> 8u) + 1u) / 16777216.0));
    vec4 warm = vec4(more & 255u) / 255.0, heat = mix(vec4(-8.2e-5), vec4(1.49e-4), warm * warm); // 1/T - 1/6500
    vec3 sum = vec3(dot(light, exp(5001.0 * heat)), light.x + light.y + light.z + light.w, dot(light, exp(-6540.0 * heat)));
    return 4.0 / (NIGHT_PI * radius * radius) * STAR_FAINTEST * sum;
}

// The light of the band of stars that are too faint to be seen singly, with the dark clouds of dust in the band.
//   direction  in the stars' frame
//   returns    linear light, above the air: up to about 3e-7
//   formula    a bell curve of the height above the band's plane, brighter towards the constellation Sagittarius, times
//              noise
// Source: the plane and the middle, 'The new I.A.U. system of galactic coordinates', Monthly Notices of the Royal
// Astronomical Society 121 (1960), for the equinox of 2000; the brightness is chosen by eye.
vec3 milkyWay(vec3 direction)
{
    const vec3 POLE = vec3(-0.86767, -0.19808, 0.45598), MIDDLE = vec3(-0.05488, -0.87344, -0.48384);
    float height = dot(direction, POLE), ahead = 0.5 + 0.5 * dot(direction, MIDDLE);
    vec4 noise = octaveNoise(7.0 * direction, 3, 0.6, 2.3);
    float wide = height + 0.10 * (noise.x - 0.5), dust = height + 0.02 + 0.16 * (noise.x - 0.5);
    float band = exp(-wide * wide / mix(0.012, 0.03, ahead)) * (0.25 + 1.5 * noise.x * noise.x);
    float dark = 1.0 - 0.75 * exp(-dust * dust / 0.0012) * smoothstep(0.35, 0.6, noise.x);
    return (0.35 + 0.65 * ahead * ahead) * band * dark * vec3(2.6e-7, 2.4e-7, 2.5e-7);
}

// ---- Dusk and dark ----

// The measured light of the sky overhead from sunset on, as a function of the sun's height, without the moon.
//   sinHeight  of the sun; above 0 it counts as 0
//   returns    0.051 at sunset, 4.5e-8 when the sun is at least 18.3 degrees below the horizon
//   formula    27 10^(-0.4 m), m in magnitudes per square second of arc; with d the sun's depth in degrees minus 5:
//              m = 11.84 + 1.518 d - 0.057 d^2 up to the largest value of this parabola, at d = 13.32; for d < 0 the
//              last coefficient is +0.102, so that m is 6.8 at sunset
// Source: F. Patat, O. S. Ugolnikov, O. V. Postylyakov, 'UBVRI twilight sky brightness at ESO-Paranal', Astronomy
// and Astrophysics 455 (2006), table 1, for depths from 5 to 15 degrees; the rest is fitted by eye.
float zenithLight(float sinHeight)
{
    float cosine = sqrt(max(1.0 - sinHeight * sinHeight, 0.0));
    float d = min(max(-degrees(atan(sinHeight, cosine)), 0.0) - 5.0, 13.3158);
    return 27.0 * exp2(-1.3287712 * (11.84 + d * (1.518 + (d < 0.0 ? 0.102 : -0.057) * d)));
}

// The magnitude of the faintest star that an eye sees against a sky.
//   light    of the sky, as from zenithLight, > 0
//   formula  7.93 - 5 log10(1 + 10^(4.316 - m / 5)), m = -2.5 log10(light / 27) the sky's magnitudes per square
//            second of arc: 6.6 in the dark, -0.4 when the sun is 6 degrees below the horizon
// Source: B. E. Schaefer, 'Telescopic limiting magnitudes', Publications of the Astronomical Society of the
// Pacific 102 (1990), after S. Hecht (1947); the form with one term is common among observers.
float faintestSeen(float light)
{
    float magnitude = -2.5 * 0.30103 * log2(light / 27.0);
    return 7.93 - 5.0 * 0.30103 * log2(1.0 + exp2(3.3219281 * (4.316 - magnitude / 5.0)));
}

// The light of the dark sky itself: a layer of air at a height of 95.5 km glows, and the path of a ray through this
// layer is longer near the horizon.
//   sinHeight  of the direction
//   returns    4.5e-8 overhead, 5.84 times as much at the horizon
//   formula    4.5e-8 / sqrt(1 - (1 - sinHeight^2) / 1.0302) times a slightly blue white, where 1.0302 is
//              (6466.5 / 6371)^2, the square of the layer's radius in radii of the Earth
// Source: P. J. van Rhijn (1921).
vec3 airglow(float sinHeight)
{
    float s = max(sinHeight, 0.0);
    return 4.5e-8 / sqrt(1.0 - (1.0 - s * s) / 1.0302) * vec3(0.72, 1.0, 1.25);
}

// Light as an eye sees it, by day and in the dark. In the dark the eye sees with its rods, which distinguish no colours and
// are most sensitive to bluish light. That is why pictures of the night are blue.
//   light    linear, white as from daylightFilm
//   returns  the same light above 2 cd/m^2; below 0.015 cd/m^2, four fifths of it are what the rods see, in one blue
//   formula  the rods' light is (0.05, 0.45, 0.5) times the colour; the blue has the brightness 0.88. Fitted by eye
vec3 nightSight(vec3 light)
{
    float rods = dot(light, vec3(0.05, 0.45, 0.5));
    return mix(light, rods * vec3(0.62, 0.9, 1.35), 0.8 * (1.0 - smoothstep(-18.0, -11.0, log2(max(rods, 1e-9)))));
}

// ---- The moon ----

// The share of the disc that is lit.
//   cosPhase  cosine of the angle at the moon between the eye and the sun: minus the cosine of the angle between moon
//             and sun in the sky, because the sun is 390 times as far away
//   formula   (1 + cosPhase) / 2
float moonShare(float cosPhase)
{
    return 0.5 + 0.5 * cosPhase;
}

// The frame of the moon, as rows: right, up (towards the celestial pole), and from the moon to the eye.
//   moon      from moonDirection; not exactly at the pole
//   returns   vector in the frame = moonFrame(moon, latitude) * vector
mat3 moonFrame(vec3 moon, float latitude)
{
    vec3 pole = vec3(cos(radians(latitude)), sin(radians(latitude)), 0.0), right = normalize(cross(moon, pole));
    return transpose(mat3(right, cross(right, moon), -moon));
}

// The point of the disc that a ray meets.
//   seen     the ray's direction in the moon's frame
//   radius   angular radius of the moon, radians; the true radius is 0.00452
//   returns  x right, y up, in radii of the disc; far outside if the ray points away from the moon
//   formula  seen.xy / sin(radius)
vec2 moonPoint(vec3 seen, float radius)
{
    return seen.z < 0.0 ? seen.xy / sin(radius) : vec2(1e3);
}

// The light of the moon's face above the air, lit by the sun and the Earth.
//   face     textures/moon.png, linear: the albedo / 0.40, and the slopes to the right and upwards, with 0 for
//            -0.30 and 1 for 0.30
//   point    from moonPoint; a point outside the disc counts as on the rim
//   width    of the pixel, in radii
//   toSun    in the moon's frame, length 1
//   relief   factor by which the slopes are exaggerated
//   returns  linear light: about 1.3 at full moon
//   formula  10.2 a (2 m / (m + n) exp(-0.94 g) + 1.2e-4 e), a the albedo, m and n the cosines of the angles between
//            the ground's normal and the directions to the sun and to the eye (Lommel and Seeliger), g the angle
//            between the two directions, e the light of the Earth at the Earth's phase b = pi - g:
//            (sin b + (pi - b) cos b) / pi. Because of the slopes, m decreases by the rise of the ground towards the
//            sun
// Source: H. Seeliger, 'Zur Photometrie zerstreut reflectirender Substanzen', Munich 1888; exp(-0.94 g) is fitted by
// eye to the light of the whole moon according to a formula of C. W. Allen, 'Astrophysical quantities' (1973), its
// magnitude -12.73 + 1.49 g + 0.043 g^4: within 10 % from 0 to 150 degrees.
vec3 moonFace(sampler2D face, vec2 point, float width, vec3 toSun, float relief)
{
    point /= max(length(point), 1.0);
    vec3 normal = vec3(point, sqrt(max(1.0 - dot(point, point), 0.0)));
    vec2 foot = vec2(0.47 * width, 0.0);
    vec3 ground = textureGrad(face, 0.5 + 0.47 * point, foot.xy, foot.yx).xyz;
    float albedo = 0.40 * ground.x, m = dot(normal, toSun);
    float rise = 0.30 * dot(2.0 * ground.yz - 1.00392, toSun.xy - m * normal.xy);
    m = clamp(m - relief * rise * smoothstep(-0.05, 0.02, m), 0.0, 1.0);
    float phase = atan(length(toSun.xy), toSun.z), earth = sin(phase) - phase * toSun.z;
    float sunlit = 2.0 * m / (m + normal.z + 0.001) * exp(-0.94 * phase);
    return 10.2 * albedo * (sunlit * vec3(1.06, 1.0, 0.88) + 1.2e-4 / NIGHT_PI * earth * vec3(0.85, 1.0, 1.25));
}

// The light of the moon on a surface perpendicular to its rays, above the air.
//   cosPhase  as for moonShare
//   returns   2.5e-5 at full moon (0.31 lx), 8.6 % of that at half moon
//   formula   2.5e-5 exp(-0.94 g) (1 - sin(g/2) tan(g/2) ln cot(g/4)), the light that moonFace gives for a uniform ball
// Source: as for moonFace.
vec3 moonlight(float cosPhase)
{
    float c = clamp(cosPhase, -0.9991, 0.9999995), sine = sqrt(0.5 - 0.5 * c), cosine = sqrt(0.5 + 0.5 * c); // of g / 2
    float ball = 1.0 - sine * sine / cosine * log((1.0 + cosine) / sine);
    return 2.5e-5 * exp(-1.88 * atan(sine, cosine)) * ball * vec3(1.06, 1.0, 0.88);
}
