#include "command/lecture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "platform.h"
#include "report.h"
#include "window/watch.h"

struct scene {
    int line;                      // its line number in the list
    int part;                      // index of its part, from 1; 0 if no part has begun yet
    const char *text;              // its line in the list: the chapter and the options
    char *word[OPTIONS_WORDS + 1]; // argv; the strings are in words
    char *words;                   // owned
    char *sentence;                // in the list, like text; NULL if there is none
    char *end;                     // the end of the sentence
    char *caption;                 // its number and sentence, owned; NULL in a course
    struct run run;                // its options, and its pictures if they are compiled
    struct window_start start;
};

struct lecture {
    const char *path;
    char *text;          // the list, in which each line ends with '\0'
    struct scene *scene; // owned
    int count;
    const char **part; // names, which are in text; the array is owned
    int parts;
    struct context context;
    struct window *window;    // NULL until it is open
    bool notes;               // the sentences are only printed
    int at;                   // the scene that the speaker has reached
    int shown;                // the scene that is shown; differs from at if scene[at] has failed
    int tried;                // the last scene that compile_ahead has tried to compile
    struct watch failed;      // the files of scene[at], if it has failed
    struct contents contents; // of a course; its items are owned
};

// ---- The list ----

// Find a chapter by its number or stem: "03", "3" or "03_shadows". Returns NULL after reporting the
// error.
static const struct lecture_chapter *find(const struct lecture_chapter *chapters, int count,
                                          const char *name)
{
    size_t length = strlen(name);
    for (int i = 0; i < count; i++) {
        const char *stem = chapters[i].stem;
        if (strcmp(stem, name) == 0 ||
            (length == 2 && strncmp(stem, name, 2) == 0 && stem[2] == '_') ||
            (length == 1 && stem[0] == '0' && stem[1] == name[0]))
            return &chapters[i];
    }
    report("'%s': no such chapter: a scene begins with a chapter's number, as in 03 --view steps; "
           "a sentence begins with a blank",
           name);
    return NULL;
}

static int read_scene(struct scene *scene, const struct lecture_chapter *chapters, int count)
{
    scene->words = memory_text("%s", scene->text);
    int words = options_split(scene->words, scene->word);
    const struct lecture_chapter *chapter =
        words > 0 ? find(chapters, count, scene->word[0]) : NULL;
    if (chapter == NULL || !run_parse(&scene->run, chapter->stem, chapter->title, &chapter->camera,
                                      chapter->tool, words, scene->word))
        return RUN_WRONG_COMMAND_LINE;
    const struct options *options = &scene->run.options;
    if (options->action != OPTIONS_RUN || !options->window) {
        report("a scene is shown in a window: --output, --probe, --benchmark, --list, "
               "--print-shader, --help and --version have no meaning here");
        return RUN_WRONG_COMMAND_LINE;
    }
    return run_find_root(&scene->run) && run_find_shader(&scene->run) ? RUN_DONE : RUN_NOT_DONE;
}

static void add_part(struct lecture *lecture, const char *name)
{
    lecture->part = memory_row(lecture->part, lecture->parts, sizeof *lecture->part);
    lecture->part[lecture->parts++] = name + strspn(name, " \t");
}

// Returns false after reporting the error.
static bool add_scene(struct lecture *lecture, int line, const char *text)
{
    if (lecture->count == LECTURE_SCENES)
        return report("a lecture has at most %d scenes: split the list", LECTURE_SCENES);
    lecture->scene = memory_row(lecture->scene, lecture->count, sizeof *lecture->scene);
    lecture->scene[lecture->count++] =
        (struct scene){.line = line, .part = lecture->parts, .text = text};
    return true;
}

// Add a line to the sentence of the last scene. Returns false after reporting the error.
static bool add_sentence(struct lecture *lecture, char *text)
{
    if (lecture->count == 0)
        return report("a sentence without a scene: a scene's line must not begin with a blank");
    struct scene *scene = &lecture->scene[lecture->count - 1];
    size_t length = strlen(text);
    if (scene->sentence == NULL) {
        scene->sentence = scene->end = text;
    } else { // the line moves towards the beginning of the list, behind the line before it
        *scene->end++ = ' ';
        memmove(scene->end, text, length + 1);
    }
    scene->end += length;
    return true;
}

// Begin all further messages with the list's name and this line number.
static void begin_line(const struct lecture *lecture, int line)
{
    char location[1024];
    snprintf(location, sizeof location, "%.900s:%d", lecture->path, line);
    report_location(location);
}

// Sort the lines of the text into parts, scenes and sentences.
static int read_lines(struct lecture *lecture)
{
    char *next = lecture->text;
    for (int line = 1; *next != '\0'; line++) {
        char *text = next, *end = strchr(next, '\n');
        next = end + 1;
        *end = '\0';
        while (end > text && strchr(" \t", end[-1]) != NULL)
            *--end = '\0';
        begin_line(lecture, line);
        size_t blank = strspn(text, " \t");
        if (text[blank] == '\0' || text[blank] == '#')
            continue;
        if (blank > 0 && !add_sentence(lecture, text + blank))
            return RUN_WRONG_COMMAND_LINE;
        if (blank == 0 && strncmp(text, "==", 2) == 0)
            add_part(lecture, text + 2);
        else if (blank == 0 && !add_scene(lecture, line, text))
            return RUN_WRONG_COMMAND_LINE;
    }
    report_location(NULL);
    if (lecture->count > 0)
        return RUN_DONE;
    report("%s: contains no scene: a scene is a line such as 03 --set shadowOffset=0.25",
           lecture->path);
    return RUN_WRONG_COMMAND_LINE;
}

int lecture_read(struct lecture **lecture, const char *path, const struct lecture_chapter *chapters,
                 int count)
{
    char why[TEXT_FILE_WHY];
    struct lecture *new = *lecture = memory_zeros(1, sizeof *new);
    *new = (struct lecture){.path = path, .shown = -1, .tried = -1};
    new->text = text_file_read(path, why);
    if (new->text == NULL) {
        report("%s: %s", path, why);
        return RUN_WRONG_COMMAND_LINE;
    }
    int status = read_lines(new);
    for (int i = 0; i < new->count &&status == RUN_DONE; i++) {
        struct scene *scene = &new->scene[i];
        begin_line(new, scene->line);
        status = read_scene(scene, chapters, count);
        if (status == RUN_DONE)
            status = run_read_shaders(&scene->run);
        scene->caption = memory_text("%d/%d  %s", i + 1, new->count,
                                     scene->sentence != NULL ? scene->sentence : "");
        report_clean(scene->caption, strlen(scene->caption) + 1, scene->caption);
    }
    report_location(NULL);
    return status;
}

// Return the path of a chapter's picture on the sheet of contents: the one with smooth edges that
// begins its page, or, if there is none yet, the one that its test compares.
static char *cover_of(const struct run *run)
{
    char *smooth = memory_text("%s/tests/references/%s-smooth.png", run->root, run->stem);
    FILE *file = platform_open(smooth);
    if (file != NULL) {
        fclose(file);
        return smooth;
    }
    free(smooth);
    return memory_text("%s/tests/references/%s.png", run->root, run->stem);
}

int lecture_course(struct lecture **lecture, const char *first,
                   const struct lecture_chapter *chapters, int count)
{
    struct lecture *new = *lecture = memory_zeros(1, sizeof *new);
    struct contents_item *item = memory_zeros((size_t)count, sizeof *item);
    *new = (struct lecture){.path = "the course", .shown = -1, .tried = -1};
    new->contents = (struct contents){item, count};
    const struct lecture_chapter *from = first != NULL ? find(chapters, count, first) : chapters;
    if (from == NULL)
        return RUN_WRONG_COMMAND_LINE;
    new->at = (int)(from - chapters);
    for (int i = 0; i < count; i++) {
        const struct lecture_chapter *chapter = &chapters[i];
        if (!add_scene(new, i + 1, chapter->stem))
            return RUN_NOT_DONE;
        struct scene *scene = &new->scene[i];
        int status = read_scene(scene, chapters, count);
        if (status != RUN_DONE)
            return status;
        item[i].name = chapter->title;
        item[i].shows = chapter->shows;
        item[i].picture = cover_of(&scene->run);
    }
    return RUN_DONE;
}

static void print_field(const char *text, char end)
{
    report_text(text);
    putchar(end);
}

void lecture_print(const struct lecture *lecture)
{
    for (int i = 0; i < lecture->count; i++) {
        const struct scene *scene = &lecture->scene[i];
        const char *options = scene->text + strcspn(scene->text, " \t");
        printf("%d\037", i + 1);
        print_field(scene->part > 0 ? lecture->part[scene->part - 1] : "", '\037');
        print_field(scene->run.stem, '\037');
        print_field(options + strspn(options, " \t"), '\037');
        print_field(scene->sentence != NULL ? scene->sentence : "", '\n');
    }
}

// ---- Compiled scenes ----

static bool is_compiled(const struct scene *scene)
{
    return scene->run.picture[0].renderer.gl != NULL;
}

static bool same_text(const char *a, const char *b)
{
    return a == b || (a != NULL && b != NULL && strcmp(a, b) == 0);
}

// True if two scenes have the same shaders and textures, so that only values differ.
static bool is_alike(const struct scene *a, const struct scene *b)
{
    const struct options *one = &a->run.options, *two = &b->run.options;
    bool alike = strcmp(a->run.shader, b->run.shader) == 0 && one->compares == two->compares &&
                 same_text(one->compare, two->compare) && same_text(one->include, two->include) &&
                 one->texture_count == two->texture_count;
    for (int i = 0; i < 4 && alike; i++)
        alike = same_text(one->channels[i], two->channels[i]);
    for (int i = 0; i < one->texture_count && alike; i++)
        alike = same_text(one->textures[i], two->textures[i]);
    return alike;
}

// Find another compiled scene with the same shaders and textures. Returns NULL if there is none.
static struct scene *alike_of(struct lecture *lecture, const struct scene *to)
{
    for (int i = 0; i < lecture->count; i++) {
        struct scene *from = &lecture->scene[i];
        if (from != to && is_compiled(from) && is_alike(from, to))
            return from;
    }
    return NULL;
}

static void move_renderers(struct scene *from, struct scene *to)
{
    for (int i = 0; i < 2; i++) {
        struct loader *picture = &to->run.picture[i];
        loader_close(picture);
        picture->renderer = from->run.picture[i].renderer;
        from->run.picture[i].renderer = (struct renderer){0};
    }
}

static void watch_file(void *watch, const char *path)
{
    watch_add(watch, path);
}

// Read a scene's shaders again, set its values, and compile what has changed. Returns false after
// reporting the error with the scene's line; then all renderers draw what they drew before.
static bool compile(struct lecture *lecture, struct scene *scene)
{
    struct shader_request request = {0};
    if (scene - lecture->scene == lecture->at) {
        request.visit = watch_file;
        request.to = &lecture->failed;
    }
    begin_line(lecture, scene->line);
    // A scene that is not shown must not add its files to those that the window watches.
    for (int i = 0; i < 2 && scene - lecture->scene != lecture->shown; i++)
        scene->run.picture[i].request = request;
    bool done =
        run_read_shaders(&scene->run) == RUN_DONE && run_compile(&scene->run, &lecture->context.gl);
    report_location(NULL);
    return done;
}

// Compile a scene, with the renderers of another scene if that has the same shaders and textures.
// If this fails, they are given back, because the other scene may be the one that is shown.
static bool compile_with(struct lecture *lecture, struct scene *scene)
{
    struct scene *lender = is_compiled(scene) ? NULL : alike_of(lecture, scene);
    if (lender != NULL)
        move_renderers(lender, scene);
    bool done = compile(lecture, scene);
    if (lender != NULL && !done)
        move_renderers(scene, lender);
    return done;
}

// Draw a small picture that is not shown, because drivers finish compiling during the first draw.
static bool draw_small(struct scene *scene)
{
    struct renderer_inputs inputs = run_still_inputs(&scene->run.options);
    inputs.width = 16; // few pixels, because each may take long
    inputs.height = 9;
    return renderer_draw(&scene->run.picture[0].renderer, &inputs, 0, inputs.height);
}

// Free the pictures of all scenes except three: the scene that is shown, and the nearest scenes
// before and after it whose shaders or textures differ.
static void forget_far(struct lecture *lecture)
{
    const struct scene *here = &lecture->scene[lecture->shown];
    int kept[2] = {lecture->shown, lecture->shown};
    for (int side = 0; side < 2; side++)
        while (kept[side] >= 0 && kept[side] < lecture->count &&
               is_alike(&lecture->scene[kept[side]], here))
            kept[side] += side == 0 ? -1 : 1;
    for (int i = 0; i < lecture->count; i++)
        for (int k = 0; k < 2 && i != lecture->shown && i != kept[0] && i != kept[1]; k++)
            loader_close(&lecture->scene[i].run.picture[k]);
}

// Compile the next scene whose shaders or textures differ from those that are shown, unless this
// has been tried before.
static void compile_ahead(struct lecture *lecture)
{
    int next = lecture->at;
    while (next < lecture->count &&
           is_alike(&lecture->scene[next], &lecture->scene[lecture->shown]))
        next++;
    if (next == lecture->count || next == lecture->tried)
        return;
    lecture->tried = next;
    struct scene *scene = &lecture->scene[next];
    if (!is_compiled(scene) && compile(lecture, scene))
        draw_small(scene);
}

// ---- The window ----

// Print a scene's sentence for the speaker and, for notes, the next one.
static void print_sentence(const struct lecture *lecture, const struct scene *scene)
{
    printf("%s\n", scene->caption != NULL ? scene->caption : scene->start.title);
    if (lecture->notes)
        printf("   then %s\n\n", lecture->at + 1 < lecture->count ? scene[1].caption : "the end");
    fflush(stdout);
}

// Show the scene that the speaker has reached. Returns false after reporting the error.
static bool show(struct lecture *lecture, bool at_last)
{
    struct scene *scene = &lecture->scene[lecture->at];
    watch_clear(&lecture->failed);
    if (lecture->window != NULL && !is_compiled(scene) && alike_of(lecture, scene) == NULL)
        window_announce(lecture->window, scene->run.title);
    if (!compile_with(lecture, scene))
        return false;
    scene->start = run_window_start(&scene->run);
    scene->start.caption = lecture->notes ? "" : scene->caption;
    scene->start.scene = lecture->at;
    if (lecture->contents.count > 0)
        scene->start.contents = &lecture->contents;
    scene->start.paused |= scene->run.options.has_time;
    if (scene->run.options.setting_count > 0)
        scene->start.selected = scene->run.options.settings[0];
    print_sentence(lecture, scene);
    lecture->shown = lecture->at;
    if (lecture->window != NULL)
        window_show(lecture->window, &scene->start, at_last);
    forget_far(lecture);
    return true;
}

int lecture_open(struct lecture *lecture, bool notes)
{
    lecture->notes = notes;
    struct run *first = &lecture->scene[lecture->at].run;
    const struct options *options = &first->options;
    if (!context_open_window(&lecture->context, options->backend, first->title, options->width,
                             options->height))
        return RUN_NO_WINDOW;
    if (!show(lecture, false))
        return RUN_NOT_DONE;
    lecture->window = window_open(&lecture->context, &lecture->scene[lecture->at].start);
    if (lecture->window == NULL)
        return RUN_NOT_DONE;
    if (lecture->contents.count == 0)
        window_fill_screen(lecture->window);
    return RUN_DONE;
}

struct window *lecture_window(const struct lecture *lecture)
{
    return lecture->window;
}

// Return the first scene of a part, or the current scene if there is no such part.
static int first_of(const struct lecture *lecture, int part)
{
    for (int i = 0; i < lecture->count; i++)
        if (lecture->scene[i].part == part)
            return i;
    return lecture->at;
}

void lecture_follow(void *of)
{
    struct lecture *lecture = of;
    int part, scene, scenes = window_asked(lecture->window, &part, &scene);
    int to = part > 0 ? first_of(lecture, part) : scene > 0 ? scene - 1 : lecture->at + scenes;
    to = to < 0 ? 0 : to >= lecture->count ? lecture->count - 1 : to;
    bool mended = lecture->at != lecture->shown && window_looks(lecture->window) &&
                  watch_look(&lecture->failed);
    if (part > 0 || to != lecture->at || mended) {
        lecture->at = to;
        if (!show(lecture, part == 0 && scenes < 0))
            window_warn(lecture->window, report_last());
    } else if (window_idles(lecture->window))
        compile_ahead(lecture);
}

void lecture_close(struct lecture *lecture)
{
    window_close(lecture->window);
    for (int i = 0; i < lecture->count; i++) {
        struct scene *scene = &lecture->scene[i];
        run_close(&scene->run);
        free(scene->words);
        free(scene->caption);
    }
    for (int i = 0; i < lecture->contents.count; i++)
        free(lecture->contents.item[i].picture);
    free((void *)lecture->contents.item);
    context_close(&lecture->context);
    watch_clear(&lecture->failed);
    free(lecture->scene);
    free(lecture->part);
    free(lecture->text);
    free(lecture);
}
