// The normal from four values: drag the point along the surface, and change the step h. The arrow is the normal that
// normalAt computes from the values at the four dots, and the dashed line is the true normal. The number is the angle
// between them, in degrees.
#include "figure.glsl"
#include "normal.glsl"

uniform vec2 point; // (0.58, 0.55) handle: a point near the surface
uniform float h;    // 0.3 in [0.01, 0.6] step 0.01, units: step of the differences

float sceneDistance(vec3 p)
{
    float beam = sdRectangle(p.xy - vec2(0.7, 0.0), vec2(0.12, 0.72));
    return min(sdCircle(p.xy - vec2(-0.7, -0.12), 0.5), beam);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    float d = sceneDistance(vec3(p, 0.0));
    vec3 at = vec3(point, 0.0);
    for (int i = 0; i < 4; i++) // move the point onto the surface
        at -= sceneDistance(at) * normalAt(at, 1e-3);
    vec3 right = normalAt(at, 1e-3), found = normalAt(at, h);
    fill(d, SAND, 1.0);
    stroke(d, 2.0, ORANGE);
    line2(p, at.xy - vec2(h, 0.0), at.xy + vec2(h, 0.0), 1.2, BLUE);
    line2(p, at.xy - vec2(0.0, h), at.xy + vec2(0.0, h), 1.2, BLUE);
    vec2 q = abs(p - at.xy); // by symmetry, one call draws all four dots
    dot2(q, q.x > q.y ? vec2(h, 0.0) : vec2(0.0, h), 7.0, BLUE);
    dashes(p, at.xy, at.xy + 0.62 * right.xy, 1.5, INK);
    arrow(p, at.xy, at.xy + 0.5 * found.xy, 2.5, TEAL);
    dot2(p, at.xy, 6.0, INK);
    number(p, vec2(-1.55, 0.85), degrees(angleBetween(right.xy, found.xy)), 1, TEAL); // off by #°
    return sheetColour;
}
