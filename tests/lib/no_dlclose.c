// Linked only into the sanitizer build. Mesa unloads its drivers, and unloaded code has no names in
// a report, so here libraries stay loaded.
#include <dlfcn.h>

int dlclose(void *handle)
{
    (void)handle;
    return 0;
}
