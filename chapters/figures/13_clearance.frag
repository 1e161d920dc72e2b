// What one march reveals: drag the point, its ray to the lamp, and the ball beside the ray. At the bottom right are
// three values, in degrees, for the free angle between the ray and the ball: the one from the smallest distance / t
// (teal), the true one (blue), and the one from the lowest crease between two circles (orange).
#include "figure.glsl"

uniform vec2 spot; // (-1.55, -0.3) handle: the point
uniform vec2 aim;  // (1.5, -0.3) handle: where its ray points
uniform vec2 ball; // (-0.05, 0.25) handle: centre of the ball

const float RADIUS = 0.2, FAR = 3.1; // radius of the ball; end of the march

float sceneDistance(vec3 p)
{
    return sdCircle(p.xy - ball, RADIUS);
}

// The end of a line from the point that makes an angle with the ray, on the ball's side.
//   tangent  of this angle
vec2 lineEnd(vec2 direction, vec2 beside, float tangent)
{
    return spot + 3.0 * normalize(direction + min(tangent, 1e3) * beside);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), direction = normalize(aim - spot + 1e-6);
    vec2 beside = vec2(-direction.y, direction.x), toBall = ball - spot;
    beside *= dot(toBall, beside) < 0.0 ? -1.0 : 1.0;

    // The march of clearanceAlong, with its circles. Find the lowest crease, and the step with the smallest
    // distance / t.
    float t = 0.0, before = 1e6, most = 1e6, least = 1e6, rim = 1e6, inside = 1e6, spots = 1e6, d = 1.0;
    vec2 crease = vec2(9.0), step = vec2(0.0);
    for (int i = 0; i < 32 && t < FAR && d > 0.001; i++) {
        vec2 at = spot + t * direction;
        d = sceneDistance(vec3(at, 0.0));
        rim = min(rim, abs(length(p - at) - abs(d)));
        inside = min(inside, length(p - at) - abs(d));
        spots = min(spots, length(p - at));
        float back = 0.5 * d * d / before, along = t - back, height = sqrt(max(d * d - back * back, 0.0));
        if (t > 0.0 && d / t < most) {
            most = d / t;
            step = vec2(t, d);
        }
        if (along > 0.0 && height / along < least) {
            least = height / along;
            crease = spot + along * direction + height * beside;
        }
        before = d;
        t += max(d, 0.0);
    }
    bool hit = d <= 0.001;

    fill(inside, SKY, 0.4);
    stroke(rim, 1.0, BLUE);
    float ballDistance = sceneDistance(vec3(p, 0.0));
    fill(ballDistance, SAND, 1.0);
    stroke(ballDistance, 2.0, ORANGE);
    line2(p, spot, spot + (hit ? t : FAR) * direction, 2.0, INK);
    fill(spots - penWidth(2.5), INK, 1.0);

    // The three angles; all are 0 if the ray itself is blocked.
    float truth = angleBetween(toBall, direction) -
                  arcSine(min(RADIUS / length(toBall), 1.0));
    truth = hit ? 0.0 : truth;
    vec3 angle = degrees(hit ? vec3(0.0) : vec3(arcSine(min(most, 1.0)), truth, atan(least)));
    if (!hit) {
        dashes(p, spot, lineEnd(direction, beside, tan(arcSine(min(most, 0.999)))), 1.6, TEAL);
        line2(p, spot, lineEnd(direction, beside, tan(min(truth, 1.5))), 1.6, BLUE);
        dashes(p, spot, lineEnd(direction, beside, least), 1.6, ORANGE);
        dot2(p, crease, 7.0, ORANGE);
        dot2(p, spot + step.x * direction, 8.0, TEAL);
    }
    dot2(p, spot, 8.0, INK);
    number(p, vec2(1.5, -0.62), angle.x, 1, TEAL); // distance / t: #°
    number(p, vec2(1.5, -0.74), angle.y, 1, BLUE); // true: #°
    number(p, vec2(1.5, -0.86), angle.z, 1, ORANGE); // crease: #°
    return sheetColour;
}
