#version 330 core
// First step 4: the march. Ask how far the scene is; go that far along the ray; ask again. Near
// enough is a hit, shown white.

in vec2 FragCoord;
out vec4 FragColor;

float sceneDistance(vec3 p)
{
    float ball = length(p - vec3(0.0, 0.0, -3.0)) - 1.0; // centre, radius: move it, shrink it
    float ground = p.y + 1.0;
    return min(ball, ground);
}

void main()
{
    vec3 direction = normalize(vec3(FragCoord, -1.5));
    float t = 0.0; // how far the ray has come
    float d = 1.0; // how far the scene is from there
    for (int i = 0; i < 200 && d > 0.001 && t < 40.0; i++) { // try 8 in place of 200
        d = sceneDistance(t * direction);
        t += d;
    }
    float white = d <= 0.001 ? exp(-0.12 * (t - 2.0)) : 0.0; // a little darker with the distance
    FragColor = vec4(vec3(white), 1.0);
}
