#include "window/field.h"

#include <stdio.h>
#include <string.h>

#include "number.h"
#include "picture/comparison.h"
#include "report.h"
#include "window/colour_picker.h"
#include "window/selection.h"

void window_field_close(struct window *window)
{
    window->dirty |= window->input.typing;
    window->input.typing = window->input.armed = false;
    window->grab.refused[0] = '\0';
}

void window_field_open(struct window *window)
{
    int first, end;
    const struct parameter *parameter = window_grabbed(window, &first, &end);
    if (parameter == NULL || window->grab.what != GRAB_VALUE)
        return;
    if (window->grab.part < 0)
        parameter_value_text(parameter, window->grab.typed, sizeof window->grab.typed);
    else
        number_text(parameter->value[first], window->grab.typed, NUMBER_SIZE);
    window->grab.fresh = true;
    window->input.typing = true;
}

// Assign the typed value as --set does. If it is refused, the reason is shown beside the row.
static void assign(struct window *window)
{
    int first, end;
    const struct parameter *parameter = window_grabbed(window, &first, &end);
    char text[512] = "";
    if (parameter == NULL) {
        window_field_close(window);
        return;
    }
    double value;
    if (window->grab.part >= 0 && !number_read(window->grab.typed, &value)) {
        snprintf(window->grab.refused, sizeof window->grab.refused, "must be one number");
        return;
    }
    int used = snprintf(text, sizeof text, "%s=", parameter->name);
    for (int k = 0; window->grab.part >= 0 && k < parameter->components; k++) {
        char number[NUMBER_SIZE];
        number_text(parameter->value[k], number, sizeof number);
        used += snprintf(text + used, sizeof text - (size_t)used, "%s%s", k > 0 ? "," : "",
                         k == first ? window->grab.typed : number);
    }
    if (window->grab.part < 0)
        snprintf(text + used, sizeof text - (size_t)used, "%s", window->grab.typed);
    if (parameters_assign(comparison_parameters_of(window->renderer, parameter), text)) {
        window_field_close(window);
        window_parameter_changed(window);
        return;
    }
    // The report says "--set NAME=VALUE: why"; the panel already shows the name and the value.
    size_t known = strlen("--set : ") + strlen(text);
    const char *why = report_last();
    snprintf(window->grab.refused, sizeof window->grab.refused, "%s",
             strlen(why) > known ? why + known : why);
}

// A comma counts as a decimal point, as in French, unless it separates the numbers of a vector. On
// a French keyboard, digits need Shift, as a message explains.
static void type_character(struct window *window, int code)
{
    const struct parameter *parameter = window_selected(window);
    bool one = window->grab.part >= 0 || (parameter != NULL && parameter->components == 1);
    size_t length = window->grab.fresh ? 0 : strlen(window->grab.typed);
    if (code >= 127 || strchr("0123456789.,-+eE", code) == NULL) {
        snprintf(window->grab.refused, sizeof window->grab.refused,
                 "type digits, a point, a sign or an e; hold Shift for digits on a French "
                 "keyboard");
    } else if (length < 40) {
        window->grab.typed[length] = code == ',' && one ? '.' : (char)code;
        window->grab.typed[length + 1] = '\0';
    }
}

void window_field_type(struct window *window, int code)
{
    if (code == INPUT_BEGIN) {
        window_field_close(window);
        window_field_open(window);
    }
    char *typed = window->grab.typed;
    size_t length = strlen(typed);
    if (!window->input.typing && code == INPUT_ESCAPE)
        window_picker_close(window);
    if (!window->input.typing)
        return;
    window->dirty = true;
    if (code == INPUT_BEGIN)
        return;
    window->grab.refused[0] = '\0';
    if (code == INPUT_ENTER)
        assign(window);
    else if (code == INPUT_ESCAPE)
        window_field_close(window);
    else if (code == INPUT_BACKSPACE && length > 0)
        typed[length - 1] = '\0';
    else if (code > ' ')
        type_character(window, code);
    window->grab.fresh &= window->grab.refused[0] != '\0';
}

void window_field_fill(const struct window *window, struct panel *panel, char tip[512])
{
    const struct panel_rows *rows = &window->panel.rows;
    panel->typed = window->input.typing ? window->grab.typed : NULL;
    panel->typed_part = window->grab.part;
    panel->refused = window->input.typing && window->grab.refused[0] != '\0';
    if (!panel->refused)
        return;
    snprintf(tip, 512, "%s", window->grab.refused);
    for (int i = 0; i < rows->count; i++)
        if (rows->row[i].selected && rows->row[i].kind != PANEL_ROW_DETAIL &&
            rows->row[i].part == window->grab.part) {
            panel->tip_at[0] = rows->row[i].left;
            panel->tip_at[1] = rows->row[i].top;
        }
}
