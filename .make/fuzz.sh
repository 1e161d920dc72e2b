#!/bin/bash
# fuzz.sh - `make fuzz`: libFuzzer generates inputs for the parsers of user-written text, which are built with clang's
# sanitizers. It starts from the files in tests/corpus/NAME; tests/lib/fuzz.h lists the conditions that must hold.
#
# Environment: DURATION, seconds for each target, 60 by default. Exit status: 0 if nothing was found; 1 after a crash, a
# leak, a hang (5 s for one input) or a violated condition; 2 if DURATION is invalid. The input that causes an error is
# kept in build/fuzz/; add it to tests/corpus after the error is corrected.
set -u
. .make/names.sh

folder=build/fuzz
duration=${DURATION:-60}
case $duration in
'' | *[!0-9]* | 0*) fail 2 "DURATION=$duration: must be a positive whole number of seconds, as in DURATION=60" ;;
esac
export ASAN_OPTIONS=detect_leaks=1
export UBSAN_OPTIONS=print_stacktrace=1

running=''
# TMPDIR is in memory if possible, because files are written faster there. It is removed at the end, because libFuzzer
# exits without removing its files.
TMPDIR=$(mktemp -d -p "$([ ! -w /dev/shm ] || echo /dev/shm)") || exit 1
export TMPDIR
trap 'rm -rf "$TMPDIR"' EXIT
trap 'kill $running 2>/dev/null; wait; exit 1' HUP INT TERM

# New inputs that libFuzzer finds are kept for the next run, separately from the committed files. The targets capture
# standard error, so -close_fd_mask=2 makes libFuzzer write its messages to a copy of the descriptor.
fuzz() { # TARGET
    mkdir -p "$folder/found/$1"
    FUZZ=$1 exec "$folder/tests/fuzz" -max_total_time="$duration" -timeout=5 -rss_limit_mb=2048 -max_len=4096 \
        -close_fd_mask=2 -dict="tests/corpus/$1.dict" -artifact_prefix="$folder/$1-" -print_final_stats=1 \
        "$folder/found/$1" "tests/corpus/$1" >"$folder/$1.log" 2>&1 </dev/null
}

number() { sed -n "s/^stat::$1: *//p" "$2"; }

targets=()
for list in tests/corpus/*.dict; do
    targets+=("$(basename "$list" .dict)")
done
echo "make fuzz: ${targets[*]}: $duration s each, at the same time"
for target in "${targets[@]}"; do
    fuzz "$target" &
    running="$running $!"
done

wrong=0
for process in $running; do
    target=${targets[0]} targets=("${targets[@]:1}")
    if wait "$process"; then
        printf '%-10s %9d inputs, no crash, no leak, no hang\n' "$target" "$(number number_of_executed_units "$folder/$target.log")"
    else
        wrong=1
        echo "$target: $(grep -m 1 -E '^broken promise|^==[0-9]+== ?ERROR:|: runtime error:' "$folder/$target.log" || tail -n 1 "$folder/$target.log")"
        sed -n "s/.*Test unit written to /    the input is /p" "$folder/$target.log"
        echo "    the whole report is $folder/$target.log"
    fi
done
exit "$wrong"
