// Paths through a room with one window, in the plane: drag the eye, the point at which it looks, and the egg. The first
// ray meets a surface; from there, each path goes on in a random direction, again and again. A path that leaves
// through the window on the left has found light, and is blue. The number counts these paths.
#include "figure.glsl"
#include "random.glsl"

uniform vec2 eye;    // (0.85, 0.5) handle: the eye
uniform vec2 target; // (0.24, -0.42) handle: the point at which the eye looks
uniform vec2 egg;    // (0.3, -0.62) handle: centre of the egg
uniform int paths;   // 8 in [1, 16]: number of paths
uniform int most;    // 4 in [0, 8]: how often a path may bounce
uniform int seed;    // 3 in [0, 100]: other random numbers

const vec2 ROOM = vec2(1.5, 0.8), WINDOW = vec2(-0.05, 0.55); // half the room's size; the window, from y to y
const float EGG = 0.18;

float sceneDistance(vec3 p)
{
    vec2 inside = ROOM - abs(p.xy);
    return min(min(inside.x, inside.y), length(p.xy - egg) - EGG);
}

// Where a ray from inside meets the walls or the egg.
//   normal  of the surface there
float reached(vec2 from, vec2 way, out vec2 normal)
{
    vec2 onward = vec2(way.x < 0.0 ? -1.0 : 1.0, way.y < 0.0 ? -1.0 : 1.0), t = (onward * ROOM - from) / (way + 1e-6 * onward);
    normal = t.x < t.y ? vec2(-onward.x, 0.0) : vec2(0.0, -onward.y);
    float wall = min(t.x, t.y), along = dot(egg - from, way), root = EGG * EGG - dot(egg - from, egg - from) + along * along;
    if (root <= 0.0 || along - sqrt(root) < 1e-3 || along - sqrt(root) > wall)
        return wall;
    normal = normalize(from + (along - sqrt(root)) * way - egg);
    return along - sqrt(root);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), normal, first = normalize(target - eye + 1e-6);
    vec2 start = eye + reached(eye, first, normal) * first, startNormal = normal;
    fill(max(abs(p.x) - ROOM.x, abs(p.y) - ROOM.y), SAND, 0.5);
    fill(length(p - egg) - EGG, CHALK, 1.0);
    float found = 0.0;
    for (int i = 0; i < paths; i++) {
        float nearest = 1e6;
        vec2 from = start;
        bool left = false;
        normal = startNormal;
        for (int k = 0; k < most + 1; k++) {
            // In the plane, a lot in [-1, 1] is the sine of the angle to the normal.
            float lot = 2.0 * float(hashOf(uvec4(i, k, seed, 24)).x >> 8u) / 16777216.0 - 1.0;
            vec2 way = lot * vec2(-normal.y, normal.x) + sqrt(1.0 - lot * lot) * normal, here = from + 1e-3 * normal;
            vec2 to = here + reached(here, way, normal) * way;
            nearest = min(nearest, sdSegment(p, from, to + 1e-6));
            left = to.x < -ROOM.x + 1e-3 && to.y > WINDOW.x && to.y < WINDOW.y;
            from = to;
            if (left)
                break;
        }
        found += left ? 1.0 : 0.0;
        fill(nearest - penWidth(left ? 1.1 : 0.6), left ? BLUE : PALE, 1.0);
    }
    stroke(max(abs(p.x) - ROOM.x, abs(p.y) - ROOM.y), 4.0, INK);
    line2(p, vec2(-ROOM.x, WINDOW.x), vec2(-ROOM.x, WINDOW.y), 7.0, SKY);
    stroke(length(p - egg) - EGG, 2.0, INK);
    line2(p, eye, start, 2.0, ORANGE);
    dot2(p, eye, 10.0, ORANGE);
    dot2(p, start, 8.0, INK);
    number(p, vec2(0.0, -0.91), found, 0, BLUE); // # path(s) reach the window
    return sheetColour;
}
