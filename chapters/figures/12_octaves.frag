// A sum of octaves and the bound on its slope: drag the point along the curve. The curve never enters the blue wedges,
// whose sides are as steep as the bound (the number). Add octaves, and change the gain: with a gain of 0.5, all octaves
// are equally steep.
#include "figure.glsl"
#include "noise.glsl" // octaveNoise, octaveStretch

uniform vec2 point;  // (-0.28, -0.14) handle units: the tip of the wedges follows this point along the curve
uniform int octaves; // 4 in [1, 7]: number of octaves
uniform float gain;  // 0.5 in [0.2, 0.9] step 0.05: weight of an octave relative to the previous one

const float CELL = 0.7, HIGH = 1.1; // the width of the first octave's cells, and the height of the value 1, units

// The height of the curve, and its slope.
vec2 heightAt(float x)
{
    vec4 noise = octaveNoise(vec3(x / CELL + 44.0, 0.5, 0.5), octaves, gain, 2.0);
    return vec2(HIGH * (noise.x - 0.55), HIGH / CELL * noise.y);
}

float sceneDistance(vec3 p)
{
    return p.y - heightAt(p.x).x;
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), tip = vec2(point.x, heightAt(point.x).x), height = heightAt(p.x);
    float bound = octaveStretch(octaves, gain, 2.0), steep = HIGH / CELL * bound;
    float above = p.y - height.x, slope = inversesqrt(1.0 + height.y * height.y);
    float wedge = (steep * abs(p.x - tip.x) - abs(p.y - tip.y)) * inversesqrt(1.0 + steep * steep);
    fill(above * slope, SAND, 1.0);
    fill(wedge, SKY, 0.9);
    stroke(wedge, 1.2, BLUE);
    curve(above, height.y, 2.2, ORANGE);
    dot2(p, tip, 9.0, INK);
    number(p, vec2(tip.x, 0.88), bound, 2, BLUE); // slope ≤ #
    return sheetColour;
}
