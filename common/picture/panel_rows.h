// panel_rows.h - the contents of the panel, and its rows, which are built, measured and then drawn.
// The row under the pointer is looked up among the rows that are drawn.
#ifndef PANEL_ROWS_H
#define PANEL_ROWS_H

#include <stdbool.h>

#include "picture/renderer.h"

// A key's label, and its action.
struct panel_key {
    char label[64];
    const char *does;
};

struct panel_rows; // defined below
struct picker;
struct inspector_table;

// The contents of the panel. If a member is NULL, 0 or "", its part is left out.
struct panel {
    const char *title;                // the chapter's title
    const struct renderer *renderer;  // contains the view and the parameters
    const struct parameter *selected; // the selected parameter, which the arrow keys change
    int selected_part;                // the component that they change; -1 for all
    double rate, milliseconds;        // frames per second, and the time that one picture takes
    double time;                      // seconds
    int resolution; // the drawn picture's sides, in percent of full size; 0 means 100
    int sharp;      // percent of the picture that is already sharp
    bool timed;     // the picture depends on the time
    int averaged;   // number of frames of which the picture is the mean; 0 if it is none
    bool paused;
    bool choice;             // there is more than one view
    bool views;              // list the views below the status
    bool buttons;            // show the row of buttons
    bool peeks;              // show the title of a folded panel, with the mark that unfolds it
    unsigned long long open; // bit k: show parameter k's components even if it is not selected
    bool ranges;             // show the range and unit of all parameters, if there is room
    // Hide the panel, the keys, the note on inputs and, in a slice or plot, the ray's march.
    bool folded;
    bool bare;               // hide the error and the ray's march, because a web page shows both
    bool right;              // the panel is at the right edge
    bool rolled;             // the panel shows only its title
    bool still;              // the pointer is on the panel, so no row should move
    bool refused;            // tip says why the typed value is rejected
    const char *typed;       // text that replaces the selected parameter's value
    const char *tip;         // the tooltip of the row under the pointer
    int typed_part;          // the component that is typed; -1 for all
    float tip_at[2];         // the pointer's position, units from the picture's top left
    struct panel_rows *rows; // receives the rows; NULL if there is no pointer
    struct inspector_table *table; // receives the table of the ray's march; may be NULL
    struct picker *picker; // the selected colour's picker, to be placed and drawn; NULL if closed
    const char *hint;      // one line about the main keys
    const char *note;      // what a key did, or why it does nothing; NULL if there is no note
    const char *note_heading; // the line above the note
    const char *caption;      // caption of a lecture, shown at the bottom
    const struct panel_key *keys;
    int key_count;
    int pixel[2];              // the selected ray's pixel, 0,0 bottom left; -1,-1 if there is none
    const char *side;          // the ray's side of a comparison: "left" or "right"
    float shown;               // number of steps shown, as in renderer_inputs
    const struct probe *probe; // the ray's march, or NULL; then why gives the reason
    const char *why;
    const char *error; // the lines of the error, each ending in '\n'
    bool broken;       // the error comes from a reload; if false, from a view
    const char *unset; // a note on an input that nothing sets, shown if there is no error
};

#define PANEL_GAP    12.0f // distance between columns, units of the overlay
#define PANEL_SWATCH 10.0f // width of a colour's swatch, in front of its value

enum { PANEL_COLUMNS = 4, PANEL_CELL = 160 };

// The cell of the status that is measured and not drawn: the text of a paused picture.
enum { PANEL_WIDEST = 2 };

enum panel_row_kind {
    PANEL_ROW_TITLE,  // the second cell is the mark that collapses the panel, at the right end
    PANEL_ROW_STATUS, // the view, the rate and the time; a click opens or closes the list of views
    PANEL_ROW_VIEW,   // one view of that list; part is the view's index
    PANEL_ROW_TEXT,
    PANEL_ROW_MORE,    // which parameters are shown, if not all; part is the last one's number
    PANEL_ROW_BUTTONS, // one button in each cell
    PANEL_ROW_RULE,
    PANEL_ROW_PARAMETER,
    PANEL_ROW_PART,  // one component of a vector
    PANEL_ROW_DETAIL // range and unit of a parameter
};

// The cells of the row of buttons.
enum panel_button { PANEL_PAUSE, PANEL_STEP_BACK, PANEL_STEP_ON, PANEL_HIDE };

// One row, in units of the overlay from the picture's top left.
struct panel_row {
    enum panel_row_kind kind;
    char cell[PANEL_COLUMNS][PANEL_CELL]; // name, value, range and unit of a parameter; or text
    int parameter;                        // index for comparison_parameter; -1 if there is none
    int part;                             // see the kind, or a component's index; -1 for all
    bool selected;                        // part of the selected parameter, or the current view
    bool current;                         // what the keys change
    double fraction; // position of the value in its range, 0 to 1; < 0 if nothing can be dragged
    float swatch;    // distance of a colour's swatch from the row's left; 0 if there is none
    double share[3]; // the swatch's colour, as fractions of the parameter's range
    float left, top, width, height;
};

// A zero-initialised struct has no rows.
struct panel_rows {
    struct panel_row *row; // owned
    int count;
    int from;                       // the first parameter that is shown, if not all are
    float column[PANEL_COLUMNS];    // widths of the columns
    bool ranges;                    // all four columns are shown, otherwise two
    float left, top, width, height; // the panel with its edges, units
};

// Build and measure the rows of a panel, leaving out those for which there is no room. Earlier rows
// are discarded.
//   limit   maximum width of the text, units, unless two columns are wider
//   bottom  lowest position of the panel's lower edge, units
// Free with panel_rows_free.
void panel_rows_build(struct panel_rows *rows, const struct panel *panel, float limit,
                      float bottom);

// Move the panel to a position.
void panel_rows_move(struct panel_rows *rows, float left, float top);

// Draw the rows of a panel, over its background.
void panel_rows_draw(const struct panel_rows *rows, const struct panel *panel,
                     struct overlay *overlay);

// Return the row at a point in units, or NULL if there is none.
const struct panel_row *panel_rows_at(const struct panel_rows *rows, float x, float y);

// True if a point is in the panel, including its edges.
bool panel_rows_hold(const struct panel_rows *rows, float x, float y);

// Return the button at a position in the row of buttons, an enum panel_button, or -1 if there is
// none.
int panel_row_button(const struct panel_row *row, float x);

// Return the distance of a button from the row's left, in units.
float panel_row_button_left(const struct panel_row *row, int button);

// True if x is on the mark of the title, which collapses the panel or opens it again.
bool panel_row_is_mark(const struct panel_row *row, float x);

// True if x is on the swatch of a colour, which opens the colour's picker.
bool panel_row_is_swatch(const struct panel_row *row, float x);

void panel_rows_free(struct panel_rows *rows);

#endif
