// This file is linked only into the sanitizer build. Mesa unloads its drivers, and unloaded code
// has no names in a sanitizer's report. This function therefore keeps libraries loaded.
#include <dlfcn.h>

int dlclose(void *handle)
{
    (void)handle;
    return 0;
}
