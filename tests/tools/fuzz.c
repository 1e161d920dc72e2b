// fuzz.c - the entry point of libFuzzer for the checks of fuzz.h. It is built only by `make fuzz`.
//
// Environment: FUZZ is the name of the target.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lib/fuzz.h"
#include "lib/scratch.h"

static const struct fuzz_target *target;

// libFuzzer requires these two names and types.
int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc, (void)argv;
    const char *name = getenv("FUZZ");
    for (int i = 0; i < FUZZ_TARGETS; i++)
        if (name != NULL && strcmp(name, fuzz_targets[i].name) == 0)
            target = &fuzz_targets[i];
    if (target == NULL) {
        fprintf(stderr, "FUZZ='%s': no such target\n", name != NULL ? name : "");
        exit(2);
    }
    scratch_make(); // fuzz.sh removes the folder, because libFuzzer calls no atexit handlers
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    target->run(bytes, size);
    return 0;
}
