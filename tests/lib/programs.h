// programs.h - the programs of all chapters: what each program passes to chapter_run.
#ifndef TESTS_PROGRAMS_H
#define TESTS_PROGRAMS_H

#include "../common/chapter.h"

// Find a chapter by its stem, such as "03_shadows". Returns false if there is no such chapter.
bool programs_find(const char *stem, struct chapter *chapter);

#endif
