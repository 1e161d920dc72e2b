// 09 Sky and sunset: a city of towers that differ from block to block, under a sky that follows
// the sun.

#include "main.glsl"       // main(): calls pixelRay, then rayColour
#include "cone.glsl"       // perspectiveRay, marchCone, pixelSpread
#include "repetition.glsl" // cellRandom
#include "city.glsl"       // cityDistance, cityNormal, blockAt, pavement
#include "lighting.glsl"   // lambert, encodeSRGB
#include "shadow.glsl"     // shadowRay; march of march.glsl
#include "bounds.glsl"     // boxInterval
#include "coverage.glsl"   // coverage, stripes, blurred
#include "sky.glsl"        // direction and light of the sun, sunlitSky, nightSky, skyAmbient, glow, disc

uniform float timeOfDay;      // 17.8 in [0, 24] step 0.25, hour of the day: solar time at the start; the sun is highest at 12
uniform float hoursPerSecond; // 0.25 in [0, 4] step 0.05, hours per second: speed of the time of day
uniform bool  reportSky;      // false: the report's sky, repaired, instead of scattered sunlight
uniform float haze;           // 0.05 in [0, 0.3] step 0.01: optical depth of the dust overhead
uniform float footprint;      // 1 in [0, 4] step 0.25, half pixels: radius of a ray; 0 shows the speckle
uniform int   maxSteps;       // 256 in [1, 512]: steps after which a ray is abandoned
uniform float hitThreshold;   // 0.002 in [0.00001, 0.1] step *2, scene units: distance that counts as a hit, at the eye

// x points north, y up, z east. At the start the camera looks west along the avenue. One scene unit
// is about 8 metres.
const float LATITUDE = 43.6;   // latitude of Toulouse, degrees
const float DECLINATION = 2.0; // declination of the sun in late March, degrees
const float FAR = 80.0;        // a ray that has travelled this far shows the sky
const float SHADOW_FAR = 18.0; // greatest length of a shadow ray
const vec3  LAMPLIGHT = vec3(1.0, 0.55, 0.22);

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float sceneDistance(vec3 p)
{
    return cityDistance(p);
}

// The camera stops above the ground and in front of the city.
float cameraRoom(vec3 p)
{
    return min(cityDistance(p), p.y) - 0.06;
}

// ---- The sun and the sky ----

float hour()
{
    return timeOfDay + hoursPerSecond * iTime;
}

// The optical depth of the air and the dust overhead.
vec3 airDepth()
{
    return RAYLEIGH + haze;
}

// Sunlight that the air scatters, or the report's colour for it, plus the light of the night sky.
vec3 skyLight(vec3 direction, vec3 sun)
{
    vec3 shaded = 0.6 * skyAmbient(sun, airDepth()); // where the Earth shades the air, only other air lights it
    vec3 day = mix(sunlitSky(direction, sun, airDepth()), shaded, earthShadow(direction, sun));
    if (reportSky)
        day = vec3(0.5, 0.7, 1.0) * vec3(1.0, vec2(max(sun.y, 0.0)));
    return day + nightSky(direction, sun);
}

// The direction to the strongest light: the sun or, at night, the moon, which is opposite the sun.
vec3 lightDirection(vec3 sun)
{
    return sun.y > 0.0 ? sun : -sun;
}

// ---- Where a ray ends ----

// The point where a ray ends, the surface there, and the width of the pixel at that point.
struct Surface {
    vec3  p;
    float t;                   // distance to p along the ray
    bool  met;                 // false if the ray shows the sky
    bool  ground, tower, lamp; // if met and none of the three, p is on a tree
    Block block;
    vec3  normal;
    float width;               // width of the pixel at p, scene units
    float facing;              // cosine of the angle between the normal and the direction to the eye, at least 0.03
};

// The march finds towers, lamps and trees. The ground is the lower face of the box that limits the
// march. A surface counts as reached within half the radius of the ray, so that outlines grow by only
// a quarter of a pixel.
Surface surfaceAlong(Ray ray)
{
    float spread = footprint * pixelSpread();
    vec3 foot = vec3(ray.origin.x, 0.0, ray.origin.z);
    vec2 interval = boxInterval(ray, foot - vec3(FAR, 0.0, FAR), foot + vec3(FAR, TALLEST, FAR));
    Hit hit = marchCone(ray, interval.x, min(interval.y, FAR), hitThreshold, 0.5 * spread, maxSteps);
    float t = hit.found ? hit.t : interval.y, width = 2.0 * spread * t;
    vec3 p = ray.origin + t * ray.direction;
    bool ground = !hit.found && p.y < 0.01, met = hit.found || ground;

    Block block = blockAt(p);
    vec3 aside = abs(block.local);
    bool tower = max(aside.x, aside.z) < 4.5 * BAY.x + 2.0 * (hitThreshold + width), lamp = aside.z < 0.7;
    vec3 normal = ground ? vec3(0.0, 1.0, 0.0) : cityNormal(block, tower, lamp);
    float facing = max(abs(dot(normal, ray.direction)), 0.03);
    if (met) { // report the hit, even on the ground, to the views and the probe
        traceNormal(normal);
        traceMarch(trace.steps, t, END_HIT);
    }
    return Surface(p, t, met, ground, tower, lamp, block, normal, width, facing);
}

// ---- The material, found once, at the hit ----

// The width and the height of the glass of a shop and of a window above it, as shares of BAY; then
// the shares of the shops and of the windows that are lit in the evening.
const vec2  SHOP = vec2(0.86, 0.7);
const vec2  WINDOW = vec2(0.6, 0.56);
const float SHOPS_LIT = 0.8;
const float WINDOWS_LIT = 0.42;

struct Material {
    vec3  colour; // the share of each colour that is reflected in all directions
    float pane;   // the share of the pixel that is a window, which reflects
    float gloss;  // the share of the pixel that is asphalt, which glints
    vec3  glow;   // light that the surface emits
};

// How brightly the street lamps are lit, from 0 to 1. They are on from shortly before sunset until
// shortly after sunrise.
float lampsOn(vec3 sun)
{
    return 1.0 - smoothstep(-0.02, 0.12, sun.y);
}

// The share of people whose lights are on: they switch the lights on at dusk, and off when they go to
// sleep, when the sun is far below the horizon.
float windowsOn(vec3 sun)
{
    return (1.0 - smoothstep(-0.08, 0.2, sun.y)) * smoothstep(-0.85, -0.4, sun.y);
}

// The vector from the bulb of the nearest lamp to the point, in the folded coordinates of pavement.
vec3 fromBulb(Surface surface)
{
    return pavement(surface.block.local) - LAMP;
}

// The share of windows in a pixel of a wall (x), and how brightly they are lit (y).
//   at      the position on the wall, in units of BAY: x counts windows, y floors
//   random  the window's random number
vec2 windowsAt(Surface surface, vec2 at, float random, vec3 sun)
{
    vec2 width = vec2(surface.width / surface.facing, surface.width) / BAY.xy;
    float blur = blurred(max(width.x, width.y));
    bool shop = at.y < 1.0, there = surface.tower && !surface.ground && abs(surface.normal.y) < 0.5;
    vec2 glass = shop ? SHOP : WINDOW;
    float pane = stripes(at.x, glass.x, width.x) * stripes(at.y, glass.y, width.y);
    float share = (shop ? SHOPS_LIT : WINDOWS_LIT) * windowsOn(sun);
    float lit = random < share ? 0.25 + 0.75 * fract(64.0 * random) : 0.0;
    return vec2(there ? mix(pane, glass.x * glass.y, blur) : 0.0, mix(lit, 0.6 * share, blur));
}

// The ground: a roadway with a dashed centre line, between pavements.
//   asphalt  the share of the pixel that is roadway
vec3 groundColour(Surface surface, float asphalt)
{
    vec2 road = 0.5 * PERIOD - abs(surface.block.local.xz);
    float dash = coverage(0.025 - road.x, surface.width) * step(0.75, road.y);
    float width = surface.width / surface.facing / 0.75;
    dash *= mix(stripes(surface.block.local.z / 0.75, 0.5, width), 0.5, blurred(width));
    return mix(vec3(0.27, 0.25, 0.23), vec3(0.06, 0.062, 0.07) + 0.5 * dash, asphalt);
}

// The brightness of the uppermost leaf at a point of a crown. Four layers cover each other; each is a grid of cells,
// turned from the one below it, with one leaf in each cell: an ellipsoid, paler towards its tip. A dark gap shows
// where no layer has a leaf.
float leafAt(vec3 p)
{
    float shade = 0.3;
    vec3 q = 22.0 * p;
    for (int layer = 0; layer < 4; layer++) {
        q = vec3(0.8 * q.y - 0.6 * q.z, 0.6 * q.y + 0.8 * q.z, q.x) + 0.37;
        vec3 inside = fract(q) - 0.5;
        float random = cellRandom(ivec3(floor(q)));
        bool leaf = length(inside * vec3(1.0, 2.2, 1.0)) < 0.5;
        shade = leaf ? 0.5 + 0.9 * random + inside.x : shade;
    }
    return shade;
}

// The random number differs for each window on each side of each tower.
Material materialAt(Surface surface, vec3 sun)
{
    vec3 local = surface.block.local, normal = surface.normal;
    vec2 at = vec2(abs(normal.x) > 0.5 ? local.z : local.x, surface.p.y) / BAY.xy + vec2(0.5, 0.0);
    float side = 4096.0 * surface.block.random + sign(normal.x + 2.0 * normal.z);
    float random = cellRandom(ivec3(floor(at), side));
    vec2 windows = windowsAt(surface, at, random, sun);
    vec2 road = 0.5 * PERIOD - abs(local.xz);
    float asphalt = coverage(0.72 - min(road.x, road.y), surface.width / surface.facing);

    vec3 wall = mix(vec3(0.46, 0.33, 0.24), vec3(0.36, 0.38, 0.42), fract(16.0 * surface.block.random));
    vec3 tower = mix(wall, vec3(0.015, 0.02, 0.025), windows.x);
    float leaf = mix(leafAt(surface.p), 1.0, min(32.0 * surface.width, 1.0));
    vec3 tree = surface.p.y < 0.3 ? vec3(0.07, 0.05, 0.035) : vec3(0.045, 0.085, 0.025) * leaf; // trunk or crown
    vec3 other = surface.lamp ? vec3(0.04) : tree;
    vec3 colour = surface.ground ? groundColour(surface, asphalt) : surface.tower ? tower : other;
    bool bulb = surface.lamp && length(fromBulb(surface)) < 0.06;
    float glow = 0.25 * windows.x * windows.y + (bulb ? 1.3 * lampsOn(sun) : 0.0);
    return Material(colour, windows.x, surface.ground ? asphalt : 0.0, glow * LAMPLIGHT);
}

// ---- The light that arrives, and the light that goes to the camera ----

// 1 if the sun or the moon is visible, otherwise 0. A ray that runs out of steps counts as blocked.
// Walls that the light grazes, at a cosine below 0.02, are not tested: they receive hardly any
// light and would cost the most.
float lightSeen(Surface surface, vec3 toLight)
{
    bool faces = surface.met && dot(surface.normal, toLight) > 0.02;
    float far = faces ? min(SHADOW_FAR, (TALLEST - surface.p.y) / toLight.y) : 0.0;
    Ray ray = shadowRay(surface.p, surface.normal, toLight, 0.03 + surface.width);
    return march(ray, 0.0, far, 0.01, 64).t < far ? 0.0 : 1.0;
}

// The light that a matt surface receives: the beam of the sun or the moon, the light of the whole
// sky, a little of the beam that the streets scatter, and the light of the nearest lamp, which shines mostly downwards.
//   direct  the part of the beam that arrives: all of it, or black in the shade
vec3 receivedLight(Surface surface, vec3 sun, vec3 beam, vec3 direct)
{
    vec3 around = skyAmbient(sun, airDepth()) + 0.1 * beam, toBulb = -fromBulb(surface);
    float square = dot(toBulb, toBulb), down = max(toBulb.y, 0.0);
    float catches = lampsOn(sun) * lambert(surface.normal, normalize(toBulb)) / (0.1 + square);
    catches *= 0.05 + 0.95 * down * down / square;
    vec3 open = direct * lambert(surface.normal, lightDirection(sun)) + (0.6 + 0.4 * surface.normal.y) * around;
    return open + 0.9 * catches * LAMPLIGHT;
}

// The sky reflected in panes, and the sun or moon reflected in asphalt. Both reflections are stronger
// at smaller grazing angles.
// The fourth power instead of Schlick's fifth was chosen by eye, for panes that are not quite flat.
//   sky  light of the sky behind the point; at a small grazing angle, a wall reflects nearly the same
//        part of the sky
vec3 mirroredLight(Surface surface, Material material, vec3 direction, vec3 sun, vec3 direct, vec3 sky)
{
    float grazing = 1.0 - surface.facing, square = grazing * grazing;
    vec3 panes = material.pane * (abs(surface.normal.x) > 0.5 ? sky : 0.7 * skyAmbient(sun, airDepth()));
    vec3 glint = 0.5 * glow(reflect(direction, surface.normal), lightDirection(sun), 0.75) * direct;
    return (0.04 + 0.96 * square * square) * (panes + material.gloss * glint);
}

// The light that a point sends to the camera: scattered, reflected and emitted.
vec3 surfaceLight(Surface surface, vec3 direction, vec3 sun, vec3 sky)
{
    Material material = materialAt(surface, sun);
    vec3 beam = sunOrMoonLight(sun, airDepth()), direct = lightSeen(surface, lightDirection(sun)) * beam;
    vec3 mirrored = mirroredLight(surface, material, direction, sun, direct, sky);
    return material.colour * receivedLight(surface, sun, beam, direct) + mirrored + material.glow;
}

// ---- The picture ----

// Light as the screen shows it. The exposure adapts to the sky, as an eye does. Then light of any
// strength is compressed to below 1, as on film: the brighter the light, the less an increase
// changes the result.
vec3 exposed(vec3 light, vec3 sun)
{
    float exposure = 0.95 / sqrt(skyAmbient(sun, airDepth()).y + 0.02);
    vec3 x = max(exposure * light, 0.0);
    return encodeSRGB(1.0 - 1.0 / (1.0 + x + x * x));
}

// The city under a sky: the surface that the ray meets, or the sky itself, and the air in between.
//   sun  direction of the sun, length 1
//   sky  light of the sky in the direction of the ray
vec3 cityColour(Ray ray, vec3 sun, vec3 sky)
{
    Surface surface = surfaceAlong(ray);
    vec3 city = mix(sky, surfaceLight(surface, ray.direction, sun, sky), exp(-0.0006 * surface.t * surface.t));
    vec3 sunDisc = 14.0 * disc(ray.direction, sun, 0.014) * transmittance(airDepth(), airMass(sun.y));
    sunDisc *= step(0.0, ray.direction.y); // beyond the farthest towers, the ground hides what is below the horizon
    return exposed(surface.met ? city : sky + sunDisc, sun);
}

vec3 rayColour(Ray ray)
{
    vec3 sun = sunDirection(hour(), LATITUDE, DECLINATION);
    vec3 upwards = vec3(ray.direction.x, max(ray.direction.y, 0.0), ray.direction.z);
    return cityColour(ray, sun, skyLight(upwards, sun));
}
