// How high the land ahead can be: drag the start of a level ray over the mountain. The line for the hills alone
// (orange) begins highest and rises least; the curves for one octave (black), two octaves (green) and all octaves
// (blue) begin lower and rise faster. No curve is ever below the land. Each proved step ends where the ray meets the
// curve of the same colour; the longest step counts, and has a ring. At the bottom are the steps in units of 100
// metres. The sheet is about one such unit wide and five high.
#include "figure.glsl"
#include "valley.glsl"

uniform vec2 start; // (-1.3, -0.06) handle: where the ray starts

const vec2  UNITS = vec2(0.3, 2.4);     // scene units in a unit of the sheet
const vec2  ORIGIN = vec2(36.42, 8.55);  // distance ahead and height in the centre of the sheet
const float ASIDE = -1.979;             // how far right of the eye the cut is: under pixel 300,240 of chapter 21

float sceneDistance(vec3 p)
{
    return p.z;
}

// The highest ground that the first octaves allow at a position: height (x), bound of its slope (y), growth of this
// bound (z).
vec3 highestGround(float ahead, int count)
{
    vec2 q = vec2(ASIDE, ahead), x = CELLS * q + SEED;
    float base = hills(q).x, high = roughness(base, FOOT).x, weight = 1.0 - GAIN, rest = 1.0, sum = 0.0, first = 1.0;
    float steep = 2.0 * VALUE_STRETCH * CELLS, slope = steep, growth = RIDGES * HILL_SLOPE;
    for (int i = 0; i < count; i++) {
        float ridge = ridged(groundNoise(x)).x;
        first = i == 0 ? ridge : first;
        sum += weight * ridge;
        rest = i + 1 < octaves ? rest - weight : 0.0;
        slope += weight * steep;
        weight *= GAIN;
        steep *= LACUNARITY;
        x = LACUNARITY * TURN * x + SHIFT;
    }
    float most = first * (sum + rest);
    return vec3(base + high * most, HILL_SLOPE + growth * most + high * slope, 2.0 * growth * slope);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), q = ORIGIN + UNITS * p, from = ORIGIN + UNITS * start;
    vec4 land = landAt(vec2(ASIDE, q.x), float(octaves));
    float base = hills(vec2(ASIDE, from.x)).x, s = q.x - from.x, flatter = UNITS.x / UNITS.y; // for slopes on the sheet
    vec4 steps = vec4((hillsUnder(from.y, FOOT) - base) / HILL_SLOPE, 0.0, 0.0, 0.0); // the proved steps
    float above = (q.y - land.x) / UNITS.y * inversesqrt(1.0 + land.z * land.z * flatter * flatter);
    fill(above, SAND, 1.0);
    stroke(above, 2.0, ORANGE);
    line2(p, vec2(start.x, -1.0), vec2(start.x, 1.0), 1.0, PALE);
    dashes(p, start, vec2(1.78, start.y), 2.0, INK);
    float climbed = base + HILL_SLOPE * s, rise = HILL_SLOPE * (1.0 + roughness(climbed, FOOT).y) * flatter;
    if (s > 0.0)
        curve((q.y - climbed - roughness(climbed, FOOT).x) / UNITS.y, rise, 2.5, ORANGE);
    for (int i = 1; i <= 3; i++) {
        int count = i < 3 ? min(i, octaves) : octaves;
        vec3 ground = highestGround(from.x, count), colour = i == 1 ? INK : (i == 2 ? TEAL : BLUE);
        steps[i] = wayToClose(from.y - ground.x, ground.y, ground.z);
        if (s > 0.0)
            curve((q.y - ground.x - ground.y * s - 0.5 * ground.z * s * s) / UNITS.y,
                  (ground.y + ground.z * s) * flatter, 2.5, colour);
    }
    float best = max(max(steps.x, steps.y), max(steps.z, steps.w));
    stroke(sdCircle(p - start - vec2(max(best, 0.0) / UNITS.x, 0.0), penWidth(7.0)), 2.0, INK);
    for (int i = 0; i < 4; i++) {
        vec3 colour = i == 0 ? ORANGE : (i == 1 ? INK : (i == 2 ? TEAL : BLUE));
        dot2(p, start + vec2(max(steps[i], 0.0) / UNITS.x, 0.0), 9.0, colour);
        number(p, vec2(0.4 + 0.36 * float(i), -0.9), max(steps[i], 0.0), 2, colour); // # | step #
    }
    dot2(p, start, 9.0, INK);
    return sheetColour;
}
