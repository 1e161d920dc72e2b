// 21 A landscape: a lake between mountains, at every hour and in all weathers.

#include "main.glsl"      // main(): calls pixelRay, then rayColour
#include "cone.glsl"      // perspectiveRay, pixelSpread
#include "relaxed.glsl"   // marchRelaxed
#include "valley.glsl"    // the scene: landDistance, landAt, landColour, thingsAlong, unmirrored, wavesAt
#include "water.glsl"     // footprintOnWater, glitter
#include "fresnel.glsl"   // schlickShare
#include "lighting.glsl"  // lambert, encodeSRGB
#include "soft_shadow.glsl" // discBesideEdge; shadowRay, shadowReach of shadow.glsl
#include "fog.glsl"       // fogDepth, fogLight, throughFog; sunDirection, airMass of sky.glsl
#include "film.glsl"      // exposed, filmOfLargest, ditherStep
#include "sky_table.glsl" // tableSky, tableSun, tableSunlight, tableAmbient, skyBrightness, daylightFilm
#include "night.glsl"     // skyTurn, starLight, airglow, the moon
#include "clouds.glsl"    // cloudPanorama, cloudLight, and the weather
#include "coarse.glsl"    // coarseStart

uniform sampler2D sunward;     // "sky_sunward.png" sRGB clamp: the sky on the sun's side
uniform sampler2D away;        // "sky_away.png" sRGB clamp: the sky on the other side
uniform sampler2D halo;        // "sun_halo.png" sRGB clamp: the sun
uniform sampler2D meter;       // "sky_meter.png" linear clamp: what an exposure meter reads
uniform sampler2D moonMap;     // "moon.png" linear clamp: the moon's face
uniform sampler2D cloudsFair;  // "clouds_fair.png" linear repeat: panorama of fair weather
uniform sampler2D cloudsStorm; // "clouds_storm.png" linear repeat: panorama of bad weather
uniform sampler2D cloudsHigh;  // "clouds_high.png" linear repeat: a layer from below

uniform float timeOfDay;      // 18.4 in [0, 24] step 0.2, hour of the day: solar time at the start
uniform float hoursPerSecond; // 0.05 in [0, 4] step 0.05, hours per second: speed of the time of day
uniform float declination;    // 10 in [-23, 23] step 1, degrees: declination of the sun
uniform float weather;        // 1 in [0.5, 1] step 0.05: 1 fair, 0.5 bad
uniform float moonAge;        // 14.77 in [0, 29.53] step 1, days: time since new moon; 14.77 is full moon
uniform bool  clouds;         // true: show the clouds
uniform float turned;         // 0.1 in [0, 1] step 0.02, turns: position of the clouds at noon; they go round once a day
uniform float wind;           // 0.3 in [0, 1] step 0.05: roughness of the water
uniform float mist;           // 0.005 in [0, 0.1] step 0.001, per scene unit: share of light lost in the clear air at the water
uniform float exposure;       // 0.5 in [-6, 6] step 0.25, stops: added to the exposure that the meter gives
uniform float omega;          // 1.3 in [1, 1.95] step 0.05, distances: length of a step
uniform float footprint;      // 0.25 in [0, 8] step 0.05, half pixels: how fast the threshold grows along the ray
uniform int   maxSteps;       // 384 in [1, 512]: steps after which a ray is abandoned
uniform float hitThreshold;   // 0.0002 in [0.00001, 0.1] step *2, scene units: distance at the eye that counts as a hit

const float FAR = 160.0;       // a ray that has travelled this far meets the sky
const float SHADOW_FAR = 60.0; // greatest length of a shadow ray
const float MIST_SCALE = 3.0;  // the height over which the mist thins to 1 / e
const float LATITUDE = 43.6;   // latitude of the lake, degrees
const float SUN_RADIUS = 0.0047, MOON_RADIUS = 0.009; // angular radii, radians: the moon's is twice the true radius
const float DISC = 0.0047;      // the true angular radius of sun and moon, radians, for shadows
const float LOW_CLOUDS = 3.0, HIGH_CLOUDS = 8.0; // altitudes, km
const float HIGH_PERIOD = 70.0; // period of the picture of the high clouds, km; the picture moves by one period a day
const float MOON_STOPS = 3.5;   // greatest exposure of the moon, in stops: an eye that looks at the moon adapts
const vec3  LAMPLIGHT = vec3(0.62, 0.24, 0.06);  // light from the windows of the cabin

// The hour, the weather and the point on the screen, set once for each pixel.
float theHour, theWeather;
vec2  theScreen;

Ray pixelRay(vec2 screen)
{
    theHour = timeOfDay + hoursPerSecond * iTime;
    theWeather = weather;
    theScreen = screen;
    return perspectiveRay(screen);
}

// How much the waves blur the mirrored image, per unit of distance from the water; and the number of
// octaves to evaluate, where 0 means the value of the parameter octaves.
float mirrorBlur = 0.0;
int   asked = 0;

// The distance to the land. Below the water, the land has at most two octaves, and the blur is
// subtracted from the distance.
float sceneDistance(vec3 p)
{
    bool below = p.y < 0.0;
    float land = landDistance(unmirrored(p), asked > 0 ? asked : (below ? min(octaves, 2) : octaves));
    return land - (below ? mirrorBlur * length(p - bend.point) : 0.0);
}

// The camera stops above the land and above the water.
float cameraRoom(vec3 p)
{
    return min(landDistance(p, octaves), p.y) - 0.02;
}

float coarseMargin(float t)
{
    return hitThreshold + footprint * pixelSpread() * t;
}

// ---- The hour ----

// The sources of light, computed once for each pixel.
struct Hour {
    float noon;             // hours since noon, in [0, 24)
    vec3  sun, moon, toLight; // directions; toLight is the direction to the sun by day and to the moon at night
    vec3  beam;             // light from toLight on a perpendicular surface, at the ground
    vec3  low, high;        // the same at the low and at the high clouds
    vec3  sky;              // light of the whole sky on a horizontal white surface
    vec3  moonlit;          // light of the clear night sky that comes from the moon
    float lamp;             // brightness of the lamps, in [0, 1]
    float stops;            // exposure, in stops
    float dimmed;           // share of the light of the moon's disc and of its reflection that is shown
};

Hour hourNow()
{
    float noon = mod(theHour - 12.0, 24.0);
    vec3 sun = sunDirection(noon + 12.0, LATITUDE, declination);
    vec3 moon = moonDirection(noon + 12.0, LATITUDE, declination, moonAge), full = 0.1 * moonlight(-dot(sun, moon));
    vec3 sunBeam = tableSunlight(sun), moonBeam = full * tableSunlight(moon);
    bool day = sun.y > -0.05;
    vec3 toLight = day ? sun : moon, beam = day ? sunBeam : moonBeam;
    vec3 strength = day ? vec3(1.0) : full;
    vec3 low = strength * tableSunlight(vec3(0.0, cloudSunHeight(toLight.y, LOW_CLOUDS), 0.0));
    vec3 high = strength * tableSunlight(vec3(0.0, cloudSunHeight(toLight.y, HIGH_CLOUDS), 0.0));
    float moonUp = max(moon.y, 0.0);
    vec3 moonlit = vec3(0.8, 1.0, 1.3) * (0.15 * moonUp * moonBeam), clear = tableAmbient(sun) + moonlit + 6e-8;
    vec3 sky = mix(clear, overcastWhite(clear + max(toLight.y, 0.0) * beam), overcastShare(theWeather));
    float left = sunLeft(theWeather), metered = meteredSky(meter, iCameraForward, sun) + brightness(moonlit + airglow(0.2));
    metered = mix(metered, brightness(0.25 * left * low + 0.6 * sky), clouds ? 0.5 : 0.0);
    float stops = exposure + adaptedStops(mix(metered, 2.0 * brightness(sky), overcastShare(theWeather)));
    return Hour(noon, sun, moon, toLight, left * beam, left * low, left * high, sky, moonlit,
                1.0 - smoothstep(0.05, 0.3, sky.g), stops, exp2(min(MOON_STOPS - stops, 0.0)));
}

// ---- The sky ----

// The sky behind the air: stars, the band of the Milky Way, and the moon.
//   mirrored  true for a reflection in the water: waves do not mirror a disc as a disc, so the moon
//             is left out, and glitter adds its light
vec3 heavens(vec3 direction, Hour now, float width, bool mirrored)
{
    vec3 star = skyTurn(hourOfStars(now.noon + 12.0, declination), LATITUDE) * direction, stars = starLight(star, width) + milkyWay(star);
    mat3 frame = moonFrame(now.moon, LATITUDE);
    vec2 point = moonPoint(frame * direction, MOON_RADIUS);
    float rim = width / MOON_RADIUS, inside = 1.0 - smoothstep(1.0 - rim, 1.0 + rim, length(point));
    return mix(stars, now.dimmed * moonFace(moonMap, point, rim, frame * now.sun, 1.0), mirrored ? 0.0 : inside);
}

// The light of the sky from a direction, with the clouds of the weather.
//   mirrored  as for heavens
//   open      share of a disc in this direction that clouds and weather leave visible
vec3 skyLight(vec3 direction, Hour now, bool mirrored, out float open)
{
    float width = min(2.0 * pixelSpread(), 0.003), noon = now.noon / 24.0, disc = discLeft(theWeather);
    vec3 through = exp(-(RAYLEIGH + 0.05) * airMass(direction.y));
    vec3 clear = tableSky(sunward, away, direction, now.sun) + airglow(direction.y) + now.moonlit;
    clear += disc * through * heavens(direction, now, width, mirrored);
    clear += mirrored ? vec3(0.0) : disc * tableSun(halo, direction, now.sun, SUN_RADIUS);
    vec3 sky = mix(clear, overcastSky(direction.y, now.sky), overcastShare(theWeather));
    Cloud fair = cloudShare(cloudPanorama(cloudsFair, direction, turned + noon, width), clouds ? fairShare(theWeather) : 0.0);
    Cloud storm = cloudShare(cloudPanorama(cloudsStorm, direction, turned + noon, width), clouds ? stormShare(theWeather) : 0.0);
    Cloud high = cloudLayer(cloudsHigh, vec3(0.0, 0.0, HIGH_PERIOD * noon), direction, HIGH_CLOUDS, HIGH_PERIOD, width);
    Cloud low = cloudOver(fair, storm);
    high = cloudShare(high, clouds ? 0.7 : 0.0);
    float left = 1.0 - cloudOver(low, high).cover;
    open = left * disc;
    vec3 behind = cloudLight(high, direction, now.toLight, now.high, now.sky);
    return left * sky + (1.0 - low.cover) * behind + cloudLight(low, direction, now.toLight, now.low, now.sky);
}

// ---- Land ----

struct Surface {
    vec3  p, normal, colour;
    float lamp; // 1 in a lit window, otherwise 0
};

Surface surfaceAt(vec3 p, vec3 direction, float width, bool thing)
{
    vec2 slope = higherGround(hills(inValley(p.xz)).xyz, shore(inValley(p.xz))).yz; // at a grazing angle a pixel covers more ground
    float facing = abs(dot(direction, normalize(vec3(-fromValley(slope), 1.0)).xzy));
    float count = log2(1.2 * sqrt(facing) / (CELLS * width)) / log2(LACUNARITY);
    vec4 land = landAt(inValley(p.xz), thing ? 1.0 : clamp(count, 1.0, 12.0));
    vec3 normal = normalize(vec3(-fromValley(land.yz), 1.0)).xzy, ofThing = thingNormal(p);
    vec4 paint = thingColour(p, ofThing);
    vec3 colour = landColour(p, direction, normal, land.w, width);
    return Surface(p, thing ? ofThing : normal, thing ? paint.rgb : colour, thing ? paint.w : 0.0);
}

// The visible share of the disc of the sun or the moon. The ray goes to the upper rim of the disc.
// The land hides the disc from below; the angle from the skyline to the ray is the least gap / distance.
// Only the first octave of the ridges is evaluated. The shadows of cabin, trees and boat are hard.
//   radius  of the pixel's footprint
float lightSeen(Surface surface, vec3 toLight, float radius)
{
    vec3 rim = normalize(toLight + vec3(0.0, DISC, 0.0));
    Ray up = shadowRay(surface.p, surface.normal, rim, 3.0 * radius);
    float far = min((HIGHEST - surface.p.y) / max(rim.y, 0.02), SHADOW_FAR);
    far = shadowReach(surface.normal, toLight, far);
    asked = 1;
    way = oneWay(abs(rim.y));
    float t = 0.0, clear = 1e3;
    int steps = 0;
    bool searching = far > 0.0;
    traceBegin(0.0, far);
    while (searching) {
        float distance = distanceAt(up.origin + t * rim);
        traceStep(steps, t, distance);
        steps++;
        clear = min(clear, overLand * length(rim.xz) / max(t, 0.01));
        t += max(distance, 0.2 * t + radius);
        searching = clear > 0.0 && t < far && steps < 24;
    }
    traceMarch(steps, t, clear > 0.0 ? END_PASSED : END_HIT);
    bool thing = thingsAlong(up, FAR, min(far, 3.0), hitThreshold, 0.0) > 0.0;
    return thing ? 0.0 : discBesideEdge(clear / DISC - 1.0);
}

vec3 surfaceLight(Surface surface, Hour now, float seen)
{
    vec3 open = (0.6 + 0.4 * surface.normal.y) * now.sky + seen * lambert(surface.normal, now.toLight) * now.beam;
    return surface.colour * open + surface.lamp * now.lamp * LAMPLIGHT;
}

// ---- The picture ----

vec3 rayColour(Ray ray)
{
    // Where the ray would meet the water, and how the water would mirror it.
    Hour now = hourNow();
    float spread = pixelSpread(), water = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : 2.0 * FAR;
    vec3 on = ray.origin + water * ray.direction;
    Water waves = wavesAt(on.xz, footprintOnWater(ray.direction, 2.0 * spread * water), mix(wind, 1.0, 0.6 * rainShare(theWeather)));
    vec3 facet = normalize(vec3(-waves.slope.x, 1.0, -waves.slope.y)), mirrored = reflect(ray.direction, facet);
    bend = Bend(true, vec3(on.x, 0.0, on.z), normalize(vec3(mirrored.x, max(mirrored.y, 0.002), mirrored.z)));

    // One march goes through the water into the mirrored world.
    mirrorBlur = 0.5 * sqrt(waves.variance);
    way = oneWay(max(abs(ray.direction.y), bend.direction.y));
    float top = ray.direction.y < 0.0 ? water + HIGHEST / bend.direction.y : (HIGHEST - ray.origin.y) / max(ray.direction.y, 0.02);
    float far = min(top, FAR);
    Hit hit = marchRelaxed(ray, min(coarseStart(ray), water), far, hitThreshold, footprint * spread, omega, maxSteps);
    float thing = thingsAlong(ray, water, hit.t, hitThreshold, spread), t = thing > 0.0 ? thing : hit.t;
    bool met = t < far, lake = t > water;
    vec3 p = unmirrored(ray.origin + t * ray.direction), direction = lake ? bend.direction : ray.direction;
    float first = min(t, water), then = t - first;
    if (lake) { // the views and the probe show every hit, including the water
        traceNormal(facet);
        traceMarch(trace.steps, first, END_HIT);
    }

    // The light of the point where the ray ends, dimmed by the mist on the path to the water and to the eye.
    Surface surface = Surface(p, vec3(0.0, 1.0, 0.0), vec3(0.0), 0.0);
    if (met)
        surface = surfaceAt(p, direction, 2.0 * spread * t + sqrt(waves.variance) * then, thing > 0.0);
    float open;
    vec3 sky = skyLight(direction, now, lake, open);
    vec3 light = met ? surfaceLight(surface, now, lightSeen(surface, now.toLight, coarseMargin(t))) : sky;
    traceNormal(surface.normal);
    float density = mist + 0.1 * (hazeDensity(theWeather) - hazeDensity(1.0));
    vec3 fog = fogLight(direction, now.toLight, 0.5 * now.sky, 0.25 * now.beam, 0.7);
    float height = lake ? 0.0 : ray.origin.y, last = lake ? then : t;
    light = throughFog(light, fog, met ? fogDepth(height, direction.y, last, density, MIST_SCALE) : 0.0);
    light = mix(light, sky, smoothstep(0.85 * FAR, FAR, t)); // land appears slowly
    float share = schlickShare(clamp(-dot(ray.direction, facet), 0.0, 1.0), 0.02);
    vec3 deep = vec3(0.012, 0.035, 0.035) * (now.sky + 0.3 * max(now.toLight.y, 0.0) * now.beam);
    vec3 ofLake = mix(deep, light + (met ? 0.0 : open) * glitter(ray.direction, now.toLight, waves, now.sun.y > -0.05 ? now.beam : now.dimmed * now.beam), share);
    ofLake = throughFog(ofLake, fog, fogDepth(ray.origin.y, ray.direction.y, first, density, MIST_SCALE));
    float drops = rainStreaks(theScreen, iTime, 2.0 * spread * focalLength);
    vec3 seen = mix(lake ? ofLake : light, now.sky, 0.35 * rainShare(theWeather) * drops);
    vec3 shown = filmOfLargest(exposed(nightSight(daylightFilm(seen)), now.stops), 1.3, 8.0);
    return encodeSRGB(shown) + ditherStep(iPixel) / 255.0;
}
