#!/bin/sh
# play.sh [OPTION...] - `make play`: a reader's own shader in a window, loaded again at each save.
#
# Environment: FILE, a shader in the course's form, in Shadertoy's, or a whole one. Without it
# chapters/play.frag, made from chapters/first_steps/play.frag when it is not there; one that is
# there is never touched. Without a display the picture goes to build/gallery/play.png.
set -u
export LC_ALL=C

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

# Options that ask for something else than a window need no display.
for option in "$@"; do
    case $option in
    -o* | --output* | --probe* | --list | --print-shader* | --benchmark* | -h | --help | -V | --version)
        exec build/01_normal_colouring -f "$file" "$@"
        ;;
    esac
done

if [ -n "${DISPLAY-}${WAYLAND_DISPLAY-}" ] || [ "$(uname)" = Darwin ]; then
    echo "$file: every save is shown at once"
    exec build/01_normal_colouring -f "$file" "$@"
fi
echo 'No display (DISPLAY and WAYLAND_DISPLAY are not set): rendering into a file instead of a window.'
mkdir -p build/gallery && build/01_normal_colouring -f "$file" -o build/gallery/play.png "$@" &&
    echo "  build/gallery/play.png"
