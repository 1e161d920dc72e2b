// The whole sky, twice: drag the sun in the left sky; beyond the rim it is below the horizon. The zenith is in the
// centre, the horizon at the rim. On the left is the sky of chapter 18, whose tables do not contain the steep
// dependence on the angle to the sun; on the right two tables with complete colours are mixed, by the horizontal angle
// or by the dot product. The number is the sun's height in degrees.
#include "figure.glsl"
#include "lighting.glsl"
#include "film.glsl"
#include "sky_table.glsl"

uniform sampler2D sunward; // "sky_sunward.png" sRGB clamp: the half of the sky that contains the sun
uniform sampler2D away;    // "sky_away.png" sRGB clamp: the other half

uniform vec2 sun; // (-0.89, -0.37) handle: the sun, in the left sky
uniform int  way; // 1 in [1, 2]: on the right the tables are mixed 1 by the horizontal angle, 2 by the dot product

const vec2  LEFT = vec2(-0.88, 0.0), RIGHT = vec2(0.88, 0.0);
const float RIM = 0.8; // radius of the horizon

float sceneDistance(vec3 p)
{
    return p.z;
}

// The direction of a position in a sky: equal angles are equal lengths.
vec3 skyDirection(vec2 local)
{
    float angle = 1.5707963 / RIM * length(local);
    return vec3(normalize(local + 1e-6) * sin(angle), cos(angle)).xzy;
}

// The light of a table with complete colours: the light along the middle of the table's half of the sky.
vec3 halfColour(sampler2D table, vec3 direction, vec3 toSun, float level)
{
    float y = max(direction.y, 0.0), both = sqrt(max((1.0 - y * y) * (1.0 - toSun.y * toSun.y), 0.0));
    vec2 uv = skyUV(toSun.y, y);
    return tableLight(table, uv, y * toSun.y + level * both, skyScale(toSun.y, uv.y));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), local = p - (p.x < 0.0 ? LEFT : RIGHT), from = sun - LEFT;
    from *= min(1.0, 1.17 * RIM / max(length(from), 1e-6)); // at most 15 degrees below the horizon
    vec3 toSun = skyDirection(from), direction = skyDirection(local);
    float angle = atan(direction.x * toSun.z - direction.z * toSun.x, dot(direction.xz, toSun.xz));
    float share = way == 1 ? 1.0 - abs(angle) / 3.1415927 : 0.5 + 0.5 * dot(direction, toSun);
    vec3 complete = mix(halfColour(away, direction, toSun, -1.0), halfColour(sunward, direction, toSun, 1.0), share);
    vec3 light = p.x < 0.0 ? tableSky(sunward, away, direction, toSun) : complete;
    light = exposed(daylightFilm(light), adaptedStops(exp2(skyBrightness(toSun.y)) + 6e-8));
    float rim = length(local) - RIM;
    fill(rim, encodeSRGB(filmOfLargest(light, 1.35, 6.0)), 1.0);
    stroke(rim, 1.5, INK);
    dashes(p, LEFT, LEFT + from, 1.0, PALE);
    dot2(p, LEFT + from, 12.0, length(from) < RIM ? CHALK : ORANGE);
    dashes(p, RIGHT, RIGHT + from, 1.0, PALE);
    dot2(p, RIGHT + from, 12.0, length(from) < RIM ? CHALK : ORANGE);
    number(p, vec2(0.0, 0.9), 90.0 * (1.0 - length(from) / RIM), 0, INK); // sun at #°
    return sheetColour;
}
