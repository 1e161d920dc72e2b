// Where the shadow ray ends: drag the lamp, the box and the point on the floor. If the ray does not stop at the lamp, a
// box behind the lamp casts a shadow on the floor. Switch on the parameter `stopping`: then only objects between the
// floor and the lamp cast shadows.
#include "figure.glsl"
#include "shadow.glsl"

uniform vec2 lamp;     // (-0.1, 0.1) handle: the lamp
uniform vec2 box;      // (-0.5, 0.6) handle: centre of the box
uniform vec2 point;    // (0.42, -0.7) handle: a point on the floor
uniform bool stopping; // false: end the march at the lamp

const float FLOOR = -0.7, THRESHOLD = 0.002;

float sceneDistance(vec3 p)
{
    float ball = sdCircle(p.xy - vec2(0.85, -0.4), 0.16);
    return min(min(p.y - FLOOR, ball), sdRectangle(p.xy - box, vec2(0.3, 0.12)));
}

// The shadow ray from the floor at x. Stores in far how far to march this ray.
Ray fromFloor(float x, out float far)
{
    vec3 at = vec3(x, FLOOR, 0.0), way = vec3(lamp, 0.0) - at, up = vec3(0.0, 1.0, 0.0);
    far = shadowReach(up, way, stopping ? length(way) : 4.0);
    return shadowRay(at, up, normalize(way), 4.0 * THRESHOLD);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    float d = sceneDistance(vec3(p, 0.0)), far, t;
    bool dark = lightReaching(fromFloor(p.x, far), far, THRESHOLD, 100) == 0.0 || far == 0.0;
    Ray second = fromFloor(point.x, far);
    drawMarch(p, second.origin.xy, second.direction.xy, far, THRESHOLD, 100, t);
    bool lit = far > 0.0 && t >= far;
    line2(p, second.origin.xy, second.origin.xy + min(t, far) * second.direction.xy, 2.5, lit ? TEAL : ORANGE);
    fill(d, SAND, 1.0);
    if (dark)
        fill(max(p.y - FLOOR, FLOOR - 0.1 - p.y), NIGHT, 0.75);
    stroke(d, 2.0, ORANGE);
    dot2(p, vec2(point.x, FLOOR), 9.0, INK);
    dot2(p, lamp, 16.0, ORANGE);
    dot2(p, lamp, 9.0, CHALK);
    return sheetColour;
}
