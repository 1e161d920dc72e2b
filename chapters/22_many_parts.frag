// 22 Many parts: a reef of thousands of parts that blend where they meet.

#include "main.glsl"        // main(): calls pixelRay, then rayColour
#include "cone.glsl"        // perspectiveRay, pixelSpread
#include "reef.glsl"        // the scene: readGrid, reefDistance, marchReef, skinAt
#include "coarse.glsl"      // coarseStart
#include "lighting.glsl"    // lambert, encodeSRGB
#include "soft_shadow.glsl" // shadowRay, shadowReach, discBesideEdge
#include "sky.glsl"         // glow
#include "noise.glsl"       // valueNoise, octaveNoise
#include "texture.glsl"     // bumpedNormal
#include "film.glsl"        // filmOfLargest, ditherStep

uniform bool  counted;      // false: show the number of parts that were evaluated, instead of the reef
uniform float clearness;    // 13 in [2, 40] step *1.25, scene units: how far light travels in the water until 1 / e of it is left
uniform float shafts;       // 1 in [0, 4] step 0.25: brightness of the shafts of light
uniform float lamp;         // 1 in [0, 4] step 0.25: brightness of the diver's lamp, which is at the eye
uniform float footprint;    // 0.25 in [0, 1] step 0.05, half pixels: how fast the threshold grows along the ray
uniform int   maxSteps;     // 320 in [1, 1024]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.0005 in [0.00001, 0.1] step *2, scene units: distance at the eye that counts as a hit

const float FAR = 40.0, SURFACE = 7.0;                     // range of vision in the water; height of the surface
const vec3  TO_SUN = vec3(-0.3612, 0.8729, -0.3281);       // direction to the sun, as refracted by the water
const float SUN_WIDTH = 0.03;                              // tangent of the sun's angular radius, which waves blur
const vec3  SUN_COLOUR = vec3(2.3, 2.1, 1.6);              // linear RGB, at the depth of the reef
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

float coarseMargin(float t)
{
    return hitThreshold + footprint * pixelSpread() * t;
}

// The camera stops in front of the reef and above the sand.
float cameraRoom(vec3 p)
{
    return min(sceneDistance(p), p.y) - 0.05;
}

// ---- Light through the waves ----

// How strongly the waves on the surface focus the light that reaches p, about 1 on average: each wave is a lens. There
// are four waves; their numbers are the components of vectors.
//   blur  width over which the light is averaged, scene units
float caustics(vec3 p, float blur)
{
    const vec4 K = vec4(1.7, 2.872, 4.853, 8.2); // 2 pi / wavelength
    const vec4 X = vec4(0.8, -0.9952, 0.6677, 0.01055), Z = vec4(0.6, 0.09796, -0.7445, 1.0); // where the waves run
    const vec4 START = vec4(0.0, 1.3, 2.6, 3.9), SPEED = vec4(1.429, 1.857, 2.414, 3.138); // sqrt(9.8 K), slowed down
    vec2 x = p.xz - TO_SUN.xz / TO_SUN.y * (p.y - SURFACE);
    vec4 high = 1.2 * exp(-0.5 * blur * blur * K * K - 0.35 * log(K)), phase = START + SPEED * iTime;
    // The light that arrives at x has crossed the surface elsewhere.
    vec4 slope = high * cos(phase + K * (X * x.x + Z * x.y));
    x += 0.16 * vec2(dot(slope, X), dot(slope, Z));
    vec4 bend = 0.16 * K * high * sin(phase + K * (X * x.x + Z * x.y));
    float xx = 1.0 - dot(bend, X * X), zz = 1.0 - dot(bend, Z * Z), xz = dot(bend, X * Z);
    return 1.0 / max(abs(xx * zz - xz * xz), 0.22);
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
    for (int i = 0; i < 8; i++) {
        float t = length * (float(i) + offset) / 8.0;
        vec3 p = ray.origin + t * ray.direction;
        sum += (caustics(p, 0.40) - 0.72) * exp(-1.2 * t / clearness) * step(p.y, SURFACE);
    }
    return shafts * length / 8.0 * max(sum, 0.0) * vec3(0.03, 0.09, 0.09) * (0.4 + glow(ray.direction, TO_SUN, 0.4));
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

// The colour of a stone, with grain and patches of algae, and its normal, which the grain makes rough.
void roughen(vec3 p, float width, inout vec3 colour, inout vec3 normal)
{
    const mat3 TURN = mat3(0.36, 0.48, -0.8, -0.8, 0.6, 0.0, 0.48, 0.64, 0.6); // no cell of the noise is level
    vec4 grain = octaveNoise(5.0 * TURN * p, 3, 0.45, 2.3);
    float patches = valueNoise(1.7 * p).x + 0.5 * (grain.x - 0.5), near = exp(-30.0 * width);
    vec3 green = vec3(0.17, 0.19, 0.07), pink = vec3(0.30, 0.13, 0.19);
    float covered = smoothstep(0.08, 0.3, abs(patches - 0.5)) * smoothstep(-0.4, 0.4, normal.y);
    colour = mix(colour, patches > 0.5 ? green : pink, 0.8 * covered);
    colour *= 0.6 + 0.8 * grain.x;
    normal = bumpedNormal(normal, 0.25 * near * grain.yzw * TURN);
}

// An estimate of the share of the light from all directions that reaches p: nearby parts block some of it. Only parts
// within HIGH of the point q can, so the list of its cell is enough.
float openness(vec3 p, vec3 normal)
{
    const float HIGH = 1.45 * MARGIN;
    vec3 q = p + HIGH * normal;
    float d = listDistance(q, cellAt(q));
    return 1.0 - 0.7 * clamp(1.0 - d / HIGH, 0.0, 1.0);
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

// The visible share of the sun: from the least distance to the reef along a ray, in widths of the cone of light around
// the ray. If the cone were wider than MARGIN, parts that a list leaves out could block some of it.
float sunSeen(Ray ray, float far)
{
    float t = 0.0, clear = 1.0;
    int steps = 0;
    traceBegin(0.0, far);
    while (t < far && clear > -1.0 && steps < 48) {
        float distance = distanceAt(ray.origin + t * ray.direction);
        traceStep(steps, t, distance);
        steps++;
        float wide = min(0.004 + SUN_WIDTH * t, MARGIN);
        clear = min(clear, (here.count > 0 ? listValue : MARGIN) / wide);
        t += max(roomAlong(ray.origin + t * ray.direction, ray.direction, distance), 0.01 + 0.02 * t);
    }
    traceMarch(steps, t, clear > -1.0 ? END_PASSED : END_HIT);
    return discBesideEdge(clear);
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
    Hit hit = marchReef(ray, max(interval.x, coarseStart(ray)), min(interval.y, min(ground, FAR)), hitThreshold,
                        footprint * spread, maxSteps);
    bool onSand = !hit.found && ground < FAR, met = hit.found || onSand;
    float t = hit.found ? hit.t : min(ground, FAR), radius = hitThreshold + spread * t;
    vec3 p = ray.origin + t * ray.direction;
    Skin skin = skinAt(p, hit.found);
    skin.normal = hit.found ? skin.normal : sandNormal(p.xz, 2.0 * spread * t / max(abs(ray.direction.y), 0.05));
    vec3 stone = skin.colour, rough = skin.normal;
    roughen(p, 2.0 * spread * t, stone, rough);
    skin.colour = hit.found ? mix(skin.colour, stone, skin.stone) : vec3(0.42, 0.36, 0.26);
    skin.normal = hit.found ? normalize(mix(skin.normal, rough, skin.stone)) : skin.normal;
    Ray there = shadowRay(p, skin.normal, TO_SUN, 2.0 * radius + 0.004);
    float reach = met ? shadowReach(skin.normal, TO_SUN, min(reefInterval(there).y, 8.0)) : 0.0;
    float seen = sunSeen(there, reach);
    vec3 light = met ? surfaceLight(ray, t, onSand, seen, skin, openness(p, skin.normal)) : vec3(0.0);
    light = mix(waterLight(ray.direction), light, met ? exp(-ABSORBED * t / clearness) : vec3(0.0)) + shaftLight(ray, t);
    vec3 shown = encodeSRGB(filmOfLargest(1.05 * light, 1.55, 5.0)) + ditherStep(iPixel) / 255.0;
    return counted ? countColour(asked) : shown;
}
