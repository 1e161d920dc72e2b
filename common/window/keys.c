#include "window/keys.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "picture/comparison.h"
#include "window/contents.h"
#include "window/draw.h"
#include "window/lens.h"
#include "window/state.h"

#define NOTE_SECONDS 4.0 // for which a note is shown

// Add the label, on the user's keyboard, of a key that is named as on an American keyboard: on a
// French keyboard, the label of key 2 is é. A punctuation mark on a letter key is quoted, because a
// comma is easily missed.
static void add_label(const struct window *window, char key, char *text, size_t size)
{
    const char american[] = {key, '\0'};
    const char *label = window->has_keyboard ? glfwGetKeyName(key, 0) : NULL;
    size_t used = strlen(text);
    if (label == NULL || label[0] == '\0' || strlen(label) > 4)
        label = american;
    bool sign = isalpha((unsigned char)key) && label[1] == '\0' && !isalnum((unsigned char)*label);
    snprintf(text + used, size - used, sign ? "\"%c%s\"" : "%c%s", toupper((unsigned char)*label),
             label + 1);
}

// Write the labels of several keys, separated by blanks.
static void fill_labels(const struct window *window, const char *keys, char *text, size_t size)
{
    text[0] = '\0';
    while (*keys != '\0') {
        size_t length = strcspn(keys, " "), used = strlen(text);
        if (length == 1)
            add_label(window, *keys, text, size);
        else
            snprintf(text + used, size - used, "%.*s", (int)length, keys);
        keys += length;
        used = strlen(text);
        if (*keys++ == '\0')
            return;
        snprintf(text + used, size - used, " ");
    }
}

bool window_has_scenes(const struct window *window)
{
    return window->start->caption != NULL || window_has_contents(window);
}

// True if a linked program of a picture reads the camera.
static bool reads_camera(const struct renderer *renderer)
{
    bool reads = renderer->comparison != NULL && reads_camera(renderer->comparison->other);
    for (int i = 0; i < SHADER_PROGRAM_COUNT && !reads; i++)
        reads =
            renderer->program[i] != 0 && inputs_reads(renderer->gl, renderer->program[i],
                                                      &renderer->fragment, INPUT_EYE, INPUT_FOCAL);
    return reads;
}

bool window_key_acts(struct window *window, enum key_condition condition)
{
    switch (condition) {
    case KEY_ALWAYS:
        return true;
    case KEY_WITH_CAMERA:
        return reads_camera(window->renderer);
    case KEY_WITH_MARCH:
        return window->renderer->fragment.dialect == DIALECT_COURSE;
    case KEY_WITH_TIME:
        return window_uses_time(window);
    case KEY_WITH_EDITOR:
        return !window->panel.in_page;
    case KEY_WITH_RAY:
        return window->inputs.pixel[0] >= 0;
    case KEY_WITH_PARAMETERS:
        return comparison_parameter_count(window->renderer) > 0;
    case KEY_WITH_HANDLES:
        return window->handles.count > 0;
    case KEY_WITH_TOOL:
        return window->renderer->sculpture.tool != NULL;
    case KEY_WITH_PROJECTIONS:
        return window_has_orthographic(window);
    case KEY_WITH_SCENES:
        return window_has_scenes(window);
    case KEY_IN_COURSE:
        return window_has_contents(window);
    case KEY_IN_LECTURE:
        return window->start->caption != NULL;
    }
    return false;
}

void window_explain_key(struct window *window, enum key_condition condition)
{
    static const char *const why[] = {[KEY_WITH_CAMERA] = "this shader does not read the camera",
                                      [KEY_WITH_MARCH] = "this shader does not record its march",
                                      [KEY_WITH_TIME] = "this picture does not change with time",
                                      [KEY_WITH_PARAMETERS] = "this shader has no parameters",
                                      [KEY_WITH_HANDLES] = "this shader has no points to drag",
                                      [KEY_WITH_TOOL] = "only chapter 23 has clay",
                                      [KEY_WITH_PROJECTIONS] = "this shader has one projection",
                                      [KEY_IN_LECTURE] = NULL};
    if (why[condition] == NULL || (window->panel.told & 1U << condition) != 0 ||
        window_key_acts(window, condition))
        return;
    window->panel.told |= 1U << condition;
    window->panel.note = why[condition];
    window->panel.note_ends = glfwGetTime() + NOTE_SECONDS;
    window->dirty = true;
}

void window_list_keys(struct window *window)
{
    char show[16], hide[16];
    int count = 0;
    for (const struct key_row *row = window_keys; row->label != NULL && count < WINDOW_KEYS; row++)
        if (window_key_acts(window, row->condition)) {
            struct panel_key *key = &window->panel.keys[count++];
            fill_labels(window, row->label, key->label, sizeof key->label);
            key->does = row->does;
        }
    window->panel.key_count = count;
    fill_labels(window, "K", show, sizeof show);
    fill_labels(window, "H", hide, sizeof hide);
    snprintf(window->panel.hint, sizeof window->panel.hint, "%s: %s    %s: hide", show,
             window->panel.helps ? "fewer keys" : "keys, ranges", hide);
}
