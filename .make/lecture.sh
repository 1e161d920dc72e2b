#!/bin/sh
# lecture.sh - `make lecture`: show the scenes of a list full screen; if no window can be opened, draw them into files.
#
# Environment: LIST, a list of scenes, by default docs/lecture.txt; NOTES=terminal, to print the sentences for the speaker,
# each with the next one, instead of showing them.
set -u
. .make/chapters.sh
. .make/scenes.sh

list=${LIST:-docs/lecture.txt}
case $list in -*) list=./$list ;; esac # a name, not an option
[ "${NOTES:-terminal}" = terminal ] || fail 2 "NOTES=$NOTES: must be terminal: the sentences for the speaker are then printed, and not shown"
in_window build/lecture ${NOTES:+--notes} "$list"
draw_scenes "$list" lecture-scenes
keep lecture-scenes || exit 1
