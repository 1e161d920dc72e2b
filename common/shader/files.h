// files.h - the files of a source: finds, names and lists each of them once.
#ifndef SHADER_FILES_H
#define SHADER_FILES_H

#include "platform.h"
#include "shader/source.h"

// Pass a path that is read or tried to the function see of the request.
void files_tell(const struct shader_source *source, const char *path);

// The folder of a resolved path.
void files_folder(const char *path, char folder[PLATFORM_PATH]);

// Add a file, unless it is listed already; takes over name and path. Returns its index.
//   name  the name to print
//   path  the resolved path
int files_add(struct shader_source *source, char *name, char *path);

// Find a file that another file names, and add it. It is looked for next to that file, then in
// folders of the project.
//   from     index of the file that names it
//   folders  each begins with /; the last is NULL
//   where    the same folders in words, for messages
//   why      receives one phrase if there is none
// Returns its index, or -1 without reporting an error.
int files_find(struct shader_source *source, int from, const char *name,
               const char *const folders[], const char *where, char why[TEXT_FILE_WHY]);

#endif
