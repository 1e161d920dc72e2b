#!/bin/bash
# figures.sh - tests that each diagram of docs/figures/ is the output of its program, has a description, and is on a
# page; and that each figure of the report has a counterpart.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh

open_scratch

# True if two figures agree. Another machine's cos, log and pow may differ in their last bit, which can change the
# second decimal place of a number, a hundredth of a pixel. No number may differ by more, and everything else must be
# the same.
alike() { # A B
    awk -v most=0.0101 '
    function numbers_of(text, number,    count) {
        count = 0
        while (match(text, /-?[0-9]+([.][0-9]+)?/)) {
            number[++count] = substr(text, RSTART, RLENGTH)
            text = substr(text, RSTART + RLENGTH)
        }
        return count
    }
    function words_of(text) { gsub(/-?[0-9]+([.][0-9]+)?/, "#", text); return text }
    NR == FNR { kept[FNR] = $0; lines = FNR; next }
    {
        count = numbers_of($0, here)
        apart = words_of($0) != words_of(kept[FNR])
        numbers_of(kept[FNR], there)
        for (i = 1; i <= count && !apart; i++)
            apart = here[i] - there[i] > most || there[i] - here[i] > most
        if (apart) { print "# line " FNR ": " kept[FNR] "\n# is now: " $0; bad = 1; exit }
    }
    END { exit bad || FNR != lines }' "$1" "$2"
}

drawn() { # NAME
    "$BUILD/docs/figures/$1" >"$scratch/$1.svg" && alike "docs/figures/$1.svg" "$scratch/$1.svg"
}

# True if every element is closed, every value is in quotes, and each '&' begins an entity.
well_formed() { # FILE
    awk '
    function wrong(why) { print "# line " FNR ": " why; bad = 1; exit }
    {
        rest = $0
        if (rest ~ /&/ && rest !~ /^([^&]|&(#[0-9]+|[a-z]+);)*$/) wrong("a bare &")
        while (match(rest, /<[^>]*>/)) {
            if (substr(rest, 1, RSTART - 1) ~ /[<>]/) wrong("a stray bracket")
            tag = substr(rest, RSTART + 1, RLENGTH - 2)
            rest = substr(rest, RSTART + RLENGTH)
            name = tag
            sub(/^\//, "", name)
            sub(/[ \/].*/, "", name)
            if (tag ~ /^\//) {
                if (depth == 0 || open[depth--] != name) wrong("</" name "> closes nothing")
                continue
            }
            if (tag !~ /^[a-z]+( [a-zA-Z][a-zA-Z0-9-]*=("[^"<]*"|\047[^\047<]*\047))* *\/?$/) wrong("not an element: <" tag ">")
            if (tag !~ /\/$/) open[++depth] = name
        }
        if (rest ~ /[<>]/) wrong("a stray bracket")
    }
    END { if (!bad && (FNR == 0 || depth != 0)) { print "# " open[depth] " is not closed"; bad = 1 }; exit bad }' "$1"
}

# True if a figure has a title, a description of at least 80 characters, valid numbers, well-formed XML, and more than 8
# shapes in at least 4 colours.
sound() { # FILE
    grep -q '<title id="title">[^<]\{12,\}</title>' "$1" &&
        grep -q '<desc id="description">[^<]\{80,\}</desc>' "$1" &&
        ! grep -q -i '"[^"]*\<\(nan\|-nan\|inf\)\>[^"]*"' "$1" && well_formed "$1" &&
        [ "$(grep -o '<\(line\|circle\|path\|polygon\|polyline\|rect\)' "$1" | wc -l)" -gt 8 ] &&
        [ "$(grep -o '\(stroke\|fill\)="#[0-9a-f]*"' "$1" | sort -u | wc -l)" -ge 4 ]
}

shown() { # NAME
    grep -q "](figures/$1\.svg)" docs/*.md
}

count=0
for source in docs/figures/*.c; do
    name=$(basename "$source" .c)
    [ "$name" = svg ] && continue
    count=$((count + 1))
    check "$name.svg is the output of its program (make figures renews it)" drawn "$name"
    check "$name.svg is well formed, with a title and a description" sound "docs/figures/$name.svg"
    check "$name.svg is on a page" shown "$name"
done
check "there are at least 13 figures" [ $count -ge 13 ]
check "normal_error.svg, which shows rounding errors, is identical in every byte" \
    cmp docs/figures/normal_error.svg "$scratch/normal_error.svg"
alone() {
    local file
    for file in docs/figures/*.svg; do
        [ -e "${file%.svg}.c" ] || { echo "# $file has no program"; return 1; }
    done
}
check "every figure has a program" alone

# Print the rows of the table in errata.md that names the counterparts of the report's figures. Each row is printed as
# the number of a figure and the files that the row links to.
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

complete() { # PAGE: true if the table has figures 1 to 11, and their counterparts exist
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
check "each of the report's figures, 1 to 11, has a counterpart" complete docs/errata.md
plan
