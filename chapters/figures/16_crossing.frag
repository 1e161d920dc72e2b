// The same end for every start: drag the start to the left or right, and drag the end of the line to set the ray's
// angle to the wall. The distance is plotted upwards, and the path along the ray to the right. A plain march (orange)
// ends anywhere below the threshold (blue); marchCrossing (teal) ends where the line crosses the threshold.
#include "figure.glsl"
#include "crossing.glsl"

uniform vec2 start;      // (-1.36, 0.62) handle: its x is where the march starts
uniform vec2 top;        // (-1.6, 0.74) handle: end of the line
uniform float threshold; // 0.5 in [0.1, 1] step 0.02, units: the threshold

const float FLOOR = -0.8, WALL = 1.5; // y and x at which the plotted distance is 0

// The distance to the wall: the height of the line above the floor of the figure.
float heightAt(float x)
{
    return clamp((top.y - FLOOR) / max(WALL - top.x, 0.01), 0.02, 1.0) * (WALL - x);
}

float sceneDistance(vec3 p)
{
    return heightAt(p.x);
}

// Draw a march: from the line down at 45 degrees to the height short2, then up to the line again, until the line is
// below the threshold. Returns the last position; before receives the position before the last.
float zigzag(vec2 p, float short2, vec3 colour, out float before)
{
    float x = min(start.x, WALL), path = 1e6, spots = 1e6;
    before = x;
    for (int i = 0; i < 24; i++) {
        float d = heightAt(x), next = x + d - short2;
        spots = min(spots, length(p - vec2(x, FLOOR + d)));
        if (d < threshold)
            break;
        path = min(path, sdSegment(p, vec2(x, FLOOR + d), vec2(next, FLOOR + short2)));
        path = min(path, sdSegment(p, vec2(next, FLOOR + short2), vec2(next, FLOOR + heightAt(next) + 1e-4)));
        before = x;
        x = next;
    }
    fill(min(path - penWidth(0.8), spots - penWidth(2.5)), colour, 1.0);
    return x;
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    float below = CROSSING_SHORT * threshold, before;
    fill(max(FLOOR - p.y, p.y - FLOOR - threshold), SKY, 0.55);
    line2(p, vec2(-1.78, FLOOR + threshold), vec2(1.78, FLOOR + threshold), 1.6, BLUE);
    dashes(p, vec2(-1.78, FLOOR + below), vec2(1.78, FLOOR + below), 1.0, BLUE);
    fill(WALL - p.x, SAND, 1.0);
    line2(p, vec2(WALL, -1.0), vec2(WALL, 1.0), 2.0, ORANGE);
    line2(p, vec2(-1.78, FLOOR), vec2(WALL, FLOOR), 1.2, PALE);
    line2(p, vec2(-1.78, FLOOR + heightAt(-1.78)), vec2(WALL, FLOOR), 2.0, INK);

    float plain = zigzag(p, 0.0, ORANGE, before);
    dot2(p, vec2(plain, FLOOR + heightAt(plain)), 10.0, ORANGE);
    float last = zigzag(p, below, TEAL, before);
    dot2(p, vec2(min(start.x, WALL), FLOOR + heightAt(min(start.x, WALL))), 8.0, INK);
    // The straight line between the last two positions crosses the threshold here.
    float above = heightAt(before) - threshold, gap = heightAt(last) - threshold;
    float end = last > before ? last + (last - before) * gap / (above - gap) : last;
    dot2(p, vec2(end, FLOOR + heightAt(end)), 10.0, TEAL);
    number(p, vec2(1.2, 0.84), heightAt(end), 2, TEAL); // marchCrossing #
    number(p, vec2(1.2, 0.72), heightAt(plain), 2, ORANGE); // march #
    return sheetColour;
}
