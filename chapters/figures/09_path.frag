// The sun's day: drag the sun along its path, and its highest point up and down to change the season. The horizontal
// axis is the time, from 0 to 24 h. Above the horizon, each column shows the sky at that hour, in the direction of the
// sun, from the horizon to the zenith. Below are the hour, the elevation of the sun in degrees (orange) and the air
// mass of its light (green).
#include "figure.glsl"
#include "lighting.glsl" // encodeSRGB
#include "sky.glsl"      // sunDirection, airMass, transmittance, sunlitSky, nightSky

uniform vec2 sun;       // (0.8, 0) handle units: its x is the hour
uniform vec2 noon;      // (0, 0.46) handle units: its y is the height of the sun at noon
uniform float latitude; // 43.6 in [-66, 66] step 0.2, degrees: latitude of the observer, north positive

const float HOUR = 1.0 / 7.2, DEGREE = 1.0 / 95.0, HORIZON = -0.05; // units of the sheet

float declination()
{
    float south = latitude < 0.0 ? -1.0 : 1.0, high = (noon.y - HORIZON) / DEGREE;
    return clamp(latitude - south * (90.0 - high), -23.44, 23.44);
}

vec3 sunAt(float x)
{
    return sunDirection(12.0 + x / HOUR, latitude, declination());
}

float heightAt(float x)
{
    return HORIZON + DEGREE * degrees(arcSine(sunAt(x).y));
}

float sceneDistance(vec3 p)
{
    return p.y - heightAt(p.x);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    float x = clamp(sun.x, -12.0 * HOUR, 12.0 * HOUR), y = heightAt(x), up = radians((p.y - HORIZON) / DEGREE);
    // The column of the sky below and above the sun.
    float here = heightAt(p.x), high = radians((here - HORIZON) / DEGREE);
    vec3 towards = vec3(cos(high), sin(high), 0.0), direction = vec3(cos(up), sin(up), 0.0), depth = RAYLEIGH + 0.02;
    vec3 sky = encodeSRGB(sunlitSky(direction, towards, depth) + nightSky(direction, towards));
    fill(max(max(HORIZON - p.y, abs(p.x) - 12.0 * HOUR), p.y - HORIZON - 90.0 * DEGREE), sky, 1.0);
    line2(p, vec2(-12.0 * HOUR, HORIZON), vec2(12.0 * HOUR, HORIZON), 2.0, INK);
    float hour = clamp(6.0 * floor(p.x / HOUR / 6.0 + 0.5), -12.0, 12.0); // the nearest of 0, 6, 12, 18 and 24 h
    line2(p, vec2(hour * HOUR, HORIZON), vec2(hour * HOUR, HORIZON - 0.04), 1.5, INK);
    number(p, vec2(hour * HOUR, HORIZON - 0.09), hour + 12.0, 0, PALE);
    if (abs(p.x) < 12.0 * HOUR)
        curve(p.y - here, (heightAt(p.x + 0.01) - here) / 0.01, 2.5,
              p.y > HORIZON ? ORANGE : PALE);
    dot2(p, vec2(0.0, heightAt(0.0)), 10.0, ORANGE);

    float mass = airMass(sunAt(x).y);
    fill(length(p - vec2(x, y)) - 0.075, encodeSRGB(1.1 * transmittance(RAYLEIGH, mass)), y > HORIZON ? 1.0 : 0.3);
    stroke(length(p - vec2(x, y)) - 0.075, 2.0, INK);
    number(p, vec2(-0.32, -0.5), 12.0 + x / HOUR, 2, INK); // # | hour #
    number(p, vec2(0.0, -0.5), (y - HORIZON) / DEGREE, 1, ORANGE); // # | elevation # degrees
    if (y > HORIZON)
        number(p, vec2(0.32, -0.5), mass, 2, TEAL); // # | air mass #
    return sheetColour;
}
