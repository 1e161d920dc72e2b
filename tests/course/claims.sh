#!/bin/bash
# claims.sh [PAGE...] - tests that the pages agree with `make compare` about the pictures that they compare. If no pixel
# differs, the page must say so. Otherwise, if the page gives percentages, one of them must be the share of the pixels
# that differ, rounded to the last digit given. In the same way, the page must give the evaluations per pixel that its
# commands with --benchmark print, or the least ratio to the bound if a command prints only that, with `tail -n 1`. The
# numbers of a table in a section that names build/tests/measure must be among those that this command prints. With
# arguments, such as 03, only those pages are tested.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh

open_scratch

# Print the blocks of a page that compare pictures as lines 'draw COMMAND', 'compare A B', 'none' (the text says that no
# pixel differs) and 'claim NUMBERS'. The text of a block is the paragraph above it and at most 13 non-empty lines below
# it, up to the next heading, numbered experiment or block of commands. A block that writes a shader with sed or cp is
# left out.
blocks_of() { # PAGE
    awk '
        function end() {
            if (many > 0 && lines !~ /\n(sed|cp) /) {
                print lines
                if (tolower(region) ~ /no pixel differs|same picture/) print "none"
                print "claim" numbers(region)
            }
            many = 0; lines = ""; region = ""
        }
        function numbers(text, all, n, i, line, found) {
            n = split(text, all, "\n")
            for (i = 1; i <= n; i++) {
                line = all[i]
                gsub(/`[^`]*`|\$[^$]*\$|2 of 255/, "", line)
                if (line !~ / %/ && line !~ /^\|/) continue
                while (match(line, /[0-9]+(\.[0-9]+)?/)) {
                    found = found " " substr(line, RSTART, RLENGTH)
                    line = substr(line, RSTART + RLENGTH)
                }
            }
            return found
        }
        /^```sh/ { end(); block = 1; region = above; left = 13; next }
        block && /^```/ { block = 0; next }
        block && /^build\/.*--output/ { lines = lines "\ndraw " $0; next }
        block && /^make compare PICTURES=/ { gsub(/.*=.|.$/, ""); lines = lines "\ncompare " $0; many++; next }
        block { lines = lines "\n" $0; next }
        /^#|^\*\*[0-9]+\./ || left == 0 { end() }
        { region = region "\n" $0; left -= /./ }
        /^$/ { last = 1; next }
        { above = last ? $0 : above "\n" $0; last = 0 }
        END { end() }' "$1" | grep -E '^(draw|compare|none|claim)'
}

# agrees SHARE NUMBER...: true if one of the numbers is SHARE, a percentage, rounded to that number's last digit.
agrees() {
    awk 'BEGIN {
        for (i = 2; i < ARGC; i++) {
            half = (match(ARGV[i], /\./) ? 10 ^ -(length(ARGV[i]) - RSTART) : 1) / 2 + 1e-9
            if (ARGV[i] - ARGV[1] <= half && ARGV[1] - ARGV[i] <= half) exit 0
        }
        exit 1 }' "$@"
}

# judge PAGE NONE NUMBER...: tests each comparison of a block. NONE is yes if the text says that no pixel differs; the
# numbers are those in the text.
judge() {
    local page=$1 none=$2 a b said
    shift 2
    while read -r a b; do
        said=$(build/tests/compare --words "$scratch/${a//\//_}" "$scratch/${b//\//_}" 2>&1)
        case $said in
        'the pictures are the same'*) check "$page says that $a and $b are alike" [ "$none" = yes ] ;;
        *' % of the pixels differ'*)
            said=${said%% %*}
            [ $# = 0 ] || check "$page says that $a and $b differ in $said % of the pixels" agrees "${said#less than }" "$@"
            ;;
        *) not_ok "$page compares $a and $b" "$said" ;;
        esac
    done <"$scratch/compared"
}

# Print the commands of a page that count evaluations as lines 'count COMMAND', each with a line of the numbers in the
# text that belongs to them. For a block of commands, this is the paragraph above it and everything below it up to the
# next heading, numbered experiment or such block; for a command in a sentence, it is the paragraph. Such a command may be
# only the options of the chapter's program.
counts_of() { # PAGE PROGRAM
    awk -v program="$2" '
        function end() { if (commands != "") printf "%snumbers%s\n", commands, numbers(region); commands = "" }
        function numbers(line, found) {
            gsub(/`[^`]*`|\$[^$]*\$/, "", line)
            while (match(line, /[0-9]+\.[0-9]+|[0-9][0-9][0-9]/)) {
                found = found " " substr(line, RSTART, RLENGTH)
                line = substr(line, RSTART + RLENGTH)
            }
            return found
        }
        function sentences(paragraph, line, found, command) {
            line = paragraph
            while (match(line, /`[^`]*--benchmark [0-9][^`]*`/)) {
                command = substr(line, RSTART + 1, RLENGTH - 2)
                line = substr(line, RSTART + RLENGTH)
                if (command ~ /^--/) command = program " " command
                if (command !~ /=json/) found = found "count " command "\n"
            }
            if (found != "" && paragraph ~ /evaluations/) printf "%snumbers%s\n", found, numbers(paragraph)
        }
        /^```sh/ { block = 1; lines = ""; next }
        block && /^```/ {
            block = 0
            if (lines != "") { end(); commands = lines; region = above }
            next
        }
        block { if (/^build\/.*--benchmark/) lines = lines "count " $0 "\n"; next }
        /^#|^\*\*[0-9]+\./ { end() }
        { region = region "\n" $0 }
        /^$/ { sentences(paragraph); above = paragraph != "" ? paragraph : above; paragraph = ""; next }
        { paragraph = paragraph " " $0 }
        END { sentences(paragraph); end() }' "$1"
}

# Run a command of a page with --benchmark, and print the number that the page must give.
counted() { # COMMAND
    local words output
    read -r -a words <<<"${1%%|*}"
    output=$("${words[@]}" 2>&1)
    case $1 in
    *'tail -n 1') sed -n 's/.*for one ray at least \([0-9.]*\).*/\1/p' <<<"$output" ;;
    *) sed -n 's/^evaluations *mean \([0-9.]*\).*/\1/p' <<<"$output" ;;
    esac
}

# Print the rows of tables in the sections of a page that name build/tests/measure, as lines 'TABLE|WHAT...|NUMBER...', where
# WHAT are the arguments with which the section names it. A row's numbers are those with a decimal point or a per cent
# sign with which its cells begin; a row with fewer than two of them is left out.
rows_of() { # PAGE
    awk '
        function end(i) { for (i = 1; i <= n && what != ""; i++) print table[i] "|" what "|" row[i]; n = 0; what = "" }
        /^##/ { end() }
        {
            line = before " " $0 # a command may go on in the next line
            while (match(line, /build\/tests\/measure [a-z]+/)) {
                word = substr(line, RSTART + 20, RLENGTH - 20)
                if (word != "speed" && index(" " what " ", word " ") == 0) what = what word " "
                line = substr(line, RSTART + RLENGTH)
            }
            before = $0 ~ /measure$/ ? $0 : ""
        }
        /^\|/ {
            found = ""; many = 0
            count = split($0, cell, "|")
            for (i = 2; i < count; i++)
                if (match(cell[i], /^ *[-+]?[0-9]+(\.[0-9]+)?( %)?/) && cell[i] ~ /^ *[-+]?[0-9]+(\.[0-9]+|( %))/) {
                    found = found " " number_of(cell[i])
                    many++
                }
            if (many > 1) { row[++n] = found; table[n] = tables }
            next
        }
        { tables++ }
        function number_of(text) { match(text, /[0-9]+(\.[0-9]+)?/); return (text ~ /^ *-/ ? "-" : "") substr(text, RSTART, RLENGTH) }
        END { end() }' "$1"
}

# prints FILE NUMBER...: true if each of the numbers, rounded to its last digit, is in the file of lines of numbers, and
# all of them but at most one come one after the other in a line or in a column.
prints() {
    awk '
        function equal(printed, given, half) {
            half = (match(given, /\./) ? 10 ^ -(length(given) - RSTART) : 1) / 2 + 1e-9
            return printed - given <= half && given - printed <= half
        }
        # The most numbers, in order, among the values of one line or column.
        function longest(values, count, best, from, at, i) {
            best = 0
            for (from = 2; from <= 3 && from < ARGC; from++) {
                at = from
                for (i = 1; i <= count && at < ARGC; i++)
                    if (equal(values[i], number[at])) at++
                if (at - from > best) best = at - from
            }
            return best
        }
        BEGIN { for (i = 2; i < ARGC; i++) { number[i] = ARGV[i]; ARGV[i] = "" } }
        {
            gsub(/%/, ""); count = split($0, value, /[, ]+/)
            for (i = 1; i <= count; i++)
                if (value[i] ~ /^[-+]?[0-9.]+(e[-+][0-9]+)?$/) {
                    for (k in number) if (equal(value[i], number[k])) seen[k] = 1
                    column[i, ++rows[i]] = value[i]
                } else value[i] = "none"
            best = longest(value, count) > best ? longest(value, count) : best
        }
        END {
            for (i in rows) {
                split("", value)
                for (k = 1; k <= rows[i]; k++) value[k] = column[i, k]
                best = longest(value, rows[i]) > best ? longest(value, rows[i]) : best
            }
            for (k in number) if (!(k in seen)) exit 1
            exit !(best >= ARGC - 3)
        }' "$@"
}

for page in docs/[0-9][0-9]_*.md; do
    name=${page#docs/}
    [[ $# = 0 || " $* " == *" ${name%%_*} "* ]] || continue
    : >"$scratch/rows"
    while IFS='|' read -r table what numbers; do
        : >"$scratch/printed"
        for word in $what; do
            [ -e "$scratch/measure_$word" ] || build/tests/measure "$word" >"$scratch/measure_$word" 2>&1
            cat "$scratch/measure_$word" >>"$scratch/printed"
        done
        verdict=no
        # shellcheck disable=SC2086 # a list of numbers
        if prints "$scratch/printed" $numbers; then verdict=yes; fi
        echo "$table $verdict $what: $numbers" >>"$scratch/rows"
    done < <(rows_of "$page")
    # A table of which no row is printed comes from elsewhere.
    printed=$(sed -n 's/^\([0-9]*\) yes .*/ \1 /p' "$scratch/rows")
    while read -r table verdict row; do
        [[ $printed != *" $table "* ]] || check "${name%.md}: build/tests/measure prints the row $row" [ "$verdict" = yes ]
    done <"$scratch/rows"
done
for page in docs/[0-9][0-9]_*.md; do
    name=${page#docs/}
    [[ $# = 0 || " $* " == *" ${name%%_*} "* ]] || continue
    none=no
    : >"$scratch/compared"
    while read -r what line; do
        case $what in
        draw)
            read -r -a words <<<"$line"
            file=$scratch/${words[-1]//\//_}
            "${words[@]::${#words[@]}-1}" "$file" >/dev/null || not_ok "$name: $line"
            ;;
        compare) echo "$line" >>"$scratch/compared" ;;
        none) none=yes ;;
        claim)
            # shellcheck disable=SC2086 # a list of numbers
            judge "${name%.md}" $none $line
            none=no
            : >"$scratch/compared"
            ;;
        esac
    done < <(blocks_of "$page")
done
for page in docs/[0-9][0-9]_*.md; do
    name=${page#docs/}
    name=${name%.md}
    [[ $# = 0 || " $* " == *" ${name%%_*} "* ]] || continue
    : >"$scratch/counts"
    while read -r what line; do
        case $what in
        count) echo "$line" >>"$scratch/counts" ;;
        numbers)
            while read -r command; do
                number=$(counted "$command")
                # shellcheck disable=SC2086 # a list of numbers
                check "$name says what this command counts: $command: ${number:-nothing}" agrees "${number:-nothing}" $line
            done <"$scratch/counts"
            : >"$scratch/counts"
            ;;
        esac
    done < <(counts_of "$page" "build/$name")
done
check 'some pages compare pictures' [ "$tap_count" -gt 0 ]
plan
