#version 330 core
// For sobol.c: Sobol's pairs and their parts. Time selects the function, iMouse has its arguments, and the pixel's
// coordinates give the index of the case.

in float Time;
out vec4 FragColor;

#include "sobol.glsl"

// Two halves of an integer, which a float represents exactly.
vec2 halves(uint n)
{
    return vec2(n & 65535u, n >> 16u);
}

void main()
{
    iPixel = ivec2(gl_FragCoord.xy);
    uint number = uint(iPixel.x) + 256u * uint(iPixel.y);
    uvec4 v = hashOf(uvec4(number, 1u, 2u, 3u));
    uint bit = 1u << uint(iMouse.x);
    if (Time < 1.0)
        FragColor = vec4(halves(v.x), halves(reverseBits(v.x)));
    else if (Time < 2.0)
        FragColor = vec4(halves(v.x), halves(pascalSum(v.x)));
    else if (Time < 3.0)
        FragColor = vec4(halves(upwards(v.x, v.y) ^ upwards(v.x ^ bit, v.y)), 0.0, 0.0);
    else if (Time < 4.0)
        FragColor = vec4(sobolPoint(number, uvec3(iMouse.xyz)), 0.0, 0.0);
    else
        FragColor = vec4(pixelPair(int(iMouse.x), int(iMouse.y)), 0.0, 0.0);
}
