// The light of a ray: drag the sun down to the horizon and below it, and the end of the ray. Sunlight reaches each
// point of the ray along a line, and the longer its path through the air, the more it has lost, blue first. The more
// light a point sends to the eye, the larger its dot is; the square has the colour of the sum. The planet is small and
// its air is thick, so that both fit in the picture.
#include "figure.glsl"
#include "sky.glsl"

uniform vec2 sun;   // (1.6, -0.66) handle: where the eye sees the sun
uniform vec2 aim;   // (-0.25, 0.35) handle: where the ray points
uniform bool ozone; // true: the air contains ozone

const vec2  CENTRE = vec2(0.0, -3.55), EYE = vec2(-0.75, -0.749);
const float RADIUS = 2.9, TOP = 1.2; // radius of the planet; height at which the air ends
const float THIN = 0.20;              // height over which the air thins by a factor of e
const vec3  OZONE = vec3(0.20, 0.21, 0.01); // optical depth of the ozone overhead
const float LAYER = RADIUS + 0.6;          // distance of the ozone from the centre

float sceneDistance(vec3 p)
{
    return sdCircle(p.xy - CENTRE, RADIUS);
}

// The optical depth of the air above a point at a distance r from the centre, in a direction whose height has the given
// sine. The function is like airMass, but for air that thins out with height.
vec3 depthUp(float r, float sine)
{
    float e = 0.785 * r / THIN - 0.5, climb = e * sine;
    return 1.7 * RAYLEIGH * exp((RADIUS - r) / THIN) * (2.0 * e + 1.0) / (sqrt(climb * climb + 2.0 * e + 1.0) + climb);
}

// The share of the sun's light that reaches a point. It is 0 in the shadow of the planet.
vec3 sunlightAt(vec2 p, vec2 toSun)
{
    float r = length(p - CENTRE), sine = dot(p - CENTRE, toSun) / r, lowest = r * sqrt(max(1.0 - sine * sine, 0.0));
    vec3 depth = depthUp(r, abs(sine));
    if (sine < 0.0)
        depth = 2.0 * depthUp(max(lowest, RADIUS), 0.0) - depth;
    float across = sqrt(max(LAYER * LAYER - lowest * lowest, 0.1)) / LAYER; // sine of the angle between path and layer
    float crossings = 1.0 - clamp(8.0 * sine, -1.0, 1.0) * smoothstep(-0.15, 0.15, r - LAYER);
    depth += ozone ? OZONE * crossings / across * (1.0 - smoothstep(-0.1, 0.1, lowest - LAYER)) : vec3(0.0);
    return exp(-depth) * (sine > 0.0 ? 1.0 : smoothstep(0.0, 0.02, lowest - RADIUS));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), toSun = normalize(sun - EYE + 1e-6), direction = normalize(aim - EYE + 1e-6);
    vec2 up = normalize(EYE - CENTRE); // no ray points below the horizon
    direction = normalize(direction - min(dot(direction, up), 0.0) * up + 1e-5 * vec2(up.y, -up.x));
    float d = sceneDistance(vec3(p, 0.0)), cosine = dot(direction, toSun);
    vec3 lit = sqrt(sunlightAt(p, toSun));
    fill(d - TOP, mix(NIGHT, vec3(0.62, 0.77, 0.97) * lit, max(lit.r, 0.1)), 0.9 * exp(-max(d, 0.0) / 0.25));
    float b = dot(EYE - CENTRE, direction), way = sqrt(b * b + TOP * (2.0 * RADIUS + TOP)) - b;
    vec3 depth = vec3(0.0), sum = vec3(0.0);
    line2(p, EYE, EYE + way * direction, 2.0, INK);
    for (int i = 0; i < 12; i++) {
        float q = (float(i) + 0.5) / 12.0, piece = 2.0 * q * way / 12.0;
        vec2 at = EYE + q * q * way * direction;
        vec3 air = piece * 1.7 * RAYLEIGH / THIN * exp((RADIUS - length(at - CENTRE)) / THIN), light = sunlightAt(at, toSun);
        vec3 sent = light * exp(-depth - 0.5 * air) * air * (0.75 + 0.75 * cosine * cosine);
        depth += air;
        sum += sent;
        line2(p, at, at + 4.0 * toSun, 1.0, light.r > 0.01 ? mix(PALE, ORANGE, light.g) : PALE);
        dot2(p, at, 3.0 + 30.0 * sqrt(max(sent.r, sent.b)), light.r > 0.01 ? ORANGE : INK);
    }
    fill(d, SAND, 1.0);
    stroke(d, 2.0, ORANGE);
    dot2(p, EYE, 9.0, INK);
    dot2(p, sun, 24.0, ORANGE);
    float square = sdRectangle(p - vec2(-1.5, 0.72), vec2(0.18)), bright = max(dot(sum, vec3(0.2, 0.7, 0.1)), 1e-5);
    sum *= vec3(1.12, 1.0, 0.96); // the colour of sunlight, as in tableSunlight
    fill(square, pow(sum / bright * 0.35 * pow(bright, 0.15), vec3(1.0 / 2.2)), 1.0);
    stroke(square, 2.0, INK);
    return sheetColour;
}
