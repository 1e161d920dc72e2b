// Experiment of chapter 06: what a fold does to a plane. The letter is drawn using its distance at
// the folded point. The line is the mirror, and the arrow that starts on the line is the normal.
// The side to which the arrow points is kept.
#include "main.glsl"
#include "symmetry.glsl" // opReflect
#include "hue.glsl"      // hsvToRGB

uniform int   folds;        // 1 in [0, 3]: number of mirrors, each turned by 60 degrees from the one before
uniform float turn;         // 25 in [-180, 180] step 5, degrees: direction of the first normal
uniform float mirrorOffset; // 0.3 in [-2, 2] step 0.1, units: the plane is dot(p, normal) = -mirrorOffset
uniform float normalLength; // 1 in [0.5, 1.5] step 0.05: length of the normal, which should be 1
uniform bool  otherSide;    // false: change the signs of normal and offset: the same line, the other side

// The origin of the ray is the point of the plane that the pixel shows. The picture is 4 units
// high.
Ray pixelRay(vec2 screen)
{
    return Ray(vec3(2.0 * screen, 0.0), vec3(0.0, 0.0, -1.0));
}

float bar(vec2 p, vec2 low, vec2 high)
{
    vec2 q = abs(p - 0.5 * (low + high)) - 0.5 * (high - low);
    return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0);
}

// The letter F, which no mirror leaves unchanged.
float letter(vec2 p)
{
    float stem = bar(p, vec2(1.05, -0.7), vec2(1.3, 0.9));
    float top = bar(p, vec2(1.05, 0.65), vec2(2.05, 0.9));
    return min(min(stem, top), bar(p, vec2(1.05, 0.0), vec2(1.75, 0.25)));
}

vec3 normalOf(int number)
{
    float angle = radians(turn + 60.0 * float(number));
    return normalLength * vec3(cos(angle), sin(angle), 0.0) * (otherSide ? -1.0 : 1.0);
}

vec3 folded(vec3 p)
{
    float offset = otherSide ? -mirrorOffset : mirrorOffset;
    for (int i = 0; i < folds; i++)
        p = opReflect(p, normalOf(i), offset);
    return p;
}

float sceneDistance(vec3 p)
{
    return letter(folded(p).xy);
}

// The share of a pixel that a line covers; x is the distance from the centre of the line, in units.
float line(float x, float pixels)
{
    return clamp(0.5 * pixels + 0.5 - abs(x) * 0.25 * iResolution.y, 0.0, 1.0);
}

float segment(vec2 p, vec2 a, vec2 b)
{
    float along = clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
    return length(p - a - along * (b - a));
}

vec3 rayColour(Ray ray)
{
    vec3 p = ray.origin;
    float away = distanceAt(p);
    vec2 q = folded(p).xy;
    // The colour of the folded plane: the hue depends on the position, and the brightness
    // alternates between squares with a side of one unit.
    float square = mod(floor(q.x) + floor(q.y), 2.0);
    vec3 colour = hsvToRGB(198.0 + 26.0 * q.x - 10.0 * q.y, 0.5, 0.50 + 0.1 * square);
    float nearest = 0.25 * floor(away / 0.25 + 0.5);
    colour = mix(colour, vec3(0.08, 0.10, 0.2), 0.4 * line(away - nearest, 1.0));
    colour = mix(colour, vec3(1.0, 0.97, 0.90), clamp(0.5 - away * 0.25 * iResolution.y, 0.0, 1.0));
    for (int i = 0; i < folds; i++) {
        vec2 normal = normalOf(i).xy / normalLength;
        float side = dot(p.xy, normal) + (otherSide ? -mirrorOffset : mirrorOffset) / normalLength;
        vec2 foot = -normal * (otherSide ? -mirrorOffset : mirrorOffset) / normalLength;
        vec2 tip = foot + 0.45 * normal;
        vec2 across = 0.1 * vec2(-normal.y, normal.x);
        float arrow = min(segment(p.xy, foot, tip), min(segment(p.xy, tip, tip - 0.15 * normal + across),
                                                        segment(p.xy, tip, tip - 0.15 * normal - across)));
        colour = mix(colour, vec3(0.02, 0.03, 0.08), max(line(side, 2.5), line(arrow, 2.5)));
    }
    return colour;
}
