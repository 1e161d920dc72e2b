// texture.glsl - pictures on surfaces that have no texture coordinates: where to look up a picture, how
// wide the pixel is there, and how a height becomes a bump.
//
// Every lookup is given its footprint. The derivatives that a driver computes itself compare neighbouring
// pixels; if one of these pixels hits a surface and another misses, the derivatives are undefined.
#include "scene.glsl"

// The area of a surface that one pixel covers: an ellipse, given by its two full axes.
struct Footprint {
    vec3 across; // scene units: perpendicular to the ray and to the normal, the short axis
    vec3 along;  // scene units: the long axis, longer the closer the ray is to grazing
};

// The ellipse in which a ray of circular cross-section cuts a surface.
//   direction  of the ray, length 1
//   normal     of the surface, length 1
//   width      of the ray where it meets the surface, scene units: 2 pixelSpread() t for one pixel
//   formula    across = width a, along = width b / max(|dot(direction, normal)|, 1/16), a the unit vector along
//              cross(direction, normal) and b = cross(a, normal); at normal incidence any a will do
// Hardware without anisotropic filtering uses the longer axis for both directions: along the ray the mip level is
// right, but across the ray the picture is too blurred, by the ratio of the axes.
// Source: P. Heckbert, 'Survey of texture mapping', IEEE Computer Graphics and Applications 6 (1986).
Footprint footprintOn(vec3 direction, vec3 normal, float width)
{
    vec3 a = cross(direction, normal), other = cross(direction, abs(direction.y) < 0.8 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0));
    a = normalize(dot(a, a) > 1e-6 ? a : other);
    return Footprint(width * a, width / max(abs(dot(direction, normal)), 0.0625) * cross(a, normal));
}

// A footprint in the coordinates of an object that is rotated and whose texture is scaled.
//   turn     a rotation, as in Pose in transform.glsl
//   scale    repeats of the texture per scene unit, > 0
Footprint footprintSeen(Footprint f, mat3 turn, float scale)
{
    return Footprint(scale * f.across * turn, scale * f.along * turn);
}

// ---- In space ----

// The value of a volume texture at p, as if the object were cut from a block of this material.
//   p        in repeats of the volume
vec4 textureInSpace(sampler3D volume, vec3 p, Footprint f)
{
    return textureGrad(volume, p, f.across, f.along);
}

// ---- Projected along an axis ----

// A point of a picture that is projected onto the scene along an axis.
struct Slide {
    vec2 at;     // in repeats of the picture
    vec2 across; // the footprint, in repeats
    vec2 along;
};

// The position of a point in a picture projected along an axis, the same at every depth.
//   p, f     in repeats of the picture
//   axis     0: along x, at (z, y); 1: along y, at (x, z); 2: along z, at (x, y). On walls, y is up
Slide slideAlong(vec3 p, Footprint f, int axis)
{
    if (axis == 0)
        return Slide(p.zy, f.across.zy, f.along.zy);
    if (axis == 1)
        return Slide(p.xz, f.across.xz, f.along.xz);
    return Slide(p.xy, f.across.xy, f.along.xy);
}

// The picture at a point, averaged over the footprint using the picture's mipmaps.
vec4 textureOnSlide(sampler2D picture, Slide slide)
{
    return textureGrad(picture, slide.at, slide.across, slide.along);
}

// A picture projected from above. On a slope it is stretched by 1 / |normal.y|, on a wall without limit.
//   p, f     in repeats of the picture
vec4 textureFromAbove(sampler2D picture, vec3 p, Footprint f)
{
    return textureOnSlide(picture, slideAlong(p, f, 1));
}

// The weights of three pictures: those projected along x, along y and along z.
//   normal     length 1
//   sharpness  >= 1: how strongly the picture that the surface faces dominates; in the limit only that picture remains
//   formula    |normal|^sharpness, per component, divided by the sum of the three, so the weights sum to 1
// Source: R. Geiss, 'Generating complex procedural terrains using the GPU', GPU Gems 3 (2007), chapter 1.
vec3 planeWeights(vec3 normal, float sharpness)
{
    vec3 w = pow(abs(normal), vec3(sharpness));
    return w / (w.x + w.y + w.z);
}

// A picture projected along three axes, with a weight for each.
//   p, f     in repeats of the picture
//   weights  from planeWeights or twoPlaneWeights, or 1 for one axis and 0 for the others
//   formula  weights.x picture(z, y) + weights.y picture(x, z) + weights.z picture(x, y)
// A weight of 0 costs no lookup.
vec4 textureOnPlanes(sampler2D picture, vec3 p, Footprint f, vec3 weights)
{
    vec4 sum = vec4(0.0);
    int last = weights.z > 0.0 ? 2 : (weights.y > 0.0 ? 1 : 0);
    for (int axis = weights.x > 0.0 ? 0 : (weights.y > 0.0 ? 1 : 2); axis <= last; axis += weights.y > 0.0 ? 1 : 2)
        sum += weights[axis] * textureOnSlide(picture, slideAlong(p, f, axis));
    return sum;
}

// The weights of the two most important projections. The third weight is 0, and each weight falls to 0 continuously.
// Two lookups cost a third less than three.
//   weights  from planeWeights
//   formula  weights minus the smallest weight, divided by their new sum; (1, 0, 0) if all are equal
// The weights are continuous except in the eight diagonal directions, where all are equal: no method that drops the
// smallest weight is continuous there.
vec3 twoPlaneWeights(vec3 weights)
{
    vec3 w = weights - min(weights.x, min(weights.y, weights.z));
    float sum = w.x + w.y + w.z;
    return sum > 0.0 ? w / sum : vec3(1.0, 0.0, 0.0);
}

// ---- Bumps ----

// A picture of heights that is projected along an axis: the height (x) and its gradient in space (yzw), per
// repeat, 0 along the axis.
//   slide, axis  from slideAlong, with that axis
//   reach        step of the differences, in repeats: about a texel, and at least a pixel
//   wanted       false if only the height is needed, which takes one lookup instead of three
//   formula      forward differences of the first channel over reach; the error is O(reach)
vec4 heightOnSlide(sampler2D heights, Slide slide, int axis, float reach, bool wanted)
{
    vec3 h = vec3(0.0);
    int taps = wanted ? 3 : 1;
    for (int i = 0; i < taps; i++) {
        Slide moved = Slide(slide.at + reach * vec2(i == 1, i == 2), slide.across, slide.along);
        h[i] = textureOnSlide(heights, moved).x;
    }
    vec2 slope = wanted ? (h.yz - h.x) / reach : vec2(0.0);
    vec3 gradient = axis == 0 ? vec3(0.0, slope.yx) : (axis == 1 ? vec3(slope.x, 0.0, slope.y) : vec3(slope, 0.0));
    return vec4(h.x, gradient);
}

// The normal that a surface would have if it were raised by a height.
//   normal    of the smooth surface, length 1
//   gradient  of the height in space, per scene unit: from noise or from a picture of heights
//   returns   length 1
//   formula   normalize(normal - g), g the component of the gradient tangent to the surface: exact on a plane;
//             otherwise the error is about height times curvature
// Source: J. F. Blinn, 'Simulation of wrinkled surfaces', SIGGRAPH 1978.
vec3 bumpedNormal(vec3 normal, vec3 gradient)
{
    return normalize(normal - gradient + dot(gradient, normal) * normal);
}
