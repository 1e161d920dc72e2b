#version 330 core
// Solution to exercise 1 of chapter 00: a snowman. The scene is the min() of several distances:
// those to three balls of snow, two of coal, and the ground. The march may take 512 steps, because
// rays that pass close to the snow or the ground need more than 128.

in vec2 FragCoord;  // the pixel's position: y from -1 to 1, x from -aspect to aspect
in float Time;      // seconds
out vec4 FragColor; // the pixel's colour

// 1. The scene: how far is the point p from it?

float sdSphere(vec3 p, float radius)
{
    return length(p) - radius;
}

float eyesDistance(vec3 p)
{
    return min(sdSphere(p - vec3(0.07, 0.59, 0.18), 0.03),
               sdSphere(p - vec3(-0.07, 0.59, 0.18), 0.03));
}

float sceneDistance(vec3 p)
{
    float belly = sdSphere(p - vec3(0.0, -0.40, 0.0), 0.40);
    float chest = sdSphere(p - vec3(0.0, 0.14, 0.0), 0.28);
    float head = sdSphere(p - vec3(0.0, 0.54, 0.0), 0.20);
    float ground = p.y + 0.8;
    return min(min(min(belly, chest), min(head, eyesDistance(p))), ground);
}

// 2. The march: how far along the ray is the scene? A negative result means a miss.

float march(vec3 origin, vec3 direction)
{
    float t = 0.0;
    for (int i = 0; i < 512 && t < 20.0; i++) {
        float d = sceneDistance(origin + t * direction);
        if (d < 0.0005)
            return t;
        t += d;
    }
    return -1.0;
}

// 3. The normal: in which direction does the distance grow fastest?

vec3 normalAt(vec3 p)
{
    const vec2 h = vec2(0.001, 0.0);
    return normalize(vec3(sceneDistance(p + h.xyy) - sceneDistance(p - h.xyy),
                          sceneDistance(p + h.yxy) - sceneDistance(p - h.yxy),
                          sceneDistance(p + h.yyx) - sceneDistance(p - h.yyx)));
}

// 4. The colour: a surface that faces the sun is bright.

vec3 rayColour(vec3 origin, vec3 direction)
{
    float t = march(origin, direction);
    if (t < 0.0)
        return mix(vec3(0.03, 0.05, 0.12), vec3(0.26, 0.32, 0.52), 1.0 + direction.y); // the dusk
    vec3 p = origin + t * direction;
    vec3 colour = eyesDistance(p) < 0.001 ? vec3(0.1) : vec3(0.95, 0.97, 1.0); // coal, snow
    vec3 toSun = normalize(vec3(1.0, 2.0, 3.0));
    return colour * mix(vec3(0.15, 0.2, 0.3), vec3(1.0), max(dot(normalAt(p), toSun), 0.0));
}

// 5. The camera: where is the eye, and where does this pixel look?

void main()
{
    vec3 eye = vec3(2.1 * sin(0.5 * Time), 0.5, 2.1 * cos(0.5 * Time));
    vec3 forward = normalize(-eye);
    vec3 right = normalize(cross(forward, vec3(0.0, 1.0, 0.0)));
    vec3 up = cross(right, forward);
    vec3 direction = normalize(FragCoord.x * right + FragCoord.y * up + 1.8 * forward);
    FragColor = vec4(rayColour(eye, direction), 1.0);
}
