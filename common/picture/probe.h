// probe.h - the march of one ray in words: for --probe, for the overlay and for a click.
#ifndef PROBE_H
#define PROBE_H

#include <stdio.h>

#include "picture/renderer.h"

// The rows of a probe's table: one for each step of the first march, as far as the probe holds
// them.
int probe_rows(const struct renderer_probe *probe);

// Why the first march stopped: "hit", ...
const char *probe_end(const struct renderer_probe *probe);

// The table: what the march of one ray knew at each step, then a line that says why it ended and
// what the pixel cost.
void probe_print(const struct renderer_probe *probe, FILE *file);

#endif
