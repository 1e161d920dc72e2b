// platform.h for Linux, macOS and similar systems: the errors of an X server.
#include "platform.h"

#include <dlfcn.h>
#include <string.h>

// Copied from X11/Xlib.h, because only GLFW needs that library.
struct x_display;
struct x_error {
    int type;
    struct x_display *display;
    unsigned long resource, serial;
    unsigned char code, request, minor;
};

static struct {
    void (*lost)(const char *what);
    int (*error_text)(struct x_display *display, int code, char *text, int size);
} state;

static int on_error(struct x_display *display, struct x_error *error)
{
    char reason[128] = "", what[192];
    if (state.error_text != NULL)
        state.error_text(display, error->code, reason, sizeof reason);
    snprintf(what, sizeof what, "refused request %d.%d: %s (error %d)", error->request,
             error->minor, reason, error->code);
    state.lost(what);
    return 0;
}

static int on_broken_connection(struct x_display *display)
{
    (void)display;
    state.lost("has gone away");
    return 0;
}

// Look up a function. ISO C has no conversion from void * to a function pointer, but POSIX
// guarantees that both have the same representation, so the bytes are copied.
static bool look_up(void *library, const char *name, void *function)
{
    void *symbol = dlsym(library, name);
    memcpy(function, &symbol, sizeof symbol);
    return symbol != NULL;
}

void platform_watch_display(void (*lost)(const char *what))
{
    int (*(*set_error)(int (*)(struct x_display *, struct x_error *)))(void);
    int (*(*set_broken)(int (*)(struct x_display *)))(void);
    void *library = dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
    if (library == NULL || !look_up(library, "XSetErrorHandler", &set_error) ||
        !look_up(library, "XSetIOErrorHandler", &set_broken))
        return;
    look_up(library, "XGetErrorText", &state.error_text);
    state.lost = lost;
    set_error(on_error);
    set_broken(on_broken_connection);
}
