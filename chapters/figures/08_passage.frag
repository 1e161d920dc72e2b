// From perspective to parallel rays: change the parameter `orthographic`, and drag the two plates, which are of equal
// size. On the right is the picture, with the sizes of the plates relative to a plate in the framing plane. As the rays
// become parallel, the eye, the dot on the left, moves back, the framing plane keeps its size, and the sizes of the
// plates become equal.
#include "figure.glsl"

uniform float orthographic; // 0.4 in [0, 1] step 0.02: 0 the perspective view, 1 the orthographic one
uniform vec2  near;         // (-0.28, 0.12) handle: centre of the near plate
uniform vec2  far;          // (0.55, -0.16) handle: centre of the far plate

const float CAMERA = -0.6, FRAMING = 0.0;         // x of the camera's plane and of the framing plane
const float DISTANCE = FRAMING - CAMERA;          // distance between these planes
const float HALF = 0.55, PLATE = 0.14;            // half the height of the picture's area, and of a plate
const float LEFT = 1.08, RIGHT = 1.66;            // edges of the picture

float sceneDistance(vec3 p)
{
    return p.z;
}

// The size, in the picture, of a plate at x, relative to that of a plate in the framing plane.
float sizeAt(float x)
{
    return DISTANCE / ((1.0 - orthographic) * (x - CAMERA) + orthographic * DISTANCE);
}

// Draw a ray from the camera's plane to x = end. It meets the framing plane at the given height.
void drawRay(vec2 p, float height, float end, float width, vec3 colour)
{
    float start = orthographic * height, slope = (height - start) / DISTANCE;
    line2(p, vec2(CAMERA, start), vec2(end, start + slope * (end - CAMERA)), width, colour);
    if (orthographic < 0.98)
        dashes(p, vec2(FRAMING - DISTANCE / (1.0 - orthographic), 0.0), vec2(CAMERA, start), 0.7 * width, colour);
}

// Draw a plate, the rays through its ends, and its image in the picture, at x = at.
void plate(vec2 p, vec2 centre, float at, vec3 colour)
{
    vec2 point = vec2(clamp(centre.x, CAMERA + 0.05, LEFT - 0.1), centre.y);
    float size = sizeAt(point.x), end = max(point.x, FRAMING);
    drawRay(p, size * (point.y - PLATE), end, 1.5, colour);
    drawRay(p, size * (point.y + PLATE), end, 1.5, colour);
    line2(p, point - vec2(0.0, PLATE), point + vec2(0.0, PLATE), 6.0, colour);
    float low = clamp(size * (point.y - PLATE), -HALF, HALF), high = clamp(size * (point.y + PLATE), -HALF, HALF);
    line2(p, vec2(at, low), vec2(at, high), 9.0, colour);
    number(p, vec2(at, -0.66), size, 2, colour); // # | relative size #
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    drawRay(p, HALF, 0.9, 1.0, PALE);
    drawRay(p, -HALF, 0.9, 1.0, PALE);
    dashes(p, vec2(CAMERA, -HALF), vec2(CAMERA, HALF), 1.5, INK);
    line2(p, vec2(FRAMING, -HALF), vec2(FRAMING, HALF), 2.5, INK);
    stroke(sdRectangle(p - vec2(0.5 * (LEFT + RIGHT), 0.0), vec2(0.5 * (RIGHT - LEFT), HALF)), 1.5, INK);
    plate(p, near, LEFT + 0.15, ORANGE);
    plate(p, far, RIGHT - 0.15, TEAL);
    if (orthographic < 0.98)
        dot2(p, vec2(FRAMING - DISTANCE / (1.0 - orthographic), 0.0), 8.0, INK);
    return sheetColour;
}
