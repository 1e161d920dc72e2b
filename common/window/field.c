// The field in which a value is typed.
#include "window/state.h"

#include <stdio.h>
#include <string.h>

#include "number.h"
#include "picture/pair.h"
#include "report.h"

void window_field_leave(struct window *window)
{
    window->dirty |= window->input.typing;
    window->input.typing = false;
    window->touch.refused[0] = '\0';
}

void window_field_open(struct window *window)
{
    int first, behind;
    const struct parameter *parameter = window_taken(window, &first, &behind);
    if (parameter == NULL || window->touch.what != TOUCH_VALUE)
        return;
    if (window->touch.part < 0)
        parameter_value_text(parameter, window->touch.typed, sizeof window->touch.typed);
    else
        number_text(parameter->value[first], window->touch.typed, NUMBER_SIZE);
    window->touch.fresh = true;
    window->input.typing = true;
}

// Take what was typed, as --set does; what is refused is said beside the row.
static void take_field(struct window *window)
{
    int first, behind;
    const struct parameter *parameter = window_taken(window, &first, &behind);
    char text[512] = "";
    if (parameter == NULL) {
        window_field_leave(window);
        return;
    }
    int used = snprintf(text, sizeof text, "%s=", parameter->name);
    for (int k = 0; window->touch.part >= 0 && k < parameter->components; k++) {
        char number[NUMBER_SIZE];
        number_text(parameter->value[k], number, sizeof number);
        used += snprintf(text + used, sizeof text - (size_t)used, "%s%s", k > 0 ? "," : "",
                         k == first ? window->touch.typed : number);
    }
    if (window->touch.part < 0)
        snprintf(text + used, sizeof text - (size_t)used, "%s", window->touch.typed);
    if (parameters_assign(pair_parameters_of(window->renderer, parameter), text)) {
        window_field_leave(window);
        window_changed(window);
        return;
    }
    // "--set NAME=VALUE: why": the reader sees name and value.
    size_t known = strlen("--set : ") + strlen(text);
    const char *why = report_last();
    snprintf(window->touch.refused, sizeof window->touch.refused, "%s",
             strlen(why) > known ? why + known : why);
}

// The comma of a French keyboard is the point, where it does not part the numbers of a vector. Its
// digits need Shift: whoever forgets that is told.
static void type_letter(struct window *window, int code)
{
    const struct parameter *parameter = window_chosen(window);
    bool one = window->touch.part >= 0 || (parameter != NULL && parameter->components == 1);
    // The first letter takes the place of the value that stands there.
    size_t length = window->touch.fresh ? 0 : strlen(window->touch.typed);
    char letter = code == ',' && one ? '.' : (char)code;
    if (code >= 127 || strchr("0123456789.,-+eE", code) == NULL) {
        snprintf(
            window->touch.refused, sizeof window->touch.refused,
            "a number has digits, a point and a minus; on a French keyboard digits need Shift");
    } else if (length < 40) {
        window->touch.typed[length] = letter;
        window->touch.typed[length + 1] = '\0';
    }
}

void window_field_type(struct window *window, int code)
{
    char *typed = window->touch.typed;
    size_t length = strlen(typed);
    if (!window->input.typing && code == WINDOW_TYPED_ESCAPE)
        window_pick_close(window);
    if (!window->input.typing)
        return;
    window->dirty = true;
    window->touch.refused[0] = '\0';
    if (code == WINDOW_TYPED_ENTER)
        take_field(window);
    else if (code == WINDOW_TYPED_ESCAPE)
        window_field_leave(window);
    else if (code == WINDOW_TYPED_BACK && length > 0)
        typed[length - 1] = '\0';
    else if (code > ' ')
        type_letter(window, code);
    window->touch.fresh &= window->touch.refused[0] != '\0';
}

void window_field_tell(const struct window *window, struct panel *panel, char tip[512])
{
    const struct panel_rows *rows = &window->panel.rows;
    panel->typed = window->input.typing ? window->touch.typed : NULL;
    panel->typed_part = window->touch.part;
    panel->refused = window->input.typing && window->touch.refused[0] != '\0';
    if (!panel->refused)
        return;
    snprintf(tip, 512, "%s", window->touch.refused);
    for (int i = 0; i < rows->count; i++)
        if (rows->row[i].chosen && rows->row[i].kind != PANEL_ROW_DETAIL &&
            rows->row[i].part == window->touch.part) {
            panel->tip_at[0] = rows->row[i].left;
            panel->tip_at[1] = rows->row[i].top;
        }
}
