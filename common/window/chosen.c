// The parameter that arrows and title bar are about.
#include "window/state.h"

struct parameter *window_chosen(const struct window *window)
{
    const struct parameters *all = &window->renderer->parameters;
    struct parameter *parameter = parameters_find(all, window->parameter);
    return parameter != NULL || all->count == 0 ? parameter : &all->item[0];
}
