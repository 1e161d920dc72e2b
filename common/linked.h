// linked.h - the programs of all chapters, linked into one program: the module of the web pages,
// or the lecture. make writes their list into chapters.c in the build folder.
#ifndef LINKED_H
#define LINKED_H

// A chapter's main function, to which make gives a unique name.
struct linked_chapter {
    const char *stem;
    int (*main)(int argc, char **argv);
};

// The stem of the last element is NULL.
extern const struct linked_chapter linked_chapters[];

// Each main calls this instead of chapter_run, because make has the compiler rename the call.
struct chapter;
int linked_run(const struct chapter *chapter, int argc, char **argv);

#endif
