#version 330 core
// For edges.c: the library's functions where a formula divides by zero, where a direction is undefined, and where a
// power, a root or an arc function reaches the end of its range. Each case has the actual value and the right one.
// iMouse is 0, a value that the compiler does not know, so it cannot compute the results in advance.

in float Time;
out vec4 FragColor;

uniform vec4 iMouse;

#define iMouse theirMouse
#include "inputs.glsl"
#undef iMouse
#include "bounds.glsl"
#include "caustic.glsl"
#include "city.glsl"
#include "clouds.glsl"
#include "cone.glsl"
#include "film.glsl"
#include "filter.glsl"
#include "fog.glsl"
#include "glass.glsl"
#include "gloss.glsl"
#include "hue.glsl"
#include "land.glsl"
#include "lens.glsl"
#include "lighting.glsl"
#include "night.glsl"
#include "normal.glsl"
#include "occlusion.glsl"
#include "orthographic.glsl"
#include "plane.glsl"
#include "prism.glsl"
#include "sky_table.glsl"
#include "soft_shadow.glsl"
#include "solids.glsl"
#include "spectrum.glsl"
#include "symmetry.glsl"
#include "thickness.glsl"
#include "transform.glsl"
#include "water.glsl"
#define Footprint PatternFootprint
#include "checkers.glsl"
#undef Footprint

const float ANY = -1e9; // for a value that only has to be finite
const vec3  UP = vec3(0.0, 1.0, 0.0);

int  cases = 0;
vec2 chosen = vec2(ANY);

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// A sheet without thickness: its distance has no gradient at 0.
float sceneDistance(vec3 p)
{
    return abs(p.y);
}

void edge(float value, float right)
{
    if (cases == int(gl_FragCoord.x))
        chosen = vec2(value, right);
    cases++;
}

void edge(vec2 value, vec2 right)
{
    edge(value.x, right.x);
    edge(value.y, right.y);
}

void edge(vec3 value, vec3 right)
{
    edge(value.xy, right.xy);
    edge(value.z, right.z);
}

void main()
{
    float o = iMouse.x; // 0
    vec3 x = vec3(1.0 + o, o, o), y = vec3(o, 1.0 + o, o), z = vec3(o, o, 1.0 + o);
    mat2x3 axes = mat2x3(x, z);

    // Views; rays along two faces of a box, between these faces and beside them.
    edge(perspectiveRay(vec2(o)).direction, iCameraForward);
    edge(projectionRay(vec2(o), 5.0).direction, iCameraForward);
    edge(boxInterval(Ray(vec3(-2.0, 0.5, 0.5), x), vec3(o), vec3(1.0 + o)), vec2(2.0, 3.0));
    edge(boxInterval(Ray(vec3(-2.0, 0.5, 0.5), -x), vec3(o), vec3(1.0 + o)).y, -2.0);
    edge(step(boxInterval(Ray(vec3(-2.0, 1.5, 0.5), x), vec3(o), vec3(1.0 + o)).y, 0.0), 1.0);
    edge(tetrahedronInterval(Ray(vec3(o), normalize(vec3(1.0, 1.0, o))), 1.0).x, 0.0);
    edge(normalAt(vec3(o), 0.01), vec3(0.0));
    edge(lensRay(Ray(vec3(o), iCameraForward), vec2(o), 0.1, 3.0).direction, iCameraForward);
    edge(circleOfConfusion(3.0 + o, 0.1, 3.0, 2.0), 0.0);
    edge(filteredScreen(vec2(o), 2, false, 0), ANY + vec2(0.0));
    edge(gaussianQuantile(0.5 + o), 0.0);
    edge(0.01 * (gaussianQuantile(o) + gaussianQuantile(1.0 + o)), 0.0);
    edge(tentOffset(vec2(o, 1.0 + o)), vec2(-1.0, 1.0));

    // Light and film.
    edge(encodeSRGB(vec3(o, 1.0 + o, o - 1.0)), vec3(0.0, 1.0, 0.0));
    edge(filmCurve(vec3(o, 8.0 + o, 0.18 + o), 1.45, 8.0), vec3(0.0, 1.0, 0.18));
    edge(filmOfLargest(vec3(o), 1.45, 8.0), vec3(0.0));
    edge(halfway(x, y), vec3(0.70710678, 0.70710678, 0.0));
    edge(blinnPhongGloss(y, x, -x + 1e-3 * y, 0.0 + o), 1.0 / 3.14159265);
    edge(ggxGloss(y, x, x, 1.0 + o), 0.0);
    edge(smithVisibility(o, o, 1.0), ANY);
    edge(hueToRGB(360.0 + o), vec3(1.0, 0.0, 0.0));
    edge(schlickShare(o, 0.04), 1.0);
    edge(fresnelShare(o, 1.0), 1.0);
    edge(fresnelShare(1.0 + o, 1.0), 0.0);
    edge(fresnelShare(1.0 + o, 1.5), 0.04);
    edge(partingAt(x, y, -1.0, 1.5).mirrored, 1.0);
    edge(partingAt(x, y, -1.0, 1.5).bent, vec3(0.0));
    edge(lightThrough(o, vec3(1.0)).x, 1.0);
    edge(cauchyWave(vec2(1.5, 0.004), 1.5 + o), ANY);
    edge(meanColour(0.55 + o, 0.55), vec3(0.0));
    edge(leastDeviation(1.0471976, 2.0 + o), 2.0943951);
    edge(prismLeaving(o, 1.0471976, 1.5), 1.2990381);
    edge(planIndex(1.5 + o, o), 1.5);
    edge(prismBeam(vec2(o, 5.0), 0.32, vec2(1.6894, 0.01341), 0.14, 0.035).waves, ANY + vec2(0.0));
    edge(softDiscArea(o, 1.0 + o), 0.041666667);
    edge(ballCaustic(vec3(o, -1.0, o), y, 0.5, 1.5, o), ANY);
    edge(ballCaustic(y, y, 0.5, 1.5, 0.05), 0.0);

    // Shadows: discs that touch, one disc inside another, and a lamp exactly behind the ball.
    edge(discBesideEdge(o - 1.0), 0.0);
    edge(discBesideEdge(o), 0.5);
    edge(discBesideEdge(1.0 + o), 1.0);
    edge(discBesideDisc(1.0 + o, 0.5), 1.0);
    edge(discBesideDisc(o - 0.5, 0.5), 0.75);
    edge(discBesideDisc(o - 2.0, 2.0), 0.0);
    edge(discBesideDisc(o - 1.0, 1.0), 0.0);
    edge(discBesideDisc(o, 1e-6), 1.0);
    edge(lampBesideEdge(vec3(o), y, 0.1, y, x), 0.5);
    edge(lampBesideEdge(vec3(o), y, 0.1, x, z), ANY);
    edge(lampBesideBall(vec3(o), y, 0.1, 2.0 * y, 0.5), 0.0);
    edge(lampBesideBall(vec3(o), y, 0.1, 2.0 * x, 0.5), 1.0);
    edge(lampDirection(y, 0.1, vec2(o)), UP);
    edge(discPoint(vec2(o)), vec2(0.0));
    edge(clearanceAlong(Ray(y, y), o, 4.0, 0.001, 20).most, 4.0 / 3.0);
    edge(openBeforeWall(o, 1.0), 0.5);
    edge(openBeforeWall(1.0, 1e-6 + o), 1.0);
    edge(hiddenByBall(vec3(o), y, 2.0 * y, 1.0), 0.25);
    edge(hiddenByBall(vec3(o), y, -2.0 * y, 1.0), 0.0);
    edge(hiddenByBall(vec3(o), y, y, 1.0 + o), 1.0);
    edge(hiddenByBall(vec3(o), y, x, 1.0 + o), 0.5);
    edge(cosineDirection(y, vec2(o)), UP);
    edge(cosineDirection(x, vec2(1.0 + o, o)).x, 0.0);
    edge(skyAndBounces(o, vec3(1.0), 2), vec3(0.0));
    edge(coneReaching(Ray(y, y), o, 4.0, 0.001, 0.1, 20), 1.0);

    // Patterns, textures and water: rays along the surface, and straight down.
    edge(planeFootprint(vec3(o), normalize(vec3(1.0, -1e-4, o)), y, 0.01, 1.0, axes).width, vec2(1e6));
    edge(planeFootprint(vec3(o), vec3(1.0, -0.25, o), y, 0.25, 1.0, axes).middle, vec2(0.0));
    edge(planeFootprint(vec3(o), -y, y, 0.01, 1.0, axes).middle, vec2(0.0));
    edge(checkers(vec2(o), vec2(1e6)), 0.5);
    edge(stripes(0.5 + o, 0.25, o), 1.0);
    edge(footprintOn(-y, y, 1.0 + o).along.y, 0.0);
    edge(length(footprintOn(-y, y, 1.0 + o).across), 1.0);
    edge(length(footprintOn(x, y, 1.0 + o).along), 16.0);
    edge(planeWeights(y, 64.0 + o), UP);
    edge(planeWeights(vec3(0.57735027 + o), 64.0), vec3(1.0 / 3.0));
    edge(twoPlaneWeights(vec3(1.0 / 3.0) + o), vec3(1.0, 0.0, 0.0));
    edge(bumpedNormal(y, 9.0 * y), UP);
    edge(length(footprintOnWater(x, 1.0 + o).across), 1.0);
    edge(length(fourWaves(vec2(o), Footprint(x, z), vec4(1.0), vec4(0.0), vec4(0.0), vec4(0.0)).slope), 0.0);
    edge(glitter(x, y, Water(vec2(0.0), 0.01), vec3(1.0)), vec3(ANY));

    // Distances: at the centre, on the axis, at the tip.
    edge(sdSegment(vec2(o), vec2(o), vec2(1.0)), 0.0);
    edge(sdTriangle(vec2(o), vec2(o), vec2(1.0, 0.0), vec2(0.0, 1.0)), 0.0);
    edge(sdCappedCone(0.5 * y, 0.3, o, 0.5), 0.0);
    edge(sdCapsule(vec3(o), vec3(o), y, 0.1), -0.1);
    edge(sdTorus(vec3(o), 1.0, 0.25), 0.75);
    edge(largestStretch(mat3(1.0 + o)), 1.0);
    edge(largestStretch(mat3(o)), 0.0);
    edge(hill(vec2(o), vec2(1.0), 2.0), vec3(2.0, 0.0, 0.0));
    edge(wayToClose(o, 1.0, o), 0.0);
    edge(octaveStretch(1, 1.0 + o, 2.0), VALUE_STRETCH);
    edge(octaveNoise(vec3(o), 1, 1.0 + o, 2.0).yzw, vec3(0.0));
    edge(length(latticeDirection(uint(o))), 1.0);
    edge(length(gradientNoise(vec3(o)).yzw), 1.0);
    edge(cityNormal(blockAt(vec3(o, 20.0, o)), true, false), UP);

    // Fog.
    edge(meanDecay(o), 1.0);
    edge(fogDepth(o, o, 3.0, 0.5, 1.0), 1.5);
    edge(skyFogDepth(o, 1.0, 0.5, 2.0), 1.0);
    edge(inverseFogDepth(o, o, 1.5, 0.5, 1.0), 3.0);
    edge(lampInFog(-z, z, o, 0.05), 0.0);
    edge(lampInFog(-z, z, 2.0, 0.05), 2.0 * atan(20.0) / 0.05);
    edge(beamInFog(-z, z, z, vec2(0.1, 0.02), 2.0, 0.1), ANY);

    // The sky: the zenith, the nadir, the pole, midnight, new and full moon.
    edge(airMass(o), 37.99);
    edge(glow(y, y, o), 1.0);
    edge(earthShadow(y, y), 0.0);
    edge(earthShadow(y, -y), ANY);
    edge(sunDirection(o, 90.0, o).y, 0.0);
    edge(sunDirection(12.0 + o, o, o), UP);
    edge(scatteredLight(vec3(0.1), 1.0, 1.0 + o).x, 0.0904);
    edge(levelCosine(y, x), ANY);
    edge(levelCosine(-x, x), -1.0);
    edge(sunwardShare(o - 1.0, o, o), 0.0);
    edge(moreShare(o - 1.0, o - 1.0, o), 0.0);
    edge(tableSunlight(-y), vec3(0.0));
    edge(adaptedStops(6e-8 + o), 18.65);
    edge(seenFromMiddle(vec3(o), y, 1.2), UP);
    edge(panoramaUV(y), vec2(0.0, 1.0));
    edge(panoramaUV(-y), vec2(0.0));
    edge(panoramaFootprint(y, 0.003 + o), ANY + vec2(0.0));
    edge(skyTurn(12.0 + o, 90.0) * y, vec3(0.0, 0.0, 1.0));
    edge(length(moonDirection(12.0, 45.0, 23.44 + o, o)), 1.0);
    edge(moonDirection(12.0 + o, 43.6, 0.0, o), sunDirection(12.0, 43.6, 0.0));
    edge(starLight(z, 0.003).x, ANY);
    edge(starLight(-z, 0.003).x, ANY);
    edge(milkyWay(z).x, ANY);
    edge(zenithLight(o - 1.0) * 1e8, 4.5);
    edge(faintestSeen(4.5e-8 + o), 6.6);
    edge(airglow(o).y / airglow(1.0).y, 5.84);
    edge(nightSight(vec3(o)), vec3(0.0));
    edge(hourOfStars(12.0, OBLIQUITY + o), 17.98);
    edge(moonPoint(-z, 0.0045), vec2(0.0));
    edge(moonPoint(z, 0.0045), vec2(1e3));
    edge(length(moonFrame(x, 45.0)[0]), 1.0);
    edge(moonlight(1.0 + o).y * 1e5, 2.5);
    edge(moonlight(o - 1.0).y * 1e5, 0.0);

    FragColor = vec4(chosen, float(cases), 0.0);
}
