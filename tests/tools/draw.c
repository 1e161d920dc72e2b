// draw [BACKEND [FOLDER]] - draws pictures of tests/pictures/images.txt, many in one context, and
// compares them with their references.
//
// Each line of standard input is NAME [ROOT]: a picture, and the folder of the project whose
// shaders draw it, "." by default. As soon as the result is known, one line is printed: 'same' or
// 'other', NAME and the numbers that compare prints; or, if the picture cannot be drawn, written or
// compared, 'none' and NAME, with the reason on standard error. With FOLDER, each picture is
// written there as NAME.BACKEND.png.
//
// The options of a picture mean the same here as in the programs.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "command/run.h"
#include "memory.h"
#include "report.h"
#include "lib/compare.h"
#include "lib/programs.h"

enum { WORDS = 64, LINE = 4096 };

// A line of tests/pictures/images.txt: the stem of its program, and a command line with its
// options.
struct listed {
    char line[LINE], stem[LINE];
    char *word[WORDS]; // a command line that ends with NULL
    int count;
};

static bool read_line(struct listed *listed, const char *name)
{
    static const char blank[] = " \t\n";
    char own[2 * LINE];
    char *rest, *stem = strtok_r(listed->line, blank, &rest);
    const char *variant = stem != NULL ? strtok_r(NULL, blank, &rest) : NULL;
    if (variant == NULL || stem[0] == '#')
        return false;
    bool first = strcmp(variant, "-") == 0;
    snprintf(own, sizeof own, "%s%s%s", stem, first ? "" : "-", first ? "" : variant);
    if (strcmp(own, name) != 0)
        return false;
    snprintf(listed->stem, sizeof listed->stem, "%s", stem);
    while (listed->count < WORDS - 1 &&
           (listed->word[listed->count] = strtok_r(NULL, blank, &rest)) != NULL)
        listed->count++;
    listed->word[listed->count] = NULL;
    return true;
}

// Find a picture's line, and turn it into the command line of a program that writes the picture to
// output. Returns false after reporting the error.
static bool find_picture(struct listed *listed, const char *name, char *output)
{
    FILE *file = fopen("tests/pictures/images.txt", "r");
    bool found = false;
    while (file != NULL && !found && fgets(listed->line, LINE, file) != NULL) {
        listed->count = 0;
        listed->word[listed->count++] = "draw";
        listed->word[listed->count++] = "-o";
        listed->word[listed->count++] = output;
        found = read_line(listed, name);
    }
    if (file != NULL)
        fclose(file);
    return found || report("tests/pictures/images.txt: no picture %s", name);
}

// Draw a picture. The current folder must be the project's, because the paths in the options are
// relative to it.
static bool draw(const struct context *context, struct run *run, struct image *image)
{
    struct renderer *renderer = &run->picture[0].renderer;
    struct renderer_inputs inputs = run_still_inputs(&run->options);
    struct renderer_eye eye;
    bool probes = run->options.has_overlay && run->options.probe_count > 0;
    struct probe *probe = probes ? memory_zeros(1, sizeof *probe) : NULL;
    snprintf(run->root, sizeof run->root, ".");
    bool done =
        run_find_shader(run) && run_read_shaders(run) == RUN_DONE && run_compile(run, &context->gl);
    if (done)
        run_start_ray(&run->options, renderer, &inputs, &eye);
    done =
        done &&
        (!probes || renderer_probe(renderer, &inputs, inputs.pixel[0], inputs.pixel[1], probe)) &&
        run_draw(run, &inputs, probe, image);
    free(probe);
    return done;
}

// Draw a picture with the shaders of the project in the folder root.
static bool draw_in(const struct context *context, const char *name, const char *root,
                    struct image *image)
{
    static struct listed listed;
    struct chapter chapter;
    struct run run = {0};
    char here[PLATFORM_PATH], output[] = "picture.png";
    if (!find_picture(&listed, name, output) || !programs_find(listed.stem, &chapter) ||
        !run_parse(&run, chapter.stem, chapter.title, &chapter.camera, chapter.tool, listed.count,
                   listed.word))
        return false;
    bool alone = run.options.frames == 0;
    bool moved = alone && getcwd(here, sizeof here) != NULL && chdir(root) == 0;
    bool done =
        moved ? draw(context, &run, image)
              : report("%s: cannot be drawn in %s: it is a sequence, or there is no such folder",
                       name, root);
    run_close(&run);
    return (!moved || chdir(here) == 0) && done;
}

// Draw a picture, compare it with its reference, and print the result.
static void answer(const struct context *context, const char *name, const char *root,
                   const char *backend, const char *folder)
{
    struct image drawn = {0}, stored = {0};
    struct image_difference difference;
    char path[2 * PLATFORM_PATH];
    bool done = draw_in(context, name, root, &drawn);
    if (done && folder != NULL) {
        snprintf(path, sizeof path, "%s/%s.%s.png", folder, name, backend);
        done = image_write_png(&drawn, path);
    }
    snprintf(path, sizeof path, "tests/references/%s.png", name);
    if (done && image_read_png(&stored, path) && image_compare(&stored, &drawn, &difference)) {
        printf("%s %s ", image_same(&difference) ? "same" : "other", name);
        image_print_difference(&difference);
    } else {
        printf("none %s\n", name);
    }
    fflush(stdout);
    image_free(&drawn);
    image_free(&stored);
}

int main(int argc, char **argv)
{
    struct context context = {0};
    enum context_backend backend = CONTEXT_ANY;
    char line[LINE], *rest;
    if ((argc > 1 && !context_backend_from_name(argv[1], &backend)) ||
        !context_open_offscreen(&context, backend))
        return RUN_NOT_DONE;
    while (fgets(line, sizeof line, stdin) != NULL) {
        const char *name = strtok_r(line, " \n", &rest);
        const char *root = name != NULL ? strtok_r(NULL, " \n", &rest) : NULL;
        if (name != NULL)
            answer(&context, name, root != NULL ? root : ".", argc > 1 ? argv[1] : "",
                   argc > 2 ? argv[2] : NULL);
    }
    context_close(&context);
    return RUN_DONE;
}
