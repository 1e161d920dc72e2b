// Two ways to choose a direction, in the plane: by Lambert's cosine (orange), or by an even choice of a point of the
// window (blue). The farther a curve is from the black point, the more often its way chooses this direction. Drag the
// point and both ends of the window. The numbers are the errors of one ray, divided by the light: of the cosine alone, of
// the window alone, and of one ray of each with weights.
#include "figure.glsl"

uniform vec2 point; // (0.1, -0.55) handle: a point of the floor
uniform vec2 upper; // (-1.3, 0.6) handle: upper end of the window
uniform vec2 lower; // (-1.3, -0.1) handle: lower end of the window

const int PARTS = 400; // of the window, for the integrals
const float SCALE = 0.45; // length of a density of 1, units

float sceneDistance(vec3 p)
{
    return p.z;
}

// The densities of the directions, per radian, from the point to a place on the window: by cosine, by window.
vec2 densities(vec2 place)
{
    vec2 to = place - point, along = upper - lower;
    float far = length(to), across = abs(to.x * along.y - to.y * along.x) / far; // length of the window, seen from the point
    return vec2(0.5 * max(to.y, 0.0) / far, far / max(across, 1e-4));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), q = p - point;
    // The integrals over the window of f, of f^2 / density, and of the weighted ways; f is the cosine.
    float light = 0.0, one = 0.0, two = 0.0;
    vec2 square = vec2(0.0), mean = vec2(0.0);
    for (int i = 0; i < PARTS; i++) {
        vec2 density = densities(mix(lower, upper, (float(i) + 0.5) / float(PARTS)));
        float f = 2.0 * density.x, angle = 1.0 / (density.y * float(PARTS)), weighted = f / max(density.x + density.y, 1e-6);
        light += f * angle;
        one += 2.0 * f * angle;
        two += f * f / density.y * angle;
        mean += weighted * density * angle;
        square += weighted * weighted * density * angle;
    }
    fill(p.y - point.y, PALE, 0.35);
    float far = length(q);
    vec2 there = q / max(far, 1e-4), along = upper - lower, off = lower - point;
    float cross2 = there.x * along.y - there.y * along.x, t = (off.x * along.y - off.y * along.x) / (abs(cross2) > 1e-6 ? cross2 : 1e-6);
    float where = dot(t * there - off, along) / dot(along, along);
    bool seen = t > 0.0 && where > 0.0 && where < 1.0 && there.y > 0.0;
    vec2 here = seen ? densities(point + t * there) : vec2(0.5 * there.y, 0.0);
    fill(max(far - SCALE * here.y, seen ? -1.0 : 1.0), SKY, 1.0);
    stroke(max(far - SCALE * here.y, seen ? -1.0 : 1.0), 1.5, BLUE);
    stroke(max(length(q - vec2(0.0, 0.25 * SCALE)) - 0.25 * SCALE, -q.y), 2.5, ORANGE);
    dashes(p, point, upper, 1.0, INK);
    dashes(p, point, lower, 1.0, INK);
    line2(p, vec2(-2.0, point.y), vec2(2.0, point.y), 2.0, INK);
    line2(p, lower, upper, 6.0, BLUE);
    dot2(p, point, 9.0, INK);
    float variance = square.x + square.y - dot(mean, mean);
    vec3 error = sqrt(max(vec3(one, two, variance) - vec3(light * light, light * light, 0.0), 0.0)) / max(light, 1e-4);
    number(p, vec2(0.9, 0.8), error.x, 2, ORANGE); // cosine #
    number(p, vec2(0.9, 0.66), error.y, 2, BLUE); // window #
    number(p, vec2(0.9, 0.52), error.z, 2, TEAL); // both #
    return sheetColour;
}
