#!/bin/bash
# dialects.sh - the small shaders of tests/shaders/dialects.txt: each is drawn or refused as its heading says, and a
# drawn one is drawn again from the file that --print-shader=shadertoy writes, which Shadertoy would accept, or its
# export is refused in the words of its heading.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh
. tests/lib/shadertoy.sh

open_scratch
unset DISPLAY WAYLAND_DISPLAY
program=$BUILD/01_normal_colouring

# Cut the file into one for each shader, with a list of the expected result of each.
awk -v folder="${scratch:?}" '
    /^=== / { name = substr($2, 1, length($2) - 1); kind = substr($2, length($2)); sub(/^=== [^ ]* ?/, "")
              print name, kind, $0 > (folder "/list"); next }
    name != "" { print > (folder "/" name) }' tests/shaders/dialects.txt

# probe FILE: its messages go to $said, without the heading of the table, and its colour to $colour.
probe() {
    said=$("$program" -f "$1" -s 48x27 -t 0.25 --probe 24,13 2>&1) || return
    said=${said#step,t,distance,x,y,z$'\n'}
    colour=$(sed -n 's/^# no march.*; colour: \([0-9]*\), \([0-9]*\), \([0-9]*\)$/\1,\2,\3/p' <<<"$said")
}

near() { # COLOUR COLOUR: they differ by 1 at most
    awk -v one="$1" -v other="$2" 'BEGIN {
        split(one, a, ","); if (split(other, b, ",") != 3) exit 1
        for (i = 1; i <= 3; i++) if (a[i] - b[i] > 1 || b[i] - a[i] > 1) exit 1 }'
}

# export_of FILE COLOUR WORDS: its export is drawn in this colour, or refused in these words. Shadertoy takes no integer
# for a float (docs/using.md), as in whole_*.
export_of() {
    local exported=$scratch/exported.frag
    if ! "$program" -f "$1" --print-shader=shadertoy >"$exported" 2>"$scratch/err"; then
        [ -n "$3" ] && [ ! -s "$exported" ] && [ "$(grep -c '' "$scratch/err")" = 1 ] && grep -qF "$3" "$scratch/err"
        return
    fi
    ! grep -qE '^ *(layout *\([^)]*\) *)?uniform ' "$exported" || return # nothing would set it
    [ -z "$3" ] && { [[ $1 = */whole_* ]] || valid "$exported"; } && probe "$exported" && near "$colour" "$2"
}

while read -r name kind right; do
    file=$scratch/$name words=
    case $kind$right in :*' ! '*) words=${right#* ! } right=${right%% ! *} ;; esac
    probe "$file"
    status=$?
    lines=$(grep -c '' <<<"$said")
    case $kind in
    :) if [ "$status" = 0 ] && near "$colour" "$right" && [ "$lines" = 1 ]; then
            ok "$name is drawn"
        elif [ "$status" = 0 ] && near "$colour" "$right" && [[ $name = *silent* ]] && [ "$lines" -gt 1 ]; then
            ok "$name is drawn, and reports the channels that are silent"
        else not_ok "$name is drawn" "status $status: $(tr '\n' ' ' <<<"$said")"; fi ;;
    \!) if [ "$status" = 1 ] && { [ "$lines" = 1 ] || [[ $right = *:[0-9]*:* ]]; } && grep -qF "$right" <<<"$said"; then
            ok "$name is refused"
        else not_ok "$name is refused" "status $status: $(tr '\n' ' ' <<<"$said")"; fi ;;
    \?) if [ "$status" = 0 ] && [ "$lines" = 2 ] && grep -qF "$right" <<<"$said"; then
            ok "$name is drawn, and says so"
        else not_ok "$name is drawn, and says so" "status $status: $(tr '\n' ' ' <<<"$said")"; fi ;;
    esac
    if [ "$kind" = : ] && [ "$status" = 0 ]; then
        if export_of "$file" "$right" "$words"; then
            ok "$name is exported${words:+, or refused}"
        else
            not_ok "$name is exported${words:+, or refused}" "$(cat "$scratch/err") $said"
        fi
    fi
done <"$scratch/list"
plan
