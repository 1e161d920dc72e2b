#version 330 core
// First step 1: the screen. This program runs once for every pixel, and only the position differs
// from pixel to pixel. Here this position becomes a colour.

in vec2 FragCoord;  // y from -1 (bottom) to 1 (top), x from -aspect (left) to aspect (right)
out vec4 FragColor; // red, green, blue, each from 0 to 1, and an opacity that is not used

void main()
{
    float red = 0.5 + 0.5 * FragCoord.x;   // try 0.5 + 1.0 * FragCoord.x
    float green = 0.5 + 0.5 * FragCoord.y;
    float blue = 0.4;                      // try 1.0
    FragColor = vec4(red, green, blue, 1.0);
}
