// judge - makes the functions of judge.h available to a shell. MINE is a reader's answer, RIGHT the
// solution; WITH and PIXELS are described in judge.h.
//
//   judge picture WITH RIGHT.png MINE.png DIFFERENCE.png
//       Prints the position and the share of the difference and, if MINE is wrong, what is wrong
//       with it, each on a line; if MINE is wrong, and has the right size, also writes DIFFERENCE.
//   judge rays WITH PIXELS RIGHT MINE
//       Prints what is wrong with the rays of MINE. Both files are outputs of --probe.
//   judge ray PROBE
//       Prints a march in words, from an output of --probe.
//   judge pixel X,Y PICTURE.png
//       Prints the colour of a pixel; 0,0 is at the bottom left.
//   judge right SHARE...
//       Prints the sentence for a right answer. Each SHARE is the judge_share of one of its
//       pictures.
//
// Exit status: 0 if the answer is right, 1 if it is wrong, 2 if it could not be judged.
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "platform.h"
#include "report.h"
#include "shader/text_file.h"
#include "lib/compare.h"
#include "lib/judge.h"

enum { RIGHT = 0, WRONG = 1, NOT_JUDGED = 2 };

static int say(const char *words)
{
    if (words[0] != '\0')
        puts(words);
    return words[0] != '\0' ? WRONG : RIGHT;
}

static int judge_files(const char *with, char **path)
{
    struct image right = {0}, mine = {0}, shown = {0};
    int status = NOT_JUDGED;
    if (image_read_png(&right, path[0]) && image_read_png(&mine, path[1])) {
        if (right.width != mine.width || right.height != mine.height) {
            printf("0,0\n1\n%s%s%sthe picture has %dx%d pixels instead of %dx%d\n",
                   with[0] != '\0' ? "with " : "", with, with[0] != '\0' ? ", " : "", mine.width,
                   mine.height, right.width, right.height);
            status = WRONG;
        } else if (image_create(&shown, right.width, right.height)) {
            const char *words = judge_picture(with, right.width, right.height, right.pixel,
                                              mine.pixel, shown.pixel);
            printf("%s\n%.9f\n", judge_pixel(), judge_share());
            status = say(words);
            if (status == WRONG && !image_write_png(&shown, path[2]))
                status = NOT_JUDGED;
        }
    }
    image_free(&shown);
    image_free(&right);
    image_free(&mine);
    return status;
}

// Read a file, up to 4 MiB. The caller frees the text. Returns NULL after reporting the error.
static char *read_text(const char *path)
{
    enum { MOST = 1 << 22 };
    char why[TEXT_FILE_WHY];
    FILE *file = text_file_open(path, why);
    if (file == NULL) {
        report("%s: %s", path, why);
        return NULL;
    }
    char *text = memory_zeros(MOST, 1);
    fread(text, 1, MOST - 1, file);
    if (ferror(file)) {
        report("%s: cannot be read: %s", path, platform_why(errno));
        free(text);
        text = NULL;
    }
    fclose(file);
    return text;
}

static int judge_texts(const char *with, const char *pixels, const char *right, const char *mine)
{
    char *a = read_text(right), *b = read_text(mine);
    int status = a != NULL && b != NULL ? say(judge_rays(with, pixels, a, b)) : NOT_JUDGED;
    free(a);
    free(b);
    return status;
}

static int print_ray(const char *path)
{
    char *text = read_text(path);
    if (text != NULL)
        say(judge_ray(text));
    free(text);
    return text != NULL ? RIGHT : NOT_JUDGED;
}

static int print_pixel(const char *pixel, const char *path)
{
    struct image image = {0};
    int x = -1, y = -1, status = NOT_JUDGED;
    if (image_read_png(&image, path)) {
        if (sscanf(pixel, "%d,%d", &x, &y) != 2 || x < 0 || y < 0 || x >= image.width ||
            y >= image.height)
            report("%s: not a pixel of a picture of %dx%d", pixel, image.width, image.height);
        else {
            const unsigned char *p =
                image.pixel +
                3 * ((size_t)(image.height - 1 - y) * (size_t)image.width + (size_t)x);
            printf("colour: %d, %d, %d\n", p[0], p[1], p[2]);
            status = RIGHT;
        }
    }
    image_free(&image);
    return status;
}

int main(int argc, char **argv)
{
    const char *what = argc > 1 ? argv[1] : "";
    if (argc == 6 && strcmp(what, "picture") == 0)
        return judge_files(argv[2], argv + 3);
    if (argc == 6 && strcmp(what, "rays") == 0)
        return judge_texts(argv[2], argv[3], argv[4], argv[5]);
    if (argc == 3 && strcmp(what, "ray") == 0)
        return print_ray(argv[2]);
    if (argc == 4 && strcmp(what, "pixel") == 0)
        return print_pixel(argv[2], argv[3]);
    if (argc > 2 && strcmp(what, "right") == 0) {
        double most = 0.0;
        for (int i = 2; i < argc; i++)
            most = fmax(most, strtod(argv[i], NULL));
        puts(judge_right(argc - 2, most));
        return RIGHT;
    }
    report("usage: judge picture WITH RIGHT.png MINE.png DIFFERENCE.png | rays WITH PIXELS "
           "RIGHT MINE | ray PROBE | pixel X,Y PICTURE.png | right SHARE...");
    return NOT_JUDGED;
}
