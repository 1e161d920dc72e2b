// texture.glsl - pictures on surfaces that have no coordinates of their own: where to look them up, how
// wide the pixel is there, and how a height becomes a bump.
//
// Every lookup is given its footprint. The derivatives that a driver takes by itself compare neighbouring
// pixels, and where one of them hits and the other misses, they are undefined.
#include "scene.glsl"

// What one pixel covers of a surface: an ellipse, given by its two axes, from one pixel to the next.
struct Footprint {
    vec3 across; // scene units: perpendicular to the ray and to the normal, the short axis
    vec3 along;  // scene units: drawn out the more, the flatter the ray meets the surface
};

// The ellipse that a ray of circular section cuts out of a surface.
//   direction  of the ray, length 1
//   normal     of the surface, length 1
//   width      of the ray where it meets the surface, scene units: 2 pixelSpread() t for one pixel
//   formula    across = width a, along = width b / max(|dot(direction, normal)|, 1/16), a the unit vector along
//              cross(direction, normal) and b = cross(a, normal); looked at straight on, any a will do
// Hardware without anisotropic filtering takes the longer axis for both: along the ray the level is
// right, across it the picture is blurred by the ratio of the axes.
// Source: P. Heckbert, 'Survey of texture mapping', IEEE Computer Graphics and Applications 6 (1986).
Footprint footprintOn(vec3 direction, vec3 normal, float width)
{
    vec3 a = cross(direction, normal), other = cross(direction, abs(direction.y) < 0.8 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0));
    a = normalize(dot(a, a) > 1e-6 ? a : other);
    return Footprint(width * a, width / max(abs(dot(direction, normal)), 0.0625) * cross(a, normal));
}

// A footprint seen by a thing that is turned and k times as large: in its own coordinates.
//   turn     a rotation, as of Pose in transform.glsl
//   scale    repeats of the texture a scene unit, > 0
Footprint footprintSeen(Footprint f, mat3 turn, float scale)
{
    return Footprint(scale * f.across * turn, scale * f.along * turn);
}

// ---- In space ----

// A volume at p, as if the thing were cut from a block of it.
//   p        in repeats of the volume
vec4 textureInSpace(sampler3D volume, vec3 p, Footprint f)
{
    return textureGrad(volume, p, f.across, f.along);
}

// ---- Thrown along an axis ----

// A place in a picture that is thrown on the scene along an axis.
struct Slide {
    vec2 at;     // in repeats of the picture
    vec2 across; // the footprint, in repeats
    vec2 along;
};

// Where a point lies in a picture thrown along an axis, at every depth the same.
//   p, f     in repeats of the picture
//   axis     0: along x, at (z, y); 1: along y, at (x, z); 2: along z, at (x, y): on walls y is up
Slide slideAlong(vec3 p, Footprint f, int axis)
{
    if (axis == 0)
        return Slide(p.zy, f.across.zy, f.along.zy);
    if (axis == 1)
        return Slide(p.xz, f.across.xz, f.along.xz);
    return Slide(p.xy, f.across.xy, f.along.xy);
}

// The picture there, averaged over the footprint by its mipmaps.
vec4 textureOnSlide(sampler2D picture, Slide slide)
{
    return textureGrad(picture, slide.at, slide.across, slide.along);
}

// A picture thrown from above. On a slope it is drawn out by 1 / |normal.y|, on a wall without end.
//   p, f     in repeats of the picture
vec4 textureFromAbove(sampler2D picture, vec3 p, Footprint f)
{
    return textureOnSlide(picture, slideAlong(p, f, 1));
}

// How much each of three pictures counts: those thrown along x, along y, along z.
//   normal     length 1
//   sharpness  >= 1: how fast the one that the surface faces wins; without end, it alone is left
//   formula    |normal|^sharpness, per component, over the sum of the three: they add up to 1
// Source: R. Geiss, 'Generating complex procedural terrains using the GPU', GPU Gems 3 (2007), chapter 1.
vec3 planeWeights(vec3 normal, float sharpness)
{
    vec3 w = pow(abs(normal), vec3(sharpness));
    return w / (w.x + w.y + w.z);
}

// A picture thrown along three axes, each as much as its weight says.
//   p, f     in repeats of the picture
//   weights  of planeWeights or twoPlaneWeights, or 1 for one of them and 0 for the others
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

// The weights of the two that count most; the third is 0, and gets there without a jump: the cheaper way,
// by a third.
//   weights  of planeWeights
//   formula  weights less the least of them, over what is then their sum; (1, 0, 0) where all are equal
// Continuous but there, in the eight diagonal directions: nothing that leaves out the least is.
vec3 twoPlaneWeights(vec3 weights)
{
    vec3 w = weights - min(weights.x, min(weights.y, weights.z));
    float sum = w.x + w.y + w.z;
    return sum > 0.0 ? w / sum : vec3(1.0, 0.0, 0.0);
}

// ---- Bumps ----

// A picture of heights that is thrown along an axis: the height (x) and its gradient in space (yzw), per
// repeat, 0 along the axis.
//   slide, axis  of slideAlong, with that axis
//   reach        how far apart the heights are taken, in repeats: about a texel, and not less than a pixel
//   wanted       false: the height is enough, one lookup in place of three
//   formula      forward differences over reach of the first channel; error O(reach)
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

// The normal of a surface that is raised by a height, without raising it.
//   normal    of the smooth surface, length 1
//   gradient  of the height in space, per scene unit: of what the noise says, or of a picture of heights
//   returns   length 1
//   formula   normalize(normal - g), g the part of the gradient that lies in the surface: exact on a plane,
//             else up to height times curvature
// Source: J. F. Blinn, 'Simulation of wrinkled surfaces', SIGGRAPH 1978.
vec3 bumpedNormal(vec3 normal, vec3 gradient)
{
    return normalize(normal - gradient + dot(gradient, normal) * normal);
}
