// state.h - what the parts of the window share. For the files of this folder alone.
//
// window.c holds the loop, input.c gathers what the hands do, hand.c says whose the pointer is,
// act.c carries out what keys ask for, draw.c draws frames, title bar and overlay, keys.c lists the
// keys, toy.c knows Shadertoy's inputs.
#ifndef WINDOW_STATE_H
#define WINDOW_STATE_H

#include "picture/overlay.h"
#include "picture/panel.h"
#include "picture/panel_rows.h"
#include "picture/picker.h"
#include "picture/renderer.h"
#include "window/watch.h"
#include "window/input.h"
#include "window/resolution.h"
#include "window/start.h"

#define WINDOW_KEYS 24 // entries of the overlay's list of keys, at most

// Who has the pointer, from a press to the release.
enum window_hand { HAND_NONE, HAND_PANEL, HAND_DIVIDER, HAND_CAMERA };

// What of the panel a press took.
enum window_touched {
    TOUCH_NOTHING,
    TOUCH_TITLE,
    TOUCH_MARK,
    TOUCH_SWATCH,
    TOUCH_PICKER,
    TOUCH_SWITCH,
    TOUCH_VALUE
};

struct window {
    GLFWwindow *handle;
    struct renderer *renderer;
    const struct window_start *start;
    struct window_input input;
    struct watch watch;
    struct renderer_inputs inputs; // of the frame on the screen
    char parameter[64];            // the one that the arrows change
    bool second;                   // it is the second picture's
    struct {
        enum window_hand who;
        bool pressed;           // the picture was, in this turn,
        double press[2], at[2]; // there; and where the pointer was last while it has the picture
    } hand;
    int rectangle[4];  // x, y, width, height before full screen
    bool has_keyboard; // the window had the focus: before that there may be no keyboard at all
    bool turning;      // a turn of the loop is under way
    bool failed;       // one did not succeed
    bool broken;       // the shader's last text: the picture is of the one before
    bool paused;
    bool moved;    // what makes the picture changed in this turn
    bool stale;    // the picture is to be drawn again
    bool dirty;    // the screen is to be shown again
    bool shooting; // a screenshot waits for the sharp picture; time waits too
    struct {
        bool on;        // Tab was pressed: orthographic is on its way
        double towards; // to this value
    } passage;
    struct {
        char shown[300];
        double due; // when it may change
    } title;
    struct {
        double turn, frame; // when the last turn of the loop began, when the last frame began
        double look_at;     // when the shader's files are due
        bool drew;          // the last turn drew a frame
        double rate;        // frames a second, 0 before it is known
        double seconds;     // that drawing the last picture took
        GLuint tried;       // the program whose cost is known
        struct resolution resolution; // at which the picture is drawn
        struct enlarging enlarging;   // it to the window's size
    } pace;
    // At rest a picture that was drawn at a lower resolution is sharpened.
    struct {
        double rest_at;                // from then on nothing moves
        struct renderer_inputs inputs; // of the last picture, at its full size
        int rows;                      // of it, from the top, that are sharp by now
        int band;                      // rows to sharpen next
        double seconds;                // that the rows took
    } sharpening;
    struct {
        struct overlay overlay;
        bool folded;            // H was pressed
        bool elsewhere;         // while it is folded, its words stand beside the picture: in a page
        struct panel_rows rows; // as they are shown
        bool right, rolled;     // it stands at the right; it is folded to its title
        bool helps;             // K was pressed: all keys, all of the parameters
        double figures[2];      // frames a second and milliseconds that it shows
        double figures_at;      // when they may change
        char error[4096];       // of the last reload, or why a view is refused; "" when all is well
        struct panel_key keys[WINDOW_KEYS];
        int key_count;
        char hint[64]; // which key shows more
    } panel;
    // The pointer on the panel.
    struct {
        enum window_touched what;
        int button;        // that it was pressed by: 0 left, 1 right
        int part;          // component of the parameter; -1: all
        double place[4];   // of the components, as far as they are dragged
        float width;       // of the row
        char typed[128];   // while input.typing
        bool fresh;        // the next letter replaces it
        char refused[512]; // why it is not taken
        double notches;    // of the wheel, what is less than one
        int pointed;       // the parameter below the pointer; -1: none
        float at[2];       // the pointer, units of the overlay
        double rests_at;   // since when
        bool tip;          // help is shown
        int cursor;        // which shape the pointer has
        GLFWcursor *cursors[4];
        struct picker picker;    // of the chosen colour, while input.picking
        enum picker_part picked; // of it, by TOUCH_PICKER
    } touch;
    // The ray that is looked at.
    struct {
        struct renderer_eye eye; // where it starts: it stays in space while the camera moves
        double place[2];         // of its pixel's middle, from the screen's, in half its heights
        struct probe *probe;     // owned
        bool follow;             // march it again
        bool tell;               // print its table once it is there
        char why[512];           // there is none because of this; "" when there is one
    } ray;
};

// The parameter that the arrows change: the one last chosen, as long as the shader has it.
struct parameter *window_chosen(const struct window *window);

// From now on it is this one.
void window_choose(struct window *window, const struct parameter *parameter);

// Show chapter, view and parameter in the title bar.
void window_retitle(struct window *window);

// True when Tab has something to drive: a parameter named orthographic, or a whole file that reads
// OrthoView.
bool window_has_orthographic(struct window *window);

// Carry on with the passage from one projection to the other that Tab began.
//   seconds  since the last turn
// Returns true when it changed the picture.
bool window_pass(struct window *window, double seconds);

// Carry out what the pointer did, for whoever has it.
// Returns false for an event that is not the pointer's.
bool window_hand(struct window *window, const struct window_event *event);

// The pointer on the panel: whether it is there; what it does from press to release; its wheel,
// false where the panel is not; where it only points; whether it has rested until now.
bool window_touch_claims(const struct window *window, const double place[2]);
void window_touch(struct window *window, const struct window_event *event);
bool window_touch_wheel(struct window *window, const struct window_event *event);
void window_touch_point(struct window *window, const struct window_event *event);
void window_touch_rest(struct window *window);

// The parameter that the last press took, and which of its components: from first to behind last.
// NULL where it took none.
struct parameter *window_taken(const struct window *window, int *first, int *behind);

// The field in which a value is typed: open it for what the last press took, leave it, type a
// letter; what the panel shows of it.
void window_field_open(struct window *window);
void window_field_leave(struct window *window);
void window_field_type(struct window *window, int code);
void window_field_tell(const struct window *window, struct panel *panel, char tip[512]);

// What the panel shows of it.
//   tip  room for the help's text, which the panel keeps
void window_touch_tell(struct window *window, struct panel *panel, char tip[512]);

// From the window's units to the overlay's; -1,-1 where there is none yet.
void window_overlay_place(const struct window *window, const double place[2], float at[2]);

// A parameter has another value.
void window_changed(struct window *window);

// The picker of the chosen colour, while it is open: open it, close it; whether a place is on it;
// what a press, a double one or a drag does there; what the panel shows. One whose colour is no
// longer shown is closed.
void window_pick_open(struct window *window);
void window_pick_close(struct window *window);
bool window_pick_at(const struct window *window, const double place[2]);
void window_pick(struct window *window, const struct window_event *event);
void window_pick_tell(struct window *window, struct panel *panel);
void window_pick_rest(struct window *window);

// Nobody has the pointer whose button is up.
void window_let_go(struct window *window);

// A click chooses the pixel's ray, and again lets it go.
//   place  in the window's units from its top left
void window_look_at_ray(struct window *window, const double place[2]);

// List the keys with the labels of the keyboard that is there, and the hint which one shows more.
void window_name_keys(struct window *window);

// Choose a pixel's ray, from the camera as it is now. In walk.c, as is all of the ray's.
void window_choose_ray(struct window *window, const int pixel[2]);

// Keep the chosen ray in a picture of another size: its pixel is the one at the ray's place on the
// screen. One beside a picture that has become narrower is let go.
//   width, height  of the new size, pixels
void window_resize_ray(struct window *window, int width, int height);

// Let the chosen ray go.
void window_leave_ray(struct window *window);

// Go along the chosen ray: the middle one where none is chosen and the shader keeps a trace.
//   by  steps on, or back
void window_step(struct window *window, int by);

// Go to the chosen ray's first step, or to its last. Returns false where there is none.
bool window_step_to(struct window *window, bool last);

// March the chosen ray for this frame's parameters and time; one whose pixel the window has no
// longer is let go.
void window_follow_ray(struct window *window);

// Carry out what the hands did since the last turn.
void window_obey(struct window *window);

// True when the screenshot that was asked for can be written: the picture is sharp, or quick to
// draw.
bool window_shoots(const struct window *window);

// True when a press there takes the divider between two pictures.
//   place  in the window's units from its top left
bool window_at_divider(const struct window *window, const double place[2]);

// Bring the divider there.
void window_drag_divider(struct window *window, const double place[2]);

// Of two pictures: give the screenshot that is about to be written the divider and the labels of a
// written picture. Where it has the whole overlay, it has them already.
void window_label_pair(struct window *window);

// Write it.
void window_shoot(struct window *window);

// Bring Shadertoy's iMouse up to this turn: xy where the button was held last, zw where it was
// pressed; z is positive while it is held, w in the one frame of the press. A change draws a frame
// where the shader reads it.
void window_follow_mouse(struct window *window);

// Set Shadertoy's iDate to the local time.
void window_tell_date(struct window *window);

// True when the picture on the screen depends on the time.
bool window_uses_time(const struct window *window);

// True when rows of the picture on the screen are to be sharpened.
//   now  of glfwGetTime
bool window_sharpens(const struct window *window, double now);

// Draw the frame that is due, with the overlay: the picture where it is stale, else a part of the
// sharp one where it is coarse.
//   now  of glfwGetTime
// Returns false, reported.
bool window_draw(struct window *window, double now);

#endif
