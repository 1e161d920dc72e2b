// panorama.c - tests that the clouds of chapter 20 are its panorama, rotated, and that no seam is
// visible where the panorama ends, whereas the hardware's derivatives cause one.
#include "lib/test.h"
#include "picture/image.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

#define CHAPTER "20_clouds_and_weather"

enum { WIDTH = 640, HEIGHT = 360 };

static const double rise = 0.56;

// Draw a shader that includes the chapter, with the chapter's starting camera turned by pan
// degrees. The caller frees the result.
static float *numbers_of(const char *text, double pan)
{
    struct renderer_inputs inputs = gpu_inputs(WIDTH, HEIGHT, 1);
    inputs.camera = gpu_camera(CHAPTER);
    inputs.camera.pan += (float)pan;
    assert_true(gpu_load_text(text));
    return gpu_numbers(&inputs);
}

#define RENAMED                                                                                    \
    "#include \"main.glsl\"\n#define rayColour chapterColour\n"                                    \
    "#include \"20_clouds_and_weather.frag\"\n#undef rayColour\n"

// Bilinear interpolation between four texels, with the values stored in the file.
static double texel_at(const struct image_bytes *image, double u, double v, int channel)
{
    double x = u * image->width - 0.5, y = (1.0 - v) * image->height - 0.5, i = floor(x);
    double j = floor(y), sum = 0.0;
    for (int k = 0; k < 4; k++) {
        int column = ((int)i + k % 2 + 4 * image->width) % image->width, row = (int)j + k / 2;
        double share = (k % 2 ? x - i : 1.0 - x + i) * (k / 2 ? y - j : 1.0 - y + j);
        sum += share * image->value[3 * (row * image->width + column) + channel] / 255.0;
    }
    return sum;
}

// Between 9 and 16 degrees above the horizon, a pixel is smaller than a texel, so level 0 is read.
// The driver's interpolation weights have 8 bits, so the tolerance is three steps of 1/256.
TEST(test_the_clouds_are_the_rotated_panorama)
{
    struct image_bytes image = {0};
    char path[4200], why[IMAGE_WHY];
    snprintf(path, sizeof path, "%s/shaders/textures/clouds_fair.png", gpu.root);
    assert_true(image_read_bytes(&image, path, 3, 1 << 22, why));
    float *values = numbers_of(
        RENAMED
        "vec3 rayColour(Ray ray) { Cloud c = cloudPanorama(cloudsFair, ray.direction, 0.38, "
        "2.0 * pixelSpread()); return vec3(c.cover, c.above, 0.5 + 0.5 * c.side); }\n",
        0.0);
    struct camera camera;
    camera = gpu_camera(CHAPTER);
    int count = 0;
    double worst = 0.0, spread = 0.0;
    for (int y = 0; y < HEIGHT; y += 3)
        for (int x = 0; x < WIDTH; x += 7) {
            struct d3 d = mirror_screen_ray(&camera, MIRROR_FOCAL_LENGTH,
                                            mirror_screen_x(x + 0.5, WIDTH, HEIGHT),
                                            mirror_screen_y(y + 0.5, HEIGHT) + rise)
                              .direction;
            double height = atan2(d.y, hypot(d.x, d.z));
            if (height < 0.157 || height > 0.28)
                continue;
            double u = atan2(d.z, d.x) / (2.0 * MIRROR_PI) + 0.38;
            for (int c = 0; c < 3; c++) {
                double right = texel_at(&image, u, sqrt(2.0 * height / MIRROR_PI), c);
                worst = fmax(worst, fabs((double)values[4 * (y * WIDTH + x) + c] - right));
                spread = fmax(spread, right);
            }
            count++;
        }
    free(values);
    free(image.value);
    print_message("# %d points of the panorama: largest error %.4f\n", count, worst);
    assert_true(count > 500 && spread > 0.9 && worst < 3.0 / 256.0);
}

// High in the sky, a texel is narrower than it is high. If the rim of a cloud were a sudden change
// from one texel to the next, it would look like a staircase, so the change is spread over a width
// that equals a texel's height.
TEST(rims_of_clouds_do_not_look_like_staircases)
{
    static const char *const names[] = {"clouds_fair", "clouds_storm"};
    for (int i = 0; i < 2; i++) {
        struct image_bytes image = {0};
        char path[4200], why[IMAGE_WHY];
        double worst = 0.0;
        snprintf(path, sizeof path, "%s/shaders/textures/%s.png", gpu.root, names[i]);
        assert_true(image_read_bytes(&image, path, 3, 1 << 22, why));
        for (int y = 0; y < image.height / 2; y++) {
            double v = 1.0 - (y + 1.5) / image.height; // the row below, whose texels are wider
            double high = MIRROR_PI * v / image.height;
            double wide = 2.0 * MIRROR_PI * cos(0.5 * MIRROR_PI * v * v) / image.width;
            for (int x = 0; x < 3 * image.width; x++) {
                const unsigned char *row = image.value + 3 * image.width * y;
                int change = abs(row[x] - row[(x + 3) % (3 * image.width)]);
                // Subtract 1, because the values in the file are rounded.
                worst = fmax(worst, (change - 1) / 255.0 * high / wide);
            }
        }
        free(image.value);
        print_message("# %s: the steepest rim changes by %.2f over a texel's height\n", names[i],
                      worst);
        assert_true(worst <= 1.0);
    }
}

// Find the largest difference between a column and the next, averaged over the rows of the sky.
//   across  receives the largest within two columns of the seam
//   beside  receives the largest of all others within 60 columns of the seam
static void steps_at(const float *values, int seam, double *across, double *beside)
{
    *across = *beside = 0.0;
    for (int x = seam - 60; x < seam + 60; x++) {
        double sum = 0.0;
        for (int y = 120; y < HEIGHT; y++)
            for (int c = 0; c < 3; c++)
                sum += fabs((double)values[4 * (y * WIDTH + x) + c] -
                            (double)values[4 * (y * WIDTH + x + 1) + c]) /
                       (3.0 * (HEIGHT - 120));
        double *largest = abs(x - seam) <= 2 ? across : beside;
        *largest = fmax(*largest, sum);
    }
}

// If the camera is turned three degrees past the end of the panorama, the panorama ends three
// degrees to the left of the middle, which is 360 tan(3 degrees) pixels.
TEST(test_no_seam_is_drawn)
{
    double across, beside;
    int seam = WIDTH / 2 - 1 - (int)(HEIGHT * tan(3.0 * MIRROR_PI / 180.0) + 0.5);
    float *values = numbers_of("#include \"20_clouds_and_weather.frag\"\n", 3.0);
    steps_at(values, seam, &across, &beside);
    free(values);
    print_message("# chapter's footprint: %.4f across the seam, %.4f beside it\n", across, beside);
    assert_true(across <= beside);
    values = numbers_of("#include \"experiments/20_seam.frag\"\n", 3.0);
    steps_at(values, seam, &across, &beside);
    free(values);
    print_message("# hardware's footprint: %.4f across the seam, %.4f beside it\n", across, beside);
    assert_true(across > 2.0 * beside);
}

TESTS(gpu_setup, gpu_teardown)
