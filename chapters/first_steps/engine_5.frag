#version 330 core
// The scene of engine_4.frag on a wooden floor. The picture of the wood repeats every 2 units, and its
// texels are already decoded to linear light.

in vec2 FragCoord;
uniform vec3 CamPos, Ex, Ey, Ez; // position of the eye; right, up and forward
uniform float focal = 1.5;       // distance from the eye to the screen, in half screen heights
uniform sampler2D picture;
out vec4 FragColor;

float sceneDistance(vec3 p)
{
    float ball = length(p - vec3(-0.8, 0.7, -0.3)) - 0.7;
    vec3 q = abs(p - vec3(0.9, 0.45, 0.2)) - 0.45;
    float box = length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0);
    return min(p.y, min(ball, box));
}

float march(vec3 origin, vec3 direction)
{
    float t = 0.01, d = 1.0;
    for (int i = 0; i < 200 && d > 0.0005 && t < 40.0; i++) {
        d = sceneDistance(origin + t * direction);
        t += d;
    }
    return t;
}

vec3 normalAt(vec3 p)
{
    vec2 h = vec2(0.001, 0.0);
    return normalize(vec3(sceneDistance(p + h.xyy) - sceneDistance(p - h.xyy),
                          sceneDistance(p + h.yxy) - sceneDistance(p - h.yxy),
                          sceneDistance(p + h.yyx) - sceneDistance(p - h.yyx)));
}

// Encode light for the screen, as in chapter 02.
vec3 encodeSRGB(vec3 light)
{
    vec3 v = clamp(light, 0.0, 1.0);
    return mix(12.92 * v, 1.055 * pow(v, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, v));
}

void main()
{
    vec3 direction = normalize(FragCoord.x * Ex + FragCoord.y * Ey + focal * Ez);
    vec2 below = CamPos.xz - CamPos.y / direction.y * direction.xz; // where this ray meets y = 0
    vec3 ground = texture(picture, 0.5 * below).rgb; // in every pixel: neighbouring pixels determine the mipmap level
    vec3 colour = mix(vec3(0.62, 0.75, 0.9), vec3(0.2, 0.42, 0.8), max(direction.y, 0.0));
    float t = march(CamPos, direction);
    if (t < 40.0) {
        vec3 p = CamPos + t * direction, normal = normalAt(p);
        vec3 toSun = normalize(vec3(-1.2, 3.0, 2.4));
        float light = max(dot(normal, toSun), 0.0);
        light *= march(p + 0.01 * normal, toSun) < 40.0 ? 0.0 : 1.0;
        vec3 own = p.y < 0.001 ? ground : p.x < 0.2 ? vec3(0.7, 0.15, 0.05) : vec3(0.1, 0.25, 0.5);
        vec3 lit = own * (vec3(0.12, 0.15, 0.2) + vec3(1.0, 0.93, 0.8) * light);
        colour = mix(lit, colour, smoothstep(6.0, 30.0, t));
    }
    FragColor = vec4(encodeSRGB(colour), 1.0);
}
