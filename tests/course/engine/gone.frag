#version 330 core
#include "gone.glsl"
void main() {}
