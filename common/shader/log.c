#include "shader/compile.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "shader/glsl.h"

#define NAME_SIZE   128 // bytes of a function's name in a link error, including the final '\0'
#define LINE_LIMIT  160 // maximum number of bytes shown of a source line
#define ERROR_LIMIT 20  // maximum number of errors shown; the first ones usually cause the others

// An explanation in progress.
struct explanation {
    const struct shader_source *source;
    int prelude; // number of lines of the prelude, before the source's text
    FILE *text;
    int shown;       // the line of the expanded text that was shown last; 0 if there is none
    int errors;      // number of the log's messages so far
    bool has_errors; // the log has an error, from which its warnings would distract
};

// The content of one line of a log.
struct message {
    int line; // line of the compiled text, or 0 if unknown
    bool warning;
    const char *text; // without the position and the kind of message, but with the driver's code
};

static const char *skip_blanks(const char *c)
{
    return c + strspn(c, " \t");
}

// Read "0:12(3): error: text" (Mesa), "0(12) : error C1008: text" (NVIDIA), or "ERROR: 0:12: text".
static struct message read_message(const char *log)
{
    static const char *const begins[] = {"ERROR: ", "WARNING: "};
    static const char *const kinds[] = {"error", "warning", "preprocessor error", "fatal error",
                                        "preprocessor warning"};
    struct message message = {.text = log};
    int line = 0, end = 0;
    for (int i = 0; i < 2; i++)
        if (strncmp(log, begins[i], strlen(begins[i])) == 0) {
            message.text += strlen(begins[i]);
            message.warning = i == 1;
        }
    if (isdigit((unsigned char)*message.text))
        (void)((sscanf(message.text, "%*8d:%8d(%*8d) : %n", &line, &end) == 1 && end > 0) ||
               (sscanf(message.text, "%*8d(%8d) : %n", &line, &end) == 1 && end > 0) ||
               sscanf(message.text, "%*8d:%8d : %n", &line, &end));
    message.line = end > 0 ? line : 0;
    message.text += end;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        const char *rest = message.text + strlen(kinds[i]);
        if (strncmp(message.text, kinds[i], strlen(kinds[i])) != 0 ||
            (*rest != ':' && *rest != ' '))
            continue;
        message.warning |= strstr(kinds[i], "warning") != NULL;
        message.text = skip_blanks(rest + (*rest == ':'));
        break;
    }
    return message;
}

// A link error names a function, but no line: `foo', "float foo(vec3);" or foo( . Find the first
// call of such a name. If there is none and the name is in quotes, it may be an input, so find its
// first mention.
// Returns the line of the expanded text, from 1, or 0 if there is none.
static int line_of_call(const struct explanation *e, const char *log)
{
    for (const char *c = log; *c != '\0';) {
        size_t length = 0;
        while (glsl_is_word(c[length]))
            length++;
        char name[NAME_SIZE];
        bool quoted = length > 0 && c > log && strchr("`'\"", c[-1]) != NULL && c[length] != '\0' &&
                      strchr("'\"", c[length]) != NULL;
        if (length > 0 && length < sizeof name && (quoted || *skip_blanks(c + length) == '(')) {
            snprintf(name, sizeof name, "%.*s", (int)length, c);
            const struct glsl_token *call = glsl_find_call(&e->source->code, name);
            if (call == NULL && quoted)
                call = glsl_find(&e->source->code, name);
            if (call != NULL)
                return call->line + 1;
        }
        c += length > 0 ? length : 1;
    }
    return 0;
}

// The line of the expanded text to which a message refers, from 1, or 0 if there is none. If a text
// ends too early, drivers blame a line past its last one.
static int expanded_line(const struct explanation *e, const struct message *message)
{
    int line = message->line - e->prelude, count = e->source->line_count;
    bool translated = e->source->body != NULL;
    if (message->line == 1 && translated && e->source->version > 0)
        return glsl_code(e->source->code.item)->line + 1; // the author's own #version
    if (message->line == 0 || line < 1 || (line > count + 1 && !translated))
        return 0;
    return line > count ? count : line;
}

// Write a line as its author wrote it.
static void put_source(const struct explanation *e, int line)
{
    const char *text = e->source->text;
    for (int i = 1; i < line; i++)
        text = strchr(text, '\n') + 1;
    text = skip_blanks(text);
    int length = (int)strcspn(text, "\n");
    bool cut = length > LINE_LIMIT;
    fprintf(e->text, "    %.*s%s\n", cut ? LINE_LIMIT : length, text, cut ? "..." : "");
}

// Name a character that is not part of GLSL, such as an accented letter in a name, or a space or a
// quotation mark from a word processor. Drivers blame whatever follows it.
static void put_foreign_character(const struct explanation *e, int line)
{
    const struct glsl_token *t = e->source->code.item;
    while (t->kind != GLSL_END && (t->line < line - 1 || (unsigned char)t->sign < 0x80))
        t++;
    const char *code = e->source->code.text + t->begin;
    if (t->kind == GLSL_END || t->line != line - 1)
        return;
    int length = 1;
    while (length < 4 && ((unsigned char)code[length] & 0xC0) == 0x80)
        length++;
    if (strncmp(code, "\xC2\xA0", 2) == 0)
        fputs("only ASCII characters are allowed here; found a no-break space: ", e->text);
    else
        fprintf(e->text, "only ASCII characters are allowed here; found '%.*s': ", length, code);
}

// Drivers blame a missing semicolon on the line of the next statement, so also name the line where
// it may be missing.
//   line  of the expanded text, from 1
static void put_line_before(const struct explanation *e, const char *text, int line)
{
    const struct glsl_token *t = e->source->code.statement;
    if (strstr(text, "syntax error") == NULL && strstr(text, "unexpected") == NULL)
        return;
    while (t->kind != GLSL_END && t->line < line - 1)
        t++;
    // The token before the first statement is an end token.
    if (t->kind == GLSL_END || t->line != line - 1 || t[-1].kind == GLSL_END)
        return;
    const struct shader_line *from = &e->source->lines[line - 1];
    const struct shader_line *before = &e->source->lines[t[-1].line];
    bool ended = t[-1].kind == GLSL_SIGN && strchr(")]", t[-1].sign) == NULL;
    if (!ended && before->file == from->file)
        fprintf(e->text, ", or at the end of line %d", before->line);
}

static void explain_line(struct explanation *e, const char *log)
{
    struct message message = read_message(log);
    int line = expanded_line(e, &message);
    if (message.line != 0 && e->has_errors && message.warning)
        return;
    if (line == 0 && message.line <= e->prelude)
        line = line_of_call(e, log);
    if (line == 0) {
        e->shown = 0;
        fprintf(e->text, "%s\n", log);
        return;
    }
    const struct shader_line *from = &e->source->lines[line - 1];
    bool again = line == e->shown;
    e->shown = line;
    fprintf(e->text, "%s:%d: %s: ", e->source->files[from->file], from->line,
            message.warning ? "warning" : "error");
    if (!again)
        put_foreign_character(e, line);
    fputs(message.text, e->text);
    put_line_before(e, message.text, line);
    fputs("\n", e->text);
    if (!again)
        put_source(e, line);
}

// True if an earlier line of the log is the same.
static bool is_repeated(const char *log, const char *line, size_t length)
{
    for (const char *c = log; c < line; c += strcspn(c, "\n") + 1)
        if (strcspn(c, "\r\n") == length && strncmp(c, line, length) == 0)
            return true;
    return false;
}

// Explain each line of the log, or only find out whether it has an error.
static void explain_lines(struct explanation *e, const char *log, bool only_look)
{
    for (const char *c = log; *c != '\0';) {
        size_t length = strcspn(c, "\n"), trimmed = length;
        while (trimmed > 0 && strchr(" \t\r", c[trimmed - 1]) != NULL)
            trimmed--;
        if (trimmed > 0 && !is_repeated(log, c, trimmed)) {
            char *line = memory_text("%.*s", (int)trimmed, c);
            struct message message = read_message(line);
            e->has_errors |= message.line != 0 && !message.warning;
            if (!only_look && ++e->errors <= ERROR_LIMIT)
                explain_line(e, line);
            free(line);
        }
        c += length + (c[length] == '\n');
    }
}

char *shader_explain(const struct shader_source *source, enum shader_view view, const char *log)
{
    char *text;
    struct explanation e = {.source = source, .text = memory_open(&text)};
    char *prelude = shader_prelude(source, view);
    for (const char *c = prelude; *c != '\0'; c++)
        e.prelude += *c == '\n';
    free(prelude);
    explain_lines(&e, log, true);
    explain_lines(&e, log, false);
    if (e.errors > ERROR_LIMIT)
        fprintf(e.text, "and %d more\n", e.errors - ERROR_LIMIT);
    memory_close(e.text);
    return text;
}
