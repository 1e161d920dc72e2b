// chapters.c - tests that every chapter opens in a window, that its camera moves, and that it
// reports nothing.
#include <dirent.h>

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

TESTS(NULL, NULL)
