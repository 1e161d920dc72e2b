#!/bin/bash
# check.sh - `make check EXERCISE=03_2 FILE=my.frag`: is a reader's solution of an exercise right? It is
# rendered like the solution in chapters/solutions, with the options of tests/images.txt; the pictures
# and the marches of some rays are compared.
#
# Environment: EXERCISE; FILE, or FILES for a table, one line a file. What differs is left as a
# picture in build/check/. Exit status: 0 when every file is right, 1 when one is not, 2 when the
# question is wrong.
set -uf

export LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe
folder=build/check # for the pictures that are left

fail() {
    printf 'make: %s\n' "$*" >&2
    exit 2
}

# NN_K of every exercise that has a solution.
exercises() {
    awk '$2 ~ /^solution-[0-9]+$/ { sub(/^solution-/, "", $2); print substr($1, 1, 2) "_" $2 }' \
        tests/images.txt
}

# The options of each picture of the exercise, a line each, without the solution's own file.
pictures_of() { # STEM NUMBER
    awk -v stem="$1" -v wanted="solution-$2" '
        $1 == stem && ($2 == wanted || index($2, wanted "-") == 1) {
            options = "-s 640x360"
            for (i = 3; i <= NF; i++)
                if ($i == "-f") i++
                else options = options " " $i
            print options
        }' tests/images.txt
}

# Where a march ended, 't end', from the table of --probe; the view's own options left out.
march() { # SHADER X,Y OPTIONS
    local options
    options=$(sed -E 's/(-v|--view|--probe) +[^ ]+//g' <<<"$3")
    # shellcheck disable=SC2086 # options are words
    "$program" $options -f "$1" --probe "$2" 2>/dev/null | awk -F '[,:;]' '
        /^[0-9]/ { t = $2 }
        /^# / { sub(/^# /, "", $1); print t + 0, $1; exit }'
}

# Do two marches end alike: both on the surface at one distance, or both not?
same_march() { # A B
    awk -v a="$1" -v b="$2" 'BEGIN {
        split(a, x, " "); split(b, y, " ")
        far = x[1] - y[1] > 0 ? x[1] - y[1] : y[1] - x[1]
        exit !(x[2] == y[2] && (x[2] != "hit" || far < 0.02 * (1 + y[1])))
    }'
}

# Two rays or more of nine that end elsewhere: prints the first of them. One may lie on an edge.
different_rays() { # FILE SOLUTION OPTIONS
    local place mine right first='' count=0
    for place in {192,320,448},{80,150,220}; do
        right=$(march "$2" "$place" "$3")
        [ -n "$right" ] || return # a whole file records nothing
        mine=$(march "$1" "$place" "$3")
        if ! same_march "$mine" "$right"; then
            count=$((count + 1))
            first=${first:-"pixel $place: '${mine#* }' at t ${mine% *}, the solution '${right#* }' at t ${right% *}"}
        fi
    done
    [ "$count" -lt 2 ] || echo "$first, and $((count - 1)) more of nine"
}

# Around which pixel, and what is known of the rays there.
there() { # FILE OPTIONS X,Y
    local mine right
    mine=$(march "$1" "$3" "$2")
    right=$(march "$solution" "$3" "$2")
    printf ', most around %s' "$3"
    if [ -n "$right" ] && ! same_march "$mine" "$right"; then
        printf " ('%s' at t %s, the solution '%s' at t %s)" "${mine#* }" "${mine% *}" "${right#* }" "${right% *}"
    fi
}

# One file: prints its verdict.
judge() { # FILE
    local file=$1 options numbers status rays difference
    local mine=$scratch/mine.png right=$scratch/right.png errors=$scratch/errors
    difference=$folder/$(basename "$file" .frag).difference.png
    [ -r "$file" ] || { echo 'cannot be read'; return 1; }
    while read -r options; do
        # shellcheck disable=SC2086 # options are words
        "$program" $options -f "$solution" -o "$right" >/dev/null 2>"$errors" ||
            fail "$solution: $(head -n 1 "$errors")"
        # shellcheck disable=SC2086
        if ! "$program" $options -f "$file" -o "$mine" >/dev/null 2>"$errors"; then
            echo "does not run: $(grep -m 1 ':[0-9][0-9]*: ' "$errors" || head -n 1 "$errors")"
            return 1
        fi
        numbers=$(build/tests/compare "$right" "$mine" "$difference")
        status=$?
        if [ "$status" != 0 ]; then
            echo "$(cut -d ' ' -f 2 <<<"$numbers") % of the pixels differ$(there "$file" "$options" \
                "${numbers##* }"): see $difference"
            return 1
        fi
        rm -f "$difference"
        rays=$(different_rays "$file" "$solution" "$options")
        [ -z "$rays" ] || { echo "the picture is right, its rays are not: $rays"; return 1; }
    done <<<"$wanted"
    echo "as the solution: $(cut -d ' ' -f 2 <<<"$numbers") % of the pixels differ"
}

case ${EXERCISE-} in
[0-9][0-9]_[0-9]*) ;;
'') fail "which exercise? For example: make check EXERCISE=03_2 FILE=my.frag" ;;
*) fail "EXERCISE=$EXERCISE: a chapter and a number, such as 03_2" ;;
esac
set +f
stem=$(basename "$(echo chapters/"${EXERCISE%%_*}"_*.c)" .c)
set -f
wanted=$(pictures_of "$stem" "${EXERCISE#*_}")
[ -n "$wanted" ] || fail "EXERCISE=$EXERCISE: no solution to compare with; there are $(exercises | tr '\n' ' ')"
program=build/$stem
solution=chapters/solutions/${stem}_${EXERCISE#*_}.frag
mkdir -p "$folder" && scratch=$(mktemp -d "${TMPDIR:-/tmp}/ray-check.XXXXXX") || exit 2
trap 'rm -rf "$scratch"' EXIT
trap 'exit 2' HUP INT TERM

read -r -a files <<<"${FILES:-${FILE-}}"
set +f
# shellcheck disable=SC2206 # a pattern in FILES stands for files
files=(${files[@]+${files[@]}})
set -f
[ ${#files[@]} -gt 0 ] || fail "which file? For example: make check EXERCISE=$EXERCISE FILE=my.frag"
wrong=0 width=0
for file in "${files[@]}"; do
    [ ${#file} -le "$width" ] || width=${#file}
done
for file in "${files[@]}"; do
    mark=right
    verdict=$(judge "$file") || { [ $? = 2 ] && exit 2; mark=wrong wrong=$((wrong + 1)); }
    if [ -n "${FILES-}" ]; then
        printf '%-5s  %-*s  %s\n' "$mark" "$width" "$file" "$verdict"
    else
        printf '%s: %s\n' "$file" "$verdict"
    fi
done
[ -z "${FILES-}" ] || echo "$((${#files[@]} - wrong)) of ${#files[@]} right"
[ "$wrong" = 0 ]
