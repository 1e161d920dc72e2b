#!/bin/bash
# check.sh - `make check EXERCISE=03_2 FILE=my.frag`: is a reader's solution of an exercise right? It is
# rendered like the solution in chapters/solutions, with the options of the exercise's pictures in
# tests/images.txt and those of tests/checks.txt; the pictures and the marches of some rays are compared.
#
# Environment: EXERCISE; FILE, or FILES for a table, one line a file: a pattern, or several with spaces
# between them. What differs is left as a picture in build/check/EXERCISE/, under the file's own path.
# Exit status: 0 when every file is right, 1 when one is not, 2 when the question is wrong.
set -u
export LC_ALL=C

export LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe
limit=${CHECK_LIMIT:-30} # seconds for one picture

fail() {
    printf 'make: %s\n' "$*" >&2
    exit 2
}

# NN_K of every exercise that has a solution.
exercises() {
    awk '$2 ~ /^solution-[0-9]+$/ { sub(/^solution-/, "", $2); print substr($1, 1, 2) "_" $2 }' \
        tests/images.txt | sort -t _ -k 1,1 -k 2,2n
}

# The options of each picture of the exercise, a line each, as the pages spell them, without the solution's
# own file.
pictures_of() { # STEM NUMBER
    awk -v stem="$1" -v number="$2" '
        BEGIN {
            n = split("-s --size -t --time -p --set -c --camera -a --samples -v --view", word)
            for (i = 1; i < n; i += 2) long[word[i]] = word[i + 1]
        }
        { first = $1 == substr(stem, 1, 2) "_" number ? 2 : $1 == stem && $2 ~ "^solution-" number "(-|$)" ? 3 : 0 }
        first {
            options = / (-s|--size) / ? "" : "--size 640x360"
            for (i = first; i <= NF; i++)
                if ($i == "-f" || $i == "--shader") i++
                else options = options " " ($i in long ? long[$i] : $i)
            print options
        }' tests/images.txt tests/checks.txt
}

# The program with some options as one word; what is handed in for at most so long, for a loop of it may never end.
render() { # OPTIONS SHADER OPTION...
    local options=$1 shader=$2 guard=()
    shift 2
    [ "$shader" = "$solution" ] || ! command -v timeout >/dev/null || guard=(timeout --foreground -k 5 "$limit")
    # shellcheck disable=SC2086 # options are words
    ${guard[@]+"${guard[@]}"} "$program" $options -f "$shader" "$@"
}

# The marches of some pixels' rays, and their colours in the picture, a line each: the last t and the last line
# of --probe, or that line alone where a file with a main of its own records no march.
marches() { # SHADER OPTIONS X,Y...
    local options probes
    options=$(sed -E 's/(--view|--probe) +[^ ]+//g' <<<"$2")
    probes=("${@:3}")
    render "$options" "$1" "${probes[@]/#/--probe=}" 2>/dev/null | awk -F , '
        /^[0-9]/ { t = $2 }
        /^# / { print (t == "" && $0 ~ /no march is/ ? "" : t + 0 " ") substr($0, 3); t = "" }'
}

# Nine rays of a shader, a line each: X,Y and the march.
nine_rays() { # SHADER OPTIONS
    local place places=() width height
    read -r width height <<<"$(size_of "$2")"
    for place in {3,5,7},{2,4,6}; do
        places+=("$((${place%,*} * width / 10)),$((${place#*,} * height / 10))")
    done
    paste -d ' ' <(printf '%s\n' "${places[@]}") <(marches "$1" "$2" "${places[@]}")
}

size_of() { # OPTIONS: width and height
    sed -E 's/.*--size +([0-9]+)x([0-9]+).*/\1 \2/' <<<"$1"
}

# Do two marches end alike: both on the surface at one distance, or both not?
same_march() { # A B
    awk -v a="$1" -v b="$2" 'BEGIN {
        split(a, x, "[ ;:]"); split(b, y, "[ ;:]")
        far = x[1] - y[1] > 0 ? x[1] - y[1] : y[1] - x[1]
        exit !(x[2] == y[2] && (x[2] != "hit" || far < 0.02 * (1 + y[1])))
    }'
}

# Two rays or more of nine that end elsewhere: prints the first of them. One may lie on an edge. A file
# with a main of its own, such as Shadertoy's, records none; where the solution is one, none are compared.
different_rays() { # FILE OPTIONS RAYS
    local place mine right first='' count=0
    grep -q '^[0-9,]* [0-9]' "$3" || return 0
    while IFS='|' read -r right mine; do
        place=${right%% *} right=${right#* } mine=${mine#* }
        [[ $mine =~ ^[0-9] ]] || { echo 'none is recorded: include main.glsl, as the chapter does'; return; }
        if ! same_march "$mine" "$right"; then
            count=$((count + 1))
            first=${first:-"pixel $place: $(told "$mine"), the solution's $(told "$right")"}
        fi
    done < <(nine_rays "$1" "$2" | paste -d '|' "$3" -)
    [ "$count" -lt 2 ] || echo "$first, and $((count - 1)) more of nine"
}

# A march in words: 'hit at t 3.2'.
told() { # MARCH
    local end=${1#* }
    echo "'${end%%;*}' at t ${1%% *}"
}

# Where in the picture a pixel is.
part_of() { # X,Y OPTIONS
    local width height
    read -r width height <<<"$(size_of "$2")"
    awk -v x="${1%,*}" -v y="${1#*,}" -v w="$width" -v h="$height" 'BEGIN {
        row = 3 * y < h ? "lower" : 3 * y < 2 * h ? "middle" : "upper"
        column = 3 * x < w ? "left" : 3 * x < 2 * w ? "middle" : "right"
        print (row column == "middlemiddle" ? "in the middle" : "at the " row " " column)
    }'
}

# What is wrong in one picture, in lines.
differs() { # FILE OPTIONS WORDS DIFFERENCE
    local place=${3##* }
    echo "$3, $(part_of "$place" "$2"): see $4"
    echo "  look at yours: $program --shader $1${shown:+ $shown}"
    echo "  your pixel $place: $(marches "$1" "$2" "$place" | sed -E 's/^[0-9]/t &/; s/ (hit|miss)/, \1/')"
    echo "  the solution's: $(marches "$solution" "$2" "$place" | sed -E 's/^[0-9]/t &/; s/ (hit|miss)/, \1/')"
}

# The solution's picture for line N of the options, and its nine rays; made when first asked for.
right_picture() { # N OPTIONS
    [ -e "$scratch/$1.png" ] ||
        render "$2" "$solution" -o "$scratch/$1.png" >/dev/null 2>"$scratch/errors" ||
        fail "$solution: $(head -n 1 "$scratch/errors")"
}
right_rays() { # OPTIONS
    [ -e "$scratch/rays" ] || nine_rays "$solution" "$1" >"$scratch/rays"
}

# Why a file gave no picture, from the status and what was said.
why_not() { # STATUS
    case $1 in
    124 | 137) echo "does not end: no picture after $limit s" ;;
    *) echo "does not run: $(grep -m 1 ':[0-9][0-9]*: ' "$scratch/errors" || head -n 1 "$scratch/errors")" ;;
    esac
}

# One file: prints its verdict, in the first line what a table has room for.
judge() { # FILE
    local file=$1 options numbers status rays shown number=0 worst=0 mine=$scratch/mine.png
    local difference=${file%.frag}.difference.png
    difference=$folder/$(sed -E 's|^([.]{0,2}/)*||; s|/[.]{1,2}/|/|g' <<<"$difference")
    [ -f "$file" ] || { echo 'is no file'; return 1; }
    [ -r "$file" ] || { echo 'cannot be read'; return 1; }
    mkdir -p "$(dirname "$difference")" || return 1
    while read -r options; do
        number=$((number + 1))
        shown=$(sed -E 's/^--size 640x360 ?//' <<<"$options")
        right_picture "$number" "$options"
        render "$options" "$file" -o "$mine" >/dev/null 2>"$scratch/errors"
        status=$?
        [ "$status" = 0 ] || { why_not "$status"; return 1; }
        if ! numbers=$(build/tests/compare "$scratch/$number.png" "$mine" "$difference"); then
            echo "${shown:+with $shown, }$(differs "$file" "$options" \
                "$(build/tests/compare --words "$scratch/$number.png" "$mine")" "$difference")"
            return 1
        fi
        rm -f "$difference"
        worst=$(printf '%s\n' "$worst" "$(cut -d ' ' -f 2 <<<"$numbers")" | sort -g | tail -n 1)
        [ "$number" = 1 ] || continue
        right_rays "$options"
        rays=$(different_rays "$file" "$options" "$scratch/rays")
        [ -z "$rays" ] || { echo "the picture${shown:+ with $shown} is right, its rays are not: $rays"; return 1; }
    done <<<"$wanted"
    echo "as the solution in $number picture$([ "$number" = 1 ] || echo s):" \
        "$(sed 's/^0\(.0*\)*$/no pixel differs/; t; s/$/ % of the pixels differ at most/' <<<"$worst") by more than 2 of 255"
}

# Set files to those that FILE or FILES asks for. A pattern whose folder has spaces is tried whole first.
find_files() {
    local IFS='' file
    files=(${FILE:+"$FILE"})
    [ -n "${FILES-}" ] || return
    shopt -s nullglob
    for IFS in '' ' '; do
        # shellcheck disable=SC2206 # a pattern stands for files
        files=($FILES)
        for file in ${files[@]+"${files[@]}"}; do
            [ ! -e "$file" ] || return
        done
    done
    fail "FILES='$FILES': no file has such a name"
}

case ${EXERCISE-} in
[0-9][0-9]_[0-9]*) ;;
'') fail "which exercise? For example: make check EXERCISE=03_2 FILE=my.frag" ;;
*) fail "EXERCISE=$EXERCISE: a chapter and a number, such as 03_2" ;;
esac
stem=$(basename "$(echo chapters/"${EXERCISE%%_*}"_*.c)" .c)
wanted=$(pictures_of "$stem" "${EXERCISE#*_}")
[ -n "$wanted" ] || fail "EXERCISE=$EXERCISE: no solution to compare with; there are $(exercises | paste -s -d ' ' -)"
find_files
set -f
[ ${#files[@]} -gt 0 ] || fail "which file? For example: make check EXERCISE=$EXERCISE FILE=my.frag"

program=build/$stem
solution=chapters/solutions/${stem}_${EXERCISE#*_}.frag
folder=${CHECK_FOLDER:-build/check}/$EXERCISE # for the pictures that are left
rm -rf "$folder" && mkdir -p "$folder" && scratch=$(mktemp -d "${TMPDIR:-/tmp}/ray-check.XXXXXX") || exit 2
trap 'rm -rf "$scratch"' EXIT
trap 'exit 2' HUP INT TERM

wrong=0 width=0
for file in "${files[@]}"; do
    [ ${#file} -le "$width" ] || width=${#file}
done
for file in "${files[@]}"; do
    mark=right
    verdict=$(judge "$file") || { [ $? = 2 ] && exit 2; mark=wrong wrong=$((wrong + 1)); }
    if [ -n "${FILES-}" ]; then
        printf '%-5s  %-*s  %s\n' "$mark" "$width" "$file" "${verdict%%$'\n'*}"
    else
        printf '%s: %s: %s\n' "$file" "$mark" "$verdict"
    fi
done
find "$folder" -depth -type d -empty -delete
[ -z "${FILES-}" ] || echo "$((${#files[@]} - wrong)) of ${#files[@]} right"
[ "$wrong" = 0 ]
