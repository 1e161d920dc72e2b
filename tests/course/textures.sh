#!/bin/bash
# textures.sh - tests that the pixels of each texture in shaders/textures/ are exactly those that its program draws, and
# that no texture is too large. tests/course/paint.c checks that the pictures repeat.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh

open_scratch

# Limits in bytes, because the files are part of every copy of the project.
one_limit=$((512 * 1024))
all_limit=$((4 * 1024 * 1024))

names() {
    local source
    for source in shaders/textures/*.c; do
        [ -e "${source%.c}.h" ] || basename "$source" .c # a source with a header contains functions for the others
    done
}

# True if two pictures have the same pixels. The bytes of the files may differ, because they depend on the machine's
# zlib.
same() { # A.png B.png
    "$BUILD/tests/compare" "$1" "$2" | grep -q 'largest 0$' && [ "$(fourth "$1")" = "$(fourth "$2")" ]
}

# Print a checksum of the alpha channel of a file, if it has one; compare ignores this channel.
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
    check "$name.png is the output of its program (make textures renews it)" same "shaders/textures/$name.png" "$scratch/$name.png"
    check "$name.png takes at most 512 KiB" at_most "$(bytes_of "shaders/textures/$name.png")" $one_limit
done
check "there are at least five textures" [ "$(names | wc -l)" -ge 5 ]
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
check "every texture has a program" alone shaders/textures
lonely() { ! alone "$scratch" >/dev/null; }
check "a texture without a program is detected" lonely

# A picture with one changed pixel must be recognised as different.
other() {
    convert "shaders/textures/$1.png" -fill '#7f7f7f' -draw 'point 17,23' "$scratch/other.png" || return
    ! same "shaders/textures/$1.png" "$scratch/other.png"
}
check "a texture with one changed pixel is detected" other noise
plan
