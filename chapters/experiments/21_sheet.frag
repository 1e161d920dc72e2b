// Experiment of chapter 21: a sheet of 5 x 12 pictures, which shows the scene at every second hour
// from top to bottom and in five kinds of weather from left to right. Each picture has its own rays,
// hour and weather.
#include "main.glsl"
#include "camera.glsl"

const vec2 SHEET = vec2(5.0, 12.0); // pictures, across and down

// The spread of a pixel in one of the small pictures.
float sheetSpread()
{
    return SHEET.y / (iResolution.y * focalLength);
}

#include "cone.glsl"
#include "coarse.glsl"
#define pixelSpread sheetSpread
#define pixelRay chapterPixelRay
#include "21_a_landscape.frag"
#undef pixelRay

Ray pixelRay(vec2 screen)
{
    vec2 size = iResolution.xy / SHEET, pixel = 0.5 * (screen * iResolution.y + iResolution.xy);
    vec2 tile = clamp(floor(pixel / size), vec2(0.0), SHEET - 1.0), local = pixel - tile * size;
    theHour = 2.0 * (SHEET.y - 1.0 - tile.y);
    theWeather = 1.0 - 0.125 * tile.x;
    theScreen = (2.0 * local - size) / size.y;
    return perspectiveRay(theScreen);
}
