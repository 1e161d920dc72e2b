#version 330 core
#include "fine.glsl"
#include "expression.glsl"
out vec4 FragColor;
void main() { FragColor = vec4(doubled(2.0)); }
