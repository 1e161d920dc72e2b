// A cloud layer over the round Earth: drag the end of the ray down to the horizon, and the layer up and down. The sheet
// reaches 137 km to the right of the eye and 1.8 km above it, and heights are drawn 25 times too large. The dashed
// layer is flat. At the top are the height of the ray in degrees and the distances to the round layer and to the flat
// one in km; on the layer is the piece that a pixel of the chapter's picture covers, with its length in km.
#include "figure.glsl"
#include "clouds.glsl"

uniform vec2 aim;   // (-0.4, 0.3) handle: where the ray points
uniform vec2 layer; // (0.75, 0.65) handle: its height is that of the flat layer

const vec2  EYE = vec2(-1.65, -0.1), KM = vec2(0.025, 0.625); // the eye; units of the sheet per km
const float PIXEL = 1.0 / 360.0;                              // the angle of a pixel, radians

float sceneDistance(vec3 p)
{
    return p.z;
}

// The height above the round ground: |(x, R + y)| - R, without the difference of two large numbers.
float heightAt(vec2 km)
{
    float more = dot(km, km) + 2.0 * EARTH_RADIUS * km.y;
    return more / (sqrt(EARTH_RADIUS * EARTH_RADIUS + more) + EARTH_RADIUS);
}

// Where a ray meets the layer. climb is the sine of the ray's elevation.
vec2 onLayer(float climb, float altitude)
{
    return EYE + KM * layerHit(0.0, climb, altitude) * vec2(sqrt(1.0 - climb * climb), climb);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), km = (p - EYE) / KM, to = max((aim - EYE) / KM, vec2(0.1, 0.0));
    float altitude = max((layer.y - EYE.y) / KM.y, 0.1), height = heightAt(km), climb = to.y / length(to);
    // The factor that converts a difference in height, in km, to a distance on the sheet.
    float slope = inversesqrt(1.0 + pow(km.x / EARTH_RADIUS * KM.y / KM.x, 2.0)) * KM.y;

    // Clouds with a flat base, on the layer.
    float cell = floor(km.x / 5.0), lot = cellRandom(ivec3(int(cell), 3, 20)), across = 2.0 * fract(km.x / 5.0) - 1.0;
    float cloud = (height - altitude) * slope - (0.05 + 0.06 * lot) * sqrt(max(1.0 - across * across, 0.0));
    fill(max(cloud, (altitude - height) * slope), SKY, 1.0);
    fill(height * slope, SAND, 1.0);
    stroke(height * slope, 2.0, ORANGE);
    dashes(p, vec2(-1.78, EYE.y + KM.y * altitude), vec2(1.78, EYE.y + KM.y * altitude), 1.5, ORANGE);
    stroke((height - altitude) * slope, 2.0, BLUE);

    // The piece of the layer that a pixel covers, and the ray.
    vec2 hit = onLayer(climb, altitude), near = onLayer(climb + 0.5 * PIXEL, altitude), far = onLayer(climb - 0.5 * PIXEL, altitude);
    float within = max(near.x - p.x, p.x - far.x);
    fill(max(abs((height - altitude) * slope) - 0.5 * penWidth(7.0), within), TEAL, 1.0);
    fill(sdTriangle(p, EYE, near, far + vec2(1e-4, 0.0)), TEAL, 0.2);
    dashes(p, EYE, vec2(1.78, EYE.y), 1.0, PALE);
    line2(p, EYE, hit, 2.0, INK);
    dot2(p, EYE, 9.0, INK);
    float flat_ = altitude / max(climb, 1e-4);
    dashes(p, hit, EYE + KM * flat_ * vec2(1.0, climb), 1.5, INK);
    dot2(p, EYE + KM * flat_ * vec2(1.0, climb), 9.0, ORANGE);
    dot2(p, hit, 9.0, BLUE);
    number(p, vec2(-1.58, 0.88), degrees(arcSine(climb)), 1, INK); // #° | ray at # degrees
    number(p, vec2(-1.2, 0.88), layerHit(0.0, climb, altitude), 1, BLUE); // # | round layer # km
    if (flat_ < 1000.0)
        number(p, vec2(-0.8, 0.88), flat_, 1, ORANGE); // # | flat layer # km
    number(p, clamp(hit - vec2(0.0, 0.13), vec2(-1.5, -0.9), vec2(1.6, 0.75)), (far.x - near.x) / KM.x, 1, TEAL); // # km
    return sheetColour;
}
