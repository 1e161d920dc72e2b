# shellcheck shell=bash disable=SC2034,SC2154
# refuse.sh - judges runs that must fail. A suite sources this file after tap.sh:
#
#   open_out                               makes the folder for pictures, $out
#   refuse NAME STATUS PATTERN COMMAND...  prints one TAP line

windows() { [ "${SYSTEM-}" = Windows ]; }

open_out() {
    out=$scratch/out
    mkdir "$out" && fill
}

# The output folder contains one old file, which must not change, and nothing else.
fill() {
    find "$out" -mindepth 1 -delete
    printf 'an old file' >"$out/old.png"
}

# The names in the output folder, on one line; old.png is listed only if it is unchanged.
listing() {
    (cd "$out" && [ "$(cat old.png)" = 'an old file' ] && find . -mindepth 1 | sort | tr '\n' ' ')
}

# run COMMAND...: sets status, error (the messages) and said (the number of lines in them).
run() {
    "$@" >"$scratch/stdout" 2>"$scratch/stderr"
    status=$?
    error=$(cat "$scratch/stderr")
    said=$(grep -c '' "$scratch/stderr")
}

# Control characters other than tabs and line feeds; in UTF-8, also those from U+0080 to U+009F, line separators, and
# characters that reverse the order of others.
unprintable=$'[\x01-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]|\xe2\x80[\xa8-\xae]|\xe2\x81[\xa6-\xa9]'

# harmless FILE: true if a terminal shows these bytes and does nothing else.
harmless() { ! grep -a -q -E -e "$unprintable" "$1" && iconv -f UTF-8 -t UTF-8 "$1" >/dev/null 2>&1; }

# Print why the last run is not a proper failure, or nothing if it is.
complaint() { # STATUS PATTERN LINES
    [ "$status" = "$1" ] || echo "status $status, not $1;"
    [ "$3" = many ] || [ "$said" = 1 ] || echo "$said lines on standard error;"
    [ "$3" = many ] || [ "${#error}" -lt 2000 ] || echo "a message of ${#error} bytes;"
    [ "$said" -ge 1 ] || echo 'nothing on standard error;'
    grep -q -i -e "$2" "$scratch/stderr" || echo "no '$2' in the message;"
    harmless "$scratch/stderr" || echo 'the message is not harmless UTF-8;'
    if grep -q 'Sanitizer\|runtime error' "$scratch/stderr"; then echo 'a sanitizer printed a message;'; fi
    [ -s "$scratch/stdout" ] && echo 'text on standard output;'
    [ "$(listing)" = "$expected_listing" ] || echo "the folder contains $(listing);"
}

# refuse NAME STATUS PATTERN COMMAND...: the command must fail with this status and one line that matches the pattern.
# refuse_at_length allows any number of lines, for errors in a shader. NAME is the subject of 'is reported'.
refuse() { judge one "$@"; }
refuse_at_length() { judge many "$@"; }
expected_listing='./old.png '
judge() {
    local lines=$1 name=$2 wanted=$3 pattern=$4 why
    shift 4
    run "$@"
    why=$(complaint "$wanted" "$pattern" "$lines")
    if [ -z "$why" ]; then ok "$name is reported"; else not_ok "$name is reported" "$(echo "$why" "$error" | tr '\n' ' ' | cut -c1-2000)"; fi
    [ -z "$why" ] || [ -n "${keep-}" ] || fill
}
