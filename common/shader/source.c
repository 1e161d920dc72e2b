#include "shader/source.h"

#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "platform.h"
#include "report.h"
#include "shader/text_file.h"

#define TEXT_LIMIT  (8 * 1024 * 1024)   // bytes of the expanded text
#define DEPTH_LIMIT 64                  // files open at once, the first one included
#define WHERE_SIZE  (3 * PLATFORM_PATH) // FILE:LINE: #include "NAME"

// One expansion under way.
struct expansion {
    struct shader_source *source;
    FILE *text;            // of the source
    size_t size;           // of it so far
    int open[DEPTH_LIMIT]; // the files from the first to the one being read
    int depth;
};

// ---- Names ----

// True for the folder itself too.
static bool inside(const char *path, const char *folder)
{
    size_t length = strlen(folder);
    return strncmp(path, folder, length) == 0 && (path[length] == '/' || path[length] == '\0' ||
                                                  (length > 0 && folder[length - 1] == '/'));
}

// The part of a path inside the folder that holds it; . for the folder itself.
static const char *within(const char *path, const char *folder)
{
    path += strlen(folder);
    return *path == '\0' ? "." : path + (*path == '/');
}

// The folder of a resolved path.
static void folder_of(const char *path, char folder[PLATFORM_PATH])
{
    int length = (int)(strrchr(path, '/') - path);
    snprintf(folder, PLATFORM_PATH, "%.*s", length > 0 ? length : 1, path);
}

static void tell(const struct shader_source *source, const char *path)
{
    if (source->request.see != NULL)
        source->request.see(source->request.to, path);
}

// True for two names of the same letters, capital or small.
static bool alike(const char *one, const char *other, size_t length)
{
    for (size_t i = 0; i < length; i++)
        if (tolower((unsigned char)one[i]) != tolower((unsigned char)other[i]))
            return false;
    return true;
}

// Where a path ends otherwise than the name by which it was found, in capital or small letters
// alone; NULL where it does not. Links lead elsewhere, and ".." is in no resolved path.
static const char *otherwise(const char *name, const char *path)
{
    const char *found = NULL;
    size_t left = strlen(name), rest = strlen(path);
    while (left > 0 && left < rest) {
        size_t length = 0;
        while (length < left && name[left - length - 1] != '/')
            length++;
        left -= length;
        rest -= length;
        if (path[rest - 1] != '/' || !alike(name + left, path + rest, length))
            break;
        if (memcmp(name + left, path + rest, length) != 0)
            found = path + rest;
        left -= left > 0;
        rest--;
    }
    return found;
}

// True for a name that means the same on every system; else why receives a phrase.
static bool is_plain(const char *name, const char *folder, char why[TEXT_FILE_WHY])
{
    // The root of a system's files, or a disk of Windows.
    if (name[0] == '/' || (isalpha((unsigned char)name[0]) && name[1] == ':'))
        snprintf(why, TEXT_FILE_WHY, "an absolute path: give one from this file or from %s",
                 folder);
    else if (strchr(name, '\\') != NULL)
        snprintf(why, TEXT_FILE_WHY, "a \\ stands between folders on Windows alone: write /");
    else
        return true;
    return false;
}

// True for a path that a name may lead to; else why receives a phrase.
static bool may_lead(const struct shader_source *source, const char *name, const char *path,
                     char why[TEXT_FILE_WHY])
{
    const char *other = otherwise(name, path);
    if (!inside(path, source->root) && !inside(path, source->own))
        snprintf(why, TEXT_FILE_WHY, "lies outside the project and the shader's own folder");
    else if (other != NULL)
        snprintf(why, TEXT_FILE_WHY,
                 "the disk has it as %.300s: write it so, for other systems tell capital letters "
                 "from small ones",
                 other);
    else
        return true;
    return false;
}

// Resolve the name of a file that another one names: beside that, then in folders of the project.
//   folders  in the project, each with a / in front; NULL after the last one
//   where    the same in words
static char *resolve(const struct shader_source *source, int from, const char *name,
                     const char *const folders[], const char *where, char why[TEXT_FILE_WHY])
{
    const char *slash = strrchr(source->files[from], '/');
    char beside[PLATFORM_PATH], path[3 * PLATFORM_PATH];
    folder_of(source->paths[from], beside);
    if (!is_plain(name, folders[0] + 1, why))
        return NULL;
    for (int i = 0; i == 0 || folders[i - 1] != NULL; i++) {
        snprintf(path, sizeof path, "%s%s/%s", i == 0 ? beside : source->root,
                 i == 0 ? "" : folders[i - 1], name);
        char *resolved = platform_resolve(path);
        tell(source, resolved != NULL ? resolved : path);
        if (resolved == NULL && (errno == ENOENT || errno == ENOTDIR))
            continue;
        if (resolved == NULL)
            snprintf(why, TEXT_FILE_WHY, "cannot be read: %s", platform_why(errno));
        else if (may_lead(source, name, resolved, why))
            return resolved;
        free(resolved);
        return NULL;
    }
    snprintf(why, TEXT_FILE_WHY, "no such file beside %.300s%s",
             slash == NULL ? source->files[from] : slash + 1, where);
    return NULL;
}

// The name of a file in messages: from the project's folder on, else as the first file was given.
static char *name_of(const struct shader_source *source, const char *given, const char *resolved)
{
    if (source->file_count == 0)
        return memory_text("%s", given);
    if (inside(resolved, source->root))
        return memory_text("%s", within(resolved, source->root));
    const char *first = source->files[0], *slash = strrchr(first, '/');
    int folder = slash == NULL ? 0 : (int)(slash - first) + 1;
    return memory_text("%.*s%s", folder, first, within(resolved, source->own));
}

// Add a file to the table; takes name and path over. A name may hold a line's end, which would
// break a message or a comment in two. Returns its index.
static int add_file(struct shader_source *source, char *name, char *path)
{
    int file = source->file_count;
    for (char *c = name; *c != '\0'; c++)
        if ((unsigned char)*c < ' ' || *c == 0x7f)
            *c = '?';
    source->files = memory_row(source->files, file, sizeof *source->files);
    source->paths = memory_row(source->paths, file, sizeof *source->paths);
    source->files[file] = name;
    source->paths[file] = path;
    return source->file_count++;
}

int shader_find_texture(struct shader_source *source, int from, const char *name,
                        char why[TEXT_FILE_WHY])
{
    static const char *const folders[] = {"/shaders/textures", NULL};
    char *path = resolve(source, from, name, folders, " or in shaders/textures/", why);
    return path == NULL ? -1 : add_file(source, name_of(source, name, path), path);
}

int shader_take_texture(struct shader_source *source, const char *path, char why[TEXT_FILE_WHY])
{
    char *resolved = platform_resolve(path);
    tell(source, resolved != NULL ? resolved : path);
    if (resolved != NULL)
        return add_file(source, memory_text("%s", path), resolved);
    snprintf(why, TEXT_FILE_WHY, "cannot be read: %s", platform_why(errno));
    return -1;
}

// ---- The expanded text ----

// Add one line of a file, its end included, after a prefix.
static bool add_line(struct expansion *e, struct shader_line from, const char *prefix,
                     const char *line, size_t length)
{
    struct shader_source *source = e->source;
    e->size += strlen(prefix) + length + 1;
    if (e->size > TEXT_LIMIT)
        return report("%s:%d: the text passes 8 MiB with its includes: include less",
                      source->files[from.file], from.line);
    fprintf(e->text, "%s%.*s\n", prefix, (int)length, line);
    source->lines = memory_row(source->lines, source->line_count, sizeof *source->lines);
    source->lines[source->line_count++] = from;
    return true;
}

static bool expand_file(struct expansion *e, int file, const char *where);

// Report an include that would have its file contain itself, with the way round.
static bool report_cycle(const struct expansion *e, int file, const char *where)
{
    char chain[2048] = "";
    size_t size = 0;
    int first = 0;
    while (e->open[first] != file)
        first++;
    for (int i = first; i < e->depth && size < sizeof chain; i++)
        size += (size_t)snprintf(chain + size, sizeof chain - size, "%s -> ",
                                 e->source->files[e->open[i]]);
    return report("%s: the file includes itself: %s%s: take one of these includes out", where,
                  chain, e->source->files[file]);
}

// Put the file of an include in place, unless it is there already.
static bool include(struct expansion *e, struct shader_line from, const char *name)
{
    struct shader_source *source = e->source;
    char where[WHERE_SIZE], why[TEXT_FILE_WHY];
    snprintf(where, sizeof where, "%s:%d: #include \"%s\"", source->files[from.file], from.line,
             name);
    static const char *const folders[] = {"/shaders", "/chapters", NULL};
    char *resolved =
        resolve(source, from.file, name, folders, ", in shaders/ or in chapters/", why);
    if (resolved == NULL)
        return report("%s: %s", where, why);
    for (int i = 0; i < source->file_count; i++) {
        if (strcmp(source->paths[i], resolved) != 0)
            continue;
        free(resolved);
        for (int k = 0; k < e->depth; k++)
            if (e->open[k] == i)
                return report_cycle(e, i, where);
        return true;
    }
    if (e->depth == DEPTH_LIMIT) {
        free(resolved);
        return report("%s: more than %d files within each other", where, DEPTH_LIMIT);
    }
    return expand_file(e, add_file(source, name_of(source, name, resolved), resolved), where);
}

// The name in an include that stands alone on its line: no comment crosses the line's ends, so that
// it means there what it means in place. False when it is malformed.
//   hash  where the directive begins, among the tokens
//   line  the line in the text, and its end
static bool quoted_name(const struct glsl *code, const struct glsl_token *hash, const char *line,
                        const char *end, char name[PLATFORM_PATH])
{
    const char *open = code->text + hash[1].begin + hash[1].length;
    open += strspn(open, " \t\v\f");
    size_t length = *open == '"' ? strcspn(open + 1, "\"\n") : 0;
    const char *close = open + length + 1;
    if (length == 0 || length >= PLATFORM_PATH || *close != '"' || end[-1] == '\\' ||
        (hash > code->item && hash[-1].begin + hash[-1].length > line - code->text &&
         hash[-1].line < hash->line))
        return false;
    for (const struct glsl_token *t = hash + 2; t->directive && t->kind != GLSL_HASH; t++) {
        const char *begin = code->text + t->begin;
        if (begin > close && (t->kind < GLSL_COMMENT || begin + t->length > end))
            return false;
    }
    snprintf(name, PLATFORM_PATH, "%.*s", (int)length, open + 1);
    return true;
}

// A #version makes the first file a whole one; anywhere else the driver would refuse it, far from
// its cause.
static bool check_version(struct expansion *e, struct shader_line from, bool first)
{
    const char *file = e->source->files[from.file];
    if (from.file > 0)
        report("%s:%d: #version in an included file: take it out", file, from.line);
    else if (!first)
        report("%s:%d: #version must come first: move it to the top", file, from.line);
    else
        e->source->versioned = true;
    return from.file == 0 && first;
}

// Expand a line of a file; hash is the directive that it begins, or NULL.
static bool expand_line(struct expansion *e, struct shader_line from, const struct glsl *code,
                        const struct glsl_token *hash, const char *line, size_t length)
{
    char name[PLATFORM_PATH];
    bool includes = hash != NULL && glsl_is(code, hash + 1, "include");
    // An author's own #line would blame another line.
    bool comments = includes || (hash != NULL && glsl_is(code, hash + 1, "line"));
    if (includes && !quoted_name(code, hash, line, line + length, name))
        return report("%s:%d: malformed include: write #include \"name.glsl\" alone on its line",
                      e->source->files[from.file], from.line);
    return add_line(e, from, comments ? "// " : "", line, length) &&
           (!includes || include(e, from, name));
}

static bool expand_text(struct expansion *e, int file, const struct glsl *code)
{
    struct shader_line from = {file, 0};
    const struct glsl_token *t = code->item;
    bool first = true;
    for (const char *line = code->text; *line != '\0';) {
        size_t length = strcspn(line, "\n");
        while (t->kind >= GLSL_COMMENT && t->line <= from.line)
            t++;
        const struct glsl_token *hash = t->kind == GLSL_HASH && t->line == from.line ? t : NULL;
        from.line++;
        if ((hash != NULL && glsl_is(code, hash + 1, "version") &&
             !check_version(e, from, first)) ||
            !expand_line(e, from, code, hash, line, length))
            return false;
        for (; t->kind != GLSL_END && t->line < from.line; t++)
            first &= t->kind >= GLSL_COMMENT;
        line += length + 1;
    }
    return true;
}

static bool expand_file(struct expansion *e, int file, const char *where)
{
    char why[TEXT_FILE_WHY];
    char *text = text_file_read(e->source->paths[file], why);
    if (text == NULL)
        return report("%s: %s", where, why);
    struct glsl code;
    bool done = false;
    glsl_read(&code, text);
    e->open[e->depth++] = file;
    if (code.open < 0)
        done = expand_text(e, file, &code);
    else
        report("%s:%d: this comment is never closed: write */ at its end", e->source->files[file],
               code.item[code.count - 1].line + 1);
    e->depth--;
    glsl_free(&code);
    free(text);
    return done;
}

bool shader_refuse(const struct shader_source *source, int line, const char *format, ...)
{
    const struct shader_line *from = &source->lines[line];
    char why[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(why, sizeof why, format, arguments);
    va_end(arguments);
    return report("%s:%d: %s", source->files[from->file], from->line, why);
}

bool shader_expand(struct shader_source *source, const char *path, const char *root,
                   const struct shader_request *request)
{
    struct expansion e = {.source = source};
    char own[PLATFORM_PATH];
    *source = (struct shader_source){.root = platform_resolve(root)};
    if (request != NULL)
        source->request = *request;
    char *resolved = source->root != NULL ? platform_resolve(path) : NULL;
    if (resolved == NULL) {
        report("%s: cannot be read: %s", source->root != NULL ? path : root, platform_why(errno));
        shader_free(source);
        return false;
    }
    tell(source, resolved);
    folder_of(resolved, own);
    source->own = memory_text("%s", own);
    e.text = memory_open(&source->text);
    bool done = expand_file(&e, add_file(source, memory_text("%s", path), resolved), path);
    memory_close(e.text);
    if (!done)
        shader_free(source);
    return done;
}

void shader_free(struct shader_source *source)
{
    for (int i = 0; i < source->file_count; i++) {
        free(source->files[i]);
        free(source->paths[i]);
    }
    free(source->files);
    free(source->paths);
    free(source->lines);
    free(source->text);
    free(source->root);
    free(source->own);
    glsl_free(&source->code);
    *source = (struct shader_source){0};
}
