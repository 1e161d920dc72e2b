// Why a matt surface looks the same from all sides: drag the eye. The patch sends less flux at a grazing angle, as the
// orange arrow shows, which ends on the sand-coloured disc. Seen from the eye, the patch is also narrower, as the blue
// bar shows. The ratio of the two numbers, at the top left, is the radiance, which does not change.
#include "figure.glsl"
#include "lighting.glsl"

uniform vec2 eye; // (0.95, 0.35) handle: where the patch is seen from

const vec2 CENTRE = vec2(0.0, -0.7);
const float HALF = 0.4, LOBE = 1.1; // half the patch's width, and the length of an arrow straight up

float sceneDistance(vec3 p)
{
    return p.z;
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), away = normalize(eye - CENTRE + 1e-6), beside = vec2(away.y, -away.x);
    float flux = lambert(vec3(0.0, 1.0, 0.0), vec3(away, 0.0)); // flux in the direction of the eye
    float seen = max(dot(beside, vec2(1.0, 0.0)), 0.0);         // apparent width of the patch, relative to its width
    float lobe = sdCircle(p - CENTRE - vec2(0.0, 0.5 * LOBE), 0.5 * LOBE);
    fill(lobe, SAND, 0.6);
    stroke(lobe, 1.2, ORANGE);
    vec2 left = CENTRE - vec2(HALF, 0.0), right = CENTRE + vec2(HALF, 0.0), bar = CENTRE + 1.2 * away;
    if (seen > 0.0) {
        dashes(p, left, bar - HALF * seen * beside, 1.2, BLUE);
        dashes(p, right, bar + HALF * seen * beside, 1.2, BLUE);
        line2(p, bar - HALF * seen * beside, bar + HALF * seen * beside, 3.5, BLUE);
        arrow(p, CENTRE, CENTRE + LOBE * flux * away, 3.0, ORANGE);
    }
    line2(p, left, right, 6.0, INK);
    line2(p, left, right, 3.0, SAND);
    dot2(p, eye, 10.0, INK);
    number(p, CENTRE + 0.6 * LOBE * flux * away - 0.14 * beside, flux, 2, ORANGE); // # | flux #
    number(p, bar + (HALF * seen + 0.16) * beside, seen, 2, BLUE); // # | apparent width #
    number(p, vec2(-1.5, 0.8), seen > 0.0 ? flux / seen : 0.0, 2, TEAL); // radiance #
    return sheetColour;
}
