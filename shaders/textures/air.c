#include "air.h"

#include <math.h>
#include <stdbool.h>

#include "paint.h"

// Kilometres. The density of the air falls by a factor of e with every LOW_SCALE of height up to
// BEND, and with every HIGH_SCALE above it, where it is colder: within 15 % of the standard
// atmosphere up to 55 km. With a single scale of 8.4 there would be 3 times too much air at 50 km,
// from where twilight comes. Dust falls off eight times as fast, by a factor of e with every 1.2
// km; ozone is densest at 25 km, and there is none 15 km above and below that. The air ends at TOP;
// a share of 3e-8 of it lies above. Sources: 'U.S. standard atmosphere' (1976); E. Bruneton, F.
// Neyret, 'Precomputed atmospheric scattering', Computer Graphics Forum 27 (2008), for the height
// of the dust and, in Bruneton's implementation of 2017, the profile of ozone.
static const double EARTH = 6371.0, TOP = 120.0;
static const double LOW_SCALE = 9.6, HIGH_SCALE = 6.7, BEND = 9.0;

// The thickness of the air overhead if all of it were as dense as at sea level, and of the dust.
static const double AIR_COLUMN = 8.464, DUST_COLUMN = 1.2;

// Angular radius of the sun: 0.267 degrees.
static const double SUN_RADIUS = 0.00466;

enum { VIEW_STEPS = 120, SUN_STEPS = 80 };

// Sources: sun: ASTM G-173 (2003), above the air; ozone: V. Gorshelev and others, 'High spectral
// resolution ozone absorption cross-sections', Atmospheric Measurement Techniques 7 (2014), at 233
// K; both as the means over 20 nm around the wavelength. The eye: CIE 1931.
const struct air_wave air_waves[AIR_WAVES] = {
    {1.437, 0.011, {0.0143, 0.0004, 0.0679}}, {1.710, 0.041, {0.1344, 0.0040, 0.6456}},
    {1.762, 0.121, {0.3483, 0.0230, 1.7471}}, {2.028, 0.299, {0.2908, 0.0600, 1.6692}},
    {1.978, 0.634, {0.0956, 0.1390, 0.8130}}, {1.937, 1.191, {0.0049, 0.3230, 0.2720}},
    {1.849, 1.871, {0.0633, 0.7100, 0.0783}}, {1.872, 2.923, {0.2904, 0.9540, 0.0203}},
    {1.842, 3.883, {0.5945, 0.9950, 0.0039}}, {1.825, 4.535, {0.9163, 0.8700, 0.0017}},
    {1.767, 4.860, {1.0622, 0.6310, 0.0008}}, {1.689, 4.023, {0.8545, 0.3810, 0.0002}},
    {1.626, 2.939, {0.4479, 0.1750, 0.0000}}, {1.539, 2.045, {0.1649, 0.0610, 0.0000}},
    {1.493, 1.341, {0.0468, 0.0170, 0.0000}}, {1.429, 0.844, {0.0114, 0.0041, 0.0000}}};

// Cross sections, 1e-25 m^2, times this are the depth of 300 Dobson units of ozone, of 2.687e20
// molecules per square metre each, overhead.
static const double OZONE = 300.0 * 2.687e20 * 1e-25;

// Depth of the dust overhead at 550 nm, and the share of the removed light that it scatters. The
// depth is proportional to 1 / wavelength. A clear day: T. Angstrom's exponent 1.
static const double DUST = 0.03, DUST_KEPT = 0.92;

// The mean cosine of the angle by which dust scatters.
static const double FORWARD = 0.76;

// 4,000 cd/m^2; 683 lumens per watt; the step of the wavelengths.
static const double UNIT = 683.0 * 20.0 / 4000.0, PI = 3.14159265358979324;

// Linear sRGB of X, Y, Z, IEC 61966-2-1.
static const double SCREEN[3][3] = {
    {3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}};

static double wave_length(int wave) // micrometres
{
    return 0.40 + 0.02 * wave;
}

// Depth of the air overhead: J. E. Hansen, L. D. Travis, 'Light scattering in planetary
// atmospheres', Space Science Reviews 16 (1974), as in chapter 09.
static double air_depth(int wave)
{
    double x = 1.0 / (wave_length(wave) * wave_length(wave));
    return 0.008569 * x * x * (1.0 + 0.0113 * x + 0.00013 * x * x);
}

static double dust_depth(int wave)
{
    return DUST * 0.55 / wave_length(wave);
}

// Add to a colour the appearance of light of a wavelength on a screen.
static void add_wave(int wave, double light, double colour[3])
{
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++)
            colour[c] += UNIT * SCREEN[c][k] * air_waves[wave].eye[k] * air_waves[wave].sun * light;
}

// ---- Amounts along a path, as shares of the amounts overhead ----

struct amount {
    double air, dust, ozone;
};

// e^-x for x >= 0: a table of 32 values for each factor of 1/e, and five terms of the series for
// the rest. The relative error is at most 3e-10; 0 from 64 on.
static double fade(double x)
{
    enum { EACH = 32, COUNT = 64 * EACH };
    static double known[COUNT];
    if (known[0] == 0.0)
        for (int i = 0; i < COUNT; i++)
            known[i] = paint_exp(-(double)i / EACH);
    double place = EACH * (x > 0.0 ? x : 0.0);
    if (place >= COUNT)
        return 0.0;
    double rest = (place - (int)place) * (1.0 / EACH);
    double series = 1.0 - rest * (1.0 / 3.0) * (1.0 - rest * 0.25);
    return known[(int)place] * (1.0 - rest * (1.0 - rest * 0.5 * series));
}

// In one kilometre at a height, upwards.
static struct amount density(double height)
{
    double low = height < BEND ? height : BEND;
    double air = fade(low * (1.0 / LOW_SCALE) + (height - low) * (1.0 / HIGH_SCALE));
    double square = air * air, fourth = square * square;
    double from = height > 25.0 ? height - 25.0 : 25.0 - height;
    return (struct amount){.air = air * (1.0 / AIR_COLUMN),
                           .dust = fourth * fourth * (1.0 / DUST_COLUMN),
                           .ozone = from < 15.0 ? (15.0 - from) * (1.0 / 225.0) : 0.0};
}

// Height above the sea at a distance along a ray that begins at radius with this sine of its
// height. The difference of two large roots, computed without its loss of digits.
static double height_at(double radius, double sine, double distance)
{
    double more = distance * (2.0 * radius * sine + distance);
    return radius - EARTH + more / (sqrt(radius * radius + more) + radius);
}

// The distance to the top of the air.
static double way_out(double radius, double sine)
{
    double b = radius * sine, c = (EARTH + TOP) * (EARTH + TOP) - radius * radius;
    return c > 0.0 ? c / (sqrt(b * b + c) + b) : 0.0;
}

// Simpson's rule for a ray that does not go down, in the cube root of the distance: the steps are
// short near the ray's beginning, where the air is thick.
static struct amount amount_up(double radius, double sine)
{
    double length = way_out(radius, sine);
    struct amount sum = {0.0, 0.0, 0.0};
    for (int i = 1; i <= SUN_STEPS; i++) { // the first point has no weight
        double q = (double)i / SUN_STEPS, weight = i == SUN_STEPS ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
        weight *= length * q * q / SUN_STEPS;
        struct amount here = density(height_at(radius, sine, length * q * q * q));
        sum.air += weight * here.air;
        sum.dust += weight * here.dust;
        sum.ozone += weight * here.ozone;
    }
    return sum;
}

// The same for any ray that does not meet the Earth. One that goes down rises again beyond its
// lowest point: its amount is twice the amount beyond that point, minus the amount behind the eye.
static struct amount amount_along(double radius, double sine)
{
    if (sine >= 0.0)
        return amount_up(radius, sine);
    double lowest = radius * sqrt(1.0 - sine * sine);
    struct amount half = amount_up(lowest > EARTH ? lowest : EARTH, 0.0);
    struct amount behind = amount_up(radius, -sine);
    return (struct amount){.air = 2.0 * half.air - behind.air,
                           .dust = 2.0 * half.dust - behind.dust,
                           .ozone = 2.0 * half.ozone - behind.ozone};
}

static double share_through(int wave, struct amount amount, double ozone)
{
    return fade(air_depth(wave) * amount.air + dust_depth(wave) * amount.dust +
                ozone * OZONE * air_waves[wave].ozone * amount.ozone);
}

// ---- Light ----

// The sun's light at a point, as shares of the light above the air. The sun is a disc, and near the
// edge of the Earth's shadow only a part of it is visible. The visible part is cut into horizontal
// strips, with Gauss's rule of three points. A strip at x, from -1 to 1, has the share 3 (1 - x^2)
// / 4 of the light, as for a disc as dark at its rim as a ball lit from the eye.
//   sine  of the height of the sun's middle
//   way   the amounts between the point and the eye
static void add_sunlight(double radius, double sine, struct amount way, double ozone,
                         double share[AIR_WAVES])
{
    static const double place[3] = {0.11270166537925831, 0.5, 0.88729833462074169};
    static const double weight[3] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    double cosine = sqrt(1.0 - sine * sine), level = EARTH / radius;
    double dip = sqrt(1.0 - level * level), over = sine * level + cosine * dip; // the horizon
    double lowest = -over / SUN_RADIUS, from = lowest > -1.0 ? lowest : -1.0;
    int strips = from >= 1.0 ? 0 : over > 4.0 * SUN_RADIUS ? 1 : 3;
    for (int i = 0; i < strips; i++) {
        double x = strips == 1 ? 0.0 : from + (1.0 - from) * place[i];
        double part = strips == 1 ? 1.0 : 0.75 * (1.0 - x * x) * (1.0 - from) * weight[i];
        double to = sine + x * SUN_RADIUS * cosine;
        struct amount all = amount_along(radius, to < 1.0 ? to : 1.0);
        all.air += way.air;
        all.dust += way.dust;
        all.ozone += way.ozone;
        for (int w = 0; w < AIR_WAVES; w++)
            share[w] += part * share_through(w, all, ozone);
    }
}

// ---- Light that is scattered more than once ----

// The light that a point of the air receives depends only on its height and on the sun's height
// there: rotate the Earth and all its air about the axis to the sun, and nothing changes. So a grid
// over these two contains all the light, for each wavelength.
enum { HEIGHTS = 32, SUNS = 96, ABOVE = 10, BELOW = 6, AROUND = 8, PATH_STEPS = 24, ORDERS = 4 };

// The share of the light on the ground that the ground reflects.
static const double ALBEDO = 0.15;

typedef double grid[HEIGHTS][SUNS][AIR_WAVES];

// At a point, as shares of the sunlight above the air: the sun's own light, and the mean over all
// directions of the light that air and ground have scattered.
static grid direct, scattered;

static double grid_height(int row)
{
    double q = (double)row / (HEIGHTS - 1);
    return TOP * q * q;
}

// The sine of the sun's height at a point is measured from that of the horizon seen from there,
// where the light changes fastest.
static const double GRID_WIDTH = 0.08, GRID_LOWEST = -0.42, GRID_SPAN = 1.25;

static double horizon(double height)
{
    double level = EARTH / (EARTH + height);
    return -sqrt(1.0 - level * level);
}

static double grid_sun(int row, int column)
{
    double lowest = air_drawn_out(GRID_LOWEST / GRID_SPAN, GRID_WIDTH);
    double x = lowest + (1.0 - lowest) * column / (SUNS - 1);
    double sine = GRID_SPAN * air_drawn_back(x, GRID_WIDTH) + horizon(grid_height(row));
    return sine < -1.0 ? -1.0 : (sine > 1.0 ? 1.0 : sine);
}

// A point between four points of the grid.
struct corner {
    int row, column;
    double up, right; // shares of the next row and of the next column
};

static struct corner corner_at(double height, double dip, double sun)
{
    double lowest = air_drawn_out(GRID_LOWEST / GRID_SPAN, GRID_WIDTH);
    double y = (HEIGHTS - 1) * sqrt(height > 0.0 ? height / TOP : 0.0);
    double x = (air_drawn_out((sun - dip) / GRID_SPAN, GRID_WIDTH) - lowest) / (1.0 - lowest);
    x = (SUNS - 1) * (x > 0.0 ? (x < 1.0 ? x : 1.0) : 0.0);
    int row = y < HEIGHTS - 2 ? (int)y : HEIGHTS - 2, column = x < SUNS - 2 ? (int)x : SUNS - 2;
    return (struct corner){row, column, y - row, x - column};
}

// Add the grid's light at a point, times a weight for each wavelength.
static void add_between(grid light, struct corner at, const double weight[AIR_WAVES],
                        double sum[AIR_WAVES])
{
    const double *a = light[at.row][at.column], *b = light[at.row][at.column + 1];
    const double *c = light[at.row + 1][at.column], *d = light[at.row + 1][at.column + 1];
    double p = (1.0 - at.up) * (1.0 - at.right), q = (1.0 - at.up) * at.right;
    double r = at.up * (1.0 - at.right), s = at.up * at.right;
    for (int w = 0; w < AIR_WAVES; w++)
        sum[w] += weight[w] * (p * a[w] + q * b[w] + r * c[w] + s * d[w]);
}

// A ray from a point of the grid, cut into steps that are shortest where the ray is lowest. It is
// the same for all heights of the sun.
struct path {
    double distance[2 * PATH_STEPS], height[2 * PATH_STEPS], dip[2 * PATH_STEPS];
    double air[2 * PATH_STEPS][AIR_WAVES];  // the share that a step scatters and sends to the point
    double dust[2 * PATH_STEPS][AIR_WAVES]; // of which by dust
    double ground[AIR_WAVES];               // the share that arrives from the end of the path
    double length;
    int steps;
    bool lands; // it ends on the ground
};

static void path_along(double radius, double sine, double ozone, struct path *path)
{
    double lowest = radius * sqrt(1.0 - sine * sine), down = -radius * sine;
    path->lands = sine < 0.0 && lowest < EARTH;
    double drop = radius * radius - EARTH * EARTH;
    path->length = path->lands ? drop / (down + sqrt(down * down - drop)) : way_out(radius, sine);
    path->steps = 0;
    double turn = path->lands ? path->length : (down > 0.0 ? down : 0.0); // the lowest place
    struct amount passed = {0.0, 0.0, 0.0};
    for (int i = 0; i < 2 * PATH_STEPS; i++) {
        double part = i < PATH_STEPS ? turn : path->length - turn;
        if (part <= 0.0)
            continue;
        int k = path->steps++;
        double from = i < PATH_STEPS ? 1.0 - (double)i / PATH_STEPS : (double)i / PATH_STEPS - 1.0;
        double to = i < PATH_STEPS ? from - 1.0 / PATH_STEPS : from + 1.0 / PATH_STEPS;
        double middle = 0.5 * (from + to), step = part * (from + to) / PATH_STEPS;
        double t = i < PATH_STEPS ? turn * (1.0 - middle * middle) : turn + part * middle * middle;
        path->distance[k] = t;
        path->height[k] = height_at(radius, sine, t);
        path->dip[k] = horizon(path->height[k]);
        struct amount here = density(path->height[k]), half = passed;
        half.air += 0.5 * step * here.air;
        half.dust += 0.5 * step * here.dust;
        half.ozone += 0.5 * step * here.ozone;
        passed.air += step * here.air;
        passed.dust += step * here.dust;
        passed.ozone += step * here.ozone;
        for (int w = 0; w < AIR_WAVES; w++) {
            double share = step * share_through(w, half, ozone);
            path->air[k][w] = share * here.air * air_depth(w);
            path->dust[k][w] = share * here.dust * dust_depth(w) * DUST_KEPT;
        }
    }
    for (int w = 0; w < AIR_WAVES; w++)
        path->ground[w] = path->lands ? share_through(w, passed, ozone) : 0.0;
}

// The nodes of Gauss's rule in [0, 1], and their weights.
static const double ABOVE_NODE[ABOVE] = {
    0.013046735741414128, 0.067468316655507732, 0.16029521585048778, 0.28330230293537639,
    0.42556283050918442,  0.57443716949081558,  0.71669769706462361, 0.83970478414951222,
    0.93253168334449232,  0.98695326425858587};
static const double ABOVE_WEIGHT[ABOVE] = {
    0.033335672154344069, 0.074725674575290296, 0.10954318125799102, 0.13463335965499817,
    0.14776211235737644,  0.14776211235737644,  0.13463335965499817, 0.10954318125799102,
    0.074725674575290296, 0.033335672154344069};
static const double BELOW_NODE[BELOW] = {0.033765242898423986, 0.16939530676686774,
                                         0.38069040695840155,  0.61930959304159845,
                                         0.83060469323313226,  0.96623475710157601};
static const double BELOW_WEIGHT[BELOW] = {0.085662246189585172, 0.18038078652406930,
                                           0.23395696728634552,  0.23395696728634552,
                                           0.18038078652406930,  0.085662246189585172};

// The cosines of (k + 1/2) 180 / AROUND degrees.
static const double AROUND_COSINE[AROUND] = {
    0.98078528040323044,  0.83146961230254524,  0.55557023301960222,  0.19509032201612828,
    -0.19509032201612828, -0.55557023301960222, -0.83146961230254524, -0.98078528040323044};

// One order of scattering: from the light at all points, the light that they send to each point.
//   from    the sunlight, or the mean light of the order before
//   first   true for sunlight, which comes from one direction; scattered light is assumed to come
//           equally from all sides
//   falls   the light of the previous order on horizontal ground, for the columns of row 0
//   mean    the mean over all directions; falls_next is the light on the ground
static void next_order(grid from, bool first, double falls[SUNS][AIR_WAVES], double ozone,
                       grid mean, double falls_next[SUNS][AIR_WAVES])
{
    static struct path path;
    for (int row = 0; row < HEIGHTS; row++) {
        double height = grid_height(row), radius = EARTH + height, dip = horizon(height);
        for (int column = 0; column < SUNS; column++)
            for (int w = 0; w < AIR_WAVES; w++) {
                mean[row][column][w] = 0.0;
                falls_next[column][w] = row > 0 ? falls_next[column][w] : 0.0;
            }
        for (int i = 0; i < ABOVE + BELOW; i++) {
            bool up = i < ABOVE;
            double q = up ? ABOVE_NODE[i] : BELOW_NODE[i - ABOVE];
            double part = up ? 1.0 - dip : 1.0 + dip, sine = dip + (up ? part : -part) * q * q;
            double share = part * q * (up ? ABOVE_WEIGHT[i] : BELOW_WEIGHT[i - ABOVE]);
            path_along(radius, sine, ozone, &path);
            for (int column = 0; column < SUNS; column++)
                for (int k = 0; k < AROUND; k++) {
                    double sun = grid_sun(row, column), sum[AIR_WAVES] = {0.0};
                    double c = sine * sun +
                               sqrt((1.0 - sine * sine) * (1.0 - sun * sun)) * AROUND_COSINE[k];
                    double phase[2] = {1.0, 1.0}; // times 4 pi
                    if (first) {
                        double x = 1.0 / (1.0 + FORWARD * FORWARD - 2.0 * FORWARD * c);
                        phase[0] = 0.75 * (1.0 + c * c);
                        phase[1] = (1.0 - FORWARD * FORWARD) * x * sqrt(x);
                    }
                    for (int j = 0; j < path.steps; j++) {
                        double weight[AIR_WAVES], t = path.distance[j];
                        double there = (radius * sun + t * c) / (EARTH + path.height[j]);
                        for (int w = 0; w < AIR_WAVES; w++)
                            weight[w] = phase[0] * path.air[j][w] + phase[1] * path.dust[j][w];
                        add_between(from, corner_at(path.height[j], path.dip[j], there), weight,
                                    sum);
                    }
                    // Sum is 4 pi times the light from this direction or, if the previous order is
                    // diffuse light, that light itself.
                    double arrives = first ? 1.0 / (4.0 * PI) : 1.0;
                    if (path.lands) {
                        double there = (radius * sun + path.length * c) / EARTH;
                        struct corner at = corner_at(0.0, 0.0, there);
                        for (int w = 0; w < AIR_WAVES; w++)
                            sum[w] += path.ground[w] * ALBEDO / (PI * arrives) *
                                      ((1.0 - at.right) * falls[at.column][w] +
                                       at.right * falls[at.column + 1][w]);
                    }
                    for (int w = 0; w < AIR_WAVES; w++) {
                        mean[row][column][w] += arrives * share / AROUND * sum[w];
                        if (row == 0 && up) // an integral over solid angle: 4 pi times the mean
                            falls_next[column][w] +=
                                arrives * 4.0 * PI * share / AROUND * sine * sum[w];
                    }
                }
        }
    }
}

// Fill in both grids.
static void scatter(double ozone)
{
    static double known = -1.0;
    static grid order, next;
    static double falls[SUNS][AIR_WAVES], falls_next[SUNS][AIR_WAVES];
    if (known == ozone)
        return;
    known = ozone;
    struct amount none = {0.0, 0.0, 0.0};
    for (int row = 0; row < HEIGHTS; row++)
        for (int column = 0; column < SUNS; column++) {
            double sun = grid_sun(row, column);
            for (int w = 0; w < AIR_WAVES; w++)
                direct[row][column][w] = scattered[row][column][w] = 0.0;
            add_sunlight(EARTH + grid_height(row), sun, none, ozone, direct[row][column]);
            for (int w = 0; w < AIR_WAVES && row == 0; w++)
                falls[column][w] = (sun > 0.0 ? sun : 0.0) * direct[0][column][w];
        }
    for (int n = 1; n <= ORDERS; n++) {
        next_order(n == 1 ? direct : order, n == 1, falls, ozone, next, falls_next);
        for (int row = 0; row < HEIGHTS; row++)
            for (int column = 0; column < SUNS; column++)
                for (int w = 0; w < AIR_WAVES; w++) {
                    scattered[row][column][w] += next[row][column][w];
                    order[row][column][w] = next[row][column][w];
                    falls[column][w] = falls_next[column][w];
                }
    }
}

void air_shares(double sun, double view, double azimuth, double ozone, struct air_shares *shares)
{
    double level =
        sqrt((1.0 - sun * sun) * (1.0 - view * view)) * azimuth; // of the cosine of their angle
    double length = way_out(EARTH, view);
    struct amount passed = {0.0, 0.0, 0.0};
    *shares = (struct air_shares){{0.0}, {0.0}, {0.0}};
    scatter(ozone);
    for (int i = 0; i < VIEW_STEPS; i++) { // the middles of steps that grow
        double from = (double)i / VIEW_STEPS, to = (i + 1.0) / VIEW_STEPS, q = 0.5 * (from + to);
        double distance = length * q * q, step = length * (to * to - from * from);
        double height = height_at(EARTH, view, distance), radius = EARTH + height;
        struct amount here = density(height), way = passed;
        // The sun is higher by the angle through which the ray has gone around the Earth.
        double sine = (EARTH * sun + distance * (view * sun + level)) / radius;
        double share[AIR_WAVES] = {0.0}, again[AIR_WAVES];
        way.air += 0.5 * step * here.air;
        way.dust += 0.5 * step * here.dust;
        way.ozone += 0.5 * step * here.ozone;
        add_sunlight(radius, sine, way, ozone, share);
        for (int w = 0; w < AIR_WAVES; w++) {
            shares->air[w] += step * share[w] * here.air * air_depth(w);
            shares->dust[w] += step * share[w] * here.dust * dust_depth(w) * DUST_KEPT;
            again[w] = step * share_through(w, way, ozone) *
                       (here.air * air_depth(w) + here.dust * dust_depth(w) * DUST_KEPT);
        }
        add_between(scattered, corner_at(height, horizon(height), sine), again, shares->more);
        passed.air += step * here.air;
        passed.dust += step * here.dust;
        passed.ozone += step * here.ozone;
    }
}

struct air_light air_scattered(double sun, double view, double azimuth, double ozone)
{
    struct air_light light = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    struct air_shares shares;
    air_shares(sun, view, azimuth, ozone, &shares);
    for (int w = 0; w < AIR_WAVES; w++) {
        add_wave(w, shares.air[w], light.air);
        add_wave(w, shares.dust[w], light.dust);
        add_wave(w, shares.more[w], light.more);
    }
    return light;
}

void air_sunlight(double sun, double colour[3])
{
    colour[0] = colour[1] = colour[2] = 0.0;
    if (sun >= 0.0)
        for (int w = 0; w < AIR_WAVES; w++)
            add_wave(w, share_through(w, amount_up(EARTH, sun), 1.0) / PI, colour);
}

// ---- The tables ----

double air_drawn_out(double sine, double k)
{
    double size = sine < 0.0 ? -sine : sine;
    double x = (sqrt(k * k + 4.0 * (1.0 - k) * size) - k) / (2.0 * (1.0 - k));
    return sine < 0.0 ? -x : x;
}

double air_drawn_back(double x, double k)
{
    return x * (k + (1.0 - k) * (x < 0.0 ? -x : x));
}

// 0 if x is far below 0, x if it is far above, smooth between.
static double beyond(double x)
{
    return 0.5 * (x + sqrt(x * x + 0.0004));
}

struct air_scale air_scale(double sun, double row)
{
    // The rows of a kind: red, green, blue.
    static const double fit[3][3][7] = {{{6.72, 0.159, 67.83, 4.369, 109.6, 1.222, 0.2395},
                                         {6.92, 0.206, 69.22, 3.697, 95.2, 1.282, 0.3577},
                                         {7.07, 0.243, 67.35, 1.829, 82.36, -1.065, 0.9554}},
                                        {{5.60, 0.224, 195.4, 4.805, 0.0, -0.722, 0.0566},
                                         {5.60, 0.317, 246.6, 4.725, 0.0, -0.596, 0.1568},
                                         {4.62, 0.300, 290.0, 4.600, 0.0, -0.600, 0.3300}},
                                        {{1.05, 0.193, 73.83, 4.599, 8.42, 0.0706, 0.0450},
                                         {1.68, 0.201, 77.35, 4.292, -0.27, 0.789, 0.0744},
                                         {2.17, 0.215, 78.63, 2.956, -3.81, 0.924, 0.0687}}};
    const double log2 = 0.69314718055994531;
    double low = 1.0 / ((sun > 0.0 ? sun : 0.0) + 0.068), foot = 1.0 / (1.0 + 114.0 * row * row);
    double shaded = beyond(-sun - 0.008), deep[3] = {beyond(-sun - 0.05), shaded, shaded};
    struct air_scale scale = {{0.0}, {0.0}, {0.0}};
    for (int i = 0; i < 3 * 3; i++) {
        const double *k = fit[i / 3][i % 3], d = deep[i / 3];
        double *one = i < 3 ? scale.air : (i < 6 ? scale.dust : scale.more);
        one[i % 3] = paint_exp(log2 * (k[0] - k[1] * low - k[2] * d - row * (k[3] + k[4] * d) -
                                       foot * (k[5] + k[6] * low)));
    }
    return scale;
}

// The light of a point in a table. A table is drawn from its top row down, and each point of the
// top storey is needed again in the storeys below, so it is stored.
static struct air_light light_once(double sun, double row, double azimuth, double ozone, int column)
{
    static struct {
        struct air_light light;
        double azimuth, ozone;
        int known;
    } kept[AIR_ROWS][AIR_COLUMNS];
    int i = (int)(row * (AIR_ROWS - 1) + 0.5);
    if (!kept[i][column].known || kept[i][column].azimuth != azimuth ||
        kept[i][column].ozone != ozone) {
        kept[i][column].light =
            air_scattered(sun, air_drawn_back(row, AIR_VIEW_WIDTH), azimuth, ozone);
        kept[i][column].azimuth = azimuth;
        kept[i][column].ozone = ozone;
        kept[i][column].known = 1;
    }
    return kept[i][column].light;
}

void air_table(double u, double v, double azimuth, double ozone, double value[4])
{
    double lowest = air_drawn_out(AIR_LOWEST_SUN, AIR_SUN_WIDTH);
    double column = floor(u * AIR_COLUMNS) / (AIR_COLUMNS - 1), y = floor(v * 3 * AIR_ROWS);
    int storey = (int)(y / AIR_ROWS);
    double row = (y - AIR_ROWS * storey) / (AIR_ROWS - 1);
    double sun = air_drawn_back(lowest + column * (1.0 - lowest), AIR_SUN_WIDTH);
    struct air_light light = light_once(sun, row, azimuth, ozone, (int)(u * AIR_COLUMNS));
    struct air_scale scale = air_scale(sun, row);
    double *part = storey == 0 ? light.air : (storey == 1 ? light.dust : light.more);
    const double *one = storey == 0 ? scale.air : (storey == 1 ? scale.dust : scale.more);
    double all = ozone > 0.0 ? 1.0 : 0.25; // without ozone there is up to three times as much light
    for (int c = 0; c < 3; c++)
        part[c] *= all;
    double blue = part[2] / one[2];
    int byte = paint_byte(blue); // the one below; the fourth number contains the rest
    byte -= byte > 0 && paint_light(byte) > blue ? 1 : 0;
    value[0] = part[0] / one[0];
    value[1] = part[1] / one[1];
    value[2] = paint_light(byte);
    value[3] = 128.0 / 255.0 + (blue - value[2]) * one[2] / (AIR_FINE * one[0]);
}

// The air mass of chapter 09's even shell.
static double air_mass(double sine)
{
    double climb = 721.5 * sine, horizon = 2.0 * 721.5 + 1.0;
    return horizon / (sqrt(climb * climb + horizon) + climb);
}

// The disc is darker towards its rim, and redder: the share at the rim is 1 - DARK. Source: the
// sun's limb by A. N. Cox (editor), 'Allen's astrophysical quantities' (2000), the linear term at
// 680, 550 and 440 nm.
static const double DARK[3] = {0.47, 0.60, 0.74};

void air_sun_table(double u, double v, double value[3])
{
    double q = floor(u * SUN_COLUMNS) / (SUN_COLUMNS - 1), x = SUN_REACH * q * q;
    double row = floor(v * SUN_ROWS) / (SUN_ROWS - 1), sine = air_drawn_back(row, SUN_ROW_WIDTH);
    double mass = air_mass(sine), scale = 15.0 * paint_exp(-0.1 * mass), colour[3];
    double rim = x < 1.0 ? sqrt(1.0 - x * x) : 0.0, left = 1.0 - x * x / (SUN_REACH * SUN_REACH);
    air_sunlight(sine, colour);
    for (int c = 0; c < 3; c++) {
        // The mean of the disc is 1 - DARK / 3 of its centre, and must equal the sun's light.
        double middle = colour[c] / (1.0 - DARK[c] / 3.0) / scale;
        value[c] = middle * (x <= 1.0 ? 1.0 - DARK[c] * (1.0 - rim) : mass / 38.0 * left * left);
    }
}
