#include "air_orders.h"

#include <math.h>
#include <stdbool.h>

#include "air_path.h"

// The light that a point of the air receives depends only on its height and on the sun's height
// there: rotate the Earth and all its air about the axis to the sun, and nothing changes. So a grid
// over these two heights contains all the light, for each wavelength.
enum { HEIGHTS = 32, SUNS = 96, ABOVE = 10, BELOW = 6, AROUND = 8, PATH_STEPS = 24, ORDERS = 4 };

// The share of the light that the ground reflects.
static const double ALBEDO = 0.15;

typedef double grid[HEIGHTS][SUNS][AIR_WAVES];

// The light at a point, as shares of the sunlight above the air: the sun's own light, and the mean
// over all directions of the light that air and ground have scattered.
static grid direct, scattered;

static double grid_height(int row)
{
    double q = (double)row / (HEIGHTS - 1);
    return AIR_TOP * q * q;
}

// In the grid, the sine of the sun's height at a point is measured from the sine of the height of
// the horizon seen from there, where the light changes fastest.
static const double GRID_WIDTH = 0.08, GRID_LOWEST = -0.42, GRID_SPAN = 1.25;

static double horizon(double height)
{
    double level = AIR_EARTH / (AIR_EARTH + height);
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
    double y = (HEIGHTS - 1) * sqrt(height > 0.0 ? height / AIR_TOP : 0.0);
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

// A ray from a point of the grid, cut into steps that are shortest where the ray is lowest. The ray
// is the same for all heights of the sun.
struct path {
    double distance[2 * PATH_STEPS], height[2 * PATH_STEPS], dip[2 * PATH_STEPS];
    double air[2 * PATH_STEPS][AIR_WAVES];  // the share that a step's air scatters to the point
    double dust[2 * PATH_STEPS][AIR_WAVES]; // the share that a step's dust scatters to the point
    double ground[AIR_WAVES];               // the share that arrives from the ground
    double length;
    int steps;
    bool lands; // true if the ray ends on the ground
};

static void path_along(double radius, double sine, double ozone, struct path *path)
{
    double lowest = radius * sqrt(1.0 - sine * sine), down = -radius * sine;
    path->lands = sine < 0.0 && lowest < AIR_EARTH;
    double drop = radius * radius - AIR_EARTH * AIR_EARTH;
    path->length =
        path->lands ? drop / (down + sqrt(down * down - drop)) : air_way_out(radius, sine);
    path->steps = 0;
    double turn = path->lands ? path->length : (down > 0.0 ? down : 0.0); // where the ray is lowest
    struct air_amount passed = {0.0, 0.0, 0.0};
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
        path->height[k] = air_height_at(radius, sine, t);
        path->dip[k] = horizon(path->height[k]);
        struct air_amount here = air_density(path->height[k]), half = passed;
        half.air += 0.5 * step * here.air;
        half.dust += 0.5 * step * here.dust;
        half.ozone += 0.5 * step * here.ozone;
        passed.air += step * here.air;
        passed.dust += step * here.dust;
        passed.ozone += step * here.ozone;
        for (int w = 0; w < AIR_WAVES; w++) {
            double share = step * air_share_through(w, half, ozone);
            path->air[k][w] = share * here.air * air_depth(w);
            path->dust[k][w] = share * here.dust * air_dust_depth(w) * AIR_DUST_KEPT;
        }
    }
    for (int w = 0; w < AIR_WAVES; w++)
        path->ground[w] = path->lands ? air_share_through(w, passed, ozone) : 0.0;
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

// Compute one order of scattering: from the light at all points, the light that these points send
// to each point.
//   from    the sunlight, or the mean light of the order before
//   first   true for sunlight, which comes from one direction; scattered light is assumed to come
//           equally from all sides
//   falls   the light of the previous order on horizontal ground, for the columns of row 0
//   mean, falls_next  receive the mean over all directions and the light on the ground
static void next_order(grid from, bool first, double falls[SUNS][AIR_WAVES], double ozone,
                       grid mean, double falls_next[SUNS][AIR_WAVES])
{
    static struct path path;
    for (int row = 0; row < HEIGHTS; row++) {
        double height = grid_height(row), radius = AIR_EARTH + height, dip = horizon(height);
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
                    double phase[2] = {1.0, 1.0}; // phase functions, times 4 pi
                    if (first) {
                        double x = 1.0 / (1.0 + AIR_FORWARD * AIR_FORWARD - 2.0 * AIR_FORWARD * c);
                        phase[0] = 0.75 * (1.0 + c * c);
                        phase[1] = (1.0 - AIR_FORWARD * AIR_FORWARD) * x * sqrt(x);
                    }
                    for (int j = 0; j < path.steps; j++) {
                        double weight[AIR_WAVES], t = path.distance[j];
                        double there = (radius * sun + t * c) / (AIR_EARTH + path.height[j]);
                        for (int w = 0; w < AIR_WAVES; w++)
                            weight[w] = phase[0] * path.air[j][w] + phase[1] * path.dust[j][w];
                        add_between(from, corner_at(path.height[j], path.dip[j], there), weight,
                                    sum);
                    }
                    // The sum is 4 pi times the light from this direction or, if the previous order
                    // is diffuse light, the light itself.
                    double arrives = first ? 1.0 / (4.0 * AIR_PI) : 1.0;
                    if (path.lands) {
                        double there = (radius * sun + path.length * c) / AIR_EARTH;
                        struct corner at = corner_at(0.0, 0.0, there);
                        for (int w = 0; w < AIR_WAVES; w++)
                            sum[w] += path.ground[w] * ALBEDO / (AIR_PI * arrives) *
                                      ((1.0 - at.right) * falls[at.column][w] +
                                       at.right * falls[at.column + 1][w]);
                    }
                    for (int w = 0; w < AIR_WAVES; w++) {
                        mean[row][column][w] += arrives * share / AROUND * sum[w];
                        if (row == 0 && up) // an integral over solid angle: 4 pi times the mean
                            falls_next[column][w] +=
                                arrives * 4.0 * AIR_PI * share / AROUND * sine * sum[w];
                    }
                }
        }
    }
}

// Fill in both grids for an amount of ozone, unless they are already filled for this amount.
static void scatter(double ozone)
{
    static double known = -1.0;
    static grid order, next;
    static double falls[SUNS][AIR_WAVES], falls_next[SUNS][AIR_WAVES];
    if (known == ozone)
        return;
    known = ozone;
    struct air_amount none = {0.0, 0.0, 0.0};
    for (int row = 0; row < HEIGHTS; row++)
        for (int column = 0; column < SUNS; column++) {
            double sun = grid_sun(row, column);
            for (int w = 0; w < AIR_WAVES; w++)
                direct[row][column][w] = scattered[row][column][w] = 0.0;
            air_add_sunlight(AIR_EARTH + grid_height(row), sun, none, ozone, direct[row][column]);
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

void air_add_scattered(double height, double sun, double ozone, const double weight[AIR_WAVES],
                       double sum[AIR_WAVES])
{
    scatter(ozone);
    add_between(scattered, corner_at(height, horizon(height), sun), weight, sum);
}
