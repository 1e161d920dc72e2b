// The light of chapter 09 in double precision: the picture at one place, by another text.
#include <stddef.h>

#include "support_city.h"

#define HAZE  0.05
#define FAR   80.0
#define WIDTH (2.0 / (360.0 * MIRROR_FOCAL_LENGTH)) // of a pixel, per unit of distance

static const struct d3 lamp_at = {0.26, 1.08, 0.0}, lamplight = {1.0, 0.55, 0.22};

static struct d3 each(double (*of)(double, double), struct d3 depth, double x)
{
    return d3(of(depth.x, x), of(depth.y, x), of(depth.z, x));
}

static double through(double depth, double mass)
{
    return exp(-depth * mass);
}

static struct d3 depth(void)
{
    return d3(0.04 + HAZE, 0.1 + HAZE, 0.25 + HAZE);
}

static double mass_of(double s)
{
    double b = 721.5 * fmax(s, 0.0);
    return sqrt(b * b + 1444.0) - b;
}

static struct d3 scattered(double v, double s)
{
    struct d3 lost = d3_sub(each(through, depth(), s), each(through, depth(), v));
    return d3_times(v / (v - s), lost);
}

struct d3 city_sun(double hour)
{
    double p = 43.6 * MIRROR_PI / 180.0, d = 2.0 * MIRROR_PI / 180.0;
    double h = (hour - 12.0) * MIRROR_PI / 12.0;
    return d3(cos(p) * sin(d) - sin(p) * cos(d) * cos(h),
              sin(p) * sin(d) + cos(p) * cos(d) * cos(h), -cos(d) * sin(h));
}

static double day_of(struct d3 sun)
{
    return mirror_smoothstep(-0.25, 0.06, sun.y);
}

static double glow(double c, double g)
{
    return pow((1.0 - g) * (1.0 - g) / (1.0 + g * g - 2.0 * g * c), 1.5);
}

struct d3 city_sky(struct d3 direction, struct d3 sun)
{
    double view = mass_of(direction.y), c = d3_dot(direction, sun), day = day_of(sun);
    struct d3 gain = d3_times(day * day * (0.6 + 0.4 * c * c), d3(1.4, 1.75, 3.1));
    struct d3 light = d3_product(gain, scattered(view, mass_of(sun.y)));
    struct d3 left = d3_times(day, each(through, depth(), mass_of(sun.y)));
    light = d3_add(light, d3_times(glow(c, 0.8), left));
    struct d3 low = d3_times(view / 38.0, d3(0.016, 0.014, 0.016));
    struct d3 high = d3_times(1.0 - view / 38.0, d3(0.002, 0.004, 0.011));
    return d3_add(light, d3_times(1.0 - day, d3_add(low, high)));
}

static struct d3 around_of(struct d3 sun)
{
    double day = day_of(sun);
    struct d3 light = scattered(4.0, mass_of(sun.y));
    return d3_add(d3_times(day * day, d3_product(d3(0.45, 0.52, 0.72), light)),
                  d3(0.003, 0.004, 0.008));
}

static struct d3 direct_of(struct d3 sun)
{
    struct d3 left = each(through, depth(), mass_of(sun.y));
    return d3_add(d3_times(2.6 * mirror_smoothstep(0.0, 0.04, sun.y), left),
                  d3_times(mirror_smoothstep(0.0, 0.15, -sun.y), d3(0.02, 0.03, 0.05)));
}

// The sky with the sun in it.
static struct d3 sky_with_sun(struct d3 sky, struct d3 direction, struct d3 sun)
{
    double away = d3_length(d3_sub(direction, sun));
    double disc = 1.0 - mirror_smoothstep(0.9 * 0.014, 1.1 * 0.014, away);
    return d3_add(sky, d3_times(14.0 * disc, each(through, depth(), mass_of(sun.y))));
}

// What stands at a place, with its colour there.
struct place {
    struct city_tower tower;
    struct d3 p, local, normal, q, colour, glass;
    double facing, width, pane, lit, asphalt;
    bool ground;
};

static double fract(double x)
{
    return x - floor(x);
}

static double cover(double inside, double width)
{
    return mirror_clamp(inside / (width + 0.001) + 0.5);
}

static double stripes(double x, double filled, double width)
{
    return cover(0.5 * filled - fabs(fract(x) - 0.5), width);
}

static double mixed(double a, double b, double share)
{
    return a + share * (b - a);
}

static void look_at_wall(struct place *place, struct d3 sun)
{
    struct d3 n = place->normal;
    double x = (fabs(n.x) > 0.5 ? place->local.z : place->local.x) / 0.36 + 0.5;
    double y = place->p.y / 0.4, wide = place->width / place->facing / 0.36;
    double high = place->width / 0.4, blur = mirror_smoothstep(0.4, 1.0, fmax(wide, high));
    double fx = y < 1.0 ? 0.86 : 0.6, fy = y < 1.0 ? 0.7 : 0.56, side = n.x + 2.0 * n.z;
    float wall = 4096.0f * place->tower.random + (side > 0.0 ? 1.0f : -1.0f);
    double random = (double)city_random((int)floor(x), (int)floor(y), (int)wall);
    double share = (y < 1.0 ? 0.8 : 0.42) * (1.0 - mirror_smoothstep(-0.08, 0.2, sun.y)) *
                   mirror_smoothstep(-0.85, -0.4, sun.y);
    double lit = random < share ? 0.25 + 0.75 * fract(64.0 * random) : 0.0;
    bool upright = fabs(n.y) < 0.5;
    place->pane = upright ? mixed(stripes(x, fx, wide) * stripes(y, fy, high), fx * fy, blur) : 0.0;
    place->lit = mixed(lit, 0.6 * share, blur);
    double b = fract(16.0 * (double)place->tower.random);
    struct d3 brick = d3(mixed(0.46, 0.36, b), mixed(0.33, 0.38, b), mixed(0.24, 0.42, b));
    place->colour =
        d3_add(d3_times(1.0 - place->pane, brick), d3_times(place->pane, d3(0.015, 0.02, 0.025)));
}

static void look_at_ground(struct place *place)
{
    double x = 3.0 - fabs(place->local.x), z = 3.0 - fabs(place->local.z);
    double wide = place->width / place->facing;
    double dash = (z >= 0.75 ? 1.0 : 0.0) * cover(0.025 - x, place->width);
    dash *= mixed(stripes(place->local.z / 0.75, 0.5, wide / 0.75), 0.5,
                  mirror_smoothstep(0.4, 1.0, wide / 0.75));
    place->asphalt = cover(0.72 - fmin(x, z), wide);
    struct d3 road = d3(0.06 + 0.5 * dash, 0.062 + 0.5 * dash, 0.07 + 0.5 * dash);
    place->colour = d3_add(d3_times(1.0 - place->asphalt, d3(0.27, 0.25, 0.23)),
                           d3_times(place->asphalt, road));
}

static struct d3 light_of(const struct place *place, struct d3 direction, double seen,
                          struct d3 sun, struct d3 sky)
{
    struct d3 n = place->normal, to_light = sun.y > 0.0 ? sun : d3_times(-1.0, sun);
    struct d3 to_lamp = d3_sub(lamp_at, place->q), around = around_of(sun), direct = direct_of(sun);
    double dusk = 1.0 - mirror_smoothstep(-0.02, 0.12, sun.y);
    double catches = dusk * mirror_lambert(n, d3_unit(to_lamp)) / (0.1 + d3_dot(to_lamp, to_lamp));
    struct d3 ambient = d3_times(0.6 + 0.4 * n.y, d3_add(around, d3_times(0.1, direct)));
    struct d3 received = d3_add(d3_times(seen * mirror_lambert(n, to_light), direct), ambient);
    received = d3_add(received, d3_times(0.08 * catches, lamplight));
    struct d3 light = d3_product(place->colour, received);
    double fresnel = 0.04 + 0.96 * pow(1.0 - place->facing, 4.0);
    struct d3 mirror = d3_sub(direction, d3_times(2.0 * d3_dot(n, direction), n));
    double glint = 0.5 * place->asphalt * seen * glow(d3_dot(mirror, to_light), 0.75);
    struct d3 mirrored = fabs(n.x) > 0.5 ? sky : d3_times(0.7, around);
    light = d3_add(light, place->ground ? d3_times(fresnel * glint, direct)
                                        : d3_times(fresnel * place->pane, mirrored));
    return d3_add(light, d3_times(0.25 * place->pane * place->lit, lamplight));
}

// The normal of a tower's face at p: of the part on which p lies.
static struct d3 face_at(const struct place *place)
{
    bool base = place->p.y < place->tower.base_height + 0.01;
    double x = fabs(place->local.x) - (base ? place->tower.base : place->tower.shaft_x);
    double y = place->p.y - (base ? place->tower.base_height : place->tower.shaft_height);
    double z = fabs(place->local.z) - (base ? place->tower.base : place->tower.shaft_z);
    if (y > fmax(x, z))
        return d3(0.0, 1.0, 0.0);
    return x > z ? d3(place->local.x > 0.0 ? 1.0 : -1.0, 0.0, 0.0)
                 : d3(0.0, 0.0, place->local.z > 0.0 ? 1.0 : -1.0);
}

static struct d3 shown(struct d3 light, struct d3 sun)
{
    double eye = 0.95 / sqrt(around_of(sun).y + 0.02), v[3] = {light.x, light.y, light.z};
    for (int i = 0; i < 3; i++) {
        double x = eye * v[i];
        v[i] = mirror_encode(1.0 - 1.0 / (1.0 + x + x * x));
    }
    return d3(v[0], v[1], v[2]);
}

// Towers and ground alone are computed here; a pixel on a lamp or a tree is named, and black.
struct mirror_sample city_sample(const struct mirror_eye *eye, double hour)
{
    struct mirror_ray ray = mirror_screen_ray(&eye->camera, MIRROR_FOCAL_LENGTH, eye->x, eye->y);
    struct d3 sun = city_sun(hour), direction = ray.direction, o = ray.origin;
    struct d3 sky = city_sky(d3(direction.x, fmax(direction.y, 0.0), direction.z), sun);
    double end = direction.y > 0.0 ? (9.3 - o.y) / direction.y : -o.y / direction.y;
    struct mirror_march march = mirror_reach(&city_scene, ray, 0.0, fmin(end, FAR));
    struct mirror_sample sample = {.what = "sky",
                                   .colour = shown(sky_with_sun(sky, direction, sun), sun)};
    if (march.end != MIRROR_HIT && (direction.y > 0.0 || end > FAR))
        return sample;
    double t = march.end == MIRROR_HIT ? march.t : end;
    int nearest = 0;
    struct place place = {.p = mirror_at(ray, t), .ground = march.end != MIRROR_HIT};
    city_distance(place.p, &nearest);
    if (!place.ground && nearest > 0)
        return (struct mirror_sample){.what = nearest == 1 ? "lamp" : "tree"};
    int x = (int)floor(place.p.x / 6.0 + 0.5), z = (int)floor(place.p.z / 6.0 + 0.5);
    place.tower = city_tower_of(x, z);
    place.local = d3_sub(place.p, d3(6.0 * x, 0.0, 6.0 * z));
    place.q = d3(fabs(place.local.x) - 2.1, place.local.y, place.local.z);
    place.width = WIDTH * t;
    place.normal = place.ground ? d3(0.0, 1.0, 0.0) : face_at(&place);
    place.facing = fmax(fabs(d3_dot(place.normal, direction)), 0.03);
    if (place.ground)
        look_at_ground(&place);
    else
        look_at_wall(&place, sun);
    struct d3 to_light = sun.y > 0.0 ? sun : d3_times(-1.0, sun);
    struct mirror_ray up = {d3_add(place.p, d3_times(0.03 + place.width, place.normal)), to_light};
    double far = fmin(18.0, (9.3 - place.p.y) / to_light.y);
    sample.faces = d3_dot(place.normal, to_light) > 0.02;
    sample.shadowed =
        sample.faces && mirror_march(&city_scene, up, 0.0, far, 0.01, 64).end != MIRROR_PASSED;
    struct d3 light = light_of(&place, direction, sample.shadowed ? 0.0 : 1.0, sun, sky);
    double clear = exp(-0.0006 * t * t);
    light = d3_add(d3_times(clear, light), d3_times(1.0 - clear, sky));
    sample.what = place.ground ? (place.asphalt > 0.5 ? "road" : "pavement")
                               : (place.pane > 0.5 ? "window" : "wall");
    sample.colour = shown(light, sun);
    return sample;
}
