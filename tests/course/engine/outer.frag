#version 330 core
#include "fine.glsl"
in vec2 FragCoord;
out vec4 FragColor;
void main() { FragColor = vec4(rde); }
