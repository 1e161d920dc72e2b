// chapters.h - the programs of all chapters in one: make writes the list (build/web/chapters.c).
#ifndef CHAPTERS_H
#define CHAPTERS_H

// A chapter's main, under a name of its own.
struct live_chapter {
    const char *stem;
    int (*main)(int argc, char **argv);
};

// Ends with a stem of NULL.
extern const struct live_chapter live_chapters[];

// What each main calls instead of chapter_run, because the compiler renames that.
struct chapter;
int live_run(const struct chapter *chapter, int argc, char **argv);

#endif
