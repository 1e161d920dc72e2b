#version 330 core
// Solution to exercise 4 of chapter 00: the cost of each pixel. The march returns the number of
// steps; black is 0 steps, and white is 64 or more.

in vec2 FragCoord;  // the pixel's position: y from -1 to 1, x from -aspect to aspect
in float Time;      // seconds
out vec4 FragColor; // the pixel's colour

// 1. The scene: how far is the point p from it?

float sdSphere(vec3 p, float radius)
{
    return length(p) - radius;
}

float boxDistance(vec3 q)
{
    return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0);
}

float sdBoxFrame(vec3 p, vec3 halfSize, float beam)
{
    vec3 outer = abs(p) - halfSize;
    vec3 inner = abs(outer + beam) - beam;
    return min(boxDistance(vec3(outer.x, inner.y, inner.z)),
               min(boxDistance(vec3(inner.x, outer.y, inner.z)),
                   boxDistance(vec3(inner.x, inner.y, outer.z))));
}

float sceneDistance(vec3 p)
{
    return min(sdBoxFrame(p, vec3(0.5), 0.05), sdSphere(p, 0.3));
}

// 2. The march: how many times is the distance evaluated?

int marchSteps(vec3 origin, vec3 direction)
{
    float t = 0.0;
    int steps = 0;
    while (steps < 128 && t < 20.0) {
        float d = sceneDistance(origin + t * direction);
        steps++;
        if (d < 0.0005)
            return steps;
        t += d;
    }
    return steps;
}

// 3. The colour: float() and 64.0 are needed, because steps / 64 would be an integer division.

vec3 rayColour(vec3 origin, vec3 direction)
{
    return vec3(float(marchSteps(origin, direction)) / 64.0);
}

// 4. The camera: where is the eye, and where does this pixel look?

void main()
{
    vec3 eye = vec3(1.8 * sin(0.5 * Time), 1.0, 1.8 * cos(0.5 * Time));
    vec3 forward = normalize(-eye);
    vec3 right = normalize(cross(forward, vec3(0.0, 1.0, 0.0)));
    vec3 up = cross(right, forward);
    vec3 direction = normalize(FragCoord.x * right + FragCoord.y * up + 1.8 * forward);
    FragColor = vec4(rayColour(eye, direction), 1.0);
}
