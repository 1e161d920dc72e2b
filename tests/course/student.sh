#!/bin/bash
# student.sh - tests `make student`: the course for students has no solutions and no answers, its links work, and `make
# check` gives the same verdicts there as in the whole course. For this test, only three exercises are stored.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh
if ! command -v zip >/dev/null || ! command -v pngquant >/dev/null || ! git rev-parse 2>/dev/null; then
    skip 'the course for students' 'this machine has no zip or no pngquant, or the project is not a checkout of git'
    plan
    exit
fi
open_scratch
# shellcheck disable=SC2154 # open_scratch sets scratch
course=$scratch/out/ray-marching
student() { STUDENT_FOLDER=$scratch/out EXERCISES='00_2 01_6 engine_1' .make/student.sh >"$scratch/said" 2>&1; }
check_empty() { check "$1" [ ! -s "$2" ] || head -n 8 "$2" | sed 's/^/# /'; } # NAME FILE

check 'make student packs the course' student || sed 's/^/# /' "$scratch/said"
chapters=$(find docs -name '[0-9][0-9]_*.md' | wc -l)

# ---- What is in it ----

check 'the course for students has the pages of all chapters' [ "$(find "$course/docs" -name '[0-9][0-9]_*.md' | wc -l)" = "$chapters" ]
find "$course" -path '*solutions*' -o -name 'teaching.md' -o -name 'questions.txt' -o -name 'answers.txt' >"$scratch/found"
check_empty 'the course for students has no solutions, no answers, no questions and no guide for teachers' "$scratch/found"
grep -nE 'summary>(Answer|Solution)<|chapters/solutions/' "$course"/README.md "$course"/docs/{README,engine,[0-9]*}.md >"$scratch/found"
check_empty 'no page of a chapter has a folded answer or names a solution' "$scratch/found"
hints() { cat "$@" | grep -c '<summary>Hint'; }
check 'the course for students has all hints' [ "$(hints "$course"/docs/*.md)" = "$(hints docs/*.md)" ]
exercises() { cat "$@" | grep -cE '^\*\*[0-9]+\. \((easy|medium|hard)\)'; }
check 'the course for students has all exercises' [ "$(exercises "$course"/docs/*.md)" = "$(exercises docs/*.md)" ]
# Print the long lines of the solutions that are in no other shader and on no page outside a fold.
own_lines() {
    cat chapters/solutions/*.frag | grep -E '^    ' | sort -u >"$scratch/lines"
    find chapters shaders \( -name '*.frag' ! -path '*solutions*' -o -name '*.glsl' \) -exec cat {} + >"$scratch/others"
    cat docs/*.md | awk '/^ *<details>/ { fold = 1 } !fold { print } /<\/details>/ { fold = 0 }' >>"$scratch/others"
    grep -vxFf "$scratch/others" "$scratch/lines" | awk 'length > 40'
}
own_lines >"$scratch/own"
grep -rnFf "$scratch/own" "$course" --include='*.frag' --include='*.md' --include='*.glsl' --include='*.txt' >"$scratch/found"
check 'more than 100 long lines are only in solutions' [ "$(wc -l <"$scratch/own")" -gt 100 ]
check_empty 'the course for students has no line that is only in a solution' "$scratch/found"
for page in "$course"/README.md "$course"/docs/*.md; do
    # shellcheck disable=SC2016 # the backticks are Markdown's
    sed 's/`[^`]*`//g' "$page" | grep -oE '\]\([^)#]+' | cut -c 3- | grep -vE '^(https?|mailto):' | while read -r target; do
        [ -e "$(dirname "$page")/$target" ] || echo "${page#"$course/"}: $target"
    done
done >"$scratch/found"
check_empty 'the target of every link and every picture in the course for students exists' "$scratch/found"
grep -n 'solutions/' "$course/tests/pictures/images.txt" >"$scratch/found"
check_empty 'the gallery of the course for students renders no picture of a solution' "$scratch/found"
check 'the course for students has a dev container, a workflow and a folder for answers' [ -e "$course/.devcontainer/devcontainer.json" -a -e "$course/.github/workflows/check.yml" -a -x "$course/answers/check.sh" ]
unnamed() { cat "$course"/README.md "$course"/docs/*.md | grep -qF 01_normal_colouring-steps.png || [ ! -e "$course/tests/references/01_normal_colouring-steps.png" ]; }
check 'a picture that no page shows is left out' unnamed
diagrams() { for diagram in "$course"/docs/figures/*.svg; do grep -qF "figures/${diagram##*/}" "$course"/docs/*.md || return; done; }
check 'a page shows each diagram, as the tests in the course require' diagrams
firsts() { for page in docs/[0-9][0-9]_*.md; do [ -e "$course/tests/references/$(basename "$page" .md).png" ] || return; done; }
check 'the first picture of each chapter is there' firsts
small() { du -sk "$course/tests/references" | awk '{ print "# " $1 " KB of pictures"; exit !($1 < 15000) }'; }
check 'all pictures of the pages together have at most 15 MB' small
added() { [ "$(ls "$course/tests/course/stored/00_2")" = "1.added.png
2.added.png
rays" ] && [ "$(cat "$course"/tests/course/stored/00_2/*.png | wc -c)" -lt 40000 ]; }
check 'of a solution'"'"'s picture, only what it adds to the chapter'"'"'s is stored' added
files() { (cd "$scratch/out" && find ray-marching -type f ! -path '*/.git/*'); }
zipped() { unzip -Z1 "$scratch/out/ray-marching.zip" 2>/dev/null || python3 -m zipfile -l "$scratch/out/ray-marching.zip" | awk 'NR > 1 { print $1 }'; }
check 'the zip has as many files as the folder' diff <(files | wc -l) <(zipped | wc -l)

# ---- The folder, written again ----

# A file of an older course, one that is no longer in the course, one that a lecturer has changed, and two that are new.
again() {
    mkdir -p "$course/.git" && : >"$course/.git/kept" && echo mine >"$course/.gitlab-ci.yml" && echo mine >>"$course/LICENSE" &&
        mkdir "$course/docs/old" && echo old >"$course/docs/old/page.md" && echo old >"$course/Makefile" &&
        (cd "$course" && cksum ./docs/old/page.md ./Makefile) >>"$scratch/out/written" && cp "$scratch/out/ray-marching.zip" "$scratch/zip" && student
}
check 'make student writes the folder again' again || sed 's/^/# /' "$scratch/said"
check 'an old file is replaced' cmp Makefile "$course/Makefile"
check 'a file that is no longer in the course is removed, with its folder' [ ! -e "$course/docs/old" ]
check 'what was added stays, the history included' [ -e "$course/.git/kept" -a -s "$course/.gitlab-ci.yml" ]
changed() { [ "$(tail -n 1 "$course/LICENSE")" = mine ] && [ "$(grep -c 'changed there and stay as they are: LICENSE: ' "$scratch/said")" = 1 ]; }
check 'a file that was changed stays, and its name is printed' changed
check 'the zip has the same bytes as before' cmp "$scratch/zip" "$scratch/out/ray-marching.zip"
check 'nothing else is left in the folder' [ "$(ls -A "$scratch/out")" = "ray-marching
ray-marching.zip
stored
written" ]

# ---- make check in it ----

ln -s "$root/build" "$course/build"
judged() { # EXERCISE FILE WORDS STATUS
    (cd "$course" && EXERCISE=$1 FILE=$2 FILES='' .make/check.sh) >"$scratch/said" 2>&1
    [ $? = "$4" ] && grep -q -e "$3" "$scratch/said" && return
    sed 's/^/# /' "$scratch/said"
    return 1
}
right=chapters/solutions/00_first_scene_2.frag
{ cat $right; echo '#define MINE'; } >"$scratch/mine.frag"
check 'a right answer is accepted' judged 00_2 "$scratch/mine.frag" ': right: matches the solution in 2 pictures: no pixel differs ' 0
edited() {
    sed -i 's/0.5 \* Time/0.7 + Time/' "$course/chapters/00_first_scene.frag" && judged 00_2 "$scratch/mine.frag" ': right: ' 0 &&
        cp chapters/00_first_scene.frag "$course/chapters/"
}
check 'a student may have changed the chapter' edited
whole() { [ -e "$course/tests/course/stored/01_6/1.png" ] && judged 01_6 "$root/chapters/solutions/01_normal_colouring_6.frag" ': right: matches ' 0; }
check 'all of it is stored if the chapter lacks a parameter' whole
echo '#include "solutions/00_first_scene_2.frag"' >"$scratch/includes.frag"
check 'an answer that includes the published solution does not run' judged 00_2 "$scratch/includes.frag" ': wrong: does not run' 1
sed 's/0.5 \* Time/Time/' $right >"$scratch/wrong.frag"
check 'a wrong answer is refused' judged 00_2 "$scratch/wrong.frag" ': wrong: .* most around ' 1
check 'the colour of the right picture is printed' grep -q "the solution's: colour: [0-9]*, [0-9]*, [0-9]*$" "$scratch/said"
check 'right pictures with wrong rays are refused' eval "printf '# hit\n' >$course/tests/course/stored/00_2/rays; judged 00_2 $scratch/mine.frag 'its rays are not' 1"
check 'an exercise that is not stored is refused' judged 00_3 "$scratch/mine.frag" 'neither chapters/solutions/.* nor tests/course/stored/00_3 exists' 2
if [ -x build/first_steps/engine_6 ]; then
    patch -s -o "$scratch/engine.c" chapters/first_steps/engine_6.c chapters/solutions/engine_1.diff
    echo 'int own;' >>"$scratch/engine.c"
    check 'a right program is accepted' judged engine_1 "$scratch/engine.c" ': right: matches the solution in 2 pictures' 0
    check 'the unchanged program is refused' judged engine_1 chapters/first_steps/engine_6.c ': wrong: ' 1
fi
plan
