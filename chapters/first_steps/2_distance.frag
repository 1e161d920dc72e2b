#version 330 core
// First step 2: a distance. How far is this pixel from a circle? The distance is positive outside
// (warm colours), negative inside (blue) and zero on the circle (white). The bands are lines of
// equal distance, 0.1 apart.

in vec2 FragCoord;
out vec4 FragColor;

float sdCircle(vec2 p, float radius)
{
    return length(p) - radius;
}

void main()
{
    vec2 centre = vec2(-0.3, 0.1);
    float d = sdCircle(FragCoord - centre, 0.5); // try 0.8, or min() of two circles

    vec3 colour = d > 0.0 ? vec3(0.95, 0.65, 0.30) : vec3(0.25, 0.50, 0.85);
    float fade = exp(-1.5 * abs(d));
    float band = smoothstep(0.10, 0.14, abs(fract(10.0 * d + 0.5) - 0.5));
    colour *= (0.35 + 0.65 * fade) * (0.75 + 0.25 * band);
    colour = mix(vec3(1.0), colour, smoothstep(0.008, 0.016, abs(d)));
    FragColor = vec4(colour, 1.0);
}
