// Experiment of chapter 17: a rainbow, from the ways through one drop. The sun stands behind the eye.
//
// A ray that meets a drop at the share b of its radius is mirrored once or twice inside and leaves under an angle to
// the sun's rays. Rings of b send their light to rings of the sky; where the angle has its limit they crowd.
#include "main.glsl"
#include "camera.glsl"
#include "coverage.glsl"
#include "fresnel.glsl"
#include "lighting.glsl"
#include "spectrum.glsl"

uniform float sunElevation; // 14 in [0, 60] step 1, degrees: height of the sun, behind the eye
uniform float sunWidth;     // 0.0093 in [0.002, 0.05] step *1.2, radians: how wide the sun looks; it blurs the bow
uniform int   waves;        // 12 in [1, 40]: wavelengths

const vec2 WATER = vec2(1.3240, 0.00310); // Cauchy's numbers
const int RINGS = 48;

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float sceneDistance(vec3 p)
{
    return p.y;
}

// The light that a shower sends from an angle off the sun's opposite point, mirrored so many times in each drop.
float bowLight(float angle, float index, int mirrored)
{
    float light = 0.0, before = 0.0, within = 0.0;
    for (int k = 0; k <= RINGS; k++) {
        float outside = 1.5707 * float(k) / float(RINGS), b = sin(outside), inside = asin(b / index);
        float turn = float(mirrored) * 3.14159265 + 2.0 * outside - 2.0 * float(mirrored + 1) * inside;
        float after = mirrored == 1 ? 3.14159265 - turn : turn - 3.14159265; // from the opposite point
        float share = fresnelShare(cos(outside), 1.0 / index);
        float kept = (1.0 - share) * (1.0 - share) * (mirrored == 1 ? share : share * share);
        float low = min(before, after), high = max(before, after);
        float area = max(cos(low) - cos(high), 1e-6);
        float lit = coverage(high - angle, sunWidth) - coverage(low - angle, sunWidth);
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
    float angle = acos(clamp(dot(d, opposite), -1.0, 1.0));
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
