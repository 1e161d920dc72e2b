// air_orders.h - sunlight that the air, its dust and the ground have scattered more than once.
#ifndef AIR_ORDERS_H
#define AIR_ORDERS_H

#include "air.h"

// Add the light that a point receives after it has been scattered at least once: the mean over all
// directions, times a weight for each wavelength, as shares of the sunlight above the air. It comes
// from a grid that the first call for each ozone computes in a few seconds.
//   height  of the point, km
//   sun     sine of the sun's height there
//   ozone   amount of ozone; 1 is 300 Dobson units
void air_add_scattered(double height, double sun, double ozone, const double weight[AIR_WAVES],
                       double sum[AIR_WAVES]);

#endif
