// judge.h - what is said of a reader's answer to an exercise: the numbers and words that
// `make check` and a page have in common. Texts that are returned are valid until the next call.
#ifndef TESTS_JUDGE_H
#define TESTS_JUDGE_H

// Compare the answer's picture with the solution's.
//   with          the picture's options, as the page spells them; "" for none
//   width, height of both
//   right, mine   3 bytes a pixel, row 0 on top
//   shown         receives what image_difference_picture draws; NULL: not asked for
// Returns what is wrong with it and where, or "" where the two are the same picture.
const char *judge_picture(const char *with, int width, int height, const unsigned char *right,
                          const unsigned char *mine, unsigned char *shown);

// The share of pixels that the last judge_picture found to differ by more than 2 of 255, in [0, 1].
double judge_share(void);

// Where the last judge_picture found most of the difference: "397,87", pixels as --probe counts
// them.
const char *judge_place(void);

// How far the last judge_picture found the two apart, or that they are the same: in the words of
// `make compare`.
const char *judge_words(void);

// Compare the rays of some pixels.
//   with         as above
//   places       "X,Y X,Y ..."
//   right, mine  what --probe prints for these places, in their order
// Returns what is wrong with the answer's rays, or "" where they end as the solution's do: one of
// them may end elsewhere, for it may lie on an edge. Where the solution records none, none are
// compared.
const char *judge_rays(const char *with, const char *places, const char *right, const char *mine);

// The march of a ray in words, "t 3.2, hit; steps: ...", from what --probe prints.
const char *judge_ray(const char *probe);

// The sentence for an answer that is right.
//   pictures  how many were compared
//   share     the largest of their judge_share
const char *judge_right(int pictures, double share);

#endif
