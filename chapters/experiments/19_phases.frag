// Experiment of chapter 19: ten phases of the moon in two rows, each exposed to the same
// brightness.
#include "main.glsl"
#include "lighting.glsl"
#include "night.glsl"

uniform sampler2D moon; // "moon.png" linear clamp: brightness and slopes of the moon's ground
uniform float relief;   // 1.5 in [0, 6] step 0.5: factor by which the slopes are exaggerated

Ray pixelRay(vec2 screen)
{
    return Ray(vec3(screen, 0.0), vec3(0.0, 0.0, -1.0));
}

float sceneDistance(vec3 p)
{
    return p.z;
}

// The ages are 1.5, 4.45, 7.4 days and so on, from left to right in the upper row, then in the
// lower.
vec3 rayColour(Ray ray)
{
    vec2 cell = vec2(ray.origin.x / 0.71, ray.origin.y < 0.0 ? 1.0 : 0.0);
    float column = clamp(round(cell.x), -2.0, 2.0), age = 1.5 + 2.95 * (column + 2.0 + 5.0 * cell.y);
    vec2 point = (ray.origin.xy - vec2(0.71 * column, 0.45 - 0.9 * cell.y)) / 0.32;
    float angle = 2.0 * NIGHT_PI * age / MONTH, width = 2.0 / (iResolution.y * 0.32);
    vec3 light = moonFace(moon, point, width, vec3(sin(angle), 0.0, -cos(angle)), relief);
    float inside = clamp((1.0 - length(point)) / width + 0.5, 0.0, 1.0);
    return encodeSRGB(inside * light * 0.55 * exp(0.94 * abs(NIGHT_PI - angle) * 0.8));
}
