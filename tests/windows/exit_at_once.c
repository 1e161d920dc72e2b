// run.sh preloads this function into Wine. A program that ends has one second to exit before Wine's
// server kills it and its status is lost. On a busy machine, Mesa's threads, for which exit()
// waits, need more time. When exit() is called, Windows' C library has already written the
// program's output, so nothing is lost.
#include <stdlib.h>
#include <unistd.h>

void exit(int status)
{
    _exit(status);
}
