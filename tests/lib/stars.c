#include "lib/stars.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

static uint32_t stirred(uint32_t v)
{
    v = (v ^ (v >> 16)) * 2146121005U;
    v = (v ^ (v >> 15)) * 2221713035U;
    return v ^ (v >> 16);
}

static int by_height(const void *a, const void *b)
{
    double x = ((const struct star *)a)->direction.z, y = ((const struct star *)b)->direction.z;
    return (x > y) - (x < y);
}

static struct star star_of(int half, int ring, int column)
{
    uint32_t bits = stirred((uint32_t)((half * STAR_RINGS + ring) * 512 + column) + 1U);
    uint32_t more = stirred(bits);
    int count = 8 * ring + 4;
    double ahead = (double)ring * ring + (bits & 65535U) / 65536.0 * (2.0 * ring + 1.0);
    double z = 1.0 - ahead / ((double)STAR_RINGS * STAR_RINGS), flat = sqrt(1.0 - z * z);
    double turn = 2.0 * MIRROR_PI * (column + (bits >> 16) / 65536.0) / count;
    double share = ((more >> 8) + 1.0) / 16777216.0;
    return (struct star){d3(flat * cos(turn), flat * sin(turn), half == 0 ? z : -z),
                         5.75e-13 * pow(share, -0.4 / 0.51), share};
}

const struct star *stars_all(void)
{
    static struct star star[STAR_COUNT];
    static bool made = false;
    if (made)
        return star;
    int n = 0;
    for (int half = 0; half < 2; half++)
        for (int ring = 0; ring < STAR_RINGS; ring++)
            for (int column = 0; column < 8 * ring + 4; column++)
                star[n++] = star_of(half, ring, column);
    qsort(star, STAR_COUNT, sizeof *star, by_height);
    made = true;
    return star;
}

double stars_light(struct d3 direction, double width)
{
    const struct star *star = stars_all();
    double radius = fmin(1.761 * width, 0.3536 / STAR_RINGS), sum = 0.0;
    int low = 0, high = STAR_COUNT; // search for the first star with z > direction.z - radius
    while (low < high) {
        int middle = (low + high) / 2;
        if (star[middle].direction.z > direction.z - radius)
            high = middle;
        else
            low = middle + 1;
    }
    for (; low < STAR_COUNT && star[low].direction.z < direction.z + radius; low++) {
        struct d3 apart = d3_sub(star[low].direction, direction);
        double near = 1.0 - d3_dot(apart, apart) / (radius * radius);
        sum += near > 0.0 ? near * near * near * star[low].light : 0.0;
    }
    return 4.0 / (MIRROR_PI * radius * radius) * sum;
}
