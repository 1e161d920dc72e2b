// Longer steps: drag the eye, the point it is aimed at, and the post. Blue circles are known to be free; an orange
// circle left a gap, so the march went back. At the top left are the numbers of evaluations of this march and, in blue,
// of the plain march.
#include "figure.glsl"

uniform vec2 eye;    // (-1.55, -0.2) handle: where the ray starts
uniform vec2 aim;    // (0.4, -0.3) handle: where the ray points
uniform vec2 post;   // (1.25, -0.3) handle: centre of the post
uniform float omega; // 1.6 in [1, 1.95] step 0.05, distances: length of a step; 1 is the plain march

const float THRESHOLD = 0.004, FAR = 3.6;

float sceneDistance(vec3 p)
{
    float ground = sdRectangle(p.xy - vec2(0.0, -1.6), vec2(3.0, 1.0));
    float standing = min(sdRectangle(p.xy - post, vec2(0.03, 0.3)), sdCircle(p.xy - vec2(-0.2, 0.62), 0.22));
    return min(ground, standing);
}

// The number of evaluations of a march with plain steps.
int plainCount(vec2 direction)
{
    int count = 0;
    float t = 0.0, d = 1.0;
    for (int i = 0; i < 99 && t < FAR && d > THRESHOLD; i++) {
        d = sceneDistance(vec3(eye + t * direction, 0.0));
        t += max(d, 0.0);
        count++;
    }
    return count;
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), direction = normalize(aim - eye + 1e-6);

    // The loop of marchRelaxed. kept and lost are the distances from p to the circles that count and to the one that
    // does not.
    float t = 0.0, covered = 0.0, before = 1.0, factor = omega, square = 0.5 * THRESHOLD * THRESHOLD;
    float inside = 1e6, kept = 1e6, lost = 1e6, spots = 1e6, lostSpot = 1e6;
    int count = 0;
    bool found = false;
    while (!found && covered < FAR && count < 99) {
        vec2 at = eye + t * direction;
        float d = sceneDistance(vec3(at, 0.0));
        count++;
        float gap = t > covered ? t - d - covered : -1e9;
        found = d < THRESHOLD && gap <= 0.0;
        bool back = !found && gap > -square / before - square / max(d, 1e-9);
        float rim = abs(length(p - at) - abs(d));
        inside = back ? inside : min(inside, length(p - at) - abs(d));
        kept = back ? kept : min(kept, rim);
        lost = back ? min(lost, rim) : lost;
        spots = back ? spots : min(spots, length(p - at));
        lostSpot = back ? length(p - at) : lostSpot;
        factor = back ? 1.0 : factor;
        before = d;
        covered = back || found ? covered : t + d;
        t = back ? covered : (found ? t : min(t + factor * d, FAR));
    }

    fill(inside, SKY, 0.55);
    stroke(kept, 1.2, BLUE);
    float d = sceneDistance(vec3(p, 0.0));
    fill(d, SAND, 1.0);
    stroke(d, 2.0, ORANGE);
    stroke(lost, 1.6, ORANGE);
    dashes(p, eye, eye + FAR * direction, 1.0, PALE);
    line2(p, eye, eye + min(found ? t : covered, FAR) * direction, 6.0, TEAL);
    fill(spots - penWidth(3.0), INK, 1.0);
    fill(lostSpot - penWidth(3.0), ORANGE, 1.0);
    number(p, vec2(-1.58, 0.86), float(count), 0, INK); // # evaluation(s)
    number(p, vec2(-1.58, 0.74), float(plainCount(direction)), 0, BLUE); // plain march #
    return sheetColour;
}
