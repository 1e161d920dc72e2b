// bounces.h - the frames of chapter 24: the light that its paths bring, and how far it is from the
// truth.
#ifndef TESTS_BOUNCES_H
#define TESTS_BOUNCES_H

#define BOUNCES_CHAPTER "chapters/24_bounces.frag"

// A shader that includes the chapter's, its parameters as "lights=1 seed=3", the size of its
// picture, and how far its eye is to the right of the chapter's, scene units.
struct bounces_run {
    const char *shader, *settings;
    int width, height;
    double right;
};

// What frame frames - 1 keeps, and the picture after this frame: four numbers for each pixel, which
// the caller frees.
float *bounces_kept(const struct bounces_run *run, int frames);
float *bounces_shown(const struct bounces_run *run, int frames);

// The mean of a channel, 0 to 2, or of all three (channel 3), over the pixels.
double bounces_mean(const float *light, const struct bounces_run *run, int channel);

// The root mean square difference of two pictures, over pixels and channels; and the same of the
// means of blocks of 8x8 pixels.
double bounces_apart(const float *a, const float *b, const struct bounces_run *run);
double bounces_blocks_apart(const float *a, const float *b, const struct bounces_run *run);

// The error of the mean of so many frames, from two means with independent random numbers.
double bounces_noise(const struct bounces_run *run, int frames);

// The slope of the least-squares line through the logarithms of points (x, y).
double bounces_slope(int count, const double *x, const double *y);

int bounces_print(void);
int bounces_print_quiet(void);

#endif
