// paths.h - the light of chapters 13 and 14, compared with paths of light in their own scenes.
#ifndef TESTS_PATHS_H
#define TESTS_PATHS_H

// The light of an estimate and of paths, over the pixels of the chapter's picture, 160x90, that do
// not show the sky. Red, green and blue.
struct paths_light {
    double paths[3];
    double estimate[3];
    double apart; // mean absolute difference, over pixels and channels
};

// Chapter 13's ambient light, and what the sky and the other surfaces send.
void paths_terrace(struct paths_light *light);

// Compare the light that comes straight from the sun in chapter 13: one ray to a random point of
// the sun for each sample, and the chapter's share.
//   method  the value of the chapter's parameter shadow
void paths_sun(int method, struct paths_light *light);

// The openness from which the series of chapter 14 is computed: that of the taps, or that of 256
// rays.
enum paths_openness { PATHS_TAPS, PATHS_TRUE_OPENNESS };

// The light that arrives in chapter 14, relative to an open floor, with all bounces; and the same
// only where less than a twentieth of the sky is visible.
void paths_court(enum paths_openness openness, struct paths_light *all, struct paths_light *dark);

int paths_print(void);

#endif
