#include "lib/session.h"

#include <unistd.h>

#include "linked.h"
#include "command/lecture.h"
#include "lib/compare.h"
#include "lib/gpu.h"
#include "lib/programs.h"
#include "lib/scratch.h"
#include "lib/system.h"
#include "window/window.h"

enum { ARGUMENTS = 32, KEPT = 4, CHAPTERS = 99 };

static struct {
    struct chapter chapter;
    struct run *run;         // NULL if no chapter is open
    struct lecture *lecture; // NULL if no lecture is open
    char line[4096], *argument[ARGUMENTS + 1];
    struct said {
        FILE *file;   // collects the program's output or its reports; NULL if nothing is collected
        long fetched; // bytes of the file that session_said has returned
        int stream;   // a copy of the descriptor that the file replaces
    } said[2];
    char text[65536];
    struct image kept[KEPT];
    int shots;
} session;

// ---- What is printed ----

static void listen(void)
{
    fflush(stdout);
    for (int i = 0; i < 2; i++) {
        session.said[i] = (struct said){system_open_scratch(), 0, dup(i + 1)};
        dup2(fileno(session.said[i].file), i + 1);
    }
}

static void hush(void)
{
    fflush(stdout);
    for (int i = 0; i < 2; i++) {
        dup2(session.said[i].stream, i + 1);
        close(session.said[i].stream);
        fclose(session.said[i].file);
        session.said[i].file = NULL;
    }
}

const char *session_said(int stream)
{
    struct said *said = &session.said[stream - 1];
    fflush(stdout);
    fseek(said->file, said->fetched, SEEK_SET);
    session.text[fread(session.text, 1, sizeof session.text - 1, said->file)] = '\0';
    said->fetched = ftell(said->file);
    return session.text;
}

// Fail the test with a message. Capturing is ended first, so that the message appears.
static void give_up(const char *format, ...) __attribute__((format(printf, 1, 2)));
static void give_up(const char *format, ...)
{
    char text[8192];
    va_list values;
    va_start(values, format);
    vsnprintf(text, sizeof text, format, values);
    va_end(values);
    if (session.said[0].file != NULL)
        hush();
    fail_msg("%s", text);
}

// ---- A window ----

int session_setup(void **unused)
{
    user_reset();
    session.shots = 0;
    setenv("DISPLAY", ":of-the-test", 1);
    return scratch_setup(unused);
}

bool session_smooths;

static void close_program(void)
{
    if (session.run != NULL)
        chapter_close(session.run);
    if (session.lecture != NULL)
        lecture_close(session.lecture);
    session.run = NULL;
    session.lecture = NULL;
}

int session_teardown(void **unused)
{
    close_program();
    if (session.said[0].file != NULL) {
        session_said(2); // the reports of a test that has failed
        hush();
        fputs(session.text, stderr);
    }
    for (int i = 0; i < KEPT; i++)
        image_free(&session.kept[i]);
    memset(session.kept, 0, sizeof session.kept);
    return scratch_teardown(unused);
}

static void open_window(const char *stem, const char *options, va_list values)
{
    char *word, *rest = session.line;
    int count = 0;
    int used = snprintf(rest, sizeof session.line, "%s --root %s ", stem, gpu_project_root());
    used += vsnprintf(rest + used, sizeof session.line - (size_t)used, options, values);
    if (!session_smooths && strstr(rest, "--samples") == NULL)
        snprintf(rest + used, sizeof session.line - (size_t)used, " --samples 1");
    while ((word = strtok(count == 0 ? rest : NULL, " ")) != NULL && count < ARGUMENTS)
        session.argument[count++] = word;
    session.argument[count] = NULL;
    assert_true(programs_find(stem, &session.chapter));
    session.chapter.title = stem;
    listen();
    int status = chapter_open(&session.run, &session.chapter, count, session.argument);
    if (status != 0 || chapter_window(session.run) == NULL)
        give_up("%s %s: status %d, no window: %s", stem, options, status, session_said(2));
    session_turn();
    session_turn();
}

void session_open(const char *stem, const char *options, ...)
{
    va_list values;
    va_start(values, options);
    open_window(stem, options, values);
    va_end(values);
}

void session_open_bare(const char *stem, const char *options, ...)
{
    va_list values;
    va_start(values, options);
    open_window(stem, options, values);
    va_end(values);
    session_key(GLFW_KEY_H);
}

void session_open_lecture(const char *list)
{
    static struct lecture_chapter chapters[CHAPTERS];
    int count = 0;
    for (; linked_chapters[count].stem != NULL; count++) {
        struct chapter chapter;
        assert_true(count < CHAPTERS && programs_find(linked_chapters[count].stem, &chapter));
        chapters[count] = (struct lecture_chapter){chapter.stem, chapter.title, chapter.shows,
                                                   chapter.camera, chapter.tool};
    }
    listen();
    int status = list != NULL ? lecture_read(&session.lecture, list, chapters, count)
                              : lecture_course(&session.lecture, NULL, chapters, count);
    if (status != RUN_DONE || lecture_open(session.lecture, false) != RUN_DONE)
        give_up("%s: no lecture: %s", list != NULL ? list : "the course", session_said(2));
    assert_true(user.full == (list != NULL));
    user_resize(320, 180); // fewer pixels, to save time
    session_turn();
    session_turn();
}

struct window *session_window(void)
{
    return session.lecture != NULL ? lecture_window(session.lecture) : chapter_window(session.run);
}

void session_close(void)
{
    close_program();
    session_said(2);
    hush();
    assert_string_equal(session.text, "");
}

void session_turn(void)
{
    user.now += 1.0 / 60.0;
    assert_true(window_turn(session_window()));
    if (session.lecture != NULL)
        lecture_follow(session.lecture);
}

void session_wait(double seconds)
{
    for (double end = user.now + seconds; user.now < end;)
        session_turn();
}

bool session_run(void)
{
    return window_run(chapter_window(session.run), NULL, NULL);
}

static void press(int key, int modifiers)
{
    user_key(key, modifiers);
    session_turn();
}

void session_key(int key)
{
    press(key, 0);
}

void session_shift_key(int key)
{
    press(key, GLFW_MOD_SHIFT);
}

void session_click(double x, double y)
{
    user_click(x, y, GLFW_MOUSE_BUTTON_LEFT);
    session_turn();
    session_turn();
    user.now += 1.0; // so that the next click is not part of a double click
}

bool session_titled(const char *text)
{
    return strstr(user.title, text) != NULL;
}

void session_assert_title(const char *text)
{
    if (!session_titled(text))
        give_up("the title is '%s', which does not contain '%s'", user.title, text);
}

// ---- What is shown ----

// Fails the test unless a chapter writes the same picture. Frees the picture.
static void assert_written(const char *stem, const char *options, struct image *image)
{
    char line[4096], said[4096];
    const char *path = scratch_path("wanted.png");
    struct image wanted;
    struct image_difference difference;
    snprintf(line, sizeof line, "%s --output %s", options, path);
    if (system_run(stem, line, said, sizeof said) != 0 || !image_read_png(&wanted, path))
        give_up("%s %s: %s", stem, line, said);
    bool compared = image_compare(&wanted, image, &difference);
    image_free(&wanted);
    image_free(image);
    if (!compared || difference.f2 > 0.0)
        give_up("this is not the picture of %s %s: a share of %g of the pixels differs", stem,
                options, difference.f2);
}

void session_assert_shown(const char *stem, const char *options, ...)
{
    char line[2048];
    struct image image;
    va_list values;
    va_start(values, options);
    vsnprintf(line, sizeof line, options, values);
    va_end(values);
    user_look(&image);
    assert_written(stem, line, &image);
}

void session_shoot(struct image *image)
{
    char root[4096], name[256], written[280];
    session_said(1);
    snprintf(name, sizeof name, "%s-%04d.png", session.chapter.stem, ++session.shots);
    snprintf(written, sizeof written, "%s: written", name);
    if (getcwd(root, sizeof root) == NULL || chdir(scratch_path("")) != 0)
        give_up("the folder for screenshots cannot be used");
    session_key(GLFW_KEY_P);
    for (double end = user.now + 10.0; strstr(session_said(1), written) == NULL;) {
        if (user.now > end)
            give_up("%s: not written", name);
        session_turn();
    }
    assert_int_equal(chdir(root), 0);
    if (!image_read_png(image, scratch_path(name)))
        give_up("%s: cannot be read", name);
}

void session_assert_screenshot(const char *stem, const char *options)
{
    struct image image;
    session_shoot(&image);
    assert_written(stem, options, &image);
}

void session_keep(int number)
{
    image_free(&session.kept[number]);
    user_look(&session.kept[number]);
}

static int apart(const unsigned char *a, const unsigned char *b)
{
    int most = 0;
    for (int i = 0; i < 3; i++)
        most = abs(a[i] - b[i]) > most ? abs(a[i] - b[i]) : most;
    return most;
}

double session_off(int number, const int part[4])
{
    const struct image *kept = &session.kept[number];
    const int all[4] = {0, 0, kept->width, kept->height};
    int box[4];
    const int *in = part != NULL ? part : all;
    return (double)session_bounds(number, in, box) / in[2] / in[3];
}

int session_bounds(int number, const int in[4], int box[4])
{
    const struct image *kept = &session.kept[number];
    struct image shown;
    int off = 0, right = 0, bottom = 0;
    user_look(&shown);
    assert_true(shown.width == kept->width && shown.height == kept->height);
    box[0] = kept->width;
    box[1] = kept->height;
    for (int y = in[1]; y < in[1] + in[3]; y++)
        for (int x = in[0]; x < in[0] + in[2]; x++) {
            int at = 3 * (y * kept->width + x);
            if (apart(kept->pixel + at, shown.pixel + at) <= 2)
                continue;
            off++;
            box[0] = x < box[0] ? x : box[0];
            box[1] = y < box[1] ? y : box[1];
            right = x >= right ? x + 1 : right;
            bottom = y + 1;
        }
    box[2] = right - box[0];
    box[3] = bottom - box[1];
    image_free(&shown);
    return off;
}
