// Experiment of chapter 05: the report's rotation (section 2.2.2). A block is turned, and three
// rods are laid along its turned axes. With the right inverse, the rods leave the block at the
// centres of its faces and perpendicular to them.
//
// formula=0 uses the transposed matrix. formula=1 uses the report's inverse, which is the same
// rotation with negated angles. formula=2 uses the transpose of the matrix that the report prints,
// in which a term is missing.
#include "main.glsl"
#include "camera.glsl"     // perspectiveRay
#include "march.glsl"      // march
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdBox
#include "lighting.glsl"   // lambert, encodeSRGB
#include "transform.glsl"  // rotations

uniform vec3 angles;  // 30, 40, 20 in [-180, 180], degrees: alpha, beta, gamma of the report
uniform int  formula; // 0 in [0, 2]: 0 transposed, 1 negated angles, 2 the printed matrix, transposed

const vec3 BLOCK = vec3(0.62, 0.34, 0.48); // half sizes
const vec3 MIDDLE = vec3(0.0, 0.0, -0.6);

// The report's R(alpha, beta, gamma), in the order of its expanded matrix: x, then y, then z.
mat3 rotation(vec3 a)
{
    return rotationZ(a.z) * rotationY(a.y) * rotationX(a.x);
}

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// The point in the coordinates of the block.
vec3 blockPoint(vec3 p)
{
    vec3 a = radians(angles), s = sin(a), c = cos(a);
    mat3 right = rotation(a), printed = right;
    printed[1][0] = s.x * s.y * c.z; // row 1, column 2: - cos(alpha) sin(gamma) is missing
    p -= MIDDLE;
    if (formula == 1)
        return rotation(-a) * p;
    return formula == 2 ? p * printed : p * right;
}

float blockDistance(vec3 p)
{
    return sdBox(blockPoint(p), BLOCK - 0.03) - 0.03;
}

// A rod along a turned axis, which extends from the centre in both directions.
float rodDistance(vec3 p, int axis)
{
    vec3 along = rotation(radians(angles))[axis];
    vec3 q = p - MIDDLE;
    return length(q - clamp(dot(q, along), -1.15, 1.15) * along) - 0.045;
}

float sceneDistance(vec3 p)
{
    float rods = min(rodDistance(p, 0), min(rodDistance(p, 1), rodDistance(p, 2)));
    return 0.8 * min(blockDistance(p), rods); // the printed matrix is not an isometry
}

vec3 colourAt(vec3 p)
{
    if (blockDistance(p) < 0.004)
        return vec3(0.75, 0.73, 0.68);
    if (rodDistance(p, 0) < 0.004)
        return vec3(0.90, 0.35, 0.02);
    return rodDistance(p, 1) < 0.004 ? vec3(0.05, 0.45, 0.75) : vec3(0.85, 0.75, 0.10);
}

vec3 rayColour(Ray ray)
{
    Hit hit = march(ray, 0.0, 20.0, 0.001, 256);
    vec3 light = mix(vec3(0.030, 0.075, 0.11), vec3(0.003, 0.007, 0.018), smoothstep(-0.5, 0.3, ray.direction.y));
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction;
        vec3 normal = normalAt(p, 0.001);
        vec3 warm = vec3(1.0, 0.8, 0.6) * lambert(normal, normalize(vec3(1.0, 1.6, 1.3)));
        vec3 cold = vec3(0.10, 0.18, 0.30) * lambert(normal, normalize(vec3(-1.5, 0.3, 0.6)));
        light = colourAt(p) * (warm + cold + vec3(0.03, 0.04, 0.05));
    }
    return encodeSRGB(light);
}
