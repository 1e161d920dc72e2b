#include "window/keys.h"

#include <ctype.h>
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

void window_list_keys(struct window *window)
{
    char show[16], hide[16], deselect[16], more[40] = "";
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
    fill_labels(window, "X", deselect, sizeof deselect);
    if (window_key_acts(window, KEY_WITH_RAY))
        snprintf(more, sizeof more, "    %s: deselect ray", deselect);
    snprintf(window->panel.hint, sizeof window->panel.hint, "%s: %s    %s: hide%s", show,
             window->panel.helps ? "fewer keys" : "keys, ranges", hide, more);
}
