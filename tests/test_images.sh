#!/bin/bash
# test_images.sh [PICTURE...] - every picture of tests/images.txt against its reference; the chapters' own
# pictures through every backend, and the backends against each other. Where CI is set, or with arguments,
# every picture goes through every backend. With arguments only those pictures, such as 03_shadows or
# 03_shadows-steps.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/support.sh

failures=build/test-failures
# A picture that measures the rounding of the machine on which it is drawn: two right ones need not be
# alike. That it is drawn is held here, its numbers in test_measure.c.
measured=01_normal_colouring-normal-error

# One picture through one backend, against its reference: prints a result, which the parent numbers.
judge() { # NAME BACKEND
    local actual=$scratch/$1.$2.png reference=tests/references/$1.png numbers status kept
    if [ ! -s "$actual" ]; then
        echo "not ok $1, $2: $(head -n 3 "$scratch/$1.$2.err" | tr '\n' ' ')"
        return
    fi
    if [ ! -e "$reference" ]; then
        echo "not ok $1, $2: $reference is missing: make references"
        return
    fi
    numbers=$(build/tests/compare "$reference" "$actual" "$scratch/$1.$2.difference.png" 2>&1)
    status=$?
    if [ "$status" = 0 ] || { [ "$status" = 1 ] && [ "$1" = $measured ]; }; then
        echo "ok $1, $2: $numbers"
        return
    fi
    kept=$failures/$1.$2
    mkdir -p "$failures"
    cp "$reference" "$kept.expected.png"
    cp "$actual" "$kept.actual.png"
    cp "$scratch/$1.$2.difference.png" "$kept.difference.png" 2>/dev/null
    echo "not ok $1, $2: $numbers: see $kept.{expected,actual,difference}.png"
}

# The program writes equal pixels as equal files.
judge_backends() { # NAME FIRST OTHER...
    local name=$1 first=$2 other
    shift 2
    for other in "$@"; do
        if [ ! -e "$scratch/$name.$first.png" ] || [ ! -e "$scratch/$name.$other.png" ]; then
            echo "not ok $name: $first and $other: not both were rendered"
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

# The Nth picture of the list through all backends.
picture() { # BACKEND... N
    local number=${*: -1} stem variant options name backend
    set -- "${@:1:$#-1}"
    read -r stem variant options <<<"$(sed -n "${number}p" "$scratch/list")"
    name=$stem
    [ "$variant" = - ] || name=$stem-$variant
    [ "$variant" = - ] || [ -n "${EVERY_BACKEND-}" ] || set -- "$1"
    rm -f "$failures/$name".*
    for backend in "$@"; do
        # shellcheck disable=SC2086 # options are words
        "$BUILD/$stem" $options -b "$backend" -o "$scratch/$name.$backend.png" >/dev/null \
            2>"$scratch/$name.$backend.err" || rm -f "$scratch/$name.$backend.png"
        judge "$name" "$backend"
    done
    [ $# -gt 1 ] && judge_backends "$name" "$@"
}

if [ "${1-}" = --picture ]; then # called by xargs below
    set -f
    scratch=$2
    shift 2
    picture "$@" >"$scratch/${*: -1}.result"
    exit 0
fi

open_scratch

# Which pictures.
grep -v '^ *\(#\|$\)' tests/images.txt | while read -r stem variant options; do
    name=$stem
    [ "$variant" = - ] || name=$stem-$variant
    for wanted in "${@:-$name}"; do
        [ "$wanted" = "$name" ] && printf '%s %s %s\n' "$stem" "$variant" "$options"
    done
done >"$scratch/list"
count=$(grep -c . "$scratch/list")
check "tests/images.txt lists what is asked for" [ "$count" -ge "$(($# > 0 ? $# : 1))" ]
[ "$count" -gt 0 ] || { plan; exit; }
stem=$(cut -d ' ' -f 1 "$scratch/list" | tail -n 1)

# Which backends.
open_display || no_display='no Xvfb on this machine, or it did not start'
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

[ $# = 0 ] || EVERY_BACKEND=1
[ -z "${CI-}" ] || EVERY_BACKEND=1
export EVERY_BACKEND

# Two at a time: with one thread each they disturb each other least.
export LP_NUM_THREADS=1
check "at least one backend renders" [ ${#backends[@]} -gt 0 ] || { plan; exit; }
seq "$count" |
    xargs -P 2 -n 1 "$0" --picture "$scratch" "${backends[@]}"
for number in $(seq "$count"); do
    while read -r line; do
        case $line in
        ok*) ok "${line#ok }" ;;
        *) not_ok "${line#not ok }" ;;
        esac
    done <"$scratch/$number.result"
done
export -n LP_NUM_THREADS

# A reference that no line makes is a picture that nothing tests.
if [ $# = 0 ]; then
    unlisted=
    for file in tests/references/*.png; do
        name=$(basename "$file" .png)
        awk -v name="$name" '!/^ *#/ && NF > 1 { if (($2 == "-" ? $1 : $1 "-" $2) == name) found = 1 }
            END { exit !found }' tests/images.txt || unlisted="$unlisted $name"
    done
    if [ -z "$unlisted" ]; then
        ok "every reference has its line in tests/images.txt"
    else
        not_ok "every reference has its line in tests/images.txt" "not listed:$unlisted"
    fi
fi

# A picture is a function of its options alone.
here=$PWD
render() { # FILE ARGUMENT...
    local file=$1
    shift
    "$here/$BUILD/$program" -s 160x90 "$@" -o "$file" 2>"$scratch/err" ||
        { sed 's/^/# /' "$scratch/err"; return 1; }
}

program=$stem
render "$scratch/a.png"
from_elsewhere() { (cd / && render "$scratch/b.png") && cmp -s "$scratch/a.png" "$scratch/b.png"; }
check "the same picture from another directory" from_elsewhere
with_threads() {
    LP_NUM_THREADS=1 render "$scratch/a.png" && LP_NUM_THREADS=3 render "$scratch/b.png" &&
        cmp -s "$scratch/a.png" "$scratch/b.png"
}
check "the same picture by one thread and by three" with_threads

program=00_first_scene
turns() {
    render "$scratch/t0.png" -t 0 && render "$scratch/t1.png" -t 1 &&
        ! cmp -s "$scratch/t0.png" "$scratch/t1.png"
}
repeats() { render "$scratch/t2.png" -t 1 && cmp -s "$scratch/t1.png" "$scratch/t2.png"; }
# The camera turns by half a radian a second: once around in 4 pi seconds.
comes_round() {
    render "$scratch/t3.png" -t 12.566370614 &&
        build/tests/compare "$scratch/t0.png" "$scratch/t3.png" >/dev/null
}
check "chapter 00: another time, another picture" turns
check "chapter 00: the same time, the same picture" repeats
check "chapter 00: after 4 pi seconds the camera is back" comes_round

plan
