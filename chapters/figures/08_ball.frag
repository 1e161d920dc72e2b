// Near and far look alike: drag the ball, then change its depth. With parallel rays, the ball keeps its position and
// its size in the picture, although it moves from the front of the tower to the terrace far behind the tower. Only the
// ball's shadow moves, and the tower begins to hide the ball. If you lower the parameter `orthographic` a little, the
// ball shrinks as it moves away. In a page, drag the picture itself to look at the building from another side.
#include "main.glsl"
#define sceneDistance buildingDistance
#define colourAt buildingColour
#define rayColour buildingView
#include "08_orthographic_view.frag"
#undef sceneDistance
#undef colourAt
#undef rayColour

uniform vec3  ball;  // -0.9, 2.3, -0.2 in [-3, 7] step 0.1, handle scene units: the ball at depth 0
uniform float depth; // 0 in [0, 3.4] step 0.1, scene units: how far the ball has moved along the view

const vec3 ALONG = vec3(0.57735027, -0.57735027, -0.57735027); // the direction of the chapter's view

float ballDistance(vec3 p)
{
    return length(p - ball - depth * ALONG) - 0.35;
}

float sceneDistance(vec3 p)
{
    return min(buildingDistance(p), ballDistance(p));
}

// The chapter's rayColour, except for the colour of the ball.
vec3 rayColour(Ray ray)
{
    vec2 interval = boxInterval(ray, LOW, HIGH);
    Hit hit = march(ray, interval.x, interval.y, hitThreshold, maxSteps);
    vec3 light = backdrop();
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction;
        vec3 normal = normalAt(p, hitThreshold);
        vec3 colour = ballDistance(p) < 0.01 ? vec3(0.95, 0.72, 0.12) : buildingColour(p);
        light = colour * (SKY_COLOUR * (0.7 + 0.3 * normal.y) + SUN_COLOUR * sunlight(p, normal));
    }
    return encodeSRGB(light);
}
