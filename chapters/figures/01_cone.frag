// The cone under a graph: drag the point and the ball. Above is the march of a ray to the right; below is the graph of
// the distance along the ray. This graph never enters the cone below one of its points, so no step goes past the
// surface. With a factor above 1, the graph enters these cones, and a step may go too far.
#include "figure.glsl"

uniform vec2 point;   // (-1.15, 0.46) handle: start of the ray
uniform vec2 ball;    // (0.05, 0.73) handle: centre of the ball
uniform float factor; // 1 in [0.5, 2] step 0.05, times the distance: length of each step

const float AXIS = -0.72; // height of the graph's axis

float sceneDistance(vec3 p)
{
    float box = sdRectangle(p.xy - vec2(1.3, 0.46), vec2(0.24, 0.32));
    return factor * min(sdCircle(p.xy - ball, 0.21), min(box, sdCircle(p.xy - vec2(-0.6, 0.2), 0.12)));
}

// The length of the step that starts at position x on the ray's line.
float along(float x)
{
    return sceneDistance(vec3(x, point.y, 0.0));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    if (p.y > 0.0) {
        float d = sceneDistance(vec3(p, 0.0)) / factor, t;
        dashes(p, point, vec2(1.9, point.y), 1.0, PALE);
        drawMarch(p, point, vec2(1.0, 0.0), 4.0, 0.004, 48, t);
        fill(d, SAND, 1.0);
        stroke(d, 2.0, ORANGE);
        dot2(p, point, 7.0, INK);
        dot2(p, point + vec2(t, 0.0), 5.0, INK); // the end of the march, even if the last step went too far
    } else {
        float cone = 1e6, rim = 1e6, spot = 1e6, x = point.x, h = 1.0, e = sheetPixel();
        for (int i = 0; i < 48 && h > 0.004 && x < 2.0; i++) {
            h = along(x);
            float side = (p.y - AXIS + abs(p.x - x) - h) * 0.7071; // signed distance to both sides of the cone
            cone = min(cone, max(side, AXIS - p.y));
            rim = min(rim, p.y > AXIS ? abs(side) : 1e6);
            spot = min(spot, length(p - vec2(x, AXIS + h)));
            x += h;
        }
        fill(cone, SKY, 0.55);
        stroke(rim, 1.2, BLUE);
        line2(p, vec2(-1.9, AXIS), vec2(1.9, AXIS), 1.0, INK);
        float f = along(p.x), slope = (along(p.x + e) - along(p.x - e)) / (2.0 * e);
        curve(p.y - AXIS - f, slope, 2.0, ORANGE);
        fill(spot - penWidth(2.5), INK, 1.0);
    }
    line2(p, vec2(-1.9, 0.0), vec2(1.9, 0.0), 1.0, PALE);
    return sheetColour;
}
