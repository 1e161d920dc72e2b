// Experiment of chapter 24: the filter over all light that a surface receives, not only over what has bounced.
#include "main.glsl"
#define frameKept chapterFrameKept
#define rayColour chapterRayColour
#include "24_bounces.frag"
#undef frameKept
#undef rayColour

vec4 frameKept(vec2 pixel)
{
    vec4 last = texelFetch(history, iPixel, 0);
    Ray ray = pixelRay(screenPosition(pixel));
    Surface s = roomSurface(ray, hitThreshold, maxSteps);
    if (iFrame >= gather)
        return iFrame < gather + filterPasses ? vec4(filtered(s, 1 << (iFrame - gather)), last.a) : last;
    float away;
    vec3 light = pathLight(ray, false, away) / (s.open ? vec3(1.0) : s.colour);
    return vec4(mix(last.rgb, light, 1.0 / float(iFrame + 1)), away);
}

vec3 rayColour(Ray ray)
{
    Surface s = roomSurface(ray, hitThreshold, maxSteps);
    vec3 light = s.open ? skyLight(ray.direction) : s.colour * filtered(s, 1);
    return encodeSRGB(filmCurve(exposed(light, exposure), 1.25, 9.0));
}
