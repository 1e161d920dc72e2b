#include "command/options.h"

#include <string.h>

static const char ending[] =
    "In the window:\n"
    "  W A S D            move, by the keys' places on an American keyboard\n"
    "  Space, C           up, down (or Left Ctrl); Left Shift or F: faster\n"
    "  drag               look, or the divider of --compare; M captures and frees the mouse\n"
    "  click              choose a pixel's ray and show its march; again hides it\n"
    "  E, Q               a step on along the ray, and back; held they run; also Page Down, Up\n"
    "  Home, End, X       its first and last step; let it go\n"
    "  wheel              focal length; in the slice and the plot their zoom\n"
    "  Tab                perspective or orthographic, where the shader has both\n"
    "  1 2 3 4 5 6        views: picture, normals, depth, steps, slice, plot\n"
    "  up, down           choose a parameter\n"
    "  left, right        change it, with Shift ten steps; Delete resets it\n"
    "  Escape, R          pause and resume; restart the time, with Shift the camera too\n"
    "  H, K               hide and show the overlay; all keys and ranges in it\n"
    "  O, T               its panel to the other side; to its title alone, and back\n"
    "  P, F11             write a screenshot; full screen\n"
    "  Backspace          end\n\n"
    "Exit status: 0 done; 1 it could not be done; 2 the command line is wrong;\n"
    "3 no window can be opened here.\n";

void options_print_help(FILE *file, const char *program, const char *title, const char *shows)
{
    const int width = 30; // of the longest option
    fprintf(file, "Usage: %s [OPTION]...\n\n%s\n%s\n\n", program, title, shows);
    fprintf(file, "Without --output, --probe or --benchmark a window opens.\n\n");
    for (const struct options_row *row = options_rows; row->name != NULL; row++) {
        fprintf(file, "  %3s --%s%-*s  %s\n", row->letter, row->name,
                width - 6 - (int)strlen(row->name), row->value, row->meaning);
        if (row->initial[0] != '\0')
            fprintf(file, "  %*s  default: %s\n", width, "", row->initial);
    }
    fprintf(file, "\n%s", ending);
}
