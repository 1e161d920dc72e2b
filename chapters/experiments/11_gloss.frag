// Experiment of chapter 11: two rows of seven balls, from smooth to rough. The upper row uses GGX,
// and the lower row uses the Blinn-Phong highlight with the exponent that corresponds to the same
// roughness. Both models treat a surface as many tiny mirrors. The mirrors reflect all the light
// that they receive, and nothing enters the balls: any light that is missing is lost by the model.
#include "main.glsl"
#include "cone.glsl"
#include "normal.glsl"
#include "primitives.glsl"
#include "gloss.glsl"
#include "lighting.glsl"

const vec3 TO_LIGHT = vec3(-0.48, 0.64, 0.6);
const float APART = 1.0; // distance between the centres of neighbouring balls, scene units

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// The centre of the ball in the row and column of p.
vec3 ballOf(vec3 p)
{
    return vec3(clamp(floor(p.x / APART + 0.5), -3.0, 3.0) * APART, p.y > 0.0 ? 0.55 : -0.55, 0.0);
}

float sceneDistance(vec3 p)
{
    return sdSphere(p - ballOf(p), 0.44);
}

vec3 rayColour(Ray ray)
{
    Hit hit = marchCone(ray, 0.0, 20.0, 0.001, pixelSpread(), 96);
    vec3 light = vec3(0.020, 0.024, 0.030);
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction;
        vec3 normal = normalAt(p, 0.002);
        float roughness = 0.2 + 0.8 * (ballOf(p).x / APART + 3.0) / 6.0, alpha = roughness * roughness;
        float gloss = p.y > 0.0 ? ggxGloss(normal, TO_LIGHT, -ray.direction, roughness)
                                : blinnPhongGloss(normal, TO_LIGHT, -ray.direction, 2.0 / (alpha * alpha) - 2.0);
        light = GLOSS_PI * gloss * lambert(normal, TO_LIGHT) * vec3(0.85, 0.72, 0.50) + 0.02;
    }
    return encodeSRGB(light);
}
