// The sky that a point sees: drag the ball, and the end of the surface's normal. Blue is open and orange is hidden,
// both along the semicircle above the surface and where this semicircle is projected straight down onto the surface. On
// the right is the projection of the whole hemisphere, a disc, seen along the normal. The number is the openness, the
// blue share of the disc.
#include "figure.glsl"
#include "occlusion.glsl"

uniform vec2 ball;    // (-0.1, 0.36) handle: centre of the ball
uniform vec2 normal;  // (-0.7, 0.1) handle: where the normal of the surface points
uniform float radius; // 0.33 in [0.02, 0.8] step 0.01, units: radius of the ball

const vec2 POINT = vec2(-0.7, -0.42);
const float DOME = 0.75; // radius of the semicircle

float sceneDistance(vec3 p)
{
    return sdCircle(p.xy - ball, radius);
}

// The distance from q to an arc of the semicircle: from the angle low to the angle high, measured from the normal.
float arcBetween(vec2 q, float low, float high)
{
    float middle = 0.5 * (low + high), c = cos(middle), s = sin(middle);
    return sdArc(vec2(c * q.x - s * q.y, s * q.x + c * q.y), DOME, max(0.5 * (high - low), 1e-4));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), up = normalize(normal - POINT + 1e-6), along = vec2(up.y, -up.x), eyes = vec2(1.16, 0.06);
    vec2 q = vec2(dot(p - POINT, along), dot(p - POINT, up)), toBall = ball - POINT; // q: along and above the surface
    float far = length(toBall), beta = far > radius ? arcSine(radius / far) : PI;
    float theta = atan(dot(toBall, along), dot(toBall, up) + 1e-6); // angle of the ball's centre from the normal
    float low = clamp(theta - beta, -0.5 * PI, 0.5 * PI), high = clamp(theta + beta, -0.5 * PI, 0.5 * PI);

    if (p.x < 0.52) {
        fill(q.y, PALE, 0.35);
        fill(max(length(q) - DOME, -q.y), SKY, 0.6);
        fill(sceneDistance(vec3(p, 0.0)), SAND, 1.0);
        stroke(sceneDistance(vec3(p, 0.0)), 2.0, ORANGE);
        stroke(arcBetween(q, -0.5 * PI, 0.5 * PI), 2.0, BLUE);
        line2(q, vec2(-2.0, 0.0), vec2(2.0, 0.0), 2.0, INK);
        line2(q, vec2(-DOME, 0.0), vec2(DOME, 0.0), 5.0, BLUE);
        if (high > low) {
            stroke(arcBetween(q, low, high), 5.0, ORANGE);
            line2(q, vec2(DOME * sin(low), 0.0), vec2(DOME * sin(high), 0.0), 5.0, ORANGE);
            dashes(q, DOME * vec2(sin(low), cos(low)), vec2(DOME * sin(low), 0.0), 1.2, ORANGE);
            dashes(q, DOME * vec2(sin(high), cos(high)), vec2(DOME * sin(high), 0.0), 1.2, ORANGE);
            dashes(q, vec2(0.0), far * cos(beta) * vec2(sin(low), cos(low)), 1.0, INK);
            dashes(q, vec2(0.0), far * cos(beta) * vec2(sin(high), cos(high)), 1.0, INK);
        }
        arrow(p, POINT, POINT + 0.3 * up, 2.0, INK);
        dot2(p, POINT, 9.0, INK);
    }

    // The disc. w is the direction in the hemisphere above a point of the disc. The ball hides w if the angle between w
    // and the direction to the ball's centre is less than beta.
    float size = 0.5, height;
    vec2 disc = (p - eyes) / size;
    vec3 w = vec3(disc, sqrt(max(1.0 - dot(disc, disc), 1e-4)));
    float over = cos(beta) - (w.x * sin(theta) + w.z * cos(theta));
    vec2 slope = vec2(sin(theta) - cos(theta) * w.x / w.z, -cos(theta) * w.y / w.z);
    float hidden = max(size * over / max(length(slope), 1e-3), size * (length(disc) - 1.0));
    fill(length(p - eyes) - size, SKY, 1.0);
    fill(hidden, SAND, 1.0);
    stroke(hidden, 2.0, ORANGE);
    stroke(length(p - eyes) - size, 2.0, BLUE);
    dot2(p, eyes, 7.0, INK);
    float open = 1.0 - (far > radius ? hiddenByBall(vec3(POINT, 0.0), vec3(up, 0.0), vec3(ball, 0.0), radius) : 1.0);
    number(p, eyes - vec2(0.0, 0.66), open, 3, INK); // openness #
    return sheetColour;
}
