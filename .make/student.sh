#!/bin/bash
# student.sh - `make student`: pack the course without its solutions and answers, as a folder and a zip in
# build/student/. `make check` works in the folder: the pictures and rays of the solutions are stored in
# tests/course/stored/. Only files that git tracks are copied, with the changes that are not committed yet. If the
# folder has become a repository, its history stays.
#
# Environment: STUDENT_FOLDER, by default build/student; EXERCISES, the exercises whose solutions' results are stored,
# by default all. The pictures are drawn again only if a shader, the programs' sources or a list of exercises has
# changed.
set -eu
export LC_ALL=C TZ=UTC
out=${STUDENT_FOLDER:-build/student}
course=$out/ray-marching stored=$out/stored

fail() {
    printf 'make: %s\n' "$*" >&2
    exit 2
}
# shellcheck source=.make/exercises.sh
. .make/exercises.sh

[ -d chapters/solutions ] || fail 'this is the course for students: make student requires the whole course'
git ls-files --error-unmatch Makefile >/dev/null 2>&1 || fail 'make student copies the files that git tracks, but this folder is not a git checkout: use git clone'

# ---- The parts of the solutions that a check needs ----

if [ ! -e "$stored/begun" ] || [ -n "$(find chapters shaders common tests/course/checks.txt tests/pictures/images.txt -newer "$stored/begun" | head -n 1)" ]; then
    rm -rf "$stored" && mkdir -p "$stored" && touch "$stored/begun"
fi
left=()
for exercise in ${EXERCISES:-$(exercises) $(engine_exercises)}; do
    [ -e "$stored/$exercise/text" ] || left+=("$exercise") # the file that is stored last
done
if [ ${#left[@]} -gt 0 ]; then
    echo "Drawing what make check needs for ${#left[@]} solutions; all solutions together take some minutes."
    printf '%s\n' "${left[@]}" | xargs -P "$(getconf _NPROCESSORS_ONLN)" -I '{}' \
        env EXERCISE='{}' STORE="$stored/{}" CHECK_FOLDER="$stored/.check" .make/check.sh || exit 2
    rm -rf "$stored/.check"
fi

# ---- The files ----

mkdir -p "$course"
find "$course" -mindepth 1 -maxdepth 1 ! -name .git ! -name build -exec rm -rf {} +
# File names may contain any characters.
git ls-files -z | tar --null -T - -cf - | tar -C "$course" -xf -
cd "$course"
rm -rf chapters/solutions tests/course/answers.* tests/course/claims.sh docs/teaching.md docs/questions.txt docs/web/guesses.txt .ci
: >docs/web/guesses.txt
# Two shaders of build/tests/measure contain the formula of a solution, which is replaced with 1.
for shader in openness shadows; do
    awk '/^float (nearTaps|signedClearance)\(/ { print; print "{\n    return 1.0;\n}"; formula = 1 }
        !formula { print }
        /^}/ { formula = 0 }' "$OLDPWD/tests/shaders/$shader.frag" >tests/shaders/$shader.frag
done
# Remove the suites that need files that are left out.
grep -lE 'solutions/|teaching[.]md|questions[.]txt' tests/*/*.sh tests/*/*.mjs | xargs rm -f
cp -R .make/student/folder/. .
cd "$OLDPWD"
mkdir "$course/tests/course/stored"
for exercise in "$stored"/*_*; do cp -R "$exercise" "$course/tests/course/stored/"; done

for page in README.md docs/README.md docs/platforms.md docs/[0-9]*.md docs/engine.md; do
    awk -f .make/student.awk "$page" | awk -v name="$page" -v list=.make/student/replaced.txt -f .make/student/replace.awk >"$course/$page"
done

# Keep only those pictures of solutions that a page shows.
for picture in "$course"/tests/references/*-solution-*.png; do
    cat "$course"/docs/*.md | grep -q -F "${picture##*/}" || rm "$picture"
done

# Write the list of the exercises and their pictures.
{
    printf '# What make check compares: each line has an exercise and the options of a picture. The right pictures are in\n# tests/course/stored/.\n\n'
    for exercise in $(exercises); do
        pictures_of "$(basename "$(echo chapters/"${exercise%_*}"_*.c)" .c)" "${exercise#*_}" | sed "s/^ */$exercise /"
    done
    echo
    grep '^engine_' tests/course/checks.txt
} >"$course/tests/course/checks.txt"
grep -v 'chapters/solutions/' tests/pictures/images.txt >"$course/tests/pictures/images.txt"

# ---- The zip: the same bytes each time ----

zip=$PWD/$out/ray-marching.zip
[[ $out != /* ]] || zip=$out/ray-marching.zip
rm -f "$zip"
date=$(git log -1 --format=%cd --date=format-local:%Y%m%d%H%M.%S)
find "$course" \( -name .git -o -path "$course/build" \) -prune -o -type f -exec touch -t "$date" {} +
(cd "$out" && find ray-marching \( -name .git -o -path ray-marching/build \) -prune -o -type f -print | sort | zip -q -9 -X -n .png:.webp -@ "$zip")
echo "$course/: the course for students, $(du -sm "$course/tests/course/stored" | cut -f 1) MB of pictures to check with; $out/ray-marching.zip: $(du -m "$zip" | cut -f 1) MB"
