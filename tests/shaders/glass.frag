#version 330 core
// For glass.c and spectrum.c: the functions of glass.glsl, fresnel.glsl, spectrum.glsl, prism.glsl and caustic.glsl.
// Time selects the function; iMouse contains some of its arguments, and the pixel's coordinates determine the others.

in float Time;
out vec4 FragColor;

#include "inputs.glsl"
#include "glass.glsl"
#include "spectrum.glsl"
#include "prism.glsl"
#include "caustic.glsl"
#include "primitives.glsl"
#include "solids.glsl"
#include "combine.glsl"

// The shape of the scene: 0 is a ball, 1 a slab perpendicular to y, 2 the shape of the tumbler, 3 a block of two halves
// that touch, 4 a rounded prism.
int shape = 0;

float sceneDistance(vec3 p)
{
    if (shape == 0)
        return sdSphere(p, 1.0);
    if (shape == 1)
        return abs(p.y) - 0.5;
    if (shape == 2)
        return opSubtraction(opRound(sdCappedCone(p, 0.50, 0.58, 0.77), 0.03),
                             sdCappedCone(p - vec3(0.0, 0.30, 0.0), 0.455, 0.54, 0.8));
    if (shape == 4)
        return opRound(opExtrude(sdTriangle(p.xz, vec2(-0.6, -0.3), vec2(0.6, -0.3), vec2(0.0, 0.7)), p.y, 0.5), 0.05);
    return min(sdBox(p - vec3(0.5, 0.0, 0.0), vec3(0.5)), sdBox(p + vec3(0.5, 0.0, 0.0), vec3(0.5)));
}

// A ray parallel to the z axis that meets the ball at the distance `offset` from this axis.
Ray towardsBall(float offset, float turn)
{
    vec3 across = vec3(cos(turn), sin(turn), 0.0);
    return Ray(offset * across + vec3(0.0, 0.0, 3.0), vec3(0.0, 0.0, -1.0));
}

void main()
{
    int function = int(Time);
    float number = floor(gl_FragCoord.x), row = floor(gl_FragCoord.y);
    iPixel = ivec2(gl_FragCoord.xy);
    traceReset(-1);
    FragColor = vec4(0.0);
    if (function == 0) { // Fresnel and Schlick; iMouse: eta, share at normal incidence
        float facing = number / 512.0;
        FragColor = vec4(facing, fresnelShare(facing, iMouse.x), schlickShare(facing, iMouse.y), 0.0);
    } else if (function == 2) { // through the ball; iMouse: index, threshold, offset in thresholds
        Ray ray = towardsBall((number + 0.5) / 512.0, 0.4 * row);
        Hit in_ = marchSide(ray, 1.0, 0.0, 9.0, iMouse.y, 4096);
        vec3 p = ray.origin + in_.t * ray.direction, normal = normalize(p);
        ray = leavingRay(p, normal, refract(ray.direction, normal, 1.0 / iMouse.x), iMouse.z * iMouse.y);
        Hit out_ = marchSide(ray, -1.0, 0.0, 9.0, iMouse.y, 4096);
        p = ray.origin + out_.t * ray.direction;
        normal = normalize(p);
        vec3 left = refract(ray.direction, -normal, iMouse.x);
        FragColor = vec4(left, in_.found && out_.found ? out_.t : -1.0);
    } else if (function == 3) { // straight through a ball or a slab; iMouse: shape, index, shortest step
        shape = int(iMouse.x);
        float angle = 1.3 * number / 255.0, offset = number / 256.0;
        Ray ray = shape == 1 ? Ray(vec3(0.0, 2.0, 0.0), vec3(sin(angle), -cos(angle), 0.0)) : towardsBall(offset, 0.0);
        Passage passage = straightThrough(ray, 60.0, iMouse.y, iMouse.z, 4096);
        FragColor = vec4(passage.share, passage.inside, passage.deepest, shape == 1 ? angle : offset);
    } else if (function == 4) { // the caustic; iMouse: index, z, spread
        float r = 3.0 * (number + 0.5) / 2048.0;
        FragColor = vec4(r, ballCaustic(vec3(r, 0.0, -iMouse.y), vec3(0.0, 0.0, 1.0), 1.0, iMouse.x, iMouse.z), 0.0, 0.0);
    } else if (function == 5) { // the colours of the wavelengths
        float wave = SHORTEST_WAVE + (LONGEST_WAVE - SHORTEST_WAVE) * (number + 0.5) / 512.0;
        FragColor = vec4(waveColour(wave), wave);
    } else if (function == 6) { // the prism; iMouse: apex, rise
        float index = 1.1 + 0.4 * row / 15.0, entering = sin(-0.4 + 1.9 * number / 255.0);
        float leaving = prismLeaving(entering, iMouse.x, index);
        FragColor = vec4(leaving, prismIndex(entering, leaving, iMouse.x), leastDeviation(iMouse.x, index), planIndex(index, iMouse.y));
    } else if (function == 7) { // absorption, and cauchyWave of cauchyIndex
        vec3 one = absorbed(vec3(0.2, 1.0, 3.0), 0.01 * number) * absorbed(vec3(0.2, 1.0, 3.0), 0.5);
        FragColor = vec4(one, cauchyWave(vec2(1.6894, 0.01341), cauchyIndex(vec2(1.6894, 0.01341), 0.4 + 0.001 * number)));
    } else if (function == 8) { // meanColour, sampleWave; iMouse: the two wavelengths, count, shift
        FragColor = vec4(meanColour(iMouse.x, iMouse.y), sampleWave(int(number), int(iMouse.z), iMouse.w));
    } else if (function == 10) { // the beam; iMouse: position, rise, half width
        Beam beam = prismBeam(iMouse.xy, 0.32, vec2(1.6894, 0.01341), iMouse.z, iMouse.w);
        FragColor = vec4(beam.white, beam.waves, 0.0);
    } else if (function == 11) { // from inside a slab; iMouse: index, first angle in degrees; 100 pixels per degree
        shape = 1;
        float angle = radians(0.01 * number + iMouse.y);
        Ray ray = Ray(vec3(0.0), vec3(sin(angle), cos(angle), 0.0));
        Hit hit = marchSide(ray, -1.0, 0.0, 9.0, 0.0001, 4096);
        vec3 left = refract(ray.direction, vec3(0.0, -1.0, 0.0), iMouse.x);
        FragColor = vec4(0.01 * number + iMouse.y, length(left), fresnelShare(cos(angle), iMouse.x), hit.t);
    } else if (function == 12) { // at scattered points: the distance that remains after a step of the claimed depth
        shape = int(iMouse.x);
        vec3 p = (fract((number + 131.0 * row) * vec3(0.8191725, 0.6710436, 0.5497005)) - 0.5) * vec3(1.9, 1.8, 1.4);
        vec3 slope = vec3(sceneDistance(p + vec3(0.002, 0.0, 0.0)) - sceneDistance(p - vec3(0.002, 0.0, 0.0)),
                          sceneDistance(p + vec3(0.0, 0.002, 0.0)) - sceneDistance(p - vec3(0.0, 0.002, 0.0)),
                          sceneDistance(p + vec3(0.0, 0.0, 0.002)) - sceneDistance(p - vec3(0.0, 0.0, 0.002))) / 0.004;
        float d = sceneDistance(p);
        FragColor = vec4(d, sceneDistance(p - d * normalize(slope)), length(slope), 0.0);
    } else { // the distance that a shape claims at scattered points
        shape = int(iMouse.x);
        vec3 p = (fract((number + 131.0 * row) * vec3(0.8191725, 0.6710436, 0.5497005)) - 0.5) * vec3(1.9, 1.8, 1.4);
        FragColor = vec4(p, sceneDistance(p));
    }
}
