// A picture projected onto a stone like a slide: drag the projector around the stone. Where the surface faces the
// projector, the stripes are as wide as on the slide; where the surface turns away, they are stretched. Drag the point
// along the outline: the number is the factor by which the stripes are stretched there. With two projections, each
// dominates where the surface faces it.
#include "figure.glsl"
#include "texture.glsl" // planeWeights

uniform vec2 projector;   // (-0.26, 0.7) handle units: where the light comes from
uniform vec2 point;       // (0.5, 0.12) handle units: a point on the outline
uniform int projections;  // 1 in [1, 2]: 2 adds one from the side
uniform float sharpness;  // 6 in [1, 30] step *1.2: how narrow the transition between the projections is

float sceneDistance(vec3 p)
{
    vec2 q = mat2(0.96, -0.28, 0.28, 0.96) * p.xy + vec2(-0.05, -0.03);
    float slab = sdRectangle(q + vec2(0.15, 0.14), vec2(0.38, 0.14)), knob = sdCircle(q - vec2(0.2, 0.04), 0.17);
    return opRound(opSmoothUnion(slab, knob, 0.3), 0.12);
}

vec2 normalOf(vec2 p)
{
    const vec2 H = vec2(0.002, 0.0);
    return normalize(vec2(sceneDistance(vec3(p + H.xy, 0.0)) - sceneDistance(vec3(p - H.xy, 0.0)),
                          sceneDistance(vec3(p + H.yx, 0.0)) - sceneDistance(vec3(p - H.yx, 0.0))) + 1e-7);
}

vec3 stripesAt(float across, vec3 dark, vec3 pale)
{
    return mix(pale, dark, stripes(across / 0.1, 0.5, sheetPixel() / 0.1));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), to = normalize(projector + 1e-6), beside = vec2(-to.y, to.x);
    float d = sceneDistance(vec3(p, 0.0)), across = dot(p, beside);
    vec2 slide = vec2(across, dot(p, to) - length(projector)); // across the light and along it

    // The light, and the slide in front of it.
    if (slide.y < 0.0 && abs(across) < 0.65 && dot(p, to) > 0.0)
        fill(abs(fract(across / 0.1) - 0.25) * 0.1 - penWidth(0.4), PALE, 0.6);
    vec2 n = normalOf(p), facing = abs(vec2(dot(n, to), dot(n, beside)));
    vec3 weights = projections == 2 ? planeWeights(vec3(facing, 0.0), sharpness) : vec3(1.0, 0.0, 0.0);
    vec3 picture = weights.x * stripesAt(across, INK, SKY) + weights.y * stripesAt(dot(p, to), ORANGE, SAND);
    fill(d, mix(PAPER, SAND, 0.5), 1.0);
    fill(abs(d + 0.05) - 0.05, picture, 1.0);
    stroke(d, 1.5, INK);
    fill(sdRectangle(slide, vec2(0.65, 0.03)), stripesAt(across, INK, SKY), 1.0);
    stroke(sdRectangle(slide, vec2(0.65, 0.03)), 1.2, INK);

    // The factor by which the picture is stretched at the point.
    vec2 at = point;
    for (int i = 0; i < 4; i++)
        at -= sceneDistance(vec3(at, 0.0)) * normalOf(at);
    vec2 normal = normalOf(at);
    arrow(p, at, at + 0.28 * normal, 2.0, TEAL);
    dot2(p, at, 8.0, TEAL);
    number(p, at + 0.38 * normal, min(1.0 / max(abs(dot(normal, to)), 1e-3), 99.0), 1, TEAL); // × #
    return sheetColour;
}
