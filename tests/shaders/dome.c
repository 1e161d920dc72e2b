// dome.c - the whole sky of chapters 20 and 21 over 24 hours, as displayed. No part of it is black,
// there is no bright spot at the zenith by day, and the sky darkens through dusk.
#include "lib/test.h"
#include "lib/chapter.h"

// A column of the picture is one of 64 times of day and one of 10 azimuths; a row is a height above
// the horizon.
enum { AZIMUTHS = 10, HOURS = CHAPTER_WIDTH / AZIMUTHS };

#define DIRECTION                                                                                  \
    "float hour = 24.0 * floor(pixel.x / 10.0) / 64.0, turn = radians(36.0 * mod(pixel.x, "        \
    "10.0)), "                                                                                     \
    "high = radians(0.25 * (pixel.y + 0.5));"                                                      \
    "vec3 d = vec3(cos(high) * cos(turn), sin(high), cos(high) * sin(turn));"

static double shown(const float *values, int hour, int azimuth, int row)
{
    const float *at = values + 4 * (row * CHAPTER_WIDTH + hour * AZIMUTHS + azimuth);
    return fmax((double)at[0], fmax((double)at[1], (double)at[2]));
}

// The mean of some rows at one time of day; each row is a ring of the sky.
static double mean_of(const float *values, int hour, int from, int to)
{
    double sum = 0.0;
    for (int row = from; row < to; row++)
        for (int azimuth = 0; azimuth < AZIMUTHS; azimuth++)
            sum += shown(values, hour, azimuth, row);
    return sum / (AZIMUTHS * (to - from));
}

// The brightest point of a row at one time of day.
static double brightest_of(const float *values, int hour, int row)
{
    double most = 0.0;
    for (int azimuth = 0; azimuth < AZIMUTHS; azimuth++)
        most = fmax(most, shown(values, hour, azimuth, row));
    return most;
}

static void judge(const char *what, const float *values, int sunset, int night)
{
    double darkest = 1.0, spot = 0.0, rise = 0.0;
    for (int hour = 0; hour < HOURS; hour++)
        for (int row = 0; row < CHAPTER_HEIGHT; row++)
            for (int azimuth = 0; azimuth < AZIMUTHS; azimuth++) {
                double here = shown(values, hour, azimuth, row);
                darkest = fmin(darkest, here);
                // By day, when there are no stars, compare the sky above 80 degrees with the
                // brightest point of the ring 5 degrees lower.
                if (row >= 320 && hour > 16 && hour < 48)
                    spot = fmax(spot, here / (brightest_of(values, hour, row - 20) + 0.02));
            }
    for (int hour = sunset; hour < night; hour++)
        rise = fmax(rise, mean_of(values, hour + 1, 0, CHAPTER_HEIGHT) -
                              mean_of(values, hour, 0, CHAPTER_HEIGHT));
    print_message("# %s: darkest %.1f / 255; overhead at most %.2f times the brightest of the ring "
                  "5 degrees lower; at dusk "
                  "at most %.4f brighter than 22 minutes before\n",
                  what, 255.0 * darkest, spot, rise);
    assert_true(darkest > 1.0 / 255.0 && spot < 1.45 && rise < 0.01);
}

TEST(the_sky_of_chapter_20_is_smooth_and_never_black)
{
    float *values =
        chapter_numbers("20_clouds_and_weather", DIRECTION
                        "Lights now = lightsAt(hour); vec3 s = skyWithClouds(d, now, 0.003);"
                        "return encodeSRGB(filmOfLargest(exposed(s, now.stops), 1.3, 6.0));");
    judge("chapter 20", values, 47, 50); // from 17.6 h to 18.75 h
    free(values);
}

TEST(the_sky_of_chapter_21_is_smooth_and_never_black)
{
    for (int weather = 0; weather < 3; weather++) {
        char body[900], what[64];
        snprintf(body, sizeof body,
                 DIRECTION "theHour = hour; theWeather = %.2f; Hour now = hourNow(); float open;"
                           "vec3 s = nightSight(daylightFilm(skyLight(d, now, false, open)));"
                           "return encodeSRGB(filmOfLargest(exposed(s, now.stops), 1.3, 8.0));",
                 0.5 + 0.25 * weather);
        snprintf(what, sizeof what, "chapter 21, weather %.2f", 0.5 + 0.25 * weather);
        float *values = chapter_numbers("21_a_landscape", body);
        judge(what, values, 49, 52); // from 18.4 h to 19.5 h
        free(values);
    }
}

TESTS(gpu_setup, gpu_teardown)
