#version 330 core
// For noise.c: the functions of noise.glsl at random points.
//
// Each item takes 4 pixels of a row. Time selects the function; iMouse contains its arguments.

in float Time;
out vec4 FragColor;

uniform vec4 iMouse;

#include "random.glsl"
#include "noise.glsl"

vec4 asked(int which, vec3 p)
{
    if (which == 0)
        return valueNoise(p);
    if (which == 1)
        return gradientNoise(p);
    return octaveNoise(p, int(iMouse.x), iMouse.y, iMouse.z);
}

// Four random numbers in [-1, 1).
vec4 nextFour()
{
    vec3 v = nextVector();
    return vec4(v, nextSigned());
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int item = pixel.x / 4 + 256 * pixel.y, slot = pixel.x % 4, which = int(Time);
    seed = uint(item) * 9781u + 17u;
    vec4 slots[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    if (which < 3) {
        vec3 p = 20.0 * nextVector();
        slots[0].xyz = p;
        slots[1] = asked(which, p);
    } else if (which == 3) { // eight random numbers at the corners
        vec3 x = 0.5 + 0.5 * nextVector();
        slots[0].xyz = x;
        slots[2] = nextFour();
        slots[3] = nextFour();
        slots[1] = blendedValues(x, slots[2], slots[3]);
    } else if (which == 4) { // a random corner with a random direction
        vec3 x = 0.5 + 0.5 * nextVector(), corner = step(0.0, nextVector());
        slots[0].xyz = x;
        slots[2].xyz = corner;
        slots[3].xyz = nextDirection();
        slots[1] = cornerSlope(x, corner, slots[3].xyz);
    } else if (which == 5) { // a direction from bits, and the bits as two numbers that a float represents exactly
        uint bits = nextBits();
        slots[0].xyz = latticeDirection(bits);
        slots[1].xy = vec2(bits >> 16u, bits & 65535u);
    } else { // the constants
        slots[0] = vec4(VALUE_STRETCH, GRADIENT_STRETCH, octaveStretch(int(iMouse.x), iMouse.y, iMouse.z),
                        geometricSum(iMouse.y, int(iMouse.x)));
    }
    FragColor = slots[slot];
}
