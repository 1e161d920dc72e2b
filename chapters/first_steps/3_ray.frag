#version 330 core
// First step 3: a ray. The eye is at the origin and looks along -z; the screen is in front of it.
// The ray of each pixel has a different direction: x is shown as red, y as green, -z as blue.

in vec2 FragCoord;
out vec4 FragColor;

void main()
{
    float focalLength = 1.0; // distance from the eye to the screen; try 0.3 and 4.0
    vec3 direction = normalize(vec3(FragCoord, -focalLength));

    vec3 colour = vec3(0.5 + 0.5 * direction.xy, -direction.z);
    FragColor = vec4(colour, 1.0);
}
