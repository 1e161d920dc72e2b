#!/bin/bash
# test_window_steps.sh - one ray in the window, step by step, with real keys: what the slice, the plot and the
# picture show of it, and that it stays in space while the camera moves. Judged by screenshots, which the command
# line renders once more.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/support.sh
. tests/support_window.sh

# The ray of pixel 170,129 of the small window: 170 from the left, 70 from the top.
click() { xdotool mousemove --window "$window" 170 70 click 1 && eventually says out 'ray of pixel 170,129'; }
ray=(--probe '170,129')
# A screenshot is what the command line makes of the same options, and not what another step shows.
is() { # NAME OPTION...
    local name=$1
    shift
    render "wanted-$name" "$@" && shoot_as "$name" && matches "wanted-$name" "$name"
}

# shellcheck disable=SC2086 # options are words
start $chapter $still
check 'a window opens' [ -n "$window" ]
key h # the picture alone
last=$("$BUILD/$chapter" -s 320x200 -c 1.65,1.6,3.4,-26,-23.5 "${ray[@]}" | awk -F, '/^[0-9]/ { n = $1 } END { print n }')

lens_is() { [[ $(title) == *"focalLength = $1" ]]; }
check 'Home without a ray resets the parameter' eval 'key Right && eventually lens_is 2.1 && key Home && eventually lens_is 2'
check 'Delete resets it too' eval 'key Right && eventually lens_is 2.1 && key Delete && eventually lens_is 2'

slice() { key 5 && shows ' - slice - ' && click && is all "${ray[@]}" -v slice; }
check 'a click in the slice shows the whole march' slice
first() { key Home && is first "${ray[@]}" -v slice --step 0 && differ first all; }
check 'Home shows its first step alone' first
on() { key e && is second "${ray[@]}" -v slice --step 1 && differ first second; }
check 'E goes a step on' on
back() { key q && shoot_as again && same first again; }
check 'Q goes a step back' back
check 'and stays at the first' back
remote() { key Next && shoot_as next && same second next && key Prior && shoot_as prior && same first prior; }
check "Page Down and Page Up, a remote's keys, do the same" remote
at_end() { key End && is end "${ray[@]}" -v slice --step "$last" && differ end first; }
check 'End shows its last step' at_end
beyond() { key e && shoot_as beyond && same end beyond; }
check 'E goes no further' beyond
runs() { # a busy machine may see press and release at once: then the key is held for longer
    local hold
    for hold in 1 3 8; do
        key Home && xdotool keydown e sleep $hold keyup e && shoot_as ran && differ ran second && differ ran first && return
    done
    return 1
}
check 'a key that is held runs' runs
plot() { key 6 && shows ' - plot - ' && key Home && key e && is plot "${ray[@]}" -v plot --step 1; }
check '6 shows the plot, at the step that is looked at' plot
stays() { key Right && eventually lens_is 2.1 && shoot_as lens && same plot lens; }
check 'the ray stays while the focal length changes' stays
resets() { key Home && shoot_as home && lens_is 2.1 && key Delete && eventually lens_is 2; }
check 'Delete resets a parameter while a ray is chosen, Home does not' resets
lets_go() { xdotool mousemove --window "$window" 170 70 click 1 && is middle -v plot; }
check 'a second click lets it go: the middle ray, whole' lets_go
starts() { key e && eventually says out 'ray of pixel 160,100' && is starts -v plot --step 0; }
check 'E without a ray takes the middle one, at its first step' starts
by_key() { key x && is middle -v plot; }
check 'X lets it go' by_key
check 'E takes it again' starts
grown() { shoot_as grown && matches wanted-grown grown; }
grows() {
    render wanted-grown -s 480x300 --probe 240,150 -v plot --step 0 && xdotool windowsize "$window" 480 300 && eventually grown
}
check 'in a larger window it is the same ray, at another pixel' grows
is_wide() { shoot_as wide && [ "$(identify -format %w "$scratch/wide.png")" = "$1" ]; }
creeps() { # as under a hand that drags its edge; what is rounded does not add up
    local width
    for width in 481 482 483 484 485 486; do
        xdotool windowsize "$window" "$width" 300 && eventually is_wide "$width" || return
    done
}
check 'its edge is dragged' creeps
as_before() { shoot_as before && same starts before; }
shrinks() { xdotool windowsize "$window" 320 200 && eventually as_before; }
check 'and in the first size the same again' shrinks

# ---- In the picture ----

key 1
shows ' - picture - '
mark() { # the cross, and in it the dot; far from the panels
    xdotool mousemove --window "$window" 170 70 click 1 && eventually says out 'ray of pixel 170,129' && shoot_as bare &&
        key h && eventually hidden bare && look crossed && key Home && eventually dotted
}
dotted() { look dot && [ "$(apart dot crossed 5x5+168+68)" -gt 0 ]; }
check 'the picture marks the point of a step in its pixel' mark
aside() { # the ray stays while the camera moves, and is seen as a line
    key End && walk d && key h && shoot_as moved && differ bare moved && key h &&
        eventually hidden moved && key 5 && shows ' - slice - ' && key h && eventually is_kept
}
is_kept() { shoot_as kept && render wanted "${ray[@]}" -v slice --step "$last" && matches wanted kept; }
check 'the ray stays in space while the camera moves: its slice is that of the click' aside
anew() { # a second click on the pixel lets it go, a third takes the ray of the camera as it is now
    xdotool mousemove --window "$window" 170 70 click 1 && xdotool click 1 && shoot_as anew && differ anew kept
}
check 'a click anew takes the ray of the new camera' anew
check 'Backspace closes the window with status 0' backspace
check 'nothing was reported' [ ! -s "$scratch/run/err" ]

# ---- A file that keeps no trace ----

# shellcheck disable=SC2086 # options are words
start 00_first_scene -s 320x200
silent() { key Escape && shows '(paused)' && key e Home End q && key 1 && alive && ! says out 'ray of pixel'; }
check 'a file with a main of its own has no steps, and says nothing' silent
check 'Backspace closes it' backspace

# ---- A French keyboard ----

french() {
    setxkbmap fr 2>/dev/null || return
    # shellcheck disable=SC2086 # options are words
    start $chapter $still && key h && xdotool mousemove --window "$window" 170 70 click 1 &&
        eventually says out 'ray of pixel 170,129' && key Home && xdotool key minus && shows ' - plot - ' &&
        xdotool key e && is french "${ray[@]}" -v plot --step 1 && xdotool key a && is french_back "${ray[@]}" -v plot --step 0 && backspace
}
check "AZERTY: its A and E, and the key of 6, do what the places say" french

close_window
plan
