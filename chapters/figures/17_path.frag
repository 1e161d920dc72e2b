// The march inside: drag the eye, the point it is aimed at, and the ball of glass. Outside, the length of a step is the
// distance (orange circles); inside, it is minus the distance (blue circles). The reflected part of the light, dashed,
// is not followed.
#include "figure.glsl"
#include "glass.glsl"

uniform vec2 eye;    // (-1.5, 0.42) handle: where the ray starts
uniform vec2 aim;    // (-0.8, 0.36) handle: where the ray points
uniform vec2 ball;   // (-0.28, 0.08) handle: centre of the ball
uniform float index; // 1.52 in [1, 2] step 0.02: index of refraction of the glass

const float THRESHOLD = 0.005;

float sceneDistance(vec3 p)
{
    return min(sdCircle(p.xy - ball, 0.55), sdRectangle(p.xy - vec2(1.02, 0.0), vec2(0.16, 0.8)));
}

// The normal of the nearest surface.
vec2 normalOf(vec2 p)
{
    vec2 e = vec2(0.001, 0.0);
    return normalize(vec2(sceneDistance(vec3(p + e.xy, 0.0)) - sceneDistance(vec3(p - e.xy, 0.0)),
                          sceneDistance(vec3(p + e.yx, 0.0)) - sceneDistance(vec3(p - e.yx, 0.0))) + 1e-9);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), from = eye, direction = normalize(aim - eye + 1e-6);
    float glass = sceneDistance(vec3(p, 0.0)), side = sceneDistance(vec3(eye, 0.0)) < 0.0 ? -1.0 : 1.0;
    float outside = 1e6, within = 1e6, path = 1e6, spots = 1e6;
    vec2 mirrorFrom[2] = vec2[2](vec2(9.0), vec2(9.0)), mirrorTo[2] = vec2[2](vec2(9.0), vec2(9.0));
    int met = 0;
    bool going = true;

    // As in wayThrough of the chapter, follow the transmitted ray from surface to surface, or the reflected one if
    // there is no transmitted ray.
    for (int k = 0; k < 5 && going; k++) {
        float t = 0.0, d = 1.0;
        for (int i = 0; i < 32 && d > THRESHOLD && t < 2.6; i++) {
            vec2 at = from + t * direction;
            d = side * sceneDistance(vec3(at, 0.0));
            float rim = abs(length(p - at) - abs(d));
            outside = side > 0.0 ? min(outside, rim) : outside;
            within = side < 0.0 ? min(within, rim) : within;
            spots = min(spots, length(p - at));
            t += d > THRESHOLD ? d : 0.0;
        }
        vec2 end = from + t * direction, normal = normalOf(end);
        path = min(path, sdSegment(p, from, end + 1e-5));
        going = d <= THRESHOLD;
        Parting parting = partingAt(vec3(direction, 0.0), vec3(normal, 0.0), side, index);
        bool back = parting.mirrored >= 1.0;
        if (going && !back && met < 2) {
            mirrorFrom[met] = end;
            mirrorTo[met] = end + 0.3 * parting.away.xy;
            met++;
        }
        direction = back ? parting.away.xy : parting.bent.xy;
        side = back ? side : -side;
        from = end + (dot(normal, direction) > 0.0 ? 2.5 : -2.5) * THRESHOLD * normal;
    }

    fill(glass, SKY, 1.0);
    fill(outside - 0.5 * penWidth(1.2), ORANGE, 0.8);
    stroke(within, 1.2, BLUE);
    stroke(glass, 2.0, BLUE);
    for (int i = 0; i < 2; i++)
        dashes(p, mirrorFrom[i], mirrorTo[i], 1.6, ORANGE);
    fill(min(path - penWidth(1.2), spots - penWidth(2.0)), INK, 1.0);
    dot2(p, eye, 9.0, INK);
    return sheetColour;
}
