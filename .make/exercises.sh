#!/bin/bash
# exercises.sh - the pictures and rays that are compared for an exercise, for `make check`, `make marks` and the pages.
# When sourced, it defines functions; when run, it prints a line for each picture:
# NN_K|STEM|OPTIONS|OPTIONS AS SHOWN|OPTIONS OF ITS RAYS|PIXELS OF ITS RAYS.
. .make/names.sh

# Print NN_K for every exercise that has a solution. In the course for students, only checks.txt lists exercises.
exercises() {
    awk '$2 ~ /^solution-[0-9]+$/ { sub(/^solution-/, "", $2); print substr($1, 1, 2) "_" $2 }
        $1 ~ /^[0-9][0-9]_[0-9]+$/ { print $1 }' \
        tests/pictures/images.txt tests/course/checks.txt | sort -u -t _ -k 1,1 -k 2,2n
}

# Those, and the exercises of docs/engine.md.
all_exercises() {
    exercises
    grep -o '^engine_[0-9]*' tests/course/checks.txt | uniq
}

# Print the options of each picture of an exercise, one line each, with long names and without the solution's file.
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
        }' tests/pictures/images.txt tests/course/checks.txt
}

# Print the part of the options that a page would show.
shown_of() { # OPTIONS
    sed -E 's/^ *//; s/^--size 640x360 ?//' <<<"$1"
}

# Print nine pixels of a picture as "X,Y X,Y ...".
places_of() { # OPTIONS
    local place places=() width height
    read -r width height <<<"$(sed -E 's/.*--size +([0-9]+)x([0-9]+).*/\1 \2/' <<<"$1")"
    for place in {3,5,7},{2,4,6}; do
        places+=("$((${place%,*} * width / 10)),$((${place#*,} * height / 10))")
    done
    echo "${places[*]}"
}

# Print those options of a picture that also apply to its rays.
options_of_rays() { # OPTIONS
    sed -E 's/(--view|--probe) +[^ ]+//g' <<<"$1"
}

# Quote a word for a command line or a lecture's list, if it contains a special character. A lecture's list cannot
# contain the last form.
quoted() { # WORD
    local end="'" quote="'\"'\"'" text
    text=${1//$end/$quote}
    if [[ "$1" =~ ^[A-Za-z0-9_./:,+@%=-]+$ ]]; then
        printf '%s\n' "$1"
    elif is_plain "$1"; then
        printf "'%s'\n" "$text"
    else
        printf '%q\n' "$1"
    fi
}

# Print the command that shows the wrong pictures of a list beside the right ones.
beside() { # LIST
    echo "To see each wrong picture beside the solution's, with L for one after the other and N for the next: make lecture LIST=$(quoted "$1")"
}

# Set files to those named by FILE or FILES. FILES is first tried as a single pattern, because names may contain spaces.
# A name that a tool would take for an option gets a folder.
find_files() {
    local IFS='' file i found=
    files=(${FILE:+"$FILE"})
    shopt -s nullglob
    for IFS in '' ' '; do
        if [ -z "${FILES-}" ] || [ -n "$found" ]; then break; fi
        # shellcheck disable=SC2206 # a pattern is expanded to files
        files=($FILES)
        for file in ${files[@]+"${files[@]}"}; do
            [ ! -e "$file" ] || found=1
        done
    done
    [ -z "${FILES-}" ] || [ -n "$found" ] || fail 2 "FILES='$FILES': no such file"
    for i in ${files[@]+"${!files[@]}"}; do
        [[ ${files[i]} != -* ]] || files[i]=./${files[i]}
    done
}

[ "${BASH_SOURCE[0]}" = "$0" ] || return 0
exercises | while read -r exercise; do
    stem=$(basename "$(echo chapters/"${exercise%%_*}"_*.c)" .c)
    pictures_of "$stem" "${exercise#*_}" | while read -r options; do
        echo "$exercise|$stem|$options|$(shown_of "$options")|$(options_of_rays "$options")|$(places_of "$options")"
    done
done
