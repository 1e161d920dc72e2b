// judge.h - judges a reader's answer to an exercise, with the numbers and words that `make check`
// and the web pages share. Returned texts are valid until the next call.
#ifndef TESTS_JUDGE_H
#define TESTS_JUDGE_H

// Compare the answer's picture with the solution's.
//   with          the picture's options, as the exercise spells them; "" if there are none
//   width, height the size of both pictures
//   right, mine   the two pictures: 3 bytes per pixel, row 0 at the top
//   shown         receives the picture of image_difference_picture; may be NULL
// Returns what is wrong with the answer's picture and where, or "" if the two pictures are the
// same.
const char *judge_picture(const char *with, int width, int height, const unsigned char *right,
                          const unsigned char *mine, unsigned char *shown);

// The share of pixels that the last judge_picture found to differ by more than 2 of 255, in [0, 1].
double judge_share(void);

// The centre of the 8x8 block in which the last judge_picture found the largest difference, for
// example "397,87", in pixels as --probe counts them.
const char *judge_pixel(void);

// The difference that the last judge_picture found between the two pictures, in the words of
// `make compare`.
const char *judge_words(void);

// Compare the rays of some pixels.
//   with         as for judge_picture
//   pixels       pixels, "X,Y X,Y ..."
//   right, mine  the output of --probe for these pixels, in the same order
// Returns what is wrong with the answer's rays, or "" if they end like the solution's. One ray may
// end elsewhere, because it may lie on an edge. If the solution records no rays, none are compared.
const char *judge_rays(const char *with, const char *pixels, const char *right, const char *mine);

// The march of a ray in words, "t 3.2, hit; steps: ...", made from the output of --probe.
const char *judge_ray(const char *probe);

// The sentence for a right answer.
//   pictures  the number of pictures compared
//   share     the largest judge_share of these pictures
const char *judge_right(int pictures, double share);

#endif
