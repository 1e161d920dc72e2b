// The mirrored world: drag the eye and the end of the ray, and tilt the wave. The march goes straight on through the
// water into the mirrored mountain. Each point of the march there (black) represents a point on the mirrored ray
// (blue), equally far from where the ray meets the water; the distance from that point to the land counts. The green
// line is the ray as level water would mirror it.
#include "figure.glsl"
#include "valley.glsl"

uniform vec2  eye;  // (-1.6, 0.3) handle: the eye
uniform vec2  aim;  // (-0.55, 0.0) handle: where the ray points
uniform float tilt; // 0.04 in [-0.2, 0.2] step 0.01: slope of the water where the ray meets it

// The exact distance to the mountain.
float mountain(vec2 p)
{
    vec2 corner[POLYGON_CORNERS];
    corner[0] = vec2(0.35, -0.02);
    corner[1] = vec2(0.62, 0.17);
    corner[2] = vec2(0.85, 0.28);
    corner[3] = vec2(1.04, 0.66);
    corner[4] = vec2(1.14, 0.6);
    corner[5] = vec2(1.32, 0.86);
    corner[6] = vec2(1.58, 0.3);
    corner[7] = vec2(1.72, -0.02);
    return sdPolygon(p, corner, 8);
}

float sceneDistance(vec3 p)
{
    return mountain(unmirrored(p).xy);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), from = vec2(eye.x, max(eye.y, 0.05)), direction = normalize(aim - from + 1e-6);
    float water = direction.y < 0.0 ? -from.y / direction.y : 8.0, t;
    vec2 on = from + water * direction, level = vec2(direction.x, -direction.y);
    vec2 facet = normalize(vec2(-tilt, 1.0)), mirrored = reflect(direction, facet);
    bend = Bend(true, vec3(on, 0.0), vec3(normalize(vec2(mirrored.x, max(mirrored.y, 0.002))), 0.0));

    fill(p.y, SKY, 0.6);
    float d = mountain(vec2(p.x, abs(p.y)));
    fill(d, p.y > 0.0 ? SAND : mix(SAND, SKY, 0.5), 1.0);
    float inside = 1e6, rim = 1e6, spot = 1e6, image = 1e6, free = 1.0;
    t = 0.0;
    for (int i = 0; i < 30 && t < 4.0 && free > 0.004; i++) {
        vec2 at = from + t * direction, seen = unmirrored(vec3(at, 0.0)).xy;
        free = sceneDistance(vec3(at, 0.0));
        inside = min(inside, length(p - seen) - abs(free));
        rim = min(rim, abs(length(p - seen) - abs(free)));
        spot = min(spot, length(p - at));
        image = t > water ? min(image, length(p - seen)) : image;
        t += free;
    }
    fill(inside, SKY, 0.55);
    stroke(rim, 1.2, BLUE);
    stroke(p.y, 2.0, BLUE);
    stroke(d, p.y > 0.0 ? 2.0 : 1.0, ORANGE);
    if (t > water) {
        vec2 last = from + t * direction, seen = unmirrored(vec3(last, 0.0)).xy;
        line2(p, on, on + (t - water) * level, 2.0, TEAL);
        dashes(p, last, vec2(last.x, -last.y), 1.0, PALE);
        line2(p, on, seen, 2.0, BLUE);
    }
    line2(p, from, from + t * direction, 2.0, INK);
    fill(spot - penWidth(2.5), INK, 1.0);
    fill(image - penWidth(2.5), BLUE, 1.0);
    line2(p, on - 0.14 * vec2(facet.y, -facet.x), on + 0.14 * vec2(facet.y, -facet.x), 5.0, BLUE);
    dot2(p, from, 9.0, INK);
    return sheetColour;
}
