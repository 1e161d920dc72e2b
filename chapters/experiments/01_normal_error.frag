// Experiment of chapter 01: the error of the normal, plotted against the step of the differences and measured by the
// GPU itself. For each column of pixels, the normal is computed at 512 points on a unit ball, whose centre is 10 units
// from the origin, and the root mean square of the errors is shown. Central differences are yellow, forward differences
// blue.
//
// The horizontal axis is the step, from 1e-5 to 1; the vertical axis is the angle between the computed and the true
// normal, from 1e-4 to 100 degrees. There is a line at each power of ten; the brighter ones are at a step of 0.001 and
// at an angle of 0.01 degrees.
#include "main.glsl"
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdSphere

const vec3 CENTRE = vec3(0.0, 0.0, 10.0);
const int  POINTS = 512;

// The position in the plot is stored in the ray's origin: x from 0 to 5, y from 0 to 6, one unit per power of ten.
Ray pixelRay(vec2 screen)
{
    vec2 point = vec2(2.5, 3.0) + vec2(2.5, 3.0) * screen * vec2(iResolution.y / iResolution.x, 1.0);
    return Ray(vec3(point, 0.0), vec3(0.0, 0.0, -1.0));
}

float sceneDistance(vec3 p)
{
    return sdSphere(p - CENTRE, 1.0);
}

vec3 forwardNormal(vec3 p, float h)
{
    float here = distanceAt(p);
    vec3 gradient = vec3(0.0);
    for (int i = 0; i < 3; i++) {
        vec3 axis = vec3(i == 0, i == 1, i == 2);
        gradient += axis * (distanceAt(p + h * axis) - here);
    }
    float size = length(gradient);
    return size > 0.0 ? gradient / size : vec3(0.0);
}

// The root mean square, over the ball, of the angle between the computed and the true normal, in degrees, for central
// and forward differences. Each point uses a different step, from h to 1.1 h, so that rounding is not favourable at all
// points at once.
vec2 typicalAngles(float h)
{
    vec2 squares = vec2(0.0);
    for (int i = 0; i < POINTS; i++) {
        // The points are on a spiral, with equal steps in z and the golden angle between neighbours.
        float z = 1.0 - (2.0 * float(i) + 1.0) / float(POINTS);
        float turn = 2.39996323 * float(i);
        vec3 p = CENTRE + vec3(sqrt(1.0 - z * z) * vec2(cos(turn), sin(turn)), z);
        vec3 normal = normalize(p - CENTRE);
        float step = h * (1.0 + 0.1 * fract(0.618034 * float(i)));
        vec3 central = normalAt(p, step) - normal;
        vec3 forward = forwardNormal(p, step) - normal;
        squares += vec2(dot(central, central), dot(forward, forward));
    }
    return degrees(sqrt(squares / float(POINTS))); // a short chord is about as long as its arc
}

vec3 rayColour(Ray ray)
{
    vec2 point = ray.origin.xy;
    vec2 angles = typicalAngles(pow(10.0, point.x - 5.0));
    vec2 curve = log2(max(angles, 1e-6)) / log2(10.0) + 4.0;
    vec2 apartFrom = 25.0 * (point.y - curve); // soft lines, 0.07 units wide at half strength
    vec2 cover = exp(-apartFrom * apartFrom);

    vec2 power = floor(point + 0.5);
    vec2 apart = abs(point - power) * vec2(1.2 * iResolution.x / iResolution.y, 1.0);
    vec3 colour = vec3(0.09, 0.10, 0.13);
    if (min(apart.x, apart.y) < 4.0 / iResolution.y) {
        bool main = (apart.x < apart.y && power.x == 2.0) || (apart.y <= apart.x && power.y == 2.0);
        colour = main ? vec3(0.45) : vec3(0.22);
    }
    colour = mix(colour, vec3(0.35, 0.65, 1.0), cover.y);
    return mix(colour, vec3(1.0, 0.85, 0.3), cover.x);
}
