#!/bin/bash
# test_window_mouse.sh - the panel by mouse, with real events: the title bar tells what they changed.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/support.sh
. tests/support_window.sh

# At scale 1 the rows begin 46 pixels from the top, 12 each; under the chosen one stand range and unit.
{
    printf '%s\n' 'uniform float size; // 5 in [0, 10], units: how large the thing is' \
        'uniform float fine; // 0.01 in [0.0001, 1] step *10, units: spans decades' \
        'uniform bool lit; // true: whether there is light' \
        'uniform vec3 tint; // 0.5 in [0, 1], linear RGB: the colour of the thing'
    echo "$good"
} >"$mine"
if ! start $chapter --size 640x360 --shader "$mine"; then
    not_ok 'a window opens'
    close_window
    plan
    exit
fi
at() { xdotool mousemove --window "$window" "$1" "$2"; }
press() { at "$1" "$2" && xdotool click "${3:-1}"; }
value() { title | sed -n 's/.* = \([^ ]*\).*/\1/p'; }
more_than() { awk -v a="$(value)" -v b="$1" 'BEGIN { exit !(a > b) }'; }
less_than() { awk -v a="$(value)" -v b="$1" 'BEGIN { exit !(a < b) }'; }

chosen_is() { titled " - $1 = "; }
# What the hand did before is done and shown: keys come after it, and the title follows them.
settled() { # NAME NEXT: of the chosen parameter and of the one below
    key Down && eventually chosen_is "$2" && key Up && eventually chosen_is "$1"
}
# A field is dark to the end of its row; its own press begins no double click.
field() { [ "$(import -window "$window" -crop 8x6+150+49 -colorspace gray -format '%[fx:round(255*mean)]' info:)" -lt 26 ]; }
no_field() { ! field; }
opens_field() { # a busy machine may see the two presses too far apart: then they are two
    local tries
    at 60 50
    for tries in 1 2 3 4 5; do
        xdotool click --repeat 2 --delay 60 1 && soon field && return
        echo "# no field after double click $tries"
        press 60 20
    done
    return 1
}

check 'the chapter begins' shows 'size = 5'
drags() { at 60 50 && xdotool mousedown 1 && at 80 50 && at 120 50 && xdotool mouseup 1 && eventually more_than 5.5; }
check 'a drag in a row changes its value' drags
back() { xdotool mousedown 1 && at 0 50 && at 0 50 && at 60 50 && xdotool mouseup 1 && eventually less_than 6; }
check 'and back, as far as the hand goes' back
check 'a right click resets it' eval 'press 60 50 3 && shows "size = 5"'
same_eye() {
    "$BUILD/$chapter" --size 640x360 --shader "$mine" --output "$scratch/wanted.png" >/dev/null && shoot_as after && matches wanted after
}
check 'no drag in the panel turned the eye' same_eye
wheels() { at 60 50 && xdotool click 4 && shows 'size = 5.1' && xdotool click 5 && shows 'size = 5'; }
check 'the wheel over a row changes it' wheels
types() { opens_field && xdotool type --delay 40 7.25 && key Return && shows 'size = 7.25' && eventually no_field; }
check 'a double click, a number and Enter set it' types
leaves() { # the wheel tells that nothing is paused
    opens_field && xdotool type --delay 40 3 && key Escape && eventually no_field && xdotool click 4 && shows 'size = 7.35' &&
        [[ $(title) != *paused* ]] && xdotool click 5 && shows 'size = 7.25'
}
check 'Escape leaves the field and pauses nothing' leaves
refuses() {
    opens_field && xdotool type --delay 40 99 && key Return && eventually says err 'out of range' && shows 'size = 7.25' &&
        key Escape && eventually no_field
}
check 'what is out of range is refused in one line' refuses
chooses() { press 60 74 && shows 'fine = 0.01'; }
check 'a click chooses a row' chooses
decades() { at 60 62 && xdotool mousedown 1 && at 70 62 && at 100 62 && xdotool mouseup 1 && eventually more_than 0.015; }
check 'where the step multiplies a drag goes by decades' decades
switches() { press 60 86 && shows 'lit = false' && press 60 20 && press 60 74 && shows 'lit = true'; }
check 'a click switches' switches
green() { [[ $(value) == 0.5,0.*,0.5 && $(value) != 0.5,0.5,0.5 ]]; }
part() {
    press 60 98 && shows 'tint = 0.5,0.5,0.5' && at 60 110 && xdotool mousedown 1 && at 80 110 && at 100 110 && xdotool mouseup 1 &&
        eventually green
}
check 'a part of a colour is dragged alone' part
helps() { at 400 300 && settled tint focalLength && look bare && at 60 50 && eventually far_off bare 500; }
check 'a pointer that rests is helped' helps
folds() { # where the mark is, the width of the panel says
    local x
    at 400 300 && settled tint focalLength && look open
    for x in 250 240 230 220 210 200 190 180 170 160 150; do
        press "$x" 20 && at 400 300 && settled tint focalLength && far_off open 20000 && return
    done
    return 1
}
check 'a click on the mark of the title folds the panel' folds
check 'Backspace closes it' backspace
check 'nothing else was reported' [ "$(wc -l <"$scratch/run/err")" = 1 ]
close_window
plan
