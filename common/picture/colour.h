// colour.h - a light as the screen's number, and a colour by its hue.
#ifndef COLOUR_H
#define COLOUR_H

// The share of light, 0 to 1, that a number of sRGB stands for, and the other way. IEC 61966-2-1:
// v / 12.92 up to 0.04045, ((v + 0.055) / 1.055)^2.4 above.
double colour_decode(double number);
double colour_encode(double light);

// The colour of a hue: v (1 + s (clamp(|6 fract(h + (0, 2, 1) / 3) - 3| - 1, 0, 1) - 1)), as
// chapter 04 derives it.
//   hsv  hue in turns, saturation, value, 0 to 1 each
//   rgb  receives it, 0 to 1 each
void colour_of_hue(const double hsv[3], double rgb[3]);

// The other way. Of a grey the hue, of black the saturation too, stay as hsv has them.
void colour_hue_of(const double rgb[3], double hsv[3]);

#endif
