// clouds.glsl - the clouds of the whole sky, from a panorama or from a layer over a round Earth; the light that they
// send; and the effect of the weather on sun and sky.
//
// Lengths are in kilometres. docs/20_clouds_and_weather.md proves the claims made here.
#include "repetition.glsl" // cellRandom
#include "sky.glsl"        // glow

const float EARTH_RADIUS = 6371.0; // km
const float QUARTER_TURN = 1.5707963;

// ---- A layer over a round Earth ----

// The distance along a ray to the point where it leaves a sphere around the Earth's centre.
//   height    of the eye above the ground, km, in [0, altitude)
//   climb     the direction's y, in [-1, 1]
//   altitude  of the sphere above the ground, km, > height
//   returns   km: altitude - height straight up, about sqrt(2 EARTH_RADIUS altitude) horizontally from the ground
//   formula   c / (b + s) where b >= 0, otherwise s - b; b = (R + height) climb, c = (altitude - height) (2 R +
//             altitude + height), s = sqrt(b^2 + c): the positive root of t^2 + 2 b t - c. No two nearly equal rounded
//             results are subtracted, so the error is a few units in the last place. The formula is exact, but it does
//             not check whether the ground hides the point
float layerHit(float height, float climb, float altitude)
{
    float b = (EARTH_RADIUS + height) * climb;
    float c = (altitude - height) * (2.0 * EARTH_RADIUS + altitude + height);
    float s = sqrt(b * b + c);
    return b >= 0.0 ? c / (b + s) : s - b;
}

// The direction in which an eye at the centre of the panorama sees the point where a ray meets a layer. With this
// direction instead of the ray's, the clouds overhead move when the eye moves, and those at the horizon hardly move.
//   eye       relative to the centre, km: x and z along the ground, a few km at most, y above the ground
//   direction, altitude  as for layerHit
//   returns   length 1
vec3 seenFromMiddle(vec3 eye, vec3 direction, float altitude)
{
    return normalize(eye + layerHit(eye.y, direction.y, altitude) * direction);
}

// ---- A panorama ----

// The position of a direction in a panorama of the upper half of the sky.
//   direction  length 1; a direction below the horizon counts as horizontal
//   returns    u, turns from north through east, in [-1/2, 1/2], with a jump at the south; v, the square root of the
//              height above the horizon, where a quarter turn is 1
vec2 panoramaUV(vec3 direction)
{
    float level = length(direction.xz);
    float east = level > 0.0 ? direction.x : 1.0; // atan(0, 0) is undefined
    return vec2(atan(direction.z, east) / (4.0 * QUARTER_TURN),
                sqrt(atan(max(direction.y, 0.0), max(level, 1e-20)) / QUARTER_TURN));
}

// The size of a pixel in a panorama, in u and in v, from the slopes of panoramaUV without its jump.
//   width  angle of a pixel, radians
//   formula  width / (2 pi cos h) and width / (pi v), where h is the height. The first is infinite at the zenith, the
//            second at the horizon: within a pixel's width of these, the value one pixel's width away replaces it
vec2 panoramaFootprint(vec3 direction, float width)
{
    float level = max(length(direction.xz), width), v = panoramaUV(direction).y;
    return width / (2.0 * QUARTER_TURN) * vec2(0.5 / level, 1.0 / max(v, sqrt(width / QUARTER_TURN)));
}

// The clouds in a direction. All three values refer only to the part that the cloud covers, so they can be filtered,
// added and weighted.
struct Cloud {
    float cover; // share of the background that is hidden, in [0, 1]
    float above; // share of a light overhead that reaches the visible side of the cloud, in [0, cover]
    float side;  // light from the right minus light from the left, in [-cover, cover]
};

// The clouds of a panorama.
//   panorama  cover, above and 1/2 + side / 2 as red, green and blue; repeats in u
//   turned    turns by which the clouds have drifted, from east to north
//   the other parameters are those of panoramaFootprint
// High in the sky, a texel is half a degree high but narrow, so the footprint is enlarged to at least a large part of
// that height. At the zenith a pixel contains every u, and a mip level that coarse would average the whole panorama,
// including clouds at the horizon. Therefore the footprint is at most twice as many texels in u as in v, if the
// panorama is 6.4 times as wide as it is high.
Cloud cloudPanorama(sampler2D panorama, vec3 direction, float turned, float width)
{
    vec2 uv = panoramaUV(direction), reach = panoramaFootprint(direction, max(width, 0.006 * uv.y * uv.y));
    reach.x = min(reach.x, 0.31 * reach.y);
    vec4 texel = textureGrad(panorama, uv + vec2(turned, 0.0), vec2(reach.x, 0.0), vec2(0.0, reach.y));
    return Cloud(texel.x, texel.y, 2.0 * texel.z - 1.0);
}

// The clouds of a thin layer over a round Earth.
//   layer     cover of the layer, seen from below; repeats in u, to the north, and in v, to the east
//   eye       position above the ground, km; x and z change as the eye moves and, against the wind, as the clouds drift
//   direction, altitude  as for layerHit; below the horizon the direction counts as horizontal
//   period    of the picture, km
//   width     angle of a pixel, radians
//   formula   the picture at eye + t direction, t from layerHit, averaged over width t / s, s the sine of the angle at
//             which the ray meets the sphere, about direction.y + t / EARTH_RADIUS; above = 9/10 cover and side = 0,
//             because light passes through such a thin layer
Cloud cloudLayer(sampler2D layer, vec3 eye, vec3 direction, float altitude, float period, float width)
{
    float climb = max(direction.y, 0.0), t = layerHit(eye.y, climb, altitude);
    vec2 uv = (eye.xz + t * direction.xz) / period;
    float reach = width * t / (climb + t / EARTH_RADIUS) / period;
    float cover = textureGrad(layer, uv, vec2(reach, 0.0), vec2(0.0, reach)).x;
    return Cloud(cover, 0.9 * cover, 0.0);
}

// One cloud in front of another.
//   near, far  the far cloud counts in proportion to the light that the near cloud lets through
Cloud cloudOver(Cloud near, Cloud far)
{
    float left = 1.0 - near.cover;
    return Cloud(near.cover + left * far.cover, near.above + left * far.above, near.side + left * far.side);
}

// A cloud whose three values are multiplied by a share.
Cloud cloudShare(Cloud cloud, float share)
{
    return Cloud(share * cloud.cover, share * cloud.above, share * cloud.side);
}

// ---- Light ----

// The sine of the sun's height above the horizon of the clouds, which is lower than the horizon of the ground.
//   sinHeight  sine of the sun's height above the horizon of the ground
//   altitude   of the clouds, km
//   formula    sin(h + sqrt(2 altitude / EARTH_RADIUS)) for a small h, at most 1
float cloudSunHeight(float sinHeight, float altitude)
{
    return min(sinHeight + sqrt(2.0 * altitude / EARTH_RADIUS), 1.0);
}

// The light that clouds send to the eye, times their cover.
//   direction  of the ray, length 1
//   sun        direction of the light, length 1
//   sunlight   light of the sun on a white surface perpendicular to its rays, linear
//   skylight   light of the whole sky on a horizontal white surface
//   formula    skylight (cover + 3 above) / 4 + sunlight (x^2 X + y^2 Y + z^2 Z + lining), with (x, y, z) the
//              components of the direction to the sun to the right, up and away from the eye, whose squares add up to
//              1; X, Y, Z the light that arrives along each axis from the side on which the sun is; lining =
//              1.5 glow(0.85) (4 cover (1 - cover) + above / 8), because thin cloud scatters light nearly straight ahead.
//              The model is fitted by eye
// Source: the squares as weights, J. Mitchell, G. McTaggart, C. Green, 'Shading in Valve's Source engine',
// SIGGRAPH 2006.
vec3 cloudLight(Cloud cloud, vec3 direction, vec3 sun, vec3 sunlight, vec3 skylight)
{
    vec2 away = direction.xz / max(length(direction.xz), 1e-4), right = vec2(-away.y, away.x);
    float x = dot(sun.xz, right), z = dot(sun.xz, away), shade = cloud.cover - cloud.above;
    float across = 0.03 * cloud.cover + max(0.3 * cloud.above + 0.8 * sign(x) * cloud.side, 0.0);
    float upright = sun.y > 0.0 ? cloud.above : 0.5 * shade;
    float ahead = z < 0.0 ? 0.15 * cloud.cover + 0.7 * cloud.above : 0.03 * cloud.cover + 0.2 * cloud.above;
    float lining = 1.5 * glow(direction, sun, 0.85) * (4.0 * cloud.cover * (1.0 - cloud.cover) + 0.125 * cloud.above);
    float direct = x * x * across + sun.y * sun.y * upright + z * z * ahead + lining;
    return sunlight * direct + skylight * (0.25 * cloud.cover + 0.75 * cloud.above);
}

// ---- Weather ----

// The shares of the fair panorama, of the storm panorama, and of an overcast sky, in [0, 1]. The storm appears behind
// the fair clouds before they disappear.
//   weather  from 1 (fair) to 0.5 (bad)
float fairShare(float weather)
{
    return smoothstep(0.5, 0.7, weather);
}

float stormShare(float weather)
{
    return 1.0 - smoothstep(0.75, 0.95, weather);
}

float overcastShare(float weather)
{
    return 1.0 - smoothstep(0.5, 0.85, weather);
}

// The share of the light of sun and moon that arrives through the clouds of this weather.
//   weather  as for fairShare
//   formula  exp(-4 overcastShare)
float sunLeft(float weather)
{
    return exp(-4.0 * overcastShare(weather));
}

// The visible share of the disc of the sun or the moon. Clouds scatter light in all directions long before they absorb
// it: in bad weather there is light but no disc.
//   formula  exp(-16 overcastShare)
float discLeft(float weather)
{
    return exp(-16.0 * overcastShare(weather));
}

// The light of an overcast sky in a direction. The sky is three times as bright overhead as at the horizon.
//   sinHeight  the direction's y; below 0 it counts as 0
//   white      the light of a horizontal white surface under such a sky
//   formula    9/7 white (1 + 2 y) / 3: a horizontal surface receives pi white from the whole sky
// Source: P. Moon, D. E. Spencer, 'Illumination from a non-uniform sky', Illuminating Engineering 37 (1942);
// CIE S 011 (ISO 15469), sky type 16.
vec3 overcastSky(float sinHeight, vec3 white)
{
    return 3.0 / 7.0 * white * (1.0 + 2.0 * max(sinHeight, 0.0));
}

// The light of a horizontal white surface under an overcast sky. It is slightly blue and about a fifth of the light in
// clear weather; the factors are chosen by eye.
//   clear  the light of the same surface under a clear sky, including the sun's
vec3 overcastWhite(vec3 clear)
{
    return vec3(0.17, 0.19, 0.22) * dot(clear, vec3(0.21, 0.72, 0.07));
}

// The share of the light that haze and rain remove, per kilometre.
//   weather  as for fairShare
//   formula  0.02 in fair weather, growing to 0.1 in bad weather: Koschmieder's visual range, 3.9 / density, falls
//            from 195 km to 39 km
float hazeDensity(float weather)
{
    return 0.02 + 0.08 * overcastShare(weather);
}

// How hard it rains, in [0, 1].
float rainShare(float weather)
{
    return 1.0 - smoothstep(0.5, 0.68, weather);
}

// The share of a pixel filled by falling drops, drawn out into streaks by a shutter that is open for about a tenth of a
// second. There are two sheets of rain, one behind the other. A streak is at least a pixel wide, and the wider it is,
// the fainter it is, so that a picture of few pixels has as much rain as a picture of many.
//   screen  y from -1 to 1, x from -aspect to aspect
//   time    seconds
//   pixel   height of a pixel, in the units of screen
//   returns in [0, 1]; its mean over a picture is the same for all values of pixel from 0.0022 to 0.028
float rainStreaks(vec2 screen, float time, float pixel)
{
    float sum = 0.0;
    for (int i = 1; i <= 2; i++) {
        float near = 9.0 * float(i), wide = clamp(near * pixel, 0.02, 0.5);
        vec2 p = near * (screen + vec2(0.14 * screen.y, 0.0));
        float column = floor(p.x), lot = cellRandom(ivec3(int(column), i, 20));
        float fall = 0.35 * p.y + 5.0 * (1.0 + 0.3 * lot) * time + 31.0 * lot, drop = floor(fall), there = fract(fall);
        float centre = column + mix(wide, 1.0 - wide, fract(7.31 * lot + 0.618 * drop));
        float streak = max(1.0 - abs(p.x - centre) / wide, 0.0);
        sum += streak * 0.02 / wide * smoothstep(0.3, 0.6, there) * (1.0 - smoothstep(0.9, 1.0, there));
    }
    return min(sum, 1.0);
}
