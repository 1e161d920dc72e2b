#!/bin/bash
# test_figures.sh - each diagram of docs/figures/ is what its program draws, says in words what is seen,
# and stands in a page.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/support.sh

open_scratch

drawn() { # NAME
    "$BUILD/docs/figures/$1" >"$scratch/$1.svg" && cmp "$scratch/$1.svg" "docs/figures/$1.svg"
}

# A title, a description of a sentence at least, numbers that are numbers, and XML that can be read.
sound() { # NAME
    local file=docs/figures/$1.svg
    grep -q '<title id="title">[^<]\{12,\}</title>' "$file" &&
        grep -q '<desc id="description">[^<]\{80,\}</desc>' "$file" &&
        ! grep -q -i '"[^"]*\<\(nan\|-nan\|inf\)\>[^"]*"' "$file" &&
        [ "$(identify -format %k "$file")" -gt 8 ]
}

shown() { # NAME
    grep -q "](figures/$1\.svg)" docs/*.md
}

count=0
for source in docs/figures/*.c; do
    name=$(basename "$source" .c)
    [ "$name" = svg ] && continue
    count=$((count + 1))
    check "$name.svg is what its program draws: make figures" drawn "$name"
    check "$name.svg is sound, with its words" sound "$name"
    check "$name.svg stands in a page" shown "$name"
done
check "there are figures" [ $count -ge 9 ]
alone() {
    local file
    for file in docs/figures/*.svg; do
        [ -e "${file%.svg}.c" ] || { echo "# $file has no program"; return 1; }
    done
}
check "every figure has its program" alone
plan
