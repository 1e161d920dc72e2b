// run.sh preloads this into Wine. A program that ends has one second to exit before Wine's server
// kills it and its status is lost. On a busy machine Mesa's threads, for which exit() waits, need
// more. By then the program's output has been written by Windows' C library.
#include <stdlib.h>
#include <unistd.h>

void exit(int status)
{
    _exit(status);
}
