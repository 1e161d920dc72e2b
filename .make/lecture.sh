#!/bin/sh
# lecture.sh - `make lecture`: show the scenes of a list full screen; if no window can be opened, draw them into files.
#
# Environment: LIST, a list of scenes; the default is docs/lecture.txt.
set -u
. .make/chapters.sh
. .make/scenes.sh

in_window build/lecture "${LIST:-docs/lecture.txt}"
draw_scenes "${LIST:-docs/lecture.txt}" build/lecture-scenes
