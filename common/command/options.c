#include "command/options.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "report.h"
#include "command/sequence.h"

static bool refuse_unknown(const char *word, size_t length)
{
    return report("unknown option '%.*s': --help lists the options", (int)length, word);
}

int options_split(char *line, char *word[OPTIONS_WORDS + 1])
{
    static const char blanks[] = " \t\n";
    int count = 0;
    for (char *from = line; *(from += strspn(from, blanks)) != '\0'; count++) {
        char quote = '\0', *to = from;
        if (count == OPTIONS_WORDS) {
            report("a line has at most %d words", OPTIONS_WORDS);
            return -1;
        }
        word[count] = from;
        for (; *from != '\0' && (quote != '\0' || strchr(blanks, *from) == NULL); from++)
            if (*from == quote)
                quote = '\0';
            else if (quote == '\0' && (*from == '\'' || *from == '"'))
                quote = *from;
            else
                *to++ = *from;
        if (quote != '\0') {
            report("a quote, %c, is not closed", quote);
            return -1;
        }
        from += *from != '\0';
        *to = '\0';
    }
    word[count] = NULL;
    return count;
}

// Apply an option.
//   text  the value if it is in the same word as the option, otherwise NULL
//   next  the words that follow, ended by NULL; a value that is the next word is skipped
static bool apply(struct options *options, const struct options_row *row, const char *text,
                  char ***next)
{
    bool optional = strncmp(row->value, " [", 2) == 0;
    if (optional && text == NULL && **next != NULL && (**next)[0] != '-')
        text = *(*next)++;
    bool needs = row->value[0] == ' ' && !optional && text == NULL;
    if (needs && **next == NULL)
        report("--%s: a value is missing: see --help", row->name);
    else if (row->value[0] == '\0' && text != NULL)
        report("--%s: takes no value", row->name);
    else {
        // --help has priority, so that it can be added to any command line.
        if (row->action != OPTIONS_RUN && options->action != OPTIONS_HELP)
            options->action = row->action;
        return row->set == NULL || row->set(options, needs ? *(*next)++ : text);
    }
    return false;
}

// Read --name or --name=value.
static bool read_name(struct options *options, const char *word, char ***next)
{
    size_t length = strcspn(word, "=");
    for (const struct options_row *row = options_rows; row->name != NULL; row++)
        if (strlen(row->name) == length - 2 && strncmp(row->name, word + 2, length - 2) == 0)
            return apply(options, row, word[length] == '=' ? word + length + 1 : NULL, next);
    return refuse_unknown(word, length);
}

// Read -a, -avalue or -abc.
static bool read_letters(struct options *options, const char *letter, char ***next)
{
    for (; *letter != '\0'; letter++) {
        const struct options_row *row = options_rows;
        while (row->name != NULL && (row->letter[0] == '\0' || row->letter[1] != *letter))
            row++;
        if (row->name == NULL)
            return refuse_unknown((char[]){'-', *letter, '\0'}, 2);
        if (row->value[0] != '\0')
            return apply(options, row, letter[1] != '\0' ? letter + 1 : NULL, next);
        if (!apply(options, row, NULL, next))
            return false;
    }
    return true;
}

static bool read_words(struct options *options, char **next)
{
    while (*next != NULL) {
        const char *word = *next++;
        bool named = strncmp(word, "--", 2) == 0, last = named && word[2] == '\0';
        if (last && *next == NULL)
            return true;
        if (word[0] != '-' || word[1] == '\0' || last)
            return report("unexpected argument '%s': --help lists the options",
                          last ? *next : word);
        if (named ? !read_name(options, word, &next) : !read_letters(options, word + 1, &next))
            return false;
    }
    return true;
}

static bool check_probes(const struct options *options)
{
    for (int i = 0; i < options->probe_count; i++) {
        const int *pixel = options->probe[i];
        if (pixel[0] < 0 || pixel[0] >= options->width || pixel[1] < 0 ||
            pixel[1] >= options->height)
            return report("--probe '%s': outside the picture of %dx%d: X must be between 0 and "
                          "%d, Y between 0 and %d",
                          options->probe_text[i], options->width, options->height,
                          options->width - 1, options->height - 1);
    }
    return true;
}

// Check the options for the ray that a picture shows, in a view of its march or in the overlay.
static bool check_ray(const struct options *options)
{
    bool view = shader_shows_ray(options->view);
    bool overlaid = options->has_overlay && options->probe_count > 0;
    bool stepped = options->step >= 0 || options->walk;
    if (options->output == NULL &&
        (options->walk || options->has_from || (stepped && !options->window)))
        return report("--%s: requires --output; in a window, E and Q step along the ray",
                      stepped ? "step" : "from");
    if (stepped && !view && !overlaid)
        return report("--step: requires --view slice or plot, or --probe and --overlay");
    if (options->walk && options->frames == 0)
        return report("--step walk: requires --frames N");
    if (options->walk && options->first_frame > 0)
        return report(
            "--step walk: requires --frames N, because K-L does not tell how long the film is");
    if (options->frames > 0 && options->step >= 0)
        return report("--step %d: cannot be combined with --frames; use --step walk",
                      options->step);
    if (options->has_from && (view || !overlaid))
        return report("--from: requires --probe and --overlay, and cannot be combined with --view "
                      "slice or plot");
    return true;
}

static void set_defaults(struct options *options)
{
    options->window =
        options->output == NULL && options->probe_count == 0 && options->benchmark == 0;
    if (!options->has_divider)
        options->divider = 0.5;
    if (!options->compares)
        options->shared_settings = options->setting_count;
    if (options->width == 0) {
        options->width = options->window ? 960 : 640;
        options->height = options->window ? 540 : 360;
    }
}

// Set the defaults, and check what the options require of each other.
static bool complete(struct options *options)
{
    bool film = options->frames > 0, paced = options->fps > 0.0;
    set_defaults(options);
    if (options->benchmark > 0 && (options->output != NULL || options->probe_count > 0))
        report("--benchmark: cannot be combined with --%s",
               options->output != NULL ? "output" : "probe");
    else if ((options->has_divider || options->labels != NULL) && !options->compares)
        report("--%s: requires --compare", options->has_divider ? "divider" : "labels");
    else if (options->compares && options->compare == NULL &&
             options->shared_settings == options->setting_count)
        report("--compare: requires a shader's FILE, or --set NAME=VALUE after it");
    else if (options->compares &&
             (options->benchmark > 0 || options->action == OPTIONS_PRINT_SHADER))
        report("--compare: cannot be combined with --%s",
               options->benchmark > 0 ? "benchmark" : "print-shader");
    else if (film && options->has_frame)
        report("--frame: cannot be combined with --frames");
    else if (!film && !options->has_frame && paced)
        report("--fps: requires --frames N, or --frame N");
    else if (film && options->output == NULL)
        report("--frames: requires --output, as in -o frame-%%04d.png");
    else if (film && !sequence_is_name(options->output))
        report("--output '%s': with --frames, the name must contain one %%d for the number, as in "
               "frame-%%04d.png",
               options->output);
    else if (film && options->probe_count > 0 && !shader_shows_ray(options->view) && !options->walk)
        report("--probe: cannot be combined with --frames, except in the slice and plot views and "
               "with --step walk");
    else if (fabs(options->time) +
                 fmax(options->frames, options->frame) / (paced ? options->fps : OPTIONS_FPS) >
             OPTIONS_LIMIT)
        report("--%s: the last time must be between -1e9 and 1e9 seconds",
               film ? "frames" : "frame");
    else if ((options->shadertoy || options->page) && options->view != VIEW_PICTURE)
        report("--print-shader=%s: cannot be combined with --view %s: only the picture view runs "
               "%s",
               options->page ? "page" : "shadertoy", shader_view_name(options->view),
               options->page ? "in a page" : "on Shadertoy");
    else
        return check_probes(options) && check_ray(options);
    return false;
}

bool options_parse(struct options *options, int argc, char **argv)
{
    *options = (struct options){.samples = 1, .step = -1, .start.smooths = true};
    options->settings = memory_zeros((size_t)argc, sizeof *options->settings);
    options->probe = memory_zeros((size_t)argc, sizeof *options->probe);
    options->probe_text = memory_zeros((size_t)argc, sizeof *options->probe_text);
    options->textures = memory_zeros((size_t)argc, sizeof *options->textures);
    if (read_words(options, argv + (argc > 0)) && complete(options))
        return true;
    options_free(options);
    return false;
}

void options_free(struct options *options)
{
    free(options->settings);
    free(options->probe);
    free(options->probe_text);
    free(options->textures);
    strokes_free(&options->strokes);
    *options = (struct options){0};
}
