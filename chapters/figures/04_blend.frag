// The smooth union of a block and a disc: drag them, and change the width k of the blend. The thin dark lines are the
// outlines of the block and the disc, the thick dark line is the outline of the union, and the pale lines connect
// points at equal distances. The colours are mixed with the same weights as the gradients.
#include "figure.glsl"
#include "hue.glsl"
#include "lighting.glsl"

uniform vec2  disc;  // (0.55, 0.2) handle units: centre of the disc
uniform vec2  block; // (-0.4, -0.3) handle units: centre of the block
uniform float blend; // 0.6 in [0.01, 1.5] step 0.05, units: width k of the blend

float blockDistance(vec2 p)
{
    return sdRectangle(p - block, vec2(0.6, 0.35));
}

float discDistance(vec2 p)
{
    return sdCircle(p - disc, 0.4);
}

float sceneDistance(vec3 p)
{
    return opSmoothUnion(blockDistance(p.xy), discDistance(p.xy), blend);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    float d = sceneDistance(vec3(p, 0.0)), share = smoothUnionShare(blockDistance(p), discDistance(p), blend);
    vec3 mixture = mix(hsvToRGB(255.0, 0.6, 0.8), hsvToRGB(12.0, 0.85, 0.9), share);
    contours(d, 0.1, 0.8, PALE);
    fill(d, encodeSRGB(mixture), 1.0);
    stroke(blockDistance(p), 1.0, INK);
    stroke(discDistance(p), 1.0, INK);
    stroke(d, 2.5, INK);
    dot2(p, block, 7.0, INK);
    dot2(p, disc, 7.0, INK);
    return sheetColour;
}
