// 18 A sky from tables: a pine on an islet in a calm sea, under a sky computed in advance.

#include "main.glsl"      // main(): calls pixelRay, then rayColour
#include "cone.glsl"      // perspectiveRay, marchCone, pixelSpread
#include "bounds.glsl"    // boxInterval, intervalUnion
#include "fresnel.glsl"   // schlickShare
#include "lighting.glsl"  // lambert, encodeSRGB
#include "film.glsl"      // exposed, filmOfLargest, ditherStep
#include "sky_table.glsl" // sunDirection, tableSky, tableSun, tableSunlight, tableAmbient, meteredSky, daylightFilm

uniform sampler2D sunward; // "sky_sunward.png" sRGB clamp: the half of the sky that contains the sun
uniform sampler2D away;    // "sky_away.png" sRGB clamp: the other half of the sky
uniform sampler2D halo;    // "sun_halo.png" sRGB clamp: the sun and its halo
uniform sampler2D meter;   // "sky_meter.png" linear clamp: what an exposure meter reads

uniform float timeOfDay;      // 18.4 in [0, 24] step 0.05, hour of the day: solar time at the start
uniform float hoursPerSecond; // 0.1 in [0, 4] step 0.05, hours per second: speed of the time of day
uniform float sunRadius;      // 0.267 in [0.1, 5] step 0.1, degrees: the true radius is 0.267, the article's 2.9
uniform float exposure;       // 0 in [-8, 8] step 0.5, stops: added to the exposure that the meter gives
uniform float swell;          // 0.04 in [0, 0.2] step 0.01: slope of the waves
uniform int   maxSteps;       // 160 in [1, 512]: steps after which a ray is abandoned
uniform float hitThreshold;   // 0.01 in [0.00001, 0.2] step *2, metres: distance at the eye that counts as a hit

// x points north, y up, z east; at the start the camera looks west. One scene unit is one metre.
const float LATITUDE = 43.6;              // latitude of Toulouse, degrees
const float DECLINATION = 2.0;            // declination of the sun in late March, degrees
const vec3  PINE = vec3(29.0, 2.4, -47.0); // foot of the pine
const vec3  HILL = vec3(31.5, -12.8, -48.0); // the centre of the ball whose top is the largest rock

// Bounding boxes of the land and of the pine, including their mirror images.
const vec3 LAND_LOW = vec3(11.5, -4.2, -58.5), LAND_HIGH = vec3(47.0, 4.2, -38.0);
const vec3 PINE_LOW = vec3(21.0, -12.0, -52.0), PINE_HIGH = vec3(33.5, 12.0, -42.0);

// The light of airglow and stars, as a share of nightSky of chapter 09, which is made for a screen.
const float NIGHT = 1.1e-5;

// The displacement of the mirror image by the waves at this pixel: metres sideways per metre of depth.
vec2 bend = vec2(0.0);

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// ---- The sky ----

vec3 sunNow()
{
    return sunDirection(timeOfDay + hoursPerSecond * iTime, LATITUDE, DECLINATION);
}

// The sky without sun and moon: 2e-4 cd/m^2 overhead.
vec3 darkSky(vec3 direction, vec3 sun)
{
    return NIGHT * nightSky(direction, sun);
}

// The sky with the sun, plus the light of the night sky.
vec3 skyLight(vec3 direction, vec3 sun)
{
    vec3 day = tableSky(sunward, away, direction, sun) + tableSun(halo, direction, sun, radians(sunRadius));
    return day + darkSky(direction, sun);
}

// ---- The islet ----

// A triangle wave with period 1 and values from -1 to 1. Its slope is at most 4.
float zigzag(float x)
{
    return 4.0 * abs(fract(x) - 0.5) - 1.0;
}

// The pine: a leaning trunk that forks, and a crown of four flattened balls. The distance is a lower
// bound.
float pineDistance(vec3 p)
{
    vec3 q = p - PINE;
    q.x += (0.34 - 0.025 * q.y) * q.y;
    float trunk = max(length(q.xz) - 0.4 + 0.035 * q.y, max(q.y - 7.0, -2.0 - q.y));
    vec2 fork = vec2(abs(q.x + 0.1) - 0.95 * (q.y - 3.7), q.z);
    trunk = min(trunk, max(0.72 * length(fork) - 0.14, max(q.y - 6.6, 3.7 - q.y)));
    vec3 c = q - vec3(0.0, 6.2, 0.0), flat1 = c * vec3(1.0, 2.1, 1.0);
    float domes = length(flat1 - vec3(0.5, 3.1, 0.0)) - 2.3;
    domes = min(domes, length(flat1 - vec3(-1.7, 1.7, -0.8)) - 2.0);
    domes = min(domes, length(flat1 - vec3(-3.6, -0.4, 0.6)) - 1.9);
    domes = min(domes, length(flat1 - vec3(3.2, 0.6, -0.2)) - 2.2);
    float leaf = 0.14 * zigzag(1.13 * c.x + 0.4 * c.y + 0.9 * c.z) + 0.04 * zigzag(2.7 * c.x - 1.3 * c.y + 1.9 * c.z);
    return min(0.7 * trunk, 0.27 * (domes - leaf));
}

// Three rocks, each a ball. The two larger balls are cut by cones, so that their sides are steep at
// the water. The distance is a lower bound.
float landDistance(vec3 p)
{
    float land = max(length(p - HILL) - 16.0, length(p.xz - HILL.xz) - 8.6 + 0.9 * p.y);
    land = min(land, max(length(p - vec3(42.0, -5.0, -47.5)) - 6.5, length(p.xz - vec2(42.0, -47.5)) - 3.8 + 0.9 * p.y));
    land = min(land, length(p - vec3(14.6, -0.6, -44.0)) - 1.8);
    float rock = 0.4 * zigzag(0.13 * p.x + 0.17 * p.y + 0.05 * p.z) + 0.24 * zigzag(0.43 * p.x - 0.36 * p.y + 0.3 * p.z);
    return 0.42 * (land + rock);
}

// The islet is above the water, and its mirror image, displaced by the waves, is below the water.
// Water shows the world upside down, so a ray goes straight on into the mirror image.
float sceneDistance(vec3 p)
{
    float depth = max(-p.y, 0.0);
    vec3 q = vec3(p.x + bend.x * depth, abs(p.y), p.z + bend.y * depth);
    return min(landDistance(q), pineDistance(q));
}

// The camera stops in front of the islet and above the water.
float cameraRoom(vec3 p)
{
    return min(sceneDistance(p), p.y) - 0.3;
}

// ---- The water ----

// The slope of the water at a point: two trains of waves, each damped where a pixel of the given
// width cannot resolve it.
vec2 waveSlope(vec2 at, float width)
{
    const vec2 LONG = vec2(0.08, 0.22), SHORT = vec2(-0.41, 0.77);
    vec2 x = abs(fract(vec2(dot(LONG, at), dot(SHORT, at)) + iTime * vec2(0.6, 1.17)) - 0.5);
    vec2 size = swell * (1.0 - 8.0 * x * x * (3.0 - 4.0 * x)) / (1.0 + width * width * vec2(2.0, 30.0));
    return size.x * normalize(LONG) + size.y * normalize(SHORT);
}

// ---- Where a ray ends ----

struct Surface {
    vec3  p;        // a point of the islet or its mirror image, if met
    bool  met;      // the ray has met the islet or its mirror image
    bool  mirrored; // the ray has met the water
    vec3  leaves;   // the direction in which the ray leaves if it meets nothing
    float down;     // sine of the angle between ray and water
};

Surface surfaceAlong(Ray ray)
{
    vec3 d = ray.direction;
    bool sea = d.y < 0.0;
    float down = max(-d.y, 1e-4), toSea = sea ? ray.origin.y / down : 1e5;
    vec2 slope = sea ? waveSlope(ray.origin.xz + toSea * d.xz, 2.0 * pixelSpread() * toSea / down) : vec2(0.0);
    bend = 2.0 * slope;
    vec2 interval = intervalUnion(boxInterval(ray, LAND_LOW, LAND_HIGH), boxInterval(ray, PINE_LOW, PINE_HIGH));
    // sceneDistance is about 0.4 of the distance, and so is the threshold: outlines grow by half a pixel.
    Hit hit = marchCone(ray, interval.x, interval.y, hitThreshold, 0.4 * pixelSpread(), maxSteps);
    // Waves too small for a pixel raise the mirrored direction a little.
    vec3 leaves = sea ? normalize(vec3(d.x + bend.x * down, down + 0.02, d.z + bend.y * down)) : d;
    return Surface(ray.origin + hit.t * d, hit.found, sea && (!hit.found || hit.t > toSea), leaves, down);
}

// ---- Light ----

// The light of the sun and the sky that a matt point of the islet reflects. The whole crown has the
// normals of a single dome, and everything else has the normals of the largest rock.
vec3 isletLight(vec3 p, vec3 sun)
{
    p.y = abs(p.y);
    bool leaf = p.y > PINE.y + 5.1;
    vec3 normal = normalize(leaf ? (p - PINE - vec3(-1.4, 6.0, 0.0)) * vec3(1.0, 3.0, 1.0) : p - HILL);
    vec3 colour = leaf ? vec3(0.04, 0.06, 0.03) : vec3(0.11, 0.1, 0.075);
    return colour * ((0.6 + 0.4 * normal.y) * tableAmbient(sun) + lambert(normal, sun) * tableSunlight(sun));
}

// The light along a ray. The sky has been evaluated once, in the direction in which the ray leaves.
vec3 surfaceLight(Surface surface, vec3 sky, vec3 sun)
{
    vec3 light = surface.met ? isletLight(surface.p, sun) : sky;
    vec3 water = vec3(0.01, 0.03, 0.04) * tableAmbient(sun);
    float share = surface.mirrored ? schlickShare(min(surface.down + 0.04, 1.0), 0.02) : 1.0;
    return mix(water, light, share);
}

// The exposure for the sky in front of the camera, in stops.
float stopsNow(vec3 sun)
{
    float night = brightness(darkSky(vec3(0.0, 0.2, 0.0), sun)); // half-way up the part of the sky that the meter sees
    return adaptedStops(meteredSky(meter, iCameraForward, sun) + night) + exposure;
}

// Light as the screen shows it: exposed for the hour, with a film that keeps hues but bleaches very
// bright light.
vec3 developed(vec3 light, vec3 sun)
{
    vec3 e = exposed(daylightFilm(light), stopsNow(sun));
    vec3 film = filmOfLargest(e, 1.35, 6.0);
    film = mix(film, vec3(max(film.r, max(film.g, film.b))), e.g / (e.g + 8.0));
    return encodeSRGB(film) + ditherStep(iPixel) / 255.0;
}

vec3 rayColour(Ray ray)
{
    vec3 sun = sunNow();
    Surface surface = surfaceAlong(ray);
    return developed(surfaceLight(surface, skyLight(surface.leaves, sun), sun), sun);
}
