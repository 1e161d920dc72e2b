// 09 Sky and sunset: a city of towers that vary from cell to cell, under a sky that follows the sun.

#include "main.glsl"       // main(): asks for pixelRay, then for rayColour
#include "cone.glsl"       // perspectiveRay, marchCone, pixelSpread
#include "primitives.glsl" // sdSphere
#include "repetition.glsl" // cellOf, cellRandom
#include "lighting.glsl"   // lambert, encodeSRGB
#include "shadow.glsl"     // shadowRay; march comes with it
#include "bounds.glsl"     // boxInterval
#include "sky.glsl"        // sunDirection, airMass, transmittance, scatteredLight, glow, disc

uniform float timeOfDay;      // 17.8 in [0, 24] step 0.25, hours: solar time at the start; at 12 the sun is highest
uniform float hoursPerSecond; // 0.25 in [0, 4] step 0.05, hours per second: how fast the time of day runs
uniform bool  reportSky;      // false: the report's sky, mended, in place of scattered sunlight
uniform float haze;           // 0.05 in [0, 0.3] step 0.01: optical depth of the dust overhead
uniform float footprint;      // 1 in [0, 4] step 0.25, half pixels: how wide a ray is; 0 shows the speckle
uniform int   maxSteps;       // 160 in [1, 512]: steps before a ray is given up
uniform float hitThreshold;   // 0.002 in [0.00001, 0.1] step *2, scene units: distance that counts as a hit at the eye

// One scene unit is about 8 metres; x points north, y up, z east. The avenue looks west.
const float LATITUDE = 43.6;  // degrees: of Toulouse
const float DECLINATION = 2.0; // of the sun, degrees: at the end of March
const float PERIOD = 6.0;     // from the middle of a block to the next
const float GAP = 1.35;       // half a street: no tower comes nearer to its cell's wall
const float TALLEST = 9.3;    // no tower is higher
const float FAR = 80.0;       // a ray that has travelled so far sees the sky
const float SHADOW_FAR = 18.0; // how far a shadow ray looks
const vec3  BAY = vec3(0.36, 0.4, 0.36); // a window and its share of the wall; a floor is 0.4 high
const vec3  LAMPLIGHT = vec3(1.0, 0.55, 0.22);
const vec3  LAMP = vec3(0.26, 1.08, 0.0);

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float hour()
{
    return timeOfDay + hoursPerSecond * iTime;
}

// ---- The city: what a ray can hit ----

// The place in a block, and the block's own random number.
struct Block {
    vec3  local;  // from the middle of the block
    float random; // in [0, 1)
};

Block blockAt(vec3 p)
{
    vec2 cell = vec2(cellOf(p.x, PERIOD), cellOf(p.z, PERIOD));
    return Block(p - PERIOD * vec3(cell.x, 0.0, cell.y), cellRandom(ivec3(cell, 9)));
}

// A tower is a shaft on a base, whole numbers of windows wide and high: how far a point lies outside
// the faces of each.
vec3 outsideShaft(Block block)
{
    vec3 r = fract(block.random * vec3(1.0, 256.0, 65536.0));
    vec3 corner = vec3(2.5, 4.0, 2.5) + floor(vec3(2.0 * r.y, 19.0 * r.x * r.x, 2.0 * r.z));
    return vec3(abs(block.local.x), block.local.y - 0.08, abs(block.local.z)) - corner * BAY;
}

vec3 outsideBase(Block block)
{
    float floors = floor(1.0 + 4.0 * fract(block.random * 65536.0));
    return vec3(abs(block.local.x), block.local.y - 0.08, abs(block.local.z)) - vec3(4.5, floors, 4.5) * BAY;
}

// The two pavements of a street that runs west, folded into one.
vec3 pavement(vec3 local)
{
    return vec3(abs(local.x) - 2.1, local.yz);
}

float lampDistance(vec3 q)
{
    float post = length(vec3(q.x, max(q.y - 1.1, 0.0), q.z)) - 0.018;
    float arm = length(vec3(q.x - clamp(q.x, 0.0, LAMP.x), q.y - 1.1, q.z)) - 0.012;
    return min(min(post, arm), sdSphere(q - LAMP, 0.045));
}

// From the nearest point of a crown's axis.
vec3 treeAxis(vec3 q)
{
    return vec3(q.x, q.y - clamp(q.y, 0.5, 1.0), abs(q.z) - 1.5);
}

float treeDistance(vec3 q)
{
    vec3 c = treeAxis(q);
    float crown = 0.98 * (length(c) - 0.3 + 0.2 * (q.y - c.y)); // the taper's slope is 0.2
    return min(crown, max(length(c.xz) - 0.03, q.y - 0.6));
}

float sceneDistance(vec3 p)
{
    Block block = blockAt(p);
    vec3 q = pavement(block.local);
    vec3 shaft = outsideShaft(block), base = outsideBase(block);
    float tower = min(max(shaft.x, max(shaft.y, shaft.z)), max(base.x, max(base.y, base.z)));
    float wall = 0.5 * PERIOD - max(abs(block.local.x), abs(block.local.z));
    return min(min(tower, wall + GAP), min(lampDistance(q), treeDistance(q)));
}

// ---- The light: sun, moon and sky ----

vec3 airDepth()
{
    return RAYLEIGH + haze;
}

// 1 by day, 0 once the sun is 14 degrees below the horizon.
float daylight(vec3 sun)
{
    return smoothstep(-0.25, 0.06, sun.y);
}

vec3 skyColour(vec3 direction, vec3 sun)
{
    float view = airMass(direction.y), day = daylight(sun), c = dot(direction, sun);
    vec3 through = day * transmittance(airDepth(), airMass(sun.y));
    vec3 light = scatteredLight(airDepth(), view, airMass(sun.y));
    light *= vec3(1.4, 1.75, 3.1) * day * day * (0.6 + 0.4 * c * c);
    light += through * glow(direction, sun, 0.8);
    if (reportSky)
        light = vec3(0.5, 0.7, 1.0) * vec3(1.0, vec2(max(sun.y, 0.0)));
    return light + (1.0 - day) * mix(vec3(0.002, 0.004, 0.011), vec3(0.016, 0.014, 0.016), view / 38.0);
}

// The light of all the sky together, on matt surfaces.
vec3 skyLight(vec3 sun)
{
    float day = daylight(sun);
    vec3 light = scatteredLight(airDepth(), 4.0, airMass(sun.y));
    return vec3(0.45, 0.52, 0.72) * day * day * light + vec3(0.003, 0.004, 0.008);
}

vec3 sunLight(vec3 sun)
{
    vec3 moonlight = vec3(0.02, 0.03, 0.05) * smoothstep(0.0, 0.15, -sun.y);
    return 2.6 * transmittance(airDepth(), airMass(sun.y)) * smoothstep(0.0, 0.04, sun.y) + moonlight;
}

// ---- Materials, found once, at the hit ----

// What a ray has met, and how the pixel sees it.
struct Place {
    Block block;
    bool  ground, tower, lamp; // none of the three: a tree
    vec3  normal;
    float width;               // of the pixel there, scene units
    float facing;              // cosine of the angle between normal and ray, at least 0.03
};

// The normal comes from the shape: a face of a box, or away from the axis of a tree or a post.
Place placeAt(vec3 p, bool ground, float width, vec3 direction)
{
    Block block = blockAt(p);
    vec3 base = outsideBase(block), q = pavement(block.local);
    bool tower = max(abs(block.local.x), abs(block.local.z)) < 4.5 * BAY.x + 2.0 * (hitThreshold + width);
    bool lamp = abs(block.local.z) < 0.7;
    vec3 outside = base.y < 0.01 ? base : outsideShaft(block);
    vec3 face = step(max(outside.x, max(outside.y, outside.z)), outside);
    vec3 axis = lamp ? vec3(q.x, 0.0, q.z) : treeAxis(q);
    vec3 normal = normalize((tower ? face : axis) * sign(block.local));
    normal = ground ? vec3(0.0, 1.0, 0.0) : normal;
    return Place(block, ground, tower, lamp, normal, width, max(abs(dot(normal, direction)), 0.03));
}

// Light of any strength, brought below 1 as film does it: the more there is, the less more counts.
vec3 compressed(vec3 light)
{
    vec3 x = max(light, 0.0);
    return 1.0 - 1.0 / (1.0 + x + x * x);
}

// How much of a pixel lies inside an edge.
//   inside  how far inside the edge its middle lies, in the unit of width
float coverage(float inside, float width)
{
    return clamp(inside / (width + 0.001) + 0.5, 0.0, 1.0);
}

// How much of a pixel stripes of period 1 cover.
//   filled  the share of each period that they fill, around its middle
float stripes(float x, float filled, float width)
{
    return coverage(0.5 * filled - abs(fract(x) - 0.5), width);
}

// 0 where a pixel is smaller than a period, 1 where it is wider: there a pattern is its mean.
float blurred(float width)
{
    return smoothstep(0.4, 1.0, width);
}

// The share of windows in a pixel of a wall (x), and how brightly they are lit (y).
//   random  of the window
vec2 windowsAt(Place place, vec2 at, float random, vec3 sun)
{
    vec2 width = vec2(place.width / place.facing, place.width) / BAY.xy;
    float blur = blurred(max(width.x, width.y));
    bool shop = at.y < 1.0, there = place.tower && !place.ground && abs(place.normal.y) < 0.5;
    vec2 filled = shop ? vec2(0.86, 0.7) : vec2(0.6, 0.56);
    float pane = stripes(at.x, filled.x, width.x) * stripes(at.y, filled.y, width.y);
    float share = (shop ? 0.8 : 0.42) * (1.0 - smoothstep(-0.08, 0.2, sun.y)) * smoothstep(-0.85, -0.4, sun.y);
    float lit = random < share ? 0.25 + 0.75 * fract(64.0 * random) : 0.0;
    return vec2(there ? mix(pane, filled.x * filled.y, blur) : 0.0, mix(lit, 0.6 * share, blur));
}

// 1 on the roadway, 0 on the pavement.
float asphaltAt(Place place)
{
    vec2 road = 0.5 * PERIOD - abs(place.block.local.xz);
    return coverage(0.72 - min(road.x, road.y), place.width / place.facing);
}

vec3 groundColour(Place place)
{
    vec2 road = 0.5 * PERIOD - abs(place.block.local.xz);
    float dash = coverage(0.025 - road.x, place.width) * step(0.75, road.y);
    float width = place.width / place.facing / 0.75;
    dash *= mix(stripes(place.block.local.z / 0.75, 0.5, width), 0.5, blurred(width));
    return mix(vec3(0.27, 0.25, 0.23), vec3(0.06, 0.062, 0.07) + 0.5 * dash, asphaltAt(place));
}

vec3 colourAt(Place place, float pane, float random)
{
    vec3 wall = mix(vec3(0.46, 0.33, 0.24), vec3(0.36, 0.38, 0.42), fract(16.0 * place.block.random));
    vec3 tower = mix(wall, vec3(0.015, 0.02, 0.025), pane);
    float leaf = mix(0.45 + 1.1 * random, 1.0, min(32.0 * place.width, 1.0));
    vec3 other = place.lamp ? vec3(0.04) : vec3(0.045, 0.085, 0.025) * leaf;
    return place.ground ? groundColour(place) : place.tower ? tower : other;
}

// What a place sends to the eye.
//   sky  the sky behind it: a wall that one looks along mirrors nearly the same
vec3 placeLight(vec3 p, Place place, vec3 direction, float seen, vec3 sun, vec3 sky)
{
    vec3 around = skyLight(sun), direct = seen * sunLight(sun), normal = place.normal;
    vec3 toLight = sun.y > 0.0 ? sun : -sun, toLamp = LAMP - pavement(place.block.local);
    float dusk = 1.0 - smoothstep(-0.02, 0.12, sun.y);
    vec3 local = place.block.local;
    vec2 at = vec2(abs(normal.x) > 0.5 ? local.z : local.x, p.y) / BAY.xy + vec2(0.5, 0.0);
    float wall = 4096.0 * place.block.random + sign(normal.x + 2.0 * normal.z);
    float random = cellRandom(place.tower ? ivec3(floor(at), wall) : ivec3(floor(32.0 * p)));
    vec2 windows = windowsAt(place, at, random, sun);
    float catches = dusk * lambert(normal, normalize(toLamp)) / (0.1 + dot(toLamp, toLamp));
    vec3 received = direct * lambert(normal, toLight) + (around + 0.1 * sunLight(sun)) * (0.6 + 0.4 * normal.y);
    vec3 light = colourAt(place, windows.x, random) * (received + 0.08 * LAMPLIGHT * catches);
    float graze = 1.0 - place.facing;
    float fresnel = 0.04 + 0.96 * graze * graze * graze * graze;
    vec3 mirrored = abs(normal.x) > 0.5 ? sky : 0.7 * around;
    vec3 glint = 0.5 * asphaltAt(place) * direct * glow(reflect(direction, normal), toLight, 0.75);
    light += fresnel * (place.ground ? glint : windows.x * mirrored);
    light += 0.25 * LAMPLIGHT * windows.x * windows.y;
    bool bulb = place.lamp && dot(toLamp, toLamp) < 0.0036;
    return light + (bulb ? 1.3 * dusk * LAMPLIGHT : vec3(0.0));
}

// The picture under a sky: what the ray meets, or the sky itself, and the air between.
//   sun  where the sun stands, length 1
//   sky  the light of the sky behind
vec3 cityColour(Ray ray, vec3 sun, vec3 sky)
{
    float spread = footprint * pixelSpread();
    vec3 foot = vec3(ray.origin.x, 0.0, ray.origin.z);
    vec2 interval = boxInterval(ray, foot - vec3(FAR, 0.0, FAR), foot + vec3(FAR, TALLEST, FAR));
    Hit hit = marchCone(ray, interval.x, min(interval.y, FAR), hitThreshold, spread, maxSteps);
    float t = hit.found ? hit.t : interval.y;
    vec3 p = ray.origin + t * ray.direction;
    bool ground = !hit.found && p.y < 0.01, met = hit.found || ground;
    Place place = placeAt(p, ground, 2.0 * spread * t, ray.direction);
    if (met) { // the views and the probe show what was met, the ground too
        traceNormal(place.normal);
        traceMarch(trace.steps, t, END_HIT);
    }
    vec3 toLight = sun.y > 0.0 ? sun : -sun; // by night the moon, always full
    float far = met && dot(place.normal, toLight) > 0.02 ? min(SHADOW_FAR, (TALLEST - p.y) / toLight.y) : 0.0;
    Ray up = shadowRay(p, place.normal, toLight, 0.03 + place.width);
    float seen = march(up, 0.0, far, 0.01, 64).t < far ? 0.0 : 1.0; // met something, or grazes too long
    vec3 light = placeLight(p, place, ray.direction, seen, sun, sky);
    vec3 sunDisc = 14.0 * disc(ray.direction, sun, 0.014) * transmittance(airDepth(), airMass(sun.y));
    light = met ? mix(sky, light, exp(-0.0006 * t * t)) : sky + sunDisc;
    float eye = 0.95 / sqrt(skyLight(sun).y + 0.02);
    return encodeSRGB(compressed(eye * light));
}

vec3 rayColour(Ray ray)
{
    vec3 sun = sunDirection(hour(), LATITUDE, DECLINATION);
    vec3 upwards = vec3(ray.direction.x, max(ray.direction.y, 0.0), ray.direction.z);
    return cityColour(ray, sun, skyColour(upwards, sun));
}
