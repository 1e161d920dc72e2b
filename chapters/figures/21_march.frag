// A march over the mountain of chapter 21, in a vertical cut: drag the eye and the end of the ray, and choose the
// bound. Bound 0 is one slope for all the land. Bound 1 is a slope for each position; its balls are empty. Bound 2 is a
// slope for each position and only for this ray; its steps are longer, and its balls are free of land only along the
// ray. The number is the count of steps, at most 60. The sheet is 5 km wide.
#include "figure.glsl"
#include "land.glsl"

uniform vec2 eye;     // (-1.55, 0.55) handle: where the ray starts
uniform vec2 aim;     // (0.3, 0.13) handle: where the ray points
uniform int  bound;   // 1 in [0, 2]: slope: 0 one for all the land, 1 by position, 2 by position and only for this ray
uniform int  octaves; // 2 in [1, 4]: number of octaves of the ridges

const float UNITS = 14.5, ASIDE = -2.0;                    // scene units in a unit of the sheet; where the cut is
const vec2  ORIGIN = vec2(-1.72, -0.6);                    // origin of the scene, on the sheet
const float FOOT = 0.4, RIDGES = 3.6, HILL_SLOPE = 0.45;   // constants of the ridges and the hill, as in valley.glsl
const float CELLS = 0.08, GAIN = 0.42, LACUNARITY = 2.1;   // constants of the octaves, as in valley.glsl
const float STEEPEST = 14.8;                               // the largest slope of the land
float ownSlope = 0.65;                                     // slope of the ray; 0.65 is valid for all directions
float overLand = 0.0;                                      // gap above the land at the last point given to landBound

// The hill and its ridges: a lower bound of the distance, like landDistance in valley.glsl.
float landBound(vec2 q)
{
    vec2 x = CELLS * vec2(ASIDE, q.x) + vec2(31.2, 9.9);
    float base = hill(vec2(ASIDE - 4.0, q.x - 46.0), vec2(43.0, 25.5), 7.4).x - 3.0, over = q.y - base;
    float high = RIDGES * max(base - FOOT, 0.0), growth = RIDGES * HILL_SLOPE, hilly = ownSlope + HILL_SLOPE;
    float weight = 1.0 - GAIN, rest = 1.0, sum = 0.0, first = 1.0, steep = 2.0 * VALUE_STRETCH * CELLS;
    float slope = (1.0 + weight) * steep, d = (min(q.y, FOOT + (q.y - FOOT) / (1.0 + RIDGES)) - base) / hilly;
    for (int i = 0; i < octaves; i++) {
        float ridge = ridged(groundNoise(x)).x;
        first = i == 0 ? ridge : first;
        sum += weight * ridge;
        rest = i + 1 < octaves ? rest - weight : 0.0;
        float most = first * (sum + rest);
        d = max(d, wayToClose(over - high * most, hilly + growth * most + high * slope, 2.0 * growth * slope));
        weight *= GAIN;
        steep *= LACUNARITY;
        slope += weight * steep;
        x = LACUNARITY * mat2(0.8, 0.6, -0.6, 0.8) * x + vec2(17.17, 29.73);
    }
    overLand = over - high * first * sum;
    return bound == 0 ? overLand / sqrt(1.0 + STEEPEST * STEEPEST) : d;
}

float sceneDistance(vec3 p)
{
    return landBound(UNITS * (p.xy - ORIGIN)) / UNITS;
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), direction = normalize(aim - eye + 1e-6);
    float t;
    ownSlope = bound == 2 ? abs(direction.y) : 0.65;
    dashes(p, eye, eye + 6.0 * direction, 1.0, PALE);
    int steps = drawMarch(p, eye, direction, 4.0, 0.007, 60, t);

    // The land, drawn using its height and slope at this position, and the lake.
    vec2 q = UNITS * (p - ORIGIN);
    landBound(q);
    float height = q.y - overLand;
    landBound(q + vec2(0.02, 0.0));
    float slope = (q.y - overLand - height) / 0.02, above = (q.y - height) * inversesqrt(1.0 + slope * slope) / UNITS;
    if (height < 0.0) {
        fill(p.y - ORIGIN.y, SKY, 0.7);
        stroke(p.y - ORIGIN.y, 2.0, BLUE);
    }
    fill(above, SAND, 1.0);
    stroke(above, 2.0, ORANGE);
    number(p, vec2(1.6, 0.85), float(steps), 0, INK); // # step(s)
    return sheetColour;
}
