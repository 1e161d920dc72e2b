// 20 Clouds and weather: a lighthouse by the sea, under drifting clouds, at every hour and in every
// weather.

#include "main.glsl"       // main(): calls pixelRay, then rayColour
#include "cone.glsl"       // perspectiveRay, marchCone, pixelSpread
#include "coast.glsl"      // the lighthouse, its house and its rocks: coastDistances, coastInterval, coastColour
#include "shadow.glsl"     // shadowRay; march of march.glsl
#include "normal.glsl"     // normalAt
#include "lighting.glsl"   // lambert, encodeSRGB
#include "noise.glsl"      // valueNoise
#include "texture.glsl"    // bumpedNormal
#include "fresnel.glsl"    // schlickShare
#include "film.glsl"       // exposed, filmOfLargest, ditherStep
#include "fog.glsl"        // fogDepth, throughFog, lampInFog, beamInFog
#include "sky_table.glsl"  // the clear sky and the sun, and their light
#include "night.glsl"      // skyTurn, starLight, milkyWay, airglow, nightSight
#include "clouds.glsl"     // clouds of a panorama and of a layer, their light, and the weather

uniform sampler2D sunward;     // "sky_sunward.png" sRGB clamp: the sky on the sun's side
uniform sampler2D away;        // "sky_away.png" sRGB clamp: the sky on the other side
uniform sampler2D halo;        // "sun_halo.png" sRGB clamp: the sun
uniform sampler2D meter;       // "sky_meter.png" linear clamp: what an exposure meter reads
uniform sampler2D cloudsFair;  // "clouds_fair.png" linear repeat: panorama of fair weather
uniform sampler2D cloudsStorm; // "clouds_storm.png" linear repeat: panorama of bad weather
uniform sampler2D cloudsHigh;  // "clouds_high.png" linear repeat: a layer from below

uniform float timeOfDay;      // 16.9 in [0, 24] step 0.1, hour of the day: solar time at the start
uniform float hoursPerSecond; // 0 in [0, 4] step 0.05, hours per second: speed of the time of day
uniform float weather;        // 1 in [0.5, 1] step 0.05: 1 fair, 0.5 bad
uniform float turned;         // 0.38 in [-1, 1] step 0.02, turns: position of the panoramas at the start
uniform float drift;          // 0.001 in [0, 0.1] step 0.001, turns per second: speed of the panoramas
uniform vec2  walk;           // 0,0 in [-2, 2] step 0.1, km: distance that the eye has moved, to the north and to the east
uniform int   clouds;         // 3 in [0, 3]: 0 none, 1 the panoramas, 2 the high layer, 3 both
uniform int   maxSteps;       // 192 in [1, 512]: steps after which a ray is abandoned
uniform float hitThreshold;   // 0.002 in [0.00001, 0.1] step *2, scene units: distance that counts as a hit

// x points north, y up, z east; at the start the camera looks south. One scene unit is 5 metres.
const float LATITUDE = 43.6;
const float DECLINATION = -8.0; // declination of the sun in the middle of October, degrees
const float RISE = 0.56;        // upward shift of the lens in half screen heights; vertical lines stay vertical
const float LOW_CLOUDS = 1.2, CLOUD_TOPS = 3.0, HIGH_CLOUDS = 8.0; // altitudes, km
const float MOON = 2.2e-6;      // light of the full moon, as a share of the sun's
const float SUN_RADIUS = 0.009; // angular radius of the sun and the moon, radians: about twice the true radius
const vec3  LAMPLIGHT = vec3(1.0, 0.72, 0.38);
const float BEAM_LOST = 0.015;   // share of the light of the beam that haze removes, per scene unit

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen + vec2(0.0, RISE));
}

float sceneDistance(vec3 p)
{
    vec3 part = coastDistances(p);
    return opUnion(part.x, opUnion(part.y, part.z));
}

// The camera stops in front of the coast and above the sea.
float cameraRoom(vec3 p)
{
    return min(sceneDistance(p), p.y) - 0.1;
}

// ---- The sources of light ----

// These values are computed once for each pixel. The full moon is opposite the sun: it fades in while the sun sinks
// from -2 degrees to -7. The sky lit by the sun and the sky lit by the moon are added.
struct Lights {
    float hour;        // solar time
    vec3  skySun;      // direction of the source whose sky is brighter, length 1
    float skyStrength; // strength of that source: 1 for the sun
    vec3  even, both;  // light of the other source's sky and of both skies, taken as the same in all directions
    float apart;       // 0 if both skies are equally bright: they are then taken as even; 1 by day
    vec3  sun;      // direction to the sun, or to the moon once the sun lights no cloud
    float strength; // light of that source: 1 for the sun
    vec3  low;      // light of that source at the ground, on a perpendicular surface
    vec3  tops;     // light of that source at the tops of the clouds, on a perpendicular surface
    vec3  high;     // light of that source at the high layer of clouds, on a perpendicular surface
    vec3  sky;      // light of the whole sky on a horizontal white surface
    float stops;    // exposure, in stops
    float lamp;     // brightness of the lamps
};

Lights lightsAt(float hour)
{
    vec3 daySun = sunDirection(hour, LATITUDE, DECLINATION);
    bool night = daySun.y < -0.05;
    float moon = MOON * smoothstep(0.035, 0.12, -daySun.y), strength = night ? moon : 1.0;
    vec3 sun = night ? -daySun : daySun;
    vec3 ofSun = tableAmbient(daySun), ofMoon = moon * tableAmbient(-daySun), clear = ofSun + ofMoon + 6e-8;
    float apart = smoothstep(0.0, 0.8, abs(ofSun.y - ofMoon.y) / (ofSun.y + ofMoon.y));
    bool moonlit = ofMoon.y > ofSun.y;
    vec3 low = strength * tableSunlight(sun);
    vec3 tops = strength * tableSunlight(vec3(0.0, cloudSunHeight(sun.y, CLOUD_TOPS), 0.0));
    vec3 high = strength * tableSunlight(vec3(0.0, cloudSunHeight(sun.y, HIGH_CLOUDS), 0.0));
    vec3 sky = mix(clear, overcastWhite(clear + low * max(sun.y, 0.0)), overcastShare(weather));
    float sunMetered = meteredSky(meter, iCameraForward, daySun), moonMetered = moon * meteredSky(meter, iCameraForward, -daySun);
    vec3 sunEven = sunMetered / brightness(ofSun) * ofSun, moonEven = moonMetered / brightness(ofMoon + 1e-12) * ofMoon;
    float metered = sunMetered + moonMetered + 6e-8, left = sunLeft(weather);
    metered = mix(metered, brightness(0.25 * left * tops + 0.6 * sky), 0.5 * float(clouds & 1));
    float stops = adaptedStops(mix(metered, 2.0 * brightness(sky), overcastShare(weather)));
    float dark = 1.0 - smoothstep(0.0, 0.12, sky.y);
    return Lights(hour, moonlit ? -daySun : daySun, moonlit ? moon : 1.0, moonlit ? sunEven : moonEven, sunEven + moonEven, apart, sun, strength,
                  left * low, left * tops, left * high, sky, stops, dark * exp2(-stops));
}

// ---- Sky and clouds ----

// The clear sky without sun, moon and stars.
vec3 skyLight(vec3 direction, Lights lights)
{
    vec3 brighter = lights.skyStrength * tableSky(sunward, away, direction, lights.skySun);
    return mix(lights.both, brighter + lights.even, lights.apart) + 6e-8;
}

// The light from beyond the air: the disc of the sun or the moon, and the stars. In October the sun is opposite to where
// it is half a year before, when its declination is as far above 0.
vec3 heavens(vec3 direction, Lights lights, float width)
{
    vec3 star = skyTurn(hourOfStars(lights.hour, -DECLINATION) + 0.5 * SIDEREAL_DAY, LATITUDE) * direction;
    vec3 disc = lights.strength * tableSun(halo, direction, lights.sun, SUN_RADIUS);
    return disc + transmittance(RAYLEIGH, airMass(direction.y)) * (starLight(star, width) + milkyWay(star));
}

// The clouds of the panoramas, fair weather in front of bad weather.
Cloud lowClouds(vec3 direction, float width)
{
    float turn = turned + drift * iTime, there = float(clouds & 1);
    vec3 seen = seenFromMiddle(vec3(walk.x, 0.0, walk.y), direction, LOW_CLOUDS);
    Cloud fair = cloudShare(cloudPanorama(cloudsFair, seen, turn, width), there * fairShare(weather));
    return cloudOver(fair, cloudShare(cloudPanorama(cloudsStorm, seen, 0.7 * turn, width), there * stormShare(weather)));
}

// The high layer, behind them.
Cloud highClouds(vec3 direction, float width)
{
    vec3 eye = vec3(walk.x, 0.0, walk.y + 10.0 * drift * iTime);
    return cloudShare(cloudLayer(cloudsHigh, eye, direction, HIGH_CLOUDS, 70.0, width), float(clouds / 2));
}

// The clear or overcast sky with the disc of the sun or the moon, the clouds in front of the sky, and
// the haze in front of the clouds.
vec3 skyWithClouds(vec3 direction, Lights lights, float width)
{
    float grey = overcastShare(weather);
    vec3 up = vec3(direction.x, max(direction.y, 0.0), direction.z);
    vec3 sky = mix(skyLight(up, lights), overcastSky(up.y, lights.sky), grey);
    vec3 beyond = discLeft(weather) * heavens(up, lights, width);
    Cloud low = lowClouds(up, width), high = highClouds(up, width), cloud = cloudOver(low, high);
    vec3 light = cloudLight(low, up, lights.sun, lights.tops, lights.sky);
    light += (1.0 - low.cover) * cloudLight(high, up, lights.sun, lights.high, lights.sky);
    float haze = fogDepth(0.0, up.y, layerHit(0.0, up.y, LOW_CLOUDS), hazeDensity(weather), 1.5);
    return (1.0 - cloud.cover) * (sky + beyond) + throughFog(light, cloud.cover * sky, haze);
}

// ---- Sea and land ----

// The point that a ray meets.
struct Surface {
    bool  land, water; // both false for the sky
    float t;           // distance to p along the ray; 1e5 for the sky
    vec3  p;
    vec3  part;        // distances to the rocks, the tower and the house
    vec3  normal;
    float tone;        // noise at p, in [0, 1)
    float width;       // width of the pixel at p, scene units
    Ray   seen;        // the ray on which the sky is evaluated: mirrored for the sea
};

// The normal of the waves at a point, without waves that are shorter than a pixel.
//   swell  noise of the long waves
vec3 waveNormal(vec3 p, vec4 swell, float width)
{
    vec2 ripple = valueNoise(vec3(4.7 * p.zx, 1.9 * iTime)).zy;
    vec2 slope = mix(0.3, 0.12, weather) * (swell.yz * exp(-1.3 * width) + ripple * exp(-4.7 * width));
    return normalize(vec3(-slope.x, 1.0, -slope.y));
}

// The march finds only the coast. The sea is the plane y = 0.
Surface surfaceAlong(Ray ray)
{
    float spread = pixelSpread(), sea = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : 1e5;
    vec2 interval = coastInterval(ray);
    Hit hit = marchCone(ray, interval.x, min(interval.y, sea), hitThreshold, spread, maxSteps);
    bool land = hit.found, water = !land && sea < 1e5;
    float t = land ? hit.t : sea, width = 2.0 * spread * t;
    vec3 p = ray.origin + t * ray.direction, part = coastDistances(p);
    vec4 grain = valueNoise(land ? vec3(1.7, 7.0, 1.7) * p : vec3(1.3 * p.xz + 0.3 * iTime, 0.6 * iTime));
    vec3 normal = land ? normalAt(p, hitThreshold + spread * t) : waveNormal(p, grain, width);
    if (land && part.x < min(part.y, part.z)) { // rock, in thick layers of thin ones
        vec4 thin = exp(-14.0 * width) * (valueNoise(vec3(6.1, 29.0, 6.1) * p + 2.0 * grain.x) - vec4(0.5, 0.0, 0.0, 0.0));
        normal = bumpedNormal(normal, 0.055 * vec3(1.7, 7.0, 1.7) * grain.yzw + 0.022 * vec3(6.1, 29.0, 6.1) * thin.yzw);
        grain.x = clamp(grain.x + 0.9 * thin.x, 0.0, 1.0);
    }
    if (land || water) { // the views and the probe show every hit, including the sea
        traceNormal(normal);
        traceMarch(trace.steps, t, END_HIT);
    }
    vec3 mirrored = reflect(ray.direction, normal);
    mirrored = normalize(vec3(mirrored.x, abs(mirrored.y) + 0.02, mirrored.z));
    Ray seen = Ray(water ? p : ray.origin, water ? mirrored : ray.direction);
    return Surface(land, water, t, p, part, normal, grain.x, width, seen);
}

// The angle over which a pixel averages the sky, radians. It is larger on the sea, whose waves scatter
// the mirrored rays.
float skyWidth(Surface surface)
{
    return surface.water ? 0.01 : 2.0 * pixelSpread();
}

// ---- The picture ----

// The light that a point sends to the eye.
//   sky  from skyWithClouds along surface.seen
vec3 surfaceLight(Surface surface, vec3 direction, vec3 sky, Lights lights)
{
    Ray up = shadowRay(surface.p, surface.normal, lights.sun, 0.02 + surface.width);
    vec2 way = coastInterval(up);
    float lit = march(up, way.x, surface.land ? way.y : 0.0, 0.01, 32).found ? 0.0 : 1.0;
    vec4 colour = coastColour(surface.p, surface.part, surface.normal, surface.tone, surface.width);
    vec3 open = lights.sky * (0.6 + 0.4 * surface.normal.y) + lit * lights.low * lambert(surface.normal, lights.sun);
    vec3 deep = vec3(0.015, 0.05, 0.055) * (lights.sky + 0.5 * lights.low * lights.sun.y);
    float share = schlickShare(clamp(-dot(direction, surface.normal), 0.0, 1.0), 0.02);
    vec3 land = colour.rgb * open + colour.w * lights.lamp * LAMPLIGHT;
    return surface.land ? land : (surface.water ? mix(deep, sky, share) : sky);
}

// Add the haze lit by the lamp and its beam, then the rain in front of everything. Apply the film last.
vec3 developed(vec3 light, Surface surface, Lights lights)
{
    vec3 from = surface.seen.origin - LANTERN, beam = vec3(sin(1.2 * iTime + 0.5), 0.03, cos(1.2 * iTime + 0.5));
    float far = surface.land ? surface.t : 1e4, haze = 0.03 * lampInFog(from, surface.seen.direction, far, 0.05);
    haze += 0.09 * beamInFog(from, surface.seen.direction, beam, vec2(0.1, 0.025), far, BEAM_LOST);
    haze *= (0.2 + 0.6 * overcastShare(weather)) * (surface.water ? 0.3 : 1.0);
    light += haze * lights.lamp * LAMPLIGHT;
    float drops = rainStreaks(screenPosition(vec2(iPixel) + 0.5), iTime, 2.0 / iResolution.y);
    light = mix(light, lights.sky, 0.35 * rainShare(weather) * drops);
    vec3 seen = exposed(nightSight(daylightFilm(light)), lights.stops);
    return encodeSRGB(filmOfLargest(seen, 1.3, 6.0)) + ditherStep(iPixel) / 255.0;
}

vec3 rayColour(Ray ray)
{
    Lights lights = lightsAt(timeOfDay + hoursPerSecond * iTime);
    Surface surface = surfaceAlong(ray);
    vec3 sky = skyWithClouds(surface.seen.direction, lights, skyWidth(surface));
    return developed(surfaceLight(surface, ray.direction, sky, lights), surface, lights);
}
