// colour.h - light and the numbers of sRGB; hue, saturation and value.
#ifndef COLOUR_H
#define COLOUR_H

// The light, 0 to 1, of a number of sRGB, and the inverse. IEC 61966-2-1: v / 12.92 up to 0.04045,
// ((v + 0.055) / 1.055)^2.4 above.
double colour_decode(double number);
double colour_encode(double light);

// The colour of a hue: v (1 + s (clamp(|6 fract(h + (0, 2, 1) / 3) - 3| - 1, 0, 1) - 1)), as
// chapter 04 derives it.
//   hsv  hue in turns, saturation, value, 0 to 1 each
//   rgb  receives it, 0 to 1 each
void colour_of_hue(const double hsv[3], double rgb[3]);

// The inverse. A grey keeps the hue that hsv has, and black keeps its saturation as well.
void colour_hue_of(const double rgb[3], double hsv[3]);

#endif
