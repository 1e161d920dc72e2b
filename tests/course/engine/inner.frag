#version 330 core
#include "fine.glsl"
#include "broken.glsl"
out vec4 FragColor;
void main() { FragColor = vec4(half_of(2.0)); }
