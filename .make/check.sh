#!/bin/bash
# check.sh - `make check EXERCISE=03_2 FILE=my.frag`: check a reader's solution to an exercise. The file and the
# solution in chapters/solutions are rendered with the options that tests/pictures/images.txt and
# tests/course/checks.txt list for the exercise. The pictures of both and the marches of some rays are compared. For an
# exercise of docs/engine.md, such as EXERCISE=engine_1, FILE is a C program, which is built and run.
#
# The course for students has no solutions. For each exercise, `make student` has stored what a check needs of the
# solution in tests/course/stored/EXERCISE/: its pictures N.png, or N.added.png, which is added to the picture of the
# chapter as it was, tests/course/stored/NN_name.frag; its rays; and what its program does (N.outcome).
#
# Environment: EXERCISE; FILE, or FILES for a table with one line for each file. FILES is a pattern, or several patterns
# separated by spaces. Pictures of the differences are left in build/check/EXERCISE/, each under the path of its file;
# if the solution exists, wrong.txt in that folder lists the wrong pictures, as scenes for `make lecture`. For `make
# marks`, the files are arguments, CHECK_FOLDER replaces build/check/ in messages, CHECK_WORK is where it is made, and
# MARKS names a file that receives a line for each of them, with fields separated by tabs: exercise, file, mark, verdict,
# its picture, the right picture and that of the difference ('-' if there is none), a + or - for each comparison, and what
# a lecturer should look at. The first line is for the unsolved exercise; its verdict is the names of the comparisons,
# separated by |. Each file is then drawn as if it lay alone beside the course. FOLDERS names a file with the folders that
# belong to a single student; their answers may include files in them. For `make student`, STORE is a folder in which the
# solution's pictures and rays are stored; no file is checked. Exit status: 0 if every file is right, 1 if one is not, 2
# if the files cannot be checked.
set -u

. .make/write.sh
# shellcheck source=.make/exercises.sh
. .make/exercises.sh
export LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe
limit=${CHECK_LIMIT:-60} # seconds of processor time for one picture, so that a busy machine makes no difference

# A full disk must not look like a wrong answer.
need_room() {
    { head -c 4096 /dev/zero >"$scratch/room"; } 2>/dev/null || no_room
}
no_room() {
    fail 2 "$scratch: the disk has no room for the pictures: free some space, or set TMPDIR to a folder on another disk"
}

# Run the program; OPTIONS is one word. A file that was handed in has a time limit, because it may loop forever.
render() { # OPTIONS SHADER OPTION...
    local options=$1 shader=$2 root=()
    shift 2
    (
        if [ "$shader" != "$solution" ]; then
            ulimit -S -t "$limit"
            [ -z "${MARKS-}" ] || root=(--root "$scratch/course") shader=$scratch/alone/${shader##*/}
        fi
        # shellcheck disable=SC2086 # options are words
        "$program" $options -f "$shader" ${root[@]+"${root[@]}"} "$@"
        exit $? # keeps this shell alive, so that its message about a killed program goes where the program's messages go
    )
}

# Print the output of --probe for some pixels, with the options of the picture.
probes() { # SHADER OPTIONS X,Y...
    local probes=("${@:3}")
    render "$(options_of_rays "$2")" "$1" "${probes[@]/#/--probe=}" 2>/dev/null
}

# Describe one ray in words.
describe() { # SHADER OPTIONS X,Y
    probes "$@" >"$scratch/ray"
    build/tests/judge ray "$scratch/ray"
}

# Print where to look, below the message about a wrong picture.
look() { # FILE OPTIONS PLACE N
    printf '%s\n' "  look at yours: $program --shader $(quoted "$1")${shown:+ $shown}"
    echo "  your pixel $3 from the lower left: $(describe "$1" "$2" "$3")"
    if [ -e "$solution" ]; then
        echo "  the solution's: $(describe "$solution" "$2" "$3")"
    else
        echo "  the solution's: $(build/tests/judge pixel "$3" "$scratch/$4.png")"
    fi
}

# List a wrong picture as a scene for `make lecture`, with the file on the left and the solution on the right. Where they
# differ most is the line between them. The class sees no name. A list can contain only plain names.
list_wrong() { # FILE OPTIONS WORDS [X,Y]
    local width place=${4-} still=
    [ -e "$solution" ] && [ "$1" != "$unsolved" ] || return
    width=$(sed -E 's/.*--size +([0-9]+)x.*/\1/' <<<"$2")
    [ -n "$place" ] || place=$((width / 2)),
    [[ $2 == *--time* ]] || still=' --time 0'
    if is_plain "$1"; then
        printf "%s --shader %s --compare %s --labels 'an answer,the solution' --divider 0.%03d%s%s\n    %s\n" "${program#build/}" \
            "$(quoted "$1")" "$solution" $((1000 * ${place%,*} / width)) "$still" "${shown:+ $shown}" "$3" >>"$work/wrong.txt"
    else
        report "$1: a list of scenes cannot contain this name, so the picture is not in wrong.txt: rename the file"
    fi
}

# Make the solution's picture for line N of the options, and the solution's nine rays, when they are first needed. A
# stored picture may be what the solution adds to that of the unsolved exercise.
right_picture() { # N OPTIONS
    local shader=$solution picture=$scratch/$1.png
    [ ! -e "$picture" ] || return 0
    [ ! -e "$scratch/$1.added.png" ] || shader=$unsolved picture=$scratch/unsolved.png
    render "$2" "$shader" -o "$picture" >/dev/null 2>"$scratch/errors" || fail 2 "$shader: $(head -n 1 "$scratch/errors")"
    [ "$shader" = "$solution" ] || build/tests/compare --add "$picture" "$scratch/$1.added.png" "$scratch/$1.png" || exit 2
}
right_rays() { # OPTIONS PLACES
    # shellcheck disable=SC2086 # the pixels are separate words
    [ -e "$scratch/rays" ] || probes "$solution" "$1" $2 >"$scratch/rays"
}

# Print the reason why a file gave no picture, from the exit status and the messages.
why_not() { # STATUS
    local why
    why=$(grep -m 1 ':[0-9][0-9]*: ' "$scratch/errors" || head -n 1 "$scratch/errors")
    case $1 in
    152) echo "does not end: no picture after $limit s" ;; # SIGXCPU
    *) printf '%s\n' "does not run: ${why//"$scratch/alone/"/}" ;;
    esac
}

# ---- For `make marks`: what a file reads, and what it does when nobody looks ----

# Copy a file that was handed in to $scratch/alone, with what lies in the student's folder, so that the program finds
# nothing of others.
put_alone() { # FILE
    local folder other
    folder=$(dirname "$1")
    [ -e "$scratch/course" ] || { mkdir "$scratch/course" && cp -R chapters shaders "$scratch/course"; } || no_room
    rm -rf "$scratch/alone" && mkdir "$scratch/alone" || exit 2
    if grep -qxF -e "$folder" "$FOLDERS"; then
        (cd "$folder" && find . -type f -size -65536 -print0 | tar --null -T - -cf -) 2>/dev/null | tar -C "$scratch/alone" -xf - || no_room
        while IFS= read -r other; do
            [[ $other != "$folder"/* ]] || rm -rf "$scratch/alone/${other#"$folder"/}"
        done <"$FOLDERS"
    fi
    cp "$1" "$scratch/alone/${1##*/}" || no_room
}

# Add a sentence for the lecturer.
flag() { # WORDS
    printf '%s\n' "$(clean 400 "$1")" >>"$scratch/flags"
}

# If a file gave no picture because something was not found, say so if it exists where the file was handed in.
flag_outside() { # FILE
    local line from name folder
    line=$(grep -m 1 -E ':[0-9]+: (#include "|sampler )|: fatal error: ' "$scratch/errors") || return
    from=${line%%:*} name=$(sed -nE 's/^[^:]*:[0-9]+: (#include "([^"]*)"|sampler [A-Za-z0-9_]*: (.*)): (no such file beside|lies outside|an absolute path).*/\2\3/p
        s/.*: fatal error: (.*): No such file or directory$/\1/p' <<<"$line")
    [ -n "$name" ] || return
    from=${from#"$scratch/alone"} from=$(dirname "$1")/${from%"${from##*/}"}
    [[ $name != /* ]] || from=
    for folder in "$from" shaders/ shaders/textures/ chapters/; do
        [ ! -e "$folder$name" ] || { flag "asks for $name, which is not its own" && return; }
    done
}

# Name the pictures that a file reads and that do not belong to the course.
flag_pictures() { # FILE
    local name
    render '' "$1" --list 2>/dev/null | awk -v folder="$scratch/alone/" '
        found && (at = index($0, folder)) { name = substr($0, at + length(folder)); sub(/[.][Pp][Nn][Gg] .*/, ".png", name); print name }
        /^texture / { found = 1 }' >"$scratch/pictures"
    while IFS= read -r name; do flag "reads the picture $name, which was handed in with it"; done <"$scratch/pictures"
}

# Compare one more picture, of a size and at a time that are in no list. The time depends on all files that are
# compared, so nobody knows it, but it is the same in each run. A right answer in other words may differ in some pixels
# more than in the pictures that were chosen for the check; half a percent of them is ten times what the check allows.
flag_other_picture() { # FILE
    local said share
    [ -e "$solution" ] || return
    right_picture other "$other"
    if ! render "$other" "$1" -o "$scratch/mine.png" >/dev/null 2>"$scratch/errors"; then
        flag "draws what the check compares, but not $(shown_of "$other"): $(why_not $?)"
        return
    fi
    said=$(build/tests/judge picture "$(shown_of "$other")" "$scratch/other.png" "$scratch/mine.png" "$scratch/difference.png")
    { read -r _; read -r share; read -r said; } <<<"$said"
    ! awk -v share="${share:-0}" 'BEGIN { exit share < 0.005 }' || flag "draws what the check compares, but $said"
}
other_picture() { # FILE...
    local file sum width height
    sum=$(for file; do [ ! -f "$file" ] || head -c 65536 "$file"; done 2>/dev/null | cksum)
    sum=${sum%% *}
    read -r width height <<<"$(head -n 1 <<<"$wanted" | sed -E 's/.*--size +([0-9]+)x([0-9]+).*/\1 \2/')"
    head -n 1 <<<"$wanted" | sed -E "s/ --time +[^ ]+//; s/--size +[^ ]+/--size $((width + 16))x$((height + 9)) --time $((1 + sum % 20)).$((10 + sum / 20 % 90))/"
}

# Keep the two pictures that are compared, for the page of `make marks`.
keep_pictures() { # N
    local own=$work/$checked.png right=$work/$checked.right.png
    [ -n "${MARKS-}" ] || return 0
    { cp "$mine" "$own" && cp "$scratch/$1.png" "$right"; } 2>/dev/null || no_room
    printf '%s\t%s\t%s\n' "$own" "$right" "$(if [ -e "$difference" ]; then printf '%s\n' "$difference"; else echo -; fi)" >"$scratch/kept"
}

# Build a C program as docs/engine.md says, and print what it does with one command line: that it writes a picture, or
# its exit status and, if that is 1, the file and line that its message names. It can open no window. A program that only
# waits takes no processor time.
build_program() { # SOURCE PROGRAM
    # shellcheck disable=SC2046 # flags are words
    (ulimit -S -t "$limit" && "${CC:-cc}" -o "$2" "$1" $(pkg-config --cflags --libs glfw3 egl libpng) -lm) 2>"$scratch/errors"
}
outcome() { # PROGRAM OPTIONS
    rm -f "$scratch/$1.png"
    # shellcheck disable=SC2086 # options are words
    (
        unset DISPLAY WAYLAND_DISPLAY
        ulimit -S -t "$limit" && timeout -k 5 $((3 * limit)) "$scratch/$1" -o "$scratch/$1.png" $2
    ) </dev/null >/dev/null 2>"$scratch/errors"
    local status=$?
    case $status in
    0) echo 'writes a picture' ;;
    124 | 152) echo 'does not end' ;; # timeout's own, SIGXCPU
    1) echo "ends with status 1 and names '$(sed -nE '1s/^[^:]*: ([^:]*(:[0-9]+)?).*/\1/p' "$scratch/errors")'" ;;
    *) echo "ends with status $status" ;;
    esac
}

# Write what the solution's program does with line N of the options to N.outcome, and its picture to N.png.
right_outcome() { # N OPTIONS
    [ -e "$scratch/$1.outcome" ] || {
        outcome right "$2" >"$scratch/$1.outcome"
        grep -qv '^writes' "$scratch/$1.outcome" || mv "$scratch/right.png" "$scratch/$1.png"
    }
}

# Compare what a C program does with line N of the options: it must end as the solution does, and write the same picture.
# Sets `said` to what is wrong, or `share`.
compare_program() { # FILE N OPTIONS
    local right
    right_outcome "$2" "$3"
    right=$(cat "$scratch/$2.outcome")
    said=$(outcome mine "$3") share='' status=1
    [ "$said" != 'does not end' ] || status=152
    [ "$said" = "$right" ] || { said="with -o FILE.png $3 the program $said, but the solution $right" && return 1; }
    [[ $right == writes* ]] || return 0
    said=$(build/tests/judge picture "$3" "$scratch/$2.png" "$mine" "$difference" 2>/dev/null)
    status=$?
    [ "$status" -le 1 ] || { said="with -o FILE.png $3 the program writes no picture that can be read" && return 1; }
    { read -r _; read -r share; read -r said; } <<<"$said"
    [ -n "$verdict" ] || keep_pictures "$2"
    [ "$status" = 0 ] || { [ ! -e "$difference" ] || said+=$see; return 1; }
}

# Print where in the folder the picture of a file's differences is stored: under the path of the file. A long name is
# shortened.
difference_of() { # FILE
    local path=${1#/} name=${1##*/}
    path=/${path%"$name"}
    while [[ $path == */./* || $path == */../* ]]; do path=${path/\/.\///}; path=${path/\/..\///}; done
    [ ${#name} -le 200 ] || name=${name:0:150}-$(printf '%s' "$1" | cksum | tr ' ' -)
    printf '%s\n' "${path#/}$name.difference.png"
}

# Compare picture N. Sets `said` to what is wrong, perhaps in several lines, or `share`.
compare_picture() { # FILE N OPTIONS
    local place words
    shown=$(shown_of "$3")
    right_picture "$2" "$3"
    render "$3" "$1" -o "$mine" >/dev/null 2>"$scratch/errors" || {
        status=$?
        ! grep -qF "$mine: cannot be written: " "$scratch/errors" || no_room
        [ -z "${MARKS-}" ] || [ "$2" != 1 ] || flag_outside "$1"
        said=$(why_not "$status")
        return 1
    }
    words=$(build/tests/judge picture "$shown" "$scratch/$2.png" "$mine" "$difference")
    status=$?
    [ "$status" -le 1 ] || exit 2 # judge has reported the error
    { read -r place; read -r share; read -r words; } <<<"$words"
    if [ -z "$verdict" ]; then
        keep_pictures "$2"
        [ "$status" = 0 ] || list_wrong "$1" "$3" "$words" "$place"
    fi
    [ "$status" = 0 ] || {
        said=$words$see
        [ -n "${MARKS-}" ] || said+=$'\n'$(look "$1" "$3" "$place" "$2")
        return 1
    }
}

# Compare the rays of nine pixels of the first picture.
compare_rays() { # FILE OPTIONS
    local places
    places=$(places_of "$2")
    right_rays "$2" "$places"
    # shellcheck disable=SC2086 # the pixels are separate words
    probes "$1" "$2" $places >"$scratch/mine"
    said=$(build/tests/judge rays "$shown" "$places" "$scratch/rays" "$scratch/mine") || {
        [ $? = 1 ] || exit 2 # judge has reported the error
        list_wrong "$1" "$2" "$(head -n 1 <<<"$said")"
        return 1
    }
}

# Print the names of all comparisons.
comparisons() {
    if [[ $solution == *.diff ]]; then
        while read -r options; do echo "what the program does with -o FILE.png $options"; done <<<"$wanted"
        return
    fi
    while read -r options; do
        options=$(shown_of "$options")
        printf '%s\n' "the picture${options:+ with $options}"
    done <<<"$wanted"
    echo 'the rays of nine of its pixels'
}

# Judge one file and print the verdict; its first line also fits into a table. `make check` stops at the first difference.
# For `make marks`, all comparisons are made, and their results written to $scratch/results.
judge() { # FILE
    local file=$1 source=$1 compare=compare_picture mine=$scratch/mine.png difference see verdict='' options shown said share shares=() status number=0 results='' rays=- unmade
    unmade=$(comparisons | sed 's/.*/-/' | tr -d '\n')
    printf '%s\n' "$unmade" >"$scratch/results"
    difference=$(difference_of "$file")
    [ -e "$file" ] || { echo 'no such file'; return 1; }
    [ -f "$file" ] || { echo 'not a regular file'; return 1; }
    [ -r "$file" ] || { echo 'cannot be read'; return 1; }
    if [ -n "${MARKS-}" ]; then
        put_alone "$file"
        source=$scratch/alone/${file##*/} difference=$work/$checked.difference.png see=
    else
        see=": see $folder/$difference (lighter than grey where yours is brighter)" difference=$work/$difference
        mkdir -p "$(dirname "$difference")" 2>/dev/null || { echo 'its path is too long, or the disk is full'; return 1; }
    fi
    if [[ $solution == *.diff ]]; then
        build_program "$source" "$scratch/mine" || {
            [ -z "${MARKS-}" ] || flag_outside "$file"
            said=$(grep -m 1 error "$scratch/errors")
            echo "does not compile: ${said//"$scratch/alone/"/}"
            return 1
        }
        compare=compare_program rays=
    elif [ -n "${MARKS-}" ]; then
        flag_pictures "$file"
    fi
    while read -r options; do
        number=$((number + 1))
        if $compare "$file" "$number" "$options"; then
            results+=+
            [ -z "$share" ] || shares+=("$share")
            if [ "$number" = 1 ] && [ -n "$rays" ]; then
                if compare_rays "$file" "$options"; then rays=+; else verdict=$said; fi
            fi
        else
            results+=-
            [ -n "$verdict" ] || verdict=$said
            [ "$status" != 152 ] || break # SIGXCPU: it would take as long once more
        fi
        [ -z "$verdict" ] || difference=$scratch/difference.png
        [ -n "${MARKS-}" ] || [ -z "$verdict" ] || break
    done <<<"$wanted"
    [ -z "$rays" ] || unmade=${unmade%-}
    printf '%s\n' "$results${unmade:${#results}}$rays" >"$scratch/results"
    if [ -n "$verdict" ]; then
        printf '%s\n' "$verdict"
        return 1
    fi
    [ -z "${MARKS-}" ] || [ -z "$rays" ] || flag_other_picture "$file"
    build/tests/judge right "${shares[@]}"
}

# Store those parts of the solution that a check needs.
store() { # FOLDER
    local options picture number=0
    mkdir "$1" || exit 2
    while read -r options; do
        number=$((number + 1))
        if [[ $solution == *.diff ]]; then
            right_outcome "$number" "$options"
        else
            right_picture "$number" "$options"
            [ "$number" != 1 ] || right_rays "$options" "$(places_of "$options")"
        fi
        [ ! -e "$scratch/$number.png" ] || store_picture "$1" "$number" "$options"
    done <<<"$wanted"
    set +f
    set -- "$1" "$scratch"/*.outcome "$scratch"/rays
    for picture in "${@:2}"; do
        [ ! -e "$picture" ] || cp "$picture" "$1" || exit 2
    done
}

# Store the solution's picture for line N of the options: what it adds to the picture of the unsolved exercise, or all
# of it if the unsolved exercise has no such picture, or if that takes less space: --pack saves a quarter of it.
store_picture() { # FOLDER N OPTIONS
    local picture=$scratch/$2.png added=$1/$2.added.png
    if [[ $solution != *.diff ]] && render "$3" "$unsolved" -o "$scratch/unsolved.png" >/dev/null 2>&1; then
        build/tests/compare --subtract "$picture" "$scratch/unsolved.png" "$added" || exit 2
        [ $((4 * $(wc -c <"$added"))) -ge $((3 * $(wc -c <"$picture"))) ] || return 0
        rm "$added"
    fi
    build/tests/compare --pack "$picture" "$1/$2.png" || exit 2
}

[ -n "${EXERCISE-}" ] || fail 2 "which exercise? For example: make check EXERCISE=03_2 FILE=my.frag"
[[ $EXERCISE != [0-9]_* ]] || EXERCISE=0$EXERCISE # 3_2 is 03_2
[[ $EXERCISE =~ ^([0-9][0-9]|engine)_[0-9]+$ ]] || fail 2 "EXERCISE=$EXERCISE: must be a chapter, or engine, and a number, such as 03_2 or engine_1"
stem=$(basename "$(echo chapters/"${EXERCISE%%_*}"_*.c)" .c)
wanted=$(pictures_of "$stem" "${EXERCISE#*_}")
[[ $EXERCISE == [0-9]* ]] || wanted=$(sed -n "s/^$EXERCISE  *//p" tests/course/checks.txt)
[ -n "$wanted" ] || fail 2 "EXERCISE=$EXERCISE: no solution to compare with; these exercises have one: $(all_exercises | paste -s -d ' ' -)"
files=()
if [ $# -gt 0 ]; then files=("$@"); elif [ -z "${STORE-}" ]; then find_files; fi
set -f
[ -n "${STORE-}" ] || [ ${#files[@]} -gt 0 ] || fail 2 "which file? For example: make check EXERCISE=$EXERCISE FILE=my.frag"

program=build/$stem
solution=chapters/solutions/${stem}_${EXERCISE#*_}.frag
unsolved=chapters/$stem.frag
[[ $EXERCISE == [0-9]* ]] || unsolved=chapters/first_steps/engine_6.c
folder=${CHECK_FOLDER:-build/check}/$EXERCISE # for the pictures of the differences
for file in ${files[@]+"${files[@]}"}; do
    ! is_in "$folder" "$file" || fail 2 "$file: make check writes the folder $folder anew: copy the file to another place"
done
if [ -n "${STORE-}" ]; then begin "${STORE%/*}"; elif [ -z "${CHECK_WORK-}" ]; then begin "${folder%/*}"; fi || exit 2
work=${CHECK_WORK:-$new}/$EXERCISE
scratch=$(mktemp -d "${TMPDIR:-/tmp}/ray-check.XXXXXX") || exit 2
[[ $EXERCISE == [0-9]* ]] || solution=chapters/solutions/$EXERCISE.diff
stored=tests/course/stored/$EXERCISE
if [ ! -e "$solution" ]; then
    cp -R "$stored/." "$scratch" 2>/dev/null || fail 2 "EXERCISE=$EXERCISE: neither $solution nor $stored exists"
    # A student may have changed the chapter itself.
    [ ! -e "tests/course/stored/$stem.frag" ] || unsolved=tests/course/stored/$stem.frag
elif [[ $EXERCISE != [0-9]* ]]; then
    command -v patch >/dev/null || fail 2 "EXERCISE=$EXERCISE: needs patch: make setup installs it"
    if ! patch -s -o "$scratch/right.c" chapters/first_steps/engine_6.c "$solution" ||
        ! build_program "$scratch/right.c" "$scratch/right"; then
        fail 2 "$solution: cannot be built: $(head -n 1 "$scratch/errors")"
    fi
fi
if [ -n "${STORE-}" ]; then
    store "$work"
    keep "$EXERCISE" || exit 2
    exit
fi

if [ -n "${MARKS-}" ] && [[ $solution != *.diff ]]; then other=$(other_picture "${files[@]}"); fi
mkdir -p "$work" || exit 2
wrong=0 width=0 checked=0 names=()
for file in "${files[@]}"; do
    names+=("$(clean 240 "$file")")
    [ ${#names[checked]} -le "$width" ] || width=${#names[checked]}
    checked=$((checked + 1))
done
if [ -n "${MARKS-}" ]; then
    checked=unsolved
    judge "$unsolved" >/dev/null
    [ $? -le 1 ] || exit 2
    printf '%s\t-\tunsolved\t%s\t-\t-\t-\t%s\n' "$EXERCISE" "$(comparisons | paste -s -d '|' -)" "$(cat "$scratch/results")" >>"$MARKS" || exit 2
fi
checked=0
for file in "${files[@]}"; do
    mark=right
    need_room
    printf -- '-\t-\t-\n' >"$scratch/kept"
    : >"$scratch/flags"
    verdict=$(judge "$file") || { [ $? = 2 ] && exit 2; need_room; mark=wrong wrong=$((wrong + 1)); }
    first=$(clean 1600 "${verdict%%$'\n'*}")
    if [ -n "${MARKS-}" ]; then
        printf '%s\t%s\t%s\t%s\t%s\t%s\t%s\n' "$EXERCISE" "$file" "$mark" "$first" "$(cat "$scratch/kept")" "$(cat "$scratch/results")" "$(paste -s -d '|' "$scratch/flags" | sed 's/|/ | /g')" >>"$MARKS" || exit 2
    elif [ -n "${FILES-}" ]; then
        printf '%-5s  %-*s  %s\n' "$mark" "$width" "${names[checked]}" "$first"
    else
        printf '%s\n' "${names[checked]}: $mark: $first${verdict#"${verdict%%$'\n'*}"}"
    fi
    checked=$((checked + 1))
done
find "$work" -mindepth 1 -depth -type d -empty -delete
if [ -z "${MARKS-}" ]; then
    keep "$EXERCISE" || exit 2
    rmdir "$folder" 2>/dev/null # unless there are pictures
    [ -z "${FILES-}" ] || echo "$((${#files[@]} - wrong)) of ${#files[@]} right"
    [ -z "${FILES-}" ] || [ ! -e "$folder/wrong.txt" ] || beside "$folder/wrong.txt"
fi
[ "$wrong" = 0 ]
