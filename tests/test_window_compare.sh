#!/bin/bash
# shellcheck disable=SC2086 # options are words
# test_window_compare.sh - two pictures beside each other in a window: the divider is dragged, both follow
# the camera, the keys and their files; a press elsewhere looks around as before.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/support.sh
. tests/support_window.sh

# The same by the command line; the divider is where the pointer was let go.
pair='--compare --set normalStep=0.4'
drawn_with() { # OPTION...: the screenshot is what the command line makes of it
    shoot_as now && "$BUILD/$chapter" $still "$@" -o "$scratch/wanted.png" >/dev/null && matches wanted now
}

start $chapter $still $pair
key h
middle() { drawn_with $pair; }
check 'a screenshot has both pictures, divider and labels, as a written one' middle
drag_to() { # FROM TO: from one column to another, near the bottom
    xdotool mousemove --window "$window" "$1" 150 mousedown 1 mousemove --window "$window" "$(($1 + ($2 - $1) / 2))" 150 \
        mousemove --window "$window" "$2" 150 mouseup 1
}
dragged() { drag_to 160 96 && drawn_with $pair --divider 0.3; }
check 'the divider is dragged, and the camera stays' dragged
to_the_edge() { drag_to 96 319 && drag_to 318 64 && drawn_with $pair --divider 0.2; }
check 'to the edge and back' to_the_edge
beside() { drag_to 100 160 && shoot_as turned && differ now turned && key shift+r && shoot_as back && same now back; }
check 'a drag beside it turns both pictures, and Shift+R brings them back' beside
# A grip in the middle, which no written picture has.
grip() { look screen && [ "$(convert "$scratch/screen.png" -crop 3x12+63+94 +repage -format '%[fx:mean > 0.8]' info:)" = 1 ]; }
check 'the window shows where to take it' eventually grip
views() { key 2 && shows ' - normals - ' && drawn_with $pair --divider 0.2 -v normals && key 1 && shows ' - picture - '; }
check 'a view is that of both' views
follows() {
    key Right && shows 'focalLength = 2.' && value=$(title | sed 's/.*focalLength = //; s/ .*//') &&
        drawn_with --set focalLength="$value" $pair --divider 0.2 && key Home
}
check 'both follow a parameter that is changed' follows
own() { key Down Right && shows "normalStep (left) = 0.002" && drawn_with --set normalStep=0.002 $pair --divider 0.2 && key Home; }
check 'but for the second in its own' own
# The panel's first row, below the title, is that of focalLength.
longer() { value=$(title | sed -n 's/.*focalLength = \([0-9.]*\).*/\1/p') && awk -v v="$value" 'BEGIN { exit !(v > 3) }'; }
# The title shows values on the way too: the last one stands there once a screenshot is taken.
slides() {
    key h && xdotool mousemove --window "$window" 60 50 mousedown 1 mousemove --window "$window" 70 50 mousemove --window "$window" 90 50 mouseup 1 &&
        eventually longer && key h && shoot_as slid && longer && drawn_with --set focalLength="$value" $pair --divider 0.2 && key Delete && shows 'focalLength = 2'
}
check 'a value that is dragged in the panel is that of both too' slides
# The second's own value has a row of its own, below the first's: that of focalLength is at 50 units, its at 70.
untitled() { ! titled "$1"; }
right_is() { drawn_with --compare --set normalStep="$1" --divider 0.2; } # the first has kept its own
of_second() {
    key Down && shows 'normalStep (left) = ' && key Down && shows 'normalStep (right) = 0.4' && key Left && shows 'normalStep (right) = 0.2' && right_is 0.2
}
check "the second's own value is chosen and changed by keys" of_second
right_value() { title | sed -n 's/.*(right) = \([0-9.e-]*\).*/\1/p'; }
slides_right() {
    look folded && key h && eventually far_off folded 20000 &&
        xdotool mousemove --window "$window" 60 70 mousedown 1 mousemove --window "$window" 50 70 mousemove --window "$window" 40 70 mouseup 1 &&
        eventually untitled '(right) = 0.2' && shows '(right) = 0.0' && shoot_as slid && right_is "$(right_value)"
}
check 'it is dragged in the panel' slides_right
typed() {
    look before && xdotool click --repeat 2 --delay 60 1 && eventually far_off before 500 && xdotool type --delay 40 0.25 && key Return &&
        shows '(right) = 0.25' && right_is 0.25
}
check 'it is typed there' typed
wheels() { xdotool click 5 && shows '(right) = 0.125' && right_is 0.125; }
check 'the wheel changes it' wheels
resets_right() { key Delete && shows '(right) = 0.001' && right_is 0.001 && key h && key Up Up && shows 'focalLength'; }
check 'Delete brings it back, and the arrows go on to the rest' resets_right
other_side() {
    xdotool mousemove --window "$window" 170 100 click 1 && eventually says out 'ray of pixel 170,99' &&
        sed -n '/^ray of pixel 170,99/,/^# /p' "$scratch/run/out" | tail -n +2 >"$scratch/told" &&
        "$BUILD/$chapter" $still --set normalStep=0.001 --probe 170,99 >"$scratch/probed" && cmp "$scratch/told" "$scratch/probed"
}
check 'a click asks the side where it is' other_side
check 'Backspace closes it' backspace
check 'nothing was reported' [ ! -s "$scratch/run/err" ]

# ---- Two files, each loaded again ----

printf '%s\n' "$good" >"$scratch/first.frag"
printf '%s\n' "${good/const vec3 SKY = vec3(/const vec3 SKY = 0.5 * vec3(}" >"$scratch/second.frag"
start $chapter $still --shader "$scratch/first.frag" --compare "$scratch/second.frag"
key h
files() { drawn_with --shader "$scratch/first.frag" --compare "$scratch/second.frag"; }
check 'two files stand beside each other' files
rewrite() { # FILE FACTOR
    printf '%s\n' "${good/const vec3 SKY = vec3(/const vec3 SKY = $2 * vec3(}" >"$scratch/new.frag" && mv "$scratch/new.frag" "$scratch/$1.frag"
}
loads_are() { [ "$(grep -c "$1.frag: loaded again" "$scratch/run/out")" = "$2" ]; }
second_saved() { rewrite second 0.2 && eventually loads_are second 1 && files; }
check 'the second is loaded again when it is saved' second_saved
first_saved() { rewrite first 0.8 && eventually loads_are first 2 && files; }
check 'so is the first' first_saved
broken() {
    shoot_as kept && echo 'float wrong() { return undeclared; }' >>"$scratch/second.frag" && shows 'error: see terminal' &&
        grep -q 'second.frag:[0-9]*.*undeclared' "$scratch/run/err" && shoot_as still && same kept still
}
check 'a second that is broken keeps its last good picture and says so' broken
recovers() { rewrite second 0.4 && eventually loads_are second 3 && files && [[ $(title) != *error* ]]; }
check 'and recovers' recovers
check 'Backspace closes it' backspace

# ---- A parameter that only the second has ----

printf '%s\n' "${good/const vec3 SKY = /uniform float glow; // 0.25 in [0, 1]: light of the sky
#define SKY glow * }" | sed 's/^\(#define SKY.*\);$/\1/' >"$scratch/glowing.frag"
start $chapter $still --compare "$scratch/glowing.frag" --divider 0.2
key h
alone() { key Up && shows 'glow (right) = 0.25' && key Right && shows 'glow (right) = 0.26' && drawn_with --compare "$scratch/glowing.frag" --set glow=0.26 --divider 0.2; }
check 'what the second alone has is changed by keys' alone
check 'Backspace closes it' backspace

# ---- While it is coarse ----

# Each side waits in a loop: the small picture has its divider where the large one has it.
slow() { # FILE COLOUR
    cat >"$scratch/$1.frag" <<GLSL
void mainImage(out vec4 c, vec2 p)
{
    float sum = 0.0;
    for (int i = 0; i < 2500; i++)
        sum += sin(sum + float(i) + p.x);
    c = vec4($2, 1.0) + 1e-9 * sum;
}
GLSL
}
slow left 'vec3(1.0, 0.0, 0.0)'
slow right 'vec3(0.0, fract(iTime), 1.0)'
start $chapter -s 480x300 --shader "$scratch/left.frag" --compare "$scratch/right.frag" --divider 0.4
key h
sides() {
    look screen && [ "$(convert "$scratch/screen.png" -crop 180x200+4+40 +repage -format '%[fx:mean.r > 0.99 && mean.b < 0.01]' info:)" = 1 ] &&
        [ "$(convert "$scratch/screen.png" -crop 270x200+204+40 +repage -format '%[fx:mean.b > 0.99 && mean.r < 0.01]' info:)" = 1 ]
}
check 'a coarse picture has its divider in the same place' eventually sides
moves_on() { look before && eventually far_off before 300000; }
check 'and moves on where one of the two does' moves_on
check 'Backspace closes it' backspace

close_window
plan
