// moon.c - the near side of a moon, to be read as numbers: the brightness of the ground in red, and
// its slopes to the right and upwards in green and blue.
//
// The seas are about where those of our Moon are, and so are the craters of the table `named`.
// Everything else is random, with many small craters and few large ones.
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#include "paint.h"

// The picture shows the disc as seen from far away, north up. Outside the disc, the ground fades to
// a mean, so that opposite edges of the picture agree.
#define RADIUS 0.47 // of the disc, in widths of the picture
#define BRIGHT 0.40 // the albedo that is stored as 1
#define STEEP  0.30 // the slope that is stored as 1; -STEEP is stored as 0

enum { SIZE = 512, SIDE = 2 * SIZE, CRATERS = 5200 };

static struct {
    bool drawn;
    float mare[SIDE][SIDE]; // 1 in a sea, 0 on the highlands
    float albedo[SIDE][SIDE];
    float height[SIDE][SIDE];
} moon;

struct point {
    double x, y, z; // on the ball of radius 1, x right, y up, z towards the eye
};

static struct point on_ball(double x, double y)
{
    return (struct point){x, y, sqrt(fmax(1.0 - x * x - y * y, 0.0))};
}

static double apart(struct point a, struct point b)
{
    double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return sqrt(x * x + y * y + z * z);
}

// ---- Noise in space ----

static double smooth(double t)
{
    return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

static double layer(double x, double y, int k, uint32_t seed)
{
    double i = floor(x), j = floor(y), s = smooth(x - i), t = smooth(y - j);
    uint32_t name = seed + 7919U * (uint32_t)(k + 4096);
    double low = paint_random((int)i, (int)j, name), high = paint_random((int)i, (int)j + 1, name);
    low += s * (paint_random((int)i + 1, (int)j, name) - low);
    high += s * (paint_random((int)i + 1, (int)j + 1, name) - high);
    return low + t * (high - low);
}

// Octaves of value noise with k cells per radius, from -1 to 1, with a mean of about 0.
static double rough(struct point p, double k, int octaves, double gain, uint32_t seed)
{
    double sum = 0.0, total = 0.0, strength = 1.0;
    for (int i = 0; i < octaves; i++) {
        double z = k * p.z + 0.37 * i, floor_z = floor(z);
        double near = layer(k * p.x + 0.71 * i, k * p.y, (int)floor_z, seed + (uint32_t)i);
        double far = layer(k * p.x + 0.71 * i, k * p.y, (int)floor_z + 1, seed + (uint32_t)i);
        sum += strength * (near + smooth(z - floor_z) * (far - near));
        total += strength;
        strength *= gain;
        k *= 2.0;
    }
    return 2.0 * sum / total - 1.0;
}

// ---- The seas ----

// The centre on the disc, the radius and the darkness of each basin that lava has filled.
static const double seas[][4] = {
    {-0.231, 0.545, 0.315, 1.00},  {0.273, 0.469, 0.175, 1.00},   {0.500, 0.155, 0.215, 1.10},
    {0.400, 0.300, 0.120, 1.05},   {0.835, 0.285, 0.125, 1.10},   {0.775, -0.080, 0.150, 1.00},
    {0.760, -0.250, 0.110, 0.95},  {0.545, -0.262, 0.095, 0.95},  {-0.400, 0.790, 0.065, 0.80},
    {-0.280, 0.828, 0.075, 0.80},  {-0.160, 0.846, 0.075, 0.80},  {-0.040, 0.848, 0.070, 0.80},
    {0.080, 0.840, 0.065, 0.80},   {0.190, 0.822, 0.060, 0.80},   {0.660, 0.030, 0.100, 0.95},
    {0.470, -0.060, 0.090, 0.95},  {-0.480, -0.060, 0.130, 0.90}, {-0.780, 0.340, 0.200, 1.00},
    {-0.720, 0.110, 0.200, 1.00},  {-0.700, 0.560, 0.130, 0.90},  {-0.640, -0.110, 0.150, 0.95},
    {-0.580, 0.300, 0.160, 0.90},  {-0.575, -0.405, 0.105, 1.05}, {-0.280, -0.345, 0.150, 0.95},
    {-0.400, -0.180, 0.120, 0.95}, {0.068, 0.222, 0.070, 0.90},   {-0.480, 0.110, 0.150, 0.85},
    {-0.120, 0.205, 0.060, 0.85},  {-0.380, 0.690, 0.070, 1.00},  {-0.924, -0.092, 0.045, 1.10},
    {-0.097, 0.784, 0.030, 1.10},  {0.960, 0.010, 0.060, 0.80},   {0.620, 0.780, 0.030, 0.90},
    {0.935, 0.160, 0.045, 0.80}};

// How deep inside the seas a point is, 0 to 1. Noise warps the shores, and there are islands near
// the shores.
//   dark  receives the mean darkness of the seas at the point
static double sea_at(struct point p, double *dark)
{
    double inside = 0.0, sum = 0.0, weight = 1e-9;
    struct point q = {p.x + 0.050 * rough(p, 4.0, 4, 0.6, 11) + 0.020 * rough(p, 17.0, 4, 0.7, 15),
                      p.y + 0.050 * rough(p, 4.0, 4, 0.6, 21) + 0.020 * rough(p, 17.0, 4, 0.7, 25),
                      p.z};
    double shore = 0.10 * rough(p, 5.5, 5, 0.65, 31), thin = 0.5 + 0.5 * rough(p, 3.5, 3, 0.6, 41);
    for (size_t i = 0; i < sizeof seas / sizeof *seas; i++) {
        double far = apart(q, on_ball(seas[i][0], seas[i][1])), r = seas[i][2];
        double soft = 0.018 + 0.05 * thin * fmin(r / 0.15, 1.0);
        double here = paint_step(soft, -soft, far - r + shore * fmin(r / 0.12, 1.0));
        inside += here - inside * here;
        sum += (here + 1e-12) * seas[i][3];
        weight += here + 1e-12;
    }
    *dark = sum / weight;
    return inside;
}

// ---- Craters ----

struct crater {
    struct point middle;
    double radius; // in radii of the moon
    double fresh;  // 0 old and worn down, 1 young and bright
    double rays;   // length of its rays, in radii of the crater; 0 if it has none
    uint32_t name;
};

static const struct {
    double x, y, radius, fresh, rays;
} named[] = {{-0.140, -0.682, 0.0250, 1.00, 46.0}, {-0.337, 0.167, 0.0280, 0.85, 13.0},
             {-0.610, 0.139, 0.0110, 0.90, 22.0},  {-0.670, 0.402, 0.0140, 1.00, 12.0},
             {0.703, 0.277, 0.0100, 1.00, 15.0},   {0.864, -0.155, 0.0380, 0.55, 5.0},
             {0.680, -0.530, 0.0130, 0.90, 16.0},  {-0.820, -0.410, 0.0100, 0.90, 18.0},
             {-0.050, 0.957, 0.0150, 0.80, 14.0},  {0.360, 0.883, 0.0120, 0.80, 14.0},
             {0.430, -0.190, 0.0300, 0.45, 0.0},   {0.400, -0.235, 0.0290, 0.10, 0.0},
             {-0.126, -0.850, 0.0650, 0.05, 0.0},  {0.785, -0.420, 0.0510, 0.20, 0.0},
             {-0.035, -0.160, 0.0440, 0.05, 0.0},  {-0.050, -0.232, 0.0340, 0.15, 0.0},
             {-0.032, -0.310, 0.0280, 0.15, 0.0},  {-0.190, 0.251, 0.0170, 0.50, 0.0},
             {-0.060, 0.493, 0.0230, 0.35, 0.0},   {0.400, -0.290, 0.0280, 0.20, 0.0},
             {0.480, 0.680, 0.0250, 0.30, 0.0},    {0.420, 0.730, 0.0200, 0.40, 0.0},
             {0.060, -0.660, 0.0350, 0.05, 0.0},   {0.170, -0.660, 0.0330, 0.05, 0.0},
             {-0.620, -0.300, 0.0320, 0.10, 0.0},  {-0.440, -0.700, 0.0550, 0.05, 0.0}};

// How strong the rays of a crater are at a point, 0 to about 1. A ray is a streak that leaves the
// crater in one direction, so rays are noise that depends only on the direction, torn into patches.
//   far  distance of the point from the crater's middle
static double ray_at(const struct crater *crater, struct point p, double far)
{
    double q = far / crater->radius;
    if (q > crater->rays || q < 0.9)
        return 0.0;
    struct point way = {(p.x - crater->middle.x) / far, (p.y - crater->middle.y) / far,
                        (p.z - crater->middle.z) / far};
    double streak = rough(way, 5.0, 3, 0.8, crater->name + 3);
    double fine = rough(way, 21.0, 2, 0.7, crater->name + 9);
    double patch = rough(p, 30.0, 4, 0.7, crater->name + 17);
    double thin = paint_step(-0.05, 0.60, streak + 0.35 * fine + 0.22 * patch);
    double fade = 1.0 - q / crater->rays, blanket = paint_step(4.5, 0.9, q);
    return fmax(thin * fade * (0.75 + 0.6 * patch), 0.80 * blanket);
}

// The height of a crater's bowl and rim, in radii of the moon; q is the distance from the crater's
// centre, in radii of the crater.
static double bowl(double q, double radius)
{
    double deep = 0.0009 + 0.050 * radius, flat = paint_step(0.016, 0.045, radius);
    double floor_at = 0.30 + 0.32 * flat; // large craters have a level floor and a peak
    double wall = paint_step(floor_at, 1.0, q) * 1.30 - 1.0;
    double peak = flat * 0.38 * paint_step(0.20, 0.0, q);
    double outside = 0.30 * paint_step(2.1, 1.0, q);
    return deep * (q < 1.0 ? wall + peak : outside);
}

static void dig(const struct crater *crater)
{
    double reach = crater->radius * fmax(crater->rays, 2.2);
    double worn = 0.35 + 0.65 * crater->fresh;
    int low[2], high[2];
    for (int k = 0; k < 2; k++) {
        double at = k == 0 ? crater->middle.x : -crater->middle.y;
        low[k] = (int)fmax((0.5 + RADIUS * (at - reach)) * SIDE, 0.0);
        high[k] = (int)fmin((0.5 + RADIUS * (at + reach)) * SIDE, SIDE - 1.0);
    }
    for (int row = low[1]; row <= high[1]; row++)
        for (int column = low[0]; column <= high[0]; column++) {
            double x = ((column + 0.5) / SIDE - 0.5) / RADIUS;
            double y = (0.5 - (row + 0.5) / SIDE) / RADIUS;
            double square = x * x + y * y, rim = square > 1.0 ? 1.0 / sqrt(square) : 1.0;
            struct point p = on_ball(rim * x, rim * y);
            double far = apart(p, crater->middle), q = far / crater->radius;
            if (q >= fmax(crater->rays, 2.2))
                continue;
            float *height = &moon.height[row][column], *albedo = &moon.albedo[row][column];
            // The impact buries the earlier ground or throws it away.
            double keep = q < 1.0 ? 0.25 + 0.75 * paint_step(0.7, 1.0, q) : 1.0;
            *height = (float)(*height * keep + worn * bowl(q, crater->radius));
            double bright = crater->fresh * (q < 1.0 ? 0.55 + 0.25 * paint_step(0.5, 0.95, q)
                                                     : 0.40 * paint_step(1.7, 1.0, q));
            double ray = crater->rays > 0.0 ? crater->fresh * ray_at(crater, p, far) : 0.0;
            double share = fmin(fmax(bright, 0.50 * ray), 1.0);
            *albedo = (float)(*albedo + share * (0.255 - *albedo));
        }
}

// ---- The whole moon ----

static void ground(void)
{
    for (int row = 0; row < SIDE; row++)
        for (int column = 0; column < SIDE; column++) {
            double x = ((column + 0.5) / SIDE - 0.5) / RADIUS;
            double y = (0.5 - (row + 0.5) / SIDE) / RADIUS;
            double square = x * x + y * y, rim = square > 1.0 ? 1.0 / sqrt(square) : 1.0;
            struct point p = on_ball(rim * x, rim * y);
            double dark, sea = sea_at(p, &dark);
            double broad = rough(p, 3.0, 4, 0.6, 51), fine = rough(p, 22.0, 4, 0.65, 61);
            double flow = rough(p, 6.0, 5, 0.55, 71);
            double old = rough(p, 7.0, 4, 0.6, 101);
            double high = 0.150 + 0.034 * broad + 0.030 * fine + 0.020 * old;
            double lava = 0.076 - 0.09 * (dark - 1.0) + 0.030 * flow + 0.009 * fine;
            moon.mare[row][column] = (float)sea;
            moon.albedo[row][column] = (float)(high + sea * (lava - high));
            double hills = 0.0006 + 0.0011 * rough(p, 9.0, 5, 0.55, 81);
            double plain = -0.0008 + 0.00012 * rough(p, 12.0, 3, 0.6, 91);
            moon.height[row][column] = (float)(hills + sea * (plain - hills));
        }
}

static double lot(int i, uint32_t what)
{
    return paint_random(i, 5, what);
}

// Dig the random craters, each on top of those before it. The number of craters larger than r falls
// as 1 / r^2. Lava has covered most of the craters in the seas.
static void by_lot(void)
{
    for (int i = 0; i < CRATERS; i++) {
        double x = 2.0 * lot(i, 1) - 1.0, y = 2.0 * lot(i, 2) - 1.0;
        // A uniform distribution on the hemisphere: points of a disc, mapped with equal areas.
        double square = x * x + y * y;
        if (square >= 1.0)
            continue;
        double shrink = sqrt(2.0 - square);
        struct crater crater = {.middle = on_ball(x * shrink, y * shrink),
                                .name = paint_hash(i, 3, 9)};
        crater.radius = 0.0062 / sqrt(fmax(lot(i, 4), 0.0095));
        int column = (int)((0.5 + RADIUS * crater.middle.x) * SIDE);
        int row = (int)((0.5 - RADIUS * crater.middle.y) * SIDE);
        if (lot(i, 6) < moon.mare[row][column] * 0.93)
            continue;
        double young = lot(i, 7);
        crater.fresh = young > 0.985 ? 0.75 : 0.16 * young;
        crater.rays = young > 0.985 && crater.radius < 0.02 ? 7.0 : 0.0;
        dig(&crater);
    }
}

static void draw(void)
{
    if (moon.drawn)
        return;
    moon.drawn = true;
    ground();
    by_lot();
    for (size_t i = sizeof named / sizeof *named; i-- > 0;) {
        struct crater crater = {on_ball(named[i].x, named[i].y), named[i].radius, named[i].fresh,
                                named[i].rays, paint_hash((int)i, 1, 77)};
        dig(&crater);
    }
}

// The value of a map at a row and a column; outside the disc the value fades to the mean.
static double look_up(float map[SIDE][SIDE], double row, double column, double mean)
{
    int i = (int)fmin(fmax(floor(row), 0.0), SIDE - 1.0);
    int j = (int)fmin(fmax(floor(column), 0.0), SIDE - 1.0);
    double x = (column / SIDE - 0.5) / RADIUS, y = (row / SIDE - 0.5) / RADIUS;
    double here = paint_step(1.06, 1.02, sqrt(x * x + y * y));
    return mean + here * ((double)map[i][j] - mean);
}

// The mean of the four points of a map in a pixel of the picture; dx and dy, in points, move these
// points.
static double mean_of(float map[SIDE][SIDE], double u, double v, double dx, double dy, double mean)
{
    double sum = 0.0;
    for (int k = 0; k < 4; k++)
        sum += 0.25 *
               look_up(map, (1.0 - v) * SIDE - dy + k / 2 - 0.5, u * SIDE + dx + k % 2 - 0.5, mean);
    return sum;
}

// The light that sRGB stores as the byte nearest to 255 times a number, which is clamped to [0, 1].
static double as_stored(double number)
{
    double value[3];
    paint_colour((uint32_t)(fmin(fmax(number, 0.0), 1.0) * 255.0 + 0.5), value);
    return value[2];
}

static void moon_at(double u, double v, double value[3])
{
    draw();
    double across =
        mean_of(moon.height, u, v, 1.0, 0.0, 0.0) - mean_of(moon.height, u, v, -1.0, 0.0, 0.0);
    double up =
        mean_of(moon.height, u, v, 0.0, 1.0, 0.0) - mean_of(moon.height, u, v, 0.0, -1.0, 0.0);
    double slope = 0.5 * SIDE * RADIUS / (2.0 * STEEP);
    value[0] = as_stored(mean_of(moon.albedo, u, v, 0.0, 0.0, 0.13) / BRIGHT);
    value[1] = as_stored(0.5 + slope * across);
    value[2] = as_stored(0.5 + slope * up);
}

int main(void)
{
    return paint_texture(SIZE, SIZE, 1, PAINT_COLOUR, moon_at);
}
