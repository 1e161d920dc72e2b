#!/bin/bash
# test_teeth.sh [PICTURE...] - would the tests notice? Each mistake of tests/mistakes.txt is planted in
# a copy of the shaders, and must move its picture at least twice as far from the reference as the
# tolerance allows; or its test in C must fail. With arguments only the mistakes of those pictures. Among all suites
# it only looks, but for CI, whether each mistake finds its place.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/support.sh

# What the tolerance allows, as in tests/support_compare.h: F2 in per cent, B8.
f2_tolerance=0.05
b8_tolerance=0.15

# One process draws all that this one plants: ask NAME COPY sets answer to what build/tests/draw says of a picture.
pen=
ask() { # NAME COPY
    if [ -z "$pen" ]; then
        pen=$scratch/pen.$$
        mkfifo "$pen.ask" "$pen.answer"
        "$BUILD/tests/draw" <"$pen.ask" >"$pen.answer" 2>>"$pen.errors" &
        exec 3>"$pen.ask" 4<"$pen.answer"
    fi
    : >"$pen.errors"
    echo "$1 $2" >&3
    if ! read -r answer <&4; then # the driver crashed over it
        answer="none $1"
        rm "$pen.ask" "$pen.answer"
        pen=
    fi
}

# The picture with the mistake against its reference.
judge_picture() { # WHAT PICTURE COPY
    local answer
    ask "$2" "$3"
    if [ "${answer%% *}" = none ]; then
        echo "not ok $1: $answer: $(tr '\n' ' ' <"$scratch/pen.$$.errors")"
        return
    fi
    awk -v what="$1" -v picture="$2" -v numbers="${answer#* * }" \
        -v f2=$f2_tolerance -v b8=$b8_tolerance 'BEGIN {
            split(numbers, word, " ")
            margin = word[2] / f2 > word[5] / b8 ? word[2] / f2 : word[5] / b8
            if (word[1] != "F2" || word[4] != "B8") margin = 0
            verdict = margin < 2 ? "not ok" : "ok"
            printf "%s %s: margin %.1f in %s, %s\n", verdict, what, margin, picture, numbers
        }'
}

plant() { # LINE COPY: prints a result
    local line=$1 copy=$2 what catcher files why
    what=$(field "$line" 1)
    catcher=$(field "$line" 2)
    files=$(field "$line" 3)
    why=$(edit_copy "$copy" "$files" "${line#*"$files"*| }")
    if [ -n "$why" ]; then
        echo "not ok $what: $why"
    elif [ "${catcher#test_}" != "$catcher" ]; then
        judge_test "$what" "$catcher" "$copy" "$BUILD/tests"
    else
        judge_picture "$what" "$catcher" "$copy"
    fi
}

here=$PWD
. tests/support_teeth.sh

open_scratch
if left_to_ci; then
    places tests/mistakes.txt
    exit
fi
mkdir -p "$scratch/right/tests" && cp -R chapters shaders "$scratch/right" && cp -R tests/shaders "$scratch/right/tests"
awk '!/^ *#/ && NF > 1 { print ($2 == "-" ? $1 : $1 "-" $2) }' tests/images.txt >"$scratch/pictures"
mistakes_of tests/mistakes.txt >"$scratch/all"

# The line of '*' stands for each picture that has no mistake of its own, but for those of solutions: test_check.sh
# shows that the chapter's unsolved shader does not pass for them.
grep '| *[*] *|' "$scratch/all" | while read -r line; do
    while read -r name; do
        [[ $name == *-solution-* ]] || grep -q "| *$name *|" "$scratch/all" ||
            printf '%s | %s |%s\n' "$(field "$line" 1)" "$name" "${line#*| \* *|}"
    done <"$scratch/pictures"
done >"$scratch/each"
grep -v '| *[*] *|' "$scratch/all" | cat - "$scratch/each" | while read -r line; do
    name=$(field "$line" 2)
    for wanted in "${@:-$name}"; do
        [ "$wanted" = "$name" ] || [ "$wanted" = "${name%% *}" ] && printf '%s\n' "$line"
    done
done >"$scratch/mistakes"
# Alone, this suite also looks whether a test fails on the right shaders: then it cannot tell them from
# wrong ones. In a run of all suites that is seen anyway.
if [ -z "${ALL_SUITES-}" ]; then
    sed -n 's/.*| *\(test_[a-z_0-9]*\) [^|]*|.*/\1/p' "$scratch/mistakes" | sort -u >"$scratch/tests"
    while read -r program; do
        passes() { PROJECT_ROOT=$here "$BUILD/tests/$program" >/dev/null 2>&1 </dev/null; }
        check "$program passes without a mistake" passes
    done <"$scratch/tests"
fi

plant_all
plan
