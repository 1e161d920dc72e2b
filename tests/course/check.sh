#!/bin/bash
# check.sh - tests `make check`: it accepts the solution to an exercise, refuses the chapter's unsolved shader, and says
# what is wrong, on one line for a file that does not run, or on four lines for pictures that differ.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh

accepted() { EXERCISE=$1 FILE=$2 FILES='' .make/check.sh >"$scratch/answer.$1" 2>&1; }

# True if the answer is refused: a line says why the shader does not run, or four lines say where its picture differs
# and what to look at.
refused() { # EXERCISE FILE
    ! accepted "$1" "$2" || return 1
    grep -q ': wrong: does not run: ' "$scratch/answer.$1" && return
    [ "$(wc -l <"$scratch/answer.$1")" = 4 ] &&
        grep -q ': wrong: .*most around [0-9]*,[0-9]*, \(in\|at\|on\) the .*: see build/' "$scratch/answer.$1" &&
        grep -q "^  look at yours: build/.* --shader $2" "$scratch/answer.$1" &&
        [ "$(grep -c 'colour: [0-9]*, [0-9]*, [0-9]*$' "$scratch/answer.$1")" = 2 ] &&
        ! grep -q 'no march is recorded' "$scratch/answer.$1" # then there is only the colour
}

open_scratch
awk '$2 ~ /^solution-[0-9]+$/ { sub(/^solution-/, "", $2); print substr($1, 1, 2) "_" $2 }' \
    tests/pictures/images.txt | sort >"$scratch/exercises"
sed -n 's/^\([0-9][0-9]_[0-9]*\) .*/\1/p' tests/course/checks.txt | sort -u | comm -13 "$scratch/exercises" - >"$scratch/unknown"
check 'tests/course/checks.txt names only exercises that exist' [ ! -s "$scratch/unknown" ]
# answers.sh checks all exercises; it runs only before a release.
for exercise in 00_2 03_2 10_7 11_2 12_2 13_2; do
    check "$exercise: the solution is accepted" accepted $exercise chapters/solutions/"${exercise%_*}"_*_"${exercise#*_}".frag
    check "$exercise: the unsolved chapter is refused" refused $exercise chapters/"${exercise%_*}"_*.frag
done
check 'a number may lack its leading zero' accepted 3_2 chapters/solutions/03_shadows_2.frag
ends() { # STATUS FILE
    env -u EXERCISE -u FILE -u FILES make -s check EXERCISE=03_2 FILE="$2" >"$scratch/out" 2>"$scratch/err"
    [ $? = "$1" ] && [ ! -s "$scratch/err" ]
}
check 'make adds nothing to a right answer' ends 0 chapters/solutions/03_shadows_2.frag
check 'make adds nothing to a wrong one' ends 0 chapters/03_shadows.frag

# A folder outside the project, such as a lecturer's. It contains files from several students, some with the same name.
handed_in="$scratch/handed in"
mkdir -p "$handed_in/ada" "$handed_in/ben"
# This shader renders the solution's picture, but its rays differ: its first march goes in the opposite direction.
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
echo 'void main() { float light = 1 +; }' >"$handed_in/ben/broken.frag"
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
check "a right picture with wrong rays is refused" \
    one_is ben/rays.frag 'picture is right, but its rays are not: pixel '
build/03_shadows -f chapters/solutions/03_shadows_2.frag --print-shader=shadertoy >"$handed_in/toy.frag"
check "a right picture from a file that records no rays is refused" one_is toy.frag 'rays are not: no ray is recorded'
check "a file that does not compile is refused with the line of the error" \
    one_is ben/broken.frag 'does not run: .*broken.frag:1'
check "an empty file, with a space in its name, is refused" \
    one_is 'ben/empty file.frag' 'does not run: .*empty file.frag: empty'
check 'a missing file is refused' one_is absent.frag 'no such file'

# The maximum of two distances renders the same lens as the exact distance, but the number of steps differs.
bound() {
    sed 's|exact; // true|exact; // false|' chapters/solutions/04_hue_colour_4.frag >"$scratch/bound.frag"
    ! accepted 04_4 "$scratch/bound.frag" && grep -q 'most around ' "$scratch/answer.04_4"
}
check "a bound is refused where an exact distance is required" bound

table() { # EXERCISE PATTERN
    EXERCISE=$1 FILE='' FILES=$2 .make/check.sh >"$scratch/answer.03_2" 2>&1
}
of_class() {
    table 03_2 "$handed_in/*/*.frag"
    [ $? = 1 ] && says '^right  .*ada/my lamp.frag ' && says '^wrong  .*rays.frag ' &&
        says '^wrong  .*broken.frag ' && says '^wrong  .*empty file.frag ' && says '^1 of 6 right$'
}
check "the files in a folder outside the project are judged in a table" of_class
of_one_name() {
    local pictures
    pictures=$(grep -o 'build/check/.*difference.png' "$scratch/answer.03_2")
    [ "$(sort -u <<<"$pictures" | wc -l)" = 2 ] &&
        while IFS= read -r picture; do [ -s "$picture" ] || return 1; done <<<"$pictures"
}
check "files with the same name get separate pictures" of_one_name
listed() {
    table 03_2 "chapters/solutions/03_shadows_1.frag chapters/solutions/03_shadows_3.f*"
    [ $? = 1 ] && says '^0 of 2 right$' && [ ! -e build/check/03_2"$handed_in" ]
}
check "several names may be separated by spaces, and earlier pictures are removed" listed
nobody() { table 03_2 "$handed_in/eve/*.frag"; [ $? = 2 ] && says 'no such file'; }
check "a pattern that matches no file is refused" nobody
endless() {
    CHECK_LIMIT=1 table 00_1 "$handed_in/endless.frag"
    [ $? = 1 ] && says '^wrong .*does not end: no picture after 1 s'
}
check "a shader that never ends is refused" endless
# A limit on the size of files acts like a full disk: the solution's picture fits, but a picture of noise does not.
cat >"$scratch/noise.frag" <<'END'
#version 330 core
out vec4 FragColor;
void main()
{
    FragColor = fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * vec4(43758.5, 22578.1, 19642.3, 1.0));
}
END
full_disk() {
    (ulimit -f 400; trap '' XFSZ; table 00_2 "$scratch/noise.frag")
    [ $? = 2 ] && [ "$(wc -l <"$scratch/answer.03_2")" = 1 ] && says 'the disk has no room'
}
check "a full disk does not count as a wrong answer" full_disk
blank_name() {
    cp chapters/00_first_scene.frag "$handed_in/ada's ball.frag"
    ! accepted 00_2 "$handed_in/ada's ball.frag" && cp "$scratch/answer.00_2" "$scratch/answer.03_2" && says "look at yours: build/00_first_scene --shader '.*/hand.*ada'\"'\"'s ball.frag'"
}
check "a name with blanks and quotes is quoted in the command to be copied" blank_name
asks_wrong() { # EXERCISE WORDS
    EXERCISE=$1 FILE=x FILES='' .make/check.sh >"$scratch/answer.03_2" 2>&1
    [ $? = 2 ] && [ "$(wc -l <"$scratch/answer.03_2")" = 1 ] && says "$2"
}
check "a command without an exercise is refused" asks_wrong '' 'which exercise'
check "an exercise of a missing chapter is refused" asks_wrong 99_1 'have one: 00_1 '
check "an exercise without a solution is refused" asks_wrong 03_99 "have one: 00_1 .* 03_4 04_1 .* $(tail -n 1 "$scratch/exercises") engine_1 .*engine_4$"
check "a name that no exercise can have is refused" asks_wrong shadows 'such as 03_2'
plan
