// state.h - the state of the window, shared by the modules of this folder.
#ifndef WINDOW_STATE_H
#define WINDOW_STATE_H

#include "picture/handles.h"
#include "picture/inspector.h"
#include "picture/overlay.h"
#include "picture/panel.h"
#include "picture/panel_rows.h"
#include "picture/picker.h"
#include "picture/renderer.h"
#include "picture/target.h"
#include "window/watch.h"
#include "window/input.h"
#include "window/resolution.h"
#include "window/start.h"

#define WINDOW_KEYS 40 // maximum number of entries in the overlay's list of keys

// The part of the window that owns the pointer from a press to the release.
enum pointer_owner {
    OWNER_NONE,
    OWNER_PICKER,
    OWNER_PANEL,
    OWNER_TABLE,
    OWNER_HANDLE,
    OWNER_DIVIDER,
    OWNER_STROKE,
    OWNER_PICTURE
};

// The part of the panel that a press grabbed.
enum panel_grab {
    GRAB_NOTHING,
    GRAB_TITLE,
    GRAB_MARK,
    GRAB_STATUS,
    GRAB_VIEW,
    GRAB_MORE,
    GRAB_BUTTON,
    GRAB_SWATCH,
    GRAB_SWITCH,
    GRAB_VALUE
};

enum pointer_shape { SHAPE_ARROW, SHAPE_HAND, SHAPE_RESIZE, SHAPE_CROSSHAIR, SHAPES };

// A panel that covers a handle when a picture is first shown moves to the right and, if that is not
// enough, collapses. A user who moves it decides.
enum panel_room { ROOM_UNKNOWN, ROOM_MOVED, ROOM_COLLAPSED, ROOM_DECIDED };

struct window {
    GLFWwindow *handle;
    struct renderer *renderer; // the first picture's renderer
    const struct window_start *start;
    struct window_input input;
    struct watch watch;
    struct renderer_inputs inputs; // inputs of the next picture
    char opened[256];              // name of the shader that was dropped; "" if there is none
    char parameter[64];            // name of the selected parameter
    int part;                      // the selected component of a vector; -1 for all
    bool second;                   // the selected parameter belongs to the second picture
    struct {
        enum pointer_owner owner;
        // The pointer on the picture, in pixels of the picture:
        bool pressed;             // the picture was pressed in this iteration of the main loop
        double press[2], last[2]; // position of the press, and last position with the button down
    } pointer;
    float density;     // pixels per CSS pixel of a web page; 0 outside a page
    int rectangle[4];  // x, y, width and height of the window before full screen
    bool has_keyboard; // the window has had the focus; until then, the labels of keys are unknown
    bool turning;      // an iteration of the main loop is running
    bool failed;       // an iteration has failed
    bool broken;       // the newest version of the shader has an error; an older one is shown
    bool compiles;     // the driver is compiling the newest version; an older one is shown
    bool paused;
    bool moved;      // the content of the picture has changed in this iteration
    bool stale;      // the picture must be drawn again
    bool dirty;      // the frame must be shown again
    bool black;      // nothing is seen (key B)
    double unzoomed; // the focal length before the wheel changed it; 0 if it has not
    int opening;     // steps of the middle ray to show once the window is visible
    bool shooting;   // a screenshot waits for the sharp picture, while the time is stopped
    struct {
        bool on;       // Tab was pressed, and the projection is changing
        double target; // the value of orthographic at the end of the transition
    } transition;
    struct {
        char shown[300];
        double due; // when the title may change again
    } title;
    struct {
        double turn, frame; // when the last iteration and the last frame began
        double shown;       // when the scene was first shown
        double watch_due;   // when to check the shader's files again
        bool looks;         // the last iteration checked them
        bool drew;          // the last iteration drew a frame
        double rate;        // frames per second; 0 before it is known
        double seconds;     // time that drawing the last picture took
        GLuint tried;       // the program whose cost has been estimated
        double known;       // pixels of the last picture; it predicts no picture of many more
        struct resolution resolution;
        bool patient; // kept frames are drawn finer, and so more slowly, than they should be
        bool begins;  // they are to begin again for that reason
        bool refines; // a paused mean goes on, finer, because nothing in it moves
    } pace;
    // At rest, a picture that was drawn at a lower resolution is sharpened.
    struct {
        double due;                    // when the picture has been at rest for long enough
        struct renderer_inputs inputs; // inputs of the last picture, at full size
        int rows;                      // number of sharp rows, from the top
        int columns;                   // number of sharp pixels in the row below them
        double next;                   // number of pixels to sharpen next
        double seconds;                // time that drawing the sharp pixels took
        bool smooths;                  // they are drawn for the second time, with smooth edges
    } sharpening;
    struct {
        struct overlay overlay;
        struct panel_rows rows; // the rows as they are shown
        struct inspector_table table;
        bool folded;              // the panel is hidden, as with key H
        bool captioned;           // the caption is shown, if there is one
        bool in_page;             // a web page shows the panel's text while the panel is folded
        bool right, rolled;       // the panel is on the right; the panel is collapsed to its title
        enum panel_room room;     // what the panel has done so that no handle is below it
        bool peeks;               // the pointer is where the folded panel shows its title
        bool views;               // the list of views is open
        unsigned long long open;  // parameters whose components stay shown, as in struct panel
        bool helps;               // all keys and the ranges of all parameters are shown (key K)
        double figures[2];        // frames per second and milliseconds, as shown
        double figures_due;       // when the figures may change again
        char note[1024];          // what a key did, or why it does nothing; "" if no note is shown
        const char *note_heading; // the line above the note
        double note_ends;         // when it disappears
        unsigned told;            // the notes that have been shown: a bit for each key_condition
        char error[4096];         // the error that the panel shows; "" if there is none
        struct panel_key keys[WINDOW_KEYS];
        int key_count;
        char hint[96]; // names the keys that list more or fewer keys, and that deselect a ray,
                       // bring the camera back or hide the overlay
    } panel;
    struct {
        int scenes, part, scene; // as window_asked returns them
    } asked;
    // The sheet of contents.
    struct {
        bool open;
        int chosen;                // the item that the frame marks
        const struct contents *of; // whose pictures are on the sheet; NULL before the first time
        struct target sheet;       // the pictures, at the size of the window
    } contents;
    // The panel's input.
    struct {
        enum panel_grab what;
        int button;         // button of the last press: 0 left, 1 right
        int part;           // the grabbed component of the selected parameter; -1 for all
        double fraction[4]; // position of each component in its range, as dragged
        float width;        // width of the grabbed row, in units of the overlay
        char typed[128];    // the typed text while input.typing is set
        bool fresh;         // the next character replaces typed
        char refused[512];  // why the typed value was refused; "" if it was not
        double notches;     // movement of the wheel that has had no effect yet, less than one notch
        int choice;         // the view or the button that was pressed
        int hovered;        // the parameter under the pointer; -1 if there is none
        float at[2];        // position of the pointer, in units of the overlay; negative if outside
        double rests_since;
        bool tip;                // the tooltip of the hovered parameter is shown
        struct picker picker;    // picker of the selected colour, while input.picker_open is set
        enum picker_part picked; // the part that the pointer has grabbed
    } grab;
    enum pointer_shape shape; // the pointer's current shape
    GLFWcursor *cursor[SHAPES];
    struct {
        struct handle item[HANDLES_MOST]; // the handles as the last frame shows them
        int count;
        int focused;                 // index of the focused handle; -1 if there is none
        bool moving;                 // the focused handle moves to target
        double offset[2], target[2]; // offset from pointer to handle, and target, in pixels
    } handles;
    // The selected ray.
    struct {
        struct renderer_eye eye; // the ray's camera and lens, fixed while the picture's change
        double position[2];      // of the ray's pixel from the centre, in half picture heights
        struct probe *probe;     // owned
        bool follow;             // the ray must be marched again
        bool print;              // the table of the march must be printed
        char why[512];           // why the ray has no march; "" if it has one
    } ray;
};

#endif
