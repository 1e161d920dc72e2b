#!/bin/bash
# window.sh - tests one window on a real X server, with real events, which tests/window/*.c cannot do, because they
# simulate the user and GLFW's clock. No result depends on a clock: every wait is for an event, and the first wait that
# fails ends the suite.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh
. tests/lib/window.sh

save "$good"
# shellcheck disable=SC2086 # the options are separate words
if ! start $chapter $still --shader "$mine"; then
    sed 's/^/# /' "$scratch/run/err"
    echo "# window ${window:-none}; all windows:"
    wmctrl -lp 2>&1 | sed 's/^/# /'
    not_ok 'a window opens'
    close_window
    plan
    exit
fi
ok 'a window opens'
check 'the title bar names the file' titled 'mine.frag - '
first() { key h && shoot_as first && render expected && matches expected first && eventually shown first; }
check 'the window and its screenshot show the picture that -o writes with the same options' first
views() { key 2 && shows ' - normals - ' && render view -v normals && eventually shown view && key 1 && shows ' - picture - '; }
check 'key 2 shows the normals, and key 1 the picture' views
drag() {
    xdotool mousemove --window "$window" 100 100 mousedown 1 mousemove_relative 60 0 \
        mousemove_relative -- 0 -40 mouseup 1 &&
        shoot_as dragged && render wanted -c 1.65,1.6,3.4,-17,-17.5 && matches wanted dragged
}
check 'dragging right and up turns the camera right and up, by 0.15 degrees per pixel' drag
wheel() { xdotool mousemove --window "$window" 100 100 click 4 && shows 'focalLength = 2.2' && xdotool click 5 && shows 'focalLength = 2'; }
check 'the wheel zooms in and out' wheel
# While the system moves the captured pointer to the middle, the first movement can get lost.
swings() { xdotool mousemove_relative 30 0 && shoot_as captured && differ before captured; }
captured() { key m && xdotool mousemove_relative 4 0 && shoot_as before && eventually swings; }
check 'M captures the pointer, which then turns the camera without a button' captured
freed() { key m && shoot_as freed && xdotool mousemove_relative 20 20 && shoot_as still && same freed still; }
check 'a second press of M frees the pointer' freed
check 'W moves the camera' walk w
rests() { shoot_as rest && same there rest; }
check 'releasing W stops the camera' rests
# Show the desktop while W is down. The window then loses the focus and is not told that the key is released.
forgets() {
    xdotool keydown w sleep 0.1 && wmctrl -k on && eventually unfocused && xdotool keyup w && wmctrl -k off &&
        xdotool windowactivate "$window" && eventually focused && shoot_as a && shoot_as b && same a b
}
check 'losing the focus releases the keys that are held' forgets
returns() { key shift+r && shoot_as again && same first again; }
check 'Shift+R resets the camera' returns

# ---- Size ----

size_is() { [ "$(xdotool getwindowgeometry "$window" | awk '/Geometry/ { print $2 }')" = "$1" ]; }
rectangle() { xdotool getwindowgeometry "$window" | grep -E 'Position|Geometry'; }
rectangle_is() { [ "$(rectangle)" = "$1" ]; }
moved_from() { ! rectangle_is "$1"; }
full_screen() {
    local before
    before=$(rectangle)
    key F11 && eventually size_is 1280x1024 && key F11 && eventually rectangle_is "$before"
}
check "F11 fills the screen, and a second press restores the window's position and size" full_screen
goes() { # X Y: ask the window manager to move the window to this position
    local before
    before=$(rectangle)
    xdotool windowmove "$window" "$1" "$2" && eventually moved_from "$before"
}
uncovered() { goes -200 50 && goes 300 300 && eventually shown first; } # the part beyond the edge of the screen is lost
check 'a part of the window that was outside the screen is shown again' uncovered
resize() { wmctrl -i -r "$window" -e 0,-1,-1,300,300 && eventually size_is 300x300 && render wanted -s 300x300 && eventually shown wanted; }
check 'a window of another size shows the picture undistorted' resize

# ---- A saved file ----

reloaded() {
    save "${good/const vec3 SKY = vec3(/const vec3 SKY = 0.5 * vec3(}" && eventually says out ': reloaded' &&
        render wanted -s 300x300 -f "$mine" && eventually shown wanted
}
check 'a saved shader is reloaded' reloaded
check 'the program has reported nothing' [ ! -s "$scratch/run/err" ]
asked() { wmctrl -i -c "$window" && ends_well; }
check 'a close request closes the window with status 0' asked

# ---- A French keyboard ----

if ! command -v setxkbmap >/dev/null; then
    skip 'a French keyboard' 'this machine has no setxkbmap'
else
    setxkbmap fr
    # shellcheck disable=SC2086 # the options are separate words
    start $chapter $still && key h
    frenchwalk() { walk z && xdotool keydown w sleep 0.15 keyup w && shoot_as a && same there a; }
    check 'on an AZERTY keyboard, Z, at the position of W, moves the camera, and W does not' frenchwalk
    digit() { xdotool key eacute && shows ' - normals - ' && key Down && shows 'normalStep'; }
    check 'on an AZERTY keyboard, the key of the digit 2 shows the normals' digit
    setxkbmap us
    check 'Backspace closes the window with status 0' backspace
fi

# ---- A lecture ----

printf '01 -a 1 -c 1.65,1.6,3.4,-26,-23.5\n  The picture.\n01 -a 1 -c 1.65,1.6,3.4,-26,-23.5 -v normals\n  Its normals.\n' >"$scratch/list.txt"
start lecture "$scratch/list.txt"
check 'a lecture fills the screen' eventually size_is 1280x1024
# The first H shows the panel, the second only the picture.
paged() {
    key Next && shows ' - normals - ' && key h h && render wanted -s 1280x1024 -v normals && eventually shown wanted &&
        key Prior && shows ' - picture - '
}
check 'Page Down shows the next scene, and Page Up the previous scene' paged
check 'Backspace ends the lecture' backspace
start lecture --notes "$scratch/list.txt"
noted() {
    eventually says out '1/2  The picture.' && says out '   then 2/2  Its normals.' && key Next && shows ' - normals - ' &&
        says out '   then the end' && render wanted -s 1280x1024 -v normals && eventually shown wanted && backspace
}
check 'notes are printed with the next one, and not shown' noted

# Where coordinates are in pixels, as on Windows and X11, the window itself is larger on a dense display.
xprop -root -format RESOURCE_MANAGER 8s -set RESOURCE_MANAGER 'Xft.dpi: 192'
start $chapter -a 1 -s 160x100 -c 1.65,1.6,3.4,-26,-23.5 && key h
check 'a window on a display of 192 dots per inch is twice as wide and high' eventually shown expected
check 'Backspace closes the window on a dense display' backspace
xprop -root -remove RESOURCE_MANAGER

printf '%s\n' '#include "main.glsl"' 'uniform sampler2D stone; // "granite.png" sRGB repeat: a picture' \
    'uniform highp sampler3D cloud; // "noise.png" linear repeat 64: a volume' \
    'Ray pixelRay(vec2 s) { return Ray(vec3(s, 0.7), vec3(0.0, 0.0, -1.0)); }' 'float sceneDistance(vec3 p) { return 1.0; }' \
    'vec3 rayColour(Ray r) { return mix(textureGrad(stone, r.origin.xy, vec2(0.01, 0.0), 0.3 * r.origin.xy).rgb, textureLod(cloud, r.origin, 1.5).rgb, 0.5); }' \
    >"$scratch/both.frag"
hidden_window() {
    "$BUILD/$chapter" -s 160x90 -f "$scratch/both.frag" -o "$scratch/egl.png" &&
        "$BUILD/$chapter" -s 160x90 -f "$scratch/both.frag" -b glfw -o "$scratch/glfw.png" && same egl glfw
}
check 'textures look the same, bit for bit, with a hidden window and without a window' hidden_window

# ---- The terminal and the display ----

# Start the program with a pipe as its standard output whose reader has exited. It prints its first line at once.
left() {
    rm -f "$scratch/pipe" && mkfifo "$scratch/pipe" && rm -rf "$scratch/run" && mkdir "$scratch/run" && keep_managed || return
    # shellcheck disable=SC2094,SC2086 # both ends are opened, so that neither waits for the other; the options are words
    (exec 5<>"$scratch/pipe" 6>"$scratch/pipe" 5>&- && exec "$BUILD/$chapter" $still -f "$mine" >&6 2>"$scratch/run/err" 6>&-) &
    program=$!
    eventually find_window && shows ' - picture - ' && eventually focus && key 2 && shows ' - normals - '
}
check 'a window outlives the reader of its standard output' left
silent() { backspace && [ ! -s "$scratch/run/err" ]; }
check 'its status is 0, and it reports nothing' silent

# fails PATTERN: the program ends with status 1 and one line that matches the pattern.
fails() {
    eventually ended || return
    wait "$program"
    [ "$? $(grep -c '' "$scratch/run/err")" = '1 1' ] && grep -q -e "$1" "$scratch/run/err" && return
    sed 's/^/# /' "$scratch/run/err"
    return 1
}
# shellcheck disable=SC2086 # the options are words
start $chapter $still
destroyed() { xdotool windowclose "$window" && fails '^window: the display refused request .*Bad'; }
check 'a window that another program has destroyed ends with one line' destroyed
# shellcheck disable=SC2086 # the options are words
start $chapter $still
vanished() { kill "$display_server" && wait "$display_server"; fails '^window: the display has gone away'; }
check 'a display that goes away ends the program with one line' vanished

close_window
plan
