// support_overlay.h - what the overlay of a window adds to a frame.
#ifndef SUPPORT_OVERLAY_H
#define SUPPORT_OVERLAY_H

// Print the processor time of panels over the annex scene, as shares of its frame, for
// build/tests/measure. Returns an exit status.
int overlay_print(void);

#endif
