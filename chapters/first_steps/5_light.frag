#version 330 core
// First step 5: light. The normal is the direction in which the distance grows fastest. A surface
// that faces the light is bright.
in vec2 FragCoord;
out vec4 FragColor;

float sceneDistance(vec3 p)
{
    return min(length(p - vec3(0.0, 0.0, -3.0)) - 1.0, p.y + 1.0);
}

void main()
{
    vec3 direction = normalize(vec3(FragCoord, -1.5));
    float t = 0.0, d = 1.0;
    for (int i = 0; i < 200 && d > 0.001 && t < 40.0; i++) {
        d = sceneDistance(t * direction);
        t += d;
    }
    vec3 p = t * direction;
    vec2 h = vec2(0.001, 0.0);
    vec3 normal = normalize(vec3(sceneDistance(p + h.xyy) - sceneDistance(p - h.xyy),
                                 sceneDistance(p + h.yxy) - sceneDistance(p - h.yxy),
                                 sceneDistance(p + h.yyx) - sceneDistance(p - h.yyx)));
    vec3 toLight = normalize(vec3(-2.5, 2.5, -0.5) - p); // to the lamp; try vec3(2.0, 0.0, -2.0) - p
    vec3 sky = vec3(0.5, 0.7, 1.0);
    vec3 colour = d <= 0.001 ? vec3(1.0, 0.9, 0.7) * (0.1 + 0.9 * max(dot(normal, toLight), 0.0)) : sky;
    FragColor = vec4(colour, 1.0);
}
