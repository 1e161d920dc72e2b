#version 330 core
// For lens.c: the functions of lens.glsl, samples.glsl and filter.glsl. Time selects the function; iMouse contains some
// of its arguments.

in float Time;
out vec4 FragColor;

#include "lens.glsl"
#include "filter.glsl"

float sceneDistance(vec3 p)
{
    return p.y;
}

uniform float focalLength;

void main()
{
    int function = int(Time);
    // The position includes the sample's offset, which the harness adds to gl_FragCoord.
    vec2 pixel = gl_FragCoord.xy, number = floor(pixel);
    iPixel = ivec2(number);
    vec2 screen = screenPosition(pixel);
    FragColor = vec4(0.0);
    if (function == 0) { // iMouse: radius, focus, depth; position at this depth of a ray through a point of the lens
        vec2 middle = vec2(0.3, -0.4), point = discPoint(number / 15.0);
        vec3 direction = middle.x * iCameraRight + middle.y * iCameraUp + 2.0 * iCameraForward;
        Ray ray = lensRay(Ray(iCameraPosition, normalize(direction)), point, iMouse.x, iMouse.y);
        vec3 p = ray.origin - iCameraPosition;
        vec3 q = p + ray.direction * (iMouse.z / dot(ray.direction, iCameraForward));
        FragColor = vec4(dot(q, iCameraRight), dot(q, iCameraUp), point);
    } else if (function == 1) { // iMouse: radius, focus, f-number
        float depth = 0.5 + 0.1 * number.x;
        FragColor = vec4(depth, circleOfConfusion(depth, iMouse.x, iMouse.y, 2.0),
                         apertureRadius(iMouse.z, 2.0, 0.012), 0.0);
    } else if (function == 2) // iMouse: the cell to find
        FragColor = vec4(vec3(equal(ivec3(sampleCell(0), sampleCell(1), sampleCell(9)), ivec3(iMouse.x))), 0.0);
    else if (function == 3) { // 1 if each sample is in its cell
        vec2 square = sampleSquare(2);
        int side = int(sqrt(float(iSamples)) + 0.5), cell = sampleCell(2);
        vec2 within = square * float(side) - vec2(cell % side, cell / side) - 0.5;
        float along = sampleLine(5) * float(iSamples) - float(sampleCell(5)) - 0.5;
        bool inside = max(max(abs(within.x), abs(within.y)), abs(along)) < 0.5001;
        FragColor = vec4(square, inside, dot(sampleDisc(4), vec2(1.0)));
    } else if (function == 4) {
        float share = (number.x + 0.5) / 1024.0;
        FragColor = vec4(share, tentOffset(vec2(share, 0.5)).x, gaussianQuantile(share), tentOffset(vec2(share, 0.5)).y);
    } else if (function == 5) // pairs of quantities: 1 in the corner of the square below x + y = 1/2
        FragColor = vec4(lessThan(vec4(sampleSquare(2).x + sampleSquare(4).x, sampleSquare(4).y + sampleLine(6),
                                       sampleSquare(2).y + sampleLine(6), sampleSquare(4).x + sampleSquare(7).x),
                                  vec4(0.5)));
    else { // iMouse: kernel, jitter; the offset in pixels, and its square
        vec2 there = filteredScreen(screen, int(iMouse.x), iMouse.y > 0.5, 0);
        vec2 offset = 0.5 * (there * iResolution.y + iResolution.xy) - vec2(iPixel) - 0.5;
        FragColor = vec4(offset, offset * offset);
    }
}
