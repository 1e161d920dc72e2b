// A lens has a width: drag the point, the plane in focus, and the rim of the lens. On the right is the image of the
// point on the film: a disc as wide as the orange segment of the plane in focus appears from the lens. The number is
// the diameter of the disc, and the curve shows half of the diameter for all depths.
#include "figure.glsl"
#include "lens.glsl"

uniform vec2 spot;  // (1.05, -0.3) handle: a point that shines
uniform vec2 focus; // (0.1, 0.8) handle: its x is the position of the plane in focus
uniform vec2 rim;   // (-1.35, 0.35) handle: its height is that of the lens's rim

const vec2 LENS = vec2(-1.35, 0.0);

float sceneDistance(vec3 p)
{
    return p.z;
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    float radius = max(abs(rim.y - LENS.y), 0.004), plane = max(focus.x - LENS.x, 0.05);
    float far = max(spot.x - LENS.x, 0.05);
    vec2 point = vec2(LENS.x + far, spot.y), upper = LENS + vec2(0.0, radius), lower = LENS - vec2(0.0, radius);
    // Where the lines from the lens to the point cross the plane in focus. If the point is nearer, the lines are
    // extended.
    float share = plane / far, end = max(share, 1.0);
    vec2 high = mix(upper, point, share), low = mix(lower, point, share), middle = mix(LENS, point, share);

    // Along the bottom: half the diameter of the circle of confusion for a point at any depth.
    float base = -0.94, depth = p.x - LENS.x, blur = 0.5 * circleOfConfusion(max(depth, 0.01), radius, plane, 1.0);
    if (depth > 0.0 && p.y < -0.5) {
        fill(max(base - p.y, p.y - base - blur), SAND, 0.7);
        if (depth > 0.1)
            curve(p.y - base - blur, radius * sign(depth - plane) / (depth * depth), 1.4, ORANGE);
    }
    line2(p, vec2(LENS.x, base), vec2(1.78, base), 1.2, PALE);
    dashes(p, point, vec2(point.x, base), 1.0, PALE);

    dashes(p, vec2(-1.78, 0.0), vec2(1.78, 0.0), 1.0, PALE);
    fill(sdTriangle(p, upper, lower + 1e-5, point + 2e-5), SAND, 0.5);
    line2(p, upper, mix(upper, point, end), 1.6, ORANGE);
    line2(p, LENS, mix(LENS, point, end), 1.2, ORANGE);
    line2(p, lower, mix(lower, point, end), 1.6, ORANGE);
    // The rays of the pixel that shows the point meet in the plane in focus, on the line through the centre of the
    // lens.
    line2(p, upper, middle, 1.0, TEAL);
    line2(p, lower, middle, 1.0, TEAL);
    line2(p, vec2(LENS.x + plane, base), vec2(LENS.x + plane, 0.86), 1.6, INK);
    line2(p, low, high, 5.0, ORANGE);
    line2(p, lower, upper, 5.0, BLUE);
    dot2(p, middle, 8.0, TEAL);
    dot2(p, point, 12.0, ORANGE);
    dot2(p, vec2(point.x, base + 0.5 * circleOfConfusion(far, radius, plane, 1.0)), 7.0, ORANGE);

    // The circle of confusion. The same light, spread over a larger disc, is fainter.
    float size = circleOfConfusion(far, radius, plane, 1.0), shown = max(0.5 * size, 0.01);
    vec2 film = vec2(1.42, 0.6);
    fill(sdRectangle(p - film, vec2(0.3)), 0.7 * NIGHT, 1.0);
    float disc = max(length(p - film) - shown, sdRectangle(p - film, vec2(0.3)));
    fill(disc, GLOW, clamp(0.02 / (shown * shown), 0.08, 1.0));
    number(p, film - vec2(0.0, 0.42), size, 2, INK); // diameter #
    return sheetColour;
}
