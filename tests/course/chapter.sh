#!/bin/bash
# chapter.sh - tests `make chapter NAME=...` in a copy of the project: the new chapter builds, renders, is listed and
# has a page. Bad names are refused, and so is a name whose file already exists; nothing is overwritten.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh

open_scratch
copy=$scratch/copy
mkdir -p "$copy/tests/pictures" "$copy/build"
cp -a Makefile .make chapters common shaders docs "$copy"
cp tests/pictures/images.txt "$copy/tests/pictures"
cp -a build/common build/chapters build/flags "$copy/build"
unset MAKEFLAGS MFLAGS MAKELEVEL SANITIZE
cd "$copy" || exit 1

last=$(basename "$(printf '%s\n' chapters/[0-9][0-9]_*.c | tail -n 1)" .c)
number=$(printf '%02d' $((10#${last%%_*} + 1)))
stem=${number}_soft_shadows

refused() { # NAME WORDS
    cp tests/pictures/images.txt before.txt
    ! NAME=$1 .make/chapter.sh >said 2>&1 && grep -q -e "$2" said && cmp -s before.txt tests/pictures/images.txt &&
        [ -z "$(find chapters docs -newer before.txt -type f)" ]
}
check "a missing name is refused" refused '' 'NAME is missing'
check "a name with a capital letter is refused" refused 'Soft' 'lower-case letters'
check "a name with a slash is refused" refused '../x' 'lower-case letters'

writes() { NAME=soft_shadows .make/chapter.sh >said 2>&1 && grep -q "make run CHAPTER=$number" said; }
check "a chapter is written with the next number" writes
for file in chapters/$stem.c chapters/$stem.frag docs/$stem.md; do
    check "$file exists" [ -s "$file" ]
done
listed() { [ "$(tail -n 1 tests/pictures/images.txt)" = "$stem  -" ]; }
check "the chapter's picture is listed in tests/pictures/images.txt" listed

builds() { make -s "build/$stem" >said 2>&1 || { sed 's/^/# /' said; return 1; }; }
check "the chapter builds" builds
renders() {
    "build/$stem" -s 160x90 -o picture.png && [ "$(identify -format %k picture.png)" -gt 200 ]
}
check "the chapter renders a picture" renders
# shellcheck disable=SC2016 # the backticks are Markdown's
page() { .make/listings.sh "docs/$stem.md" >/dev/null && grep -q '`ballRadius` | 0.8 |' "docs/$stem.md"; }
check "the chapter's page has the listings and the table of parameters" page

not_overwritten() {
    printf '// mine\n' >"chapters/$(printf '%02d' $((10#$number + 1)))_mine.frag"
    ! NAME=mine .make/chapter.sh >said 2>&1
    grep -q 'already exists$' said && grep -q '^// mine$' chapters/*_mine.frag && [ -z "$(find chapters -name '*_mine.c')" ]
}
check "an existing file is not overwritten" not_overwritten
plan
