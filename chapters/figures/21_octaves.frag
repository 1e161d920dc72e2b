// What a pixel leaves out: drag the right end of the pixel. Below is the land of chapter 21, with all octaves as a
// line, and with the octaves that fit this pixel in colour; above are the cells of each octave, the coarsest at the
// top, and those that fit are green. The numbers are the width of the pixel in units of 100 metres, and the number of
// octaves that fit the pixel.
#include "figure.glsl"
#include "valley.glsl"

uniform vec2 pixel; // (-1.33, 0.3) handle: the right end of the pixel

const float LEFT = -1.6, UNITS = 4.0, ALL = 8.0; // left end of the pixel; scene units per sheet unit; octaves drawn

float sceneDistance(vec3 p)
{
    return p.z;
}

// The distance, on the sheet, to the land with count octaves, drawn at three fifths of its height.
float landAbove(vec2 p, float count)
{
    vec4 land = landAt(vec2(1.0 + UNITS * p.x, 41.0), count);
    float slope = 0.6 * land.y;
    return (p.y + 0.5 - 0.6 * (land.x - 9.6) / UNITS) * inversesqrt(1.0 + slope * slope);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    float end = max(pixel.x, LEFT + 0.01), width = UNITS * (end - LEFT);
    float fit = clamp(log(1.2 / (CELLS * width)) / log(LACUNARITY), 0.0, ALL);
    float above = landAbove(p, fit);
    fill(above, SAND, 1.0);
    stroke(above, 2.0, ORANGE);
    stroke(landAbove(p, ALL), 1.0, INK);

    // The pixels, and the cells of the octaves.
    float edge = (p.x - LEFT) / (end - LEFT), nearest = LEFT + (end - LEFT) * floor(edge + 0.5);
    line2(p, vec2(nearest, -1.0), vec2(nearest, -0.94), 1.0, INK);
    float row = floor((0.86 - p.y) / 0.06), cell = 1.0 / (CELLS * pow(LACUNARITY, row) * UNITS);
    if (row >= 0.0 && row < ALL) {
        float share = clamp(fit - row, 0.0, 1.0), x = fract((p.x - LEFT) / cell);
        float gap = min(max(cell * (abs(x - 0.5) - 0.5) + 0.3 * min(cell, 0.02), abs(p.y - 0.83 + 0.06 * row) - 0.022), 1.0);
        fill(max(gap, LEFT - p.x), mix(mix(PAPER, PALE, 0.5), TEAL, share), 1.0);
    }
    dashes(p, vec2(LEFT, 0.4), vec2(LEFT, -1.0), 1.0, BLUE);
    dashes(p, vec2(end, 0.4), vec2(end, -1.0), 1.0, BLUE);
    line2(p, vec2(LEFT, pixel.y), vec2(end, pixel.y), 4.0, BLUE);
    dot2(p, vec2(end, pixel.y), 9.0, BLUE);
    number(p, vec2(max(end, LEFT + 0.2) + 0.2, pixel.y), width, 2, BLUE); // # | pixel width #
    number(p, vec2(1.6, 0.93), fit, 1, TEAL); // # octave(s) fit
    return sheetColour;
}
