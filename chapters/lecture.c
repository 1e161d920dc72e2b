// The lecture: one program that contains all chapters and shows the scenes of a list in one window.
//
//   build/lecture docs/lecture.txt
//   build/lecture --course 03
//
// With --notes, the sentences for the speaker are only printed, each with the next one. With
// --course, it shows all chapters, beginning with the one that is named. With --print, it prints
// the scenes of a list instead.
#include "../common/chapter.h"

#include <stdio.h>
#include <string.h>

#include "../common/command/lecture.h"
#include "../common/linked.h"
#include "../common/report.h"

enum { CHAPTERS = 99 };

static struct lecture_chapter chapters[CHAPTERS];
static int chapter_count;

// Add a chapter to the list. Each chapter's main calls this function instead of chapter_run.
int linked_run(const struct chapter *chapter, int argc, char **argv)
{
    (void)argc;
    (void)argv;
    chapters[chapter_count++] = (struct lecture_chapter){
        chapter->stem, chapter->title, chapter->shows, chapter->camera, chapter->tool};
    return RUN_DONE;
}

int main(int argc, char **argv)
{
    struct lecture *lecture;
    bool course = argc > 1 && argc < 4 && strcmp(argv[1], "--course") == 0;
    bool prints = argc == 3 && strcmp(argv[1], "--print") == 0;
    bool notes = argc == 3 && strcmp(argv[1], "--notes") == 0;
    if (argc != 2 && !prints && !notes && !course) {
        report("%s: usage: %s [--print | --notes] LIST, as in %s docs/lecture.txt, or %s --course "
               "[CHAPTER]",
               argv[0], argv[0], argv[0], argv[0]);
        return RUN_WRONG_COMMAND_LINE;
    }
    for (int i = 0; linked_chapters[i].stem != NULL && chapter_count < CHAPTERS; i++)
        linked_chapters[i].main(1, argv);
    int status = course
                     ? lecture_course(&lecture, argc == 3 ? argv[2] : NULL, chapters, chapter_count)
                     : lecture_read(&lecture, argv[argc - 1], chapters, chapter_count);
    if (status == RUN_DONE && prints)
        lecture_print(lecture);
    else if (status == RUN_DONE)
        status = lecture_open(lecture, notes);
    if (status == RUN_DONE && !prints &&
        !window_run(lecture_window(lecture), lecture_follow, lecture))
        status = RUN_NOT_DONE;
    lecture_close(lecture);
    return run_end(status, !prints);
}
