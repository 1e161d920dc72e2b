#!/bin/bash
# class.sh - tests `make marks` with a class of thirty invented students and two exercises: right and wrong answers,
# copies, and files that do not compile, never end or do harm. Every mark and every remark must be as expected.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh
open_scratch
# shellcheck disable=SC2154 # open_scratch sets scratch
class=$scratch/class expected=$scratch/expected
: >"$expected"

# expect STUDENT EXERCISE MARK REMARK: records what the table must say.
expect() { printf '%s\t%s\t%s\t%s\n' "$@" >>"$expected"; }

solution() { echo chapters/solutions/"${1%_*}"_*_"${1#*_}".frag; } # EXERCISE
chapter() { echo chapters/"${1%_*}"_*.frag; }

# hand_in STUDENT EXERCISE MARK REMARK: stores an answer from standard input, and records the expected mark and remark.
hand_in() {
    mkdir -p "$class/$1"
    cat >"$class/$1/$2.frag"
    expect "$@"
}

# Print the edits in tests/course/answers.txt for an exercise and a verdict, one per line.
edits() { # EXERCISE VERDICT
    awk -F ' +[|] +' -v exercise="$1" -v verdict="$2" '$1 == exercise && $2 == verdict { sub(/^[^|]*[|][^|]*[|][^|]*[|] /, ""); print }' tests/course/answers.txt
}

for exercise in 00_2 03_2; do
    # Seventeen right answers: sixteen are the solution with a different last line, and one is an edit from answers.txt.
    for student in 01 02 03 04 05 06 07 08 09 10 11 12 13 14 15 16; do
        { cat "$(solution $exercise)"; echo "#define STUDENT_$student"; } | hand_in "$student" $exercise right 'matches the solution'
    done
    edits $exercise right | head -n 1 >"$scratch/edit"
    sed "$(cat "$scratch/edit")" "$(solution $exercise)" | hand_in 17 $exercise right 'matches the solution'
    # Two wrong answers, and the unsolved chapter from two students, which does not count as copying.
    edits $exercise wrong | head -n 2 >"$scratch/edits"
    sed "$(sed -n 1p "$scratch/edits")" "$(solution $exercise)" | hand_in 18 $exercise wrong ' differ '
    sed "$(sed -n 2p "$scratch/edits")" "$(solution $exercise)" | hand_in 19 $exercise wrong ' differ '
    hand_in 20 $exercise wrong 'differ\|compile' <"$(chapter $exercise)"
    hand_in 21 $exercise wrong 'differ\|compile' <"$(chapter $exercise)"
    # The published solution, once disguised and once included, and the same answer from two students.
    { echo '/* all * my own */'; sed 's/; *$/ ;  \/\/ mine/' "$(solution $exercise)"; } | hand_in 22 $exercise copied '^the published solution; matches the'
    echo '#include "solutions/'"$(basename "$(solution $exercise)")"'"' | hand_in 23 $exercise copied '^the published solution; '
    for student in 24 25; do
        { cat "$(solution $exercise)"; echo "#define TWIN // $student"; } | hand_in $student $exercise copied '^the same text: 24, 25; matches the solution'
    done
    # Files that do not compile: one with a syntax error, one that is empty, and one that is not text.
    echo 'float sceneDistance(vec3 p) { return 1 +; }' | hand_in 26 $exercise wrong 'does not run: .*frag:1'
    hand_in 27 $exercise wrong 'does not run: .*empty' </dev/null
    head -c 4000 build/00_first_scene | hand_in 28 $exercise wrong 'does not run: '
done

# The last two students hand in a shader that never ends, one that includes a system file, one that exhausts the memory,
# and a pipe.
hand_in 29 00_2 wrong 'does not end: no picture after' <<'END'
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
echo '#include "/etc/passwd"' | hand_in 29 03_2 wrong 'does not run: .*/etc/passwd'
{
    printf '#version 330 core\nout vec4 FragColor;\n#define A0 x + x\n'
    for ((i = 1; i <= 28; i++)); do printf '#define A%d A%d + A%d\n' $i $((i - 1)) $((i - 1)); done
    printf 'void main() { float x = 1.0; FragColor = vec4(A28); }\n'
} | hand_in 30 00_2 wrong 'does not run: \|does not end'
mkdir -p "$class/30"
mkfifo "$class/30/03_2.frag"
expect 30 03_2 wrong 'not a regular file'

marks() { FILES="$class/*/*.frag" EXERCISES='00_2 03_2' CSV=$scratch/marks.csv .make/marks.sh >"$scratch/said" 2>&1; }
check 'a class of thirty is marked' marks || sed 's/^/# /' "$scratch/said"
while IFS=$'\t' read -r student exercise mark remark; do
    column=2
    [ "$exercise" = 00_2 ] || column=4
    awk -F ',' -v student="\"$student\"" '$1 == student' "$scratch/marks.csv" | tr -d '\n' >"$scratch/row"
    found=$(awk -v column=$column '{
        # Split a row into fields. A comma within quotes does not separate fields.
        for (i = 1; i <= length($0); i++) {
            c = substr($0, i, 1)
            if (c == "\"") quoted = !quoted
            else if (c == "," && !quoted) n++
            else if (n == column - 1) mark = mark c
            else if (n == column) text = text c
        }
        print mark "\t" text }' "$scratch/row")
    check "the answer of student $student to exercise $exercise is marked $mark" eval "[ '$mark' = \"\${found%%\$'\t'*}\" ] && grep -q -e '$remark' <<<\"\${found#*\$'\t'}\"" || echo "# $found"
done <"$expected"
check 'the marks are counted' grep -q '^30 students; answers: 34 right, 18 wrong, 8 copied$' "$scratch/said" || sed 's/^/# /' "$scratch/said"
plan
