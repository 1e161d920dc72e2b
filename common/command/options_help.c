#include "command/options.h"

#include <string.h>

static const char ending[] =
    "In the window, with keys named by their position on an American keyboard:\n"
    "  W A S D            move\n"
    "  Space, C           move up, down (or Left Ctrl); Left Shift or F: faster\n"
    "  drag               look around, or move the divider of --compare\n"
    "  M                  capture or release the mouse\n"
    "  click              select a pixel's ray and show its march; again: deselect it\n"
    "                     on a step of its table: go to that step\n"
    "  E, Q               step forward, back along the ray; also Page Down, Page Up\n"
    "  Home, End, X       first step, last step; deselect the ray\n"
    "  wheel              focal length; zoom in the slice and the plot\n"
    "  Tab                perspective or orthographic, if the shader has both\n"
    "  1 2 3 4 5 6        view: picture, normals, depth, steps, slice, plot\n"
    "  up, down           select a parameter\n"
    "  left, right        change it, with Shift by ten steps; Delete: reset it\n"
    "  Enter              focus the next handle, which the arrow keys then move\n"
    "  drag, U            in chapter 23 with tool set: change the clay; undo the last\n"
    "                     stroke, with Shift all\n"
    "  Escape, R          pause or resume; restart the time, with Shift the camera too\n"
    "  H, K               hide or show the overlay; show all keys and ranges\n"
    "  O, T               move the panel to the other side; collapse or expand it\n"
    "  P, F11             save a screenshot; full screen\n"
    "  Backspace          quit\n\n"
    "Exit status: 0 success; 1 failure; 2 the command line is wrong;\n"
    "3 no window can be opened here.\n";

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
    fprintf(file, "\n%s", ending);
}
