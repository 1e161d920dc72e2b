#!/bin/bash
# test_teeth_c.sh [FILE|TEST...] - would the tests notice a mistake in the harness? Each of
# tests/mistakes_c.txt is planted in a copy of the sources; that file is compiled anew, the test in C that
# the line names is linked with it, and must fail; without a mistake it must pass there. With arguments only
# the mistakes of those files or tests. Among all suites it only looks, but for CI, whether each mistake finds its place.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/support.sh

# In COPY compile FILE anew, as all was built but for the warnings and what the compiler takes time for, and link
# PROGRAM with it, before the archive that has the right one.
rebuild() { # COPY FILE PROGRAM
    local command changed=()
    cd "$1" || return
    if [ "$2" != - ]; then
        rm -f "build/${2%.c}.o"
        read -r -a command <build/flags
        "${command[@]}" -w -O0 -g0 -c -o "build/${2%.c}.o" "$2" || return
        case $2 in tests/test_*) ;; *) changed=("build/${2%.c}.o") ;; esac
    fi
    read -r -a command <build/link
    command=("${command[@]//test_camera/$3}")
    "${command[0]}" ${changed[@]+"${changed[@]}"} "${command[@]:1}"
}

plant() { # LINE COPY: prints a result
    local line=$1 copy=$2 what catcher file why='' outcome
    what=$(field "$line" 1)
    catcher=$(field "$line" 2)
    file=$(field "$line" 3)
    if [ "$file" = - ]; then
        edit_copy "$copy" '' ''
    elif [ -e "$file" ] && [ ! -e "build/${file%.c}.o" ]; then
        echo "skip $what"
        return
    else
        why=$(edit_copy "$copy" "$file" "${line#*"$file"*| }")
    fi
    if [ -n "$why" ]; then
        echo "not ok $what: $why"
    elif ! (rebuild "$copy" "$file" "${catcher%% *}" >"$scratch/$number.log" 2>&1); then
        echo "not ok $what: it does not build: $(grep -m 1 -w -i 'error' "$scratch/$number.log")"
    elif [ "$file" = - ]; then
        outcome=$(cd "$copy" && try_test "$catcher" "$copy" "$copy/build/tests")
        [ "$outcome" = passes ] || printf 'not '
        echo "ok $what: it $outcome"
    else
        (cd "$copy" && judge_test "$what" "$catcher" "$copy" "$copy/build/tests")
    fi
}

. tests/support_teeth.sh

# Of a make that called, what it was told to build with.
case ${MAKEFLAGS-} in
*' -- '*) export MAKEFLAGS="-- ${MAKEFLAGS#* -- }" ;;
*) unset MAKEFLAGS ;;
esac
open_scratch
chmod 711 "$scratch" # whom a test becomes reaches what it left in a copy
if left_to_ci; then
    places tests/mistakes_c.txt
    exit
fi
# What building a test needs, and what a test reads.
mkdir -p "$scratch/right/tests" "$scratch/right/build/tests"
cp -Rp Makefile common chapters shaders "$scratch/right"
cp -Rp tests/*.[ch] tests/images.txt tests/corpus tests/shaders "$scratch/right/tests"
cp -Rp build/flags build/common build/shaders "$scratch/right/build"
cp -p build/tests/*.[ao] "$scratch/right/build/tests"
(cd "$scratch/right" && make --no-print-directory -n V=1 -W build/tests/test_camera.o build/tests/test_camera | tail -n 1 >build/link)
export BUILD=$root/build

mistakes_of tests/mistakes_c.txt | while read -r line; do
    for wanted in "${@:-|}"; do
        case $line in *" $wanted "*) printf '%s\n' "$line" ;; esac
    done
done >"$scratch/chosen"
while read -r line; do
    field "$line" 2
done <"$scratch/chosen" | sort -u | sed 's/.*/& passes without a mistake | & | - | -/' >"$scratch/mistakes"
cat "$scratch/chosen" >>"$scratch/mistakes"
plant_all
plan
