// Linked into the sanitizer build alone. Mesa unloads its drivers, and code that is gone has no
// names in a report: here libraries stay.
#include <dlfcn.h>

int dlclose(void *handle)
{
    (void)handle;
    return 0;
}
