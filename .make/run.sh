#!/bin/sh
# run.sh [OPTION...] - `make run`: a chapter in a window; without a display, pictures of all chapters.
#
# Environment: CHAPTER, "03" or a whole stem; the first chapter, or without a display every one.
set -u
. .make/chapters.sh

stem=$(stem_of "${CHAPTER-}") || exit 1

# Options that ask for something else than a window need no display.
for option in "$@"; do
    case $option in
    -o* | --output* | --probe* | --list | --print-shader* | -h | --help | -V | --version)
        exec "build/$stem" "$@"
        ;;
    esac
done

if [ -n "${DISPLAY-}${WAYLAND_DISPLAY-}" ] || [ "$(uname)" = Darwin ]; then
    exec "build/$stem" "$@"
fi

[ -n "${CHAPTER-}" ] || stem=$(stems)
mkdir -p build/gallery || exit 1
echo 'No display (DISPLAY and WAYLAND_DISPLAY are not set): rendering into files instead of a window.'
for each in $stem; do
    "build/$each" -o "build/gallery/$each.png" "$@" || exit 1
    echo "  build/gallery/$each.png"
done
