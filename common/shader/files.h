// files.h - finds and names the files of a source, and lists each of them once.
#ifndef SHADER_FILES_H
#define SHADER_FILES_H

#include "platform.h"
#include "shader/source.h"

// Pass a path that is read or tried to the callback request.visit, if there is one.
void files_visit(const struct shader_source *source, const char *path);

// The folder of a resolved path.
void files_folder(const char *path, char folder[PLATFORM_PATH]);

// Add a file, unless it is already listed, and take ownership of name and path. Returns the file's
// index.
//   name  the name to print
//   path  the resolved path
int files_add(struct shader_source *source, char *name, char *path);

// Find a file that another file names, and add it to the source's files. The file is looked for
// next to the file that names it, then in folders of the project.
//   from     index of the file that names this file
//   folders  the folders, each beginning with /; the list ends in NULL
//   where    the same folders in words, for messages
//   why      receives the reason on failure, as a phrase
// Returns the file's index, or -1 without reporting an error.
int files_find(struct shader_source *source, int from, const char *name,
               const char *const folders[], const char *where, char why[TEXT_FILE_WHY]);

#endif
