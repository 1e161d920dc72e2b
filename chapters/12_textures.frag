// 12 Textures: stones, a plank and a cloth on a cold, clear morning. None has texture coordinates.

#include "main.glsl"       // main(): calls pixelRay, then rayColour
#include "cone.glsl"       // perspectiveRay, marchCone, pixelSpread, coneReaching
#include "primitives.glsl" // sdSphere, boxDistance
#include "repetition.glsl" // opRepeatLimited
#include "transform.glsl"  // Pose, seenFrom, rotationZ, displacementStretch, heightStretch
#include "noise.glsl"      // octaveNoise, octaveStretch, geometricSum
#include "texture.glsl"    // footprintOn, planeWeights, the lookups
#include "fresnel.glsl"    // schlickShare
#include "lighting.glsl"   // lambert, encodeSRGB
#include "shadow.glsl"     // shadowRay, shadowReach
#include "bounds.glsl"     // boxInterval, intervalUnion

uniform sampler2D granite;  // "granite.png" sRGB repeat: polished stone
uniform sampler2D plank;    // "plank.png" sRGB repeat: boards side by side
uniform sampler2D cloth;    // "cloth.png" sRGB repeat: a plain weave

uniform int   planes;       // 3 in [0, 3]: sides from which the granite is projected: all 3, the 2 with the largest weights, 1 from above; 0: coloured in space
uniform float sharpness;    // 6 in [1, 64] step *1.5: how strongly the side that the surface faces dominates
uniform float footprint;    // 0.577 in [0, 32] step 0.1, pixels: width over which a texture is averaged; 0: no averaging
uniform bool  carried;      // true: the ball carries its texture; false: it rolls through the texture
uniform float bumps;        // 0.02 in [0, 0.2] step 0.01, scene units: apparent height of the bumps on the ground
uniform float frost;        // 0.45 in [0, 1] step 0.05: how white the surfaces that face upwards are
uniform float roughness;    // 0.12 in [0, 0.4] step 0.02, scene units: depth to which the noise carves the stones
uniform int   maxSteps;     // 160 in [1, 512]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.001 in [0.00001, 0.1] step *2, scene units: distance that counts as a hit, at the eye
uniform float normalStep;   // 0.002 in [0.0000001, 0.5] step *2, scene units: step of the differences that estimate the normal

const float FAR = 60.0;                       // at this distance the ground has become mist
const vec3  LOW = vec3(-1.85, -0.1, -0.62);   // opposite corners of a box around the bench
const vec3  HIGH = vec3(2.25, 1.6, 0.62);
const vec3  ROW_LOW = vec3(-0.7, -0.1, -9.3); // opposite corners of a box around the row of stones behind the bench
const vec3  ROW_HIGH = vec3(2.7, 2.25, -2.3);
const int   OCTAVES = 1;                      // octaves of the noise that carves the stones in the march
const float CELLS = 2.8;                      // cells of the first octave per scene unit
const float GAIN = 0.45;                      // weight of an octave relative to the previous one
const float LACUNARITY = 2.0;                 // how much finer an octave is than the previous one
const float BALL = 0.28;                      // radius of the ball, scene units
const float REPEATS = 1.8;                    // repeats of the granite per scene unit
const float WEAVE = 0.8;                      // repeats of the plank and of the cloth per scene unit
const vec3  SUN = vec3(-0.899, 0.345, 0.269); // direction to the sun, length 1
const vec3  SUN_COLOUR = vec3(3.2, 1.95, 0.98);
const vec3  SKY_COLOUR = vec3(0.11, 0.17, 0.29);
const vec3  EARTH_COLOUR = vec3(0.070, 0.052, 0.042);

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// ---- The shapes ----

float roundBox(vec3 p, vec3 halfSize, float radius)
{
    return boxDistance(abs(p) - halfSize + radius) - radius;
}

// The stones before they are carved: two under the plank, and a row in the mist.
float smoothStones(vec3 p)
{
    float under = roundBox(vec3(abs(p.x - 0.2) - 1.2, p.y - 0.36, p.z), vec3(0.45, 0.53, 0.5), 0.16);
    vec3 q = p - vec3(1.9, 0.9, -3.2);
    vec2 row = vec2(0.943983 * q.x - 0.329994 * q.z, 0.329994 * q.x + 0.943983 * q.z);
    return min(under, roundBox(vec3(row.x, q.y, opRepeatLimited(row.y, 2.7, -2.0, 0.0)), vec3(0.5, 1.25, 0.62), 0.3));
}

// The pose of the ball, which rolls to and fro and turns by an angle of path / radius.
Pose ballPose()
{
    float way = 0.35 - 0.7 * abs(2.0 * fract(0.1 * iTime) - 1.0);
    return Pose(vec3(way - 0.75, 0.96 + BALL, 0.0), rotationZ(-way / BALL));
}

// A shell around the plank, open at the bottom and cut off at the hem. If it were closed just under
// the cut, the lower bound of the distance to it would be near 0 there, which the wide rays of a
// small picture would count as a hit. Folds displace the shell along z, by more the lower it hangs,
// with a slope of at most 0.7. Without the folds, the shell has the same cross-section at every x, so
// the slope of the folds is perpendicular to the gradient of the distance.
float clothDistance(vec3 p)
{
    vec3 q = p - vec3(0.75, 0.6, 0.0);
    vec2 wave = 2.0 * fract(vec2(1.8, 4.1) * q.x) - 1.0;
    float fold = dot(vec2(0.12, 0.03), wave * (1.0 - abs(wave)));
    vec2 edge = vec2(abs(abs(q.z) - fold * clamp(0.475 - 1.25 * q.y, 0.0, 1.0)) - 0.43, q.y - 0.33);
    float shell = abs(length(max(edge, 0.0)) + min(max(edge.x, edge.y), 0.0) - 0.05) - 0.012;
    float hem = max(-0.34 - q.y, abs(q.x + 0.1 * (q.y - 0.4)) - 0.48);
    return max(shell, hem) / heightStretch(0.7);
}

// The distances to the smooth stones, the plank, the ball and the cloth.
vec4 partDistances(vec3 p)
{
    float board = roundBox(p - vec3(0.2, 0.9, 0.0), vec3(1.95, 0.06, 0.46), 0.02);
    return vec4(smoothStones(p), board, sdSphere(p - ballPose().position, BALL), clothDistance(p));
}

// The noise that carves the stones: its value (x), in [0, 1), and its gradient (yzw).
vec4 stoneNoise(vec3 p, int count)
{
    return vec4(1.0, vec3(CELLS)) * octaveNoise(CELLS * p, count, GAIN, LACUNARITY);
}

// A Lipschitz constant of stoneNoise with the octaves that the march uses.
float stoneNoiseStretch()
{
    return CELLS * octaveStretch(OCTAVES, GAIN, LACUNARITY);
}

// The noise removes material from the stones, to a depth of at most roughness. So the rough stones
// lie inside the smooth stones, and the distance to the smooth stones is also a lower bound.
float sceneDistance(vec3 p)
{
    vec4 part = partDistances(p);
    float rough = part.x + roughness * stoneNoise(p, OCTAVES).x;
    float stones = max(part.x, rough / displacementStretch(roughness * stoneNoiseStretch()));
    return min(min(stones, part.y), min(part.z, part.w));
}

// The camera stops in front of the objects and above the ground.
float cameraRoom(vec3 p)
{
    return min(sceneDistance(p), p.y) - 0.1;
}

vec2 sceneInterval(Ray ray)
{
    return intervalUnion(boxInterval(ray, LOW, HIGH), boxInterval(ray, ROW_LOW, ROW_HIGH));
}

// ---- Materials ----

struct Surface {
    vec4 part;   // the smallest absolute value of each of partDistances near p, at most 1
    vec3 normal; // normal of the smooth shapes
};

// The surface at p. Its normal comes from differences of the smooth shapes only, at the corners of a
// tetrahedron. If the differences cancel or there is no hit, the normal points up.
Surface surfaceAt(vec3 p, float h, bool hit)
{
    Surface surface = Surface(vec4(1.0), vec3(0.0));
    int corners = hit ? 4 : 1;
    for (int i = 0; i < corners; i++) {
        vec3 corner = 2.0 * vec3(i == 0 || i == 3, i == 1 || i == 3, i == 2 || i == 3) - 1.0;
        vec4 part = partDistances(p + h * corner);
        surface.normal += corner * min(min(part.x, part.y), min(part.z, part.w));
        surface.part = min(surface.part, abs(part));
    }
    float size = length(surface.normal);
    surface.normal = hit && size > 0.0 ? surface.normal / size : vec3(0.0, 1.0, 0.0);
    return surface;
}

// Granite, projected from as many sides as the parameter planes specifies.
//   p, normal, f  in the coordinates of the object
vec3 graniteAt(vec3 p, vec3 normal, Footprint f)
{
    vec3 weights = planeWeights(normal, sharpness);
    weights = planes == 2 ? twoPlaneWeights(weights) : (planes == 1 ? vec3(0.0, 1.0, 0.0) : weights);
    weights *= step(0.01, weights); // a smaller weight is not worth a lookup; the others sum to more than 0.98
    return textureOnPlanes(granite, REPEATS * p, footprintSeen(f, mat3(1.0), REPEATS), weights).rgb;
}

struct Material {
    vec3  colour;
    vec3  normal; // normal of the rough surface
    float polish; // 1 if the surface mirrors the sky, otherwise 0
};

// The material at the point where the ray ends, found once, at the hit. Without a hit, the point is
// on the ground.
//   width  of the pixel at p, scene units
Material materialAt(vec3 p, vec3 direction, float width, bool hit)
{
    float h = normalStep + 0.5 * width, near = hitThreshold + h;
    Surface surface = surfaceAt(p, h, hit);
    bool isCloth = hit && surface.part.w < near, isBall = hit && surface.part.z < near;
    bool isPlank = hit && surface.part.y < near && !isCloth, isStone = hit && !(isCloth || isBall || isPlank);

    // The gradient of the noise is computed in closed form. It includes two more octaves than the
    // march uses, or four more on the ground, which is nearer to the eye. The ground is flat, and
    // only shaded as if it were rough.
    float scale = hit ? 1.0 : 1.8, depth = isStone ? roughness : (hit ? 0.0 : bumps);
    int octaves = OCTAVES + (hit ? 2 : 4);
    vec4 noise = stoneNoise(scale * p, octaves);
    depth *= geometricSum(GAIN, octaves) / geometricSum(GAIN, OCTAVES); // the octaves of the march keep their depth
    vec3 normal = bumpedNormal(surface.normal, -depth * scale * noise.yzw);
    float pale = noise.x;

    Footprint f = footprintOn(direction, surface.normal, footprint * width);
    Pose pose = Pose(vec3(0.0), mat3(1.0));
    if (isBall && carried)
        pose = ballPose();
    bool granular = isStone || isBall; // elsewhere one lookup is enough, because the result is not used
    vec3 stone = graniteAt(seenFrom(pose, p), granular ? normal * pose.turn : vec3(0.0, 1.0, 0.0), footprintSeen(f, pose.turn, 1.0));
    stone = planes == 0 ? mix(vec3(0.10, 0.09, 0.08), vec3(0.62, 0.56, 0.52), pale) : stone;

    // The sides of the plank and the cloth are level or vertical, so one projection is enough, along
    // the axis that a side faces.
    vec3 facing = abs(surface.normal);
    int axis = facing.y > 0.6 ? 1 : (facing.x > facing.z ? 0 : 2);
    Slide slide = slideAlong(WEAVE * p, footprintSeen(f, mat3(1.0), WEAVE), axis);
    vec3 linen = 0.55 * textureOnSlide(cloth, slide).rgb, wood = textureOnSlide(plank, slide).rgb;
    vec3 earth = mix(vec3(0.05, 0.032, 0.018), vec3(0.20, 0.14, 0.085), pale);
    vec3 colour = isCloth ? linen : (isPlank ? wood : (hit ? stone : earth));
    float white = frost * smoothstep(0.3, 0.95, normal.y) * smoothstep(0.35, 0.6, pale + 0.25 * frost);
    colour = mix(colour, vec3(0.58, 0.66, 0.80), isBall ? 0.0 : (isStone || !hit ? white : 0.5 * white));
    return Material(colour, normal, isBall ? 1.0 : 0.0);
}

// ---- The morning ----

// A clear sky, paler towards the horizon and warm towards the low sun.
vec3 skyLight(vec3 direction, vec3 sun)
{
    float low = exp(-4.0 * max(direction.y, 0.0)), facing = 0.5 + 0.5 * dot(direction, sun);
    vec3 sky = mix(vec3(0.04, 0.14, 0.40), vec3(0.37, 0.43, 0.52), low);
    return sky + facing * facing * facing * vec3(1.5, 0.70, 0.16) * low;
}

vec3 rayColour(Ray ray)
{
    float spread = pixelSpread(), ground = ray.direction.y < 0.0 ? min(-ray.origin.y / ray.direction.y, FAR) : FAR;
    vec2 interval = sceneInterval(ray);
    Hit hit = marchCone(ray, interval.x, min(interval.y, ground), hitThreshold, spread, maxSteps);
    float t = hit.found ? hit.t : ground, radius = hitThreshold + spread * t;
    vec3 p = ray.origin + t * ray.direction;
    Material material = materialAt(p, ray.direction, 2.0 * spread * t, hit.found);
    if (t < FAR) { // report the hit, even on the ground, to the views and the probe
        traceNormal(material.normal);
        traceMarch(trace.steps, t, END_HIT);
    }
    Ray up = shadowRay(p, material.normal, SUN, 3.0 * radius);
    vec2 way = boxInterval(up, LOW, HIGH);
    float seen = coneReaching(up, way.x, shadowReach(material.normal, SUN, way.y), radius, 0.02, maxSteps);

    vec3 sky = mix(EARTH_COLOUR, SKY_COLOUR, 0.5 + 0.5 * material.normal.y);
    vec3 light = material.colour * (sky + seen * lambert(material.normal, SUN) * SUN_COLOUR);
    vec3 mirrored = reflect(ray.direction, material.normal);
    float share = material.polish * schlickShare(clamp(-dot(ray.direction, material.normal), 0.0, 1.0), 0.04);
    light = mix(light, mix(sky, skyLight(mirrored, SUN), smoothstep(-0.2, 0.2, mirrored.y)), share);
    vec3 mist = skyLight(vec3(ray.direction.x, 0.02, ray.direction.z), SUN);
    return encodeSRGB(t < FAR ? mix(mist, light, exp(-0.006 * t * t)) : skyLight(ray.direction, SUN));
}
