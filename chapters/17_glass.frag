// 17 Glass: light splits at each surface, and the ray continues with the transmitted part. Inside the
// glass, the length of a step is minus the distance.

#include "main.glsl"       // main(): calls pixelRay, then rayColour
#include "cone.glsl"       // perspectiveRay, pixelSpread
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdSphere
#include "solids.glsl"     // opExtrude, sdCappedCone; opRound, sdTriangle of plane.glsl
#include "combine.glsl"    // opSubtraction
#include "glass.glsl"      // marchSide, partingAt, leavingRay, absorbed, straightThrough
#include "spectrum.glsl"   // cauchyIndex, waveColour, meanColour, sampleWave
#include "prism.glsl"      // prismBeam
#include "caustic.glsl"    // ballCaustic
#include "coverage.glsl"   // coverage, stripes, blurred
#include "lighting.glsl"   // encodeSRGB
#include "random.glsl"     // pixelRandom
#include "shadow.glsl"     // shadowRay
#include "bounds.glsl"     // boxInterval

uniform int   surfaces;     // 10 in [0, 24]: number of surfaces that a ray may meet; light that is left after them is lost
uniform int   waves;        // 1 in [1, 16]: wavelengths in each sample; with 1 all colours take the path of green
uniform bool  byLot;        // false: at a surface the ray is reflected or transmitted as a whole, at random
uniform bool  white;        // false: clear glass in a white world; the picture must be white
uniform float tint;         // 1 in [0, 4] step 0.1: how much light the tumbler's glass absorbs
uniform float startOffset;  // 2.5 in [0, 10] step 0.5, thresholds: distance from a surface at which the next ray starts
uniform float lampAzimuth;  // 28 in [0, 360] step 2, degrees: azimuth of the lamp, from the right away from the viewer
uniform float lampSpeed;    // 12 in [0, 90] step 2, degrees per second: speed of the lamp's azimuth
uniform int   maxSteps;     // 384 in [1, 512]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.0004 in [0.00001, 0.05] step *2, scene units: distance that counts as a hit, on both sides

// The table is the plane y = 0. It is not part of the distance.
const vec3  LOW = vec3(-1.95, -0.01, -1.10), HIGH = vec3(1.65, 1.65, 1.15); // corners of a box around the glass
const float FAR = 30.0;
const vec4  BALL = vec4(1.10, 0.502, 0.0, 0.5);      // centre and radius
const vec3  TUMBLER = vec3(-0.10, 0.802, -0.40);     // centre of the tumbler
const vec3  PRISM = vec3(-1.32, 0.322, 0.45);        // centre of the prism
const float PRISM_RADIUS = 0.32;                     // distance from the axis of the prism to a side
const vec2  PRISM_BASE = vec2(0.9916, -0.1296);      // x and z of the direction of the prism's base, length 1.00003
const vec2  CROWN = vec2(1.5046, 0.00420);           // Cauchy's coefficients of BK7 glass
const vec2  FLINT = vec2(1.6894, 0.01341);           // Cauchy's coefficients of SF10 glass
const vec3  AMBER = vec3(0.25, 0.9, 2.4);            // absorption per scene unit
const vec3  LAMP_COLOUR = vec3(1.25, 1.02, 0.78);
const vec3  TABLE_COLOUR = vec3(0.045, 0.060, 0.080);
const float SQUARE = 0.6;                            // side of a square of the table's pattern
const float BEAM = 0.035;                            // half the width of the prism's beam
const float BEAM_RISE = 0.14;                        // sine of the angle at which the beam descends to the table
const float BEAM_LIGHT = 8.0;

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// ---- The glass: distances that are exact inside ----

// A point in the prism's plan: x along the base, y towards the edge opposite the base.
vec2 prismPlan(vec2 p)
{
    vec2 q = p - PRISM.xz;
    return vec2(dot(PRISM_BASE, q), PRISM_BASE.y * q.x - PRISM_BASE.x * q.y);
}

// An equilateral triangle, extruded upwards and rounded: rounding needs a distance that is also
// exact outside.
float prismDistance(vec3 p)
{
    const float r = PRISM_RADIUS - 0.004, corner = 1.7320508 * r;
    float triangle = sdTriangle(prismPlan(p.xz), vec2(-corner, -r), vec2(corner, -r), vec2(0.0, 2.0 * r));
    return opRound(opExtrude(triangle, p.y - PRISM.y, 0.316), 0.004);
}

float tumblerDistance(vec3 p)
{
    vec3 q = p - TUMBLER;
    float body = opRound(sdCappedCone(q, 0.50, 0.58, 0.77), 0.03);
    return opSubtraction(body, sdCappedCone(q - vec3(0.0, 0.30, 0.0), 0.455, 0.54, 0.8));
}

float ballDistance(vec3 p)
{
    return sdSphere(p - BALL.xyz, BALL.w);
}

float sceneDistance(vec3 p)
{
    return min(tumblerDistance(p), min(prismDistance(p), ballDistance(p)));
}

// The camera stops in front of the glass and above the table.
float cameraRoom(vec3 p)
{
    return min(sceneDistance(p), p.y) - 0.05;
}

// A kind of glass: Cauchy's coefficients, and the absorption per scene unit.
struct Glass {
    vec2 cauchy;
    vec3 absorption;
};

Glass glassAt(vec3 p)
{
    bool prism = p.x < -0.72, ball = p.x > 0.56;
    return Glass(prism ? FLINT : CROWN, white || prism || ball ? vec3(0.0) : tint * AMBER);
}

// ---- The room ----

vec3 toLamp()
{
    float azimuth = radians(lampAzimuth + lampSpeed * iTime);
    return normalize(vec3(cos(azimuth), 0.50, -sin(azimuth)));
}

// The light from the direction d in a dark room: a lit screen behind the table, tall windows on both
// sides, and the lamp itself.
vec3 surroundings(vec3 d)
{
    vec2 screen = vec2(d.x, d.y - 0.06) / max(-d.z, 0.05);
    float glow = (1.0 - smoothstep(0.0, 0.75, length(screen))) * smoothstep(0.0, 0.3, -d.z);
    vec3 wall = vec3(0.012, 0.026, 0.055) + glow * vec3(0.34, 0.09, 0.06) + glow * glow * glow * vec3(0.80, 0.62, 0.36);
    float left = smoothstep(0.72, 0.78, -d.x) * smoothstep(0.04, 0.10, d.y) * (1.0 - smoothstep(0.55, 0.60, d.y));
    float right = smoothstep(0.90, 0.93, d.x) * smoothstep(0.06, 0.12, d.y);
    float lamp = smoothstep(0.9975, 0.9985, dot(d, toLamp()));
    vec3 above = wall + left * vec3(0.36, 0.48, 0.62) + right * vec3(1.1, 0.85, 0.6) + 4.0 * lamp * LAMP_COLOUR;
    return white ? vec3(1.0) : mix(0.35 * TABLE_COLOUR, above, smoothstep(-0.02, 0.02, d.y));
}

// The white beam on the table, and its colours behind the prism.
vec3 beamLight(vec3 p)
{
    Beam beam = prismBeam(prismPlan(p.xz), PRISM_RADIUS, FLINT, BEAM_RISE, BEAM);
    return BEAM_LIGHT * (beam.white + meanColour(beam.waves.x, beam.waves.y));
}

// The lamp's light on the table. The light goes straight through the tumbler and the prism, but the
// ball gathers it.
vec3 lampLight(vec3 p, bool asked)
{
    vec3 lamp = toLamp(), fromBall = p - BALL.xyz;
    Ray ray = shadowRay(p, vec3(0.0, 1.0, 0.0), lamp, 0.001);
    vec2 interval = boxInterval(ray, LOW, HIGH);
    ray.origin += interval.x * lamp;
    Passage passage = straightThrough(ray, asked ? interval.y - interval.x : 0.0, 1.52, 0.015, maxSteps);
    vec3 absorption = glassAt(ray.origin + passage.deepest * lamp).absorption;
    float axis = length(fromBall - dot(fromBall, lamp) * lamp);
    bool behind = dot(fromBall, lamp) < 0.0;
    vec3 straight = passage.share * absorbed(absorption, passage.inside);
    straight *= behind ? 1.0 - coverage(BALL.w - axis, 0.02) : 1.0;
    return 6.0 * lamp.y * LAMP_COLOUR * (straight + ballCaustic(fromBall, lamp, BALL.w, 1.52, 0.05));
}

// The light of the table, and of the room behind it.
//   far  length of the path from the eye to this ray's start, scene units
vec3 worldLight(Ray ray, float far)
{
    float t = ray.direction.y < 0.0 ? min(-ray.origin.y / ray.direction.y, FAR) : FAR;
    vec3 p = ray.origin + t * ray.direction;
    vec2 width = 2.0 * pixelSpread() * (far + t) * (1.0 + abs(ray.direction.xz) / max(abs(ray.direction.y), 1e-6)) / SQUARE;
    vec2 lines = vec2(stripes(p.x / SQUARE, 0.025, width.x), stripes(p.z / SQUARE, 0.025, width.y));
    lines = mix(lines, vec2(0.025), vec2(blurred(width.x), blurred(width.y)));
    vec3 colour = TABLE_COLOUR * (1.0 + 2.2 * max(lines.x, lines.y));
    vec3 light = vec3(0.16, 0.20, 0.30) + exp(-0.1 * dot(p.xz, p.xz)) * lampLight(p, t < FAR) + beamLight(p);
    vec3 room = surroundings(normalize(vec3(ray.direction.x, max(ray.direction.y, 0.03), ray.direction.z)));
    return white ? vec3(1.0) : mix(colour * light, room, t < FAR ? smoothstep(2.5, 12.0, length(p.xz)) : 1.0);
}

// ---- The path of a ray ----

struct Way {
    Ray   ray;   // the last ray of the path; it starts at the last surface
    float far;   // length of the path from the eye to that surface, scene units
    vec3  share; // share of the light of this ray that reaches the eye
    vec3  light; // light reflected towards the eye at the surfaces that the path has met
    bool  free;  // true if the ray met nothing more, false if the path met too many surfaces
};

// Follow a ray from surface to surface. With byLot, chance decides at each surface whether the ray is reflected.
// Otherwise, the ray is transmitted unless all light is reflected, and the light of the reflected part, which is not
// followed, is assumed to come straight from the room.
//   wave  wavelength of the light, micrometres
//   lot   the first dimension of pixelRandom that the path uses
Way wayThrough(Ray ray, float wave, int lot)
{
    Way way = Way(ray, 0.0, vec3(1.0), vec3(0.0), true);
    float side = 1.0;
    int met = 0;
    bool going = true;
    while (going) {
        vec2 interval = boxInterval(way.ray, LOW, HIGH);
        float ground = way.ray.direction.y < 0.0 ? -way.ray.origin.y / way.ray.direction.y : FAR;
        Hit hit = marchSide(way.ray, side, side > 0.0 ? interval.x : 0.0, min(interval.y, ground), hitThreshold, maxSteps);
        way.free = !hit.found;
        if (hit.found) {
            vec3 from = way.ray.direction, p = way.ray.origin + hit.t * from, normal = normalAt(p, hitThreshold);
            Glass glass = glassAt(p);
            way.share *= side > 0.0 ? vec3(1.0) : absorbed(glass.absorption, hit.t);
            Parting parting = partingAt(from, normal, side, cauchyIndex(glass.cauchy, wave));
            bool back = byLot ? pixelRandom(lot + met) < parting.mirrored : parting.mirrored >= 1.0;
            way.light += byLot || back ? vec3(0.0) : way.share * parting.mirrored * surroundings(parting.away);
            way.share *= byLot || back ? 1.0 : 1.0 - parting.mirrored;
            way.far += hit.t;
            way.ray = leavingRay(p, normal, back ? parting.away : parting.bent, startOffset * hitThreshold);
            side = back ? side : -side;
            met++;
        } else if (met == 0 && ground < FAR) { // report the hit on the table to the views and the probe
            traceMarch(trace.steps, ground, END_HIT);
            traceNormal(vec3(0.0, 1.0, 0.0));
        }
        going = hit.found && met < surfaces;
    }
    return way;
}

vec3 rayColour(Ray ray)
{
    vec3 sum = vec3(0.0), weight = vec3(0.0);
    for (int k = 0; k < waves; k++) {
        float wave = sampleWave(k, waves, 0.5);
        vec3 colour = waves > 1 ? waveColour(wave) : vec3(1.0);
        Way way = wayThrough(ray, wave, 32 * k);
        sum += colour * (way.light + (way.free ? way.share * worldLight(way.ray, way.far) : vec3(0.0)));
        weight += colour;
    }
    return encodeSRGB(sum / weight);
}
