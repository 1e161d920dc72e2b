#!/bin/sh
# play.sh [OPTION...] - `make play`: a reader's own shader in a window, loaded again at each save.
#
# Environment: FILE, a shader in the course's form, in Shadertoy's, or a whole one. Without it
# chapters/play.frag, made from chapters/first_steps/play.frag when it is not there; one that is
# there is never touched. Where no window can be opened the picture goes to build/gallery/play.png.
set -u
. .make/chapters.sh

file=${FILE-}
if [ -z "$file" ]; then
    file=chapters/play.frag
    if [ ! -e "$file" ] && [ ! -L "$file" ]; then
        cp chapters/first_steps/play.frag "$file" || exit 1
        echo "$file: made from chapters/first_steps/play.frag; it is yours to change"
    fi
elif [ ! -e "$file" ]; then
    echo "make play: $file: no such file: \`make play\` alone makes one to start from" >&2
    exit 1
fi

in_window build/01_normal_colouring -f "$file" "$@"
in_file play build/01_normal_colouring -f "$file" "$@"
