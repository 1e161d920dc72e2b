// Experiment of chapter 15: the workshop's anti-aliasing, a loop in the shader that takes the mean
// of n x n rays per pixel. Their positions are (i, j) / n from the pixel's centre, so the picture
// is shifted; and the mean is that of encoded values. The parameters `centred` and `asLight`
// correct these mistakes.
#include "main.glsl"
#define rayColour chapterRayColour
#include "15_the_picture.frag"
#undef rayColour

uniform int  side;     // 2 in [1, 8]: rays per side: side x side rays
uniform bool centred;  // false: positions at the centres of their cells
uniform bool asLight;  // false: the mean of the light, encoded once

vec3 rayColour(Ray ray)
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < side * side; i++) {
        vec2 offset = (vec2(i % side, i / side) + (centred ? 0.5 : 0.0)) / float(side) - (centred ? 0.5 : 0.0);
        vec3 shown = developed(lightOnFilm(perspectiveRay(screenPosition(vec2(iPixel) + 0.5 + offset))));
        sum += asLight ? shown : encodeSRGB(shown);
    }
    sum /= float(side * side);
    return asLight ? encodeSRGB(sum) : sum;
}
