#include "window/keys.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "window/state.h"

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

// True if Shift+R would change the camera or the zoom.
static bool has_moved(const struct window *window)
{
    const struct camera *now = &window->inputs.camera, *first = &window->start->camera;
    float apart = fabsf(now->pan - first->pan) + fabsf(now->tilt - first->tilt);
    for (int i = 0; i < 3; i++)
        apart += fabsf(now->position[i] - first->position[i]);
    return apart > 0.0f || window->unzoomed > 0.0;
}

void window_list_keys(struct window *window)
{
    char show[16], label[16];
    int count = 0;
    for (const struct key_row *row = window_keys; row->label != NULL && count < WINDOW_KEYS; row++)
        if (window_key_acts(window, row->condition)) {
            struct panel_key *key = &window->panel.keys[count++];
            fill_labels(window, row->label, key->label, sizeof key->label);
            key->does = row->does;
        }
    window->panel.key_count = count;
    // The second key is the one that brings back what was there before.
    bool ray = window_key_acts(window, KEY_WITH_RAY);
    bool moved = !ray && window_key_acts(window, KEY_WITH_CAMERA) && has_moved(window);
    fill_labels(window, "K", show, sizeof show);
    fill_labels(window, ray ? "X" : moved ? "R" : "H", label, sizeof label);
    snprintf(window->panel.hint, sizeof window->panel.hint, "%s: %s    %s%s: %s", show,
             window->panel.helps ? "fewer keys" : "keys, ranges", moved ? "Shift+" : "", label,
             ray     ? "deselect ray"
             : moved ? "camera back"
                     : "hide");
}
