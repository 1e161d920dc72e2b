// The scene of chapters 02 and 03 and the colours of chapter 03, in double precision.
#include <stdio.h>
#include <string.h>

#include "lib/mirror.h"

static const struct mirror_part parts_02[] = {
    {"stage", MIRROR_BOX, {0.0, -0.1, 0.0}, {2.6, 0.1, 2.2}, 0.0},
    {"frame", MIRROR_FRAME, {0.4, 0.8, -0.5}, {0.8, 0.8, 0.8}, 0.07},
    {"inside", MIRROR_SPHERE, {0.4, 0.8, -0.5}, {0.0, 0.0, 0.0}, 0.36},
    {"above", MIRROR_SPHERE, {0.4, 2.05, -0.5}, {0.0, 0.0, 0.0}, 0.28},
    {"resting", MIRROR_SPHERE, {1.75, 0.4, 1.2}, {0.0, 0.0, 0.0}, 0.4},
    {"block", MIRROR_BOX, {-1.6, 0.3, 0.1}, {0.35, 0.3, 0.55}, 0.0},
};

#define COUNT(array) ((int)(sizeof(array) / sizeof(array)[0]))

const struct mirror_scene mirror_scene_02 = {parts_02, COUNT(parts_02), NULL};

static struct d3 mirror_lamp(double time)
{
    double angle = (35.0 + 20.0 * time) * MIRROR_PI / 180.0;
    return d3(4.2 * cos(angle), 4.6, -4.2 * sin(angle));
}

static struct d3 lamp_light(struct d3 p, struct d3 normal, struct d3 lamp, struct d3 colour)
{
    struct d3 to_lamp = d3_sub(lamp, p);
    double distance = d3_length(to_lamp);
    return d3_times(mirror_lambert(normal, d3_unit(to_lamp)) * mirror_fall_off(distance, 6.0),
                    colour);
}

static struct d3 dark_sky(struct d3 direction)
{
    double s = mirror_smoothstep(-0.5, 0.3, direction.y);
    return d3_add(d3_times(1.0 - s, d3(0.030, 0.075, 0.11)), d3_times(s, d3(0.003, 0.007, 0.018)));
}

// Is the lamp hidden from a point of the surface? The ray ends at the lamp.
static bool hidden(struct d3 p, struct d3 normal, struct d3 lamp)
{
    struct d3 start = d3_add(p, d3_times(1e-6, normal));
    struct d3 to_lamp = d3_sub(lamp, p);
    struct mirror_ray ray = {start, d3_unit(to_lamp)};
    return mirror_reach(&mirror_scene_02, ray, 0.0, d3_length(to_lamp)).end == MIRROR_HIT;
}

struct mirror_sample mirror_stage(const struct mirror_eye *eye)
{
    struct mirror_ray ray = mirror_screen_ray(&eye->camera, MIRROR_FOCAL_LENGTH, eye->x, eye->y);
    struct mirror_march march = mirror_reach(&mirror_scene_02, ray, 0.0, MIRROR_FAR);
    struct mirror_sample sample = {.what = "sky"};
    struct d3 light = dark_sky(ray.direction);
    if (march.end == MIRROR_HIT) {
        int nearest = 0;
        struct d3 p = mirror_at(ray, march.t), lamp = mirror_lamp(eye->time);
        mirror_distance(&mirror_scene_02, p, &nearest);
        struct d3 normal = mirror_normal(&mirror_scene_02, p);
        struct d3 warm = lamp_light(p, normal, lamp, d3(1.0, 0.72, 0.45));
        struct d3 cold = lamp_light(p, normal, d3(-5.0, 3.0, 4.0), d3(0.06, 0.14, 0.3));
        sample.what = parts_02[nearest].name;
        sample.faces = warm.x > 0.0;
        sample.shadowed = sample.faces && hidden(p, normal, lamp);
        light = d3_add(d3(0.012, 0.02, 0.035), cold);
        if (!sample.shadowed)
            light = d3_add(light, warm);
        light = d3_product(d3(0.95, 0.9, 0.85), light);
    }
    sample.colour = d3(mirror_encode(light.x), mirror_encode(light.y), mirror_encode(light.z));
    return sample;
}

bool mirror_camera(const char *root, const char *stem, struct camera *camera)
{
    char path[4096], text[8192];
    snprintf(path, sizeof path, "%s/chapters/%s.c", root, stem);
    FILE *file = fopen(path, "rb");
    if (file == NULL)
        return false;
    size_t length = fread(text, 1, sizeof text - 1, file);
    fclose(file);
    text[length] = '\0';
    const char *at = strstr(text, ".camera = {.position = {");
    struct camera read = {0};
    bool found = at != NULL && sscanf(at, ".camera = {.position = {%ff, %ff, %ff}",
                                      &read.position[0], &read.position[1], &read.position[2]) == 3;
    const char *pan = found ? strstr(at, ".pan = ") : NULL;
    if (pan != NULL)
        found = sscanf(pan, ".pan = %ff, .tilt = %ff", &read.pan, &read.tilt) == 2;
    *camera = read;
    return found;
}
