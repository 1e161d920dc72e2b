// moonscape.h - the near side of a moon: how bright and how high it is, for moon.c and
// moon_height.c.
//
// The picture shows the disc as it is seen from far away, north up: u and v run across it, and its
// radius is MOONSCAPE_RADIUS. Outside of it the ground fades to a mean, so that the edges agree.
#ifndef MOONSCAPE_H
#define MOONSCAPE_H

#define MOONSCAPE_RADIUS 0.47
#define MOONSCAPE_BRIGHT 0.40  // the albedo that is stored as 1
#define MOONSCAPE_RANGE  0.012 // the heights that are stored, in radii of the moon, from 0 to 1
#define MOONSCAPE_SIZE   512   // pixels a side

// What share of the light the ground sends back, in [0, MOONSCAPE_BRIGHT].
double moonscape_albedo(double u, double v);

// How high it lies over the mean ground, in radii of the moon.
double moonscape_height(double u, double v);

#endif
