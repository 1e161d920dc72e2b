// files.h - the files of a source: found, named and listed once.
#ifndef SHADER_FILES_H
#define SHADER_FILES_H

#include "platform.h"
#include "shader/source.h"

// Tell the source's request of a path that is read or tried.
void files_tell(const struct shader_source *source, const char *path);

// The folder of a resolved path.
void files_folder(const char *path, char folder[PLATFORM_PATH]);

// Add a file, unless it is known; takes over name and path. Returns its index.
//   name  to print
//   path  resolved
int files_add(struct shader_source *source, char *name, char *path);

// Find a file that another one names: next to that one, then in folders of the project; and add it.
//   from     index of the file that names it
//   folders  each begins with /; the last is NULL
//   where    the same in words
//   why      receives one phrase if there is none
// Returns its index, or -1, not reported.
int files_find(struct shader_source *source, int from, const char *name,
               const char *const folders[], const char *where, char why[TEXT_FILE_WHY]);

#endif
