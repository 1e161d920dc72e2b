// 22 Many parts: a reef of thousands of parts that blend where they meet.

#include "main.glsl"     // main(): calls pixelRay, then rayColour
#include "cone.glsl"     // perspectiveRay, pixelSpread
#include "reef.glsl"     // the scene: readGrid, reefDistance, marchReef, skinAt
#include "lighting.glsl" // lambert, encodeSRGB
#include "shadow.glsl"   // shadowRay, shadowReach
#include "sky.glsl"      // glow
#include "film.glsl"     // filmOfLargest, ditherStep

uniform bool  counted;      // false: show the number of parts that were evaluated, instead of the reef
uniform float clearness;    // 13 in [2, 40] step *1.25, scene units: how far light travels in the water until 1 / e of it is left
uniform float shafts;       // 1 in [0, 4] step 0.25: brightness of the shafts of light
uniform float lamp;         // 1 in [0, 4] step 0.25: brightness of the diver's lamp, which is at the eye
uniform float footprint;    // 0.05 in [0, 1] step 0.05, half pixels: how fast the threshold grows along the ray
uniform int   maxSteps;     // 320 in [1, 1024]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.0005 in [0.00001, 0.1] step *2, scene units: distance at the eye that counts as a hit

const float FAR = 40.0, SURFACE = 7.0;                     // range of vision in the water; height of the surface
const vec3  TO_SUN = vec3(-0.3612, 0.8729, -0.3281);       // direction to the sun, as refracted by the water
const vec3  SUN_COLOUR = vec3(2.3, 2.1, 1.6);            // linear RGB, at the depth of the reef
const vec3  DEEP = vec3(0.002, 0.030, 0.085), SHALLOW = vec3(0.02, 0.25, 0.42); // light from below and from above
const vec3  ABSORBED = vec3(1.6, 0.85, 0.7);               // absorption of red, green and blue, times 1 / clearness

Ray pixelRay(vec2 screen)
{
    readGrid();
    return perspectiveRay(screen);
}

float sceneDistance(vec3 p)
{
    return reefDistance(p);
}

// The camera stops in front of the reef and above the sand.
float cameraRoom(vec3 p)
{
    return min(sceneDistance(p), p.y) - 0.05;
}

// ---- Light through the waves ----

// How strongly the waves on the surface focus the light that reaches p, about 1 on average: each wave is a lens.
//   blur  width over which the light is averaged, scene units
float caustics(vec3 p, float blur)
{
    vec2 x = p.xz - TO_SUN.xz / TO_SUN.y * (p.y - SURFACE), slope = vec2(0.0);
    vec3 bend = vec3(0.0); // second derivatives: xx, zz, xz
    vec2 d = vec2(0.8, 0.6);
    for (int pass = 0; pass < 2; pass++) {
        float k = 1.7;
        slope = vec2(0.0);
        bend = vec3(0.0);
        for (int i = 0; i < 6; i++) {
            float phase = k * dot(d, x) + 1.3 * float(i) + sqrt(9.8 * k) * 0.35 * iTime;
            float strength = exp(-0.5 * k * k * blur * blur) / pow(k, 1.35);
            slope += k * strength * cos(phase) * d;
            bend -= k * k * strength * sin(phase) * vec3(d * d, d.x * d.y);
            d = vec2(-0.7374 * d.x - 0.6755 * d.y, 0.6755 * d.x - 0.7374 * d.y);
            k *= 1.37;
        }
        x += pass == 0 ? 0.16 * slope : vec2(0.0);
    }
    vec3 b = 0.16 * bend;
    return 1.0 / max(abs((1.0 + b.x) * (1.0 + b.y) - b.z * b.z), 0.22);
}

// The light that the water itself sends to the eye: brighter towards the sun.
vec3 waterLight(vec3 direction)
{
    float up = smoothstep(-0.35, 0.75, direction.y);
    return mix(DEEP, SHALLOW, up * up) + 0.10 * vec3(0.6, 1.0, 0.9) * glow(direction, TO_SUN, 0.75);
}

// The shafts: sunlight that the water scatters towards the eye along a ray.
vec3 shaftLight(Ray ray, float far)
{
    float sum = 0.0, length = min(far, 16.0), offset = 0.5 + 0.5 * ditherStep(iPixel);
    for (int i = 0; i < 12; i++) {
        float t = length * (float(i) + offset) / 12.0;
        vec3 p = ray.origin + t * ray.direction;
        sum += (caustics(p, 0.40) - 0.72) * exp(-1.2 * t / clearness) * step(p.y, SURFACE);
    }
    return shafts * length / 12.0 * max(sum, 0.0) * vec3(0.03, 0.09, 0.09) * (0.4 + glow(ray.direction, TO_SUN, 0.4));
}

// ---- Colours ----

// The colour that paint, a byte of the table, encodes. The upper four bits select one of 9 pigments, stone or fish. A
// coral becomes paler towards its tips, where the lower four bits are larger.
vec3 paintColour(int paint)
{
    const vec3 pigment[9] = vec3[9](vec3(0.80, 0.16, 0.38), vec3(0.70, 0.07, 0.05), vec3(0.86, 0.30, 0.05),
        vec3(0.82, 0.58, 0.09), vec3(0.28, 0.50, 0.12), vec3(0.08, 0.52, 0.52), vec3(0.14, 0.24, 0.62),
        vec3(0.40, 0.15, 0.56), vec3(0.85, 0.78, 0.60));
    int colour = paint >> 4;
    float tip = float(paint & 15) / 15.0;
    vec3 coral = mix(0.75 * pigment[min(colour, 8)], mix(pigment[min(colour, 8)], vec3(1.0, 0.95, 0.85), 0.4), tip * tip);
    vec3 stone = mix(vec3(0.15, 0.11, 0.12), vec3(0.27, 0.20, 0.17), tip);
    return colour == STONE ? stone : (colour == 15 ? mix(vec3(0.75, 0.62, 0.15), vec3(0.85, 0.42, 0.10), tip) : coral);
}

// The normal of the sand, tilted by ripples perpendicular to the current.
vec3 sandNormal(vec2 p, float width)
{
    float x = 7.0 * p.y + 1.6 * sin(0.9 * p.x + 0.4 * p.y) + 0.8 * sin(2.3 * p.x + 1.1 * p.y);
    float slope = 0.28 * cos(x) * exp(-40.0 * width * width) + 0.12 * cos(0.6 * p.x) * cos(0.5 * p.y);
    return normalize(vec3(0.25 * slope, 1.0, -slope));
}

// The colour of a stone, with grain and patches of algae on top.
vec3 mottled(vec3 p, vec3 colour, float up)
{
    vec3 q = 5.0 * p + 1.3 * sin(7.0 * p.yzx + 2.0);
    float spots = sin(q.x) * sin(q.y + 1.0) * sin(q.z), grain = sin(31.0 * q.x) * sin(29.0 * q.y) * sin(37.0 * q.z);
    vec3 algae = mix(vec3(0.28, 0.14, 0.19), vec3(0.20, 0.22, 0.08), smoothstep(-0.1, 0.2, spots));
    return mix(colour, algae, 0.75 * smoothstep(0.0, 0.8, up + 0.6 * spots)) * (1.0 + 0.1 * grain);
}

// An estimate of the share of the light from all directions that reaches p: nearby parts block some of it.
float openness(vec3 p, vec3 normal)
{
    float open = 1.0;
    for (int i = 1; i <= 2; i++) {
        float h = 0.09 * float(i * i);
        vec3 q = p + h * normal;
        Cell cell = cellAt(q);
        float d = cell.count > 0 ? listDistance(q, cell) : MARGIN + h;
        open -= 0.32 * clamp(1.0 - d / h, 0.0, 1.0);
    }
    return open;
}

// The light that a point of the reef or of the sand sends to the eye.
vec3 surfaceLight(Ray ray, float t, bool onSand, float seen, Skin skin, float open)
{
    vec3 p = ray.origin + t * ray.direction;
    vec3 direct = seen * lambert(skin.normal, TO_SUN) * SUN_COLOUR * (0.15 + 0.85 * caustics(p, 0.04));
    vec3 above = (0.6 + 0.4 * skin.normal.y) * vec3(0.20, 0.46, 0.55), below = (0.5 - 0.5 * skin.normal.y) * vec3(0.22, 0.20, 0.13);
    vec3 through = vec3(0.25) * skin.colour * pow(max(dot(ray.direction, TO_SUN), 0.0), 2.0);
    vec3 torch = lamp * max(-dot(skin.normal, ray.direction), 0.0) / (0.6 + 0.10 * t * t) * exp(-ABSORBED * t / clearness) * vec3(1.5, 1.3, 1.1);
    return skin.colour * (direct + open * (above + below) + torch) + (onSand ? vec3(0.0) : through);
}

// The number of parts that were evaluated, as a colour from night blue to straw, on a logarithmic scale up to 1024.
vec3 countColour(int count)
{
    const vec3 colours[5] = vec3[5](vec3(0.05, 0.04, 0.15), vec3(0.24, 0.16, 0.43), vec3(0.62, 0.27, 0.46),
                                    vec3(0.94, 0.55, 0.37), vec3(1.00, 0.95, 0.72));
    float x = min(0.4 * log2(1.0 + float(count)), 3.999);
    int i = int(x);
    return mix(colours[i], colours[i + 1], x - float(i));
}

vec3 rayColour(Ray ray)
{
    float ground = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : 2.0 * FAR, spread = pixelSpread();
    vec2 interval = reefInterval(ray);
    Hit hit = marchReef(ray, interval.x, min(interval.y, min(ground, FAR)), hitThreshold, footprint * spread, maxSteps);
    bool onSand = !hit.found && ground < FAR, met = hit.found || onSand;
    float t = hit.found ? hit.t : min(ground, FAR), radius = hitThreshold + spread * t;
    vec3 p = ray.origin + t * ray.direction;
    Skin skin = skinAt(p, hit.found);
    skin.normal = hit.found ? skin.normal : sandNormal(p.xz, 2.0 * spread * t / max(abs(ray.direction.y), 0.05));
    skin.colour = hit.found ? mix(skin.colour, mottled(p, skin.colour, skin.normal.y), skin.stone) : vec3(0.50, 0.43, 0.31);
    Ray there = shadowRay(p, skin.normal, TO_SUN, 2.0 * radius + 0.004);
    float reach = met ? shadowReach(skin.normal, TO_SUN, min(reefInterval(there).y, 8.0)) : 0.0;
    float seen = marchReef(there, 0.0, reach, hitThreshold, 0.0, maxSteps).found ? 0.0 : 1.0;
    vec3 light = met ? surfaceLight(ray, t, onSand, seen, skin, openness(p, skin.normal)) : vec3(0.0);
    light = mix(waterLight(ray.direction), light, met ? exp(-ABSORBED * t / clearness) : vec3(0.0)) + shaftLight(ray, t);
    vec3 shown = encodeSRGB(filmOfLargest(1.05 * light, 1.55, 5.0)) + ditherStep(iPixel) / 255.0;
    return counted ? countColour(asked) : shown;
}
