#include "window/keys.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "picture/comparison.h"
#include "window/projection.h"

enum condition {
    ALWAYS,
    WITH_RAY,
    WITH_PARAMETERS,
    WITH_HANDLES,
    WITH_TOOL,
    WITH_PROJECTIONS,
    IN_LECTURE
};

// A single letter or digit in a label names a key of an American keyboard.
static const struct {
    const char *does, *label;
    enum condition condition;
} entries[] = {
    {"scene, step", "Page Up Page Down", IN_LECTURE},
    {"next scene", "N", IN_LECTURE},
    {"part", "Shift+1…9", IN_LECTURE},
    {"move", "W A S D", ALWAYS},
    {"up, down", "Space C", ALWAYS},
    {"faster", "Shift F", ALWAYS},
    {"look around", "drag", ALWAYS},
    {"capture mouse", "M", ALWAYS},
    {"select ray", "click", ALWAYS},
    {"step back, on", "Q E", ALWAYS},
    {"first, last step", "Home End", WITH_RAY},
    {"deselect ray", "X", WITH_RAY},
    {"zoom", "wheel", ALWAYS},
    {"view", "1 2 3 4 5 6", ALWAYS},
    {"select", "↑ ↓", WITH_PARAMETERS},
    {"change", "← →", WITH_PARAMETERS},
    {"reset", "Delete", WITH_PARAMETERS},
    {"next handle", "Enter", WITH_HANDLES},
    {"undo stroke, all", "U Shift+U", WITH_TOOL},
    {"orthographic", "Tab", WITH_PROJECTIONS},
    {"pause", "Esc", ALWAYS},
    {"restart", "R", ALWAYS},
    {"screenshot", "P", ALWAYS},
    {"hide overlay", "H", ALWAYS},
    {"fewer keys", "K", ALWAYS},
    {"other side", "O", ALWAYS},
    {"collapse panel", "T", ALWAYS},
    {"full screen", "F11", ALWAYS},
    {"quit", "Backspace", ALWAYS},
};
_Static_assert(sizeof entries / sizeof *entries <= WINDOW_KEYS, "no room for all keys");

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

void window_list_keys(struct window *window)
{
    const bool holds[] = {[ALWAYS] = true,
                          [WITH_RAY] = window->inputs.pixel[0] >= 0,
                          [WITH_PARAMETERS] = comparison_parameter_count(window->renderer) > 0,
                          [WITH_HANDLES] = window->handles.count > 0,
                          [WITH_TOOL] = window->renderer->sculpture.tool != NULL,
                          [WITH_PROJECTIONS] = window_has_orthographic(window),
                          [IN_LECTURE] = window->start->caption != NULL};
    char show[16], hide[16];
    int count = 0;
    for (size_t i = 0; i < sizeof entries / sizeof *entries; i++)
        if (holds[entries[i].condition]) {
            struct panel_key *key = &window->panel.keys[count++];
            fill_labels(window, entries[i].label, key->label, sizeof key->label);
            key->does = entries[i].does;
        }
    window->panel.key_count = count;
    fill_labels(window, "K", show, sizeof show);
    fill_labels(window, "H", hide, sizeof hide);
    snprintf(window->panel.hint, sizeof window->panel.hint, "%s: %s    %s: hide", show,
             window->panel.helps ? "fewer keys" : "keys, ranges", hide);
}
