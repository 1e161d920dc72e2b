#version 330 core
// The scene whose rendering time is the unit of `make benchmark`. It resembles the scene at the end of the report, but
// the code is our own: a ball in the frame of a box, at most 60 steps, a normal from six distances, one sun and a
// moving camera. The scene never changes, because otherwise no earlier measurement could be compared with a new one.

in vec2  FragCoord;
in float Time;
out vec4 FragColor;

float frameDistance(vec3 p, float halfSize, float bar)
{
    vec3 a = abs(p) - halfSize;
    vec3 b = abs(a + bar) - bar;
    vec3 x = vec3(a.x, b.y, b.z), y = vec3(b.x, a.y, b.z), z = vec3(b.x, b.y, a.z);
    float alongX = length(max(x, 0.0)) + min(max(x.x, max(x.y, x.z)), 0.0);
    float alongY = length(max(y, 0.0)) + min(max(y.x, max(y.y, y.z)), 0.0);
    float alongZ = length(max(z, 0.0)) + min(max(z.x, max(z.y, z.z)), 0.0);
    return min(min(alongX, alongY), alongZ);
}

float sceneDistance(vec3 p)
{
    return min(frameDistance(p, 0.5, 0.1), length(p) - 0.25);
}

vec3 normalAt(vec3 p)
{
    vec3 x = vec3(0.01, 0.0, 0.0), y = x.yxy, z = x.yyx;
    return normalize(vec3(sceneDistance(p + x) - sceneDistance(p - x),
                          sceneDistance(p + y) - sceneDistance(p - y),
                          sceneDistance(p + z) - sceneDistance(p - z)));
}

// The distance along the ray to its hit, or -1 if it has none.
float march(vec3 origin, vec3 direction)
{
    float t = 0.0;
    for (int i = 0; i < 60; i++) {
        float d = sceneDistance(origin + t * direction);
        t += d;
        if (d <= 0.01)
            return t;
        if (d >= 20.0)
            return -1.0;
    }
    return -1.0;
}

void main()
{
    vec3 eye = vec3(2.0 * sin(0.5 * Time), 1.0, 2.0 * cos(0.5 * Time));
    vec3 forward = normalize(-eye);
    vec3 right = normalize(cross(forward, vec3(0.0, 1.0, 0.0)));
    vec3 up = cross(right, forward);
    vec3 direction = normalize(FragCoord.x * right + FragCoord.y * up + forward);
    float t = march(eye, direction);
    vec3 colour = vec3(0.5, 0.7, 1.0);
    if (t >= 0.0) {
        float facing = dot(normalAt(eye + t * direction), normalize(vec3(1.0, 2.0, 3.0)));
        colour = min(vec3(1.0), vec3(1.0, 0.9, 0.5) * max(facing, 0.0));
    }
    FragColor = vec4(colour, 1.0);
}
