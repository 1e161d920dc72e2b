#include "lib/events.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "lib/gpu.h"
#include "lib/scratch.h"
#include "lib/user.h"
#include "shader/text_file.h"
#include "window/keys.h"

// The generator SplitMix64.
int events_random(uint64_t *state, int count)
{
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (int)((z ^ (z >> 31)) % (uint64_t)count);
}

// ---- The files ----

#define DRAWN                                                                                      \
    "#include \"main.glsl\"\n#include \"camera.glsl\"\n"                                           \
    "Ray pixelRay(vec2 screen) { return perspectiveRay(screen); }\n"                               \
    "float sceneDistance(vec3 p) { return length(p) - 1.0; }\n"

// NULL is the text of the chapter's shader.
static const char *const texts[] = {
    NULL,
    DRAWN "vec3 rayColour(Ray ray) { return vec3(undeclared); }\n",
    DRAWN "vec3 rayColour(Ray ray) { trace.end = 1000000; trace.steps = -7; return vec3(0.5); }\n",
    DRAWN "vec3 rayColour(Ray ray) { float t = march(ray); trace.end = -2147483647 - 1;\n"
          "    trace.steps = 2147483647; return vec3(t); }\n",
    "uniform float amount; // 1 in [0, 4]: how much\nuniform vec3 tint; // colour 1, 0, 0: tint\n"
    "uniform int kind; // 1 in [0, 3]: kind\n" DRAWN
    "vec3 rayColour(Ray ray) { return march(ray) * amount * tint + float(kind); }\n",
    "uniform vec3 shadowOffset; // (1, 2, 3) in [0, 4]: another type than the chapter's\n" DRAWN
    "vec3 rayColour(Ray ray) { return shadowOffset; }\n",
    "#include \"missing.glsl\"\n",
    "#include \"03_sha",
    "",
    "\x7f\x45LF\x01\xff\xfe\xe9",
    "void mainImage(out vec4 c, in vec2 p) { c = vec4(p / iResolution.xy, sin(iTime), 1.0); }\n",
    "void main() { gl_FragColor = vec4(1.0); }\n",
    "#version 330\nout vec4 c;\nvoid main() { discard; }\n",
    "#include \"00_first_scene.frag\"\n",
    "#include \"11_antialiasing.frag\"\n",
    DRAWN "vec3 rayColour(Ray ray) { return vec3(0.0 / 0.0, 1.0 / 0.0, -1.0 / 0.0); }\n",
};
enum { TEXTS = sizeof texts / sizeof *texts };

const char *const events_file[EVENTS_FILES] = {"mine.frag", "other.frag"};

static const char *text_of(const char *own, int text)
{
    static char *first, path[8192], why[TEXT_FILE_WHY];
    if (texts[text] != NULL)
        return texts[text];
    snprintf(path, sizeof path, "%s/chapters/%s.frag", gpu_project_root(), own);
    free(first);
    first = text_file_read(path, why);
    if (first == NULL)
        abort();
    return first;
}

void events_save(const char *own, int file, int text)
{
    if (text < TEXTS)
        scratch_write(events_file[file], text_of(own, text));
    else
        remove(scratch_path(events_file[file]));
}

// ---- Random gestures ----

// Keys that the table of window/keys.h does not have: those that act while they are held, a digit
// of the number pad, V for the clipboard, and some that do nothing.
static const int other_keys[] = {GLFW_KEY_W,    GLFW_KEY_A,          GLFW_KEY_S,
                                 GLFW_KEY_D,    GLFW_KEY_SPACE,      GLFW_KEY_C,
                                 GLFW_KEY_F,    GLFW_KEY_LEFT_SHIFT, GLFW_KEY_LEFT_CONTROL,
                                 GLFW_KEY_KP_5, GLFW_KEY_9,          GLFW_KEY_V,
                                 GLFW_KEY_F12};
enum { OTHER_KEYS = sizeof other_keys / sizeof *other_keys };

static const char *const clipboards[] = {NULL,
                                         "",
                                         "0.5",
                                         "-1e999",
                                         "nan",
                                         "1\n2\t3",
                                         "\xc3\xa9\xe2\x82",
                                         "000000000000000000000000000000000"};
enum { CLIPBOARDS = sizeof clipboards / sizeof *clipboards };

const char *events_clipboard(int text)
{
    return clipboards[text];
}

enum { DROPPED = EVENTS_FILES + 4 };

const char *events_dropped(int file)
{
    static const char *const others[DROPPED - EVENTS_FILES] = {
        "tests/references/03_shadows.png", "missing.png", "mesh.obj", "missing.frag"};
    static char path[4096];
    if (file < EVENTS_FILES)
        return scratch_path(events_file[file]);
    snprintf(path, sizeof path, "%s/%s", gpu_project_root(), others[file - EVENTS_FILES]);
    return path;
}

struct maker {
    uint64_t *state;
    struct event *events;
    int count, made;
    double x, y; // the pointer
};

static int any(struct maker *maker, int count)
{
    return events_random(maker->state, count);
}

static void add(struct maker *maker, struct event event)
{
    if (maker->made < maker->count)
        maker->events[maker->made++] = event;
}

// Half of the events are followed by an iteration, so that the program also gets many at once.
static void turns(struct maker *maker)
{
    if (any(maker, 2) == 0)
        add(maker, (struct event){.kind = EVENTS_TURNS, .i = any(maker, 8) == 0 ? 20 : 1});
}

static void point(struct maker *maker, double x, double y)
{
    maker->x = x;
    maker->y = y;
    add(maker, (struct event){.kind = EVENTS_POINT, .x = x, .y = y});
}

// Somewhere in the window, or in the panel at its left, where more reacts to the pointer.
static void point_anywhere(struct maker *maker)
{
    bool panel = any(maker, 3) == 0;
    point(maker, any(maker, panel ? 200 : 340) - 10, any(maker, 220) - 10);
}

// Most of the keys are those of the table, so that a new row is tried too. Backspace would end the
// sequence.
static int any_key(struct maker *maker)
{
    int key = other_keys[any(maker, OTHER_KEYS)], seen = 0;
    if (any(maker, 4) == 0)
        return key;
    for (const struct key_row *row = window_keys; row->label != NULL; row++)
        for (int i = 0; i < KEY_BINDINGS; i++) {
            const struct key_binding *at = &row->binding[i];
            for (int k = at->key; k > 0 && k < at->key + (at->count > 0 ? at->count : 1); k++)
                if (k != GLFW_KEY_BACKSPACE && any(maker, ++seen) == 0)
                    key = k;
        }
    return key;
}

static void press_key(struct maker *maker)
{
    int key = any_key(maker);
    int modifiers = any(maker, 4) == 0    ? GLFW_MOD_SHIFT
                    : any(maker, 16) == 0 ? GLFW_MOD_CONTROL
                                          : 0;
    add(maker, (struct event){.kind = EVENTS_PRESS, .i = key, .k = modifiers});
    while (any(maker, 4) == 0)
        add(maker, (struct event){.kind = EVENTS_REPEAT, .i = key, .k = modifiers});
    turns(maker);
    if (any(maker, 10) != 0) // otherwise, the release is lost
        add(maker, (struct event){.kind = EVENTS_RELEASE, .i = key});
}

static void type(struct maker *maker)
{
    static const char letters[] = "0123456789.-+eE, ()nanif#\xe9\x01";
    for (int count = 1 + any(maker, 6); count > 0; count--)
        add(maker, (struct event){.kind = EVENTS_LETTER,
                                  .i = (unsigned char)letters[any(maker, sizeof letters - 1)]});
    turns(maker);
}

// Click, double click or drag, perhaps over the window's edge.
static void use_button(struct maker *maker)
{
    int button = any(maker, 5) == 0    ? GLFW_MOUSE_BUTTON_RIGHT
                 : any(maker, 12) == 0 ? GLFW_MOUSE_BUTTON_MIDDLE
                                       : GLFW_MOUSE_BUTTON_LEFT;
    point_anywhere(maker);
    turns(maker);
    for (int clicks = any(maker, 4) == 0 ? 2 : 1; clicks > 0; clicks--) {
        add(maker, (struct event){.kind = EVENTS_BUTTON, .i = button, .k = GLFW_PRESS});
        turns(maker);
        if (any(maker, 2) == 0) {
            int reach = any(maker, 3) == 0 ? 4000 : 120;
            for (int steps = 1 + any(maker, 6); steps > 0; steps--) {
                point(maker, maker->x + any(maker, reach) - reach / 2,
                      maker->y + any(maker, reach) - reach / 2);
                turns(maker);
            }
        }
        if (any(maker, 12) != 0)
            add(maker, (struct event){.kind = EVENTS_BUTTON, .i = button, .k = GLFW_RELEASE});
        turns(maker);
    }
}

static void change_window(struct maker *maker)
{
    static const int sizes[][2] = {{320, 200}, {320, 200}, {1, 1},   {1, 200},  {320, 1},
                                   {0, 0},     {2, 3},     {37, 53}, {500, 60}, {640, 400}};
    int size = any(maker, sizeof sizes / sizeof *sizes);
    switch (any(maker, 8)) {
    case 0:
    case 1:
        add(maker, (struct event){.kind = EVENTS_RESIZE, .i = sizes[size][0], .k = sizes[size][1]});
        break;
    case 2:
        add(maker, (struct event){.kind = EVENTS_FOCUS, .i = any(maker, 2)});
        break;
    case 3:
        add(maker, (struct event){.kind = EVENTS_HIDE, .i = any(maker, 3) == 0});
        break;
    case 4:
        add(maker, (struct event){.kind = EVENTS_ENTER, .i = any(maker, 2)});
        break;
    case 5:
        add(maker, (struct event){.kind = EVENTS_DAMAGE});
        break;
    case 6:
        add(maker, (struct event){.kind = EVENTS_DENSITY, .i = 1 + any(maker, 4) / 3});
        break;
    default:
        add(maker, (struct event){.kind = EVENTS_COPY, .i = any(maker, CLIPBOARDS)});
    }
    turns(maker);
}

static void save(struct maker *maker)
{
    int text = any(maker, 3) == 0 ? 0 : any(maker, TEXTS + 1);
    add(maker, (struct event){.kind = EVENTS_SAVE, .i = any(maker, EVENTS_FILES), .k = text});
    if (any(maker, 2) == 0) // usually the time in which the program sees that the file has changed
        add(maker, (struct event){.kind = EVENTS_TURNS, .i = 40});
}

void events_make(uint64_t *state, struct event *events, int count)
{
    static const double costs[] = {1e-7, 1e-6, 1e-5, 3e-5, 1e-4};
    struct maker maker = {.state = state, .events = events, .count = count};
    add(&maker, (struct event){.kind = EVENTS_COST, .x = costs[any(&maker, 5)]});
    while (maker.made < count) {
        int gesture = any(&maker, 100);
        if (gesture < 40)
            press_key(&maker);
        else if (gesture < 75)
            use_button(&maker);
        else if (gesture < 80)
            add(&maker, (struct event){.kind = EVENTS_WHEEL, .x = 0.25 * (any(&maker, 41) - 20)});
        else if (gesture < 85)
            type(&maker);
        else if (gesture < 93)
            change_window(&maker);
        else if (gesture < 94)
            add(&maker, (struct event){.kind = EVENTS_DROP, .i = any(&maker, DROPPED)});
        else if (gesture < 95)
            add(&maker,
                (struct event){.kind = EVENTS_CLOCK, .x = any(&maker, 2) == 0 ? 0.5 : 100.0});
        else
            save(&maker);
    }
}

// ---- One event ----

void events_do(const struct event *event, void (*turn)(void), const char *own)
{
    const int i = event->i, k = event->k;
    const double x = event->x, y = event->y;
    switch (event->kind) {
// NOLINTBEGIN(bugprone-macro-parentheses): the code is a statement
#define EVENTS_CASE(name, code)                                                                    \
    case EVENTS_##name:                                                                            \
        code;                                                                                      \
        break;
        EVENTS(EVENTS_CASE)
#undef EVENTS_CASE
        // NOLINTEND(bugprone-macro-parentheses)
    }
}

void events_print(const struct event *event, const char *own, FILE *to)
{
#define EVENTS_CODE(name, code) #code,
    static const char *const codes[] = {EVENTS(EVENTS_CODE)};
#undef EVENTS_CODE
    fputs("    ", to);
    for (const char *at = codes[event->kind]; *at != '\0';) {
        int length = (int)strspn(at, "abcdefghijklmnopqrstuvwxyz_");
        if (length == 1 && (*at == 'i' || *at == 'k'))
            fprintf(to, "%d", *at == 'i' ? event->i : event->k);
        else if (length == 1 && (*at == 'x' || *at == 'y'))
            fprintf(to, "%.9g", *at == 'x' ? event->x : event->y);
        else if (length == 3 && strncmp(at, "own", 3) == 0)
            fprintf(to, "\"%s\"", own);
        else
            fprintf(to, "%.*s", length > 0 ? length : 1, at);
        at += length > 0 ? length : 1;
    }
    fputs(";\n", to);
}
