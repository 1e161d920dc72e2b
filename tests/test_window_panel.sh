#!/bin/bash
# shellcheck disable=SC2086 # options are words
# test_window_panel.sh - a colour's picker, the panel's keys and typed numbers, with real events, also on a French
# keyboard; the title bar tells what they changed.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/support.sh
. tests/support_window.sh

# At scale 1 the rows begin 46 pixels from the top, 12 each; under the chosen one stand range and unit, of a vector its
# parts too. The picture is the colour itself.
cat >"$mine" <<'GLSL'
uniform vec3  tint; // 0.5 in [0, 1], linear RGB: the colour of all
uniform float size; // 5 in [0, 10], units: nothing

#include "main.glsl"
#include "camera.glsl"
#include "lighting.glsl"

Ray pixelRay(vec2 screen) { return perspectiveRay(screen); }
float sceneDistance(vec3 p) { return size; }
vec3 rayColour(Ray ray) { return encodeSRGB(tint); }
GLSL

at() { xdotool mousemove --window "$window" $(($1 * scale)) $(($2 * scale)); } # in units of the overlay
click() { at "$1" "$2" && xdotool click "${3:-1}"; }
double() { at "$1" "$2" && xdotool click --repeat 2 --delay 60 1; }
value() { title | sed -n 's/.* = \([^ ]*\).*/\1/p'; }
is_like() { # PATTERN
    # shellcheck disable=SC2053 # a pattern
    [[ $(value) == $1 ]]
}
# What the window shows below the line of its figures is that of a kept picture, or is not.
below() { off "$1" "960x$((540 - 44 * scale))+0+$((44 * scale))"; }
other() { [ "$(below "$1")" -gt 500 ]; }
# The same right of the panel, 196 units wide with its margin, whose last line tells the resolution.
beside() { off "$1" "$((960 - 197 * scale))x$((540 - 44 * scale))+$((197 * scale))+$((44 * scale))"; }
picks() { [ "$(beside "$1")" -gt 500 ]; }
again() { [ "$(beside "$1")" = 0 ]; }

# types X Y TEXT: into the field that a double click opens; it is there once it is seen.
types() { at "$1" "$2" && look before && double "$1" "$2" && eventually other before && xdotool type --delay 40 "$3" && key Return; }

# ---- A colour ----

for scale in 1 2; do
    start $chapter --size 960x540 --shader "$mine" --overlay=$scale
    opens_it() { look plain && click 97 50 && at 400 250 && eventually picks plain && shows 'tint = 0.5,0.5,0.5'; }
    check "scale $scale: a click on a colour's own colour opens its picker" opens_it
    # Where it is, in units: what has changed right of the panel.
    find_it() {
        look with && convert "$scratch/plain.png" "$scratch/with.png" -compose difference -composite -crop +$((197 * scale))+$((44 * scale)) \
            -threshold 1% -trim -format '%[fx:w] %[fx:h] %[fx:page.x] %[fx:page.y]' info:
    }
    read -r width height left top < <(find_it)
    placed() {
        [ "$width $height" = "$((104 * scale)) $((86 * scale))" ] && return
        echo "# $width x $height at $left, $top"
        return 1
    }
    check "scale $scale: it stands where it covers no row of its colour, in its whole size" placed
    left=$((left / scale)) top=$((top / scale))
    place() { at $((left + $1)) $((top + $2)); } # units from its corner
    white() { place 7 7 && xdotool click 1 && shows 'tint = 1,1,1'; }
    check "scale $scale: its corner is white" white
    pure() { place 40 40 && xdotool mousedown 1 && place 60 30 && place 200 -40 && xdotool mouseup 1 && eventually is_like '1,0*,0*'; }
    check "scale $scale: a drag beyond its square ends in the pure hue" pure
    turns() { place 91 31 && xdotool click 1 && eventually is_like '0*,0*,1'; }
    check "scale $scale: a place of its bar is another hue" turns
    pixel() { look screen && convert "$scratch/screen.png" -format "%[fx:p{$(((left + $1) * scale)),$(((top + $2) * scale))}.b>0.9&&p{$(((left + $1) * scale)),$(((top + $2) * scale))}.g<0.3]" info:; }
    same_hue() { [ "$(pixel 74 12)$(pixel 200 100)" = 11 ]; }
    check "scale $scale: its square and the picture show that hue" eventually same_hue
    closes() { look open && key Escape && eventually picks open && [[ $(title) != *paused* ]]; }
    check "scale $scale: Escape closes it and pauses nothing" closes
    typed() { types 130 50 0.25,0.5,0.75 && shows 'tint = 0.25,0.5,0.75'; }
    check "scale $scale: its numbers are typed as before" typed
    # A screenshot is written once the pointer that went away is seen to be away.
    outside() { at 400 250 && shoot && look off && click 97 50 && at 400 250 && eventually picks off && xdotool click 1 && eventually again off && ! says out 'ray of pixel'; }
    check "scale $scale: a click elsewhere closes it, and chooses no ray" outside
    check "scale $scale: Backspace closes the window" backspace
done

# ---- The panel's place ----

scale=1
start $chapter --size 960x540 --shader "$mine" --overlay=$scale
# Bright from the panel on: what stands at the left, and at the right, of what the window shows.
darker() { # WxH+X+Y: there is a panel
    look screen && [ "$(convert "$scratch/screen.png" -crop "$1" -format '%[fx:mean<0.5]' info:)" = 1 ]
}
bare() { look screen && [ "$(convert "$scratch/screen.png" -crop "$1" -format '%[fx:mean>0.7]' info:)" = 1 ]; }
left=100x30+20+100 right=100x30+840+100
check 'the panel stands at the left' eventually darker $left
moves() { key o && eventually darker $right && eventually bare $left; }
check 'O moves it to the right' moves
chooses() { at 860 110 && xdotool click 1 && shows 'size = 5'; }
check 'where it is touched as before' chooses
rolls() { key t && eventually bare $right && eventually darker 100x8+840+12; }
check 'T folds it to its title' rolls
unfolds() { key t && eventually darker $right; }
check 'and unfolds it' unfolds
moves_back() { key o && eventually darker $left && eventually bare $right; }
check 'O moves it back' moves_back
check 'Backspace closes the window' backspace

# ---- Numbers on a French keyboard ----

# By key codes: 10 to 19 are the row of digits, 58 is M, whose place has the comma, 59 has the semicolon and, with
# Shift, the point; 36 is Enter.
if ! setxkbmap fr 2>/dev/null; then
    skip 'a number on a French keyboard' 'no setxkbmap on this machine'
else
    start $chapter --size 960x540 --shader "$mine" --overlay=$scale
    check 'AZERTY: the row is there' eval 'click 60 110 && shows "size = 5"'
    digits() { rest && field86 && key shift+16 58 shift+11 shift+14 && key 36 && shows 'size = 7.25'; }
    # The chosen row of one number, below the colour's, whose parts are folded then.
    rest() { at 400 250 && shoot && look before; }
    field86() { double 100 62 && eventually other before; }
    check 'AZERTY: digits with Shift and the comma are a number' digits
    point() { rest && field86 && key shift+12 shift+59 shift+14 36 && shows 'size = 3.5'; }
    check 'AZERTY: so they are with the point' point
    accents() { rest && field86 && look before && key 11 && eventually other before && key 16 18 shift+13 && key 36 && shows 'size = 4' && [[ $(title) != *paused* ]]; }
    check 'AZERTY: accents are left out, and said to be none' accents
    minus() { rest && field86 && key 15 shift+12 36 && eventually says err 'size=-3: out of range' && key Escape; }
    check 'AZERTY: the minus is that of the 6' minus
    leaves() { rest && field86 && key shift+13 && at 500 300 && xdotool click 1 && eventually says out 'ray of pixel 500,239' && key t && eventually bare 100x30+20+100 && titled 'size = 4'; }
    check 'AZERTY: a press in the picture leaves the field, and keys are keys again' leaves
    check 'AZERTY: Backspace closes the window' backspace
    setxkbmap us
fi

close_window
plan
