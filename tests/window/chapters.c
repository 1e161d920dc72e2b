// chapters.c - tests that every chapter opens in a window, that its camera moves, and that it
// reports nothing; and that all chapters can be paged through.
#include <dirent.h>

#include "linked.h"
#include "lib/programs.h"
#include "lib/scratch.h"
#include "lib/session.h"

static void try_chapter(const char *stem)
{
    session_open_bare(stem, "--size 64x36");
    session_keep(0);
    user_press(GLFW_KEY_W, 0);
    session_wait(0.3);
    user_release(GLFW_KEY_W);
    session_turn();
    if (session_off(0, NULL) <= 0.0)
        print_error("%s: the picture does not change when the camera moves\n", stem);
    assert_true(session_off(0, NULL) > 0.0);
    session_close();
}

SESSION_TEST(every_chapter_opens_and_moves)
{
    int count = 0;
    DIR *folder = opendir("chapters");
    assert_non_null(folder);
    for (struct dirent *entry = readdir(folder); entry != NULL; entry = readdir(folder)) {
        char stem[sizeof entry->d_name];
        snprintf(stem, sizeof stem, "%s", entry->d_name);
        char *end = strstr(stem, ".c");
        if (end == NULL || strcmp(end, ".c") != 0 || stem[0] < '0' || stem[0] > '9')
            continue;
        *end = '\0';
        try_chapter(stem);
        count++;
    }
    closedir(folder);
    assert_true(count >= 22);
}

enum { MIDDLE = 13 }; // a scene of this test: the shader of a reader, which is broken at first

// Page to a scene with a key. In the middle, the window says that the shader has an error, until it
// is mended.
static void page_to(int scene, int key)
{
    struct chapter chapter;
    if (scene == MIDDLE)
        scratch_write("mine.frag", "void mainImage(");
    session_key(key);
    session_turn();
    if (scene == MIDDLE) {
        session_wait(0.5);
        session_assert_title("error");
        assert_non_null(strstr(session_said(2), "mine.frag"));
        scratch_write("mine.frag", "void mainImage(out vec4 c, in vec2 p) { c = vec4(0.5); }");
        session_wait(0.5);
    }
    assert_false(session_titled("error"));
    assert_true(programs_find(linked_chapters[scene].stem, &chapter));
    session_assert_title(scene == MIDDLE ? "mine.frag" : chapter.title);
    assert_string_equal(session_said(2), "");
}

SESSION_TEST(two_keys_page_through_all_chapters_and_back)
{
    static char list[8192], path[4096];
    int count = 0, length = 0;
    for (; linked_chapters[count].stem != NULL; count++)
        length += snprintf(list + length, sizeof list - (size_t)length, "%.2s%s%s\n",
                           linked_chapters[count].stem, count == MIDDLE ? " --shader " : "",
                           count == MIDDLE ? scratch_path("mine.frag") : "");
    assert_true(count > MIDDLE);
    scratch_write("mine.frag", "void mainImage(out vec4 c, in vec2 p) { c = vec4(0.5); }");
    snprintf(path, sizeof path, "%s", scratch_write("list.txt", list));
    session_open_lecture(path);
    if (getenv("ALL") != NULL)
        user_resize(1280, 720); // takes ten times as long
    for (int i = 1; i < count; i++)
        page_to(i, GLFW_KEY_PAGE_DOWN);
    for (int i = count - 2; i >= 0; i--)
        page_to(i, GLFW_KEY_PAGE_UP);
    session_close();
}

TESTS(NULL, NULL)
