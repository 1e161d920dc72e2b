// hours.c - tests the light of the pictures of chapters 18 to 21 from hour to hour: no dusk becomes
// brighter, no dawn becomes darker, and no six minutes change the picture suddenly.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

enum { WIDTH = 160, HEIGHT = 90, FRAMES = 61 }; // a frame every six minutes, for six hours

// The mean of a picture: the brightness of its light, and its numbers from 0 to 255.
struct mean {
    double light, number;
};

// Draw the loaded chapter at an hour.
static struct mean mean_at(const struct camera *camera, double hour)
{
    struct renderer_inputs inputs = {
        .width = WIDTH, .height = HEIGHT, .samples = 1, .camera = *camera};
    struct image image = {0};
    struct mean mean = {0.0, 0.0};
    gpu_set("timeOfDay", hour);
    assert_true(renderer_picture(&gpu.renderer, &inputs, &image));
    static const double weight[3] = {0.2126, 0.7152, 0.0722}; // IEC 61966-2-1
    for (int i = 0; i < 3 * WIDTH * HEIGHT; i++) {
        mean.light += weight[i % 3] * mirror_decode(image.pixel[i] / 255.0) / (WIDTH * HEIGHT);
        mean.number += image.pixel[i] / (3.0 * WIDTH * HEIGHT);
    }
    image_free(&image);
    return mean;
}

// What was seen in six hours, from the bright end to the dark one.
struct hours {
    double rise; // the largest share by which the light exceeds that of a brighter hour
    double step; // the largest change of the mean number in six minutes
};

// Follow the light from an hour on, forwards into the night or backwards.
//   way    hours per frame, 0.1 or -0.1
//   night  the hour from which on, in this order, moon and stars may make the picture brighter
static struct hours follow(const struct camera *camera, double hour, double way, double night)
{
    struct hours seen = {0.0, 0.0};
    struct mean before = {0.0, 0.0};
    double least = 1.0;
    for (int i = 0; i < FRAMES; i++, hour += way) {
        struct mean mean = mean_at(camera, hour);
        if (i > 0)
            seen.step = fmax(seen.step, fabs(mean.number - before.number));
        if (way * (hour - night) < 0.0)
            seen.rise = fmax(seen.rise, mean.light / least - 1.0);
        least = fmin(least, mean.light);
        before = mean;
    }
    return seen;
}

// Check the dusk, from 16 to 22 h, and the dawn, from 9 to 3 h, as a chapter's parameters are set.
//   dusk, dawn  the hours between which moon and stars may make the night brighter
static void check(const struct camera *camera, const char *what, double dusk, double dawn)
{
    struct hours evening = follow(camera, 16.0, 0.1, dusk);
    struct hours morning = follow(camera, 9.0, -0.1, dawn);
    printf("# drawn: %s: light rises by at most %.1f %% at dusk, %.1f %% at dawn backwards; six "
           "minutes "
           "change at most %.1f, %.1f of 255\n",
           what, 100.0 * evening.rise, 100.0 * morning.rise, evening.step, morning.step);
    fflush(stdout);
    assert_true(evening.rise < 0.01 && morning.rise < 0.01);
    assert_true(evening.step < 12.0 && morning.step < 12.0);
}

TEST(test_the_sky_from_tables)
{
    struct camera camera = gpu_open_chapter("18_sky_from_tables");
    check(&camera, "18", 22.05, 2.95);
}

TEST(test_the_moon_and_the_stars)
{
    struct camera camera = gpu_open_chapter("19_moon_and_stars");
    for (int quarter = 0; quarter < 4; quarter++) {
        char what[32];
        snprintf(what, sizeof what, "19, quarter %d", quarter);
        gpu_set("moonAge", 7.38 * quarter);
        check(&camera, what, quarter == 0 ? 20.0 : 19.0, quarter == 0 ? 4.0 : 5.0);
    }
}

TEST(test_clouds_and_weather)
{
    static const double weather[4] = {1.0, 0.85, 0.7, 0.5};
    struct camera camera = gpu_open_chapter("20_clouds_and_weather");
    for (int i = 0; i < 5; i++) { // the last one without clouds
        char what[32];
        snprintf(what, sizeof what, "20, weather %.2f%s", weather[i % 4],
                 i < 4 ? "" : ", no cloud");
        gpu_set("weather", weather[i % 4]);
        gpu_set("clouds", i < 4 ? 3.0 : 0.0);
        check(&camera, what, 18.4, 5.6);
    }
}

TEST(test_a_landscape)
{
    struct camera camera = gpu_open_chapter("21_a_landscape");
    for (int i = 0; i < 6; i++) {
        char what[48];
        gpu_set("weather", 1.0 - 0.25 * (i % 3));
        gpu_set("moonAge", i < 3 ? 0.0 : 14.77);
        snprintf(what, sizeof what, "21, weather %.2f, %s moon", 1.0 - 0.25 * (i % 3),
                 i < 3 ? "no" : "full");
        check(&camera, what, i < 3 ? 20.5 : 19.0, i < 3 ? 3.5 : 5.0);
    }
}

TESTS(gpu_setup, gpu_teardown)
