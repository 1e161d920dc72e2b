// Experiment of chapter 17: a rainbow, from the paths through one drop. The sun is behind the eye.
//
// A ray meets a drop at a distance of b radii from the line through the drop's centre and the sun.
// It is reflected once or twice inside and leaves at an angle to the sun's rays. The rays between
// two values of b light a ring of the sky, and where the angle reaches its limit, their light is
// concentrated.
#include "main.glsl"
#include "camera.glsl"
#include "coverage.glsl"
#include "fresnel.glsl"
#include "lighting.glsl"
#include "spectrum.glsl"

uniform float sunElevation; // 14 in [0, 60] step 1, degrees: height of the sun, behind the eye
uniform float sunWidth;     // 0.0093 in [0.002, 0.05] step *1.2, radians: angular diameter of the sun, which blurs the bow
uniform int   waves;        // 12 in [1, 40]: number of wavelengths

const vec2 WATER = vec2(1.3240, 0.00310); // Cauchy's coefficients
const int RINGS = 48;

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float sceneDistance(vec3 p)
{
    return p.y;
}

// The sum of two angles. An angle is given by its cosine and sine, so that nothing depends on how
// exact a driver's asin and acos are; the product of two such pairs, as complex numbers, has the
// sum of their angles.
vec2 turned(vec2 a, vec2 b)
{
    return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

// The sine of the angle a - b, which is about a - b in radians if this is small; beyond a quarter
// turn, 1 or -1. Both angles are from 0 to half a turn.
float apart(vec2 a, vec2 b)
{
    vec2 difference = turned(a, vec2(b.x, -b.y));
    return difference.x > 0.0 ? difference.y : sign(difference.y);
}

// The light of a shower in a direction at the given angle from the point opposite the sun, after
// `mirrored` reflections in each drop.
float bowLight(vec2 angle, float index, int mirrored)
{
    vec2 before = vec2(1.0, 0.0);
    float light = 0.0, within = 0.0;
    for (int k = 0; k <= RINGS; k++) {
        float b = sin(1.5707 * float(k) / float(RINGS)), c = b / index;
        vec2 outside = vec2(sqrt(1.0 - b * b), b), inside = vec2(sqrt(1.0 - c * c), c);
        // The angle to the normal is i outside the drop and j inside.
        vec2 less = turned(inside, vec2(outside.x, -outside.y)), twice = turned(inside, inside); // j - i, 2 j
        vec2 once = turned(turned(less, less), twice); // 4 j - 2 i
        // The angle from the point opposite the sun at which the ray leaves.
        vec2 after = mirrored == 1 ? once : vec2(-1.0, 1.0) * turned(once, twice);
        float share = fresnelShare(outside.x, 1.0 / index);
        float kept = (1.0 - share) * (1.0 - share) * (mirrored == 1 ? share : share * share);
        vec2 low = before.x > after.x ? before : after, high = before.x > after.x ? after : before;
        float area = max(low.x - high.x, 1e-6);
        float lit = coverage(apart(high, angle), sunWidth) - coverage(apart(low, angle), sunWidth);
        light += k > 0 ? lit * kept * (b * b - within) / area : 0.0;
        before = after;
        within = b * b;
    }
    return light;
}

vec3 rayColour(Ray ray)
{
    float elevation = radians(sunElevation);
    vec3 opposite = vec3(0.0, -sin(elevation), -cos(elevation)), d = ray.direction;
    vec2 angle = vec2(dot(d, opposite), length(cross(d, opposite)));
    vec3 bow = vec3(0.0), sum = vec3(0.0);
    for (int i = 0; i < 2 * waves; i++) {
        float wave = sampleWave(i / 2, waves, 0.5);
        bow += waveColour(wave) * bowLight(angle, cauchyIndex(WATER, wave), 1 + i % 2);
        sum += 0.5 * waveColour(wave);
    }
    vec3 cloud = mix(vec3(0.10, 0.13, 0.19), vec3(0.03, 0.04, 0.07), smoothstep(0.0, 0.7, d.y));
    float hill = 0.035 * sin(2.1 * d.x / -d.z) + 0.02 * sin(5.3 * d.x / -d.z + 1.0);
    vec3 meadow = mix(vec3(0.16, 0.19, 0.04), vec3(0.02, 0.05, 0.012), 1.0 - smoothstep(-0.25, 0.0, d.y - hill));
    vec3 sky = cloud + 0.55 * bow / sum * smoothstep(-0.02, 0.12, d.y - hill);
    return encodeSRGB(mix(meadow, sky, smoothstep(-0.002, 0.002, d.y - hill)));
}
