#!/bin/sh
# play.sh [OPTION...] - `make play`: show a reader's own shader in a window, reloaded on every save.
#
# Environment: FILE, a shader in the course's dialect, in Shadertoy's, or a complete one. By default it is
# chapters/play.frag, which is copied from chapters/first_steps/play.frag if it does not exist; an existing file is
# never changed. If no window can be opened, the picture is written to build/gallery/play.png.
set -u
. .make/write.sh
. .make/chapters.sh

file=${FILE-}
if [ -z "$file" ]; then
    file=chapters/play.frag
    if [ ! -e "$file" ] && [ ! -L "$file" ]; then
        write "$file" cat chapters/first_steps/play.frag || exit 1
        echo "$file: made from chapters/first_steps/play.frag; it is yours to change"
    fi
elif [ ! -e "$file" ]; then
    fail 1 "$file: no such file: \`make play\` without FILE creates one to start from"
fi

in_window build/01_normal_colouring -f "$file" "$@"
in_file play build/01_normal_colouring -f "$file" "$@"
