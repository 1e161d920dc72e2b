// air_orders.h - sunlight that the air, its dust and the ground have scattered at least once before
// it arrives at a point of the air.
#ifndef AIR_ORDERS_H
#define AIR_ORDERS_H

#include "air_path.h"

// Add the light that has been scattered at least once before a point receives it: the mean over all
// directions, times a weight for each wavelength, as shares of the sunlight above the air. This
// light comes from a grid, which takes a few seconds to compute, on the first call and whenever
// ozone changes.
//   height  of the point, km
//   sun     sine of the sun's height there
//   ozone   amount of ozone; 1 is 300 Dobson units
void air_add_scattered(double height, double sun, double ozone, const double weight[AIR_WAVES],
                       double sum[AIR_WAVES]);

#endif
