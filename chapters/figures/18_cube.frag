// Skybox and skydome: the sky on the upper half of a cube, unfolded, and on a dome. The zenith is at both centres, the
// horizon at the rims, and the lines join points of equal height, 10 degrees apart. Drag the blue point along an edge
// of the cube: the number, the point's height, is 45 degrees in the middle of the edge and 35.3 degrees at both ends.
// The point on the dome is in the same direction.
#include "figure.glsl"

uniform vec2 point; // (-0.88, 0.4) handle: a point on the cube

const vec2  LEFT = vec2(-0.88, 0.0), RIGHT = vec2(0.88, 0.0);
const float HALF_SIDE = 0.4, RIM = 0.8; // half side of the cube; radius of the horizon

float sceneDistance(vec3 p)
{
    return p.z;
}

// The direction of a position on the net: on the lid, x and y are at most 1; each flap continues to 2, the horizon.
vec3 cubeDirection(vec2 local)
{
    vec2 side = abs(local);
    float up = min(2.0 - max(side.x, side.y), 1.0);
    return normalize(vec3(clamp(local, -1.0, 1.0), up).xzy);
}

// The direction of a position on the dome: equal angles are equal lengths.
vec3 domeDirection(vec2 local)
{
    float angle = 1.5707963 / RIM * length(local);
    return vec3(normalize(local + 1e-6) * sin(angle), cos(angle)).xzy;
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), local = (p - LEFT) / HALF_SIDE;
    bool left = p.x < 0.0;
    vec3 up = left ? cubeDirection(local) : domeDirection(p - RIGHT);
    float height = atan(up.y, length(up.xz));
    float net = min(sdRectangle(local, vec2(2.0, 1.0)), sdRectangle(local, vec2(1.0, 2.0))) * HALF_SIDE;
    float shape = left ? net : length(p - RIGHT) - RIM;
    vec3 outside = sheetColour;
    fill(shape, mix(SAND, BLUE, smoothstep(-0.15, 1.5, height)), 1.0);
    contours((left ? HALF_SIDE : RIM / 1.5707963) * height, (left ? HALF_SIDE : RIM / 1.5707963) * radians(10.0), 1.0, INK);
    sheetColour = mix(outside, sheetColour, coverage(-shape / sheetPixel(), 1.0));
    stroke(shape, 2.0, INK);
    if (left)
        stroke(sdRectangle(local, vec2(1.0)) * HALF_SIDE, 2.0, ORANGE);

    // The point, confined to the net, and the point in the same direction on the dome.
    vec2 at = clamp((point - LEFT) / HALF_SIDE, -2.0, 2.0);
    at = min(abs(at.x), abs(at.y)) > 1.0 ? clamp(at, -1.0, 1.0) : at;
    vec3 direction = cubeDirection(at);
    float angle = atan(length(direction.xz), direction.y);
    vec2 there = RIGHT + RIM / 1.5707963 * angle * normalize(direction.xz + 1e-6);
    dot2(p, LEFT + HALF_SIDE * at, 11.0, PAPER);
    dot2(p, LEFT + HALF_SIDE * at, 9.0, BLUE);
    dot2(p, there, 11.0, PAPER);
    dot2(p, there, 9.0, BLUE);
    number(p, vec2(0.0, 0.9), 90.0 - degrees(angle), 1, INK); // height #°
    return sheetColour;
}
