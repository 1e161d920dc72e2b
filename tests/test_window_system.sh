#!/bin/bash
# test_window_system.sh - the window on systems that the tests do not have: one that keeps GLFW from returning while
# a hand resizes the window, one whose displays are dense. other_glfw.c stands before GLFW and behaves like them.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/support.sh
. tests/support_window.sh

read -r -a flags <<<"$(pkg-config --cflags glfw3 2>/dev/null)"
if ! "${CC:-cc}" -std=c11 -D_XOPEN_SOURCE=700 -shared -fPIC ${flags[@]+"${flags[@]}"} -o "$scratch/other_glfw.so" tests/other_glfw.c -ldl; then
    not_ok 'the other GLFW is built'
    plan
    exit
fi
# start_with VARIABLE=VALUE STEM OPTION...: a window on such a system. What else is begun meanwhile has no GLFW.
start_with() {
    export LD_PRELOAD=$scratch/other_glfw.so "${1?}"
    start "${@:2}"
    unset LD_PRELOAD "${1%%=*}"
}
picture_of() { "$root/$BUILD/$chapter" "$@" -o "$scratch/wanted.png" >/dev/null; }
eye=(-c "1.65,1.6,3.4,-26,-23.5")

# ---- A hand on the window's edge ----

start_with "GLFW_HOLD=$scratch/hold" $chapter -s 320x200 "${eye[@]}"
key h
picture_of -s 320x200 "${eye[@]}"
check 'the window is drawn' eventually shown wanted
: >"$scratch/hold"
check 'the system keeps GLFW from returning' eventually [ -e "$scratch/hold.held" ]
# Where drawing is slow, a size's one frame is coarse: up to a quarter of its pixels are others. Of a picture that still
# has the size before it is more than half.
for size in 400x260 240x300 520x300; do
    resized() { picture_of -s "$size" "${eye[@]}" && xdotool windowsize "$window" "${size%x*}" "${size#*x}" && eventually part_shown wanted "$size+0+0" 300000; }
    check "meanwhile the window is drawn at $size" resized
done
mv "$scratch/hold" "$scratch/let_go"
check 'afterwards keys are heard again' eval 'key 2 && shows " - normals - "'
check 'Backspace closes it' backspace
check 'nothing was reported' [ ! -s "$scratch/run/err" ]

# ---- A dense display ----

start_with GLFW_DENSE=1 $chapter -s 160x100 "${eye[@]}"
key h
twice() { picture_of -s 320x200 "${eye[@]}" && shoot_as dense && matches wanted dense && eventually shown wanted; }
check 'a window has all pixels of a dense display' twice
ray() { xdotool mousemove --window "$window" 170 70 click 1 && eventually says out 'ray of pixel 170,129'; }
check 'a click chooses the pixel that it is on' ray
check 'Backspace closes it' backspace

start_with GLFW_DENSE=1 $chapter -s 160x100 "${eye[@]}" --compare --set normalStep=0.4
key h
divided() {
    picture_of -s 320x200 "${eye[@]}" --compare --set normalStep=0.4 --divider 0.3 &&
        xdotool mousemove --window "$window" 160 150 mousedown 1 mousemove --window "$window" 120 150 \
            mousemove --window "$window" 96 150 mouseup 1 && shoot_as dragged && matches wanted dragged
}
check 'the divider goes where it is dragged' divided
check 'Backspace closes it' backspace

start_with GLFW_DENSE=1 $chapter -s 320x180
row() { key Down && shows 'normalStep = ' && xdotool mousemove --window "$window" 60 50 click 1 && shows 'focalLength = '; }
check 'a click in the panel chooses the row that it is on' row
check 'Backspace closes it' backspace

# Where coordinates are pixels, as on Windows and X11, the window itself is larger.
xprop -root -format RESOURCE_MANAGER 8s -set RESOURCE_MANAGER 'Xft.dpi: 192'
start $chapter -s 160x100 "${eye[@]}"
key h
check 'a window on a display of 192 dots an inch is twice as wide and high' twice
check 'Backspace closes it' backspace
xprop -root -remove RESOURCE_MANAGER

# ---- What a Mac is asked for ----

hints() { # WANTED OPTION...: the hint for the menu bar, which comes with an icon in the Dock
    local wanted=$1
    shift
    rm -f "$scratch/log"
    LD_PRELOAD=$scratch/other_glfw.so GLFW_LOG=$scratch/log "$BUILD/$chapter" -b glfw "$@" >/dev/null 2>"$scratch/said"
    [ "$(sed -n 's/^0x51002 //p' "$scratch/log" 2>/dev/null)" = "$wanted" ]
}
check 'a hidden window has no icon in the Dock' hints 0 -s 16x9 -o "$scratch/small.png"
start_with "GLFW_LOG=$scratch/log" $chapter -s 320x200
check 'a window that is seen has one' grep -qx '0x51002 0x1' "$scratch/log"
check 'Backspace closes it' backspace
# It has OpenGL 3.2 and more in a core profile alone, and that only where it is forward-compatible.
asked() {
    local hint
    for hint in '0x22002 0x3' '0x22003 0x3' '0x22006 0x1' '0x22008 0x32001'; do
        grep -qx "$hint" "$scratch/log" || { echo "# no hint $hint"; return 1; }
    done
}
check 'and OpenGL 3.3, core and forward-compatible' asked
hidden() { hints 0 -s 16x9 -o "$scratch/small.png" && asked; }
check 'a hidden one too' hidden
unset DISPLAY WAYLAND_DISPLAY
check 'without a display GLFW is not begun' hints '' -s 16x9 -o "$scratch/small.png"
check 'which is said' grep -q 'no display' "$scratch/said"
plan
