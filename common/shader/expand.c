#include "shader/files.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "context/gl.h"
#include "memory.h"
#include "platform.h"
#include "report.h"
#include "shader/dialects.h"

#define TEXT_LIMIT  (8 * 1024 * 1024) // maximum size of the expanded text, in bytes
#define DEPTH_LIMIT 64                // maximum number of files open at once, including the first
#define BLANKS      " \t\v\f"
#define WHERE_SIZE  (3 * PLATFORM_PATH) // room for FILE:LINE: #include "NAME"

// ---- Includes ----

// An expansion in progress.
struct expansion {
    struct shader_source *source;
    struct glsl_reader reader; // scans the source's text
    int open[DEPTH_LIMIT];     // indices of the files from the first to the one being read
    int depth;
};

static bool expand_file(struct expansion *e, int file, const char *where);

// Report an include that would make a file include itself, and list the files in between.
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
    return report("%s: the file includes itself: %s%s: remove one of these includes", where, chain,
                  e->source->files[file]);
}

// Insert the file that an include names, unless it has been inserted already.
static bool include(struct expansion *e, struct shader_line from, const char *name)
{
    static const char *const folders[] = {"/shaders", "/chapters", NULL};
    struct shader_source *source = e->source;
    char where[WHERE_SIZE], why[TEXT_FILE_WHY];
    snprintf(where, sizeof where, "%s:%d: #include \"%s\"", source->files[from.file], from.line,
             name);
    if (strncmp(name, "http", 4) == 0)
        return report("%s: files are not downloaded: save this one beside the shader and include "
                      "the copy",
                      where);
    const char *also = source->include != NULL     ? ", in --include, in shaders/ or in chapters/"
                       : strchr(name, '/') == NULL ? ", in shaders/ or in chapters/"
                       : GL_IS_ES ? ", in shaders/ or in chapters/: drop the folder that has it"
                                  : ", in shaders/ or in chapters/: give --include DIR, the folder "
                                    "that has it";
    int count = source->file_count;
    int file = files_find(source, from.file, name, folders, also, why);
    if (file < 0)
        return report("%s: %s", where, why);
    for (int i = 0; i < e->depth; i++)
        if (e->open[i] == file)
            return report_cycle(e, file, where);
    if (file == count && e->depth == DEPTH_LIMIT)
        return report("%s: more than %d nested includes", where, DEPTH_LIMIT);
    return file < count || expand_file(e, file, where);
}

// Read the rest of an include: a name in quotes, followed only by comments that end on this line.
// Returns false if it is malformed.
static bool quoted_name(const char *c, char name[PLATFORM_PATH])
{
    c += strspn(c, BLANKS);
    size_t length = *c == '"' ? strcspn(c + 1, "\"\n") : 0;
    if (length == 0 || length >= PLATFORM_PATH || c[length + 1] != '"')
        return false;
    snprintf(name, PLATFORM_PATH, "%.*s", (int)length, c + 1);
    for (c += length + 2;; c += 2) {
        const char *end = c + strcspn(c, "\n");
        c += strspn(c, BLANKS);
        if (c == end || (c[0] == '/' && c[1] == '/'))
            return end[-1] != '\\';
        c = c[0] == '/' && c[1] == '*' ? strstr(c + 2, "*/") : NULL;
        if (c == NULL || c > end)
            return false;
    }
}

static bool take_include(struct expansion *e, struct shader_line at, const char *rest)
{
    char name[PLATFORM_PATH];
    if (quoted_name(rest, name))
        return include(e, at, name);
    const char *file = e->source->files[at.file];
    rest += strspn(rest, BLANKS);
    int length = (int)strcspn(rest, ">\n");
    if (rest[0] == '<' && rest[length] == '>' && length < PLATFORM_PATH)
        return report(
            "%s:%d: #include %.*s>: a part of a library, such as three.js or lygia, which "
            "is not available here: remove the line, or copy the code that it includes",
            file, at.line, length, rest);
    return report("%s:%d: malformed include: write #include \"name.glsl\" alone on its line", file,
                  at.line);
}

// ---- Lines ----

// Append the lines that have ended to the source's list of lines.
static void end_lines(struct shader_source *source, struct shader_line *from)
{
    for (; source->line_count < source->code.lines; from->line++) {
        source->lines = memory_row(source->lines, source->line_count, sizeof *source->lines);
        source->lines[source->line_count++] = *from;
    }
}

// Obey a directive that is not meant for the driver: the directive becomes a comment, or another
// line. #line becomes a comment, because it would make the driver blame another line.
//   line  moves past the directive
//   done  receives false if there was an error, which has been reported
// Returns false for any other line.
static bool take_directive(struct expansion *e, struct shader_line *from, const char **line,
                           bool *done)
{
    const char *word = *line + strspn(*line, BLANKS);
    if (*word != '#' || !e->reader.live)
        return false;
    word += 1 + strspn(word + 1, BLANKS);
    size_t length = 0;
    while (glsl_is_word(word[length]))
        length++;
    const struct shader_line at = *from;
    char *instead = NULL;
    bool includes = length == 7 && strncmp(word, "include", 7) == 0;
    *done = true;
    if (!includes && !(length == 4 && strncmp(word, "line", 4) == 0) &&
        (dialects.obey == NULL || !dialects.obey(e->source, at, word, length, &instead, done)))
        return false;
    if (instead != NULL) {
        const char *c = instead;
        glsl_take_line(&e->reader, &c);
        *line += strcspn(*line, "\n") + 1;
    } else
        glsl_take_comment(&e->reader, line);
    free(instead);
    end_lines(e->source, from);
    if (includes)
        *done = take_include(e, at, word + length);
    return true;
}

// Check the directive in the tokens of a line. A #version is allowed only at the top of the first
// file: anywhere else, the driver would refuse the #version with a misleading message.
//   first  only comments come before the directive
static bool check_directive(struct expansion *e, struct shader_line at,
                            const struct glsl_token *hash, bool first)
{
    const struct glsl *code = &e->source->code;
    const char *file = e->source->files[at.file];
    const struct glsl_token *end = code->item + code->count;
    if (hash + 1 >= end || !hash->live)
        return true;
    if (glsl_is(hash + 1, "include")) // the directive follows a comment, or a comment divides it
        return take_include(e, at, "");
    if (!glsl_is(hash + 1, "version"))
        return true;
    if (at.file > 0)
        return report("%s:%d: #version in an included file: remove it", file, at.line);
    bool number = hash + 2 < end && hash[2].kind == GLSL_NUMBER;
    e->source->version = number ? atoi(hash[2].text) : 1;
    return first || report("%s:%d: #version must come first: move it to the top", file, at.line);
}

static bool expand_text(struct expansion *e, int file, const char *text)
{
    struct shader_source *source = e->source;
    const struct glsl *code = &source->code;
    struct shader_line from = {file, 1};
    bool first = true, done = true;
    while (done && *text != '\0') {
        if (take_directive(e, &from, &text, &done)) {
            first = false;
            continue;
        }
        int begin = code->count;
        glsl_take_line(&e->reader, &text);
        if (code->open)
            return report("%s:%d: this comment is never closed: write */ at its end",
                          source->files[file],
                          from.line + code->item[code->count - 1].line - source->line_count);
        if (code->length > TEXT_LIMIT)
            return report(
                "%s:%d: the text exceeds 8 MiB with its includes: include fewer or smaller files",
                source->files[file], from.line);
        for (int i = begin; done && i < code->count; i++) {
            const struct glsl_token *token = &code->item[i];
            struct shader_line at = {file, from.line + token->line - source->line_count};
            done = token->kind != GLSL_HASH || check_directive(e, at, token, first);
            first &= token->kind >= GLSL_COMMENT;
        }
        end_lines(source, &from);
    }
    return done;
}

static bool expand_file(struct expansion *e, int file, const char *where)
{
    char why[TEXT_FILE_WHY];
    char *text = text_file_read(e->source->paths[file], why);
    char *part[2] = {0};
    bool done = true, unpacked = file == 0 && dialects.unpack != NULL &&
                                 dialects.unpack(e->source, text, part, &done);
    if (text == NULL && !unpacked)
        return report("%s: %s", where, why);
    e->open[e->depth++] = file;
    if (unpacked) {
        done = done && expand_text(e, 0, part[0]) && expand_text(e, 0, part[1]);
        free(part[0]);
        free(part[1]);
    } else
        done = expand_text(e, file, text);
    e->depth--;
    free(text);
    return done;
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
    const char *include = source->request.include;
    source->include = include != NULL ? platform_resolve(include) : NULL;
    if (include != NULL && source->include == NULL) {
        report("--include %s: cannot be read: %s", include, platform_why(errno));
        free(resolved);
        shader_free(source);
        return false;
    }
    if (resolved == NULL) {
        struct platform_file file;
        int why = errno;
        if (source->root != NULL && platform_look(path, &file) && !file.regular)
            report("%s: a pipe, which can be read only once: save the text in a file", path);
        else
            report("%s: cannot be read: %s", source->root != NULL ? path : root, platform_why(why));
        shader_free(source);
        return false;
    }
    files_visit(source, resolved);
    files_folder(resolved, own);
    source->own = memory_text("%s", own);
    glsl_begin(&e.reader, &source->code);
    bool done = expand_file(&e, files_add(source, memory_text("%s", path), resolved), path);
    glsl_end(&e.reader);
    source->text = source->code.text;
    if (!done)
        shader_free(source);
    return done;
}
