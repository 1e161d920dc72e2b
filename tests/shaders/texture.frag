#version 330 core
// For test_texture.c: the functions of texture.glsl that look nothing up, at random places.
//
// Each item takes 4 pixels of a row. iMouse.x is the sharpness.

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
    vec3 weights = planeWeights(normal, iMouse.x);
    Footprint f = footprintOn(direction, normal, 0.01);
    vec4 slots[8] = vec4[8](vec4(normal, 0.0), vec4(direction, 0.0), vec4(gradient, 0.0), vec4(weights, 0.0),
                            vec4(twoPlaneWeights(weights), 0.0), vec4(f.across, 0.0), vec4(f.along, 0.0),
                            vec4(bumpedNormal(normal, gradient), 0.0));
    FragColor = slots[slot];
}
