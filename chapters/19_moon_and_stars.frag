// 19 Moon and stars: a lake at dusk under a young moon, an observatory on its shore, and a sky that
// turns.

#include "main.glsl"       // main(): calls pixelRay, then rayColour
#include "cone.glsl"       // perspectiveRay, marchCone, pixelSpread
#include "bounds.glsl"     // boxInterval, intervalUnion
#include "repetition.glsl" // cellRandom
#include "lighting.glsl"   // lambert, encodeSRGB
#include "fresnel.glsl"    // schlickShare
#include "coverage.glsl"   // coverage
#include "sky_table.glsl"  // tableSky, tableSun, tableSunlight, tableAmbient, meteredSky; sunDirection, glow of sky.glsl
#include "night.glsl"      // the directions of stars and moon, and their light
#include "film.glsl"       // exposed, filmOfLargest

uniform sampler2D moon;       // "moon.png" linear clamp: brightness and slopes of the moon's ground
uniform sampler2D sunward;    // "sky_sunward.png" sRGB clamp: the half of the sky that contains the sun
uniform sampler2D away;       // "sky_away.png" sRGB clamp: the other half of the sky
uniform sampler2D halo;       // "sun_halo.png" sRGB clamp: the sun and its halo
uniform sampler2D meter;      // "sky_meter.png" linear clamp: what an exposure meter reads

uniform float timeOfDay;      // 19.35 in [0, 24] step 0.25, hour of the day: solar time at the start; at 12 the sun is highest
uniform float hoursPerSecond; // 0.25 in [0, 4] step 0.05, hours per second: speed of the time of day
uniform float moonAge;        // 2.9 in [0, 29.5] step 0.5, days: time since new moon, at the start; 14.77 is full moon
uniform float moonRadius;     // 2.6 in [0.1, 8] step *1.1, degrees: radius of the moon as drawn; the true one is 0.259, that in the article's shader 1.7
uniform bool  lightKept;      // true: an enlarged moon sends as much light as the true one; false: its surface is as bright as the true one's
uniform float relief;         // 1.5 in [0, 6] step 0.5: factor by which the moon's slopes are exaggerated
uniform float exposure;       // 0.5 in [-16, 8] step 0.5, stops: added to the exposure that the meter gives
uniform float softness;       // 0.7 in [0.2, 1] step 0.05: exponent applied to the ratio of light to the light of the sky; 1 changes nothing
uniform float latitude;       // 43.6 in [-89, 89] step 5, degrees: latitude of the observer
uniform int   maxSteps;       // 90 in [1, 512]: steps after which a ray is abandoned
uniform float hitThreshold;   // 0.005 in [0.00001, 0.1] step *2, scene units: distance at the eye that counts as a hit

// x points north, y up, z east, as in chapter 09; at the start the camera looks west. One scene
// unit is one metre.
const float DECLINATION = 2.0;                // declination of the sun in late March, degrees
const float SUN_RADIUS = 0.00466;             // angular radius of the sun, radians
const vec3  DOME = vec3(17.0, 6.2, -57.0);    // the foot of the observatory
const vec3  DOME_LOW = DOME + vec3(-3.1, -2.1, -3.1);
const vec3  DOME_HIGH = DOME + vec3(7.0, 5.8, 3.1);
const vec3  WOOD_LOW = vec3(-51.0, -0.2, -60.2);
const vec3  WOOD_HIGH = vec3(1.4, 8.8, -55.6);
const vec4  LAND[3] = vec4[](vec4(24.0, -83.7, -62.0, 90.0), vec4(-38.0, -150.4, -66.0, 152.0), vec4(-6.0, -498.1, -101.0, 500.0));

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// ---- The shore ----

// A spruce: a cone with branches, whose undersides are flat. The slope of the sawtooth is at most 1,
// so the factor 0.6 is safe, except below an underside, where a step may enter the branch or pass its
// tip.
float spruce(vec3 p, float height)
{
    float y = p.y / height, tier = fract(9.0 * y);
    float wide = 0.19 * height * (1.0 - y) * (0.78 + 0.3 * (1.0 - tier));
    return 0.6 * max(length(p.xz) - max(wide, 0.04), max(p.y - height, -p.y));
}

// The row of trees: each cell has one tree, with a random height and position. A tree is cut off at
// the walls of its cell, and a step ends at most 0.3 m beyond them.
float forest(vec3 p)
{
    const float PERIOD = 2.7;
    float cell = clamp(round(p.x / PERIOD), -18.0, 0.0), random = cellRandom(ivec3(cell, 5, 0));
    vec3 q = vec3(p.x - PERIOD * cell, p.y, p.z + 57.0 + 2.0 * fract(64.0 * random));
    float height = mix(4.2, 9.0, random * random) * (1.0 - 0.03 * abs(cell + 10.0)), wall = 0.5 * PERIOD - abs(q.x);
    return min(spruce(q, height), wall > 0.0 ? 0.6 * wall + 0.3 : 1e3);
}

// The observatory: a drum under a hemisphere, and a house. The slit is only painted, in lampLight.
float observatory(vec3 p)
{
    vec3 q = p - DOME;
    float drum = max(length(q.xz) - 2.7, max(q.y - 2.6, -2.0 - q.y)), ball = length(q - vec3(0.0, 2.7, 0.0)) - 3.0;
    float house = max(max(abs(q.x - 4.2) - 2.6, abs(q.z) - 1.7), max(q.y + 0.4 * abs(q.z) - 2.0, -2.0 - q.y));
    return min(min(drum, max(ball, 2.7 - q.y)), 0.92 * house);
}

// 1 in the slit of the dome and in the window of the house, where light comes out; 0 elsewhere.
float lampLight(vec3 p)
{
    vec3 q = p - DOME;
    float slit = step(abs(q.x + 0.25 * (q.y - 3.0)), 0.34) * step(3.0, q.y) * step(q.z, 5.0);
    float window = step(abs(q.x - 4.6), 0.35) * step(abs(q.y - 0.75), 0.4);
    return slit + window;
}

float sceneDistance(vec3 p)
{
    return min(forest(p), observatory(p));
}

// The camera stops in front of the trees and above the water.
float cameraRoom(vec3 p)
{
    return min(sceneDistance(p), p.y) - 0.3;
}

// ---- The sky ----

// Values that are the same for all pixels.
struct Hour {
    float hour;       // solar time
    vec3  sun, moon;  // directions to the sun and the moon
    vec3  moonlight;  // moonlight on a perpendicular surface; fades to 0 as the moon sets
    vec3  around;     // light of the whole sky on a horizontal white surface
    float metered;    // light of the sky in front of the camera
};

Hour hourNow()
{
    float hour = timeOfDay + hoursPerSecond * iTime, age = moonAge + hoursPerSecond * iTime / 24.0;
    vec3 sun = sunDirection(hour, latitude, DECLINATION);
    vec3 toMoon = moonDirection(hour, latitude, DECLINATION, age);
    vec3 light = moonlight(-dot(toMoon, sun)) * smoothstep(-0.1, 0.1, toMoon.y);
    vec3 night = airglow(0.2) + 0.05 * light;
    return Hour(hour, sun, toMoon, light, tableAmbient(sun) + night, meteredSky(meter, iCameraForward, sun) + brightness(night));
}

// The light of the sky that the sun lights from above or from below the horizon.
vec3 skyLight(vec3 direction, vec3 sun)
{
    return tableSky(sunward, away, direction, sun);
}

// The light of the moon's disc, and the share of the pixel that the disc covers (w).
vec4 moonSeen(vec3 direction, Hour now, float width)
{
    mat3 frame = moonFrame(now.moon, latitude);
    float radius = radians(moonRadius);
    vec2 point = moonPoint(frame * direction, radius);
    vec3 light = moonFace(moon, point, width / radius, frame * now.sun, relief);
    float spread = lightKept ? min(radians(0.259) / radius, 1.0) : 1.0;
    return vec4(spread * spread * light, coverage(1.0 - length(point), width / radius));
}

// The light of the air: the sky by day or at dusk, the airglow, and moonlight, which the air scatters
// like sunlight.
vec3 airLight(vec3 direction, Hour now, vec3 clear)
{
    vec3 moonlit = 0.10 * (1.0 - clear) + 0.25 * glow(direction, now.moon, 0.9);
    return skyLight(direction, now.sun) + airglow(direction.y) + now.moonlight * moonlit;
}

// The light from beyond the air: the stars, and the moon in front of them.
vec3 heavens(vec3 direction, Hour now, float width)
{
    vec3 star = skyTurn(hourOfStars(now.hour, DECLINATION), latitude) * direction;
    vec4 disc = moonSeen(direction, now, width);
    return mix(starLight(star, width) + milkyWay(star), disc.rgb, disc.w);
}

// ---- Land and water ----

// Two ranges of hills, too far away for the march: their outlines depend only on the direction.
// Returns the shares of the pixel that they cover, the far range first.
vec2 rangesSeen(vec3 direction, float width)
{
    float turn = atan(direction.x, -direction.z + 1e-12), up = direction.y / max(length(direction.xz), 1e-6);
    vec2 wave = sin(vec2(5.0, 7.0) * turn + vec2(0.6, 2.9)) + 0.5 * sin(vec2(13.0, 19.0) * turn + vec2(0.0, 1.0));
    vec2 top = vec2(0.072, 0.042) + vec2(0.019, 0.013) * wave;
    return vec2(coverage(top.x - up, width), coverage(top.y - up, width));
}

// The t at which the ray meets the land, which consists of three large balls; 1e6 if it meets none.
float landAlong(Ray ray)
{
    float t = 1e6;
    for (int i = 0; i < 3; i++) {
        vec3 from = ray.origin - LAND[i].xyz;
        float b = dot(from, ray.direction), rest = b * b - dot(from, from) + LAND[i].w * LAND[i].w, near = -b - sqrt(max(rest, 0.0));
        t = rest > 0.0 && near > 0.0 ? min(t, near) : t;
    }
    return t;
}

// The mirror image of a ray that meets the lake at t. The water is not quite still: it has two long
// waves, and two short ones, which fade where a pixel contains several of them.
Ray mirroredRay(Ray ray, float t)
{
    vec3 p = ray.origin + t * ray.direction;
    vec2 swell = cos(vec2(1.1, 2.6) * p.x + vec2(4.6, -3.1) * p.z + vec2(1.3, 2.1) * iTime);
    vec2 ripple = cos(vec2(3.0, -6.5) * p.x + vec2(17.0, 29.0) * p.z + vec2(3.4, 4.6) * iTime);
    vec2 tilt = 0.003 / (1.0 + 0.02 * t) * vec2(0.3 * (swell.x - swell.y), swell.x + swell.y);
    tilt += 0.006 * exp(-0.02 * t) * vec2(0.5 * (ripple.x - ripple.y), ripple.x + ripple.y);
    vec3 away = reflect(ray.direction, normalize(vec3(tilt.x, 1.0, tilt.y)));
    return Ray(p, normalize(vec3(away.x, abs(away.y) + 1e-4, away.z)));
}

// The light from the shore: almost nothing, except from the white dome and its lamp.
vec3 shoreLight(vec3 p, bool marched, Hour now)
{
    vec3 q = p - DOME;
    bool dome = marched && p.x > DOME_LOW.x && p.y > DOME_LOW.y;
    vec3 round = normalize(vec3(q.x, max(q.y - 2.7, 0.0), q.z)), normal = dome ? round : vec3(0.0, 1.0, 0.0);
    vec3 colour = dome ? vec3(0.5, 0.52, 0.56) : vec3(0.05, 0.06, 0.045) * (marched ? 0.4 : 1.0);
    vec3 received = (0.6 + 0.4 * normal.y) * now.around + lambert(normal, now.moon) * now.moonlight;
    received += lambert(normal, now.sun) * tableSunlight(now.sun);
    return colour * received + (dome ? lampLight(p) : 0.0) * vec3(5.7e-5, 2.2e-5, 6e-6);
}

// Everything behind the shore: the ranges of hills, the air, and the heavens beyond the air.
vec3 skyAll(vec3 direction, Hour now, float width)
{
    vec3 above = vec3(direction.x, max(direction.y, 0.0), direction.z), clear = transmittance(RAYLEIGH, airMass(above.y));
    vec3 air = airLight(above, now, clear);
    vec2 ranges = rangesSeen(direction, 2.0 * width);
    vec3 beyond = clear * heavens(above, now, width) + tableSun(halo, direction, now.sun, SUN_RADIUS);
    return mix(mix(air + beyond, 0.45 * air, ranges.x), 0.22 * air, ranges.y);
}

// The light of the shore where a ray meets the shore, otherwise the light of the sky behind it.
vec3 behindLake(Ray ray, vec3 sky, Hour now)
{
    float land = landAlong(ray);
    vec2 interval = intervalUnion(boxInterval(ray, WOOD_LOW, WOOD_HIGH), boxInterval(ray, DOME_LOW, DOME_HIGH));
    // The distance to a tree is 0.6 of the true one, and so is the threshold: outlines grow by half a pixel.
    Hit hit = marchCone(ray, interval.x, min(interval.y, land), hitThreshold, 0.6 * pixelSpread(), maxSteps);
    float t = hit.found ? hit.t : land;
    return t < 1e5 ? shoreLight(ray.origin + t * ray.direction, hit.found, now) : sky;
}

// Light as it is shown: exposed for the sky in front of the camera, and with less contrast, because
// no screen shows the moon and the stars together.
vec3 shown(vec3 light, Hour now)
{
    vec3 x = exposed(daylightFilm(light), adaptedStops(now.metered) + exposure);
    x *= pow(max(brightness(light) / now.metered, 1e-6), softness - 1.0);
    return encodeSRGB(filmOfLargest(x, 1.4, 60.0));
}

vec3 rayColour(Ray ray)
{
    Hour now = hourNow();
    float lake = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : 1e6;
    bool water = lake < landAlong(ray);
    Ray mirrored = mirroredRay(ray, lake), seen = Ray(water ? mirrored.origin : ray.origin, water ? mirrored.direction : ray.direction);
    float width = 2.0 * pixelSpread() * pow(dot(ray.direction, iCameraForward), 1.5); // width of the pixel, radians
    vec3 light = behindLake(seen, skyAll(seen.direction, now, width), now);
    return shown(water ? (0.03 + 0.95 * schlickShare(seen.direction.y, 0.02)) * light : light, now);
}
