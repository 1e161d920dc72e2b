#!/bin/bash
# test_teeth.sh [PICTURE...] - would the image test notice? Each mistake of tests/mistakes.txt is
# planted in a copy of the shaders, and must move its picture at least twice as far from the
# reference as the tolerance allows. With arguments only the mistakes of those pictures.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/support.sh

# What the tolerance allows, as in common/image.h: F2 in per cent, B8.
f2_tolerance=0.05
b8_tolerance=0.15

# field LINE N: the Nth field, without the blanks around it.
field() {
    printf '%s\n' "$1" | awk -F ' +[|] +' -v n="$2" '{ print $n }'
}

# The options of a picture of tests/images.txt.
options_of() { # NAME
    awk -v name="$1" '!/^ *#/ && NF > 1 && ($2 == "-" ? $1 : $1 "-" $2) == name {
        $2 = ""; print; exit }' tests/images.txt
}

plant() { # LINE COPY: prints a result
    local line=$1 copy=$2 what picture file edit stem options numbers
    what=$(field "$line" 1)
    picture=$(field "$line" 2)
    file=$(field "$line" 3)
    edit=${line#*"$file"*| }
    read -r stem options <<<"$(options_of "$picture")"
    if [ -z "$stem" ]; then
        echo "not ok $what: tests/images.txt has no $picture"
        return
    fi
    mkdir "$copy" && cp -R chapters shaders "$copy"
    if ! sed "$edit" "$file" >"$copy/$file" || cmp -s "$file" "$copy/$file"; then
        echo "not ok $what: '$edit' changes nothing in $file"
        return
    fi
    # shellcheck disable=SC2086 # options are words
    if ! (cd "$copy" && "$here/$BUILD/$stem" --root . $options -o picture.png 2>errors); then
        echo "not ok $what: $(tr '\n' ' ' <"$copy/errors")"
        return
    fi
    numbers=$(build/tests/compare "tests/references/$picture.png" "$copy/picture.png" 2>&1)
    awk -v what="$what" -v picture="$picture" -v numbers="$numbers" \
        -v f2=$f2_tolerance -v b8=$b8_tolerance 'BEGIN {
            split(numbers, word, " ")
            margin = word[2] / f2 > word[5] / b8 ? word[2] / f2 : word[5] / b8
            if (word[1] != "F2" || word[4] != "B8") margin = 0
            verdict = margin < 2 ? "not ok" : "ok"
            printf "%s %s: margin %.1f in %s, %s\n", verdict, what, margin, picture, numbers
        }'
}

here=$PWD
if [ "${1-}" = --plant ]; then # called by xargs below
    set -f
    plant "$(sed -n "$3p" "$2/mistakes")" "$2/$3.copy" >"$2/$3.result"
    rm -rf "$2/$3.copy"
    exit 0
fi

open_scratch
sed 's/[[:space:]]*$//' tests/mistakes.txt | grep -v '^\(#\|$\)' | while read -r line; do
    name=$(field "$line" 2)
    for wanted in "${@:-$name}"; do
        [ "$wanted" = "$name" ] && printf '%s\n' "$line"
    done
done >"$scratch/mistakes"
count=$(grep -c . "$scratch/mistakes")

export LP_NUM_THREADS=1
seq "$count" | xargs -P 2 -n 1 "$0" --plant "$scratch"
for number in $(seq "$count"); do
    read -r line <"$scratch/$number.result" || line="not ok mistake $number: no result"
    case $line in
    ok*) ok "${line#ok }" ;;
    *) not_ok "${line#not ok }" ;;
    esac
done

# A picture that catches nothing proves nothing.
if [ $# = 0 ]; then
    blunt=$(awk '!/^ *#/ && NF > 1 { print ($2 == "-" ? $1 : $1 "-" $2) }' tests/images.txt |
        while read -r name; do
            grep -q "| *$name *|" "$scratch/mistakes" || printf ' %s' "$name"
        done)
    if [ -z "$blunt" ]; then
        ok "every picture of tests/images.txt catches a mistake"
    else
        not_ok "every picture of tests/images.txt catches a mistake" "these catch none:$blunt"
    fi
fi
plan
