#!/bin/bash
# textures.sh - each texture of shaders/textures/ is what its program draws, to the last bit of each pixel, and none is
# too large. tests/course/paint.c checks the pictures themselves.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh

open_scratch

# Bytes. The files are part of every copy of the project.
one_limit=$((512 * 1024))
all_limit=$((4 * 1024 * 1024))

names() {
    local source
    for source in shaders/textures/*.c; do
        [ -e "${source%.c}.h" ] || basename "$source" .c # one that has a header contains functions for the others
    done
}

# The bytes of the file depend on the machine's zlib; the pixels do not.
same() { # A.png B.png
    "$BUILD/tests/compare" "$1" "$2" | grep -q 'largest 0$' && [ "$(fourth "$1")" = "$(fourth "$2")" ]
}

# A checksum of the alpha channel, which compare ignores, if a file has one.
fourth() { # A.png
    [ "$(od -An -tu1 -j25 -N1 "$1")" -ne 6 ] || convert "$1" -alpha extract -depth 8 gray:- | cksum
}

draw() { # NAME
    "$BUILD/shaders/textures/$1" >"$scratch/$1.png"
}
export -f draw
export BUILD scratch

bytes_of() { cat "$@" | wc -c; }
at_most() { [ "$1" -gt 0 ] && [ "$1" -le "$2" ]; }

names | xargs -P 2 -I % bash -c 'draw %'
for name in $(names); do
    check "$name.png is what its program draws: make textures" same "shaders/textures/$name.png" "$scratch/$name.png"
    check "$name.png takes at most 512 KiB" at_most "$(bytes_of "shaders/textures/$name.png")" $one_limit
done
check "there are textures" [ "$(names | wc -l)" -ge 5 ]
check "all textures together take at most 4 MiB" at_most "$(bytes_of shaders/textures/*.png)" $all_limit

alone() { # FOLDER
    local file
    for file in "$1"/*.png; do
        if [ ! -e "${file%.png}.c" ] || [ -e "${file%.png}.h" ]; then
            echo "# $file has no program"
            return 1
        fi
    done
}
check "every texture has its program" alone shaders/textures
lonely() { ! alone "$scratch" >/dev/null; }
check "a texture without a program is detected" lonely

# A single bit of one pixel makes another picture.
other() {
    convert "shaders/textures/$1.png" -fill '#7f7f7f' -draw 'point 17,23' "$scratch/other.png" || return 0
    ! same "shaders/textures/$1.png" "$scratch/other.png"
}
check "a texture with one changed pixel is detected" other noise
plan
