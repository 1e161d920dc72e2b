// chapters.h - the programs of all chapters, linked into one. make writes their list into
// build/web/chapters.c.
#ifndef CHAPTERS_H
#define CHAPTERS_H

// A chapter's main, under a unique name.
struct live_chapter {
    const char *stem;
    int (*main)(int argc, char **argv);
};

// The list ends with a stem of NULL.
extern const struct live_chapter live_chapters[];

// Each main calls this instead of chapter_run, because make has the compiler rename the call.
struct chapter;
int live_run(const struct chapter *chapter, int argc, char **argv);

#endif
