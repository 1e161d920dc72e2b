#include "reef_parts.h"

#include <math.h>
#include <stddef.h>

#include "paint.h"

// The kinds of coral. STAG, BUSH, FAN and TABLE fork again and again.
enum kind { STAG, BUSH, FAN, TABLE, BRAIN, TUBES, ANEMONE };

enum { STONE = 14, FISH = 15, PINK = 0, RED, ORANGE, YELLOW, GREEN, CYAN, BLUE, VIOLET, CREAM };

// At most TIPS tips of a coral grow at a time. A colony has about COLONY parts.
enum { TIPS = 4096, COLONY = 96 };

struct v3 {
    double x, y, z;
};

struct tip {
    struct v3 from, direction;
    double radius, length;
    int level;
};

// A reef that is being built.
struct reef {
    struct part *part;
    int count, limit;
    int drawn; // how many random numbers have been drawn
    struct tip tip[TIPS];
};

static struct v3 v3(double x, double y, double z)
{
    return (struct v3){x, y, z};
}

static struct v3 plus(struct v3 a, double s, struct v3 b)
{
    return v3(a.x + s * b.x, a.y + s * b.y, a.z + s * b.z);
}

static double dot(struct v3 a, struct v3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct v3 unit(struct v3 a)
{
    double s = 1.0 / sqrt(dot(a, a) + 1e-12);
    return v3(s * a.x, s * a.y, s * a.z);
}

static double drawn(struct reef *reef)
{
    return paint_random(reef->drawn++, 0, 25U);
}

// A random direction, uniformly distributed.
static struct v3 any_direction(struct reef *reef)
{
    for (;;) {
        struct v3 d = v3(2.0 * drawn(reef) - 1.0, 2.0 * drawn(reef) - 1.0, 2.0 * drawn(reef) - 1.0);
        double square = dot(d, d);
        if (square < 1.0 && square > 0.01)
            return unit(d);
    }
}

// A direction turned by the golden angle about the y axis, so that many turns cover the circle
// evenly.
static struct v3 golden(struct v3 d)
{
    const double c = -0.73736887807832, s = 0.67549029426152;
    return v3(c * d.x - s * d.z, d.y, s * d.x + c * d.z);
}

static void add(struct reef *reef, struct v3 a, struct v3 b, double radius, int colour, double tip)
{
    if (reef->count >= reef->limit)
        return;
    int near = (int)(15.0 * (tip < 0.0 ? 0.0 : tip > 1.0 ? 1.0 : tip));
    struct part part = {{0.5 * (a.x + b.x), 0.5 * (a.y + b.y), 0.5 * (a.z + b.z)},
                        {0.5 * (b.x - a.x), 0.5 * (b.y - a.y), 0.5 * (b.z - a.z)},
                        radius,
                        16 * colour + near};
    reef->part[reef->count++] = part_stored(part);
}

// ---- Corals ----

// A coral that forks until it has used up its parts.
static void fork(struct reef *reef, enum kind kind, struct v3 base, double size, int colour,
                 int end)
{
    int stems = kind == STAG ? 7 : kind == FAN ? 4 : kind == TABLE ? 8 : 6, first = 0, last = 0;
    double spread = kind == STAG ? 1.0 : kind == TABLE ? 1.6 : 0.7;
    struct v3 flat = unit(v3(0.5 * (drawn(reef) - 0.5), 0.0, -1.0)), around = v3(1.0, 0.0, 0.0);
    if (kind == TABLE) {
        add(reef, base, plus(base, 0.30 * size, v3(0.1, 1.0, 0.0)), 0.08 * size, colour, 0.0);
        base = plus(base, 0.32 * size, v3(0.1, 1.0, 0.0));
    }
    for (int i = 0; i < stems; i++, around = golden(around)) {
        struct v3 d = unit(v3(spread * around.x, kind == TABLE ? 0.25 : 1.0, spread * around.z));
        d = kind == FAN ? unit(plus(d, -0.95 * dot(d, flat), flat)) : d;
        double length = size * (kind == TABLE ? 0.17 : kind == STAG ? 0.24 : 0.22);
        reef->tip[last++] = (struct tip){base, d, size * (kind == FAN ? 0.045 : 0.058), length, 0};
    }
    while (reef->count < end && first < last) {
        struct tip t = reef->tip[first++ % TIPS];
        struct v3 to = plus(t.from, t.length, t.direction);
        add(reef, t.from, to, t.radius, colour, t.level / 5.0 + 0.05 * drawn(reef));
        int forks = drawn(reef) < 0.2 ? 3 : 2;
        for (int i = 0; i < forks && last - first < TIPS - 4; i++) {
            struct v3 d = plus(t.direction, kind == BUSH ? 0.75 : 0.62, any_direction(reef));
            d.y += 0.14;
            d = kind == FAN ? plus(d, -0.95 * dot(d, flat), flat) : d;
            if (kind == TABLE)
                d.y = 0.12 + 0.12 * drawn(reef) + (t.level > 2 ? 0.45 : 0.0);
            d = unit(d);
            double radius = t.radius * 0.84 > 0.012 ? t.radius * 0.84 : 0.012;
            double length = t.length * (0.76 + 0.14 * drawn(reef));
            reef->tip[last++ % TIPS] = (struct tip){to, d, radius, length, t.level + 1};
        }
    }
}

// A brain coral: many small balls on a large ball.
static void brain(struct reef *reef, struct v3 base, double size, int colour, int end)
{
    int balls = end - reef->count - 1;
    double ball = 0.42 * size;
    struct v3 around = v3(1.0, 0.0, 0.0), middle = plus(base, 0.10 * size, v3(0.0, 1.0, 0.0));
    add(reef, middle, middle, 0.93 * ball, colour, 0.0);
    for (int i = 0; i < balls; i++, around = golden(around)) {
        double y = 1.0 - 1.35 * (i + 0.5) / balls, s = sqrt(y < 1.0 ? 1.0 - y * y : 0.0);
        struct v3 p = plus(middle, ball, v3(s * around.x, 0.88 * y, s * around.z));
        add(reef, p, p, 1.55 * ball / sqrt(balls), colour, 0.5 + 0.4 * y);
    }
}

// A cluster of organ pipes, or a tuft of tentacles with bright ends.
static void cluster(struct reef *reef, enum kind kind, struct v3 base, double size, int colour,
                    int end)
{
    bool pipes = kind == TUBES;
    struct v3 around = v3(1.0, 0.0, 0.0);
    for (int i = 0; reef->count < end; i++, around = golden(around)) {
        double out = sqrt((i + 0.5) * (pipes ? 0.07 : 0.03)),
               height = pipes ? 1.3 - 0.5 * out : 0.5;
        struct v3 from = plus(base, 0.2 * size * out, around);
        struct v3 d =
            unit(v3((pipes ? 0.25 : 0.9) * out * around.x + 0.2 * (drawn(reef) - 0.5), 1.0,
                    (pipes ? 0.25 : 0.9) * out * around.z + 0.2 * (drawn(reef) - 0.5)));
        double radius = size * (pipes ? 0.085 - 0.012 * out : 0.022);
        double length = size * height * (0.55 + 0.5 * drawn(reef));
        for (int k = 0; k < 3; k++) {
            struct v3 to = plus(from, length / 3.0, d);
            add(reef, from, to, radius * (pipes ? 0.9 + 0.1 * k : 1.0 - 0.15 * k), colour, k / 2.2);
            d = unit(plus(d, pipes ? 0.10 : 0.35, any_direction(reef)));
            from = to;
        }
        if (!pipes)
            add(reef, from, from, 0.032 * size, CREAM, 1.0);
    }
}

// ---- The whole reef ----

// The height of the reef's bed, which rises to the left, to the right and far behind, around a
// gully.
static double bed(double x, double z)
{
    static const double hill[4][5] = {{-3.9, -1.2, 3.0, 6.0, 1.5}, // x, z, widths squared, height
                                      {3.7, 0.2, 2.6, 3.4, 1.0},
                                      {3.2, -6.5, 8.0, 5.0, 2.0},
                                      {-2.6, -8.5, 9.0, 4.0, 1.5}};
    double height = 0.0;
    for (int i = 0; i < 4; i++) {
        double dx = x - hill[i][0], dz = z - hill[i][1];
        double away = dx * dx / hill[i][2] + dz * dz / hill[i][3];
        height += hill[i][4] / (1.0 + away * away);
    }
    return height;
}

// Add the rock: stones as high as the bed.
static void rock(struct reef *reef, int count)
{
    struct v3 around = v3(0.6, 0.0, 0.8);
    for (int i = 0; i < count; i++) {
        around = golden(around);
        double out = sqrt((i + 0.5) / count), radius = 0.5 + 0.4 * drawn(reef);
        struct v3 p = v3(5.6 * out * around.x, 0.0, 6.6 * out * around.z - 4.0);
        double height = bed(p.x, p.z);
        radius = height > 0.45 ? radius : 0.3 + 0.2 * drawn(reef);
        p.y = height + 0.10 - radius;
        if (height > 0.25)
            add(reef, v3(p.x + 0.3 * around.z, 0.4 * p.y, p.z), p, radius, STONE, drawn(reef));
    }
}

// Add the stones on which a coral grows.
static void stones(struct reef *reef, struct v3 base, double size, int count)
{
    struct v3 around = unit(any_direction(reef));
    for (int i = 0; i < count; i++) {
        around = golden(around);
        double radius = size * (0.26 + 0.10 * drawn(reef)), out = (i == 0 ? 0.0 : 0.30) * size;
        struct v3 p = plus(base, out, v3(around.x, 0.0, around.z));
        p.y = base.y - (i == 0 ? 0.9 : 1.1) * radius;
        struct v3 side = v3(0.5 * radius * around.z, 0.0, 0.5 * radius * around.x);
        add(reef, plus(p, -1.0, side), plus(p, 1.0, side), radius, STONE, drawn(reef));
    }
}

static void colony(struct reef *reef, int number, struct v3 base, double size, int end)
{
    static const unsigned char kinds[] = {STAG,    BRAIN, TABLE, BUSH, TUBES, FAN,
                                          ANEMONE, BRAIN, BUSH,  STAG, FAN,   TABLE};
    static const unsigned char colours[] = {ORANGE, YELLOW, CYAN,   PINK,   VIOLET, RED, GREEN,
                                            RED,    BLUE,   YELLOW, VIOLET, ORANGE, PINK};
    enum kind kind = kinds[number % 12];
    int colour = colours[number % 13];
    stones(reef, base, size, 3);
    if (kind == BRAIN)
        brain(reef, base, size, colour, end);
    else if (kind == TUBES || kind == ANEMONE)
        cluster(reef, kind, base, size, colour, end);
    else
        fork(reef, kind, base, size, colour, end);
    while (reef->count < end) { // the parts left over by a coral that ended early become pebbles
        struct v3 p = plus(base, size * (0.5 + drawn(reef)), any_direction(reef));
        double radius = 0.02 + 0.04 * drawn(reef);
        p.y = bed(p.x, p.z) * 0.2 + 0.3 * radius;
        add(reef, p, plus(p, radius, v3(drawn(reef), 0.0, drawn(reef))), radius, STONE,
            drawn(reef));
    }
}

// A fish: a body that becomes thinner towards a tail with two fins.
static void fish(struct reef *reef, struct v3 p, struct v3 d, double size, int colour)
{
    struct v3 tail = plus(p, -1.9 * size, d), up = v3(0.0, 1.0, 0.0);
    double paint = colour / 15.0;
    add(reef, plus(p, -0.1 * size, d), plus(p, 0.9 * size, d), 0.52 * size, FISH, paint);
    add(reef, plus(p, -0.3 * size, d), tail, 0.25 * size, FISH, paint);
    add(reef, tail, plus(plus(tail, -0.7 * size, d), 0.7 * size, up), 0.12 * size, FISH, paint);
    add(reef, tail, plus(plus(tail, -0.7 * size, d), -0.7 * size, up), 0.12 * size, FISH, paint);
}

static double cube_root(double x)
{
    double root = 1.0;
    for (int i = 0; i < 40; i++)
        root = (2.0 * root + x / (root * root)) / 3.0;
    return root;
}

void reef_build(int count, struct part *part)
{
    static struct reef reef;
    reef = (struct reef){.part = part, .limit = count};
    int school = count >= 1024  ? 46
                 : count >= 512 ? 12
                                : 2,
        pebbles = count / 14, rocks = count / 50;
    int grown = count - pebbles - rocks - 4 * school,
        colonies = grown / COLONY > 1 ? grown / COLONY : 1;
    double size = 3.6 / cube_root(colonies);
    struct v3 around = v3(0.8, 0.0, 0.6);
    for (int i = 0; i < colonies; i++, around = golden(around)) {
        double out = sqrt((i + 0.5) / colonies);
        struct v3 p = v3(4.9 * out * around.x, 0.0, 5.6 * out * around.z - 2.6);
        p.x += p.x * p.x < 1.0 ? (p.x < 0.0 ? -0.8 : 0.8) : 0.0; // keep the gully free
        p.y = bed(p.x, p.z) + 0.22 * size;
        int end = (int)((double)grown * (i + 1) / colonies + 0.5);
        colony(&reef, i, p, size * (0.8 + 0.45 * drawn(&reef)), end);
    }
    rock(&reef, rocks);
    for (int i = 0; i < pebbles; i++) {
        struct v3 p = v3(13.0 * drawn(&reef) - 6.5, 0.0, 12.0 * drawn(&reef) - 6.8);
        double shape = drawn(&reef), radius = 0.02 + 0.08 * shape * shape;
        p.y = 0.25 * radius;
        struct v3 d = v3(2.0 * drawn(&reef) - 1.0, 0.1, 2.0 * drawn(&reef) - 1.0);
        add(&reef, p, plus(p, radius, d), radius, STONE, drawn(&reef));
    }
    for (int i = 0; i < school; i++) {
        struct v3 d = unit(v3(-1.0, 0.12, 0.25 + 0.3 * drawn(&reef)));
        struct v3 off = any_direction(&reef);
        double far = drawn(&reef);
        struct v3 p =
            v3(0.3 + 2.6 * far * off.x, 2.5 + 0.7 * far * off.y, -3.5 + 1.8 * far * off.z);
        fish(&reef, p, d, 0.065 + 0.02 * drawn(&reef), i % 16);
    }
    while (reef.count < count)
        add(&reef, v3(0.0, -0.5, 0.0), v3(0.0, -0.5, 0.0), 0.1, STONE, 0.0);
}
