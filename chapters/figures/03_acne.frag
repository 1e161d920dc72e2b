// Shadow acne: lower the offset, and drag the eye. Above, rays from the eye meet the floor; where the floor is dark,
// the shadow ray would start as a hit. Below is an enlarged graph of the height above the floor at which the shadow ray
// starts; between the graph's two orange lines, this height is less than the threshold. The height is never below the
// dashed line, a lower bound that follows from the angle of the ray.
#include "figure.glsl"
#include "march.glsl"

uniform vec2 eye;           // (-1.1, 0.85) handle: where the rays start
uniform vec2 ball;          // (0.75, 0.5) handle: centre of a ball
uniform float shadowOffset; // 0.5 in [0, 1.5] step 0.05, times the threshold: start of a shadow ray above the hit

const float FLOOR = 0.0, AXIS = -0.9, ONE = 0.34, THRESHOLD = 0.003; // ONE: height of one threshold in the graph

float sceneDistance(vec3 p)
{
    return min(p.y - FLOOR, sdCircle(p.xy - ball, 0.17));
}

// March from the eye towards the floor at x. Returns the height, in thresholds, at which the march ends, and 1 if the
// march ends at the floor or 0 if it does not.
vec2 heightAt(float x)
{
    vec2 way = vec2(x, FLOOR) - eye;
    Hit hit = march(Ray(vec3(eye, 0.0), vec3(normalize(way), 0.0)), 0.0, 9.0, THRESHOLD, 90);
    float height = eye.y + hit.t * normalize(way).y - FLOOR;
    return vec2(height / THRESHOLD, hit.found && height < 1.01 * THRESHOLD ? 1.0 : 0.0);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), found = heightAt(p.x);
    float start = found.x + shadowOffset, y = p.y - AXIS, steepness = (eye.y - FLOOR) / length(eye - vec2(p.x, FLOOR));
    if (p.y > FLOOR - 0.1) {
        float way = (eye.y - p.y) / max(eye.y - FLOOR, 1e-3); // the ray through p meets the floor at foot
        float foot = eye.x + (p.x - eye.x) / max(way, 1e-3), near = 0.2 * clamp(floor(foot / 0.2 + 0.5), -9.0, 9.0);
        if (heightAt(near).y > 0.5 && p.y < eye.y)
            line2(p, eye, vec2(near, FLOOR), 1.0, PALE);
        float solid = sdCircle(p - ball, 0.17);
        fill(solid, SAND, 1.0);
        stroke(solid, 2.0, ORANGE);
        fill(p.y - FLOOR, found.y > 0.5 ? (start < 1.0 ? NIGHT : SAND) : PAPER, 1.0);
        line2(p, vec2(-1.9, FLOOR), vec2(1.9, FLOOR), 2.0, ORANGE);
        dot2(p, eye, 10.0, INK);
    } else {
        fill(max(y - ONE, -y), SAND, 1.0);
        if (found.y > 0.5)
            fill(max(y - ONE * start, -y), start < 1.0 ? NIGHT : SKY, 1.0);
        float envelope = 1.0 - steepness + shadowOffset;
        if (mod(p.x, 0.08) < 0.05)
            fill(abs(y - ONE * envelope) - penWidth(0.8), BLUE, 1.0);
        line2(p, vec2(-1.9, AXIS + ONE), vec2(1.9, AXIS + ONE), 1.5, ORANGE);
        line2(p, vec2(-1.9, AXIS), vec2(1.9, AXIS), 1.5, ORANGE);
    }
    return sheetColour;
}
