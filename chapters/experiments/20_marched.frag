// Experiment of chapter 20: a march through a layer of clouds, with Beer's law along the ray and
// one ray towards the sun from each point.

#include "main.glsl"
#include "random.glsl"
#define rayColour chapterColour
#include "20_clouds_and_weather.frag"
#undef rayColour

uniform sampler3D noise; // "noise.png" linear repeat 64: value noise

uniform int   points;    // 32 in [4, 128]: points on the path of a ray through the layer
uniform float amount;    // 0.5 in [0, 1] step 0.02: amount of cloud in the layer
uniform float thickness; // 9 in [0, 40] step 1, per km: optical depth of a kilometre of cloud
uniform bool  shaded;    // true: one ray to the sun from each point

const float FOOT = 1.2, TOP = 2.6; // altitudes of the layer, km

// The optical depth of one kilometre at a point p, which is relative to the eye.
//   level  level of detail at which the noise is read
float vapour(vec3 p, float level)
{
    float altitude = p.y + dot(p.xz, p.xz) / (2.0 * EARTH_RADIUS), height = (altitude - FOOT) / (TOP - FOOT);
    vec3 q = vec3(p.x, altitude, p.z + 9.0);
    float field = textureLod(noise, vec3(q.xz / 41.0, 0.3).xzy, level - 2.0).x;
    float puffs = 0.45 * textureLod(noise, q / 11.0, level).x + 0.4 * abs(textureLod(noise, q / 4.1, level + 1.4).x - 0.5);
    puffs += 0.3 * abs(textureLod(noise, q / 1.5, level + 2.9).x - 0.5);
    float inside = 0.9 * field + 1.3 * puffs - mix(1.2, 0.7, amount) - 0.5 * max(height - 0.2, 0.0);
    float within = smoothstep(0.0, 0.08, height) * (1.0 - smoothstep(0.8, 1.0, height));
    return thickness * within * clamp(7.0 * inside, 0.0, 1.0);
}

// The light of the layer along a ray, weighted with its cover (rgb), and the share of the
// background that remains visible (a).
vec4 marchedLayer(vec3 direction, Lights lights, float width)
{
    float near = layerHit(0.0, direction.y, FOOT), far = min(layerHit(0.0, direction.y, TOP), 80.0);
    float stride = max(far - near, 0.0) / float(points), left = 1.0;
    float level = max(log2(width * near * 64.0 / 13.0), 0.0), phase = 0.5 + 3.0 * glow(direction, lights.sun, 0.6);
    vec3 light = vec3(0.0);
    for (int i = 0; i < points; i++) {
        vec3 p = (near + (float(i) + pixelRandom(0)) * stride) * direction;
        float here = vapour(p, level), depth = 0.0;
        if (shaded)
            for (int k = 0; k < 4; k++) {
                float reach = 0.06 * exp2(float(k));
                depth += reach * vapour(p + 1.5 * reach * lights.sun, level + float(k));
            }
        float lost = left * (1.0 - exp(-here * stride)), height = clamp((p.y - FOOT) / (TOP - FOOT), 0.0, 1.0);
        light += lost * (lights.high * phase * (0.7 * exp(-depth) + 0.3 * exp(-0.15 * depth)) * 0.5 + lights.sky * (0.35 + 0.65 * height));
        left -= lost;
    }
    return vec4(light, left);
}

vec3 rayColour(Ray ray)
{
    Lights lights = lightsAt(timeOfDay + hoursPerSecond * iTime);
    Surface surface = surfaceAlong(ray);
    vec3 up = normalize(vec3(surface.seen.direction.x, max(surface.seen.direction.y, 0.002), surface.seen.direction.z));
    vec3 clear = mix(skyLight(up, lights), overcastSky(up.y, lights.sky), overcastShare(weather));
    vec4 layer = marchedLayer(up, lights, skyWidth(surface));
    float haze = fogDepth(0.0, up.y, layerHit(0.0, up.y, FOOT), hazeDensity(weather), 1.5);
    vec3 beyond = discLeft(weather) * heavens(surface.seen.direction, lights, skyWidth(surface));
    vec3 sky = layer.a * (clear + beyond) + throughFog(layer.rgb, (1.0 - layer.a) * clear, haze);
    return developed(surfaceLight(surface, ray.direction, sky, lights), surface, lights);
}
