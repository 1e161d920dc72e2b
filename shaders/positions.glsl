// positions.glsl - the position in the picture of a point in space, for any chapter's pixelRay.
#include "inputs.glsl"
#include "scene.glsl"

// Compiled only for the program that finds the positions of points.
#if VIEW == VIEW_POSITIONS

const int HANDLE_POINTS = 24;

uniform sampler2D iMarch;                   // column k, row 1: the position of step k, as a probe wrote it
uniform int iHandlePoints;                  // how many points to find; 0 to find the steps of the march instead
uniform vec3 iHandlePoint[HANDLE_POINTS];   // scene units

// The point whose position is written to column k.
vec3 projectedPoint(int k)
{
    return iHandlePoints > 0 ? iHandlePoint[min(k, HANDLE_POINTS - 1)] : texelFetch(iMarch, ivec2(k, 1), 0).xyz;
}

// The offset from a pixel's ray to a point, perpendicular to the ray, scene units.
//   along  where the ray passes the point, scene units along the ray
vec3 projectionOffset(vec3 p, vec2 pixel, float along)
{
    Ray ray = pixelRay(screenPosition(pixel));
    return p - ray.origin - along * ray.direction;
}

// The position in the picture whose ray passes through a point.
//   returns  (x, y, found, 0): x and y are in pixels, and found is 1 if there is such a position and the point is in
//            front of the camera, and 0 otherwise
//   formula  Gauss-Newton steps from the middle of the picture. Let q be the offset from the ray to the point, and a, b
//            the changes of the ray at the point's distance if the pixel moves by one to the right or by one upwards,
//            all perpendicular to the ray; a step minimises |q - x a - y b|. A parallel view converges at once; in
//            other views a step is as long as the sine of the remaining angle and never overshoots
vec4 projectedPixel(vec3 p)
{
    vec2 pixel = 0.5 * iResolution.xy;
    float missed = 1e9, t = 0.0;
    for (int i = 0; i < 12; i++) {
        Ray ray = pixelRay(screenPosition(pixel));
        t = dot(p - ray.origin, ray.direction);
        float far = length(p - ray.origin);
        vec3 q = projectionOffset(p, pixel, t), there = projectionOffset(p, pixel, far);
        vec3 a = there - projectionOffset(p, pixel + vec2(1.0, 0.0), far);
        vec3 b = there - projectionOffset(p, pixel + vec2(0.0, 1.0), far);
        a -= dot(a, ray.direction) * ray.direction;
        b -= dot(b, ray.direction) * ray.direction;
        float aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), determinant = aa * bb - ab * ab;
        vec2 way = vec2(bb * dot(a, q) - ab * dot(b, q), aa * dot(b, q) - ab * dot(a, q)) / max(determinant, 1e-30);
        missed = determinant > 1e-30 ? length(way) : 1e9;
        pixel += clamp(way, -4.0 * iResolution.y, 4.0 * iResolution.y);
    }
    return vec4(pixel, missed < 0.5 && t > -1e-3 ? 1.0 : 0.0, 0.0);
}

#endif
