#!/bin/bash
# textures.sh - `make textures`: draw each texture of shaders/textures/ with its program. A file whose pixels are the
# same is not replaced, because another version of zlib packs the same picture into different bytes.
set -u
. .make/write.sh

same_pixels() { # A.png B.png
    build/tests/compare "$1" "$2" 2>/dev/null | grep -q 'largest 0$'
}

begin shaders/textures || exit 1
for program in shaders/textures/*.c; do
    name=$(basename "$program" .c)
    [ -e "shaders/textures/$name.h" ] && continue # a source with a header contains functions for the other sources
    file=shaders/textures/$name.png drawn=$new/$name.png
    "build/shaders/textures/$name" >"$drawn" || exit 1
    # compare ignores the alpha channel, so a file with one is the same only if its bytes are.
    [ "$(od -An -tu1 -j25 -N1 "$drawn")" -eq 6 ] && same=(cmp -s) || same=(same_pixels)
    if [ -e "$file" ] && "${same[@]}" "$file" "$drawn"; then
        echo "same     $file"
    else
        keep "$name.png" || exit 1
        echo "written  $file"
    fi
done
