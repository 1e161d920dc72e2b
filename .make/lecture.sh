#!/bin/sh
# lecture.sh - `make lecture`: show the scenes of a list full screen; if no window can be opened, draw them into files.
#
# Environment: LIST, a list of scenes; the default is docs/lecture.txt.
set -u
. .make/chapters.sh
. .make/scenes.sh

list=${LIST:-docs/lecture.txt}
case $list in -*) list=./$list ;; esac # a name, not an option
in_window build/lecture "$list"
draw_scenes "$list" lecture-scenes
keep lecture-scenes || exit 1
