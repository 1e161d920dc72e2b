#include "picture/colour.h"

#include <math.h>

double colour_decode(double number)
{
    return number <= 0.04045 ? number / 12.92 : pow((number + 0.055) / 1.055, 2.4);
}

double colour_encode(double light)
{
    return light <= 0.0031308 ? 12.92 * light : 1.055 * pow(light, 1.0 / 2.4) - 0.055;
}

void colour_of_hue(const double hsv[3], double rgb[3])
{
    static const double third[3] = {0.0, 2.0, 1.0};
    for (int k = 0; k < 3; k++) {
        double turn = hsv[0] + third[k] / 3.0;
        double share = fabs(6.0 * (turn - floor(turn)) - 3.0) - 1.0;
        rgb[k] = hsv[2] * (1.0 + hsv[1] * (fmin(fmax(share, 0.0), 1.0) - 1.0));
    }
}

void colour_hue_of(const double rgb[3], double hsv[3])
{
    double most = fmax(rgb[0], fmax(rgb[1], rgb[2])), least = fmin(rgb[0], fmin(rgb[1], rgb[2]));
    double span = most - least, sixths;
    hsv[2] = most;
    if (most > 0.0)
        hsv[1] = span / most;
    if (span <= 0.0)
        return;
    if (most == rgb[0])
        sixths = (rgb[1] - rgb[2]) / span;
    else if (most == rgb[1])
        sixths = 2.0 + (rgb[2] - rgb[0]) / span;
    else
        sixths = 4.0 + (rgb[0] - rgb[1]) / span;
    hsv[0] = sixths / 6.0 - floor(sixths / 6.0);
}
