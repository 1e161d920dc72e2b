#version 330 core
// Solution to exercise 2 of chapter 00: the camera is fixed and the object turns. Turning a point
// one way before evaluating its distance turns the object the other way.

in vec2 FragCoord;  // the pixel's position: y from -1 to 1, x from -aspect to aspect
in float Time;      // seconds
out vec4 FragColor; // the pixel's colour

uniform vec2 ball; // 0, 0 in [-1.5, 1.5] step 0.05, handle half screen heights: the lamp
vec3 centre;       // its centre in the scene; main computes it

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

// The point p turned about the y axis by an angle in radians; a positive angle takes z towards x.
vec3 turnedY(vec3 p, float angle)
{
    float c = cos(angle);
    float s = sin(angle);
    return vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
}

float sceneDistance(vec3 p)
{
    return min(sdBoxFrame(turnedY(p, 0.5 * Time), vec3(0.5), 0.05), sdSphere(p - centre, 0.3));
}

// 2. The march: how far along the ray is the scene? A negative result means a miss.

float march(vec3 origin, vec3 direction)
{
    float t = 0.0;
    for (int i = 0; i < 128 && t < 20.0; i++) {
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

// 4. The colour: the ball shines, and a surface that faces it, or the moon, is bright.

vec3 rayColour(vec3 origin, vec3 direction)
{
    float t = march(origin, direction);
    if (t < 0.0)
        return mix(vec3(0.03, 0.05, 0.12), vec3(0.26, 0.32, 0.52), 1.0 + direction.y); // the dusk
    vec3 p = origin + t * direction;
    vec3 normal = normalAt(p);
    if (sdSphere(p - centre, 0.3) < 0.001)
        return mix(vec3(1.0, 0.6, 0.2), vec3(1.0, 0.95, 0.8), -dot(normal, direction)); // the lamp
    vec3 toLamp = centre - p;
    float lamp = max(dot(normal, normalize(toLamp)), 0.0) / dot(toLamp, toLamp);
    float moon = max(dot(normal, normalize(vec3(1.0, 2.0, 3.0))), 0.0);
    return lamp * vec3(0.40, 0.27, 0.15) + (0.3 + moon) * vec3(0.22, 0.28, 0.40);
}

// 5. The camera: where is the eye, and where does this pixel look?

void main()
{
    vec3 eye = vec3(0.0, 1.0, 1.8);
    vec3 forward = normalize(-eye);
    vec3 right = normalize(cross(forward, vec3(0.0, 1.0, 0.0)));
    vec3 up = cross(right, forward);
    centre = length(eye) / 1.8 * (ball.x * right + ball.y * up);
    vec3 direction = normalize(FragCoord.x * right + FragCoord.y * up + 1.8 * forward);
    FragColor = vec4(rayColour(eye, direction), 1.0);
}
