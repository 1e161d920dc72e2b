// Solution of exercise 14.2: the two box trees hide part of the sky, in closed form, and nothing
// else does.
#include "main.glsl"
#define rayColour chapterRayColour
#include "14_occlusion.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    lookingRound = false;
    Place place = courtyardPlace(ray, hitThreshold, maxSteps);
    vec3 start = place.p + 2.0 * place.radius * place.normal;
    float large = hiddenByBall(start, place.normal, COURT_BALL.xyz, COURT_BALL.w);
    float small = hiddenByBall(start, place.normal, COURT_SMALL_BALL.xyz, COURT_SMALL_BALL.w);
    bool green = boxTreeDistance(place.p) < place.radius;
    float open = green ? 1.0 : openOverGround(place.normal) * (1.0 - large) * (1.0 - small);
    return encodeSRGB(place.open ? skyLight(ray.direction) : placeLight(place, open));
}
