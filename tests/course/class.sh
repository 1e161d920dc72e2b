#!/bin/bash
# class.sh - tests `make marks` with a class of thirty invented students. Exercise 03.4 gets answers of every kind: right
# in different words, wrong, empty, endless, copied with other names. For exercise 03.1 almost everybody changes the same
# line in the same way, which makes nobody a copier. Every mark, every remark and every name in 'same as' must be as
# expected.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh
open_scratch
# shellcheck disable=SC2154 # open_scratch sets scratch
class=$scratch/class expected=$scratch/expected
chapter=chapters/03_shadows.frag solution=chapters/solutions/03_shadows_4.frag
: >"$expected"

# hand_in STUDENT EXERCISE MARK SAME REMARK: stores an answer from standard input, and records what the table must say.
# SAME is compared as it is, REMARK is a pattern.
hand_in() {
    mkdir -p "$class/$1"
    cat >"$class/$1/$2.frag"
    expect "$@"
}
expect() { printf '%s|%s|%s|%s|%s\n' "$@" >>"$expected"; }

# Print the chapter with one of the right answers in place of warmLight.
answer() { # N
    awk -v wanted="$1" '
        FILENAME ~ /txt$/ { if (/^== /) on = $2 == wanted; else if (on) text = text $0 "\n"; next }
        /^vec3 warmLight/ { printf "%s", text; skip = 1 }
        !skip { print }
        /^}/ { skip = 0 }' tests/course/nine_lamps.txt "$chapter"
}

# ---- Exercise 03.4 ----

for student in 01 03 04 05 06 08 09 10; do
    answer $((10#$student)) | hand_in $student 03_4 right '' 'matches the solution'
done
answer 2 | hand_in 02 03_4 right 23 'matches the solution'
answer 7 | hand_in 07 03_4 right 24 'matches the solution'

for student in 11 12; do answer $student | hand_in $student 03_4 wrong '' ' differ '; done
answer 6 | sed 's/0\.3/0.6/g' | hand_in 13 03_4 wrong '' ' differ '
answer 10 | sed 's/visibility(p, normal, toPoint/visibility(p, normal, (lampPosition() - p)/' | hand_in 14 03_4 wrong '' ' differ '
# The chapter with one number changed, equal by chance.
for student in 15 16; do sed 's/= 6.0; /= 5.0; /' "$chapter" | hand_in $student 03_4 wrong '' ' differ '; done

answer 10 | sed 's/vec3 sum/vec4 sum/' | hand_in 17 03_4 wrong '' 'does not run: .*frag:'
echo 'void main() { float light = 1 +; }' | hand_in 18 03_4 wrong '' 'does not run: .*frag:1'
hand_in 19 03_4 wrong '' 'does not run: .*empty' </dev/null
hand_in 20 03_4 wrong '' 'does not end: no picture after' <<'END'
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
for student in 21 22; do hand_in $student 03_4 wrong '' ' differ ' <"$chapter"; done

# Copies of other students' answers, and of the published solution: with other names, comments and blanks.
answer 2 | sed 's/onePoint/shine/g; s/offset/where/g; s/\<seen\>/s/g; s/\<distance\>/len/g; s/toLamp/way/g; s/\<light\>/l/g; s/; *$/ ; \/\/ mine/' |
    hand_in 23 03_4 right 02 'matches the solution'
answer 7 | sed 's/HALF_SIDE/H/g; s/toLamp/v/g; s/\<colour\>/c/g; s/\<seen\>/visible/g' |
    hand_in 24 03_4 right 07 'matches the solution'
sed 's/nineLamps/f/g; s/\<sum\>/total/g; s/toLamp/way/g; s/offset/o/g; s/lampSide/side/g; s/^{/{ \/* all * mine *\/ /' "$solution" |
    hand_in 25 03_4 right 'the published solution' 'matches the solution'
echo '#include "solutions/03_shadows_4.frag"' | hand_in 26 03_4 right 'the published solution' 'matches the solution'

head -c 4000 build/00_first_scene | hand_in 27 03_4 wrong '' 'does not run: '
echo '#include "/etc/passwd"' | hand_in 28 03_4 wrong '' 'does not run: .*/etc/passwd'
{
    printf '#version 330 core\nout vec4 FragColor;\n#define A0 x + x\n'
    for ((i = 1; i <= 28; i++)); do printf '#define A%d A%d + A%d\n' $i $((i - 1)) $((i - 1)); done
    printf 'void main() { float x = 1.0; FragColor = vec4(A28); }\n'
} | hand_in 29 03_4 wrong '' 'does not run: \|does not end'
mkdir -p "$class/30"
mkfifo "$class/30/03_4.frag"
expect 30 03_4 wrong '' 'not a regular file'

# ---- Exercise 03.1 ----

# The chapter with a new line for the light of the cold lamp.
cold() { awk -v line="        vec3 coldLight = $1;" '/^        vec3 coldLight = / { print line; next } { print }' "$chapter"; }
cold_light='lampLight(normal, COLD_LAMP - p, COLD_COLOUR)'
cold_seen='visibility(p, normal, normalize(COLD_LAMP - p), length(COLD_LAMP - p))'
for student in 0{1..9} {10..26}; do cold "$cold_seen * $cold_light" | hand_in "$student" 03_1 right '' 'matches the solution'; done
cold "$cold_light * $cold_seen" | hand_in 27 03_1 right '' 'matches the solution'
cold "sun ? $cold_light : $cold_seen * $cold_light" | hand_in 28 03_1 right '' 'matches the solution'
for student in 29 30; do cold "0.5 * $cold_light" | hand_in $student 03_1 wrong '' ' differ '; done

# ---- The table ----

marks() { FILES="$class/*/*.frag" EXERCISES='03_1 03_4' CSV=$scratch/marks.csv .make/marks.sh >"$scratch/said" 2>&1; }
check 'a class of thirty is marked' marks || sed 's/^/# /' "$scratch/said"
# Print the fields of the table's rows, separated by '|'. A comma within quotes does not separate fields.
awk '{
    text = ""
    for (i = 1; i <= length($0); i++) {
        c = substr($0, i, 1)
        if (c == "\"") quoted = !quoted
        else text = text (c == "," && !quoted ? "|" : c)
    }
    print text }' "$scratch/marks.csv" >"$scratch/rows"
says() { # MARK SAME REMARK MARK SAME REMARK: the first three are found, the others expected
    [ "$1" = "$4" ] && [ "$2" = "$5" ] && grep -q -e "$6" <<<"$3" && return
    echo "# $1, same as '$2': $3"
    return 1
}
while IFS='|' read -r student exercise mark same remark; do
    first=2
    [ "$exercise" = 03_1 ] || first=5
    IFS='|' read -r a b c < <(awk -F '|' -v student="$student" -v n=$first 'BEGIN { OFS = "|" } $1 "" == student { print $n, $(n + 1), $(n + 2) }' "$scratch/rows")
    check "student $student, exercise $exercise: $mark${same:+, the same as $same}" says "${a-}" "${b-}" "${c-}" "$mark" "$same" "$remark"
done <"$expected"
check 'the marks are counted' grep -q '^30 students; answers: 42 right, 18 wrong; 6 almost the same as another$' "$scratch/said" || sed 's/^/# /' "$scratch/said"
plan
