// One ray for a block of pixels: drag the eye, the point it is aimed at, and the ball. The cone continues while it fits
// into the ball of empty space around a point of its axis; where the cone stops, all the rays of its pixels begin.
#include "figure.glsl"

uniform vec2 eye;     // (-1.55, 0.0) handle: where the rays start
uniform vec2 aim;     // (0.5, 0.02) handle: where the cone points
uniform vec2 ball;    // (0.78, -0.33) handle: centre of the ball
uniform float spread; // 0.08 in [0.01, 0.3] step 0.01, units per unit: how fast the cone widens

const float FAR = 3.4, MARGIN = 0.01;

float sceneDistance(vec3 p)
{
    float post = sdRectangle(p.xy - vec2(1.5, 0.0), vec2(0.05, 0.55));
    return min(min(sdCircle(p.xy - ball, 0.25), post), sdCircle(p.xy - vec2(-0.55, 0.55), 0.22));
}

// How far the cone may continue: the largest h with (spread (t + h))^2 + h^2 <= (d - MARGIN)^2, or 0 if there is none.
float stepOfCone(float t, float d)
{
    float empty = d - MARGIN, radius = spread * t;
    float a = 1.0 + spread * spread, b = spread * radius;
    return empty > radius ? (sqrt(max(b * b + a * (empty * empty - radius * radius), 0.0)) - b) / a : 0.0;
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), direction = normalize(aim - eye + 1e-6), beside = vec2(-direction.y, direction.x);
    float inside = 1e6, rim = 1e6, spots = 1e6, t = 0.0, advance = 1.0;
    int count = 0;
    for (int i = 0; i < 32 && advance > 0.001 && t < FAR; i++) {
        vec2 at = eye + t * direction;
        float d = sceneDistance(vec3(at, 0.0));
        inside = min(inside, length(p - at) - abs(d));
        rim = min(rim, abs(length(p - at) - abs(d)));
        spots = min(spots, length(p - at));
        advance = stepOfCone(t, d);
        t += advance;
        count++;
    }
    fill(inside, SKY, 0.55);
    stroke(rim, 1.2, BLUE);
    float d = sceneDistance(vec3(p, 0.0));
    fill(d, SAND, 1.0);
    stroke(d, 2.0, ORANGE);

    // The rays of eight pixels are marched on from the end of the cone, each in separate steps. They are computed only
    // where the rays or their count are shown.
    int rest = 0;
    float lines = 1e6, ends = 1e6;
    bool seen = dot(p - eye, direction) > t - 0.05 || (p.x < -1.4 && p.y > 0.6);
    for (int i = 0; i < (seen ? 8 : 0); i++) {
        vec2 way = normalize(direction + spread * (float(i) - 3.5) / 4.0 * beside);
        float start = t / dot(way, direction), s = start, h = 1.0;
        for (int k = 0; k < 24 && h > MARGIN && s < FAR; k++) {
            h = sceneDistance(vec3(eye + s * way, 0.0));
            s += max(h, 0.0);
            rest++;
        }
        lines = min(lines, sdSegment(p, eye + start * way, eye + (s + 1e-4) * way));
        ends = min(ends, length(p - eye - s * way));
    }
    fill(min(lines - penWidth(0.6), ends - penWidth(1.6)), INK, 1.0);
    vec2 end = eye + t * direction, half2 = spread * t * beside;
    line2(p, eye, end + half2, 2.0, TEAL);
    line2(p, eye, end - half2, 2.0, TEAL);
    line2(p, end - half2, end + half2, 4.0, TEAL);
    fill(spots - penWidth(2.5), INK, 1.0);
    number(p, vec2(-1.58, 0.86), float(count), 0, TEAL); // # step(s), block
    number(p, vec2(-1.58, 0.74), float(rest), 0, INK); // # step(s), ray
    return sheetColour;
}
