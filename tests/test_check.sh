#!/bin/bash
# test_check.sh - `make check`: it accepts a solution of an exercise, refuses the chapter's unsolved
# shader in its place, and says what is wrong in one line.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/support.sh

accepted() { EXERCISE=$1 FILE=$2 FILES='' .make/check.sh >"$scratch/answer.$1" 2>&1; }

# Refused, by a line that says why it does not run, or in four where it differs and what to look at.
refused() { # EXERCISE FILE
    ! accepted "$1" "$2" || return 1
    grep -q ': wrong: does not run: ' "$scratch/answer.$1" && return
    [ "$(wc -l <"$scratch/answer.$1")" = 4 ] &&
        grep -q ': wrong: .*most around [0-9]*,[0-9]*, \(in\|at\) the .*: see build/' "$scratch/answer.$1" &&
        grep -q "^  look at yours: build/.* --shader $2" "$scratch/answer.$1" &&
        [ "$(grep -c 'colour: [0-9]*, [0-9]*, [0-9]*$' "$scratch/answer.$1")" = 2 ]
}

# One exercise, called by xargs below: the chapter's unsolved shader is no solution.
if [ "${1-}" = --unsolved ]; then
    scratch=$2
    if refused "$3" "$(echo chapters/"${3%%_*}"_*.frag)"; then
        echo "ok $3: the unsolved chapter is refused"
    else
        echo "not ok $3: the unsolved chapter is refused: $(cat "$scratch/answer.$3")"
    fi >"$scratch/$3.result"
    echo "# drawn for $3"
    exit 0
fi

open_scratch
awk '$2 ~ /^solution-[0-9]+$/ { sub(/^solution-/, "", $2); print substr($1, 1, 2) "_" $2 }' \
    tests/images.txt | sort >"$scratch/exercises"
check "there are exercises" [ -s "$scratch/exercises" ]
# One exercise a chapter; test_answers.sh asks it of all.
sort -t _ -k 1,1 -u "$scratch/exercises" >"$scratch/unsolved"
xargs -P 2 -n 1 "$0" --unsolved "$scratch" <"$scratch/unsolved"
while read -r exercise; do
    read -r line <"$scratch/$exercise.result"
    case $line in
    ok*) ok "${line#ok }" ;;
    *) not_ok "${line#not ok }" ;;
    esac
done <"$scratch/unsolved"
sed -n 's/^\([0-9][0-9]_[0-9]*\) .*/\1/p' tests/checks.txt | sort -u | comm -13 "$scratch/exercises" - >"$scratch/unknown"
check "tests/checks.txt names exercises that there are" [ ! -s "$scratch/unknown" ]
check "a solution is right: chapter 00" accepted 00_2 chapters/solutions/00_first_scene_2.frag
check "a solution is right: chapter 03" accepted 03_2 chapters/solutions/03_shadows_2.frag
check "a solution is right: chapter 13" accepted 13_2 chapters/solutions/13_soft_shadows_2.frag
check "a solution is right: chapter 10" accepted 10_7 chapters/solutions/10_distance_in_the_plane_7.frag
check "a solution is right: chapter 11" accepted 11_2 chapters/solutions/11_materials_2.frag
check "a solution is right: chapter 12" accepted 12_2 chapters/solutions/12_textures_2.frag

# A folder outside the project, as a lecturer has it: files of several students, some of one name.
handed_in="$scratch/handed in"
mkdir -p "$handed_in/ada" "$handed_in/ben"
# Same picture, other rays: the first march goes elsewhere.
cat >"$handed_in/ben/rays.frag" <<'END'
#include "main.glsl"
#include "march.glsl"
#define rayColour painted
#include "solutions/03_shadows_2.frag"
#undef rayColour
vec3 rayColour(Ray ray)
{
    march(Ray(ray.origin, -ray.direction), 0.0, 1.0, 0.001, 64);
    return painted(ray);
}
END
cp chapters/solutions/03_shadows_2.frag "$handed_in/ada/my lamp.frag"
cp chapters/solutions/03_shadows_1.frag "$handed_in/ada/mine.frag"
echo '#include "03_shadows.frag"' >"$handed_in/ben/mine.frag"
echo 'float sceneDistance(vec3 p) { return 1 +; }' >"$handed_in/ben/broken.frag"
: >"$handed_in/ben/empty file.frag"
cat >"$handed_in/endless.frag" <<'END'
#version 330 core
in vec2 FragCoord;
out vec4 FragColor;
void main()
{
    float x = FragCoord.x;
    for (int i = 0; i >= 0; i = i > 9000 ? 0 : i + 1)
        for (int k = 0; k >= 0; k = k > 9000 ? 0 : k + 1)
            x += sin(x + FragCoord.y);
    FragColor = vec4(x);
}
END

says() { # WORDS
    grep -q -e "$1" "$scratch/answer.03_2" || { sed 's/^/# /' "$scratch/answer.03_2"; return 1; }
}
one_is() { # FILE WORDS
    ! accepted 03_2 "$handed_in/$1" && [ "$(wc -l <"$scratch/answer.03_2")" = 1 ] && says "$2"
}
check "a picture that is right with rays that are not is refused" \
    one_is ben/rays.frag 'picture is right, its rays are not: pixel '
build/03_shadows -f chapters/solutions/03_shadows_2.frag --print-shader=shadertoy >"$handed_in/toy.frag"
check "a right picture of a file that records no rays says so" one_is toy.frag 'rays are not: none is recorded'
check "a file that does not compile is refused with its line" \
    one_is ben/broken.frag 'does not run: .*broken.frag:1'
check "an empty file, with a space in its name, is refused" \
    one_is 'ben/empty file.frag' 'does not run: .*empty file.frag: empty'
check "a file that is not there is refused" one_is absent.frag 'is no file'

# The maximum draws the same lens as the exact distance; the steps tell them apart.
bound() {
    sed 's|exact; // true|exact; // false|' chapters/solutions/04_hue_colour_4.frag >"$scratch/bound.frag"
    ! accepted 04_4 "$scratch/bound.frag" && grep -q 'most around ' "$scratch/answer.04_4"
}
check "a bound is refused where an exact distance is asked for" bound

table() { # EXERCISE PATTERN
    EXERCISE=$1 FILE='' FILES=$2 .make/check.sh >"$scratch/answer.03_2" 2>&1
}
of_class() {
    table 03_2 "$handed_in/*/*.frag"
    [ $? = 1 ] && says '^right  .*ada/my lamp.frag ' && says '^wrong  .*rays.frag ' &&
        says '^wrong  .*broken.frag ' && says '^wrong  .*empty file.frag ' && says '^1 of 6 right$'
}
check "a folder outside the project gives a table" of_class
of_one_name() {
    local pictures
    pictures=$(grep -o 'build/check/.*difference.png' "$scratch/answer.03_2")
    [ "$(sort -u <<<"$pictures" | wc -l)" = 2 ] &&
        while IFS= read -r picture; do [ -s "$picture" ] || return 1; done <<<"$pictures"
}
check "files of one name leave pictures of their own" of_one_name
listed() {
    table 03_2 "chapters/solutions/03_shadows_1.frag chapters/solutions/03_shadows_3.f*"
    [ $? = 1 ] && says '^0 of 2 right$' && [ ! -e build/check/03_2"$handed_in" ]
}
check "several names with spaces between them; earlier pictures are gone" listed
nobody() { table 03_2 "$handed_in/eve/*.frag"; [ $? = 2 ] && says 'no file has such a name'; }
check "a pattern that fits no file is a wrong question" nobody
endless() {
    CHECK_LIMIT=1 table 00_1 "$handed_in/endless.frag"
    [ $? = 1 ] && says '^wrong .*does not end: no picture after 1 s'
}
check "a file that never ends is refused" endless
asks_wrong() { # EXERCISE WORDS
    EXERCISE=$1 FILE=x FILES='' .make/check.sh >"$scratch/answer.03_2" 2>&1
    [ $? = 2 ] && [ "$(wc -l <"$scratch/answer.03_2")" = 1 ] && says "$2"
}
check "no exercise" asks_wrong '' 'which exercise'
check "an exercise of no chapter" asks_wrong 99_1 'there are 00_1 '
check "an exercise without a solution" asks_wrong 03_99 "there are 00_1 .* 03_4 04_1 .* $(tail -n 1 "$scratch/exercises")$"
check "what is no exercise" asks_wrong shadows 'such as 03_2'
plan
