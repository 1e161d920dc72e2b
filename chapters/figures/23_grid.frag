// A stored distance: drag the disc and the plate. The orange outline is the true one. On the blue outline, the distance
// interpolated between the dots is 0.
#include "figure.glsl"

uniform vec2  disc;  // (-0.55, 0.1) handle: centre of the disc
uniform vec2  plate; // (0.75, 0.05) handle: centre of the plate
uniform float thin;  // 0.06 in [0.01, 0.3] step 0.01: half the thickness of the plate
uniform float cell;  // 0.2 in [0.05, 0.5] step 0.01: side of a cell

float trueDistance(vec2 p)
{
    return min(sdCircle(p - disc, 0.4), sdRectangle(p - plate, vec2(thin, 0.5)));
}

// Bilinear interpolation in the cell of p.
float sceneDistance(vec3 p)
{
    vec2 low = floor(p.xy / cell), share = p.xy / cell - low;
    vec2 below = vec2(trueDistance(cell * low), trueDistance(cell * (low + vec2(1.0, 0.0))));
    vec2 above = vec2(trueDistance(cell * (low + vec2(0.0, 1.0))), trueDistance(cell * (low + 1.0)));
    vec2 line = mix(below, above, share.y);
    return mix(line.x, line.y, share.x);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    float stored = sceneDistance(vec3(p, 0.0));
    fill(stored, SAND, 1.0);
    contours(stored, 0.1, 1.0, SKY);
    stroke(trueDistance(p), 2.0, ORANGE);
    stroke(stored, 2.4, BLUE);
    vec2 point = cell * floor(p / cell + 0.5);
    dot2(p, point, 4.0, trueDistance(point) < 0.0 ? ORANGE : PALE);
    return sheetColour;
}
