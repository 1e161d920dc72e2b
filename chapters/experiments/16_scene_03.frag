// Experiment of chapter 16: the scene of chapter 03 with the methods of 16_means.glsl and one more:
// a shadow ray ignores the stage.
//
// No point of the stage lies between another point of the scene and the lamp, because all objects
// are on the stage and the lamp is higher. So the stage can be left out of the distance for shadow
// rays, which then need not climb away from it in small steps.
#include "main.glsl"
#include "16_means.glsl"

uniform bool own; // true: shadow rays ignore the stage

float stageAway = 0.0; // added to the stage's distance

float reachingWithoutStage(Ray ray, float far, float threshold, int steps)
{
    stageAway = own ? 1000.0 : 0.0;
    float light = lightReaching(ray, far, threshold, steps);
    stageAway = 0.0;
    return light;
}

#define lightReaching reachingWithoutStage
#define sceneDistance chapterDistance
#include "03_shadows.frag"
#undef sceneDistance

float sceneDistance(vec3 p)
{
    vec3 q = p - vec3(0.4, 0.8, -0.5);
    float framed = min(sdBoxFrame(q, vec3(0.8), 0.07), sdSphere(q, 0.36));
    float balls = min(sdSphere(q - vec3(0.0, 1.25, 0.0), 0.28), sdSphere(p - vec3(1.75, 0.4, 1.2), 0.4));
    float block = sdBox(p - vec3(-1.6, 0.3, 0.1), vec3(0.35, 0.3, 0.55));
    float stage = sdBox(p - vec3(0.0, -0.1, 0.0), vec3(2.6, 0.1, 2.2)) + stageAway;
    return min(min(framed, balls), min(block, stage));
}

float coarseMargin(float t)
{
    return hitThreshold;
}
