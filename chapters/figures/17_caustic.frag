// A ball focuses light: drag the point through the light behind the ball, the ball, and the direction to the far lamp.
// At the top left is the brightness of the point, which is 1 without the ball.
#include "figure.glsl"
#include "caustic.glsl"

uniform vec2 spot;    // (0.35, 0.0) handle: the point
uniform vec2 ball;    // (-0.55, 0.0) handle: centre of the ball
uniform vec2 lamp;    // (-1.5, 0.0) handle: direction of the far lamp, seen from the centre of the sheet
uniform float index;  // 1.5 in [1.02, 1.53] step 0.01: index of refraction of the ball
uniform float spread; // 0.06 in [0.005, 0.3] step *1.2: radius of the lamp's disc at a distance of one unit

const float RADIUS = 0.5;
const int RAYS = 11;

float sceneDistance(vec3 p)
{
    return sdCircle(p.xy - ball, RADIUS);
}

// The light at q, relative to the ball's centre: light that passes beside the ball, and light that the ball focuses.
// Without the ball, the light is 1.
float lightAt(vec2 q, vec2 toLamp)
{
    float z = -dot(q, toLamp), r = length(q + z * toLamp);
    float beside = z > 0.0 ? coverage(r - RADIUS, max(spread * z, sheetPixel())) : 1.0;
    return length(q) < RADIUS ? 1.0 : beside + ballCaustic(vec3(q, 0.0), vec3(toLamp, 0.0), RADIUS, index, spread);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), toLamp = normalize(lamp + 1e-6), across = vec2(-toLamp.y, toLamp.x);
    float d = sceneDistance(vec3(p, 0.0)), light = lightAt(p - ball, toLamp);
    // From night to the brightest colour: a light of 1 is a third of the way, and a light of 4 is two thirds.
    sheetColour = mix(0.7 * NIGHT, GLOW, light / (light + 2.0));

    // Parallel rays: each is turned by the angle of incidence minus that of refraction where it enters, and by the same
    // angle where it leaves.
    float path = 1e6;
    for (int k = 0; k < RAYS; k++) {
        float sine = 0.96 * (2.0 * float(k) / float(RAYS - 1) - 1.0), cosine = sqrt(1.0 - sine * sine);
        vec2 enter = ball + RADIUS * (sine * across + cosine * toLamp);
        vec2 inside = refract(-toLamp, (enter - ball) / RADIUS, 1.0 / index);
        vec2 leave = enter - 2.0 * dot(enter - ball, inside) * inside;
        vec2 away = refract(inside, (ball - leave) / RADIUS, index);
        path = min(path, min(sdSegment(p, enter + 4.0 * toLamp, enter), sdSegment(p, enter, leave)));
        path = min(path, sdSegment(p, leave, leave + 4.0 * away));
    }
    fill(d, BLUE, 0.35);
    fill(path - penWidth(0.4), GLOW, 0.55);
    stroke(d, 2.0, BLUE);
    dot2(p, spot, 11.0, CHALK);
    dot2(p, spot, 8.0, ORANGE);
    if (p.x < -1.3 && p.y > 0.7) // the number is computed only where it is shown
        number(p, vec2(-1.56, 0.86), lightAt(spot - ball, toLamp), 1, CHALK); // brightness #
    return sheetColour;
}
