// A blend of two materials: drag the two discs, and the point along the outline. Where the shares of clay and blue
// glaze are 1 - s and s, the normal is the sum of two arrows with these lengths, one along the normal of each disc. The
// green number is s. If the parameter `numbered` is on, clay is 2 and glaze is 5, and the numbers in between belong to
// neither.
#include "figure.glsl"
#include "lighting.glsl" // encodeSRGB
#include "material.glsl" // Material, mixMaterials

uniform vec2 clay;     // (-0.52, -0.2) handle units: centre of the clay disc
uniform vec2 glaze;    // (0.5, -0.02) handle units: centre of the blue disc
uniform vec2 point;    // (-0.08, 0.18) handle units: a point, moved onto the outline
uniform float blend;   // 0.9 in [0.05, 1.5] step 0.05, units: width of the blend
uniform bool numbered; // false: mix the numbers of the materials, and look the result up in a table

const Material CLAY = Material(vec3(0.69, 0.17, 0.01), vec3(0.04), 0.6);
const Material GLAZE = Material(vec3(0.03, 0.16, 0.53), vec3(0.04), 0.1);

// The distances to the two discs.
vec2 partsAt(vec2 p)
{
    return vec2(sdCircle(p - clay, 0.46), sdCircle(p - glaze, 0.38));
}

float sceneDistance(vec3 p)
{
    vec2 parts = partsAt(p.xy);
    return opSmoothUnion(parts.x, parts.y, blend);
}

float shareAt(vec2 p)
{
    vec2 parts = partsAt(p);
    return smoothUnionShare(parts.x, parts.y, blend);
}

vec3 colourAt(float share)
{
    if (!numbered)
        return encodeSRGB(mixMaterials(CLAY, GLAZE, share).colour);
    int found = int(floor(mix(2.0, 5.0, share) + 0.5)); // 3 and 4 belong to neither disc
    vec3 between = found == 3 ? vec3(0.95) : vec3(0.75, 0.1, 0.6);
    return found == 2 ? encodeSRGB(CLAY.colour) : (found == 5 ? encodeSRGB(GLAZE.colour) : between);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), at = point, normal = vec2(0.0);
    vec2 toClay = normalize(p - clay + 1e-6), toGlaze = normalize(p - glaze + 1e-6);
    // The slope of the union. Lines keep their width because the distance is divided by this slope.
    float slope = max(length(mix(toClay, toGlaze, shareAt(p))), 0.1);
    float d = sceneDistance(vec3(p, 0.0)) / slope, share = 0.0;
    fill(d, colourAt(shareAt(p)), 1.0);
    stroke(length(p - clay) - 0.46, 1.0, PALE);
    stroke(length(p - glaze) - 0.38, 1.0, PALE);
    stroke(d, 2.0, INK);

    for (int i = 0; i < 6; i++) {
        share = shareAt(at);
        normal = mix(normalize(at - clay + 1e-6), normalize(at - glaze + 1e-6), share);
        at -= sceneDistance(vec3(at, 0.0)) * normal / max(dot(normal, normal), 0.05);
    }
    vec2 tip = at + 0.6 * (1.0 - share) * normalize(at - clay + 1e-6);
    arrow(p, at, at + 0.6 * normal, 2.5, INK);
    arrow(p, at, tip, 2.5, ORANGE);
    arrow(p, tip, at + 0.6 * normal, 2.5, BLUE);
    dot2(p, at, 8.0, INK);
    number(p, at + 0.6 * normal + 0.1 * normalize(normal + 1e-6), share, 2, TEAL); // # | share of the glaze #
    return sheetColour;
}
