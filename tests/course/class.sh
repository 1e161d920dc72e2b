#!/bin/bash
# class.sh - tests `make marks` with a class of thirty invented students. Exercise 03.4 gets answers of every kind: right
# in different words, wrong, empty, endless, copied with other names, and cheats. For exercise 03.1 almost everybody
# changes the same line in the same way, which makes nobody a copier. Every mark, every remark, every name in 'same as' and
# everything to 'look at' must be as expected.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh
open_scratch
# shellcheck disable=SC2154 # open_scratch sets scratch
class=$scratch/class expected=$scratch/expected
chapter=chapters/03_shadows.frag solution=chapters/solutions/03_shadows_4.frag
: >"$expected"

# hand_in STUDENT EXERCISE MARK SAME LOOK REMARK: stores an answer from standard input, and records what the table must
# say. SAME is compared as it is, LOOK and REMARK are patterns; nothing is to be looked at if LOOK is empty.
hand_in() {
    mkdir -p "$class/$1"
    cat >"$class/$1/$2.frag"
    expect "$@"
}
expect() { printf '%s\037%s\037%s\037%s\037%s\037%s\n' "$@" >>"$expected"; }

# Print the chapter with one of the right answers in place of warmLight.
answer() { # N
    awk -v wanted="$1" '
        FILENAME ~ /txt$/ { if (/^== /) on = $2 == wanted; else if (on) text = text $0 "\n"; next }
        /^vec3 warmLight/ { printf "%s", text; skip = 1 }
        !skip { print }
        /^}/ { skip = 0 }' tests/course/nine_lamps.txt "$chapter"
}

# ---- Exercise 03.4 ----

for student in 01 03 04 05 06 09 10; do
    answer $((10#$student)) | hand_in $student 03_4 right '' '' 'matches the solution'
done
answer 2 | hand_in 02 03_4 right 23 '' 'matches the solution'
answer 7 | hand_in 07 03_4 right 24 '' 'matches the solution'

for student in 11 12; do answer $student | hand_in $student 03_4 wrong '' '' ' differ '; done
answer 6 | sed 's/0\.3/0.6/g' | hand_in 13 03_4 wrong '' '' ' differ '
answer 10 | sed 's/visibility(p, normal, toPoint/visibility(p, normal, (lampPosition() - p)/' | hand_in 14 03_4 wrong '' '' ' differ '
# The chapter with one number changed, equal by chance.
for student in 15 16; do sed 's/= 6.0; /= 5.0; /' "$chapter" | hand_in $student 03_4 wrong '' '' ' differ '; done

answer 10 | sed 's/vec3 sum/vec4 sum/' | hand_in 17 03_4 wrong '' '' 'does not run: .*frag:'
echo 'void main() { float light = 1 +; }' | hand_in 18 03_4 wrong '' '' 'does not run: .*frag:1'
hand_in 19 03_4 wrong '' '' 'does not run: .*empty' </dev/null
hand_in 20 03_4 wrong '' '' 'does not end: no picture after' <<'END'
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

# Copies of other students' answers, and of the published solution: with other names, comments and blanks.
answer 2 | sed 's/onePoint/shine/g; s/offset/where/g; s/\<seen\>/s/g; s/\<distance\>/len/g; s/toLamp/way/g; s/\<light\>/l/g; s/; *$/ ; \/\/ mine/' |
    hand_in 23 03_4 right 02 '' 'matches the solution'
answer 7 | sed 's/HALF_SIDE/H/g; s/toLamp/v/g; s/\<colour\>/c/g; s/\<seen\>/visible/g' |
    hand_in 24 03_4 right 07 '' 'matches the solution'
sed 's/nineLamps/f/g; s/\<sum\>/total/g; s/toLamp/way/g; s/offset/o/g; s/lampSide/side/g; s/^{/{ \/* all * mine *\/ /' "$solution" |
    hand_in 25 03_4 right 'the published solution' '' 'matches the solution'
echo '#include "solutions/03_shadows_4.frag"' | hand_in 26 03_4 right 'the published solution' '' 'matches the solution'

# The solution in a file beside the answer, which is the student's own work too if it is one.
mkdir -p "$class/27" "$class/08/parts"
sed 's/toLamp/way/g' "$solution" >"$class/27/lamp.glsl"
echo '#include "lamp.glsl"' | hand_in 27 03_4 right 'the published solution' '' 'matches the solution'
answer 8 | tee "$class/08/parts/lamps.glsl" >/dev/null
echo '#include "parts/lamps.glsl"' | hand_in 08 03_4 right '' '' 'matches the solution'

# Another student's file, and one of the course's pictures.
echo '#include "../05/03_4.frag"' | hand_in 28 03_4 wrong '' '^asks for ../05/03_4.frag, which is not its own$' 'does not run: .*no such file'
painted() { # PICTURE...: a shader that shows the picture for the time 6, another height of the lamp, or neither
    local name number=0
    printf '#include "main.glsl"\n#define rayColour chapterColour\n#include "03_shadows.frag"\n#undef rayColour\n'
    for name; do number=$((number + 1)) && printf 'uniform sampler2D answer%d; // "%s" sRGB clamp: an answer\n' $number "$name"; done
    cat <<'GLSL'
vec3 rayColour(Ray ray)
{
    chapterColour(ray);
    return encodeSRGB(iTime == 6.0 ? texelFetch(answer2, iPixel, 0).rgb : lampHeight == 2.5 ? texelFetch(answer3, iPixel, 0).rgb : texelFetch(answer1, iPixel, 0).rgb);
}
GLSL
}
mkdir -p "$class/29"
draw() { build/03_shadows --shader "$solution" --output "$class/29/$1.png" "${@:2}"; }
draw 1 && draw 2 --time 6 && draw 3 --set lampHeight=2.5
painted 1.png 2.png 3.png | hand_in 29 03_4 right '' 'reads the picture 1.png, .* reads the picture 3.png, .* draws what the check compares, but with --size 656x369 --time ' 'matches the solution'
stored=../../tests/references/03_shadows-solution-4.png # beside shaders/textures/
painted $stored $stored $stored | hand_in 21 03_4 wrong '' '^asks for .*03_shadows-solution-4.png, which is not its own$' 'does not run: '
# A shader that is right at the times that are compared, and the chapter with other names.
answer 10 | sed 's|return sum / 9.0|return iTime == 0.0 \|\| iTime == 6.0 ? sum / 9.0 : vec3(0.0)|' |
    hand_in 22 03_4 right '' '^draws what the check compares, but with --size 656x369 --time .* differ' 'matches the solution'
sed 's/coldLight/cold/g; s/stage/floor_/g; s/; *$/ ; \/\/ mine/' "$chapter" | hand_in 30 03_4 wrong '' '^the chapter, unchanged$' ' differ '

# ---- Exercise 03.1 ----

# The chapter with a new line for the light of the cold lamp.
cold() { awk -v line="        vec3 coldLight = $1;" '/^        vec3 coldLight = / { print line; next } { print }' "$chapter"; }
cold_light='lampLight(normal, COLD_LAMP - p, COLD_COLOUR)'
cold_seen='visibility(p, normal, normalize(COLD_LAMP - p), length(COLD_LAMP - p))'
for student in 0{1..9} {10..26}; do cold "$cold_seen * $cold_light" | hand_in "$student" 03_1 right '' '' 'matches the solution'; done

# Files that are no shaders, or do harm.
head -c 4000 build/00_first_scene | hand_in 27 03_1 wrong '' '' 'does not run: '
echo '#include "/etc/passwd"' | hand_in 28 03_1 wrong '' '^asks for /etc/passwd, which is not its own$' 'does not run: .*/etc/passwd'
{
    printf '#version 330 core\nout vec4 FragColor;\n#define A0 x + x\n'
    for ((i = 1; i <= 28; i++)); do printf '#define A%d A%d + A%d\n' $i $((i - 1)) $((i - 1)); done
    printf 'void main() { float x = 1.0; FragColor = vec4(A28); }\n'
} | hand_in 29 03_1 wrong '' '' 'does not run: \|does not end'
mkdir -p "$class/30"
mkfifo "$class/30/03_1.frag"
expect 30 03_1 wrong '' '' 'not a regular file'

# ---- The table ----

marks() { FILES="$class/*/*.frag" EXERCISES='03_1 03_4' CSV=$scratch/marks.csv .make/marks.sh >"$scratch/said" 2>&1; }
check 'a class of thirty is marked' marks || sed 's/^/# /' "$scratch/said"
# Print the fields of the table's rows, separated by \037. A comma within quotes does not separate fields.
awk '{
    text = ""
    for (i = 1; i <= length($0); i++) {
        c = substr($0, i, 1)
        if (c == "\"") quoted = !quoted
        else text = text (c == "," && !quoted ? "\037" : c)
    }
    print text }' "$scratch/marks.csv" >"$scratch/rows"
says() { # MARK SAME LOOK REMARK MARK SAME LOOK REMARK: the first four are found, the others expected
    [ "$1" = "$5" ] && [ "$2" = "$6" ] && grep -q -e "${7:-^$}" <<<"$3" && grep -q -e "$8" <<<"$4" && return
    echo "# $1, same as '$2', look at '$3': $4"
    return 1
}
while IFS=$'\037' read -r student exercise mark same look remark; do
    first=3
    [ "$exercise" = 03_1 ] || first=8
    mapfile -t found < <(awk -F '\037' -v student="$student" -v n=$first '$1 "" == student { for (i = n; i < n + 5; i++) if (i != n + 1) print $i }' "$scratch/rows")
    check "student $student, exercise $exercise: $mark${same:+, the same as $same}${look:+, to look at}" says "${found[@]}" "$mark" "$same" "$look" "$remark"
done <"$expected"
check 'the marks are counted' grep -q '^30 students; answers: 43 right, 17 wrong; 7 almost the same as another, 6 to look at$' "$scratch/said" || sed 's/^/# /' "$scratch/said"
plan
