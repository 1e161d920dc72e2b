#!/bin/bash
# kept.sh - interrupts the commands that write files with Ctrl+C, a request to end, or a kill, and tests that every file
# is the old one or the new one, whole, and that nothing else is left: no file, no process. A moment is the start of a
# tool, or the middle of a result, so that no clock decides. It also tests what `make clean` leaves.
#
# Environment: CI, to interrupt all commands, at three moments more with each signal, or ALL, at ten; EVERY=1 with them,
# at every moment, which takes an hour.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh
. tests/lib/stand_ins.sh
open_scratch
make_project

# ---- Interrupting a command ----

# copy FROM TO: copies a project.
copy() { rm -rf "$2" && cp -pR "$1" "$2"; }

# start COMMAND...: run a command in the project, in a process group of its own, to its end.
start() {
    rm -rf "$moments" "$TMPDIR" && mkdir "$moments" "$TMPDIR" && : >"$moments/0"
    set -m
    (within "$@") >"$scratch/said" 2>&1 </dev/null &
    group=$!
    set +m
    { wait "$group"; } 2>/dev/null # without bash's message about a process that was killed
    while alive; do sleep 0.05; done
}
# True while a process of the group lives.
alive() {
    cat /proc/[0-9]*/stat 2>/dev/null | awk -v group="$group" '{ sub(/.*[)] /, "") } $3 == group && $1 !~ /[ZX]/ { n++ } END { exit !n }'
}

# whole FOLDER|FILE...: each of these is in the project as in $scratch/before or as in $scratch/new.
whole() {
    local name
    for name; do
        [ -e "$scratch/before/$name" ] || [ -e "$project/$name" ] || continue
        diff -r "$scratch/before/$name" "$project/$name" >/dev/null 2>&1 || diff -r "$scratch/new/$name" "$project/$name" >/dev/null 2>&1 || {
            echo "# $name is neither the old one nor the new one"
            return 1
        }
    done
}
# The pictures in stored/ are drawn again whenever a shader changes, also if a run was interrupted. While `make student`
# replaces files, its list `written` has those of both versions.
sums_of() {
    (cd "$1" && find . \( -name '.ray-marching.*' -o -path ./.git -o -path ./build/student/stored -o -path ./build/student/written \) -prune -o -type f -exec cksum {} + | LC_ALL=C sort)
}
# every_file: each file of the project is that of $scratch/before or that of $scratch/new.
every_file() {
    sums_of "$project" >"$scratch/sums"
    LC_ALL=C comm -23 "$scratch/sums" "$scratch/any" >"$scratch/more"
    [ ! -s "$scratch/more" ] || { sed 's/^/# left: /' "$scratch/more" && return 1; }
}
# nothing_else: there is no other file, neither in the project nor in TMPDIR, and none is missing.
nothing_else() {
    find "$project" "$TMPDIR" -name '.ray-marching.*' -o -path "$TMPDIR/*" >"$scratch/more"
    cut -d ' ' -f 3- "$scratch/sums" | LC_ALL=C sort | LC_ALL=C comm -13 - "$scratch/both" >"$scratch/less"
    [ ! -s "$scratch/more" ] && [ ! -s "$scratch/less" ] && return
    sed 's/^/# left: /' "$scratch/more"
    sed 's/^/# lost: /' "$scratch/less"
    return 1
}

# interrupt WHOLES SIGNAL MOMENT COMMAND...
interrupt() {
    local wholes=$1 signal=$2 at=$3
    shift 3
    copy "$scratch/before" "$project"
    SIGNAL=$signal AT=$at start "$@"
    # shellcheck disable=SC2086 # words
    if every_file; then
        [ "$signal" != KILL ] || after_kill "$@"
        every_file && whole $wholes && nothing_else && { [ "$signal$repeats" != KILL1 ] || diff -r "$scratch/new" "$project"; } && return
    fi
    echo "# signal $signal at moment $at of $last, $*"
    sed 's/^/# /' "$scratch/said"
    return 1
}

# What a killed command leaves is removed by the next run, which finds every file. That run must not wait until init has
# taken note of the end of the process, so the file gets the number of a process that cannot exist.
after_kill() { # COMMAND...
    local left
    find "$project" -name '.ray-marching.*' -prune | while IFS= read -r left; do
        if [ -n "$repeats" ]; then mv "$left" "${left%/*}/.ray-marching.99999999.${left##*.}"; else rm -rf "$left"; fi
    done
    [ -z "$repeats" ] || start "$@"
}

# survives NAME WHOLES COMMAND...: the command makes WHOLES, names of files and folders, each of which stays whole.
repeats=1 # a second run of the command gives the same files
survives() {
    local name=$1 wholes=$2 each
    shift 2
    copy "$project" "$scratch/start"
    new_version 1
    [ -z "$repeats" ] || start "$@"
    new_version 2
    copy "$project" "$scratch/before"
    start "$@"
    last=$(($(find "$moments" -type l | wc -l))) first=1
    until [ "$(readlink "$moments/$first")" = mv ] || [ $first = "$last" ]; do first=$((first + 1)); done
    copy "$project" "$scratch/new"
    for each in before new; do
        sums_of "$scratch/$each" >"$scratch/$each.sums"
        cut -d ' ' -f 3- "$scratch/$each.sums" | LC_ALL=C sort >"$scratch/$each.names"
    done
    LC_ALL=C sort -u "$scratch/before.sums" "$scratch/new.sums" >"$scratch/any"
    LC_ALL=C comm -12 "$scratch/before.names" "$scratch/new.names" >"$scratch/both"
    for each in $wholes; do
        if [ ! -e "$scratch/new/$each" ] || diff -r "$scratch/before/$each" "$scratch/new/$each" >/dev/null 2>&1; then
            not_ok "$name: a run makes a new $each"
            sed 's/^/# /' "$scratch/said"
            return
        fi
    done
    check "$name leaves the old result or the new one, whole, when it is interrupted" each_moment "$wholes" "$@"
    copy "$scratch/start" "$project"
}
# Try the moment in the middle, and those around the first new name.
each_moment() {
    local wholes=$1 i signal steps=0
    shift
    interrupt "$wholes" INT $((last / 2)) "$@" && interrupt "$wholes" TERM $first "$@" && interrupt "$wholes" KILL $((first + 1)) "$@" || return
    [ -z "${CI-}" ] || steps=3
    [ -z "${ALL-}" ] || steps=10
    [ -z "${EVERY-}" ] || steps=$last
    for ((i = 1; i <= steps; i++)); do
        for signal in INT TERM KILL; do
            interrupt "$wholes" $signal $(((last * i + steps - 1) / steps)) "$@" || return
        done
    done
}

# ---- The commands ----

echo v >"$project/my.obj"

survives 'make questions' 'build/questions/ray-marching.gift build/questions/ray-marching.xml' .make/questions.sh
survives 'make film' 'build/film/00_first_scene build/film/00_first_scene.mp4 build/film/00_first_scene.gif' env CHAPTER=00 .make/film.sh
survives 'make marks' 'build/marks marks.csv' env EXERCISES=00_2 FILES='answers/*.frag' CSV=marks.csv .make/marks.sh
repeats=
survives 'make chapter' 'tests/pictures/images.txt chapters/24_mine.c chapters/24_mine.frag docs/24_mine.md' env NAME=mine .make/chapter.sh
survives 'make play' chapters/play.frag .make/play.sh
repeats=1
if [ -n "${CI-}${ALL-}" ]; then
    survives 'make bake' build/my.png env MESH=my.obj .make/bake.sh
    survives 'make book' build/book.pdf .make/book.sh
    survives 'make handouts' 'build/handouts.pdf build/handouts-answers.pdf' .make/handouts.sh
    survives 'make slides' 'build/slides build/slides.pdf' .make/slides.sh
    survives 'make lecture' build/lecture-scenes .make/lecture.sh
    survives 'make check' build/check/00_2 env EXERCISE=00_2 FILES='answers/*' .make/check.sh
    survives 'make docs' docs/engine.md .make/listings.sh docs/README.md docs/engine.md
    survives 'make benchmark' docs/benchmark.md env WRITE=1 ROUNDS=1 .make/benchmark.sh
    survives 'make benchmark MARCHES=1' docs/benchmark.md env WRITE=1 MARCHES=1 .make/benchmark.sh
    survives 'make textures' shaders/textures/noise.png .make/textures.sh
    survives 'make figures' docs/figures/a.svg .make/figures.sh a
    survives 'make web' 'build/web/course build/web/course.json build/web/harness.js' .make/web.sh
    survives 'make site' 'build/site build/site.zip' .make/site.sh
    survives 'make figures-html' build/figures .make/figures_html.sh
    survives 'make windows-zip' build/ray-marching-windows.zip .make/windows_zip.sh
fi

# ---- The course for students ----

course=$project/build/student/ray-marching
if git -C "$project" init -q --template= && git -C "$project" add -A . 2>/dev/null &&
    git -C "$project" -c user.name=t -c user.email=t@t commit -q -m all; then
    (within env EXERCISES=00_2 .make/student.sh) >"$scratch/said" 2>&1 || sed 's/^/# /' "$scratch/said"
    mkdir -p "$course/.git" "$course/own" && echo history >"$course/.git/HEAD" && echo mine | tee "$course/own/page.md" >>"$course/LICENSE"
    [ -z "${CI-}${ALL-}" ] ||
        survives 'make student' 'build/student/ray-marching build/student/ray-marching.zip' env EXERCISES=00_2 .make/student.sh
fi

# ---- make clean ----

# clean FILE...: `make clean` removes build/, except build/student/ if that contains these files, and says so in a line.
clean() {
    local file
    (within .make/clean.sh) >"$scratch/said" 2>&1 || return
    if [ $# = 0 ]; then
        [ ! -e "$project/build" ] && [ ! -s "$scratch/said" ]
    else
        for file; do [ -e "$project/build/student/$file" ] || return; done
        [ "$(ls "$project/build")" = student ] && [ "$(wc -l <"$scratch/said")" = 1 ] && grep -q '^make: build/student: kept, because' "$scratch/said"
    fi
}
has() { # FILE...: a new build/ with a course for students and these files
    local file
    rm -rf "$project/build" && mkdir -p "$course/build" "$project/build/film" && : | tee "$project/build/student/ray-marching.zip" "$course/build/x" >"$course/README.md"
    (cd "$course" && cksum ./README.md) >"$project/build/student/written"
    for file; do mkdir -p "$(dirname "$project/build/student/$file")" && echo mine >"$project/build/student/$file"; done
}
has && check 'make clean removes build/' clean
has ray-marching/.git/HEAD && check 'a repository stays' clean ray-marching/.git/HEAD ray-marching/README.md
has ray-marching/answers/00_1.frag && check 'a file that was added to the course stays' clean ray-marching/answers/00_1.frag
has ray-marching/README.md && check 'a file that was changed in the course stays' clean ray-marching/README.md
has notes.txt && check 'a file beside the course stays' clean notes.txt
rm -rf "$project/build" && check 'without build/, make clean does nothing' clean
plan
