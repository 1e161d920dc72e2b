#!/bin/bash
# exercises.sh - which pictures and rays of an exercise are compared, for `make check` and for the pages. Sourced it
# has functions; run it prints a line for each picture: NN_K|STEM|OPTIONS|OPTIONS AS SHOWN|OPTIONS OF ITS RAYS|PLACES.
export LC_ALL=C

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

# What of the options a page would name.
shown_of() { # OPTIONS
    sed -E 's/^ *//; s/^--size 640x360 ?//' <<<"$1"
}

# Nine pixels of a picture: "X,Y X,Y ...".
places_of() { # OPTIONS
    local place places=() width height
    read -r width height <<<"$(sed -E 's/.*--size +([0-9]+)x([0-9]+).*/\1 \2/' <<<"$1")"
    for place in {3,5,7},{2,4,6}; do
        places+=("$((${place%,*} * width / 10)),$((${place#*,} * height / 10))")
    done
    echo "${places[*]}"
}

# The options of a picture that its rays have too.
options_of_rays() { # OPTIONS
    sed -E 's/(--view|--probe) +[^ ]+//g' <<<"$1"
}

[ "${BASH_SOURCE[0]}" = "$0" ] || return 0
cd "$(dirname "$0")/.." || exit 1
exercises | while read -r exercise; do
    stem=$(basename "$(echo chapters/"${exercise%%_*}"_*.c)" .c)
    pictures_of "$stem" "${exercise#*_}" | while read -r options; do
        echo "$exercise|$stem|$options|$(shown_of "$options")|$(options_of_rays "$options")|$(places_of "$options")"
    done
done
