// A penumbra: drag the point, and the floor with it, the edge of the plate, and the lamp. On the right are the lamp's
// disc as seen from the point, and its visible share; the curve under the floor is this share along the whole floor.
#include "figure.glsl"
#include "soft_shadow.glsl"

uniform vec2 spot;    // (-0.71, -0.5) handle: the point
uniform vec2 edge;    // (-0.55, 0.15) handle: edge of the plate
uniform vec2 lamp;    // (-0.45, 0.84) handle: centre of the lamp
uniform float radius; // 0.3 in [0.02, 0.8] step 0.02, units: radius of the lamp

float sceneDistance(vec3 p)
{
    return p.z;
}

// By how many lamp radii the lamp's centre clears the edge, as seen from q, from -1 to 1.
float clearFrom(vec2 q)
{
    if (q.y >= edge.y || edge.y >= lamp.y)
        return q.y < lamp.y && edge.y < lamp.y ? 1.0 : (q.x > edge.x ? 1.0 : -1.0);
    float hit = q.x + (edge.x - q.x) * (lamp.y - q.y) / (edge.y - q.y);
    return clamp((lamp.x - hit) / radius, -1.0, 1.0);
}

// Draw the line from an end of the lamp past the edge down to the floor.
void limit(vec2 p, float side)
{
    vec2 end = lamp + vec2(side * radius, 0.0);
    line2(p, end, edge + (edge - end) * max(edge.y - spot.y, 0.0) / max(lamp.y - edge.y, 0.01), 1.2, ORANGE);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), eyes = vec2(1.25, 0.3);
    float clear = clearFrom(spot), width = 0.4;
    float field = max(max(p.x - 0.7, spot.y - p.y), p.y - lamp.y);
    fill(max(field, p.y - edge.y), SHADE, 0.75 * (1.0 - discBesideEdge(clearFrom(p))));

    // The floor, and below it the visible share along the floor.
    float share = discBesideEdge(clearFrom(vec2(p.x, spot.y))), base = spot.y - 0.36;
    float next = discBesideEdge(clearFrom(vec2(p.x + 0.01, spot.y)));
    if (p.x < 0.7) {
        fill(max(base - p.y, p.y - base - 0.3 * share), SAND, 1.0);
        curve(p.y - base - 0.3 * share, 30.0 * (next - share), 2.0, TEAL);
    }
    line2(p, vec2(-1.78, spot.y), vec2(0.7, spot.y), 2.0, INK);

    limit(p, -1.0);
    limit(p, 1.0);
    line2(p, vec2(-1.78, edge.y), edge, 5.0, BLUE);
    line2(p, lamp - vec2(radius, 0.0), lamp + vec2(radius, 0.0), 5.0, ORANGE);
    line2(p, spot, lamp - vec2(radius * clear, 0.0), 1.2, INK);
    dot2(p, spot, 9.0, INK);

    // The lamp as seen from the point.
    vec2 q = p - eyes;
    fill(length(q) - width, GLOW, 1.0);
    fill(max(length(q) - width, q.x + width * clear), SKY, 1.0);
    if (length(q) < width)
        line2(q, vec2(-width * clear, -1.0), vec2(-width * clear, 1.0), 2.0, BLUE);
    stroke(length(q) - width, 2.0, q.x < -width * clear ? BLUE : ORANGE);
    number(p, eyes - vec2(0.0, 0.62), discBesideEdge(clear), 2, INK); // visible #
    return sheetColour;
}
