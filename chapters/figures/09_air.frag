// How much air the sunlight passes through: drag the sun. The dots on the ray are one vertical air mass apart, the
// length of the dashed vertical line. The green number is the air mass of the round Earth, and the orange number is
// that of flat layers, whose top is the dashed orange line. The sun has the colour of the light that remains. Make the
// Earth larger: at 721.5 it has its true size and is nearly flat.
#include "figure.glsl"
#include "lighting.glsl" // encodeSRGB
#include "sky.glsl"      // RAYLEIGH, transmittance

uniform vec2 sun;    // (1.38, -0.02) handle units: direction of the sun
uniform float earth; // 40 in [5, 721.5] step *1.2, thicknesses of the air: radius of the Earth

const vec2 EYE = vec2(-0.85, -0.36);
const float AIR = 0.23; // thickness of the air, units

float sceneDistance(vec3 p)
{
    float radius = earth * AIR;
    vec2 q = p.xy - EYE;
    return (dot(q, q) + 2.0 * q.y * radius) / (length(q + vec2(0.0, radius)) + radius); // large numbers do not cancel
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), to = normalize(vec2(sun.x - EYE.x, max(sun.y - EYE.y, 0.0)) + 1e-6);
    float climb = earth * to.y, horizon = 2.0 * earth + 1.0;
    float mass = horizon / (sqrt(climb * climb + horizon) + climb), even = min(1.0 / max(to.y, 0.001), 999.0);
    float height = sceneDistance(vec3(p, 0.0));
    vec3 left = encodeSRGB(1.1 * transmittance(RAYLEIGH, mass));

    fill(abs(height - 0.5 * AIR) - 0.5 * AIR, SKY, 1.0);
    stroke(height - AIR, 1.0, BLUE);
    fill(height, SAND, 1.0);
    stroke(height, 2.0, INK);
    dashes(p, vec2(-2.0, EYE.y + AIR), vec2(2.0, EYE.y + AIR), 1.2, ORANGE);
    dashes(p, EYE, EYE + vec2(0.0, AIR), 1.5, INK);

    // The ray: the remaining light turns from white to yellow and red on its path through the air.
    vec2 q = vec2(dot(p - EYE, to), dot(p - EYE, vec2(-to.y, to.x)));
    float passed = clamp(mass - q.x / AIR, 0.0, mass), end = max(length(sun - EYE), mass * AIR + 0.1);
    line2(p, EYE, EYE + end * to, 6.0, INK);
    line2(p, EYE, EYE + end * to, 4.0, encodeSRGB(1.1 * transmittance(RAYLEIGH, passed)));
    float mark = AIR * clamp(floor(q.x / AIR + 0.5), 1.0, floor(mass));
    if (mass >= 1.0)
        dot2(p, EYE + mark * to, 6.0, TEAL);
    dot2(p, EYE + AIR * even * to, 8.0, ORANGE);
    dot2(p, EYE + AIR * mass * to, 8.0, TEAL);
    number(p, EYE + AIR * mass * to + 0.12 * vec2(-to.y, to.x), mass, 2, TEAL); // # | air mass #
    number(p, EYE + AIR * even * to + 0.12 * vec2(to.y, -to.x), even, 2, ORANGE); // # | flat layers #
    vec2 disc = EYE + end * to;
    fill(length(p - disc) - 0.08, left, 1.0);
    stroke(length(p - disc) - 0.08, 2.0, INK);
    dot2(p, EYE, 9.0, INK);
    return sheetColour;
}
