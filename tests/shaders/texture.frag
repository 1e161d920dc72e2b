#version 330 core
// For texturing.c: the functions of texture.glsl that read no texture, at random points. Each item
// takes 8 pixels of a row. iMouse.x is the sharpness.

out vec4 FragColor;

uniform vec4 iMouse;

#include "random.glsl"
#include "texture.glsl"

float sceneDistance(vec3 p)
{
    return length(p);
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int item = pixel.x / 8 + 128 * pixel.y, slot = pixel.x % 8;
    seed = uint(item) * 9781u + 17u;
    vec3 normal = nextDirection(), direction = nextDirection(), gradient = nextVector();
    normal = normalize(normal + vec3(1e-4));
    direction = normalize(direction + vec3(1e-4));
    if (item < 8) { // normals along the diagonals, seen at normal incidence
        normal = normalize(vec3(item & 1, item >> 1 & 1, item >> 2) - 0.5);
        direction = item < 4 ? normal : -normal;
    }
    vec3 weights = item < 8 ? vec3(1.0 / 3.0) : planeWeights(normal, iMouse.x);
    Footprint f = footprintOn(direction, normal, 0.01);
    vec4 slots[8] = vec4[8](vec4(normal, 0.0), vec4(direction, 0.0), vec4(gradient, 0.0), vec4(weights, 0.0),
                            vec4(twoPlaneWeights(weights), 0.0), vec4(f.across, 0.0), vec4(f.along, 0.0),
                            vec4(bumpedNormal(normal, gradient), 0.0));
    FragColor = slots[slot];
}
