// slice.glsl - the march of one ray, seen from the side: the distance around the ray, every position and
// every circle of radius sceneDistance.
//
// The plane contains the ray and the camera's up vector. The ray points to the right. A point of the
// plane is (along, across): scene units along the ray from its origin, and up from the ray.
#include "signs.glsl"
#include "inputs.glsl"
#include "scene.glsl"

// Compiled only for the slice, and for the plot, which shows the slice above the graph.
#if VIEW == VIEW_SLICE || VIEW == VIEW_PLOT

uniform sampler2D iMarch;      // column k: t and distance of step k, as a probe wrote them
uniform int   iMarchSteps;     // number of columns that contain a step
uniform bool  iMarchHit;       // whether the last step found the surface
uniform float iMarchStep;      // the selected step, with a fraction on the way to the next step; -1 to show all
uniform vec2  iMarchPixel;     // where the ray that is marched meets the picture, in pixels
uniform vec3  iSliceFrame;     // (along, across) of the picture's bottom left corner; units per pixel
uniform float iSliceTick;      // scene units between ticks, 1, 2 or 5 times a power of ten
uniform float iSliceLine;      // scene units between lines of equal distance
uniform int   iSliceTickScaled; // the tick as iSliceTickScaled / 10^iSliceDecimals
uniform int   iSliceDecimals;

const vec3 SLICE_INK   = vec3(0.05, 0.08, 0.20);
const vec3 SLICE_PAPER = vec3(1.00, 0.985, 0.95);
const vec3 SLICE_HERE  = vec3(0.80, 0.00, 0.28); // the selected step

// All colours outside are lighter than those inside, so the picture can be read without telling hues apart.
const vec3 SLICE_OUT_NEAR = vec3(0.97, 0.66, 0.32);
const vec3 SLICE_OUT_FAR  = vec3(0.99, 0.88, 0.72);
const vec3 SLICE_IN_NEAR  = vec3(0.27, 0.50, 0.80);
const vec3 SLICE_IN_DEEP  = vec3(0.10, 0.24, 0.50);

// The share of a pixel that a line covers, from 0 to 1.
//   distance  from the line's middle to the pixel's centre, in pixels
//   width     in pixels
float lineCover(float distance, float width)
{
    return clamp(0.5 * width + 0.5 - abs(distance), 0.0, 1.0);
}

// The share of a pixel that a disc covers.
//   distance  from the disc's centre, in pixels
//   radius    of the disc, in pixels
float discCover(float distance, float radius)
{
    return clamp(radius - distance + 0.5, 0.0, 1.0);
}

// The thickness of the pen, pixels: a fixed share of the picture's height, but at least 0.75.
float slicePen()
{
    return max(iResolution.y / 360.0, 0.75);
}

// The slope of the distance in the plane, per scene unit: at most 1, less where the plane only
// grazes a surface. Lines that are drawn with distance / slope keep their width.
float sliceSlope(vec3 p, vec3 along, vec3 across)
{
    float h = 0.5 * iSliceFrame.z;
    vec2 slope = vec2(sceneDistance(p + h * along) - sceneDistance(p - h * along),
                      sceneDistance(p + h * across) - sceneDistance(p - h * across)) / (2.0 * h);
    return clamp(length(slope), 0.25, 1.0);
}

// The distance as a colour, with lines of equal distance and the surface.
//   slope  from sliceSlope
vec3 sliceField(float distance, float slope)
{
    float pen = slicePen();
    float unit = iSliceFrame.z;
    float fade = 1.0 - exp(-abs(distance) / (0.2 * iResolution.y * unit));
    vec3 colour = distance > 0.0 ? mix(SLICE_OUT_NEAR, SLICE_OUT_FAR, fade)
                                 : mix(SLICE_IN_NEAR, SLICE_IN_DEEP, fade);
    float nearest = iSliceLine * floor(distance / iSliceLine + 0.5);
    bool tick = abs(nearest / iSliceTick - floor(nearest / iSliceTick + 0.5)) < 0.01;
    float pixels = (distance - nearest) / (unit * slope);
    vec3 line = distance > 0.0 ? vec3(0.62, 0.36, 0.14) : vec3(0.75, 0.85, 0.97);
    colour = mix(colour, line, (tick ? 0.45 : 0.20) * lineCover(pixels, pen));
    float surface = lineCover(distance / (unit * slope), 3.2 * pen);
    return mix(colour, SLICE_PAPER, surface);
}

// The number of steps whose circles are shown: all steps, or those up to the selected step.
int sliceSteps()
{
    return iMarchStep < 0.0 ? iMarchSteps : min(iMarchSteps, int(iMarchStep) + 1);
}

// Column k of the march: t and distance.
vec2 sliceStep(int k)
{
    return texelFetch(iMarch, ivec2(k, 0), 0).xy;
}

// The selected position on the ray: that of the selected step, or a point on the way to the next step.
float sliceHere()
{
    int k = sliceSteps() - 1;
    float way = smoothstep(0.0, 0.55, iMarchStep - float(k));
    return mix(sliceStep(k).x, sliceStep(min(k + 1, iMarchSteps - 1)).x, way);
}

// The number of a step above its position, if there is room: the result is 0 where nothing is drawn, otherwise 1 for
// the label's background plus the share of the pixel that the number covers.
//   pixel     of the picture
//   position  of the step in the picture, in pixels
//   room      to the neighbours, in pixels
float stepNumber(int step, vec2 pixel, vec2 position, float room)
{
    float cell = float(signCell());
    float width = float(numberWidth(step, 0));
    vec2 corner = floor(position / cell) - vec2(floor(0.5 * width), -4.0);
    vec2 at = floor(pixel / cell) - corner;
    bool ground = at.x >= -1.0 && at.x <= width && at.y >= -1.0 && at.y <= 5.0;
    bool cut = abs(position.x - 0.5 * iResolution.x) > 0.5 * (iResolution.x - (width + 2.0) * cell);
    if (!ground || cut || room < (width + 4.0) * cell)
        return 0.0;
    return 1.0 + numberCover(step, 0, pixel - cell * corner);
}

// Draw every step over a colour: the area that the circles prove empty, the circles, the positions and the numbers.
// A circle whose centre lies outside the picture is pale: such circles are large and crowd together.
// The circle of the next step grows as the selected position approaches it.
//   point  (along, across)
vec3 sliceMarch(vec3 colour, vec2 point, vec2 pixel)
{
    float pen = slicePen();
    float unit = iSliceFrame.z;
    float empty = 0.0, circles = 0.0, dots = 0.0, before = 0.0, number = 0.0;
    int steps = sliceSteps();
    float grown = iMarchStep < 0.0 ? 0.0 : smoothstep(0.5, 1.0, iMarchStep - float(steps - 1));
    for (int k = 0; k < min(steps + (grown > 0.0 ? 1 : 0), iMarchSteps); k++) {
        vec2 step = sliceStep(k);
        float from = length(point - vec2(step.x, 0.0)) / unit;
        float radius = (k < steps ? 1.0 : grown) * abs(step.y) / unit;
        empty = max(empty, discCover(from, radius));
        vec2 position = (vec2(step.x, 0.0) - iSliceFrame.xy) / unit;
        bool shown = position.x >= 0.0 && position.x <= iResolution.x;
        circles = max(circles, (shown ? 1.0 : 0.4) * lineCover(from - radius, 1.3 * pen));
        dots = max(dots, discCover(from, pen * clamp(0.2 * radius / pen, 1.0, 2.6)));
        number = max(number, stepNumber(k, pixel, position, k == 0 ? radius : min(radius, before)));
        before = radius;
    }
    colour = mix(colour, SLICE_PAPER, 0.38 * empty);
    colour = mix(colour, SLICE_INK, circles);
    colour = mix(colour, SLICE_PAPER, number > 0.0 ? 0.7 : 0.0);
    return mix(colour, SLICE_INK, max(number - 1.0, dots));
}

// Draw the ray: a solid line up to where it was marched, or up to the selected position, and dashes beyond, with
// the eye at its start and a ring where the march found the surface.
vec3 sliceRay(vec3 colour, vec2 point)
{
    float pen = slicePen();
    float unit = iSliceFrame.z;
    int steps = sliceSteps();
    float end = steps == 0 ? 0.0 : iMarchStep < 0.0 ? sliceStep(steps - 1).x : sliceHere();
    bool dash = fract(point.x / (unit * 12.0 * pen)) < 0.5;
    float ray = point.x < 0.0 || (point.x > end && !dash) ? 0.0 : lineCover(point.y / unit, pen);
    colour = mix(colour, SLICE_INK, point.x > end ? 0.5 * ray : ray);
    float eye = length(point) / unit;
    colour = mix(colour, SLICE_INK, discCover(eye, 6.0 * pen));
    colour = mix(colour, SLICE_PAPER, discCover(eye, 4.2 * pen));
    colour = mix(colour, SLICE_INK, discCover(eye, 2.2 * pen));
    float hit = length(point - vec2(end, 0.0)) / unit;
    bool found = iMarchHit && steps == iMarchSteps;
    return mix(colour, SLICE_INK, found ? lineCover(hit - 5.5 * pen, 1.6 * pen) : 0.0);
}

// Draw the selected position on the ray as a dot, and an arrow from there to the next step.
vec3 sliceWalk(vec3 colour, vec2 point)
{
    float pen = slicePen();
    int steps = sliceSteps();
    if (iMarchStep < 0.0 || steps == 0)
        return colour;
    vec2 from = (point - vec2(sliceHere(), 0.0)) / iSliceFrame.z;
    float way = steps < iMarchSteps ? (sliceStep(steps).x - sliceHere()) / iSliceFrame.z : 0.0;
    float head = min(9.0 * pen, 0.6 * way);
    // The arrow's width: constant from the tail to the head's base, decreasing from there to the tip.
    float width = from.x < way - head ? min(3.0 * pen, 0.4 * head) : 0.9 * (way - from.x);
    float arrow = from.x > 0.0 && from.x < way ? lineCover(from.y, width) : 0.0;
    float edge = from.x > 0.0 && from.x < way + pen ? lineCover(from.y, width + 2.4 * pen) : 0.0;
    float dot = length(from);
    colour = mix(colour, SLICE_PAPER, 0.8 * max(way > 4.0 * pen ? edge : 0.0, discCover(dot, 5.6 * pen)));
    return mix(colour, SLICE_HERE, max(way > 4.0 * pen ? arrow : 0.0, discCover(dot, 4.2 * pen)));
}

// Draw the axis along the bottom: scene units along the ray, 0 at the eye. A number that the edge of the picture would
// cut is left out.
vec3 sliceAxis(vec3 colour, vec2 point, vec2 pixel)
{
    float pen = slicePen();
    float cell = float(signCell());
    float top = 13.0 * cell;
    if (iResolution.y < 8.0 * top || pixel.y > top + pen)
        return colour;
    colour = mix(colour, SLICE_PAPER, pixel.y < top ? 0.85 : 0.0);
    float small = iSliceLine * floor(point.x / iSliceLine + 0.5);
    float tick = floor(point.x / iSliceTick + 0.5);
    float mark = lineCover(pixel.y - top, pen);
    if (pixel.y > top - 1.5 * cell)
        mark = max(mark, lineCover((point.x - small) / iSliceFrame.z, pen));
    if (pixel.y > top - 3.0 * cell)
        mark = max(mark, lineCover((point.x - tick * iSliceTick) / iSliceFrame.z, 1.3 * pen));
    int number = int(tick) * iSliceTickScaled;
    float width = float(numberWidth(number, iSliceDecimals));
    float column = floor((tick * iSliceTick - iSliceFrame.x) / iSliceFrame.z / cell);
    vec2 corner = vec2(column - floor(0.5 * width), 3.0);
    bool whole = corner.x >= 1.0 && corner.x + width + 1.0 <= floor(iResolution.x / cell);
    mark = max(mark, whole ? numberCover(number, iSliceDecimals, pixel - cell * corner) : 0.0);
    return mix(colour, SLICE_INK, mark);
}

// The plane of the ray, and everything drawn in it.
//   pixel  in pixels of the picture
vec3 slicePlane(Ray ray, vec2 pixel)
{
    vec3 across = iCameraUp - dot(iCameraUp, ray.direction) * ray.direction;
    if (length(across) < 0.001) // the ray is vertical: any plane that contains it will do
        across = iCameraForward - dot(iCameraForward, ray.direction) * ray.direction;
    across = normalize(across);
    vec2 point = iSliceFrame.xy + pixel * iSliceFrame.z;
    vec3 p = ray.origin + point.x * ray.direction + point.y * across;
    vec3 colour = sliceField(sceneDistance(p), sliceSlope(p, ray.direction, across));
    colour = sliceMarch(colour, point, pixel);
    return sliceWalk(sliceRay(colour, point), point);
}

// The colour of a pixel in the slice view.
//   pixel  in pixels of the picture
vec3 sliceView(vec2 pixel)
{
    Ray ray = pixelRay(screenPosition(iMarchPixel));
    vec2 point = iSliceFrame.xy + pixel * iSliceFrame.z;
    return sliceAxis(slicePlane(ray, pixel), point, pixel);
}

#endif
