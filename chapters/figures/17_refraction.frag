// A surface bends light: drag the lamp above the face of the glass, and below it. Thicker rays carry more light. At the
// top left are the angles of the ray (black) and of the refracted ray (teal), and the share reflected (orange); on the
// right is this share for all angles from 0 to 90 degrees, with Schlick's formula for it (blue).
#include "figure.glsl"
#include "glass.glsl"

uniform vec2 lamp;   // (-1.25, 0.72) handle: where the light comes from
uniform float index; // 1.52 in [1, 2.5] step 0.02: index of refraction of the glass

const vec2 MEET = vec2(-0.55, 0.0); // where the ray meets the face, y = 0
const vec2 LOW = vec2(0.75, -0.45), SIZE = vec2(0.88, 0.9); // corner and size of the plot

float sceneDistance(vec3 p)
{
    return p.y;
}

// The share reflected at an angle, in units of 90 degrees, on the side of the lamp.
float shareAt(float angle, float eta)
{
    return fresnelShare(cos(1.5707963 * clamp(angle, 0.0, 1.0)), eta);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), direction = normalize(MEET - lamp + 1e-6);
    float side = lamp.y > 0.0 ? 1.0 : -1.0, circle = 0.5, reach = 0.95;
    Parting parting = partingAt(vec3(direction, 0.0), vec3(0.0, 1.0, 0.0), side, index);
    float passed = 1.0 - parting.mirrored, eta = side > 0.0 ? 1.0 / index : index;
    if (p.x < 0.55) {
        fill(p.y, SKY, 1.0);
        line2(p, vec2(-1.78, 0.0), vec2(0.55, 0.0), 2.0, BLUE);
        dashes(p, MEET - vec2(0.0, 0.85), MEET + vec2(0.0, 0.85), 1.0, PALE);
        fill(abs(length(p - MEET) - circle) - 0.5 * penWidth(1.0), PALE, 1.0);

        // Lines perpendicular to the normal, from the normal to the circle. Their lengths are proportional to sin i and
        // sin j, whose ratio is the index.
        vec2 from = MEET - circle * direction, to = MEET + circle * parting.bent.xy;
        line2(p, vec2(MEET.x, from.y), from, 2.5, INK);
        line2(p, vec2(MEET.x, to.y), to, 2.5, passed > 0.0 ? TEAL : SKY);

        arrow(p, MEET, MEET + reach * parting.away.xy, 1.0 + 4.0 * parting.mirrored, ORANGE);
        if (passed > 0.0)
            arrow(p, MEET, MEET + reach * parting.bent.xy, 1.0 + 4.0 * passed, TEAL);
        line2(p, lamp, MEET, 5.0, INK);
        dot2(p, lamp, 12.0, INK);
    }

    // The share as a function of the angle.
    float angle = atan(abs(direction.x), abs(direction.y)) / 1.5707963;
    vec2 q = (p - LOW) / SIZE;
    if (q.x > 0.0 && q.x < 1.0 && q.y > 0.0 && q.y < 1.01) {
        float share = shareAt(q.x, eta), slope = (shareAt(q.x + 0.004, eta) - shareAt(q.x - 0.004, eta)) / 0.008;
        fill(max(LOW.y - p.y, p.y - LOW.y - SIZE.y * share), SAND, 1.0);
        float straight = shareAt(0.0, eta), grazing = 1.0 - cos(1.5707963 * q.x), power = grazing * grazing;
        float rise = 7.854 * (1.0 - straight) * power * power * sin(1.5707963 * q.x); // the slope of schlickShare
        curve(SIZE.y * (q.y - schlickShare(1.0 - grazing, straight)), rise * SIZE.y / SIZE.x, 1.2, BLUE);
        curve(SIZE.y * (q.y - share), slope * SIZE.y / SIZE.x, 2.0, ORANGE);
    }
    line2(p, LOW, LOW + vec2(SIZE.x, 0.0), 1.5, INK);
    line2(p, LOW, LOW + vec2(0.0, SIZE.y), 1.5, INK);
    dashes(p, LOW + vec2(angle * SIZE.x, 0.0), LOW + vec2(angle, parting.mirrored) * SIZE, 1.0, INK);
    dot2(p, LOW + vec2(angle, parting.mirrored) * SIZE, 9.0, INK);
    float leaving = degrees(atan(abs(parting.bent.x), abs(parting.bent.y)));
    number(p, vec2(-1.56, 0.86), 90.0 * angle, 1, INK); // ray #°
    if (passed > 0.0)
        number(p, vec2(-1.56, 0.74), leaving, 1, TEAL); // refracted #°
    number(p, vec2(-1.56, 0.62), parting.mirrored, 2, ORANGE); // reflected #
    return sheetColour;
}
