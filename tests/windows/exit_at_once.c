// Loaded before Wine by windows.sh. A program that ends has a second to go away before Wine's
// server kills it, and its status is lost; on a busy machine Mesa's threads, which exit() waits
// for, want more. What the program wrote is written by then: Windows' C library has done so.
#include <stdlib.h>
#include <unistd.h>

void exit(int status)
{
    _exit(status);
}
