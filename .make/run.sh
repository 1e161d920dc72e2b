#!/bin/sh
# run.sh [OPTION...] - `make run`: show the course in a window, beginning with a chapter; if none can be opened, render
# pictures of all chapters, or of that one.
#
# With options, which are those of one chapter's program, the window shows this chapter alone.
#
# Environment: CHAPTER, "03" or a whole stem; by default the first chapter, or, without a window, all chapters.
# FIGURE, "01_march": an interactive figure of a page, chapters/figures/01_march.frag, instead of a chapter.
set -u
. .make/chapters.sh

if [ -n "${FIGURE-}" ]; then
    if [ ! -f "chapters/figures/$FIGURE.frag" ]; then
        report "FIGURE=$FIGURE: no such figure: the figures are"
        for file in chapters/figures/*.frag; do printf '%s ' "$(basename "$file" .frag)"; done | fold -s -w 100 >&2
        echo >&2
        exit 1
    fi
    CHAPTER=${FIGURE%%_*}
    set -- --shader "chapters/figures/$FIGURE.frag" "$@"
fi
stem=$(stem_of "${CHAPTER-}") || exit 1
if [ $# = 0 ]; then
    in_window build/lecture --course "$stem"
else
    in_window "build/$stem" "$@"
fi
[ -n "${CHAPTER-}" ] || stem=$(stems)
for each in $stem; do
    in_file "${FIGURE:-$each}" "build/$each" "$@"
done
