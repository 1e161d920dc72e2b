// The lecture: one program that contains all chapters and shows the scenes of a list in one window.
//
//   build/lecture docs/lecture.txt
//
// With --print, it prints the scenes instead.
#include "../common/chapter.h"

#include <stdio.h>
#include <string.h>

#include "../common/linked.h"
#include "../common/command/lecture.h"
#include "../common/report.h"

enum { CHAPTERS = 99 };

static struct lecture_chapter chapters[CHAPTERS];
static int chapter_count;

// Add a chapter to the list. Each chapter's main calls this function instead of chapter_run.
int linked_run(const struct chapter *chapter, int argc, char **argv)
{
    (void)argc;
    (void)argv;
    chapters[chapter_count++] =
        (struct lecture_chapter){chapter->stem, chapter->title, chapter->camera, chapter->tool};
    return RUN_DONE;
}

int main(int argc, char **argv)
{
    struct lecture *lecture;
    bool prints = argc == 3 && strcmp(argv[1], "--print") == 0;
    if (argc != 2 && !prints) {
        report("%s: usage: %s [--print] LIST, as in %s docs/lecture.txt", argv[0], argv[0],
               argv[0]);
        return RUN_WRONG_COMMAND_LINE;
    }
    for (int i = 0; linked_chapters[i].stem != NULL && chapter_count < CHAPTERS; i++)
        linked_chapters[i].main(1, argv);
    int status = lecture_read(&lecture, argv[argc - 1], chapters, chapter_count);
    if (status == RUN_DONE && prints)
        lecture_print(lecture);
    else if (status == RUN_DONE)
        status = lecture_open(lecture);
    if (status == RUN_DONE && !prints &&
        !window_run(lecture_window(lecture), lecture_follow, lecture))
        status = RUN_NOT_DONE;
    lecture_close(lecture);
    return run_end(status, !prints);
}
