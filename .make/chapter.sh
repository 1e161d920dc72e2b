#!/bin/bash
# chapter.sh - `make chapter NAME=soft_shadows`: create a chapter with the next free number.
#
# Environment: NAME. The script writes chapters/NN_NAME.c, chapters/NN_NAME.frag and docs/NN_NAME.md, and adds a line to
# tests/pictures/images.txt. It never overwrites a file.
set -u
. .make/write.sh
. .make/chapters.sh

[ -n "${NAME-}" ] || fail 1 'NAME is missing; for example: make chapter NAME=soft_shadows'
[[ $NAME =~ ^[a-z][a-z0-9_]*$ && ${#NAME} -le 60 ]] || fail 1 "NAME=$NAME: must begin with a lower-case letter, followed only by up to 59 lower-case letters, digits and _, as in NAME=soft_shadows"
last=$(stems | tail -n 1)
number=$(printf '%02d' $((10#${last%%_*} + 1)))
[ "$number" -le 99 ] || fail 1 'there are already a hundred chapters'
stem=${number}_$NAME
small=${NAME//_/ }
title=$(printf '%s' "${small:0:1}" | tr '[:lower:]' '[:upper:]')${small:1} # macOS's bash cannot change the case itself
for file in "chapters/$stem.c" "chapters/$stem.frag" "docs/$stem.md"; do
    [ ! -e "$file" ] || fail 1 "$file already exists"
done

# fill TEMPLATE: print the template with the names of this chapter filled in.
fill() {
    sed "s/@number@/$number/g; s/@before@/${last%%_*}/g; s/@stem@/$stem/g; s/@title@/$title/g; s/@small@/$small/g" \
        ".make/chapter/$1"
}
# All files, or none.
listed() { cat tests/pictures/images.txt && printf '\n%s  -\n' "$stem"; }
if ! (
    trap '' HUP INT PIPE TERM
    write "docs/$stem.md" fill chapter.md && write "chapters/$stem.frag" fill chapter.frag &&
        write "chapters/$stem.c" fill chapter.c && write tests/pictures/images.txt listed
); then
    rm -f "docs/$stem.md" "chapters/$stem.frag" "chapters/$stem.c"
    exit 1
fi

printf '%s\n' "chapters/$stem.c, chapters/$stem.frag, docs/$stem.md: written; tests/pictures/images.txt lists the picture" \
    "next: make docs references CHAPTER=$number; make run CHAPTER=$number; docs/contributing.md describes the other steps"
