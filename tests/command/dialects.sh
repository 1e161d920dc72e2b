#!/bin/bash
# dialects.sh - tests the small shaders of tests/shaders/dialects.txt: each is drawn or refused, as its heading says. A
# shader that is drawn is also exported with --print-shader=shadertoy: either Shadertoy would accept the exported file,
# which gives the same colour here, or the export is refused in the words of the heading. At the end, a program without
# the folder common/dialects/ is tried.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh
. tests/lib/shadertoy.sh

open_scratch
unset DISPLAY WAYLAND_DISPLAY
program=$BUILD/01_normal_colouring

# Split the file into one file per shader, and list the expected result of each.
awk -v folder="${scratch:?}" '
    /^=== / { name = substr($2, 1, length($2) - 1); kind = substr($2, length($2)); sub(/^=== [^ ]* ?/, "")
              print name, kind, $0 > (folder "/list"); next }
    name != "" { print > (folder "/" name) }' tests/shaders/dialects.txt

# probe FILE: renders the shader, and sets $said to the messages, without the heading of the table, and $colour to the
# colour of the probed pixel.
probe() {
    said=$("$program" -f "$1" -s 48x27 -t 0.25 --probe 24,13 2>&1) || return
    said=${said#step,t,distance,x,y,z$'\n'}
    colour=$(sed -n 's/^# no march.*; colour: \([0-9]*\), \([0-9]*\), \([0-9]*\)$/\1,\2,\3/p' <<<"$said")
}

near() { # COLOUR COLOUR: true if no channel differs by more than 1
    awk -v one="$1" -v other="$2" 'BEGIN {
        split(one, a, ","); if (split(other, b, ",") != 3) exit 1
        for (i = 1; i <= 3; i++) if (a[i] - b[i] > 1 || b[i] - a[i] > 1) exit 1 }'
}

# export_of FILE COLOUR WORDS: true if the exported file is drawn in this colour or, if WORDS is not empty, the export
# is refused in these words. The exports of whole_* are not validated, because they have an integer where a float is
# needed, which Shadertoy does not accept (docs/using.md).
export_of() {
    local exported=$scratch/exported.frag
    if ! "$program" -f "$1" --print-shader=shadertoy >"$exported" 2>"$scratch/err"; then
        [ -n "$3" ] && [ ! -s "$exported" ] && [ "$(grep -c '' "$scratch/err")" = 1 ] && grep -qF "$3" "$scratch/err"
        return
    fi
    ! grep -qE '^ *(layout *\([^)]*\) *)?uniform ' "$exported" || return # Shadertoy would not set such a uniform
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
            ok "$name is drawn, and its silent channels are reported"
        else not_ok "$name is drawn" "status $status: $(tr '\n' ' ' <<<"$said")"; fi ;;
    \!) if [ "$status" = 1 ] && { [ "$lines" = 1 ] || [[ $right = *:[0-9]*:* ]]; } && grep -qF "$right" <<<"$said"; then
            ok "$name is refused"
        else not_ok "$name is refused" "status $status: $(tr '\n' ' ' <<<"$said")"; fi ;;
    \?) if [ "$status" = 0 ] && [ "$lines" = 2 ] && grep -qF "$right" <<<"$said"; then
            ok "$name is drawn with a warning"
        else not_ok "$name is drawn with a warning" "status $status: $(tr '\n' ' ' <<<"$said")"; fi ;;
    esac
    if [ "$kind" = : ] && [ "$status" = 0 ]; then
        if export_of "$file" "$right" "$words"; then
            ok "$name is exported${words:+, or its export is refused}"
        else
            not_ok "$name is exported${words:+, or its export is refused}" "$(cat "$scratch/err") $said"
        fi
    fi
done <"$scratch/list"

# A program without the folder common/dialects/ draws the same picture of a course shader, and refuses any other file.
shot=(-s 64x36 -o)
check 'without common/dialects/, a chapter is drawn' "$BUILD/tests/own" -f chapters/01_normal_colouring.frag "${shot[@]}" "$scratch/own.png"
"$program" "${shot[@]}" "$scratch/whole.png"
check 'the two pictures are the same' cmp "$scratch/own.png" "$scratch/whole.png"
echo 'void mainImage(out vec4 c, vec2 p) { c = vec4(1.0); }' >"$scratch/toy.frag"
said=$("$BUILD/tests/own" -f "$scratch/toy.frag" "${shot[@]}" "$scratch/toy.png" 2>&1)
check 'a file of another tool is refused there' [ "$? $said" = "1 $scratch/toy.frag: was written for another tool: this program runs only shaders that begin with #include \"main.glsl\"" ]
plan
