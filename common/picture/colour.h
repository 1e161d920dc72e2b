// colour.h - conversions between light and sRGB values, and between RGB and hue, saturation and
// value.
#ifndef COLOUR_H
#define COLOUR_H

// Convert an sRGB value v to the light that it encodes, and light to its sRGB value; all are from 0
// to 1. According to IEC 61966-2-1, the light is v / 12.92 for v up to 0.04045, and
// ((v + 0.055) / 1.055)^2.4 above that.
double colour_decode(double number);
double colour_encode(double light);

// Convert hue h, saturation s and value v to a colour, as chapter 04 derives it:
// v (1 + s (clamp(|6 fract(h + (0, 2, 1) / 3) - 3| - 1, 0, 1) - 1)).
//   hsv  h in turns, s and v; 0 to 1 each
//   rgb  receives red, green and blue; 0 to 1 each
void colour_of_hue(const double hsv[3], double rgb[3]);

// The inverse of colour_of_hue. For a grey colour, hsv keeps its previous hue; for black, it also
// keeps its previous saturation.
void colour_hue_of(const double rgb[3], double hsv[3]);

#endif
