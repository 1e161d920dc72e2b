#!/bin/bash
# compare.sh - tests `make compare`, which says in one line how much two pictures differ.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh

open_scratch
draw() { build/02_lighting -s 128x72 -o "$scratch/$1.png" "${@:2}" >/dev/null; }
draw one && draw same && draw hair -p ambient=0.012,0.02,0.0353 && draw other -p falloff=false
build/02_lighting -s 64x36 -o "$scratch/small.png"
draw shifted -p ambient=0.013,0.0215,0.037
echo 'this is not a picture' >"$scratch/text.png"

# says STATUS WORDS NAME...: comparing the pictures NAME.png must give this status and one line that matches WORDS.
says() {
    local status=$1 words=$2 pictures='' said file
    shift 2
    for file in "$@"; do pictures+=" $scratch/$file.png"; done
    said=$(PICTURES=$pictures .make/compare.sh 2>&1)
    if [ $? != "$status" ] || [ "$(wc -l <<<"$said")" != 1 ] || ! grep -qx -e "$words" <<<"$said"; then
        echo "# $said"
        return 1
    fi
}
shown() { [ -s build/compare.png ]; }
says 1 '[0-9.]* % of the pixels differ by more than 2 of 255, by at most [0-9]*, most around [0-9]*,[0-9]*: see build/compare.png' one other
check 'two different pictures are reported' [ $? = 0 ]
check 'the difference between two pictures is shown in a picture' shown
check 'two equal pictures are reported as the same' says 0 'the pictures are the same: no pixel differs' one same
check 'an earlier picture of a difference is removed' eval '! shown'
check 'a rounding error is not a difference' says 0 'the pictures are the same: no pixel differs by more than 2 of 255; the largest difference is 1' one hair
check 'a small difference over a whole region counts' says 1 'no pixel differs by more than [12] of 255, but a whole region differs a little, most around .*: see build/compare.png' one shifted
check 'two pictures of different sizes are refused' says 2 'make: pictures of different sizes cannot be compared: 128x72 and 64x36' one small
check 'a text file is refused' says 2 "make: .*text.png: cannot be read: Not a PNG file: save it again as a PNG" one text
check 'a missing file is refused' says 2 "make: .*absent.png: cannot be read: No such file or directory" one absent
check 'a single picture is refused' says 2 'make: which two pictures? .*' one
check 'three pictures are refused' says 2 'make: which two pictures? .*' one one one
asks() { make -s compare PICTURES="$scratch/$1.png $scratch/$2.png" >"$scratch/said" 2>&1; }
check 'make compare succeeds for pictures that differ' asks one other
check 'make compare fails for a text file' eval '! asks one text'

# make student stores what a solution adds to a picture.
tool() { build/tests/compare "$@" >"$scratch/said" 2>&1; }
added() {
    tool --subtract "$scratch"/{other,one,added}.png && tool --add "$scratch"/{one,added,sum}.png && tool "$scratch"/{other,sum}.png &&
        grep -q ' largest 0$' "$scratch/said" && [ "$(wc -c <"$scratch/added.png")" -lt "$(wc -c <"$scratch/other.png")" ]
}
check 'a picture is the sum of another and what it adds to it' added
# In a white picture, modulo 256 the sum of a brighter picture would be black.
draw white -p lampColour=4,4,4 -p ambient=1,1,1
near() {
    tool --subtract "$scratch"/{white,one,added}.png && tool --add "$scratch"/{shifted,added,sum}.png
    tool "$scratch"/{white,sum}.png
    [ "$(sed 's/.* largest \([0-9]*\).*/\1/' "$scratch/said")" -le 3 ] || { sed 's/^/# /' "$scratch/said" && return 1; }
}
check 'a picture that differs slightly has a sum that differs slightly' near
unfit() { tool --add "$scratch"/{one,small,sum}.png; [ $? = 2 ] && grep -q '128x72 and one of 64x36 cannot be added' "$scratch/said"; }
check 'pictures of different sizes are not added' unfit
plan
