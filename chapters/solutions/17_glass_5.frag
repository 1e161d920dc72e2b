// Solution to exercise 17.5: each sample has its own wavelengths, from the same parts of the
// spectrum.
#include "main.glsl"
#define rayColour chapterRayColour
#include "17_glass.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    vec3 sum = vec3(0.0), weight = vec3(0.0);
    float shift = (float(iSample) + 0.5) / float(iSamples);
    for (int k = 0; k < waves; k++) {
        float wave = sampleWave(k, waves, shift);
        Way way = wayThrough(ray, wave, 32 * k);
        sum += waveColour(wave) * (way.light + (way.free ? way.share * worldLight(way.ray, way.far) : vec3(0.0)));
        weight += waveColour(wave);
    }
    return encodeSRGB(sum / weight);
}
