// 21 A landscape: a lake between mountains, at every hour and in every weather.

#include "main.glsl"      // main(): asks for pixelRay, then for rayColour
#include "cone.glsl"      // perspectiveRay, pixelSpread
#include "relaxed.glsl"   // marchRelaxed
#include "valley.glsl"    // the scene: landDistance, landAt, thingsAlong, unmirrored
#include "water.glsl"     // fourWaves, glitter
#include "fresnel.glsl"   // schlickShare
#include "lighting.glsl"  // lambert, encodeSRGB
#include "shadow.glsl"    // shadowRay, shadowReach
#include "fog.glsl"       // fogDepth, skyFogDepth, fogLight, throughFog
#include "film.glsl"      // exposed, filmOfLargest
#include "sky_table.glsl" // tableSky, tableSun, tableSunlight, tableAmbient, hourStops
#include "night.glsl"     // skyTurn, starLight, airglow, the moon
#include "clouds.glsl"    // cloudPanorama, cloudLight, and the weather
#include "coarse.glsl"    // coarseStart

uniform sampler2D sunward;    // "sky_sunward.png" sRGB clamp: light of the sky on the sun's side
uniform sampler2D away;       // "sky_away.png" sRGB clamp: and opposite
uniform sampler2D halo;       // "sun_halo.png" sRGB clamp: the sun and its halo
uniform sampler2D fair;       // "clouds_fair.png" linear repeat: clouds of fair weather
uniform sampler2D storm;      // "clouds_storm.png" linear repeat: and of bad
uniform sampler2D moonMap;    // "moon.png" linear clamp: the moon's face
uniform sampler2D turf;       // "turf.png" sRGB repeat: grass
uniform sampler2D granite;    // "granite.png" sRGB repeat: rock

uniform float timeOfDay;      // 18.4 in [0, 24] step 0.25, hours: solar time at the start
uniform float hoursPerSecond; // 0.1 in [0, 4] step 0.05, hours per second: how fast the time of day runs
uniform float declination;    // 10 in [-23.44, 23.44] step 1, degrees: of the sun
uniform float weather;        // 1 in [0.5, 1] step 0.05: 1 fair, 0.5 bad
uniform float moonAge;        // 14.77 in [0, 29.53] step 1, days: since new moon; 14.77 is full
uniform float turned;        // 0.1 in [0, 1] step 0.01, days: since new moon; 14.77 is full
uniform float wind;           // 0.3 in [0, 1] step 0.05: how rough the water is
uniform float omega;          // 1.5 in [1, 1.95] step 0.05, distances: length of a step
uniform int   maxSteps;       // 160 in [1, 512]: steps before a ray is given up
uniform float hitThreshold;   // 0.0002 in [0.00001, 0.1] step *2, scene units: distance that counts as a hit at the eye

const float FAR = 160.0;
const float LATITUDE = 43.6;
const float MOON = 0.009;
const float TIDE = 0.2617994; // 2 pi / 24 s
const vec3  LAMPLIGHT = 0.012 * vec3(1.0, 0.55, 0.2);

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float sceneDistance(vec3 p)
{
    bool below = p.y < 0.0;
    float land = landDistance(unmirrored(p), below ? 2 : octavesAsked);
    return land - (below ? mirrorBlur * length(p - bend.place) : 0.0);
}

float coarseMargin(float t)
{
    return hitThreshold + pixelSpread() * t;
}

// ---- The hour ----

struct Hour {
    vec3  sun, moon, toLight; // directions; the last to what is brighter
    float turn;               // hours since the noon before
    vec3  beam, cloudBeam, around; // light of sun or moon on the ground, on clouds, and of the whole sky
    float stops;
};

Hour hourNow()
{
    float turn = mod(timeOfDay + hoursPerSecond * iTime + 12.0, 24.0);
    vec3 sun = sunDirection(turn + 12.0, LATITUDE, declination), moon = moonDirection(turn + 12.0, LATITUDE, declination, moonAge);
    vec3 sunBeam = tableSunlight(sun), moonBeam = moonlight(-dot(sun, moon)) * 0.1 * tableSunlight(moon);
    bool day = sun.y > -0.05 || sunBeam.g > moonBeam.g;
    vec3 toLight = day ? sun : moon, beam = day ? sunBeam : moonBeam;
    float high = cloudSunHeight(toLight.y, 3.0);
    vec3 cloudBeam = tableSunlight(vec3(0.0, high, 0.0)) * (day ? vec3(1.0) : 0.1 * moonlight(-dot(sun, moon)));
    vec3 around = tableAmbient(sun) + 0.15 * max(moon.y, 0.0) * moonBeam * vec3(0.8, 1.0, 1.3) + 6e-8 * vec3(0.8, 1.0, 1.2);
    float bright = exp2(skyBrightness(max(sun.y, -0.3))) + 6e-8 + 0.2 * max(moon.y, 0.0) * moonBeam.g;
    around = mix(around, overcastWhite(around + max(toLight.y, 0.0) * beam), overcastShare(weather));
    return Hour(sun, moon, toLight, turn, beam * sunLeft(weather), cloudBeam, around, -2.0 - 0.85 * log2(bright));
}

vec3 skyLight(vec3 direction, Hour now, bool mirrored)
{
    float width = 2.0 * pixelSpread();
    vec3 clear = tableSky(sunward, away, direction, now.sun) + airglow(direction.y);
    vec3 through = exp(-vec3(0.1, 0.148, 0.269) * airMass(direction.y));
    vec3 stars = skyTurn(now.turn + 12.0, LATITUDE) * direction;
    mat3 frame = moonFrame(now.moon, LATITUDE);
    vec2 onMoon = moonPlace(frame * direction, MOON);
    float disc_ = 1.0 - smoothstep(1.0 - width / MOON, 1.0 + width / MOON, length(onMoon));
    vec3 far = starLight(stars, min(width, 0.0031));
    far = mix(far, moonFace(moonMap, onMoon, width / MOON, frame * now.sun, 1.0), disc_);
    clear += sunLeft(weather) * (through * far + (mirrored ? vec3(0.0) : tableSun(halo, direction, now.sun, 0.0047)));
    vec3 sky = mix(clear, overcastSky(direction.y, now.around), overcastShare(weather));
    float drift = turned + now.turn / 24.0;
    Cloud low = cloudShare(cloudPanorama(fair, direction, drift, width), fairShare(weather));
    Cloud dark = cloudShare(cloudPanorama(storm, direction, drift, width), stormShare(weather));
    Cloud cloud = cloudOver(dark, low);
    return (1.0 - cloud.cover) * sky + cloudLight(cloud, direction, now.toLight, sunLeft(weather) * now.cloudBeam, now.around);
}

struct Place {
    vec3 p, normal, colour;
    float lamp; // share of it that is a lit window
    bool met;
};

// Grass, rock and snow by slope and height.
//   land   of landAt: chance in w
//   width  of the pixel there
vec3 landColour(vec3 p, vec3 direction, vec3 normal, float chance, float width)
{
    Footprint f = footprintOn(direction, normal, 0.577 * width);
    vec3 weights = twoPlaneWeights(planeWeights(normal, 4.0));
    vec3 stone = textureOnPlanes(granite, 0.35 * p, footprintSeen(f, mat3(1.0), 0.35), weights).rgb;
    vec3 meadow = textureFromAbove(turf, 9.0 * p, footprintSeen(f, mat3(1.0), 9.0)).rgb * mix(0.5, 1.6, chance);
    vec3 wood = mix(vec3(0.010, 0.022, 0.010), vec3(0.045, 0.055, 0.02), chance);
    vec3 rock = stone * mix(vec3(0.3, 0.28, 0.27), vec3(0.8, 0.74, 0.68), chance);
    float uneven = chance - 0.5, level = normal.y + 0.3 * uneven, height = p.y + 2.0 * uneven;
    vec3 green = mix(meadow, wood, smoothstep(0.25, 0.5, p.y + 0.3 * uneven));
    vec3 colour = mix(rock, green, smoothstep(0.55, 0.70, level) * smoothstep(3.9, 2.3, height));
    colour = mix(colour, vec3(0.85, 0.87, 0.9), smoothstep(0.48, 0.64, level) * smoothstep(3.6, 5.0, height));
    return mix(0.6 * stone * mix(0.5, 1.0, chance), colour, smoothstep(0.002, 0.014, p.y + 0.01 * uneven));
}

Place placeAt(vec3 p, vec3 direction, float width, bool met, bool thing)
{
    vec2 q = inValley(p.xz);
    vec4 land = landAt(q, clamp(log2(1.2 / (CELLS * width)) / log2(LACUNARITY), 1.0, 12.0));
    vec3 normal = normalize(vec3(-fromValley(land.yz), 1.0)).xzy, ofThing = thingNormal(p);
    vec4 paint = thingColour(p, ofThing);
    vec3 colour = landColour(p, direction, normal, land.w, width);
    return Place(p, thing ? ofThing : normal, thing ? paint.rgb : colour, thing ? paint.w : 0.0, met);
}

float lightSeen(Place place, Hour now, float radius)
{
    Ray up = shadowRay(place.p, place.normal, now.toLight, 3.0 * radius);
    way = vec2(abs(now.toLight.y), length(now.toLight.xz));
    float top = (14.0 - place.p.y) / max(now.toLight.y, 0.02);
    float far = place.met ? shadowReach(place.normal, now.toLight, min(60.0, top)) : 0.0;
    octavesAsked = 1;
    bend.waves = false;
    mirrorBlur = 0.0;
    Hit hit = marchRelaxed(up, 0.0, far, 0.5 * radius, 0.005, 1.5, 24);
    return hit.found || thingsAlong(up, FAR, min(far, 3.0), hitThreshold, 0.0) > 0.0 ? 0.0 : 1.0;
}

Water waterAt(vec3 p, vec3 direction, float width)
{
    Footprint f = footprintOn(direction, vec3(0.0, 1.0, 0.0), width);
    f.along *= max(0.0625 / abs(direction.y), 1.0);
    vec2 q = p.xz;
    float gust = smoothstep(0.35, 0.75, groundNoise(q * vec2(0.5, 0.5)).x);
    float strength = wind * (0.3 + 0.7 * gust);
    Water a = fourWaves(q, f, vec4(55.0, -80.0, 120.0, 170.0), vec4(30.0, 70.0, -40.0, 90.0), strength * vec4(0.03, 0.03, 0.025, 0.025), vec4(9.0, 12.0, 13.0, 17.0) * TIDE * iTime);
    Water b = fourWaves(q, f, vec4(-250.0, 310.0, 480.0, -700.0), vec4(120.0, -300.0, 350.0, 250.0), strength * vec4(0.03, 0.025, 0.02, 0.02), vec4(20.0, 25.0, 29.0, 33.0) * TIDE * iTime);
    return Water(a.slope + b.slope, a.variance + b.variance + 0.00003);
}

vec3 rayColour(Ray ray)
{
    Hour now = hourNow();
    float water = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : 2.0 * FAR;
    vec3 w = ray.origin + water * ray.direction;
    Water waves = waterAt(w, ray.direction, 2.0 * pixelSpread() * water);
    vec3 facet = normalize(vec3(-waves.slope.x, 1.0, -waves.slope.y)), mirrored = reflect(ray.direction, facet);
    mirrored = normalize(vec3(mirrored.x, max(mirrored.y, 0.002), mirrored.z));
    bend = Bend(true, vec3(w.x, 0.0, w.z), mirrored);
    mirrorBlur = 0.3 * sqrt(waves.variance);
    way = vec2(max(abs(ray.direction.y), mirrored.y), 1.0);
    Hit hit = marchRelaxed(ray, min(coarseStart(ray), water), FAR, hitThreshold, 2.5 * pixelSpread(), omega, maxSteps);
    hit.found = hit.t < FAR;
    float thing = thingsAlong(ray, water, hit.t, hitThreshold, pixelSpread());
    float t = thing > 0.0 ? thing : hit.t;
    bool met = thing > 0.0 || hit.found, lake = t > water;
    vec3 direction = lake ? mirrored : ray.direction;
    vec3 p = unmirrored(ray.origin + t * ray.direction);
    float spread = pixelSpread() + (lake ? 0.5 * sqrt(waves.variance) * (t - water) / t : 0.0);
    Place place = placeAt(p, direction, 2.0 * spread * t, met, thing > 0.0);
    float seen = lightSeen(place, now, coarseMargin(t));
    vec3 matt = place.colour * (seen * lambert(place.normal, now.toLight) * now.beam + (0.6 + 0.4 * place.normal.y) * now.around) + place.lamp * LAMPLIGHT;
    vec3 light = met ? matt : skyLight(direction, now, lake);
    // fog
    float density = 2.0 * 0.1 * hazeDensity(weather), scale = 3.0;
    vec3 fog = fogLight(direction, now.toLight, 0.5 * now.around, 0.25 * now.beam, 0.7);
    float first = min(t, water), last = t - first;
    float depth = met ? fogDepth(lake ? 0.0 : ray.origin.y, direction.y, lake ? last : t, density, scale) : skyFogDepth(0.14, direction.y, density, scale) * 0.0;
    light = throughFog(light, fog, depth);
    float share = schlickShare(clamp(-dot(ray.direction, facet), 0.0, 1.0), 0.02);
    vec3 deep = vec3(0.012, 0.035, 0.035) * (now.around + 0.3 * max(now.toLight.y, 0.0) * now.beam);
    vec3 ofLake = mix(deep, light + glitter(ray.direction, now.toLight, waves, now.beam), share);
    ofLake = throughFog(ofLake, fog, density * first);
    light = lake ? ofLake : light;
    return encodeSRGB(filmOfLargest(exposed(daylightFilm(light), now.stops), 1.3, 8.0));
}
