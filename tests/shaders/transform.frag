#version 330 core
// For transform.c and deformation.c: the functions of transform.glsl at random points.
//
// Each item takes 4 pixels of a row. Time selects the function; iMouse contains its arguments.

in float Time;
out vec4 FragColor;

uniform vec4 iMouse;

#include "random.glsl"
#include "primitives.glsl"
#include "transform.glsl"

const vec3 HALF = vec3(0.75, 0.5, 1.25);
const vec3 SHIFT = vec3(0.5, -0.25, 1.0);

// The rotation by the angles iMouse.xyz, radians: first about x, then y, then z.
mat3 turn()
{
    return rotationZ(iMouse.z) * rotationY(iMouse.y) * rotationX(iMouse.x);
}

mat3 randomMatrix()
{
    vec3 a = nextVector(), b = nextVector();
    return mat3(a, b, nextVector());
}

// The value of the selected function at p.
float asked(int which, vec3 p)
{
    if (which == 0)
        return sdBox((p - SHIFT) * turn(), HALF); // moved and turned
    if (which == 1)
        return iMouse.x * sdBox(p / iMouse.x, HALF);
    if (which == 2)
        return sdSphere(mat3(2.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0) * p, 1.0) /
               largestStretch(mat3(2.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0));
    if (which == 3)
        return sdTorus(p, iMouse.x, iMouse.y);
    return 0.0;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int item = pixel.x / 4 + 256 * pixel.y, slot = pixel.x % 4, which = int(Time);
    seed = uint(item) * 9781u + 17u;
    vec4 slots[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    if (which < 10) {
        vec3 p = 3.0 * nextVector();
        slots[0] = vec4(p, asked(which, p));
    } else if (which < 20) { // 10 twist, 11 bend: a point, the stated stretch and the moved point; iMouse: rate, radius
        vec3 p = 2.0 * nextVector();
        float rate = iMouse.x;
        slots[0] = vec4(p, which == 10 ? twistStretch(rate, iMouse.y) : bendStretch(rate, iMouse.y));
        slots[1].xyz = which == 10 ? opTwist(p, rate) : opBend(p, rate);
    } else if (which == 20) { // matrices, and their largest stretch
        mat3 m = randomMatrix();
        for (int i = 0; i < 3; i++)
            slots[i].xyz = m[i];
        slots[3].x = largestStretch(m);
        slots[3].y = largestStretch(turn());
    } else if (which == 21) { // the columns of the rotation by iMouse.xyz
        for (int i = 0; i < 3; i++)
            slots[i].xyz = turn()[i];
    } else {
        slots[0] = vec4(displacementStretch(iMouse.x), heightStretch(iMouse.x), 0.0, 0.0);
    }
    FragColor = slots[slot];
}
