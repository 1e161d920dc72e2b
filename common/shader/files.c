#include "shader/files.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "platform.h"

// True for a path in a folder, or for the folder itself.
static bool inside(const char *path, const char *folder)
{
    size_t length = strlen(folder);
    return strncmp(path, folder, length) == 0 && (path[length] == '/' || path[length] == '\0' ||
                                                  (length > 0 && folder[length - 1] == '/'));
}

// A path relative to a folder that contains it.
static const char *within(const char *path, const char *folder)
{
    path += strlen(folder);
    return *path == '\0' ? "." : path + (*path == '/');
}

void files_folder(const char *path, char folder[PLATFORM_PATH])
{
    int length = (int)(strrchr(path, '/') - path);
    snprintf(folder, PLATFORM_PATH, "%.*s", length > 0 ? length : 1, path);
}

void files_visit(const struct shader_source *source, const char *path)
{
    if (source->request.visit != NULL)
        source->request.visit(source->request.to, path);
}

// Return the end of a resolved path, from the first component that differs from the given name in
// case; NULL if case is not the only difference, or if the name does not differ. Any other
// difference is allowed, because a link may lead anywhere.
static const char *other_case(const char *name, const char *path)
{
    while (strncmp(name, "./", 2) == 0 || strncmp(name, "../", 3) == 0)
        name = strchr(name, '/') + 1;
    size_t length = strlen(name), whole = strlen(path);
    if (length > whole)
        return NULL;
    const char *tail = path + whole - length, *part = tail, *other = NULL;
    for (size_t i = 0; i < length; i++) {
        if (tolower((unsigned char)name[i]) != tolower((unsigned char)tail[i]))
            return NULL;
        part = name[i] == '/' ? tail + i + 1 : part;
        other = other == NULL && name[i] != tail[i] ? part : other;
    }
    return other;
}

// True for a name that means the same on every system. Otherwise why receives the reason.
static bool is_portable(const char *name, const char *folder, char why[TEXT_FILE_WHY])
{
    bool absolute = name[0] == '/' || (isalpha((unsigned char)name[0]) && name[1] == ':');
    if (absolute)
        snprintf(why, TEXT_FILE_WHY, "an absolute path: give one relative to this file or to %s",
                 folder);
    else if (strchr(name, '\\') != NULL)
        snprintf(why, TEXT_FILE_WHY, "a \\ separates folders only on Windows: write /");
    return !absolute && strchr(name, '\\') == NULL;
}

// Resolve a name, as files_find does. Returns memory that the caller frees, or NULL without
// reporting an error.
static char *resolve(const struct shader_source *source, int from, const char *name,
                     const char *const folders[], const char *where, char why[TEXT_FILE_WHY])
{
    const char *slash = strrchr(source->files[from], '/');
    const char *include = source->include;
    char beside[PLATFORM_PATH], path[3 * PLATFORM_PATH];
    files_folder(source->paths[from], beside);
    if (!is_portable(name, folders[0] + 1, why))
        return NULL;
    for (int i = 0; i < 2 || folders[i - 2] != NULL; i++) {
        if (i == 1 && include == NULL)
            continue;
        snprintf(path, sizeof path, "%s%s/%s",
                 i == 0   ? beside
                 : i == 1 ? include
                          : source->root,
                 i < 2 ? "" : folders[i - 2], name);
        char *resolved = platform_resolve(path);
        files_visit(source, resolved != NULL ? resolved : path);
        if (resolved == NULL && (errno == ENOENT || errno == ENOTDIR))
            continue;
        const char *other = resolved != NULL ? other_case(name, resolved) : NULL;
        if (resolved == NULL)
            snprintf(why, TEXT_FILE_WHY, "cannot be read: %s", platform_why(errno));
        else if (!inside(resolved, source->root) && !inside(resolved, source->own) &&
                 (include == NULL || !inside(resolved, include)))
            snprintf(why, TEXT_FILE_WHY,
                     "lies outside the project and the shader's own folder: give --include DIR, a "
                     "folder that contains it");
        else if (other == NULL)
            return resolved;
        else
            snprintf(why, TEXT_FILE_WHY,
                     "the name on disk is %.300s: write it like that, because other systems "
                     "distinguish upper and lower case",
                     other);
        free(resolved);
        return NULL;
    }
    snprintf(why, TEXT_FILE_WHY, "no such file beside %.300s%s",
             slash == NULL ? source->files[from] : slash + 1, where);
    return NULL;
}

// The name of a file in messages: for the first file, the name as it was given; for any other file,
// a name relative to the project, or below the name of the request's folder or of that of the first
// file. Returns memory that the caller
// frees.
static char *name_of(const struct shader_source *source, const char *given, const char *resolved)
{
    if (source->file_count == 0)
        return memory_text("%s", given);
    if (inside(resolved, source->root))
        return memory_text("%s", within(resolved, source->root));
    if (source->include != NULL && inside(resolved, source->include))
        return memory_text("%s/%s", source->request.include, within(resolved, source->include));
    const char *first = source->files[0], *slash = strrchr(first, '/');
    int folder = slash == NULL ? 0 : (int)(slash - first) + 1;
    return memory_text("%.*s%s", folder, first, within(resolved, source->own));
}

// A line end in a name would break a message or a comment in two, so control characters are
// replaced.
int files_add(struct shader_source *source, char *name, char *path)
{
    int file = source->file_count;
    for (int i = 0; i < file; i++)
        if (strcmp(source->paths[i], path) == 0) {
            free(name);
            free(path);
            return i;
        }
    for (char *c = name; *c != '\0'; c++)
        if ((unsigned char)*c < ' ' || *c == 0x7f)
            *c = '?';
    source->files = memory_row(source->files, file, sizeof *source->files);
    source->paths = memory_row(source->paths, file, sizeof *source->paths);
    source->files[file] = name;
    source->paths[file] = path;
    return source->file_count++;
}

int files_find(struct shader_source *source, int from, const char *name,
               const char *const folders[], const char *where, char why[TEXT_FILE_WHY])
{
    char *path = resolve(source, from, name, folders, where, why);
    return path == NULL ? -1 : files_add(source, name_of(source, name, path), path);
}

int shader_find_texture(struct shader_source *source, int from, const char *name,
                        char why[TEXT_FILE_WHY])
{
    static const char *const folders[] = {"/shaders/textures", NULL};
    return files_find(source, from, name, folders, " or in shaders/textures/", why);
}

int shader_take_texture(struct shader_source *source, const char *path, char why[TEXT_FILE_WHY])
{
    char *resolved = platform_resolve(path);
    files_visit(source, resolved != NULL ? resolved : path);
    if (resolved != NULL)
        return files_add(source, memory_text("%s", path), resolved);
    snprintf(why, TEXT_FILE_WHY, "cannot be read: %s", platform_why(errno));
    return -1;
}
