#!/bin/bash
# student.sh - `make student`: pack the course without its solutions and answers, as a folder and a zip in
# build/student/. `make check` works in the folder: the pictures and rays of the solutions are stored in
# tests/course/stored/. Only files that git tracks are copied, with the changes that are not committed yet. What somebody
# has added to the folder or changed in it stays, the history of a repository included: build/student/written lists the
# files that this script has written. The zip contains those files alone.
#
# Environment: STUDENT_FOLDER, by default build/student; EXERCISES, the exercises whose solutions' results are stored,
# by default all. The pictures are drawn again only if a shader, the programs' sources or a list of exercises has
# changed.
set -eu
export TZ=UTC
. .make/write.sh
. .make/written.sh
out=${STUDENT_FOLDER:-build/student}
course=$out/ray-marching stored=$out/stored

# shellcheck source=.make/exercises.sh
. .make/exercises.sh

[ -d chapters/solutions ] || fail 2 'this is the course for students: make student requires the whole course'
git ls-files --error-unmatch Makefile >/dev/null 2>&1 || fail 2 'make student copies the files that git tracks, but this folder is not a git checkout: use git clone'

# ---- The parts of the solutions that a check needs ----

if [ ! -e "$stored/begun" ] || [ -n "$(find chapters shaders common tests/course/checks.txt tests/pictures/images.txt -newer "$stored/begun" | head -n 1)" ]; then
    rm -rf "$stored" && mkdir -p "$stored" && touch "$stored/begun"
fi
sweep "$stored"
left=()
for exercise in ${EXERCISES:-$(all_exercises)}; do
    [ -e "$stored/$exercise" ] || left+=("$exercise")
done
if [ ${#left[@]} -gt 0 ]; then
    echo "Drawing what make check needs for ${#left[@]} solutions; all of them together take two minutes."
    printf '%s\n' "${left[@]}" | xargs -P "$(getconf _NPROCESSORS_ONLN)" -I '{}' \
        env EXERCISE='{}' STORE="$stored/{}" .make/check.sh || exit 2
fi

# ---- The files ----

begin "$out"
made=$new/ray-marching
mkdir "$made"
# File names may contain any characters.
git ls-files -z | tar --null -T - -cf - | tar -C "$made" -xf -
(
    project=$PWD
    cd "$made"
    rm -rf chapters/solutions tests/course/answers.* tests/course/claims.sh docs/teaching.md docs/questions.txt docs/web/guesses.txt .ci
    : >docs/web/guesses.txt
    # Two shaders of build/tests/measure contain the formula of a solution, which is replaced with 1.
    for shader in openness shadows; do
        awk '/^float (nearTaps|signedClearance)\(/ { print; print "{\n    return 1.0;\n}"; formula = 1 }
            !formula { print }
            /^}/ { formula = 0 }' "$project/tests/shaders/$shader.frag" >tests/shaders/$shader.frag
    done
    # Remove the suites that need files that are left out.
    grep -lE 'solutions/|teaching[.]md|questions[.]txt|stand_ins[.]sh' tests/*/*.sh tests/*/*.mjs | xargs rm -f
    cp -R .make/student/folder/. .
)
mkdir "$made/tests/course/stored"
for exercise in "$stored"/*_*; do cp -R "$exercise" "$made/tests/course/stored/"; done
cp chapters/[0-9][0-9]_*.frag "$made/tests/course/stored/"

for page in README.md docs/README.md docs/platforms.md docs/[0-9]*.md docs/engine.md; do
    awk -f .make/student.awk "$page" | awk -v name="$page" -v list=.make/student/replaced.txt -f .make/student/replace.awk >"$made/$page"
done

# Keep only those pictures that a file names, such as a page, and the first one of each chapter. They are for the eye, so
# 160 colours in each are enough, and the suites that compare them are left out.
{
    grep -rohaE '[A-Za-z0-9_-]+[.]png' "$made" --include='*.md' --include='*.mjs' --include='*.c' --include='*.sh'
    find "$made/docs" -name '[0-9][0-9]_*.md' | sed 's/.*\///; s/md$/png/'
} | sort -u >"$new/named"
find "$made/tests/references" -name '*.png' | awk -F / -v list="$new/named" '
    BEGIN { while ((getline name <list) > 0) named[name] }
    !($NF in named)' | tr '\n' '\0' | xargs -0 rm -f
find "$made/tests/references" -name '*.png' -print0 |
    xargs -0 -P "$(getconf _NPROCESSORS_ONLN)" -n 16 pngquant 160 --speed 7 --skip-if-larger --strip --force --ext .png ||
    [ $? = 123 ] # some would be larger
rm -f "$made"/tests/pictures/images.sh "$made"/tests/pictures/weak.sh
for diagram in "$made"/docs/figures/*.svg; do # one that only a solution shows is not in this course
    grep -qF "figures/${diagram##*/}" "$made"/docs/*.md || rm -f "$diagram" "${diagram%.svg}.c"
done

# Write the list of the exercises and their pictures.
{
    printf '# What make check compares: each line has an exercise and the options of a picture. The right pictures are in\n# tests/course/stored/.\n\n'
    for exercise in $(exercises); do
        pictures_of "$(basename "$(echo chapters/"${exercise%_*}"_*.c)" .c)" "${exercise#*_}" | sed "s/^ */$exercise /"
    done
    echo
    grep '^engine_' tests/course/checks.txt
} >"$made/tests/course/checks.txt"
grep -v 'chapters/solutions/' tests/pictures/images.txt >"$made/tests/pictures/images.txt"

# ---- The zip: the same bytes each time ----

date=$(git log -1 --format=%cd --date=format-local:%Y%m%d%H%M.%S)
find "$made" -type f -exec touch -t "$date" {} +
(cd "$new" && find ray-marching -type f -print | sort | zip -q -9 -X -n .png:.webp -@ ray-marching.zip)

# ---- The folder ----

# Replace the files that this script has written, if nobody has changed them, and leave all others alone.
update() {
    local what name
    mkdir -p "$course"
    touch "$out/written"
    sums "$course" >"$new/there"
    awk '{ name = $0; sub(/^[0-9]+ [0-9]+ /, "", name); sum = $1 " " $2 }
        FILENAME ~ /written$/ { ours[name, sum]; was[name]; next }
        FILENAME ~ /files$/ { made[name] = sum; next }
        { there[name] = sum }
        END {
            for (name in made)
                if (!(name in there)) print "put", name
                else if (there[name] != made[name]) print (((name, there[name]) in ours) ? "put" : "own"), name
            for (name in was)
                if (!(name in made) && (name in there) && ((name, there[name]) in ours)) print "remove", name
        }' "$out/written" "$new/files" "$new/there" | sed 's/ [.]\// /' | sort >"$new/plan"
    # If this is killed halfway, the next run must know the files of both.
    write "$out/written" sort -u "$out/written" "$new/files"
    while read -r what name; do
        if [ "$what" = remove ]; then
            rm -f "$course/$name"
            rmdir -p "$(dirname "$course/$name")" 2>/dev/null || :
        elif [ "$what" = own ] || [ -d "$course/$name" ] || [ -L "$course/$name" ]; then
            printf '%s\n' "$name" >>"$new/own"
        else
            mkdir -p "$(dirname "$course/$name")"
            mv -f "$made/$name" "$course/$name"
        fi
    done <"$new/plan"
    write "$out/written" cat "$new/files"
}
sums "$made" >"$new/files"
if [ -e "$course" ]; then
    (trap '' HUP INT PIPE TERM && update)
else
    keep ray-marching && write "$out/written" cat "$new/files"
fi
keep ray-marching.zip
if [ -e "$new/own" ]; then
    report "$course: these files were changed there and stay as they are: $(paste -s -d ' ' - <"$new/own"): to get the new ones, delete them and repeat make student"
fi
echo "$course/: the course for students, $(du -sm "$course/tests/course/stored" | cut -f 1) MB of pictures to check with; $out/ray-marching.zip: $(du -m "$out/ray-marching.zip" | cut -f 1) MB"
