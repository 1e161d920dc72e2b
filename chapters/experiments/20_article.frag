// Experiment of chapter 20: clouds and weather as the article computes them, with values that are
// already encoded for the screen.

#include "main.glsl"
#define rayColour chapterColour
#include "20_clouds_and_weather.frag"
#undef rayColour

uniform bool positive; // false: keep the clouds' colour from becoming negative at night

vec3 rayColour(Ray ray)
{
    float hour = timeOfDay + hoursPerSecond * iTime, height = sunDirection(hour, LATITUDE, DECLINATION).y;
    Lights lights = lightsAt(hour);
    Surface surface = surfaceAlong(ray);
    vec3 direction = normalize(vec3(surface.seen.direction.x, max(surface.seen.direction.y, 0.0), surface.seen.direction.z));
    vec3 screen = encodeSRGB(filmOfLargest(exposed(skyLight(direction, lights) + heavens(direction, lights, 0.01), lights.stops), 1.3, 6.0));
    float turn = turned + drift * iTime, share = 2.0 * (weather - 0.5);
    float fair = cloudPanorama(cloudsFair, direction, turn, skyWidth(surface)).cover;
    float storm = cloudPanorama(cloudsStorm, direction, turn, skyWidth(surface)).cover;
    float grey = min(1.5 * weather, 1.0) * (height > 0.0 ? 0.95 : 0.95 + 1.8 * height);
    grey = positive ? max(grey, 0.0) : grey;
    screen = mix(weather * screen, vec3(grey), clamp((2.0 - weather) * mix(storm, fair, share), 0.0, 1.0));
    vec3 scene = encodeSRGB(filmOfLargest(exposed(surfaceLight(surface, ray.direction, vec3(0.0), lights), lights.stops), 1.3, 6.0));
    return surface.land ? scene : (surface.water ? 0.8 * screen : screen);
}
