// 20 Clouds and weather: a lighthouse by the sea, under clouds that drift, by every hour and weather.

#include "main.glsl"       // main(): asks for pixelRay, then for rayColour
#include "cone.glsl"       // perspectiveRay, marchCone, pixelSpread
#include "bounds.glsl"     // boxInterval
#include "shadow.glsl"     // shadowRay; march comes with it
#include "normal.glsl"     // normalAt
#include "lighting.glsl"   // lambert, encodeSRGB
#include "combine.glsl"    // opUnion, opSmoothUnion
#include "solids.glsl"     // sdCylinder, sdCappedCone
#include "primitives.glsl" // sdBox, sdSphere
#include "noise.glsl"      // valueNoise
#include "coverage.glsl"   // coverage
#include "texture.glsl"    // bumpedNormal
#include "fresnel.glsl"    // schlickShare
#include "film.glsl"       // exposed, filmOfLargest
#include "fog.glsl"        // fogDepth, throughFog
#include "sky_table.glsl"  // the clear sky, its sun, their light
#include "clouds.glsl"     // panoramas, layer, light, weather

uniform sampler2D sunward;     // "sky_sunward.png" sRGB clamp: the sky on the sun's side
uniform sampler2D away;        // "sky_away.png" sRGB clamp: the sky on the other side
uniform sampler2D halo;        // "sun_halo.png" sRGB clamp: the sun
uniform sampler2D cloudsFair;  // "clouds_fair.png" linear repeat: panorama of fair weather
uniform sampler2D cloudsStorm; // "clouds_storm.png" linear repeat: panorama of bad weather
uniform sampler2D cloudsHigh;  // "clouds_high.png" linear repeat: a layer from below

uniform float timeOfDay;      // 16.9 in [0, 24] step 0.1, hours: solar time at the start
uniform float hoursPerSecond; // 0 in [0, 4] step 0.05, hours per second: how fast the time of day runs
uniform float weather;        // 1 in [0.5, 1] step 0.05: 1 fair, 0.5 bad
uniform float turned;         // 0.38 in [-1, 1] step 0.02, turns: where the panoramas stand at the start
uniform float drift;          // 0.001 in [0, 0.1] step 0.001, turns a second: how fast they go round
uniform vec2  walk;           // 0,0 in [-2, 2] step 0.1, km: how far the eye has gone, to the north and to the east
uniform int   clouds;         // 3 in [0, 3]: 0 none, 1 the panoramas, 2 the high layer, 3 both
uniform int   maxSteps;       // 96 in [1, 512]: steps before a ray is given up
uniform float hitThreshold;   // 0.002 in [0.00001, 0.1] step *2, scene units: distance that counts as a hit

// x points north, y up, z east; the eye looks to the south. One scene unit is 5 metres.
const float LATITUDE = 43.6;
const float DECLINATION = -8.0; // of the sun, degrees: in the middle of October
const float KILOMETRE = 200.0;  // scene units
const float RISE = 0.56;        // by which the lens is shifted up, half screen heights: upright lines stay so
const float LOW_CLOUDS = 1.2, HIGH_CLOUDS = 8.0; // altitudes, km
const float MOON = 2.2e-6;      // light of a full moon, of the sun's
const float SUN_RADIUS = 0.009; // radians, of sun and moon: twice the true one
const vec3  LAMPLIGHT = vec3(1.0, 0.72, 0.38);

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen + vec2(0.0, RISE));
}

// ---- The coast ----

const vec3 TOWER = vec3(-15.5, 1.5, -6.4);
const vec3 HOUSE = vec3(-16.0, 2.0, -8.9);
const vec3 LANTERN = TOWER + vec3(0.0, 4.95, 0.0);

// Flat rocks with ledges and clefts: folds of triangular waves, whose slope together is at most 0.9.
float rockDistance(vec3 p)
{
    vec3 fold = abs(fract(vec3(0.47, 0.9, 0.61) * p + 0.21 * p.zxy) - 0.5);
    float cape = max(length(p.xz - vec2(-16.0, -8.6)) - 3.9, p.y - 1.5);
    float hill = max(length(p.xz - vec2(-17.4, -14.4)) - 5.2, p.y - 2.4 + 0.12 * abs(p.z + 15.0));
    float boulder = sdSphere(p - vec3(-13.6, -0.7, -4.9), 1.5);
    float d = opSmoothUnion(opSmoothUnion(cape, hill, 1.4), boulder, 0.6);
    d = opUnion(d, sdSphere(p - vec3(-13.9, -0.6, -2.3), 0.85));
    return (d - 0.2 + fold.x * fold.z + 0.2 * fold.y + 0.2 * fold.z) / 1.9;
}

float towerDistance(vec3 p)
{
    vec3 q = p - TOWER;
    float d = sdCappedCone(q - vec3(0.0, 2.2, 0.0), 0.74, 0.46, 2.2);
    d = opUnion(d, sdCylinder(q - vec3(0.0, 4.46, 0.0), 0.68, 0.06));
    d = opUnion(d, sdCylinder(q - vec3(0.0, 4.9, 0.0), 0.36, 0.4));
    return opUnion(d, sdCappedCone(q - vec3(0.0, 5.5, 0.0), 0.48, 0.04, 0.22));
}

float houseDistance(vec3 p)
{
    vec3 q = p - HOUSE, side = vec3(abs(q.x), q.y - 0.5, abs(q.z));
    float roof = max(dot(side.xy - vec2(0.8, -0.05), vec2(0.6, 0.8)), max(-side.y, side.z - 1.2));
    float d = opUnion(sdBox(q, vec3(0.7, 0.5, 1.1)), roof);
    return opUnion(d, sdBox(q - vec3(0.1, 1.0, -0.8), vec3(0.14, 0.36, 0.16)));
}

// The three of them, so that the hit knows which it is.
vec3 partDistances(vec3 p)
{
    return vec3(rockDistance(p), towerDistance(p), houseDistance(p));
}

float sceneDistance(vec3 p)
{
    vec3 part = partDistances(p);
    return opUnion(part.x, opUnion(part.y, part.z));
}

// Where a ray may meet it: in a flat box round rocks and house, or in a slender one round the tower.
vec2 coastInterval(Ray ray)
{
    vec2 rocks = boxInterval(ray, vec3(-22.5, -0.1, -21.0), vec3(-11.6, 3.4, -1.4));
    return intervalUnion(rocks, boxInterval(ray, TOWER - vec3(0.76, 0.5, 0.76), TOWER + vec3(0.76, 5.8, 0.76)));
}

// ---- What gives light ----

// Found once for each pixel. By night the full moon takes the sun's place: the same sky, much darker.
struct Lights {
    vec3  sun;      // or moon: direction, length 1
    float strength; // of it and of its sky: 1 the sun's
    vec3  low;      // its light at the ground, on a surface across it
    vec3  high;     // the same at the clouds
    vec3  sky;      // light of all the sky on a level white surface
    float stops;    // of the exposure
    float lamp;     // how far the lamps are on
};

Lights lightsAt(float hour)
{
    vec3 sun = sunDirection(hour, LATITUDE, DECLINATION);
    bool night = sun.y < -0.2;
    float strength = night ? MOON * smoothstep(0.2, 0.28, -sun.y) : 1.0;
    sun = night ? -sun : sun;
    vec3 low = strength * tableSunlight(sun), clear = strength * tableAmbient(sun) + 6e-8;
    vec3 high = strength * tableSunlight(vec3(0.0, cloudSunHeight(sun.y, LOW_CLOUDS), 0.0));
    vec3 sky = mix(clear, overcastWhite(clear + low * max(sun.y, 0.0)), overcastShare(weather));
    float stops = -2.0 - 0.85 * log2(clear.y), left = sunLeft(weather);
    float dark = 1.0 - smoothstep(0.04, 0.15, sky.y);
    return Lights(sun, strength, left * low, left * high, sky, stops, dark * exp2(-stops));
}

// ---- Sky and clouds ----

vec3 skyLight(vec3 direction, Lights lights)
{
    vec3 light = tableSky(sunward, away, direction, lights.sun) + tableSun(halo, direction, lights.sun, SUN_RADIUS);
    return lights.strength * light + 6e-8;
}

// The fair panorama before the storm's before the high layer.
Cloud cloudsAt(vec3 direction, float width)
{
    float turn = turned + drift * iTime;
    vec3 eye = vec3(walk.x, 0.0, walk.y), seen = seenFromMiddle(eye, direction, LOW_CLOUDS);
    vec2 there = vec2(clouds & 1, clouds / 2);
    Cloud fair = cloudShare(cloudPanorama(cloudsFair, seen, turn, width), there.x * fairShare(weather));
    Cloud storm = cloudShare(cloudPanorama(cloudsStorm, seen, 0.7 * turn, width), there.x * stormShare(weather));
    Cloud high = cloudLayer(cloudsHigh, eye + vec3(0.0, 0.0, 10.0 * drift * iTime), direction, HIGH_CLOUDS, 70.0, width);
    return cloudOver(fair, cloudOver(storm, cloudShare(high, there.y)));
}

// The clear or the overcast sky, the clouds before it, and the haze before them.
vec3 skyWithClouds(vec3 direction, Lights lights, float width)
{
    vec3 up = vec3(direction.x, max(direction.y, 0.0), direction.z);
    vec3 sky = mix(skyLight(up, lights), overcastSky(up.y, lights.sky), overcastShare(weather));
    Cloud cloud = cloudsAt(up, width);
    vec3 light = cloudLight(cloud, up, lights.sun, lights.high, lights.sky);
    float haze = fogDepth(0.0, up.y, layerHit(0.0, up.y, LOW_CLOUDS), hazeDensity(weather), 1.5);
    return (1.0 - cloud.cover) * sky + throughFog(light, cloud.cover * sky, haze);
}

// The light of the lamp that haze sends to the eye: round the lamp, and along a beam that goes round.
//   far  where the ray ends
float lampHaze(Ray ray, float far)
{
    vec3 from = ray.origin - LANTERN, beam = vec3(sin(1.2 * iTime + 0.5), 0.02, cos(1.2 * iTime + 0.5));
    float nearest = -dot(from, ray.direction), aside = length(from + nearest * ray.direction) + 0.05;
    float round_ = (atan((far - nearest) / aside) + atan(nearest / aside)) / aside;
    float facing = dot(beam, ray.direction), across = max(1.0 - facing * facing, 0.002);
    float along = max((dot(from, beam) + facing * nearest) / across, 0.0), place = nearest + along * facing;
    float wide = 0.1 + 0.035 * along, off = length(from + place * ray.direction - along * beam) / wide;
    float ahead = smoothstep(0.0, 1.0, place) * smoothstep(-0.5, 0.5, far - place);
    return 0.03 * round_ + 0.25 * exp(-off * off) / wide * ahead * inversesqrt(across);
}

// ---- Sea and land ----

// The normal of the waves at a place, without those that are shorter than a pixel.
//   swell  noise of the long ones
vec3 waveNormal(vec3 p, vec4 swell, float width)
{
    vec2 ripple = valueNoise(vec3(4.7 * p.zx, 1.9 * iTime)).zy;
    vec2 slope = mix(0.3, 0.12, weather) * (swell.yz * exp(-1.3 * width) + ripple * exp(-4.7 * width));
    return normalize(vec3(-slope.x, 1.0, -slope.y));
}

// What the place is made of, found once, at the hit: its colour, and in w the share that is a lit window.
vec4 landColour(vec3 p, vec3 part, vec3 normal, float tone, float width)
{
    vec3 stone = mix(vec3(0.13, 0.11, 0.10), vec3(0.42, 0.36, 0.30), tone) * (0.25 + 0.75 * smoothstep(0.0, 0.5, p.y));
    vec3 turf = mix(vec3(0.09, 0.09, 0.03), vec3(0.18, 0.15, 0.06), tone);
    vec3 ground = mix(stone, turf, smoothstep(0.55, 0.85, normal.y) * smoothstep(1.0, 1.5, p.y + 0.5 * tone));
    const vec3 WHITE = vec3(0.78, 0.75, 0.70), RED = vec3(0.42, 0.05, 0.035), SLATE = vec3(0.14, 0.13, 0.15);
    vec3 q = p - TOWER, r = p - HOUSE;
    float band = coverage(0.55 - abs(q.y - 2.6), width) + coverage(q.y - 5.26, width);
    vec3 painted = mix(WHITE, RED, min(band + coverage(0.12 - abs(q.y - 4.42), width), 1.0));
    float glass = coverage(0.3 - abs(q.y - 4.92), width);
    vec3 wall = r.y > 0.47 && r.y < 1.05 ? SLATE : WHITE;
    float panes = r.x > 0.65 ? coverage(0.14 - abs(abs(r.z - 0.1) - 0.5), width) * coverage(0.18 - abs(r.y - 0.05), width) : 0.0;
    vec4 building = part.y < part.z ? vec4(mix(painted, vec3(0.05), glass), 6.0 * glass) : vec4(mix(wall, vec3(0.03), panes), panes);
    return part.x < min(part.y, part.z) ? vec4(ground, 0.0) : building;
}

// ---- The picture ----

vec3 rayColour(Ray ray)
{
    Lights lights = lightsAt(timeOfDay + hoursPerSecond * iTime);
    float spread = pixelSpread(), sea = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : 1e5;
    vec2 interval = coastInterval(ray);
    Hit hit = marchCone(ray, interval.x, min(interval.y, sea), hitThreshold, spread, maxSteps);
    bool land = hit.found, water = !land && sea < 1e5;
    float t = land ? hit.t : sea, width = 2.0 * spread * t;
    vec3 p = ray.origin + t * ray.direction;
    vec4 grain = valueNoise(land ? vec3(1.7, 7.0, 1.7) * p : vec3(1.3 * p.xz + 0.3 * iTime, 0.6 * iTime));
    vec3 normal = land ? normalAt(p, hitThreshold + spread * t) : waveNormal(p, grain, width);
    vec3 part = partDistances(p);
    normal = land && part.x < min(part.y, part.z) ? bumpedNormal(normal, 0.055 * vec3(1.7, 7.0, 1.7) * grain.yzw) : normal;
    if (land || water) { // the views and the probe show what was met, the sea too
        traceNormal(normal);
        traceMarch(trace.steps, t, END_HIT);
    }

    // The sea mirrors the sky: one sky is asked, along the ray or along the mirrored one.
    vec3 mirrored = reflect(ray.direction, normal);
    mirrored.y = abs(mirrored.y) + 0.02;
    Ray seen = Ray(water ? p : ray.origin, water ? normalize(mirrored) : ray.direction);
    vec3 sky = skyWithClouds(seen.direction, lights, water ? 0.01 : 2.0 * spread);
    vec3 lamp = lights.lamp * LAMPLIGHT;

    Ray up = shadowRay(p, normal, lights.sun, 0.02 + width);
    vec2 way = coastInterval(up);
    float lit = march(up, way.x, land ? way.y : 0.0, 0.01, 32).found ? 0.0 : 1.0;
    vec4 colour = landColour(p, part, normal, grain.x, width);
    vec3 open = lights.sky * (0.6 + 0.4 * normal.y) + lit * lights.low * lambert(normal, lights.sun);
    vec3 deep = vec3(0.015, 0.05, 0.055) * (lights.sky + 0.5 * lights.low * lights.sun.y);
    vec3 waves = mix(deep, sky, schlickShare(clamp(-dot(ray.direction, normal), 0.0, 1.0), 0.02));
    vec3 light = land ? colour.rgb * open + colour.w * lamp : (water ? waves : sky);

    light += (0.2 + overcastShare(weather)) * lampHaze(seen, land ? t : 1e4) * (water ? 0.3 : 1.0) * lamp;
    float drops = rainShare(weather) * rainStreaks(screenPosition(vec2(iPixel) + 0.5), iTime, 2.0 / iResolution.y);
    light = mix(light, lights.sky, 0.35 * drops);
    return encodeSRGB(filmOfLargest(exposed(light, lights.stops), 1.3, 6.0));
}
