// Experiment of chapter 24: the eye moves to the right, and each frame keeps nothing of the last one, or what the
// same pixel had, or what the same point of the room had. The fourth number kept is a count of frames, plus 1/32 of the
// distance of the point.
#include "main.glsl"
#define pixelRay chapterPixelRay
#define frameKept chapterFrameKept
#define rayColour chapterRayColour
#include "24_bounces.frag"
#undef pixelRay
#undef frameKept
#undef rayColour

uniform int   keeping; // 2 in [0, 2]: what is kept of the last frame: 0 nothing, 1 what the pixel had, 2 what the point had
uniform float speed;   // 0.3 in [-1, 1] step 0.05, scene units per second: speed of the eye
uniform int   most;    // 32 in [1, 1024]: the mean never counts more frames than this

Ray pixelRay(vec2 screen)
{
    Ray ray = perspectiveRay(screen);
    return Ray(ray.origin + vec3(speed * iTime, 0.0, 0.0), ray.direction);
}

// What the last frame kept for a point p of a surface: the mean over those of the four pixels around it whose points
// are in the plane of the surface. The fourth number is the count of frames, 0 if no pixel belongs to the surface.
vec4 keptAt(vec3 p, vec3 normal)
{
    vec3 eye = iCameraPosition + vec3(speed * (iTime - iTimeDelta), 0.0, 0.0), to = p - eye;
    vec2 screen = focalLength * vec2(dot(to, iCameraRight), dot(to, iCameraUp)) / dot(to, iCameraForward);
    vec2 pixel = 0.5 * (screen * iResolution.y + iResolution.xy) - 0.5;
    ivec2 low = ivec2(floor(pixel));
    vec2 part = pixel - vec2(low);
    vec4 sum = vec4(0.0);
    float all = 0.0;
    for (int i = 0; i < 4; i++) {
        ivec2 corner = ivec2(i % 2, i / 2), there = low + corner;
        vec4 kept = texelFetch(history, clamp(there, ivec2(0), ivec2(iResolution.xy) - 1), 0);
        vec3 on = eye + 32.0 * fract(kept.a) * perspectiveRay(screenPosition(vec2(there) + 0.5)).direction;
        vec2 near = mix(1.0 - part, part, vec2(corner));
        bool inside = there == clamp(there, ivec2(0), ivec2(iResolution.xy) - 1);
        bool same = inside && fract(kept.a) > 0.0 && abs(dot(on - p, normal)) < 2.0 * SAME_PLANE;
        sum += same ? near.x * near.y * vec4(kept.rgb, floor(kept.a)) : vec4(0.0);
        all += same ? near.x * near.y : 0.0;
    }
    return iFrame > 0 && all > 0.0 ? sum / all : vec4(0.0);
}

vec4 frameKept(vec2 pixel)
{
    float away;
    Ray ray = pixelRay(screenPosition(pixel));
    vec3 light = pathLight(ray, false, away);
    Surface s = roomSurface(ray, hitThreshold, maxSteps);
    vec4 old = keeping == 2 ? keptAt(s.p, s.normal) : texelFetch(history, iPixel, 0);
    float count = keeping == 0 ? 0.0 : min(floor(old.a), float(most - 1));
    return vec4(mix(old.rgb, light, 1.0 / (count + 1.0)), count + 1.0 + max(away, 0.0) / 32.0);
}

vec3 rayColour(Ray ray)
{
    roomSurface(ray, hitThreshold, maxSteps); // for the views
    return encodeSRGB(filmCurve(exposed(texelFetch(history, iPixel, 0).rgb, exposure), 1.25, 9.0));
}
