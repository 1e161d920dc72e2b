// The footprint of a pixel: drag the eye, and the point of the floor that the pixel shows. Below the floor are the
// levels of the texture; the texels of each level are twice as wide as those of the level above. The footprint is
// green, and its length in texels is beside it. This length, times the parameter `footprint`, determines the level
// (orange) whose texels are as long; between two levels, both are mixed.
#include "figure.glsl"
#include "lighting.glsl" // encodeSRGB

uniform sampler2D granite; // "granite.png" sRGB repeat: polished stone
uniform vec2 eye;          // (-1.3, 0.84) handle units: where the rays start
uniform vec2 aim;          // (0.32, -0.05) handle units: the middle of the pixel, on the floor
uniform float pixelAngle;  // 4 in [1, 10] step 0.5, degrees: how wide the ray of a pixel is
uniform float footprint;   // 1 in [0.25, 2] step *1.1: factor on the footprint

const float FLOOR = -0.05, TEXEL = 0.03, ROW = 0.13; // height of the floor, width of a level-0 texel, height of a row
const int LEVELS = 6;

float sceneDistance(vec3 p)
{
    return p.y - FLOOR;
}

// The x at which a ray at an angle to the vertical meets the floor.
float floorAt(float angle)
{
    return eye.x + max(eye.y - FLOOR, 0.01) * tan(clamp(angle, -1.56, 1.56));
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray);
    float pixel = radians(pixelAngle), middle = atan(aim.x - eye.x, max(eye.y - FLOOR, 0.01));
    float near = floorAt(middle - 0.5 * pixel), far = floorAt(middle + 0.5 * pixel);
    float texels = (far - near) / TEXEL, level = clamp(log2(footprint * texels), 0.0, float(LEVELS - 1));

    // The rays through the borders of the pixels, and the selected pixel.
    float angle = atan(p.x - eye.x, max(eye.y - p.y, 1e-4));
    float between = abs(fract((angle - middle) / pixel) - 0.5) * pixel * length(p - eye);
    if (p.y > FLOOR && p.y < eye.y) {
        fill((abs(angle - middle) - 0.5 * pixel) * length(p - eye), TEAL, 0.25);
        stroke(between, 0.8, PALE);
        stroke((abs(angle - middle) - 0.5 * pixel) * length(p - eye), 1.4, TEAL);
    }

    // The levels, one below another.
    int row = int(floor((FLOOR - 0.06 - p.y) / ROW));
    float top = FLOOR - 0.06 - ROW * float(row);
    if (row >= 0 && row < LEVELS && p.y > top - 0.8 * ROW) {
        int size = textureSize(granite, 0).x >> row;
        int column = int(floor((p.x + 1.8) / (TEXEL * exp2(float(row)))));
        vec3 colour = encodeSRGB(texelFetch(granite, ivec2(column % size, (7 * size) / 16), row).rgb);
        float read = clamp(1.0 - abs(float(row) - level), 0.0, 1.0); // the weight of this level
        sheetColour = mix(PAPER, colour, abs(p.x) < 1.6 ? 0.3 + 0.7 * read : 0.0);
    }
    float marked = FLOOR - 0.06 - ROW * (level + 0.4);
    dashes(p, vec2(near, FLOOR), vec2(near, marked), 1.0, TEAL);
    dashes(p, vec2(far, FLOOR), vec2(far, marked), 1.0, TEAL);
    line2(p, vec2(-2.0, FLOOR), vec2(2.0, FLOOR), 1.5, INK);
    line2(p, vec2(near, FLOOR), vec2(far, FLOOR), 5.0, TEAL);
    dot2(p, eye, 9.0, INK);
    number(p, vec2(far + 0.13, FLOOR + 0.055), min(texels, 999.0), 1, TEAL); // # texel(s)
    number(p, vec2(-1.69, marked), level, 1, ORANGE); // # | level #
    return sheetColour;
}
