// Experiment of chapter 22: the list of a cell. Drag the point: the cell in which its ray meets the reef is outlined,
// all parts on the list of this cell are orange, and the surfaces inside the cell are yellow.
#include "main.glsl"
#define rayColour chapterColour
#include "22_many_parts.frag"
#undef rayColour

uniform vec3 point; // (1.85, 1.2, 1.95) handle: a point whose ray chooses the cell

const vec3 OUTLINE = vec3(0.1, 0.5, 0.9);

// The part on the list of a cell that is nearest to p; -1 if the list is empty.
int nearestPart(vec3 p, Cell cell)
{
    int nearest = -1;
    float least = 1e9;
    for (int i = 0; i < cell.count; i++) {
        int id = listed(cell.first + i);
        vec4 part = partAt(id, p);
        float d = length(part.xyz) - part.w;
        nearest = d < least ? id : nearest;
        least = min(least, d);
    }
    return nearest;
}

bool onList(int id, Cell cell)
{
    bool found = false;
    for (int i = 0; i < cell.count; i++)
        found = found || listed(cell.first + i) == id;
    return found;
}

// How strongly an edge of the cell is drawn, from 0 to 1, at a point p on the cell's surface.
//   width  of the line, scene units
float edgeAt(vec3 p, Cell cell, float width)
{
    vec3 q = 0.5 * cell.size - abs(p - cell.low - 0.5 * cell.size); // distances to the faces
    float second = max(min(q.x, q.y), min(max(q.x, q.y), q.z)); // the median: the smallest is 0
    return 1.0 - smoothstep(width, 2.0 * width, second);
}

Hit marchThrough(Ray ray)
{
    vec2 interval = reefInterval(ray);
    return marchReef(ray, interval.x, min(interval.y, FAR), hitThreshold, footprint * pixelSpread(), maxSteps);
}

vec3 rayColour(Ray ray)
{
    Hit hit = marchThrough(ray);
    vec3 p = ray.origin + hit.t * ray.direction;
    Skin skin = skinAt(p, hit.found);
    int id = nearestPart(p, cellAt(p));

    Ray through = Ray(ray.origin, normalize(point - ray.origin));
    Hit chosen = marchThrough(through);
    Cell cell = cellAt(through.origin + chosen.t * through.direction);
    vec3 inside = p - cell.low;
    bool within = all(greaterThan(inside, vec3(0.0))) && all(lessThan(inside, vec3(cell.size)));

    vec3 colour = !onList(id, cell) || !chosen.found ? vec3(0.35) : (within ? vec3(0.9, 0.65, 0.1) : vec3(0.85, 0.3, 0.05));
    colour *= 0.25 + 0.75 * lambert(skin.normal, normalize(TO_SUN - 0.6 * ray.direction));
    colour = hit.found ? colour : vec3(0.04, 0.07, 0.1);
    vec2 box = boxInterval(ray, cell.low, cell.low + cell.size);
    float line = 0.0, far = chosen.t * pixelSpread();
    if (chosen.found && box.x < box.y)
        line = max(edgeAt(ray.origin + box.x * ray.direction, cell, far), 0.5 * edgeAt(ray.origin + box.y * ray.direction, cell, far));
    return encodeSRGB(mix(colour, OUTLINE, line));
}
