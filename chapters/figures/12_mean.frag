// What a pixel should show: drag the pixel over the grains, and change its width. On the right, from top to bottom, are
// the single texel in the middle of the pixel, which changes abruptly, the mean of all texels in the pixel, and a
// lookup in the level that fits. The numbers are the green channels, from 0 to 255.
#include "figure.glsl"
#include "lighting.glsl" // encodeSRGB

uniform sampler2D granite; // "granite.png" sRGB repeat: polished stone
uniform vec2 middle;       // (-0.85, -0.1) handle units: middle of the pixel
uniform float wide;        // 11.5 in [1, 22] step 0.5, texels: width of the pixel
uniform float footprint;   // 0.577 in [0.1, 4] step *1.1: factor on the footprint; 0.577 is best

const float TEXEL = 0.045; // the width of a texel, units

float sceneDistance(vec3 p)
{
    return p.z;
}

vec3 texelAt(ivec2 at)
{
    return texelFetch(granite, ivec2(mod(vec2(at), vec2(textureSize(granite, 0)))), 0).rgb;
}

// The mean over a pixel centred at a point, in texels. A texel that is partly covered counts in proportion.
vec3 meanAt(vec2 at)
{
    vec3 sum = vec3(0.0);
    vec2 low = at - 0.5 * wide, high = at + 0.5 * wide;
    ivec2 first = ivec2(floor(low)), last = ivec2(floor(high));
    for (int y = first.y; y <= last.y; y++)
        for (int x = first.x; x <= last.x; x++) {
            vec2 texel = vec2(x, y), covered = min(texel + 1.0, high) - max(texel, low);
            sum += covered.x * covered.y * texelAt(ivec2(x, y));
        }
    return sum / (wide * wide);
}

vec3 rayColour(Ray ray)
{
    vec2 p = sheetPoint(ray), at = middle / TEXEL + 256.0, side = vec2(0.5 * wide * TEXEL);
    sheetColour = encodeSRGB(texelAt(ivec2(floor(p / TEXEL + 256.0))));
    stroke(sdRectangle(p - middle, side), 5.0, CHALK);
    stroke(sdRectangle(p - middle, side), 2.5, ORANGE);
    dot2(p, middle, 7.0, ORANGE);

    float panel = p.x - 1.08;
    fill(-panel, PAPER, 1.0);
    int row = int(floor(1.5 - 1.5 * p.y)); // counted from the top
    vec2 centre = vec2(1.43, 0.667 - 0.667 * float(row));
    if (panel > 0.0) {
        vec3 light = texelAt(ivec2(floor(at)));
        if (row == 1 && sdRectangle(p - centre, vec2(0.26)) < 0.0) // the long sum is computed only where it is shown
            light = meanAt(at);
        if (row == 2) {
            vec2 size = vec2(textureSize(granite, 0));
            light = textureLod(granite, at / size, log2(footprint * wide)).rgb;
        }
        vec3 colour = encodeSRGB(light);
        fill(sdRectangle(p - centre, vec2(0.25, 0.25)), colour, 1.0);
        stroke(sdRectangle(p - centre, vec2(0.25, 0.25)), 1.5, INK);
        number(p, centre, 255.0 * colour.g, 0, colour.g > 0.5 ? NIGHT : CHALK);
    }
    return sheetColour;
}
