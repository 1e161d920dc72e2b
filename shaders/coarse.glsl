// coarse.glsl - the coarse pass: one march per block of 8 x 8 pixels finds a distance before which no ray of
// the block meets anything.
//
// Before each picture the harness marches a cone for each block (VIEW_COARSE), and the rays of the block's pixels
// begin where that march ended. The pass runs only in programs that call coarseStart.
//
// The pass loses nothing, for the following reason. The ball of radius r(t) = radius + t spread around the axis at t
// contains the points at t of all rays of the block. Let the cone be at t, where the scene is at distance d. Let m be
// at least coarseMargin at all points up to t + d. Farther on, at t + h, a point of a ray is at most
// sqrt(r(t + h)^2 + 2 h ahead + h^2) from the axis point at t. While this root is at most d - m, the point lies in the
// empty ball of radius d, at least m from its rim, so the scene is at least m away. The root grows with h, so the
// same is true of all points in between. The step is the largest such h, the root of a quadratic; if there is none,
// the cone's march ends there, at the start of the block's rays. At every t before the start, the march of any of these
// rays would have gone on. Therefore a march from the start misses no surface and no point that counts as a hit.
//
// Requirements for a chapter:
// - sceneDistance is a lower bound, so that no surface is missed, and 1-Lipschitz, so that the margin is
//   kept; any step factor that this requires is part of sceneDistance. The pass ignores anything that
//   sceneDistance leaves out, such as a ground with a separate distance.
// - pixelRay: the rays of a block start in the convex hull of the four corner rays' origins and point into the
//   cone of the corner rays' directions (each direction is a combination of the four with weights >= 0). This is
//   true of perspectiveRay, orthographicRay and projectionRay, because origin and unnormalised direction are affine
//   functions of the screen position. If a sample moves its ray farther, as with a lens, add that amount to
//   coarseMargin.
// - coarseMargin exceeds the rounding error of a float: about 1e-6 of p and t.
// docs/16_fewer_steps.md has the full proof. Source: J. C. Hart's sphere tracing along the cones of
// J. Amanatides, SIGGRAPH 1984; demo programmers call such a first pass cone marching.
#include "inputs.glsl"
#include "scene.glsl"

const int COARSE_BLOCK = 8; // side of a block, pixels

// Defined by the chapter: how far from the scene the point at t of a ray must be for the march to go on. This
// is the largest threshold that counts as a hit there, plus the distance by which samples move the ray.
//   t        scene units along the ray, >= 0
//   returns  scene units, > 0; must not decrease as t grows
float coarseMargin(float t);

#ifndef EXPORTED

uniform bool coarsePass; // true: rays begin where the march of their block of 8 x 8 pixels has ended

uniform sampler2D iCoarse; // one texel per block of the picture, as coarseBlock wrote it

#endif

// Where the march of a pixel's ray may begin: every earlier point is farther from the scene than
// coarseMargin. A chapter whose march begins later for another reason, such as a box, takes the larger value.
//   ray      from pixelRay, for the pixel iPixel, whose block is looked up
//   returns  scene units along the ray, >= 0; 0 if the pass is switched off, and in an exported file,
//            which has no pass
float coarseStart(Ray ray)
{
#ifdef EXPORTED
    return 0.0;
#else
    return coarsePass ? texelFetch(iCoarse, iPixel / COARSE_BLOCK, 0).x : 0.0;
#endif
}

// Compiled only for the coarse pass.
#if VIEW == VIEW_COARSE

const int   COARSE_STEPS = 64;    // limit on the steps of a block's march
const float COARSE_FAR = 100.0;   // where the march ends at the latest, scene units

// A cone that contains the rays of a block: a ball around each point of the axis.
struct Cone {
    Ray axis;
    float radius; // of the ball at t = 0: no ray starts farther from the origin of the axis
    float spread; // how fast the radius grows, per scene unit: no direction differs from that of the axis by more
    float ahead;  // how far in front of the axis's origin, along the axis, a ray may start
};

// The cone around all rays through a rectangle of the picture, computed from the rays through its corners.
//   low, high  opposite corners, pixels
//   formula    origin and direction of the axis are the means of those of the corner rays; radius, spread and ahead
//              are the largest |o - origin|, |d - direction| and (o - origin) . direction of a corner ray. A ball
//              that contains four points contains their convex hull; and the component along the axis of a unit
//              vector between the four directions is at least the smallest of their four components, so no
//              direction is farther from the axis.
Cone coneOfPixels(vec2 low, vec2 high)
{
    Ray corner[4];
    Ray axis = Ray(vec3(0.0), vec3(0.0));
    for (int i = 0; i < 4; i++) {
        vec2 pixel = vec2(i % 2 == 0 ? low.x : high.x, i < 2 ? low.y : high.y);
        corner[i] = pixelRay(screenPosition(pixel));
        axis.origin += 0.25 * corner[i].origin;
        axis.direction += corner[i].direction;
    }
    axis.direction = normalize(axis.direction);
    Cone cone = Cone(axis, 0.0, 0.0, 0.0);
    for (int i = 0; i < 4; i++) {
        vec3 aside = corner[i].origin - axis.origin;
        cone.radius = max(cone.radius, length(aside));
        cone.spread = max(cone.spread, length(corner[i].direction - axis.direction));
        cone.ahead = max(cone.ahead, dot(aside, axis.direction));
    }
    return cone;
}

// How far the cone's march may advance from t.
//   distance  of the scene from the axis point at t, scene units
//   returns   the largest h >= 0 with r(t + h)^2 + 2 h ahead + h^2 <= (distance - margin)^2, with the margin
//             at t + distance; 0 if there is none
float coneStep(Cone cone, float t, float distance)
{
    float empty = distance - coarseMargin(t + max(distance, 0.0));
    float radius = cone.radius + t * cone.spread;
    float a = 1.0 + cone.spread * cone.spread, b = cone.spread * radius + cone.ahead;
    float root = sqrt(max(b * b + a * (empty * empty - radius * radius), 0.0));
    return empty > radius ? (root - b) / a : 0.0;
}

// March the cone of a block of pixels.
//   block    index of the block, (0, 0) at the bottom left
//   returns  where the block's rays may start, scene units along the rays, and the number of evaluations of the scene
vec2 coarseBlock(ivec2 block)
{
    iPixel = COARSE_BLOCK * block;
    vec2 low = vec2(iPixel), high = min(low + float(COARSE_BLOCK), iResolution.xy);
    Cone cone = coneOfPixels(low, high);
    float t = 0.0, advance = 1.0;
    for (int i = 0; i < COARSE_STEPS && advance > 0.0 && t < COARSE_FAR; i++) {
        advance = coneStep(cone, t, distanceAt(cone.axis.origin + t * cone.axis.direction));
        t += advance;
    }
    return vec2(t, float(trace.evaluations));
}

#endif
