// plot.glsl - the distance along one ray as a graph, below the slice, with the steps of the march.
//
// Slice and graph share the axis along the ray. A step is drawn at (t, distance) and extends to the right by its
// height, so a march is a staircase. From each step a line falls by 1 per unit of the ray, as fast as a distance can
// fall. If the graph dips below this line, the scene's function is not 1-Lipschitz; if it also falls to 0 before the
// line does, the function is not a lower bound of the distance.
#include "signs.glsl"
#include "inputs.glsl"
#include "scene.glsl"
#include "slice.glsl"

// Compiled only for the plot.
#if VIEW == VIEW_PLOT

uniform vec3 iPlotFrame;      // the picture's row of distance 0; distance per pixel; the slice's lowest row
uniform float iPlotTick;      // distance between ticks, 1, 2 or 5 times a power of ten
uniform int  iPlotTickScaled; // the tick as iPlotTickScaled / 10^iPlotDecimals
uniform int  iPlotDecimals;
uniform int  iPlotEnd; // why the march ended: END_HIT, ...

const vec3 PLOT_CURVE     = vec3(0.10, 0.33, 0.70);
const vec3 PLOT_EMPTY     = vec3(0.99, 0.88, 0.72);
const vec3 PLOT_THRESHOLD = vec3(0.42, 0.12, 0.55);

// The distance of a point from the segment between two other points, in pixels.
float plotLine(vec2 point, vec2 from, vec2 to)
{
    vec2 way = to - from;
    float along = clamp(dot(point - from, way) / max(dot(way, way), 1e-9), 0.0, 1.0);
    return length(point - from - along * way);
}

// The position of a distance at t, in pixels of the picture. A point far outside the picture is moved closer to
// it, so that lines to the point keep their precision.
vec2 plotPoint(float t, float distance)
{
    float up = clamp(distance / iPlotFrame.y, -4.0 * iResolution.y, 4.0 * iResolution.y);
    return vec2((t - iSliceFrame.x) / iSliceFrame.z, iPlotFrame.x + up);
}

// The height of the threshold at t: a straight line through its values at the march's first and last step.
float plotThreshold(float t)
{
    int last = max(iMarchSteps - 1, 0);
    vec2 first = vec2(sliceStep(0).x, texelFetch(iMarch, ivec2(0, 1), 0).w);
    vec2 end = vec2(sliceStep(last).x, texelFetch(iMarch, ivec2(last, 1), 0).w);
    return mix(first.y, end.y, end.x > first.x ? (t - first.x) / (end.x - first.x) : 0.0);
}

// The graph of the scene's distance along the ray: the share of a pixel that its line covers.
float plotCurve(Ray ray, vec2 pixel)
{
    float pen = slicePen(), nearest = 1e9;
    vec2 before = vec2(0.0);
    for (int i = -2; i <= 2; i++) { // to both sides of the pixel, over the width of the line
        float t = iSliceFrame.x + (pixel.x + 0.7 * pen * float(i)) * iSliceFrame.z;
        vec2 point = plotPoint(t, sceneDistance(ray.origin + t * ray.direction));
        nearest = i == -2 ? nearest : min(nearest, plotLine(pixel, before, point));
        before = point;
    }
    return lineCover(nearest, 2.2 * pen);
}

// Draw the falling line of each step with the area below it, which shows the empty interval, the stairs, and the
// positions of the steps.
vec3 plotSteps(vec3 colour, vec2 pixel)
{
    float pen = slicePen(), promised = 0.0, slopes = 0.0, stairs = 0.0, here = 0.0, dots = 0.0;
    int steps = sliceSteps();
    for (int k = 0; k < steps; k++) {
        vec2 step = sliceStep(k), next = sliceStep(min(k + 1, iMarchSteps - 1));
        bool current = iMarchStep >= 0.0 && k == steps - 1;
        bool goes = k + 1 < iMarchSteps, ends = k + 1 == iMarchSteps && iPlotEnd == END_HIT;
        vec2 from = plotPoint(step.x, step.y), foot = plotPoint(step.x, 0.0);
        vec2 end = plotPoint(step.x + abs(step.y), 0.0);
        vec2 to = plotPoint(goes ? next.x : ends ? step.x : step.x + step.y, step.y);
        float slope = from.y - (pixel.x - from.x) * (from.y - foot.y) / max(end.x - from.x, 1e-3);
        bool below = pixel.x >= from.x && pixel.x < end.x && pixel.y > foot.y && pixel.y < slope;
        promised = max(promised, below ? 1.0 : 0.0);
        slopes = max(slopes, lineCover(plotLine(pixel, from, end), pen));
        float stair = lineCover(plotLine(pixel, from, to), 1.5 * pen);
        if (k + 1 < steps)
            stair = max(stair, lineCover(plotLine(pixel, to, plotPoint(next.x, next.y)), 1.5 * pen));
        float head = min(8.0 * pen, 0.6 * (to.x - from.x)), behind = to.x - pixel.x;
        bool tip = current && to.x - from.x > 4.0 * pen && behind > 0.0 && behind < head;
        stair = max(stair, tip ? lineCover(pixel.y - to.y, 0.9 * behind) : 0.0);
        stairs = max(stairs, current ? 0.0 : stair);
        here = max(here, current ? max(stair, discCover(length(pixel - from), 4.2 * pen)) : 0.0);
        dots = max(dots, discCover(length(pixel - from), 2.4 * pen));
    }
    colour = mix(colour, PLOT_EMPTY, 0.75 * promised);
    colour = mix(colour, SLICE_OUT_NEAR, 0.8 * slopes);
    colour = mix(colour, SLICE_INK, max(stairs, dots));
    return mix(colour, SLICE_HERE, here);
}

// Mark the end of the march, with a ring for a hit and a cross for any other end, and label the mark.
vec3 plotEnd(vec3 colour, vec2 pixel, float cell)
{
    float pen = slicePen();
    if (iMarchSteps == 0 || sliceSteps() < iMarchSteps)
        return colour;
    vec2 last = sliceStep(iMarchSteps - 1), point = plotPoint(last.x, last.y), from = pixel - point;
    float cross = max(abs(from.x), abs(from.y)) < 5.0 * pen ? lineCover((abs(from.x) - abs(from.y)) * 0.7, 1.8 * pen) : 0.0;
    float mark = iPlotEnd == END_HIT ? lineCover(length(from) - 5.5 * pen, 1.8 * pen) : cross;
    vec2 corner = floor(point / cell) + vec2(iPlotEnd == END_HIT ? -5.0 : -7.0, 7.0);
    // The label of an end outside the picture is in the corner, where every label fits.
    vec2 most = floor(vec2(iResolution.x / cell, iPlotFrame.z / cell)) - vec2(32.0, 8.0);
    float shorter = iPlotEnd == END_HIT ? 20.0 : iPlotEnd == END_STEPS ? 0.0 : 15.0;
    corner = point.x > iResolution.x ? most : min(corner, most + vec2(shorter, 0.0));
    int word = iPlotEnd == END_HIT ? SIGN_HIT : iPlotEnd == END_STEPS ? SIGN_GIVEN_UP : SIGN_MISS;
    vec2 ground = pixel / cell - corner;
    float width = iPlotEnd == END_HIT ? 8.0 : iPlotEnd == END_STEPS ? 27.0 : 14.0;
    bool below = ground.x > -1.0 && ground.x < width + 1.0 && ground.y > -1.0 && ground.y < 6.0;
    colour = mix(colour, SLICE_PAPER, below ? 0.7 : 0.0);
    return mix(colour, SLICE_INK, max(mark, wordCover(word, pixel - cell * corner)));
}

// Draw the axis of the distance, at the eye or at the left edge, with its name, its ticks, their numbers and grid
// lines.
vec3 plotAxis(vec3 colour, vec2 pixel, float cell)
{
    float pen = slicePen(), left = max(plotPoint(0.0, 0.0).x, 26.0 * cell);
    float tick = floor((pixel.y - iPlotFrame.x) * iPlotFrame.y / iPlotTick + 0.5);
    float off = pixel.y - plotPoint(0.0, tick * iPlotTick).y;
    bool room = iPlotFrame.z - pixel.y + off > 12.0 * cell;
    if (pixel.x < left)
        colour = SLICE_PAPER;
    else
        colour = mix(colour, SLICE_INK, 0.16 * lineCover(off, pen));
    float mark = lineCover(pixel.x - left, pen);
    if (pixel.x > left - 3.0 * cell && pixel.x < left && room)
        mark = max(mark, lineCover(off, 1.3 * pen));
    if (pixel.x > left)
        mark = max(mark, lineCover(pixel.y - iPlotFrame.x, 1.3 * pen));
    int number = int(tick) * iPlotTickScaled;
    vec2 corner = vec2(floor(left / cell) - 5.0 - float(numberWidth(number, iPlotDecimals)),
                       floor((pixel.y - off) / cell) - 2.0);
    if (room)
        mark = max(mark, numberCover(number, iPlotDecimals, pixel - cell * corner));
    vec2 name = vec2(floor(left / cell) + 3.0, floor(iPlotFrame.z / cell) - 8.0);
    return mix(colour, SLICE_INK, max(mark, wordCover(SIGN_DISTANCE, pixel - cell * name)));
}

// Draw the dashed line below which a distance counts as a hit, and its name if the line is clear of the axis.
vec3 plotLimit(vec3 colour, vec2 pixel, float cell)
{
    float pen = slicePen();
    float t = iSliceFrame.x + pixel.x * iSliceFrame.z, limit = plotThreshold(t);
    bool dash = fract(pixel.x / (10.0 * pen)) < 0.6 && limit > 0.0 && t > 0.0;
    float line = dash ? lineCover(pixel.y - plotPoint(t, limit).y, 1.4 * pen) : 0.0;
    float right = iResolution.x - 38.0 * cell;
    float up = plotPoint(0.0, plotThreshold(iSliceFrame.x + right * iSliceFrame.z)).y;
    vec2 corner = vec2(floor(right / cell), floor(up / cell) + 2.0);
    bool named = limit > 0.0 && up - iPlotFrame.x > 3.0 * pen;
    return mix(colour, PLOT_THRESHOLD, max(line, named ? wordCover(SIGN_THRESHOLD, pixel - cell * corner) : 0.0));
}

// The view: the slice above, the graph below it, and the axis along the ray at the bottom.
//   pixel  in pixels of the picture
vec3 plotView(vec2 pixel)
{
    float pen = slicePen(), cell = float(signCell());
    vec2 point = iSliceFrame.xy + pixel * iSliceFrame.z;
    Ray ray = pixelRay(screenPosition(iMarchPixel));
    vec3 slice = slicePlane(ray, pixel);
    vec3 graph = SLICE_PAPER;
    float tick = iSliceTick * floor(point.x / iSliceTick + 0.5);
    graph = mix(graph, SLICE_INK, 0.16 * lineCover((point.x - tick) / iSliceFrame.z, pen));
    graph = plotSteps(graph, pixel);
    graph = mix(graph, PLOT_CURVE, (point.x < 0.0 ? 0.35 : 1.0) * plotCurve(ray, pixel));
    graph = plotLimit(graph, pixel, cell);
    graph = plotEnd(plotAxis(graph, pixel, cell), pixel, cell);
    graph = pixel.y < 13.0 * cell ? SLICE_PAPER : graph;
    vec3 colour = pixel.y > iPlotFrame.z ? slice : graph;
    colour = mix(colour, SLICE_INK, lineCover(pixel.y - iPlotFrame.z, 1.6 * pen));
    colour = sliceAxis(colour, point, pixel);
    vec2 name = vec2(floor(iResolution.x / cell) - 6.0, 15.0);
    return mix(colour, SLICE_INK, wordCover(SIGN_T, pixel - cell * name));
}

#endif
