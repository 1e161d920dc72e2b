// Lambert's law: drag the end of the patch to tilt it. The upper number is the count of rays that the patch catches;
// the lower number is N . L, the cosine of the angle between the patch's normal (green) and the direction to the light
// (orange). The disc shows how bright the patch is.
#include "figure.glsl"
#include "lighting.glsl"

uniform vec2 tip; // (-0.135, 0.346) handle: sets the direction of the patch

const vec2 CENTRE = vec2(-0.45, -0.2);
const float HALF = 0.63, SPACING = 0.105; // half the patch's width, and the distance between neighbouring rays

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), along = normalize(tip - CENTRE + 1e-6), normal = vec2(-along.y, along.x);
    float cosine = lambert(vec3(normal, 0.0), vec3(0.0, 1.0, 0.0));
    float k = clamp(floor((p.x - CENTRE.x) / SPACING), -9.0, 8.0), x = (k + 0.5) * SPACING; // the nearest ray
    float meets = x / (abs(along.x) > 1e-3 ? along.x : 1e-3); // position along the patch where the ray meets it
    bool stops = abs(meets) < HALF, lit = stops && normal.y > 0.0;
    float end = stops ? CENTRE.y + meets * along.y : -0.9;
    vec2 from = vec2(CENTRE.x + x, 0.92), to = vec2(CENTRE.x + x, end);
    arrow(p, from, to, 1.2, lit ? ORANGE : PALE);
    line2(p, CENTRE - HALF * along, CENTRE + HALF * along, 6.0, INK);
    line2(p, CENTRE - HALF * along, CENTRE + HALF * along, 3.0, SAND);
    vec2 q = p - CENTRE, middle = normalize(normal + vec2(1e-6, 1.0)); // halfway between the normal and the light
    vec2 turned = vec2(dot(q, vec2(middle.y, -middle.x)), dot(q, middle));
    fill(sdArc(turned, 0.2, 0.5 * angleBetween(normal, vec2(0.0, 1.0)) + 1e-3) - penWidth(0.8), INK, 1.0);
    arrow(p, CENTRE, CENTRE + 0.42 * normal, 2.5, TEAL);
    arrow(p, CENTRE, CENTRE + vec2(0.0, 0.42), 2.5, ORANGE);
    float caught = 0.0;
    for (int i = -9; i < 9; i++)
        caught += abs((float(i) + 0.5) * SPACING) < HALF * normal.y ? 1.0 : 0.0;
    float disc = sdCircle(p - vec2(1.15, -0.1), 0.36);
    fill(disc, encodeSRGB(cosine * vec3(1.0, 0.93, 0.8)), 1.0);
    stroke(disc, 1.5, INK);
    number(p, vec2(1.15, 0.72), caught, 0, ORANGE); // # ray(s)
    number(p, vec2(1.15, 0.5), cosine, 2, TEAL); // N · L = #
    return sheetColour;
}

float sceneDistance(vec3 p)
{
    return p.z;
}
