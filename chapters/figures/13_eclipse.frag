// The shadow of a ball: drag the point through the shadow, or drag the ball. The umbra ends where the ball looks as
// large as the lamp. On the right are the lamp's disc as seen from the point, the ball's disc in front of it, and the
// visible share.
#include "figure.glsl"
#include "soft_shadow.glsl"

uniform vec2 spot;    // (-0.43, -0.72) handle: the point
uniform vec2 ball;    // (-0.6, -0.06) handle: centre of the ball
uniform float radius; // 0.15 in [0.02, 0.5] step 0.01, units: radius of the ball

const vec2 LAMP = vec2(-0.6, 0.66);
const float LAMP_RADIUS = 0.25;

float sceneDistance(vec3 p)
{
    return sdCircle(p.xy - ball, radius);
}

// The radius of the lamp's disc at a distance of one unit from q.
float spreadFrom(vec2 q)
{
    vec2 toLamp = LAMP - q;
    return LAMP_RADIUS / sqrt(max(dot(toLamp, toLamp) - LAMP_RADIUS * LAMP_RADIUS, 1e-4));
}

// Whether the ball's centre is between q and the lamp, measured along the line that joins q and the lamp.
bool before(vec2 q)
{
    float along = dot(ball - q, normalize(LAMP - q));
    return along > 0.0 && along < length(LAMP - q);
}

// The share of the lamp that is visible from q.
float shareFrom(vec2 q)
{
    if (length(ball - q) < radius || !before(q))
        return length(ball - q) < radius ? 0.0 : 1.0;
    return lampBesideBall(vec3(q, 0.0), vec3(normalize(LAMP - q), 0.0), spreadFrom(q), vec3(ball, 0.0), radius);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), eyes = vec2(1.16, 0.2), toBall = ball - spot, toLamp = normalize(LAMP - spot);
    fill(p.y - LAMP.y + LAMP_RADIUS, SHADE, 0.75 * (1.0 - shareFrom(p)) * (1.0 - smoothstep(0.35, 0.62, p.x)));

    // The tangents from the point to the lamp are perpendicular to the lamp's radii at the points of contact.
    float spread = spreadFrom(spot), cosine = inversesqrt(1.0 + spread * spread), reach = LAMP_RADIUS / spread;
    vec2 aside = cosine * spread * vec2(-toLamp.y, toLamp.x);
    line2(p, spot, spot + reach * (cosine * toLamp + aside), 1.2, ORANGE);
    line2(p, spot, spot + reach * (cosine * toLamp - aside), 1.2, ORANGE);
    fill(sdCircle(p - LAMP, LAMP_RADIUS), GLOW, 1.0);
    stroke(sdCircle(p - LAMP, LAMP_RADIUS), 2.0, ORANGE);
    fill(sceneDistance(vec3(p, 0.0)), SKY, 1.0);
    stroke(sceneDistance(vec3(p, 0.0)), 2.0, BLUE);
    dot2(p, spot, 9.0, INK);

    // Both discs as seen from the point, in radii of the lamp; the ball's disc is the circle of lampBesideBall.
    float shown = 0.42, along = dot(toBall, toLamp), off = abs(dot(toBall, vec2(toLamp.y, -toLamp.x)));
    float tangent = radius / sqrt(max(dot(toBall, toBall) - radius * radius, 1e-4));
    float rim = (off - along * tangent) / max(along + off * tangent, 1e-3);
    float middle = (rim + tangent) / spread * sign(dot(toBall, vec2(toLamp.y, -toLamp.x)));
    vec2 q = (p - eyes) / shown;
    float lampDisc = shown * (length(q) - 1.0), ballDisc = shown * (length(q - vec2(middle, 0.0)) - tangent / spread);
    bool inside = length(toBall) < radius, seen = inside || before(spot);
    fill(lampDisc, GLOW, 1.0);
    fill(max(inside ? -1.0 : ballDisc, lampDisc), SKY, seen ? 1.0 : 0.0);
    fill(max(abs(ballDisc) - 0.5 * penWidth(2.0), lampDisc - 0.13), BLUE, seen && !inside ? 1.0 : 0.0);
    stroke(lampDisc, 2.0, ORANGE);
    number(p, eyes - vec2(0.0, 0.68), shareFrom(spot), 2, INK); // visible #
    return sheetColour;
}
