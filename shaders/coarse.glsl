// coarse.glsl - the coarse pass: one march for a block of 8 x 8 pixels finds how far none of their rays
// meets anything.
//
// Before each picture the harness marches a cone for each block (VIEW 8), and the pixels begin where it
// ended. It runs where the program calls coarseStart, and only there.
//
// Why nothing is lost. The ball of radius r(t) = radius + t spread around the axis at t holds the points at
// t of all rays of the block. The cone stands at t, where the scene is d away. Take m not less than
// coarseMargin up to t + d. Later, at t + h, a point of a ray is at most sqrt(r(t + h)^2 + 2 h ahead + h^2)
// from where the cone stands; while that is at most d - m, the point lies in the ball of radius d in
// which nothing is, by m from its rim: the scene is at least m away. It grows with h, so all the points
// on the way are as far: the largest h is the step, the root of a square. Where none is, the pass ends.
// So at every t below the start, on every ray of the block, a march would have gone on; none that
// starts there misses a surface, nor a place that it would have counted as a hit.
//
// What it asks of a chapter:
// - sceneDistance is a lower bound, for the surfaces; and 1-Lipschitz, for the rest of the margin. A factor
//   that makes it one is part of it. What sceneDistance does not know, a ground of its own, the pass does not.
// - pixelRay: the rays of a block start in the convex hull of the corners' origins and go in the cone of
//   their directions (a direction is a sum of theirs, weights >= 0). perspectiveRay, orthographicRay and
//   projectionRay are so: origin and direction before it is normalised change linearly with the screen.
//   Where a sample moves its ray by more, a lens, coarseMargin takes in by how much.
// - coarseMargin is more than a float's rounding: about 1e-6 of what p and t are.
// docs/16_fewer_steps.md has the proof in full. Source: J. C. Hart's sphere tracing along the cones of
// J. Amanatides, SIGGRAPH 1984; among writers of demos such a first pass is called cone marching.
#include "inputs.glsl"
#include "scene.glsl"

const int COARSE_BLOCK = 8; // side of a block, pixels

// The chapter's: how far from the scene a point at t of a ray must be for its march to go on: the largest
// threshold that counts as a hit there; and where samples move the ray, by how much they move it.
//   t        scene units along the ray, >= 0
//   returns  scene units, > 0; must not become less as t grows
float coarseMargin(float t);

#ifndef EXPORTED

uniform bool coarsePass; // true: rays begin where the march of their block of 8 x 8 pixels has ended

uniform sampler2D iCoarse; // one texel a block of the picture, as coarseBlock wrote it

#endif

// Where the march of a pixel's ray may begin: no point before it is as near to the scene as
// coarseMargin. A chapter whose march begins later for a reason of its own, a box, takes the larger.
//   ray      of pixelRay, for the pixel iPixel: the one whose block is looked up
//   returns  scene units along the ray, >= 0; 0 where the pass is switched off, and in a file of the
//            export, which has none
float coarseStart(Ray ray)
{
#ifdef EXPORTED
    return 0.0;
#else
    return coarsePass ? texelFetch(iCoarse, iPixel / COARSE_BLOCK, 0).x : 0.0;
#endif
}

// Compiled only for the pass.
#if VIEW == 8

const int   COARSE_STEPS = 64;    // of a block's march, at most
const float COARSE_FAR = 100.0;   // where it ends at the latest, scene units

// What holds the rays of a block: around each point of the axis a ball.
struct Cone {
    Ray axis;
    float radius; // of the ball at t = 0: no ray starts farther from the axis' origin
    float spread; // how fast it grows, per scene unit: no direction differs by more from the axis'
    float ahead;  // how far along the axis a ray may start before its origin
};

// The cone around all rays through a rectangle of the picture, from those through its corners.
//   low, high  opposite corners, pixels
//   formula    origin and direction of the axis are the corners' means; radius, spread and ahead their
//              largest |o - origin|, |d - direction| and (o - origin) . direction. A ball that holds four
//              points holds their hull; and of unit vectors the one with a sum of others is never less
//              along the axis than the least of them, so none is farther from it.
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

// How far the cone may go on from t.
//   distance  of the scene from its axis there, scene units
//   returns   the largest h >= 0 with r(t + h)^2 + 2 h ahead + h^2 <= (distance - margin)^2, margin that
//             of t + distance; 0 where there is none
float coneStep(Cone cone, float t, float distance)
{
    float empty = distance - coarseMargin(t + max(distance, 0.0));
    float radius = cone.radius + t * cone.spread;
    float a = 1.0 + cone.spread * cone.spread, b = cone.spread * radius + cone.ahead;
    float root = sqrt(max(b * b + a * (empty * empty - radius * radius), 0.0));
    return empty > radius ? (root - b) / a : 0.0;
}

// March the cone of a block of pixels.
//   block    which one, (0, 0) the bottom left one
//   returns  where its rays may start, scene units along them, and the evaluations of the scene
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
