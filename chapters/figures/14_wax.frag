// Through wax: drag the lamp, the drop and the point. Every point in the wax has the colour of the light that reaches
// it straight from the lamp. For the point that is dragged, the number is the length of the light's path inside the
// wax, and the patch on the right shows the light that remains.
#include "figure.glsl"
#include "lighting.glsl"
#include "thickness.glsl"

uniform vec2 lamp;   // (-1.3, 0.62) handle: the lamp
uniform vec2 drop;   // (0.35, 0.2) handle: centre of the drop
uniform vec2 spot;   // (-0.02, -0.46) handle: the point
uniform float depth; // 0.42 in [0.05, 2] step *1.1, units: path after which 0.37 of the red light is left

float sceneDistance(vec3 p)
{
    float candle = sdRectangle(p.xy - vec2(-0.3, -0.62), vec2(0.42, 0.5)) - 0.06;
    return opSmoothUnion(candle, sdCircle(p.xy - drop, 0.3), 0.35);
}

// The length of the path from q to the lamp inside the wax that contains q.
float wayFrom(vec2 q)
{
    vec2 toLamp = lamp - q;
    return thicknessAlong(Ray(vec3(q, 0.0), vec3(normalize(toLamp + 1e-6), 0.0)), length(toLamp), 0.004, 48);
}

// The white light that remains after a path, encoded for the screen: less of green and blue than of red, as in the
// experiment 14_wax.frag.
vec3 leftAfter(float way)
{
    return encodeSRGB(lightThrough(way, depth * vec3(1.0, 0.476, 0.202)));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), patch2 = vec2(1.35, 0.0), toLamp = normalize(lamp - spot + 1e-6);
    float d = sceneDistance(vec3(p, 0.0)), way = wayFrom(spot);
    sheetColour = 0.7 * NIGHT;
    if (d < 0.02)
        fill(d, leftAfter(wayFrom(p)), 1.0);
    stroke(d, 2.0, ORANGE);

    dashes(p, spot, lamp, 1.4, PALE);
    line2(p, spot, spot + (way + 1e-4) * toLamp, 3.0, CHALK);
    dot2(p, spot, 11.0, CHALK);
    dot2(p, spot, 7.0, ORANGE);
    dot2(p, lamp, 18.0, CHALK);
    float square = sdRectangle(p - patch2, vec2(0.2));
    fill(square, leftAfter(way), 1.0);
    stroke(square, 1.5, PALE);
    number(p, patch2 - vec2(0.0, 0.32), way, 2, CHALK); // path #
    return sheetColour;
}
