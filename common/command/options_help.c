#include "command/options.h"

#include <string.h>

#include "window/keys.h"

// Print a text in lines of at most 78 characters, the first of which has already begun.
//   indent  characters before the text of each line
static void print_wrapped(FILE *file, const char *text, int indent)
{
    for (int at = indent; *text != '\0';) {
        int word = (int)strcspn(text, " ");
        if (at > indent && at + 1 + word > 78) {
            fprintf(file, "\n%*s", indent, "");
            at = indent;
        } else if (at > indent)
            at += fprintf(file, " ");
        at += fprintf(file, "%.*s", word, text);
        text += word + (text[word] == ' ');
    }
    fprintf(file, "\n");
}

// Print the keys, those that change the scene last.
static void print_keys(FILE *file)
{
    const int indent = 21;
    if (window_keys->label != NULL)
        fprintf(file,
                "In the window, with keys named by their position on an American keyboard:\n");
    for (int scenes = 0; scenes < 2; scenes++)
        for (const struct key_row *row = window_keys; row->label != NULL; row++) {
            int width = 0; // characters, of which an arrow has three bytes
            for (const char *c = row->label; *c != '\0'; c++)
                width += ((unsigned char)*c & 0xC0) != 0x80;
            if ((row->condition >= KEY_WITH_SCENES) != scenes)
                continue;
            fprintf(file, "  %s%*s", row->label, indent - 2 - width, "");
            print_wrapped(file, row->meaning, indent);
        }
    fprintf(file, "\n");
}

void options_print_help(FILE *file, const char *program, const char *title, const char *shows)
{
    const int width = 30; // characters of the longest option
    fprintf(file, "Usage: %s [OPTION]...\n\n%s\n%s\n\n", program, title, shows);
    fprintf(file, "Without --output, --probe or --benchmark, a window opens.\n\n");
    for (const struct options_row *row = options_rows; row->name != NULL; row++) {
        fprintf(file, "  %3s --%s%-*s  %s\n", row->letter, row->name,
                width - 6 - (int)strlen(row->name), row->value, row->meaning);
        if (row->initial[0] != '\0')
            fprintf(file, "  %*s  default: %s\n", width, "", row->initial);
    }
    fprintf(file, "\n");
    print_keys(file);
    fprintf(file, "Exit status: 0 success; 1 failure; 2 the command line is wrong;\n"
                  "3 no window can be opened here.\n");
}
