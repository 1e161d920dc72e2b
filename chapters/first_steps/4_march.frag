#version 330 core
// First step 4: the march. Find how far away the scene is, go that far along the ray, and repeat.
// A point that is close enough is a hit, shown in white.

in vec2 FragCoord;
out vec4 FragColor;

float sceneDistance(vec3 p)
{
    float ball = length(p - vec3(0.0, 0.0, -3.0)) - 1.0; // try another centre or radius
    float ground = p.y + 1.0;
    return min(ball, ground);
}

void main()
{
    vec3 direction = normalize(vec3(FragCoord, -1.5));
    float t = 0.0; // distance travelled along the ray
    float d = 1.0; // distance from the point at t to the scene
    for (int i = 0; i < 200 && d > 0.001 && t < 40.0; i++) { // try 8 instead of 200
        d = sceneDistance(t * direction);
        t += d;
    }
    float white = d <= 0.001 ? exp(-0.12 * (t - 2.0)) : 0.0; // darker in the distance
    FragColor = vec4(vec3(white), 1.0);
}
