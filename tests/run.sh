#!/bin/bash
# run.sh [SUITE...] - run every test suite, or those named, and add up. With --find before them, only say
# whether there are such suites.
#
# A suite is a program build/tests/test_NAME (cmocka) or a script tests/test_NAME.sh; either prints
# TAP: "ok 1 - name", "not ok 2 - name", "ok 3 - name # SKIP reason", other lines with '#'. Where CI is
# set, the unit and failure suites, and one picture, run a second time as sanitize/NAME on the programs of
# build/sanitize/. Exit status: 0 when all passed; a skip is a failure where CI is set.
set -u
export LC_ALL=C

cd "$(dirname "$0")/.." || exit 1
PROJECT_ROOT=$(pwd)
results=${TEST_RESULTS:-$PROJECT_ROOT/build/test-results/$$} # two runs at once do not meet
export PROJECT_ROOT TEST_RESULTS=$results
export MESA_SHADER_CACHE_DIR=$PROJECT_ROOT/build/shader-cache
export LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe
export CMOCKA_MESSAGE_OUTPUT=TAP
export LOCPATH=$PROJECT_ROOT/build/locale # a French one
# gcc's sanitizer takes some driver's thread-local block for one of its own layout, and its leak checker
# then dies of a wild pointer: it is told to leave those blocks alone.
export ASAN_OPTIONS=intercept_tls_get_addr=0
export LSAN_OPTIONS=suppressions=$PROJECT_ROOT/tests/lsan.supp:print_suppressions=0
export UBSAN_OPTIONS=print_stacktrace=1
limit=${TEST_LIMIT:-600} # seconds without a new result, after which a suite hangs, on a slow machine too

# ---- One suite ----

# One picture under the sanitizers, compared with the stored one.
sanitized_picture() {
    local stem=01_normal_colouring numbers status
    numbers=$(build/sanitize/$stem -o build/sanitize/$stem.png &&
        build/tests/compare tests/references/$stem.png build/sanitize/$stem.png)
    status=$?
    [ "$status" = 0 ] || printf 'not '
    echo "ok 1 - $stem rendered under the sanitizers is the stored picture"
    echo "# ${numbers:-no picture}"
    return "$status"
}
export -f sanitized_picture

command_of() { # NAME
    local name=$1 build=build
    case $name in sanitize/*) name=${name#sanitize/} build=build/sanitize ;; esac
    if [ "$1" = sanitize/one_picture ]; then
        echo sanitized_picture
    elif [ -e "tests/test_$name.sh" ]; then
        echo "BUILD=$build tests/test_$name.sh"
    else
        echo "$build/tests/test_$name"
    fi
}

# End a suite that hangs: that neither has a result nor has drawn a picture. The turns of this loop are
# counted, not a clock's seconds: a machine that slept, or was too busy for the loop, gave the suite no time
# either.
end_when_quiet() { # GROUP FILE
    local quiet=0 before='' now
    while [ "$quiet" -lt "$limit" ] && sleep 1; do
        now=$(grep -cE '^((not )?ok|# drawn)\>' "$2.tap")
        quiet=$((now == ${before:--1} ? quiet + 1 : 0)) before=$now
    done
    : >"$2.ended"
    kill -TERM -- "-$1"
    sleep 5
    kill -KILL -- "-$1"
}

# Run a command in a group of its own, which goes when it hangs or this script is interrupted.
watched() { # COMMAND FILE
    local suite watcher status
    set -m
    bash -c "$1" >"$2.tap" 2>"$2.err" </dev/null &
    suite=$!
    set +m
    end_when_quiet "$suite" "$2" >/dev/null 2>&1 &
    watcher=$!
    # shellcheck disable=SC2064 # these two
    trap "kill -TERM -- -$suite $watcher; exit 1" HUP INT TERM
    wait "$suite"
    status=$?
    kill "$watcher"
    wait "$watcher"
    trap - HUP INT TERM
    return "$status"
}

# Run a suite; leave its counts in NAME.counts and print its line.
run_one() { # NAME
    local file=$results/${1//\//-} status passed failed skipped planned seconds text="" TIMEFORMAT=%1R
    rm -f "$file.ended" # of an earlier run with the same folder for results
    { time watched "$(command_of "$1")" "$file"; } 2>"$file.time"
    status=$?
    seconds=$(tail -n 1 "$file.time")
    skipped=$(grep -cE '^(not )?ok\>.*# *SKIP\>' "$file.tap")
    passed=$(grep -E '^ok\>' "$file.tap" | grep -vcE '# *SKIP\>')
    failed=$(grep -E '^not ok\>' "$file.tap" | grep -vcE '# *SKIP\>')
    planned=$(sed -n 's/^1\.\.\([0-9][0-9]*\).*/\1/p' "$file.tap" | awk '{ n += $1 } END { print n + 0 }')
    if [ -e "$file.ended" ]; then
        text="no result for $limit s: ended"
    elif [ "$status" != 0 ] && [ "$failed" = 0 ]; then
        text="died with status $status"
    elif [ "$planned" != 0 ] && [ "$planned" != $((passed + failed + skipped)) ]; then
        text="planned $planned tests, ran $((passed + failed + skipped))"
    elif [ $((passed + failed + skipped)) = 0 ]; then
        text='ran no test'
    fi
    [ -n "$text" ] && failed=$((failed + 1))
    echo "$passed $failed $skipped" >"$file.counts"
    printf '%s\n' "$(
        printf '%-24s %4d passed' "$1" "$passed"
        [ "$failed" = 0 ] || printf ', %d FAILED' "$failed"
        [ "$skipped" = 0 ] || printf ', %d skipped' "$skipped"
        [ -z "$text" ] || printf ' (%s)' "$text"
        printf '  %s s' "$seconds"
        printf '\n'
        grep -E '^(not )?ok\>.*# *SKIP\>' "$file.tap" | sed 's/^/    /'
        if [ "$failed" != 0 ]; then
            sed 's/^/    /' "$file.tap" "$file.err" | tail -n 60
        fi
    )"
    {
        grep -E '^not ok\>' "$file.tap" | grep -vE '# *SKIP\>'
        [ -z "$text" ] || echo "$text"
    } | sed "s,^,FAILED: $1: ," >"$file.failed"
}

if [ "${1-}" = --one ]; then
    run_one "$2"
    exit 0
fi

# ---- All of them ----

names_of() { # FILE...: the NAMEs of the test files that exist
    local file name
    for file in "$@"; do
        [ -e "$file" ] || continue
        name=${file##*/test_}
        echo "${name%.*}"
    done
}

# Tests of shaders say nothing more under the sanitizers, which see C alone.
of_shaders() { grep -q 'tests/shaders/\|support_\(pixels\|measure\|bound\)\.h' "tests/test_$1.c"; }

# The long ones come first, so that none of them ends alone: the window's, which mostly wait, then the other scripts.
suites=$(
    names_of tests/test_window*.sh | sort -r
    [ -e tests/test_failures.sh ] && echo sanitize/failures
    [ -e tests/test_others.sh ] && echo sanitize/others
    names_of tests/test_*.sh | grep -v '^window'
    names_of tests/test_*.c
    for name in $(names_of tests/test_*.c); do
        of_shaders "$name" || echo "sanitize/$name"
    done
    echo sanitize/one_picture
)

find=
[ "${1-}" != --find ] || { find=1; shift; }
if [ -n "${1-}" ]; then
    for name in "$@"; do
        if ! grep -q -x -e "$name" <<<"$suites"; then
            printf 'make: SUITE=%s: no such suite: there are\n' "$name" >&2
            printf '%s\n' "$suites" | sed 's/^/  /' >&2
            exit 2
        fi
    done
    suites=$(printf '%s\n' "$@" | awk '!seen[$0]++')
else
    export ALL_SUITES=1
    # Where CI is set there is more to do: the sanitizers, each texture drawn anew, the wrong answers to exercises, what
    # pages say of two pictures, and the mistakes, each of which is planted.
    [ -n "${CI-}" ] || suites=$(grep -v -x -e 'sanitize/.*' -e textures -e answers -e claims <<<"$suites")
fi

[ -z "$find" ] || exit 0

for old in build/test-results/*; do
    kill -0 "$(basename "$old")" 2>/dev/null || rm -rf "$old"
done
mkdir -p "$results" || exit 1
# Of three one waits, and two compute: a suite has work for two processors at most, and the window's want little.
printf '%s\n' "$suites" | xargs -P 3 -n 1 tests/run.sh --one

read -r passed failed skipped <<<"$(cat "$results"/*.counts 2>/dev/null |
    awk '{ p += $1; f += $2; s += $3 } END { print p + 0, f + 0, s + 0 }')"
# A suite that left no counts was killed with its runner.
lost=$(($(wc -w <<<"$suites") - $(find "$results" -name '*.counts' | wc -l)))
if [ "$lost" != 0 ]; then
    echo "$lost suites left no result"
    failed=$((failed + lost))
fi
[ -n "${CI-}" ] && [ "$skipped" != 0 ] && echo 'In continuous integration nothing may be skipped.'
# Which ones, where they are seen: what their suites said may stand far above.
cat "$results"/*.failed 2>/dev/null
[ "$failed" = 0 ] && rm -rf "$results"
[ "$failed" = 0 ] || echo "What the suites printed is in build/test-results/$$."
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" = 0 ] && [ "$passed" != 0 ] && { [ -z "${CI-}" ] || [ "$skipped" = 0 ]; }
