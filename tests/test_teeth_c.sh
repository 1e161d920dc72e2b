#!/bin/bash
# test_teeth_c.sh [FILE|TEST...] - would the tests notice a mistake in the harness? Each of
# tests/mistakes_c.txt is planted in a copy of the sources; that file is compiled anew, the test in C that
# the line names is linked with it, and must fail; without a mistake it must pass there. With arguments only
# the mistakes of those files or tests. Among all suites it only looks, but for CI, whether each mistake finds its place.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/support.sh

# Compile FILE anew, as all was built but for the warnings, link TEST as it stands in COPY, and run it.
rebuild_and_run() { # COPY FILE TEST
    local compile
    cd "$1" || return 2
    read -r -a compile <build/flags
    if [ "$2" != - ]; then
        rm -f "build/${2%.c}".[od]
        "${compile[@]}" -w -O1 -MMD -MP -c -o "build/${2%.c}.o" "$2" >log 2>&1 || return 2
    fi
    make "build/tests/$3" >log 2>&1 || return 2
    ulimit -S -t 120 # a mistake may hang a test: seconds of the processor, which a busy machine does not shorten
    PROJECT_ROOT=$1 BUILD=$root/build CMOCKA_MESSAGE_OUTPUT=TAP "build/tests/$3" >log 2>&1 </dev/null || return 1
}

plant() { # LINE COPY: prints a result
    local line=$1 copy=$2 what catcher file why='' failed
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
        return
    fi
    (rebuild_and_run "$copy" "$file" "$catcher")
    case $?$file in
    0-) echo "ok $what" ;;
    0*) echo "not ok $what: $catcher does not see it" ;;
    1*)
        failed=$(sed -n 's/^not ok [0-9]* - / /p' "$copy/log" | tr '\n' ',' | sed 's/,$//')
        case $file in
        -) echo "not ok $what: it fails in$failed" ;;
        *) echo "ok $what: $catcher fails in$failed" ;;
        esac
        ;;
    *) echo "not ok $what: it does not build: $(grep -m 1 -w -i 'error' "$copy/log")" ;;
    esac
}

. tests/support_teeth.sh

# Of a make that called, what it was told to build with.
case ${MAKEFLAGS-} in
*' -- '*) export MAKEFLAGS="-- ${MAKEFLAGS#* -- }" ;;
*) unset MAKEFLAGS ;;
esac
open_scratch
if left_to_ci; then
    places tests/mistakes_c.txt
    exit
fi
# What building a test needs, with the times that make compares, and what a test reads.
mkdir -p "$scratch/right/tests" "$scratch/right/build/tests"
cp -Rp Makefile common chapters shaders "$scratch/right"
cp -Rp tests/*.[ch] tests/images.txt tests/corpus tests/shaders "$scratch/right/tests"
cp -Rp build/flags build/common build/shaders "$scratch/right/build"
cp -p build/tests/*.[od] "$scratch/right/build/tests"

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
