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

# shellcheck source=.make/exercises.sh
. .make/exercises.sh
export LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe
limit=${CHECK_LIMIT:-60} # seconds of the processor for one picture, so that a busy machine refuses nobody

fail() {
    printf 'make: %s\n' "$*" >&2
    exit 2
}

# The program with some options as one word; what is handed in for at most so long, for a loop of it may never end.
render() { # OPTIONS SHADER OPTION...
    local options=$1 shader=$2
    shift 2
    (
        [ "$shader" = "$solution" ] || ulimit -S -t "$limit"
        # shellcheck disable=SC2086 # options are words
        "$program" $options -f "$shader" "$@"
        exit $? # not its last command: what this shell says of a program that was ended goes where the program's words go
    )
}

# What --probe prints of some pixels, in the picture's options.
probes() { # SHADER OPTIONS X,Y...
    local probes=("${@:3}")
    render "$(options_of_rays "$2")" "$1" "${probes[@]/#/--probe=}" 2>/dev/null
}

# One ray in words.
told() { # SHADER OPTIONS X,Y
    probes "$@" >"$scratch/ray"
    build/tests/judge ray "$scratch/ray"
}

# Where to look, below what is wrong in a picture.
look() { # FILE OPTIONS PLACE
    echo "  look at yours: $program --shader $1${shown:+ $shown}"
    echo "  your pixel $3: $(told "$1" "$2" "$3")"
    echo "  the solution's: $(told "$solution" "$2" "$3")"
}

# The solution's picture for line N of the options, and its nine rays; made when first asked for.
right_picture() { # N OPTIONS
    [ -e "$scratch/$1.png" ] ||
        render "$2" "$solution" -o "$scratch/$1.png" >/dev/null 2>"$scratch/errors" ||
        fail "$solution: $(head -n 1 "$scratch/errors")"
}
right_rays() { # OPTIONS PLACES
    # shellcheck disable=SC2086 # places are words
    [ -e "$scratch/rays" ] || probes "$solution" "$1" $2 >"$scratch/rays"
}

# Why a file gave no picture, from the status and what was said.
why_not() { # STATUS
    case $1 in
    152) echo "does not end: no picture after $limit s" ;; # SIGXCPU
    *) echo "does not run: $(grep -m 1 ':[0-9][0-9]*: ' "$scratch/errors" || head -n 1 "$scratch/errors")" ;;
    esac
}

# One file: prints its verdict, in the first line what a table has room for.
judge() { # FILE
    local file=$1 options status said place share shares=() shown places number=0 mine=$scratch/mine.png
    local difference=${file%.frag}.difference.png
    difference=$folder/$(sed -E 's|^([.]{0,2}/)*||; s|/[.]{1,2}/|/|g' <<<"$difference")
    [ -f "$file" ] || { echo 'is no file'; return 1; }
    [ -r "$file" ] || { echo 'cannot be read'; return 1; }
    mkdir -p "$(dirname "$difference")" || return 1
    while read -r options; do
        number=$((number + 1))
        shown=$(shown_of "$options")
        right_picture "$number" "$options"
        render "$options" "$file" -o "$mine" >/dev/null 2>"$scratch/errors"
        status=$?
        [ "$status" = 0 ] || { why_not "$status"; return 1; }
        said=$(build/tests/judge picture "$shown" "$scratch/$number.png" "$mine" "$difference")
        status=$?
        { read -r place; read -r share; read -r said; } <<<"$said"
        [ "$status" = 0 ] || { echo "$said: see $difference"; look "$file" "$options" "$place"; return 1; }
        shares+=("$share")
        [ "$number" = 1 ] || continue
        places=$(places_of "$options")
        right_rays "$options" "$places"
        # shellcheck disable=SC2086 # places are words
        probes "$file" "$options" $places >"$scratch/mine"
        build/tests/judge rays "$shown" "$places" "$scratch/rays" "$scratch/mine" || return 1
    done <<<"$wanted"
    build/tests/judge right "${shares[@]}"
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
