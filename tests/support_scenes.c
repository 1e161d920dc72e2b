// The scenes and the colours of chapters 00 to 03 and of the first steps, in double precision.
#include <stdio.h>
#include <string.h>

#include "support_mirror.h"

static const struct mirror_part parts_00[] = {
    {"frame", MIRROR_FRAME, {0.0, 0.0, 0.0}, {0.5, 0.5, 0.5}, 0.05},
    {"ball", MIRROR_SPHERE, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.3},
};

static const struct mirror_part parts_01[] = {
    {"frame", MIRROR_FRAME, {0.0, 0.0, 0.0}, {0.8, 0.8, 0.8}, 0.08},
    {"ball", MIRROR_SPHERE, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.52},
    {"orbit 0", MIRROR_SPHERE, {1.64, -0.15, -0.23}, {0.0, 0.0, 0.0}, 0.16},
    {"orbit 1", MIRROR_SPHERE, {1.33, -0.38, 1.00}, {0.0, 0.0, 0.0}, 0.20},
    {"orbit 2", MIRROR_SPHERE, {0.23, -0.38, 1.64}, {0.0, 0.0, 0.0}, 0.23},
    {"orbit 3", MIRROR_SPHERE, {-1.00, -0.17, 1.33}, {0.0, 0.0, 0.0}, 0.27},
    {"orbit 4", MIRROR_SPHERE, {-1.64, 0.15, 0.23}, {0.0, 0.0, 0.0}, 0.30},
    {"orbit 5", MIRROR_SPHERE, {-1.33, 0.38, -1.00}, {0.0, 0.0, 0.0}, 0.34},
    {"orbit 6", MIRROR_SPHERE, {-0.23, 0.38, -1.64}, {0.0, 0.0, 0.0}, 0.37},
    {"orbit 7", MIRROR_SPHERE, {1.00, 0.17, -1.33}, {0.0, 0.0, 0.0}, 0.41},
};

static const struct mirror_part parts_02[] = {
    {"stage", MIRROR_BOX, {0.0, -0.1, 0.0}, {2.6, 0.1, 2.2}, 0.0},
    {"frame", MIRROR_FRAME, {0.4, 0.8, -0.5}, {0.8, 0.8, 0.8}, 0.07},
    {"inside", MIRROR_SPHERE, {0.4, 0.8, -0.5}, {0.0, 0.0, 0.0}, 0.36},
    {"above", MIRROR_SPHERE, {0.4, 2.05, -0.5}, {0.0, 0.0, 0.0}, 0.28},
    {"resting", MIRROR_SPHERE, {1.75, 0.4, 1.2}, {0.0, 0.0, 0.0}, 0.4},
    {"block", MIRROR_BOX, {-1.6, 0.3, 0.1}, {0.35, 0.3, 0.55}, 0.0},
};

static const struct mirror_part parts_steps[] = {
    {"ball", MIRROR_SPHERE, {0.0, 0.0, -3.0}, {0.0, 0.0, 0.0}, 1.0},
    {"ground", MIRROR_PLANE, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, -1.0},
};

#define COUNT(array) ((int)(sizeof(array) / sizeof(array)[0]))

const struct mirror_scene mirror_scene_00 = {parts_00, COUNT(parts_00), NULL};
const struct mirror_scene mirror_scene_01 = {parts_01, COUNT(parts_01), NULL};
const struct mirror_scene mirror_scene_02 = {parts_02, COUNT(parts_02), NULL};
static const struct mirror_scene scene_steps = {parts_steps, COUNT(parts_steps), NULL};

const struct d3 mirror_low = {-2.65, -0.25, -2.25};
const struct d3 mirror_high = {2.65, 2.45, 2.25};

static const struct d3 report_sky = {0.5, 0.7, 1.0};

// What a ray meets: the part and where; false for the sky.
static bool look(const struct mirror_scene *scene, struct mirror_ray ray, double far,
                 struct mirror_sample *sample, struct d3 *p)
{
    struct mirror_march march = mirror_reach(scene, ray, 0.0, far);
    sample->what = "sky";
    if (march.end != MIRROR_HIT)
        return false;
    int nearest = 0;
    *p = mirror_at(ray, march.t);
    mirror_distance(scene, *p, &nearest);
    sample->what = scene->part[nearest].name;
    return true;
}

static struct mirror_ray camera_ray(const struct mirror_eye *eye)
{
    return mirror_screen_ray(&eye->camera, MIRROR_FOCAL_LENGTH, eye->x, eye->y);
}

// ---- First steps ----

static struct mirror_sample step_1(const struct mirror_eye *eye)
{
    return (struct mirror_sample){
        .colour = d3(mirror_clamp(0.5 + 0.5 * eye->x), mirror_clamp(0.5 + 0.5 * eye->y), 0.4),
        .what = "screen"};
}

static struct mirror_sample step_2(const struct mirror_eye *eye)
{
    double d = hypot(eye->x + 0.3, eye->y - 0.1) - 0.5;
    double turn = 10.0 * d + 0.5;
    double band = mirror_smoothstep(0.10, 0.14, fabs(turn - floor(turn) - 0.5));
    double shade = (0.35 + 0.65 * exp(-1.5 * fabs(d))) * (0.75 + 0.25 * band);
    double line = 1.0 - mirror_smoothstep(0.008, 0.016, fabs(d));
    struct d3 colour = d3_times(shade, d > 0.0 ? d3(0.95, 0.65, 0.30) : d3(0.25, 0.50, 0.85));
    struct d3 white = d3(1.0, 1.0, 1.0);
    return (struct mirror_sample){.colour =
                                      d3_add(d3_times(1.0 - line, colour), d3_times(line, white)),
                                  .what = line > 0.5 ? "circle" : (d > 0.0 ? "outside" : "inside")};
}

static struct mirror_sample step_3(const struct mirror_eye *eye)
{
    struct d3 direction = d3_unit(d3(eye->x, eye->y, -1.0));
    return (struct mirror_sample){
        .colour = d3(0.5 + 0.5 * direction.x, 0.5 + 0.5 * direction.y, -direction.z),
        .what = "ray"};
}

// These two steps go one distance on after they have found a hit; at the limit that is nothing.
static bool step_look(const struct mirror_eye *eye, struct mirror_sample *sample, struct d3 *p)
{
    struct mirror_ray ray = {{0.0, 0.0, 0.0}, d3_unit(d3(eye->x, eye->y, -1.5))};
    return look(&scene_steps, ray, 40.0, sample, p);
}

static struct mirror_sample step_4(const struct mirror_eye *eye)
{
    struct mirror_sample sample = {.colour = {0.0, 0.0, 0.0}};
    struct d3 p;
    if (step_look(eye, &sample, &p)) {
        double white = mirror_clamp(exp(-0.12 * (d3_length(p) - 2.0)));
        sample.colour = d3(white, white, white);
    }
    return sample;
}

static struct mirror_sample step_5(const struct mirror_eye *eye)
{
    struct mirror_sample sample = {.colour = report_sky};
    struct d3 p;
    if (step_look(eye, &sample, &p)) {
        double light =
            mirror_lambert(mirror_normal(&scene_steps, p), d3_unit(d3_sub(d3(-2.5, 2.5, -0.5), p)));
        sample.colour = d3_times(0.1 + 0.9 * light, d3(1.0, 0.9, 0.7));
        sample.faces = light > 0.0;
    }
    return sample;
}

// ---- Chapters ----

static struct mirror_sample chapter_00(const struct mirror_eye *eye)
{
    double turn = 0.5 * eye->time;
    struct d3 origin = d3(1.8 * sin(turn), 1.0, 1.8 * cos(turn));
    struct d3 forward = d3_unit(d3_times(-1.0, origin));
    struct d3 right = d3_unit(d3_cross(forward, d3(0.0, 1.0, 0.0)));
    struct d3 up = d3_cross(right, forward);
    struct d3 direction =
        d3_add(d3_add(d3_times(eye->x, right), d3_times(eye->y, up)), d3_times(1.8, forward));
    struct mirror_sample sample = {.colour = report_sky};
    struct d3 p;
    if (look(&mirror_scene_00, (struct mirror_ray){origin, d3_unit(direction)}, 20.0, &sample,
             &p)) {
        double light =
            mirror_lambert(mirror_normal(&mirror_scene_00, p), d3_unit(d3(1.0, 2.0, 3.0)));
        sample.colour = d3_times(0.15 + 0.85 * light, d3(1.0, 0.9, 0.5));
        sample.faces = light > 0.0;
    }
    return sample;
}

static struct mirror_sample chapter_01(const struct mirror_eye *eye)
{
    struct mirror_sample sample = {.colour = report_sky};
    struct d3 p;
    if (look(&mirror_scene_01, camera_ray(eye), MIRROR_FAR, &sample, &p)) {
        struct d3 n = mirror_normal(&mirror_scene_01, p);
        sample.colour = d3(mirror_clamp(n.x), mirror_clamp(n.y), mirror_clamp(n.z));
    }
    return sample;
}

struct d3 mirror_lamp(double time)
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

// Is the lamp hidden from a point of the surface? A ray to the lamp and no farther.
static bool hidden(struct d3 p, struct d3 normal, struct d3 lamp)
{
    struct d3 start = d3_add(p, d3_times(1e-6, normal));
    struct d3 to_lamp = d3_sub(lamp, p);
    struct mirror_ray ray = {start, d3_unit(to_lamp)};
    return mirror_reach(&mirror_scene_02, ray, 0.0, d3_length(to_lamp)).end == MIRROR_HIT;
}

static struct mirror_sample lit_stage(const struct mirror_eye *eye, bool shadows)
{
    struct mirror_ray ray = camera_ray(eye);
    struct mirror_sample sample = {0};
    struct d3 p, light = dark_sky(ray.direction);
    if (look(&mirror_scene_02, ray, MIRROR_FAR, &sample, &p)) {
        struct d3 normal = mirror_normal(&mirror_scene_02, p), lamp = mirror_lamp(eye->time);
        struct d3 warm = lamp_light(p, normal, lamp, d3(1.0, 0.72, 0.45));
        struct d3 cold = lamp_light(p, normal, d3(-5.0, 3.0, 4.0), d3(0.06, 0.14, 0.3));
        sample.faces = warm.x > 0.0;
        sample.shadowed = shadows && sample.faces && hidden(p, normal, lamp);
        light = d3_add(d3(0.012, 0.02, 0.035), cold);
        if (!sample.shadowed)
            light = d3_add(light, warm);
        light = d3_product(d3(0.95, 0.9, 0.85), light);
    }
    sample.colour = d3(mirror_encode(light.x), mirror_encode(light.y), mirror_encode(light.z));
    return sample;
}

static struct mirror_sample chapter_02(const struct mirror_eye *eye)
{
    return lit_stage(eye, false);
}

static struct mirror_sample chapter_03(const struct mirror_eye *eye)
{
    return lit_stage(eye, true);
}

// ---- The list ----

#define STEP(name) "chapters/first_steps/" name ".frag"

const struct mirror_picture mirror_pictures[] = {
    {"1_screen", STEP("1_screen"), "00_first_scene", 0.0, step_1},
    {"2_distance", STEP("2_distance"), "00_first_scene", 0.0, step_2},
    {"3_ray", STEP("3_ray"), "00_first_scene", 0.0, step_3},
    {"4_march", STEP("4_march"), "00_first_scene", 0.0, step_4},
    {"5_light", STEP("5_light"), "00_first_scene", 0.0, step_5},
    {"00_first_scene", "chapters/00_first_scene.frag", "00_first_scene", 1.0, chapter_00},
    {"01_normal_colouring", "chapters/01_normal_colouring.frag", "01_normal_colouring", 0.0,
     chapter_01},
    {"02_lighting", "chapters/02_lighting.frag", "02_lighting", 0.0, chapter_02},
    {"03_shadows", "chapters/03_shadows.frag", "03_shadows", 0.0, chapter_03},
};

const int mirror_picture_count = COUNT(mirror_pictures);

const struct mirror_picture *mirror_find(const char *name)
{
    for (int i = 0; i < mirror_picture_count; i++)
        if (strcmp(mirror_pictures[i].name, name) == 0)
            return &mirror_pictures[i];
    return NULL;
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
