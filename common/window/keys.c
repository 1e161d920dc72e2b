// The list of keys, as the overlay shows it.
#include "window/state.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "picture/pair.h"

// What stands on a key that GLFW names by the American keyboard: é on the 2 of a French one.
static void name_of(const struct window *window, int key, char name[8])
{
    const char american[] = {(char)key, '\0'};
    const char *text = window->has_keyboard ? glfwGetKeyName(key, 0) : NULL;
    if (text == NULL || text[0] == '\0' || strlen(text) > 4)
        text = american;
    snprintf(name, 8, "%c%s", toupper((unsigned char)text[0]), text + 1);
}

// The same where it stands alone: a comma is easily missed.
static void label_of(const struct window *window, int key, char label[8])
{
    char name[8];
    name_of(window, key, name);
    bool sign = name[1] == '\0' && !isalnum((unsigned char)name[0]);
    snprintf(label, 8, sign ? "\"%.4s\"" : "%.4s", name);
}

static void add_key(struct window *window, const char *does, const char *label)
{
    if (window->panel.key_count == WINDOW_KEYS)
        return;
    struct panel_key *key = &window->panel.keys[window->panel.key_count++];
    snprintf(key->label, sizeof key->label, "%s", label);
    key->does = does;
}

static void add_letter(struct window *window, const char *does, int key)
{
    char label[8];
    label_of(window, key, label);
    add_key(window, does, label);
}

void window_name_keys(struct window *window)
{
    static const int moves[] = {GLFW_KEY_W, GLFW_KEY_A, GLFW_KEY_S, GLFW_KEY_D, GLFW_KEY_C};
    static const int views[] = {GLFW_KEY_1, GLFW_KEY_2, GLFW_KEY_3,
                                GLFW_KEY_4, GLFW_KEY_5, GLFW_KEY_6};
    char l[6][8], text[64];
    for (int i = 0; i < 5; i++)
        label_of(window, moves[i], l[i]);
    window->panel.key_count = 0;
    snprintf(text, sizeof text, "%s %s %s %s", l[0], l[1], l[2], l[3]);
    add_key(window, "move", text);
    snprintf(text, sizeof text, "Space %s", l[4]);
    add_key(window, "up, down", text);
    label_of(window, GLFW_KEY_F, l[0]);
    snprintf(text, sizeof text, "Shift %s", l[0]);
    add_key(window, "faster", text);
    add_key(window, "look", "drag");
    add_letter(window, "mouse look", GLFW_KEY_M);
    add_key(window, "ray", "click");
    label_of(window, GLFW_KEY_Q, l[0]);
    label_of(window, GLFW_KEY_E, l[1]);
    snprintf(text, sizeof text, "%s %s", l[0], l[1]);
    add_key(window, "step back, on", text);
    if (window->inputs.pixel[0] >= 0) {
        add_key(window, "first, last step", "Home End");
        add_letter(window, "no ray", GLFW_KEY_X);
    }
    add_key(window, "zoom", "wheel");
    for (int i = 0; i < 6; i++)
        name_of(window, views[i], l[i]);
    snprintf(text, sizeof text, "%s %s %s %s %s %s", l[0], l[1], l[2], l[3], l[4], l[5]);
    add_key(window, "view", text);
    if (pair_parameter_count(window->renderer) > 0) {
        add_key(window, "choose", "↑ ↓");
        add_key(window, "change", "← →");
        add_key(window, "reset", "Delete");
    }
    if (window_has_orthographic(window))
        add_key(window, "orthographic", "Tab");
    add_key(window, "pause", "Esc");
    add_letter(window, "restart", GLFW_KEY_R);
    add_letter(window, "screenshot", GLFW_KEY_P);
    add_letter(window, "hide all", GLFW_KEY_H);
    add_letter(window, "fewer", GLFW_KEY_K);
    add_letter(window, "other side", GLFW_KEY_O);
    add_letter(window, window->panel.rolled ? "unfold panel" : "title alone", GLFW_KEY_T);
    add_key(window, "full screen", "F11");
    add_key(window, "end", "Backspace");
    label_of(window, GLFW_KEY_K, l[0]);
    label_of(window, GLFW_KEY_H, l[1]);
    snprintf(window->panel.hint, sizeof window->panel.hint, "%s: %s    %s: hide", l[0],
             window->panel.helps ? "fewer" : "keys, ranges", l[1]);
}
