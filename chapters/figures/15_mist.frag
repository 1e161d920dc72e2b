// Low mist: drag both ends of the ray. The bar above the ray is divided into ten pieces of the same optical depth. The
// numbers are the optical depth of the whole ray, and the share of the light that remains.
#include "figure.glsl"
#include "fog.glsl"

uniform vec2 eye;      // (-1.3, 0.55) handle: the eye
uniform vec2 aim;      // (1.1, -0.55) handle: where its ray ends
uniform float density; // 1.6 in [0, 6] step 0.1, per unit: density of the mist on the ground
uniform float scale;   // 0.4 in [0.05, 5] step *1.1, units: height over which the density falls to 1 / e

const float GROUND = -0.75;
const vec3 MIST = vec3(0.56, 0.66, 0.78);

float sceneDistance(vec3 p)
{
    return p.y - GROUND;
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), from = vec2(eye.x, max(eye.y, GROUND)), to = vec2(aim.x, max(aim.y, GROUND));
    float far = max(length(to - from), 0.01), climb = clamp((to.y - from.y) / far, -1.0, 1.0);
    vec2 way = normalize(to - from + 1e-6), beside = vec2(-way.y, way.x) * (way.x < 0.0 ? -1.0 : 1.0);
    float height = from.y - GROUND, whole = fogDepth(height, climb, far, density, scale);

    // The mist, whose opacity shows its density, and the ground.
    float here = density * exp(-max(p.y - GROUND, 0.0) / scale);
    sheetColour = mix(PAPER, MIST, 1.0 - exp(-0.7 * here));
    fill(p.y - GROUND, SAND, 1.0);
    line2(p, vec2(-1.78, GROUND), vec2(1.78, GROUND), 2.0, ORANGE);

    // The bar shows the colour that a black object at each point of the ray would have, seen through the mist.
    float t = clamp(dot(p - from, way), 0.0, far), off = dot(p - from, beside);
    float depth = fogDepth(height, climb, t, density, scale);
    float band = max(abs(off - 0.11) - 0.05, abs(dot(p - from, way) - 0.5 * far) - 0.5 * far);
    fill(band, INK, 1.0);
    fill(band + penWidth(1.0), mix(MIST, 0.7 * NIGHT, exp(-depth)), 1.0);
    for (int i = 1; i < 10; i++) {
        float mark = inverseFogDepth(height, climb, 0.1 * float(i) * whole, density, scale);
        line2(p, from + mark * way + 0.06 * beside, from + mark * way + 0.16 * beside, 1.2, CHALK);
        dot2(p, from + mark * way, 5.0, INK);
    }
    line2(p, from, to, 2.0, INK);
    dot2(p, from, 10.0, INK);
    dot2(p, to, 10.0, ORANGE);
    number(p, vec2(-1.56, 0.86), whole, 2, INK); // optical depth #
    number(p, vec2(-1.56, 0.74), exp(-whole), 2, BLUE); // light left #
    return sheetColour;
}
