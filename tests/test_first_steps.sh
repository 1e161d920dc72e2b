#!/bin/bash
# test_first_steps.sh - the two whole programs of chapters/first_steps, without harness: picture.c draws what
# step 1 of chapter 00 draws, window.c shows it and ends when it is asked to; both say in one line what
# fails, and both build by the line at their top, with nothing of common/.
# shellcheck disable=SC2317 # functions are handed to check by name
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/support.sh

open_scratch
programs=$BUILD/first_steps
expected=tests/references/00_first_scene-step-1.png

# ---- Without a display ----

# fails STATUS WORDS COMMAND...: the status, and one line of the program's own, with these words.
fails() {
    local wanted=$1 words=$2 status
    shift 2
    "$@" >"$scratch/said" 2>&1
    status=$?
    [ "$status" = "$wanted" ] && [ "$(wc -l <"$scratch/said")" = 1 ] && grep -q -e "$words" "$scratch/said" && return
    echo "# status $status: $(cat "$scratch/said")"
    return 1
}

# A file may hold so many KiB only. A signal would hide the program's own words.
within() { # KIB COMMAND...
    (trap '' XFSZ && ulimit -f "$1" && shift && exec "$@")
}

# builds NAME [EDIT]: by the line at the top of the source, in a folder that has nothing else.
builds() { # NAME [EDIT]
    local line
    line=$(sed -n 's|^//   \(cc .*\)|\1|p' "chapters/first_steps/$1.c")
    mkdir -p "$scratch/alone/chapters/first_steps" &&
        sed "${2-}" "chapters/first_steps/$1.c" >"$scratch/alone/chapters/first_steps/$1.c" &&
        (cd "$scratch/alone" && eval "$line") 2>"$scratch/said" && [ -x "$scratch/alone/$1" ]
}

draws() { # PROGRAM
    "$1" "$scratch/picture.ppm" && [ "$(head -n 1 "$scratch/picture.ppm")" = 'P6 640 360 255' ] &&
        convert "$scratch/picture.ppm" "$scratch/picture.png" &&
        build/tests/compare "$expected" "$scratch/picture.png" >/dev/null
}

if [ ! -x "$programs/picture" ] || ! command -v convert >/dev/null; then
    skip 'picture.c draws the picture of step 1' 'no EGL or no convert on this machine'
else
    check 'picture.c draws the picture of step 1' draws "$programs/picture"
    check 'without a name it says how it is called' fails 2 '^usage: ' "$programs/picture"
    check 'a folder that is not there is named' fails 1 "$scratch/gone/a.ppm: " "$programs/picture" "$scratch/gone/a.ppm"
    check 'a full disk is no picture' fails 1 'full.ppm: ' within 4 "$programs/picture" "$scratch/full.ppm"
    # LIBGL_ALWAYS_SOFTWARE is set: the driver is Mesa's.
    check 'an OpenGL that is too old is refused' fails 1 '^picture: no OpenGL 3.3' \
        env -u DISPLAY -u WAYLAND_DISPLAY MESA_GL_VERSION_OVERRIDE=3.2 "$programs/picture" "$scratch/old.ppm"
    check 'picture.c builds by the line at its top' builds picture
    check 'and draws the same' draws "$scratch/alone/picture"
    mistyped() { builds picture 's/vec4(0.5/vec4(O.5/' && fails 1 '^picture: the shaders: .*7' "$scratch/alone/picture" "$scratch/a.ppm"; }
    check 'a mistake in its shader is told with its line' mistyped
    unfit() {
        builds picture '0,/"void main/s//"out float other; void main/; s/"out vec4 colour/"in vec2 other; out vec4 colour/; s/0.5 + 0.5 [*] place/other/' &&
            fails 1 '^picture: the shaders: ' "$scratch/alone/picture" "$scratch/a.ppm"
    }
    check 'so are two shaders that do not fit' unfit
fi

if [ ! -x "$programs/window" ]; then
    skip 'window.c opens a window' 'no GLFW on this machine'
    plan
    exit
fi
hidden() { # COMMAND...: where no window can be opened; libwayland may add lines of its own
    env -u DISPLAY -u WAYLAND_DISPLAY "$@" 2>&1 | grep -e '^window: '
    return "${PIPESTATUS[0]}"
}
check 'without a display window.c says so' fails 1 '^window: ' hidden "$programs/window"
check 'window.c builds by the line at its top' builds window
check 'neither includes anything of the course' [ "$(grep -c '#include "' chapters/first_steps/*.c | grep -vc ':0$')" = 0 ]

# ---- In a window ----

close_scratch
. tests/support_window.sh
export XDG_RUNTIME_DIR=$scratch # else libwayland says that there is none

open_window() { # COMMAND...
    "$@" >"$scratch/said" 2>&1 &
    program=$!
    opens
}

# Is a pixel's red and green what its place says? The blue goes with the time.
pixel_is() { # X Y, from the top left, in a window of 640x360 or of the size given
    import -window "$window" -depth 8 rgb:- 2>/dev/null | od -An -v -tu1 -w3 | awk -v x="$1" -v y="$2" -v w="${3-640}" -v h="${4-360}" '
        function near(is, wanted) {
            wanted = 255 * (wanted < 0 ? 0 : wanted > 1 ? 1 : wanted)
            return is - wanted < 1.5 && wanted - is < 1.5
        }
        NR == y * w + x + 1 {
            right = near($1, 0.5 + 0.5 * (2 * x + 1 - w) / h) && near($2, 0.5 + 0.5 * (h - 2 * y - 1) / h)
        }
        END { exit !(right && NR == w * h) }'
}
right_everywhere() {
    local place
    for place in '0 0' '639 0' '0 359' '639 359' '320 180' '200 90' '450 300'; do
        # shellcheck disable=SC2086 # two words
        eventually pixel_is $place || return 1
    done
}
check 'window.c opens a window' open_window "$programs/window" || {
    sed 's/^/# /' "$scratch/said"
    alive && echo '# it runs'
    close_window
    plan
    exit
}
check 'and shows the picture of step 1' right_everywhere
blue() { import -window "$window" -crop 1x1+320+180 -depth 8 rgb:- 2>/dev/null | od -An -tu1 | awk '{ print $3 }'; }
was=$(blue)
other_blue() { [ "$(blue)" != "$was" ]; }
check 'its blue goes with the time' eventually other_blue
resizes() { wmctrl -i -r "$window" -e 0,-1,-1,300,200 && eventually pixel_is 20 20 300 200 && pixel_is 280 150 300 200; }
check 'it fills a window of another size' resizes
check 'Backspace ends it with status 0' backspace
asked() { open_window "$programs/window" && wmctrl -i -c "$window" && ends_well; }
check 'so does the button that closes' asked
check 'nothing was reported' [ ! -s "$scratch/said" ]
check 'an OpenGL that is too old is refused' fails 1 '^window: ' env MESA_GL_VERSION_OVERRIDE=3.2 "$programs/window"
mistyped() { builds window 's/vec4(0.5/vec4(O.5/' && fails 1 '^window: the shaders: .*8' "$scratch/alone/window"; }
check 'a mistake in its shader is told with its line' mistyped

close_window
plan
