// panel_rows.h - what the panel says, and the rows of the chapter's panel: built, then measured,
// then drawn by panel_paint. What the pointer is on is found in the same rows, so that what is seen
// is what is touched.
#ifndef PANEL_ROWS_H
#define PANEL_ROWS_H

#include <stdbool.h>

#include "picture/overlay.h"
#include "picture/renderer.h"

// A key's label and what it does.
struct panel_key {
    char label[64];
    const char *does;
};

struct panel_rows; // below
struct picker;

// NULL, 0 and "" leave a part out.
struct panel {
    const char *title;               // of the chapter
    const struct renderer *renderer; // its view and parameters
    const struct parameter *chosen;  // what the arrows change
    double rate, milliseconds;       // frames a second, of one frame
    double time;                     // seconds
    int resolution; // percent of each side at which the picture is drawn; 0 and 100: full
    int sharp;      // percent of it that is sharp all the same
    bool timed;     // the picture depends on the time
    bool paused;
    bool ranges;       // range and unit of all parameters, where the picture has room for them
    bool folded;       // leave out all but the ray's march, in the slice that too, and the error
    bool bare;         // leave out all words but a pair's labels: somebody else says them
    bool right;        // it stands at the right
    bool rolled;       // it is folded to its title
    bool refused;      // it says why what was typed is not taken
    const char *typed; // letters that stand in place of the chosen parameter's value
    const char *tip;   // help for the row that the pointer rests on
    int typed_part;    // the component that the letters are for; -1: all
    float tip_at[2];   // where the pointer is, units from the picture's top left
    struct panel_rows *rows; // takes the rows as they stand, for whoever has a pointer
    struct picker *picker;   // of the chosen colour, which takes its place; NULL: it is not open
    const char *hint;        // what to press; NULL or "": none
    const struct panel_key *keys;
    int key_count;
    int pixel[2];              // whose march is shown, 0,0 bottom left; -1,-1: none
    const char *side;          // whose it is, of two pictures: "left" or "right"
    float shown;               // how many of its steps, as renderer_inputs.shown
    const struct probe *probe; // its march, or NULL: then why says why there is none
    const char *why;
    const char *error; // its lines ended by '\n'; NULL or "": none
    bool broken;       // the error is that of a reload; else it says why a view is refused
};

#define PANEL_GAP    12.0f // units of the overlay, between columns
#define PANEL_SWATCH 10.0f // width of a colour's own colour, in front of its value

enum { PANEL_COLUMNS = 4, PANEL_CELL = 160, PANEL_DETAIL = 2 * PANEL_CELL };

enum panel_row_kind {
    PANEL_ROW_TITLE, // the second cell is the mark that folds the panel, at the row's right end
    PANEL_ROW_TEXT,
    PANEL_ROW_RULE,
    PANEL_ROW_PARAMETER,
    PANEL_ROW_PART,  // one component of the chosen vector
    PANEL_ROW_DETAIL // range and unit of the chosen parameter
};

// One row. Its place is in units of the overlay, from the picture's top left.
struct panel_row {
    enum panel_row_kind kind;
    char cell[PANEL_COLUMNS][PANEL_CELL]; // name, value, range and unit of a parameter; else a text
    int parameter;                        // its index of pair_parameter; -1: none
    int part;                             // of a vector; -1: all of them
    bool chosen;
    double place;    // of the value between its ends, 0 to 1; below 0: nothing to drag
    float swatch;    // of a colour that a pointer can reach: from the row's left to it; 0: none
    double share[3]; // that colour, as shares of the range
    float left, top, width, height;
};

// The panel. One of zeros has no rows.
struct panel_rows {
    struct panel_row *row; // owned
    int count;
    float column[PANEL_COLUMNS];    // widths
    bool ranges;                    // the large form: all four columns
    float left, top, width, height; // of the panel with its edges, units
};

// Build the rows of a panel, leave out what there is no room for, and measure the rest.
//   limit   width of the text at most, where the small form can keep it
//   bottom  of the panel at most
// The rows before are forgotten. Free with panel_rows_free.
void panel_rows_build(struct panel_rows *rows, const struct panel *panel, float limit,
                      float bottom);

// Move them to a place.
void panel_rows_move(struct panel_rows *rows, float left, float top);

// The row at a place in units; NULL where there is none.
const struct panel_row *panel_rows_at(const struct panel_rows *rows, float x, float y);

// True where the panel is, its edges too.
bool panel_rows_hold(const struct panel_rows *rows, float x, float y);

// True at the mark of a title that folds the panel.
bool panel_row_is_mark(const struct panel_row *row, float x);

// True at the swatch of a colour, which opens its picker.
bool panel_row_is_swatch(const struct panel_row *row, float x);

void panel_rows_free(struct panel_rows *rows);

#endif
