// places.glsl - where a point of space is in the picture, whatever the chapter's pixelRay.
#include "inputs.glsl"
#include "scene.glsl"

// Compiled only for the program that looks for the steps of a march.
#if VIEW == 9

uniform sampler2D iMarch; // column k, row 1: the position of step k, as a probe wrote it

// How far the ray of a pixel passes from a point, square to the ray, scene units.
//   along  where it passes, scene units along that ray
vec3 placeMissed(vec3 p, vec2 pixel, float along)
{
    Ray ray = pixelRay(screenPosition(pixel));
    return p - ray.origin - along * ray.direction;
}

// The place of the picture whose ray goes through a point.
//   returns  x and y in pixels, 1 where there is such a ray in front of the camera, else 0
//   formula  Gauss-Newton steps from the middle: with the way q from the ray to the point, and a, b what one
//            pixel to the right and one up add to the ray as far away as the point, all square to the ray, the
//            least |q - x a - y b|. A parallel view is there at once; in others a step is as long as the sine of
//            the angle that is left, which never leads beyond
vec4 placeOf(vec3 p)
{
    vec2 pixel = 0.5 * iResolution.xy;
    float missed = 1e9, t = 0.0;
    for (int i = 0; i < 12; i++) {
        Ray ray = pixelRay(screenPosition(pixel));
        t = dot(p - ray.origin, ray.direction);
        float far = length(p - ray.origin);
        vec3 q = placeMissed(p, pixel, t), there = placeMissed(p, pixel, far);
        vec3 a = there - placeMissed(p, pixel + vec2(1.0, 0.0), far);
        vec3 b = there - placeMissed(p, pixel + vec2(0.0, 1.0), far);
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
