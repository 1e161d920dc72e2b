#!/bin/bash
# test_check.sh - `make check`: it accepts a solution of an exercise, refuses the chapter's unsolved
# shader in its place, and says what is wrong in one line.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/support.sh

accepted() { EXERCISE=$1 FILE=$2 FILES='' .make/check.sh >"$scratch/answer.$1" 2>&1; }

# Refused, by a line that says where, or why it does not run.
refused() { # EXERCISE FILE
    ! accepted "$1" "$2" && [ "$(wc -l <"$scratch/answer.$1")" = 1 ] &&
        grep -q 'most around [0-9]*,[0-9]*\|does not run: ' "$scratch/answer.$1"
}

# One exercise, called by xargs below: the chapter's unsolved shader is no solution.
if [ "${1-}" = --unsolved ]; then
    scratch=$2
    if refused "$3" "$(echo chapters/"${3%%_*}"_*.frag)"; then
        echo "ok $3: the unsolved chapter is refused"
    else
        echo "not ok $3: the unsolved chapter is refused: $(cat "$scratch/answer.$3")"
    fi >"$scratch/$3.result"
    exit 0
fi

open_scratch
awk '$2 ~ /^solution-[0-9]+$/ { sub(/^solution-/, "", $2); print substr($1, 1, 2) "_" $2 }' \
    tests/images.txt >"$scratch/exercises"
check "there are exercises" [ -s "$scratch/exercises" ]
xargs -P 2 -n 1 "$0" --unsolved "$scratch" <"$scratch/exercises"
while read -r exercise; do
    read -r line <"$scratch/$exercise.result"
    case $line in
    ok*) ok "${line#ok }" ;;
    *) not_ok "${line#not ok }" ;;
    esac
done <"$scratch/exercises"
check "a solution is right: chapter 00" accepted 00_2 chapters/solutions/00_first_scene_2.frag
check "a solution is right: chapter 03" accepted 03_2 chapters/solutions/03_shadows_2.frag

# Same picture, other rays: the first march goes elsewhere.
mkdir "$scratch/in" && cp -R chapters "$scratch/in"
cat >"$scratch/in/rays.frag" <<'END'
#include "main.glsl"
#include "march.glsl"
#define rayColour painted
#include "chapters/solutions/03_shadows_2.frag"
#undef rayColour
vec3 rayColour(Ray ray)
{
    march(Ray(ray.origin, -ray.direction), 0.0, 1.0, 0.001, 64);
    return painted(ray);
}
END
echo '#include "chapters/solutions/03_shadows_2.frag"' >"$scratch/in/mine.frag"
echo 'float sceneDistance(vec3 p) { return 1 +; }' >"$scratch/in/broken.frag"

says() { # WORDS
    grep -q -e "$1" "$scratch/answer.03_2" || { sed 's/^/# /' "$scratch/answer.03_2"; return 1; }
}
wrong_rays() { ! accepted 03_2 "$scratch/in/rays.frag" && says 'picture is right, its rays are not: pixel '; }
check "a picture that is right with rays that are not is refused" wrong_rays
broken() { ! accepted 03_2 "$scratch/in/broken.frag" && says 'does not run: .*broken.frag:1'; }
check "a file that does not compile is refused with its line" broken
absent() { ! accepted 03_2 "$scratch/in/absent.frag" && says 'cannot be read'; }
check "a file that is not there is refused" absent
# The maximum draws the same lens as the exact distance; the steps tell them apart.
bound() {
    sed 's|exact; // true|exact; // false|; s|"../|"chapters/|' chapters/solutions/04_hue_colour_4.frag \
        >"$scratch/in/bound.frag"
    ! accepted 04_4 "$scratch/in/bound.frag" && grep -q 'most around ' "$scratch/answer.04_4"
}
check "a bound is refused where an exact distance is asked for" bound
rm -f "$scratch/in/bound.frag"

table() {
    EXERCISE=03_2 FILE='' FILES="$scratch/in/*.frag" \
        .make/check.sh >"$scratch/answer.03_2" 2>&1
    [ $? = 1 ] && says '^right  .*mine.frag ' && says '^wrong  .*rays.frag ' &&
        says '^wrong  .*broken.frag ' && says '^1 of 3 right$'
}
check "a folder gives a table" table
asks_wrong() { # EXERCISE WORDS
    EXERCISE=$1 FILE=x FILES='' .make/check.sh >"$scratch/answer.03_2" 2>&1
    [ $? = 2 ] && [ "$(wc -l <"$scratch/answer.03_2")" = 1 ] && says "$2"
}
check "no exercise" asks_wrong '' 'which exercise'
check "an exercise of no chapter" asks_wrong 99_1 'there are 00_1 '
check "an exercise without a solution" asks_wrong 03_99 'there are 00_1 '
check "what is no exercise" asks_wrong shadows 'such as 03_2'
plan
