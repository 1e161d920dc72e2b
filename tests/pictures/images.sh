#!/bin/bash
# images.sh [PICTURE...] - draws every picture of tests/pictures/images.txt and compares it with its reference. Every
# fourth chapter's own picture is drawn through every backend, and the backends are compared with each other. With
# arguments, such as 03_shadows or 03_shadows-steps, only those pictures are drawn, each through every backend. Without
# arguments, solutions of exercises are drawn only with CI=1 or ALL=1. ALL=1 also adds the 'smooth' pictures, which
# average nine samples per pixel and take nine times as long, and draws every chapter through every backend.
# CHAPTERS_ONLY=1 draws only the chapters' own pictures.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh

failures=build/test-failures
# This picture shows the rounding errors of the machine that draws it, so two correct copies may differ. It is only
# drawn here; tests/shaders/measure.c tests the errors.
measured=01_normal_colouring-normal-error

# Draw pictures through a backend: a chapter's own picture with the chapter's program, as a user starts it, and all
# others with build/tests/draw, which draws many in one process with the programs' code. Each picture is written to
# NAME.BACKEND.png, and draw also writes a line of numbers. draw_rest prints the name of each picture when it is done,
# so that tests/run sees that the suite makes progress.
draw_by_program() { # NAME BACKEND
    local options
    options=$(sed -n "s/^$1 - //p" "$scratch/list")
    # shellcheck disable=SC2086 # the options are separate words
    "$BUILD/$1" $options -b "$2" -o "$scratch/$1.$2.png" >/dev/null 2>"$scratch/$1.$2.err" ||
        rm -f "$scratch/$1.$2.png"
}
draw_rest() { # BACKEND PART: draws every second picture that has a variant, starting with index PART (0 or 1)
    awk -v part="$2" '$2 != "-" && n++ % 2 == part { print $1 "-" $2 }' "$scratch/list" |
        "$BUILD/tests/draw" "$1" "$scratch" 2>"$scratch/$1.$2.errors" |
        while read -r said; do
            printf '%s\n' "$said" >&3
            printf '# drawn by %s: %s\n' "$1" "${said#* }"
        done 3>"$scratch/$1.$2.numbers"
}

# Compare one backend's picture with its reference, and print the result.
judge() { # NAME BACKEND
    local actual=$scratch/$1.$2.png reference=tests/references/$1.png said same='' numbers kept
    if [ ! -e "$reference" ]; then
        echo "not ok $1, $2: $reference is missing: run make references"
        return
    fi
    said=$(grep -h " $1 " "$scratch/$2".[01].numbers 2>/dev/null)
    case $said in
    same*) same=1 numbers=${said#* * } ;;
    other*) numbers=${said#* * } ;;
    *)
        if [ ! -s "$actual" ]; then
            echo "not ok $1, $2: $(head -n 3 "$scratch/$1.$2.err" "$scratch/$2".[01].errors 2>/dev/null | tr '\n' ' ')"
            return
        fi
        numbers=$(build/tests/compare "$reference" "$actual" 2>&1) && same=1
        ;;
    esac
    if [ -n "$same" ] || { [ "$1" = $measured ] && [ -n "$numbers" ]; }; then
        echo "ok $1, $2: $numbers"
        return
    fi
    kept=$failures/$1.$2
    mkdir -p "$failures"
    cp "$reference" "$kept.expected.png"
    cp "$actual" "$kept.actual.png"
    build/tests/compare "$reference" "$actual" "$kept.difference.png" >/dev/null 2>&1
    echo "not ok $1, $2: $numbers: see $kept.{expected,actual,difference}.png"
}

# Compare the files of several backends: the program writes equal pixels as equal files.
judge_backends() { # NAME FIRST OTHER...
    local name=$1 first=$2 other
    shift 2
    for other in "$@"; do
        if [ ! -e "$scratch/$name.$first.png" ] || [ ! -e "$scratch/$name.$other.png" ]; then
            echo "not ok $name: $first and $other: at least one was not rendered"
            return
        fi
        if ! cmp -s "$scratch/$name.$first.png" "$scratch/$name.$other.png"; then
            echo "not ok $name: $first and $other differ:" \
                "$(build/tests/compare "$scratch/$name.$first.png" "$scratch/$name.$other.png" 2>&1)"
            return
        fi
    done
    echo "ok $name: $first $* agree in every pixel"
}

if [ "${1-}" = --draw ]; then # called by xargs below
    set -f
    scratch=$2
    "${@:3}"
    exit 0
fi

open_scratch

# List the requested pictures.
grep -v '^ *\(#\|$\)' tests/pictures/images.txt | while read -r stem variant options; do
    name=$stem
    [ "$variant" = - ] || name=$stem-$variant
    for wanted in "${@:-$name}"; do
        [ "$wanted" = "$name" ] || continue
        case $#${CI-}${ALL-},${CHAPTERS_ONLY-},$variant in 0,,solution-* | *,1,[!-]*) continue ;; esac
        case $#${ALL-},$variant in 0,smooth) continue ;; esac
        printf '%s %s %s\n' "$stem" "$variant" "$options"
    done
done >"$scratch/list"
asked=$# count=$(grep -c . "$scratch/list")
check "tests/pictures/images.txt lists the requested pictures" [ "$count" -ge "$(($# > 0 ? $# : 1))" ]
[ "$count" -gt 0 ] || { plan; exit; }
stem=$(cut -d ' ' -f 1 "$scratch/list" | tail -n 1)

# Find the backends that work on this machine.
open_display || no_display='Xvfb is missing, or did not start'
backends=()
for backend in egl osmesa glfw; do
    if [ $backend = glfw ] && [ -n "${no_display-}" ]; then
        skip "pictures through glfw" "$no_display"
    elif "$BUILD/$stem" --version -b $backend >"$scratch/version" 2>&1; then
        backends+=("$backend")
    else
        skip "pictures through $backend" "$(head -n 1 "$scratch/version")"
    fi
done

check "at least one backend renders" [ ${#backends[@]} -gt 0 ] || { plan; exit; }
all=("${backends[@]}") # the backends that draw all pictures
[ $# != 0 ] || all=("${backends[0]}")
# The backends share a driver, so every fourth chapter's own picture is enough to show that they agree.
everywhere() { [ $asked != 0 ] || [ -n "${ALL-}" ] || [ $((10#${1%%_*} % 4)) = 0 ]; } # NAME
# Two processes run at a time. With one thread each, they slow each other down least.
export LP_NUM_THREADS=1
{
    for backend in "${all[@]}"; do
        printf '%s\n' "draw_rest $backend 0" "draw_rest $backend 1"
    done
    sed -n 's/ - .*//p' "$scratch/list" | while read -r name; do
        for backend in "${backends[@]}"; do
            printf '%s\n' "draw_by_program $name $backend"
            everywhere "$name" || break
        done
    done
} | xargs -P 2 -L 1 "$0" --draw "$scratch"
export -n LP_NUM_THREADS
while read -r name variant _; do
    through=("${backends[@]}")
    everywhere "$name" || through=("${backends[0]}")
    [ "$variant" = - ] || name=$name-$variant through=("${all[@]}")
    rm -f "$failures/$name".*
    for backend in "${through[@]}"; do
        judge "$name" "$backend"
    done
    [ ${#through[@]} = 1 ] || judge_backends "$name" "${through[@]}"
done <"$scratch/list" >"$scratch/results"
while read -r line; do
    case $line in
    ok*) ok "${line#ok }" ;;
    *) not_ok "${line#not ok }" ;;
    esac
done <"$scratch/results"

awk '/ largest [0-9]/ { all++; none += !/ differ / } END { printf "# %d pictures, %d identical to their references\n", all, none }' \
    "$scratch/results"

# A reference without a line in images.txt would not be tested.
if [ $# = 0 ]; then
    unlisted=
    for file in tests/references/*.png; do
        name=$(basename "$file" .png)
        [ "$name" != engine_5 ] || continue # drawn by docs/engine.md's program, for tests/course/first_steps.sh
        awk -v name="$name" '!/^ *#/ && NF > 1 { if (($2 == "-" ? $1 : $1 "-" $2) == name) found = 1 }
            END { exit !found }' tests/pictures/images.txt || unlisted="$unlisted $name"
    done
    if [ -z "$unlisted" ]; then
        ok "every reference has a line in tests/pictures/images.txt"
    else
        not_ok "every reference has a line in tests/pictures/images.txt" "not listed:$unlisted"
    fi
fi

# A picture depends only on its options.
here=$PWD
render() { # FILE ARGUMENT...
    local file=$1
    shift
    "$here/$BUILD/$program" -s 160x90 "$@" -o "$file" 2>"$scratch/err" ||
        { sed 's/^/# /' "$scratch/err"; return 1; }
}

program=$stem
with_threads() {
    LP_NUM_THREADS=1 render "$scratch/a.png" && LP_NUM_THREADS=3 render "$scratch/b.png" &&
        cmp -s "$scratch/a.png" "$scratch/b.png"
}
check "one thread and three threads draw the same picture" with_threads

# The camera turns at half a radian per second, so it completes a turn in 4 pi seconds.
program=00_first_scene
comes_round() {
    render "$scratch/t0.png" -t 0 && render "$scratch/t3.png" -t 12.566370614 &&
        build/tests/compare "$scratch/t0.png" "$scratch/t3.png" >/dev/null
}
check "chapter 00: the camera is back at its start after 4 pi seconds" comes_round

plan
