// The columns of a table: drag the sun's height to the left and to the right, and change k. The horizontal axis is the
// sine of the height, and the vertical axis is the column of the table; every twelfth column is drawn. Both strips show
// the same sky near the horizon, one against the sine and one against the column. At the top are the column and its
// width in degrees.
#include "figure.glsl"
#include "lighting.glsl"
#include "film.glsl"
#include "sky_table.glsl"

uniform sampler2D sunward; // "sky_sunward.png" sRGB clamp: the half of the sky that contains the sun
uniform sampler2D away;    // "sky_away.png" sRGB clamp: the other half

uniform vec2  at; // (-0.5, 0.6) handle: the sun's height
uniform float k;  // 0.1 in [0.02, 0.98] step 0.02: the smaller it is, the closer the columns are at the horizon

const vec2 LOW = vec2(-1.45, -0.68), HIGH = vec2(1.6, 0.85); // corners of the plot

float sceneDistance(vec3 p)
{
    return p.z;
}

// The sine of the height at a fraction of the table's width, and the inverse.
float sineAt(float share)
{
    float lowest = drawnOut(LOWEST_SUN, k), x = mix(lowest, 1.0, share);
    return min(x * (k + (1.0 - k) * abs(x)), 1.0);
}

float shareAt(float sine)
{
    float lowest = drawnOut(LOWEST_SUN, k);
    return (drawnOut(sine, k) - lowest) / (1.0 - lowest);
}

// The position in the plot of a sine and a share.
vec2 inPlot(float sine, float share)
{
    return mix(LOW, HIGH, vec2((sine - LOWEST_SUN) / (1.0 - LOWEST_SUN), share));
}

// The colour of the sky 3 degrees above the horizon on the side of the sun.
vec3 skyAt(float sine)
{
    vec3 sun = vec3(sqrt(max(1.0 - sine * sine, 0.0)), sine, 0.0);
    vec3 light = tableSky(sunward, away, vec3(0.99863, 0.05234, 0.0), sun);
    return encodeSRGB(filmOfLargest(exposed(daylightFilm(light), adaptedStops(exp2(skyBrightness(sine)) + 6e-8)), 1.35, 6.0));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), share = (p - LOW) / (HIGH - LOW), middle = 0.5 * (LOW + HIGH);
    float sine = mix(LOWEST_SUN, 1.0, share.x);
    bool below = p.y < LOW.y - 0.02;
    vec3 sky = skyAt(clamp(below ? sine : sineAt(clamp(share.y, 0.0, 1.0)), LOWEST_SUN, 1.0));
    fill(sdRectangle(p - vec2(middle.x, LOW.y - 0.11), vec2(0.5 * (HIGH - LOW).x, 0.09)), sky, 1.0);
    fill(sdRectangle(p - vec2(LOW.x - 0.11, middle.y), vec2(0.09, 0.5 * (HIGH - LOW).y)), sky, 1.0);
    float known = clamp(sine, LOWEST_SUN, 1.0), above = floor(24.0 * shareAt(known) + 0.5) / 24.0;
    float beside = clamp(floor(24.0 * share.y + 0.5) / 24.0, 0.0, 1.0); // the nearest of the columns drawn
    line2(p, inPlot(LOWEST_SUN, beside), inPlot(sineAt(beside), beside), 1.0, mix(PAPER, PALE, 0.6));
    line2(p, inPlot(sineAt(above), 0.0), inPlot(sineAt(above), above), 1.0, PALE);
    line2(p, LOW, vec2(HIGH.x, LOW.y), 1.5, INK);
    line2(p, LOW, vec2(LOW.x, HIGH.y), 1.5, INK);
    float low = max(known - 0.002, LOWEST_SUN), high = min(known + 0.002, 1.0);
    float slope = (inPlot(0.0, shareAt(high)) - inPlot(0.0, shareAt(low))).y / (inPlot(high, 0.0) - inPlot(low, 0.0)).x;
    if (known == sine)
        curve(p.y - inPlot(0.0, shareAt(sine)).y, slope, 2.5, BLUE);
    float chosen = clamp(mix(LOWEST_SUN, 1.0, (at.x - LOW.x) / (HIGH - LOW).x), LOWEST_SUN, 1.0), row = shareAt(chosen);
    vec2 spot = inPlot(chosen, row);
    line2(p, vec2(spot.x, LOW.y - 0.2), spot, 2.0, ORANGE);
    line2(p, vec2(LOW.x - 0.2, spot.y), spot, 2.0, ORANGE);
    dot2(p, spot, 9.0, ORANGE);
    float column = row * (SKY_TABLE.x - 1.0), next = 1.0 / (SKY_TABLE.x - 1.0);
    number(p, vec2(0.2, 0.93), column, 0, INK); // column #
    float wide = arcSine(sineAt(row + next * step(row, 0.5))) - arcSine(sineAt(row - next * step(0.5, row)));
    number(p, vec2(0.8, 0.93), degrees(wide), 2, ORANGE); // #° wide
    return sheetColour;
}
