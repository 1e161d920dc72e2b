// The distance to two discs: drag the point and the discs. The number is the distance to the nearer disc; no disc
// reaches into the blue circle of this radius. Rings join points of equal distance. Inside a disc the distance is
// negative.
#include "figure.glsl"

uniform vec2 point;  // (0.0, 0.42) handle: where the distance is evaluated
uniform vec2 first;  // (-0.75, -0.15) handle: centre of the large disc
uniform vec2 second; // (0.85, -0.1) handle: centre of the small disc

float sceneDistance(vec3 p)
{
    return min(sdCircle(p.xy - first, 0.5), sdCircle(p.xy - second, 0.3));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    float d = sceneDistance(vec3(p, 0.0)), f = sceneDistance(vec3(point, 0.0));
    float ring = 0.1 * (abs(fract(10.0 * d) - 0.5) - 0.5); // minus the distance from d to the nearest multiple of 0.1
    bool nearFirst = sdCircle(point - first, 0.5) < sdCircle(point - second, 0.3);
    vec2 towards = normalize((nearFirst ? first : second) - point + 1e-6);
    fill(d, SAND, 1.0);
    float circle = sdCircle(p - point, abs(f));
    fill(circle, f > 0.0 ? SKY : PAPER, 0.75);
    stroke(ring, 0.8, PALE);
    stroke(d, 2.0, ORANGE);
    stroke(circle, 2.0, f > 0.0 ? BLUE : ORANGE);
    line2(p, point, point + f * towards, 2.0, TEAL);
    dot2(p, point + f * towards, 6.0, TEAL);
    dot2(p, point, 7.0, INK);
    number(p, point + vec2(0.0, 0.09), f, 2, INK); // distance #
    return sheetColour;
}
