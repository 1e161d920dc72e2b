# shellcheck shell=bash
# tap.sh - functions that the shell suites share. A suite sources this file from the project's root:
#
#   . tests/lib/tap.sh
#   open_scratch
#   check "name" COMMAND...     prints one TAP line: ok if the command succeeds
#   plan                        prints the last line; fails if a line was 'not ok'
#
# The file sets BUILD, scratch (a folder that is removed at the end) and the environment of the
# programs: software rendering, and sanitizers with readable reports.

export LC_ALL=C
BUILD=${BUILD:-build}
root=$PWD # the project's root, for this file and for the suites that source it
export root
scratch=
display_server=
tap_count=0
tap_failed=0

export LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe
# Status 99 distinguishes an error found by a sanitizer from an error that the program reports with status 1.
export ASAN_OPTIONS="${ASAN_OPTIONS:-intercept_tls_get_addr=0}:exitcode=99"
export UBSAN_OPTIONS="${UBSAN_OPTIONS:+$UBSAN_OPTIONS:}exitcode=99:print_stacktrace=1"
export LSAN_OPTIONS="${LSAN_OPTIONS:-suppressions=$root/tests/lib/lsan.supp:print_suppressions=0}"

open_scratch() {
    scratch=$(mktemp -d "${TMPDIR:-/tmp}/ray-test.XXXXXX") || exit 1
    trap close_scratch EXIT
    trap 'exit 1' HUP INT TERM
}

close_scratch() {
    close_display
    [ -n "$scratch" ] && chmod -R u+rwx "$scratch" && rm -rf "$scratch"
}

# ok NAME, not_ok NAME [REASON], skip NAME REASON: each prints one TAP line.
ok() {
    tap_count=$((tap_count + 1))
    printf 'ok %d - %s\n' "$tap_count" "$1"
}

not_ok() {
    tap_count=$((tap_count + 1))
    tap_failed=$((tap_failed + 1))
    printf 'not ok %d - %s%s\n' "$tap_count" "$1" "${2:+: $2}"
}

skip() {
    tap_count=$((tap_count + 1))
    printf 'ok %d - %s # SKIP %s\n' "$tap_count" "$1" "$2"
}

# check NAME COMMAND...: the test passes if the command succeeds.
check() {
    local name=$1
    shift
    if "$@"; then
        ok "$name"
    else
        not_ok "$name"
        return 1
    fi
}

# within_kib KIB COMMAND...: runs a command that can write no file beyond this many KiB, as if the disk were full.
# SIGXFSZ is ignored, because it would end the program before the program prints its message.
within_kib() {
    (trap '' XFSZ && ulimit -f "$1" && shift && exec "$@")
}

plan() {
    printf '1..%d\n' "$tap_count"
    [ "$tap_failed" = 0 ]
}

# Start a display for this suite, with a free number, and set DISPLAY. Without -noreset, the server would reset between
# two clients and refuse some of them.
open_display() {
    command -v Xvfb >/dev/null || return 1
    mkfifo "$scratch/display" || return 1
    Xvfb -displayfd 3 -screen 0 1280x1024x24 -noreset -nolisten tcp \
        3>"$scratch/display" >/dev/null 2>&1 &
    display_server=$!
    local number=
    read -r number <"$scratch/display"
    [ -n "$number" ] || return 1
    export DISPLAY=":$number"
    unset WAYLAND_DISPLAY
}

close_display() {
    [ -n "$display_server" ] || return 0
    kill "$display_server" 2>/dev/null
    wait "$display_server" 2>/dev/null
    display_server=
}
