// 09 Sky and sunset: a city of towers that vary from cell to cell, under a sky that follows the sun.

#include "main.glsl"       // main(): asks for pixelRay, then for rayColour
#include "cone.glsl"       // perspectiveRay, marchCone, pixelSpread
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdSphere, boxDistance
#include "repetition.glsl" // cellOf, cellRandom
#include "lighting.glsl"   // lambert, encodeSRGB
#include "shadow.glsl"     // shadowRay, lightReaching
#include "bounds.glsl"     // boxInterval
#include "sky.glsl"        // sunDirection, airMass, transmittance, scatteredLight, glow, disc

uniform float timeOfDay;      // 17.75 in [0, 24] step 0.25, hours: solar time at the start; at 12 the sun is highest
uniform float hoursPerSecond; // 0.25 in [0, 4] step 0.05, hours per second: how fast the time of day runs
uniform bool  reportSky;      // false: the report's sky, mended, in place of scattered sunlight
uniform float haze;           // 0.04 in [0, 0.3] step 0.01: optical depth of the dust overhead
uniform float footprint;      // 1 in [0, 4] step 0.25, half pixels: how wide a ray is; 0 shows the speckle
uniform int   maxSteps;       // 160 in [1, 512]: steps before a ray is given up
uniform float hitThreshold;   // 0.002 in [0.00001, 0.1] step *2, scene units: distance that counts as a hit at the eye

// One scene unit is about 8 metres. x points north, y up, z east: the avenue looks west.
const float LATITUDE = 43.6;   // degrees: Toulouse
const float DECLINATION = 4.0; // of the sun, degrees: on the last day of March
const float PERIOD = 6.0;     // from the middle of a block to the next
const float GAP = 1.35;       // half a street: no tower comes nearer to its cell's wall
const float TALLEST = 9.3;    // no tower is higher
const float FAR = 100.0;      // a ray that has travelled so far sees the sky
const float SHADOW_FAR = 18.0;
const vec3  BAY = vec3(0.36, 0.4, 0.36); // a window with its share of the wall: width, height of a floor
const vec3  LAMP = vec3(0.26, 1.08, 0.0);

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float hour()
{
    return timeOfDay + hoursPerSecond * iTime;
}

// ---- The city ----

// The place in a block, and a number of its own for each block.
struct Block {
    vec3  local;  // from the middle of the block, on the ground
    float random; // in [0, 1)
};

Block blockAt(vec3 p)
{
    vec2 cell = vec2(cellOf(p.x, PERIOD), cellOf(p.z, PERIOD));
    return Block(p - PERIOD * vec3(cell.x, 0.0, cell.y), cellRandom(ivec3(cell, 9)));
}

// A tower is a shaft on a base, both whole numbers of windows wide and high: what lies outside of
// its east, upper and north faces.
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

// The pavement on both sides of the streets that run west, folded into one.
vec3 pavement(vec3 local)
{
    return vec3(abs(local.x) - 2.1, local.y, local.z);
}

float lampDistance(vec3 q)
{
    float post = max(length(q.xz) - 0.02, q.y - 1.1);
    float arm = boxDistance(abs(q - vec3(0.13, 1.1, 0.0)) - vec3(0.14, 0.01, 0.015));
    return min(min(post, arm), sdSphere(q - LAMP, 0.045));
}

// From the nearest point of the axis of a crown.
vec3 treeAxis(vec3 q)
{
    return vec3(q.x, q.y - clamp(q.y, 0.45, 1.0), abs(q.z) - 1.5);
}

float treeDistance(vec3 q)
{
    vec3 c = treeAxis(q);
    return min(length(c) - 0.2 + 0.12 * max(q.y - 0.45, 0.0), max(length(c.xz) - 0.03, q.y - 0.5));
}

float sceneDistance(vec3 p)
{
    Block block = blockAt(p);
    float wall = 0.5 * PERIOD - max(abs(block.local.x), abs(block.local.z));
    vec3 q = pavement(block.local);
    float street = min(lampDistance(q), treeDistance(q));
    float tower = min(boxDistance(outsideShaft(block)), boxDistance(outsideBase(block)));
    return min(min(tower, wall + GAP), street);
}

// ---- The sky ----

vec3 airDepth() { return RAYLEIGH + haze; }

float daylight(vec3 sun) { return smoothstep(-0.25, 0.06, sun.y); }

const vec3 SKY = vec3(1.5, 1.9, 2.6); 

vec3 skyColour(vec3 direction, vec3 sun)
{
    float view = airMass(direction.y), mass = airMass(sun.y), day = daylight(sun);
    float c = dot(direction, sun);
    vec3 through = day * transmittance(airDepth(), mass);
    vec3 light = SKY * day * day * scatteredLight(airDepth(), view, mass) * (0.65 + 0.35 * c * c);
    light += through * (0.7 * glow(direction, sun, 60.0) + 0.25 * glow(direction, sun, 6.0));
    if (reportSky)
        light = vec3(0.5, 0.7, 1.0) * vec3(1.0, vec2(max(sun.y, 0.0)));
    light += 14.0 * disc(direction, sun, 0.012) * through;
    return light + (1.0 - day) * mix(vec3(0.004, 0.008, 0.02), vec3(0.03, 0.028, 0.035), view / 38.0);
}

// The normal of what was hit, known from the shape: a box's face, an axis of a tree or a post.
vec3 cityNormal(Block block, bool tower, bool lamp)
{
    vec3 shaft = outsideShaft(block), base = outsideBase(block);
    vec3 q = pavement(block.local), side = sign(block.local);
    vec3 out3 = base.y < 0.01 ? base : shaft;
    vec3 face = step(max(out3.x, max(out3.y, out3.z)), out3);
    q = tower ? face : lamp ? vec3(q.x, 0.0, q.z) : treeAxis(q);
    return normalize(q * side);
}

// ---- Materials ----

// A pattern of stripes with period 1, seen through a window of a width: its mean where that is wide.
float stripes(float x, float filled, float width)
{
    float inside = 0.5 * filled - abs(fract(x) - 0.5);
    float sharp = clamp(inside / max(width, 0.001) + 0.5, 0.0, 1.0);
    return mix(sharp, filled, smoothstep(0.4, 1.0, width));
}

vec3 rayColour(Ray ray)
{
    vec3 sun = sunDirection(hour(), LATITUDE, DECLINATION);
    float day = daylight(sun), dusk = 1.0 - smoothstep(-0.02, 0.12, sun.y);
    float spread = footprint * pixelSpread();
    vec3 middle = vec3(ray.origin.x, 0.0, ray.origin.z);
    vec2 interval = boxInterval(ray, middle - vec3(FAR, 0.0, FAR), middle + vec3(FAR, TALLEST, FAR));
    Hit hit = marchCone(ray, interval.x, min(interval.y, FAR), hitThreshold, spread, maxSteps);
    vec3 sky = skyColour(vec3(ray.direction.x, max(ray.direction.y, 0.0), ray.direction.z), sun);
    vec3 around = 0.5 * day * day * SKY * scatteredLight(airDepth(), 4.0, airMass(sun.y));
    vec3 light = sky;
    float t = hit.found ? hit.t : interval.y;
    vec3 p = ray.origin + t * ray.direction;
    bool isGround = !hit.found && p.y < 0.01;
    if (hit.found || isGround) {
        float width = 2.0 * spread * t;
        Block block = blockAt(p);
        vec3 local = block.local, q = pavement(local);
        bool isTower = max(abs(local.x), abs(local.z)) < 4.5 * BAY.x + 2.0 * (hitThreshold + width);
        bool isLamp = abs(local.z) < 0.7;
        vec3 normal = isGround ? vec3(0.0, 1.0, 0.0) : cityNormal(block, isTower, isLamp);
        traceNormal(normal);
        float facing = max(abs(dot(normal, ray.direction)), 0.03);
        bool sideways = abs(normal.x) > abs(normal.z);
        // facade
        vec2 place = vec2(sideways ? local.z : local.x, p.y) / BAY.xy + vec2(0.5, 0.0);
        vec2 w = vec2(width / facing, width) / BAY.xy;
        bool shop = p.y < BAY.y;
        float pane = stripes(place.x, shop ? 0.86 : 0.6, w.x) * stripes(place.y, shop ? 0.7 : 0.56, w.y);
        pane = isTower && !isGround && abs(normal.y) < 0.5 ? pane : 0.0;
        ivec3 key = isTower ? ivec3(floor(place), 4096.0 * block.random + 7.0 * sign(normal.x) + 3.0 * sign(normal.z)) : ivec3(floor(p * 24.0));
        float random = cellRandom(key);
        float lateness = smoothstep(22.0, 24.0, mod(hour(), 24.0)) + 1.0 - smoothstep(4.0, 6.0, mod(hour(), 24.0));
        float share = (shop ? 0.9 : 0.5) * (1.0 - smoothstep(-0.05, 0.2, sun.y)) * (1.0 - 0.6 * lateness);
        float on = mix(random < share ? 0.4 + 0.6 * fract(64.0 * random) : 0.0, 0.7 * share, smoothstep(0.4, 1.0, max(w.x, w.y)));
        float b = fract(16.0 * block.random);
        vec3 wall = b < 0.4 ? vec3(0.46, 0.4, 0.34) : b < 0.75 ? vec3(0.32, 0.34, 0.38) : vec3(0.42, 0.24, 0.18);
        vec2 road = 0.5 * PERIOD - abs(local.xz);
        float wg = width / facing;
        float asphalt = clamp((0.72 - min(road.x, road.y)) / max(wg, 0.001) + 0.5, 0.0, 1.0);
        float dash = clamp((0.025 - road.x) / max(width, 0.001) + 0.5, 0.0, 1.0) * stripes(local.z / 0.75, 0.5, wg / 0.75);
        float paint = dash * step(0.75, road.y);
        vec3 ground = mix(vec3(0.26, 0.24, 0.22), vec3(0.06, 0.062, 0.07) + 0.5 * paint, asphalt);
        vec3 colour = isGround ? ground : isTower ? mix(wall, vec3(0.015, 0.02, 0.025), pane) : isLamp ? vec3(0.04) : vec3(0.05, 0.09, 0.03) * mix(0.5 + random, 1.0, min(24.0 * width, 1.0));
        // light
        vec3 toLight = sun.y > 0.0 ? sun : -sun;
        vec3 sunLight = 1.4 * transmittance(airDepth(), airMass(sun.y)) * smoothstep(0.0, 0.04, sun.y)
                      + vec3(0.018, 0.026, 0.045) * smoothstep(0.0, 0.15, -sun.y);
        float far = min(SHADOW_FAR, (TALLEST - p.y) / max(toLight.y, 0.001));
        float seen = lightReaching(shadowRay(p, normal, toLight, 0.03 + width), dot(normal, toLight) > 0.0 ? far : 0.0, 0.01, 24);
        vec3 ambient = around + vec3(0.004, 0.006, 0.011);
        vec3 received = seen * sunLight * lambert(normal, toLight) + ambient * (0.6 + 0.4 * normal.y);
        vec3 toLamp = LAMP - q;
        received += dusk * vec3(1.0, 0.62, 0.3) * 0.2 * lambert(normal, normalize(toLamp)) / (0.1 + dot(toLamp, toLamp));
        light = colour * received;
        // mirror
        float graze = 1.0 - facing;
        float fresnel = 0.04 + 0.96 * graze * graze * graze * graze;
        float gloss = isGround ? 0.4 * asphalt : pane;
        vec3 mirrored = sideways ? sky : 0.7 * around;
        light += gloss * fresnel * (isGround ? seen * sunLight * glow(reflect(ray.direction, normal), toLight, 30.0) : mirrored);
        light += pane * on * vec3(1.0, 0.62, 0.3) * 0.4;
        light += isLamp && distance(q, LAMP) < 0.06 ? dusk * vec3(3.0, 2.1, 1.1) : vec3(0.0);
        light = mix(light, sky, 1.0 - exp(-0.0006 * t * t));
    }
    float eye = 1.0 / sqrt(around.y + 0.02);
    return encodeSRGB(1.0 - exp(-eye * light));
}
