// Solution to exercise 20.5: the panorama carried by the wind, endlessly.
#include "main.glsl"
#include "clouds.glsl"

Cloud windyPanorama(sampler2D panorama, vec3 direction, float turned, float width)
{
    const float PERIOD = 40.0, SPEED = 0.03, ALTITUDE = 1.2; // s, km/s, km
    Cloud sum = Cloud(0.0, 0.0, 0.0);
    for (int k = 0; k < 2; k++) {
        float phase = fract(iTime / PERIOD + 0.5 * float(k)), weight = 1.0 - abs(2.0 * phase - 1.0);
        vec3 shift = vec3(0.0, 0.0, -SPEED * PERIOD * (phase - 0.5)); // the clouds move east
        Cloud part = cloudPanorama(panorama, seenFromMiddle(shift, direction, ALTITUDE), turned, width);
        sum = Cloud(sum.cover + weight * part.cover, sum.above + weight * part.above, sum.side + weight * part.side);
    }
    return sum;
}

#define cloudPanorama windyPanorama
#include "20_clouds_and_weather.frag"
