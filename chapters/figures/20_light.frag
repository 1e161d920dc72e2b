// Clouds in the light: drag the sun in the small disc, which shows the sky with the zenith in its centre and the view
// at its top; beyond its rim, the sun is below the horizon. Drag the point over the clouds. The bars show the light of
// this point: their widths are the squared components of the direction to the sun, sideways (orange), upwards (green)
// and ahead (blue), and their heights are the shares of the sun's light that arrive from these directions. The number
// is the total area of the bars plus the silver lining.
#include "figure.glsl"
#include "lighting.glsl"
#include "film.glsl"
#include "sky_table.glsl"
#include "clouds.glsl"

uniform sampler2D sunward;    // "sky_sunward.png" sRGB clamp: the sky on the sun's side
uniform sampler2D away;       // "sky_away.png" sRGB clamp: the sky on the other side
uniform sampler2D cloudsFair; // "clouds_fair.png" linear repeat: panorama of fair weather

uniform vec2  sun;    // (-1.59, -0.71) handle: the sun, in the small disc
uniform vec2  at;     // (0.55, -0.08) handle: a point on the clouds
uniform float turned; // 0.4 in [-1, 1] step 0.02, turns: position of the panorama

const vec2  DISC = vec2(-1.35, -0.64);
const float RIM = 0.28, SILL = -0.3; // radius of the disc; lower end of the view, the horizon

float sceneDistance(vec3 p)
{
    return p.z;
}

// The direction of a point of the view, which extends 62 degrees to either side and 45 degrees upwards.
vec3 viewDirection(vec2 p)
{
    float height = 0.6 * (p.y - SILL);
    return vec3(cos(height) * cos(0.61 * p.x), sin(height), cos(height) * sin(0.61 * p.x));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), from = sun - DISC;
    float low = 1.5707963 * min(length(from) / RIM, 1.06);
    vec2 level = sin(low) * normalize(from + 1e-6);
    vec3 toSun = vec3(level.y, cos(low), level.x), direction = viewDirection(p);
    vec3 high = tableSunlight(vec3(0.0, cloudSunHeight(toSun.y, 3.0), 0.0)), skylight = tableAmbient(toSun);
    float width = 0.6 * sheetPixel(), stops = -2.2 - 0.85 * log2(skylight.y);
    Cloud cloud = cloudPanorama(cloudsFair, direction, turned, width);
    vec3 light = (1.0 - cloud.cover) * tableSky(sunward, away, direction, toSun) + cloudLight(cloud, direction, toSun, high, skylight);
    light += (1.0 - cloud.cover) * 100.0 * exp2(-stops) * disc(direction, toSun, 0.02) * step(0.0, toSun.y);
    if (p.y > SILL)
        sheetColour = encodeSRGB(filmOfLargest(exposed(daylightFilm(light), stops), 1.35, 6.0));
    line2(p, vec2(-1.78, SILL), vec2(1.78, SILL), 2.0, INK);

    // The sky from below, with the view and the sun.
    float d = sdCircle(p - DISC, RIM);
    fill(d, SKY, 1.0);
    fill(max(d, abs(p.x - DISC.x) * 0.53 - (p.y - DISC.y) * 0.85), PAPER, 1.0);
    stroke(d, 2.0, BLUE);
    dot2(p, DISC + min(length(from), 1.06 * RIM) * normalize(from + 1e-6), 16.0, ORANGE);

    // The point: three squares, and the three shares of cloudLight.
    vec2 point = vec2(at.x, max(at.y, SILL));
    vec3 there = viewDirection(point), ahead = normalize(vec3(there.x, 0.0, there.z)), right = vec3(-ahead.z, 0.0, ahead.x);
    Cloud c = cloudPanorama(cloudsFair, there, turned, width);
    vec3 part = vec3(dot(toSun, right), toSun.y, dot(toSun, ahead)), square = part * part, share;
    float across = part.x < 0.0 ? -1.0 : 1.0;
    share.x = 0.03 * c.cover + max(0.3 * c.above + 0.8 * across * c.side, 0.0);
    share.y = part.y > 0.0 ? c.above : 0.5 * (c.cover - c.above);
    share.z = part.z < 0.0 ? 0.15 * c.cover + 0.7 * c.above : 0.03 * c.cover + 0.2 * c.above;
    vec2 base = vec2(-0.7, -0.85);
    for (int i = 0; i < 3; i++) {
        vec2 size = vec2(1.9 * square[i], 0.4 * share[i]);
        vec3 colour = i == 0 ? ORANGE : (i == 1 ? TEAL : BLUE);
        fill(sdRectangle(p - base - 0.5 * vec2(size.x, 0.4), 0.5 * vec2(size.x, 0.4)), colour, 0.2);
        fill(sdRectangle(p - base - 0.5 * size, 0.5 * size), colour, 1.0);
        base.x += size.x;
    }
    vec3 sent = cloudLight(c, there, toSun, vec3(1.0), vec3(0.0));
    number(p, vec2(1.5, -0.65), sent.x, 2, INK); // light #
    stroke(sdCircle(p - point, penWidth(5.0)), 2.0, ORANGE);
    return sheetColour;
}
