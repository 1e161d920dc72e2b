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
check "there are figures" [ $count -ge 13 ]
alone() {
    local file
    for file in docs/figures/*.svg; do
        [ -e "${file%.svg}.c" ] || { echo "# $file has no program"; return 1; }
    done
}
check "every figure has its program" alone

# The table of errata.md that names a counterpart of each of the report's figures: its rows, FIGURE then
# the files that it links to.
counterparts() { # PAGE
    awk -F ' *[|] *' '/^## / { here = /report.s figures/ } here && $2 ~ /^[0-9]+$/ {
        row = $2
        while (match($4, /\]\([^)#]*/)) {
            row = row " " substr($4, RSTART + 2, RLENGTH - 2)
            $4 = substr($4, RSTART + RLENGTH)
        }
        print row
    }' "$1"
}

complete() { # PAGE
    local number files file row=0
    while read -r number files; do
        row=$((row + 1))
        if [ "$number" != "$row" ] || [ -z "$files" ]; then
            echo "# row $row: $number $files"
            return 1
        fi
        for file in $files; do
            [ -s "docs/$file" ] || { echo "# figure $number: no $file"; return 1; }
        done
    done < <(counterparts "$1")
    [ "$row" = 11 ] || { echo "# $row of 11 figures"; return 1; }
}
check "each of the report's figures, 1 to 11, has its counterpart" complete docs/errata.md
refused() { # SED
    sed "$1" docs/errata.md >"$scratch/errata.md"
    ! complete "$scratch/errata.md" >/dev/null
}
check "a table without figure 5 is refused" refused '/^| 5 |/d'
check "a table that ends at figure 10 is refused" refused '/^| 11 |/d'
check "a counterpart that is not there is refused" refused '/^| 4 |/s/shadow_rays/gone/'
check "a figure without a counterpart is refused" refused 's/^| 2 |.*/| 2 | the vectors | none |/'
plan
