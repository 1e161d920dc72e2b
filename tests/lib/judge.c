#include "lib/judge.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lib/compare.h"

#define RAYS 16 // at most this many rays are compared
// A hit that is off by more than this share of 1 + t is a different hit.
#define FAR 0.02

static struct {
    char text[1024], pixel[32];
    struct image_difference difference;
} judge;

// ---- Pictures ----

static const char *part_of(int x, int y, int width, int height)
{
    static const char *const parts[3][3] = {
        {"at the lower left", "at the bottom", "at the lower right"},
        {"on the left", "in the middle", "on the right"},
        {"at the upper left", "at the top", "at the upper right"}};
    int row = 3 * y < height ? 0 : 3 * y < 2 * height ? 1 : 2;
    int column = 3 * x < width ? 0 : 3 * x < 2 * width ? 1 : 2;
    return parts[row][column];
}

const char *judge_picture(const char *with, int width, int height, const unsigned char *right,
                          const unsigned char *mine, unsigned char *shown)
{
    const struct image a = {width, height, (unsigned char *)right};
    const struct image b = {width, height, (unsigned char *)mine};
    struct image_difference *difference = &judge.difference;
    struct image picture = {0};
    char words[256];
    image_compare(&a, &b, difference);
    snprintf(judge.pixel, sizeof judge.pixel, "%d,%d", difference->x, difference->y);
    if (shown != NULL && image_difference_picture(&a, &b, &picture))
        memcpy(shown, picture.pixel, 3 * (size_t)width * (size_t)height);
    image_free(&picture);
    if (image_same(difference))
        return "";
    image_difference_words(difference, words);
    snprintf(judge.text, sizeof judge.text, "%s%s%s%s, %s", with[0] != '\0' ? "with " : "", with,
             with[0] != '\0' ? ", " : "", words,
             part_of(difference->x, difference->y, width, height));
    return judge.text;
}

double judge_share(void)
{
    return judge.difference.f2;
}

const char *judge_pixel(void)
{
    return judge.pixel;
}

const char *judge_words(void)
{
    return image_difference_words(&judge.difference, judge.text);
}

// ---- Rays ----

struct march {
    bool recorded;
    double t;           // t of the last step
    char end[160];      // the last line of --probe without the "# "
    size_t outcome, at; // length of end up to the first ';', and up to the first ' ', ':' or ';'
};

// Read the next march that --probe printed. Returns the rest of the text, or NULL if there is no
// march.
static const char *read_march(const char *text, struct march *march)
{
    *march = (struct march){0};
    for (; text != NULL && *text != '\0';) {
        const char *end = strchr(text, '\n');
        size_t length = end != NULL ? (size_t)(end - text) : strlen(text);
        if (*text >= '0' && *text <= '9') {
            const char *comma = memchr(text, ',', length);
            march->recorded = comma != NULL;
            march->t = comma != NULL ? strtod(comma + 1, NULL) : 0.0;
        } else if (strncmp(text, "# ", 2) == 0) {
            snprintf(march->end, sizeof march->end, "%.*s", (int)length - 2, text + 2);
            march->recorded = march->recorded || strstr(march->end, "no march is") == NULL;
            march->outcome = strcspn(march->end, ";");
            march->at = strcspn(march->end, " ;:");
            return end != NULL ? end + 1 : text + length;
        }
        text += length + (end != NULL);
    }
    return NULL;
}

// Do both marches end in the same way and, if they hit the surface, at about the same distance?
static bool ends_alike(const struct march *a, const struct march *b)
{
    if (a->at != b->at || strncmp(a->end, b->end, a->at) != 0)
        return false;
    return strncmp(a->end, "hit", a->at) != 0 || fabs(a->t - b->t) < FAR * (1.0 + b->t);
}

static const char *refuse(const char *with, const char *why)
{
    snprintf(judge.text, sizeof judge.text, "the picture%s%s is right, but its rays are not: %s",
             with[0] != '\0' ? " with " : "", with, why);
    return judge.text;
}

const char *judge_rays(const char *with, const char *pixels, const char *right, const char *mine)
{
    struct march a, b;
    char first[512] = "", why[640];
    int count = 0, rays = 0, silent = 0;
    bool recorded = false;
    const char *at = right;
    while ((at = read_march(at, &a)) != NULL)
        recorded |= a.recorded;
    if (!recorded)
        return "";
    while (rays < RAYS && (right = read_march(right, &a)) != NULL) {
        mine = read_march(mine, &b);
        if (mine == NULL || !b.recorded)
            return refuse(with, "no ray is recorded: include main.glsl, as the chapter does");
        int length = (int)strcspn(pixels, " ");
        silent += strncmp(b.end, "no march", 8) == 0;
        if (!ends_alike(&b, &a) && count++ == 0)
            snprintf(first, sizeof first, "pixel %.*s: '%.*s' at t %g instead of '%.*s' at t %g",
                     length, pixels, (int)b.outcome, b.end, b.t, (int)a.outcome, a.end, a.t);
        pixels += length;
        pixels += strspn(pixels, " ");
        rays++;
    }
    static const char *const numbers[] = {"none", "one", "two",   "three", "four",
                                          "five", "six", "seven", "eight", "nine"};
    if (count < 2)
        return "";
    snprintf(why, sizeof why, "%s, and %d more of the %s rays%s", first, count - 1,
             rays < 10 ? numbers[rays] : "compared",
             silent == rays ? ": let your march call traceBegin, traceStep and traceMarch, as that "
                              "of march.glsl does"
                            : "");
    return refuse(with, why);
}

const char *judge_ray(const char *probe)
{
    struct march march;
    if (read_march(probe, &march) == NULL)
        return "";
    if (march.recorded)
        snprintf(judge.text, sizeof judge.text, "t %g, %s", march.t, march.end);
    else { // only the colour
        const char *colour = strstr(march.end, "colour: ");
        snprintf(judge.text, sizeof judge.text, "%s", colour != NULL ? colour : march.end);
    }
    return judge.text;
}

const char *judge_right(int pictures, double share)
{
    char most[64] = "no pixel differs";
    if (share >= 0.5e-6)
        snprintf(most, sizeof most, "at most %.4f %% of the pixels differ", 100.0 * share);
    snprintf(judge.text, sizeof judge.text,
             "matches the solution in %d picture%s: %s by more than 2 of 255", pictures,
             pictures == 1 ? "" : "s", most);
    return judge.text;
}
