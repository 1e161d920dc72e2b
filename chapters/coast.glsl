// coast.glsl - a lighthouse with its keeper's house on flat rocks in the sea: the scene of chapter 20.
//
// x points north, y up, z east; at the start the camera looks south. One scene unit is 5 metres; the
// sea is y = 0.
#include "bounds.glsl"     // boxInterval, intervalUnion
#include "combine.glsl"    // opUnion, opSmoothUnion
#include "coverage.glsl"   // coverage
#include "primitives.glsl" // sdBox, sdSphere

const vec3 TOWER = vec3(-15.5, 1.5, -6.4);
const vec3 HOUSE = vec3(-16.0, 2.0, -8.9);
const vec3 LANTERN = TOWER + vec3(0.0, 4.95, 0.0); // position of the lamp

// Flat rocks with ledges and clefts: folds of triangle waves, whose total slope is at most 0.7.
float rockDistance(vec3 p)
{
    vec3 fold = abs(fract(vec3(0.47, 0.9, 0.61) * p + 0.21 * p.zxy) - 0.5);
    float cape = max(length(p.xz - vec2(-16.0, -8.6)) - 3.9, p.y - 1.5);
    float hill = max(length(p.xz - vec2(-16.6, -14.4)) - 5.4, p.y - 2.4 + 0.12 * abs(p.z + 15.0));
    float boulder = sdSphere(p - vec3(-13.6, -0.7, -4.9), 1.5);
    float d = opSmoothUnion(opSmoothUnion(cape, hill, 1.4), boulder, 0.6);
    d = opUnion(d, sdSphere(p - vec3(-13.9, -0.6, -2.3), 0.85));
    return (d - 0.2 + fold.x * fold.z + 0.2 * fold.y + 0.2 * fold.z) / 1.9;
}

// A tapered tower, a gallery, a lantern and a roof, all solids of revolution about one axis. Each
// is an intersection, so the distance is a lower bound.
float towerDistance(vec3 p)
{
    float r = length(p.xz - TOWER.xz), y = p.y - TOWER.y;
    float body = max(0.9979 * (r - 0.6 + 0.0636 * (y - 2.2)), abs(y - 2.2) - 2.2);
    float gallery = max(r - 0.68, abs(y - 4.46) - 0.06), lantern = max(r - 0.36, abs(y - 4.9) - 0.4);
    float roof = max(0.7071 * (r + y - 5.76), 5.28 - y);
    return opUnion(opUnion(body, gallery), opUnion(lantern, roof));
}

float houseDistance(vec3 p)
{
    vec3 q = p - HOUSE, side = vec3(abs(q.x), q.y - 0.5, abs(q.z));
    float roof = max(dot(side.xy - vec2(0.8, -0.05), vec2(0.6, 0.8)), max(-side.y, side.z - 1.2));
    float d = opUnion(sdBox(q, vec3(0.7, 0.5, 1.1)), roof);
    return opUnion(d, sdBox(q - vec3(0.1, 1.0, -0.8), vec3(0.14, 0.36, 0.16)));
}

// The distances to rocks, tower and house; the smallest shows which of them a ray has hit.
vec3 coastDistances(vec3 p)
{
    return vec3(rockDistance(p), towerDistance(p), houseDistance(p));
}

// The interval in which a ray can meet the coast: inside a flat box around rocks and house, or a
// slender box around the tower.
vec2 coastInterval(Ray ray)
{
    vec2 rocks = boxInterval(ray, vec3(-22.5, -0.1, -21.0), vec3(-10.8, 3.4, -1.4));
    return intervalUnion(rocks, boxInterval(ray, TOWER - vec3(0.76, 0.5, 0.76), TOWER + vec3(0.76, 5.8, 0.76)));
}

// The material of the coast at a point: its colour, and in w the brightness of a lamp behind the glass.
//   part   from coastDistances
//   tone   noise, in [0, 1)
//   width  of the pixel at p, scene units
vec4 coastColour(vec3 p, vec3 part, vec3 normal, float tone, float width)
{
    const vec3 WHITE = vec3(0.78, 0.75, 0.70), RED = vec3(0.42, 0.05, 0.035), SLATE = vec3(0.14, 0.13, 0.15);
    vec3 q = p - TOWER, r = p - HOUSE;
    float wet = 0.25 + 0.75 * smoothstep(0.0, 0.5, p.y);
    vec3 stone = wet * mix(vec3(0.13, 0.11, 0.10), vec3(0.42, 0.36, 0.30), tone);
    vec3 turf = mix(vec3(0.09, 0.09, 0.03), vec3(0.18, 0.15, 0.06), tone);
    float grown = smoothstep(0.55, 0.85, normal.y) * smoothstep(1.0, 1.5, p.y + 0.5 * tone);
    float band = coverage(0.55 - abs(q.y - 2.6), width) + coverage(q.y - 5.26, width) + coverage(0.12 - abs(q.y - 4.42), width);
    float glass = coverage(0.3 - abs(q.y - 4.92), width);
    float panes = coverage(0.14 - abs(abs(r.z - 0.1) - 0.5), width) * coverage(0.18 - abs(r.y - 0.05), width) * step(0.65, r.x);
    vec4 tower = vec4(mix(mix(WHITE, RED, min(band, 1.0)), vec3(0.05), glass), 6.0 * glass);
    vec4 house = vec4(mix(r.y > 0.47 && r.y < 1.05 ? SLATE : WHITE, vec3(0.03), panes), panes);
    vec4 building = part.y < part.z ? tower : house;
    return part.x < min(part.y, part.z) ? vec4(mix(stone, turf, grown), 0.0) : building;
}
