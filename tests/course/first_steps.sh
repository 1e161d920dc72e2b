#!/bin/bash
# first_steps.sh - tests the engine of docs/engine.md, engine_1.c to engine_6.c: each step builds with the command at
# its top and with nothing from common/, and shows its picture; a failure is reported on one line.
# shellcheck disable=SC2317 # functions are passed to check by name
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh

open_scratch
steps=$BUILD/first_steps
sources=chapters/first_steps
plank=shaders/textures/plank.png

if [ ! -x "$steps/engine_6" ] || ! command -v convert >/dev/null; then
    skip 'the engine' 'this machine has no GLFW, no EGL or no convert'
    plan
    exit
fi

# ---- The sources ----

grown() {
    local step before=100 lines
    for step in 1 2 3 4 5 6; do
        lines=$(wc -l <"$sources/engine_$step.c")
        [ $((lines - before)) -le 60 ] || { echo "# engine_$step.c has $lines lines, more than 60 above $before" && return 1; }
        before=$lines
    done
}
check 'each step is at most 60 lines longer than the one before' grown
check 'no step includes a header of the course' [ "$(cat "$sources"/*.c | grep -c '#include "')" = 0 ]

# builds NAME [EDIT]: builds the source with the command at its top, in a folder that contains nothing else. EDIT is a
# sed script for the source.
builds() {
    local line
    line=$(sed -n "s|^// \(cc .*\)|\1|p" "$sources/$1.c")
    mkdir -p "$scratch/alone/$sources" && sed "${2-}" "$sources/$1.c" >"$scratch/alone/$sources/$1.c" &&
        (cd "$scratch/alone" && eval "$line") 2>"$scratch/said" && [ -x "$scratch/alone/$1" ]
}
for step in 1 2 3 4 5 6; do
    check "engine_$step.c builds with the command at its top" builds "engine_$step"
done

# ---- Without a window ----

# fails STATUS WORDS COMMAND...: the command must fail with this status and print one line that matches WORDS.
fails() {
    local wanted=$1 words=$2 status
    shift 2
    "$@" >"$scratch/said" 2>&1
    status=$?
    [ "$status" = "$wanted" ] && [ "$(wc -l <"$scratch/said")" = 1 ] && grep -q -e "$words" "$scratch/said" && return
    echo "# status $status: $(cat "$scratch/said")"
    return 1
}

draw() { "$steps/engine_6" -o "$scratch/picture.png" "$@"; }
draws() { # REFERENCE SHADER [PICTURE]
    draw "${@:2}" && build/tests/compare "tests/references/$1.png" "$scratch/picture.png"
}
check 'step 6 draws the first step of chapter 00' draws 00_first_scene-step-1 "$sources/1_screen.frag"
check 'step 6 draws the scene of step 4' draws 00_first_scene-engine-4 "$sources/engine_4.frag"
check 'step 6 draws the wooden floor of step 5' draws engine_5 "$sources/engine_5.frag" "$plank"

# A texture of two texels, black above white, must be sampled the right way up and averaged in linear light, both within
# a level and from one level to the next.
printf '%s\n' '#version 330 core' 'in vec2 FragCoord; uniform sampler2D picture; out vec4 FragColor;' 'void main() {' \
    'FragColor = textureLod(picture, vec2(0.5, FragCoord.x < -0.6 ? 0.25 : 0.5), FragCoord.x < 0.6 ? 0.0 : 1.0); }' >"$scratch/read.frag"
averages() {
    convert -size 1x1 xc:black xc:white -append "PNG24:$scratch/texels.png" && draw "$scratch/read.frag" "$scratch/texels.png" &&
        [[ $(convert "$scratch/picture.png" -crop 3x1+0+0 -resize 1x1\! -depth 8 gray:- | od -An -tu1) -eq 255 ]] &&
        for x in 320 600; do
            [[ $(convert "$scratch/picture.png" -crop "1x1+$x+9" -depth 8 gray:- | od -An -tu1) =~ ^\ *12[78]$ ]] || return 1
        done
}
check 'a texture is the right way up and averaged in linear light' averages

for line in '' '-o' '-o a.png' '-t 1 a.frag' 'a b c'; do
    # shellcheck disable=SC2086 # the line is split into words
    check "the command line '$line' is refused" fails 2 '^usage: ' "$steps/engine_6" $line
done
check 'a missing shader is reported' fails 1 "^engine: $scratch/gone.frag: No such file" draw "$scratch/gone.frag"
check 'a folder given as a shader is reported' fails 1 '^engine: tests: ' draw tests
head -c 70000 /dev/zero | tr '\0' ' ' >"$scratch/long.frag"
check 'a shader that is too long is reported' fails 1 'long.frag: too long: ' draw "$scratch/long.frag"
sed 's/red, green/rde, green/' "$sources/1_screen.frag" >"$scratch/wrong.frag"
check 'a mistake in a shader is reported with its line number' fails 1 "^engine: $scratch/wrong.frag:13: .*rde" draw "$scratch/wrong.frag"
sed 's/in vec2 FragCoord/in vec4 FragCoord/' "$sources/1_screen.frag" >"$scratch/unfit.frag"
check 'an input of the wrong type is reported' fails 1 "^engine: $scratch/unfit.frag: .*FragCoord" draw "$scratch/unfit.frag"
check 'a missing picture is reported' fails 1 '^engine: gone.png: ' draw "$sources/engine_5.frag" gone.png
check 'a file that is not a picture is reported' fails 1 '^engine: README.md: ' draw "$sources/engine_5.frag" README.md
head -c 2000 "$plank" >"$scratch/half.png"
check 'a truncated picture is reported' fails 1 "^engine: $scratch/half.png: " draw "$sources/engine_5.frag" "$scratch/half.png"
check 'a missing folder for the picture is reported' fails 1 "^engine: $scratch/gone/a.png: " "$steps/engine_6" -o "$scratch/gone/a.png" "$sources/1_screen.frag"
full() { fails 1 'full.png: ' within_kib 1 "$steps/engine_6" -o "$scratch/full.png" "$sources/engine_4.frag" && [ ! -e "$scratch/full.png" ]; }
check 'a full disk is reported, and no part of the picture is left' full
# LIBGL_ALWAYS_SOFTWARE selects Mesa's driver, which obeys MESA_GL_VERSION_OVERRIDE.
check 'with -o, a version of OpenGL that is too old is refused' fails 1 '^engine: no OpenGL 3.3' env MESA_GL_VERSION_OVERRIDE=3.2 "$steps/engine_6" -o "$scratch/old.png" "$sources/1_screen.frag"
hidden() { # COMMAND...: runs the command where no window can be opened, without the lines that libwayland may add
    env -u DISPLAY -u WAYLAND_DISPLAY "$@" 2>&1 | grep -e '^engine: '
    return "${PIPESTATUS[0]}"
}
check 'a window without a display is refused' fails 1 '^engine: no window' hidden "$steps/engine_1"
check 'step 6 says that -o needs no window' fails 1 'needs none' hidden "$steps/engine_6" "$sources/1_screen.frag"

# ---- The exercises ----

checked() { EXERCISE=$1 FILE=$2 FILES='' .make/check.sh >"$scratch/said" 2>&1; }
solved() { # EXERCISE
    patch -s -o "$scratch/my.c" "$sources/engine_6.c" "chapters/solutions/$1.diff" && checked "$1" "$scratch/my.c" &&
        ! checked "$1" "$sources/engine_6.c" && grep -q 'engine_6.c: wrong: with ' "$scratch/said"
}
for diff in chapters/solutions/engine_*.diff; do
    name=$(basename "$diff" .diff)
    check "make check accepts the solution to $name, but not the unsolved engine" solved "$name" || sed 's/^/# /' "$scratch/said"
done
echo 'int main(void) { return x; }' >"$scratch/broken.c"
refused() { ! checked engine_1 "$scratch/broken.c" && grep -q 'does not compile: .*broken.c:1:' "$scratch/said"; }
check 'make check names the line of the error in a program that does not compile' refused
check 'make diff compares a step with the one before' [ "$(CHAPTER=engine_2 .make/diff.sh | grep -c '^[+]static bool read_text')" = 1 ]

# ---- In a window ----

close_scratch
. tests/lib/window.sh
export XDG_RUNTIME_DIR=$scratch # otherwise, libwayland reports that the variable is not set

begin() { # STEP WORD...
    "$steps/engine_$1" "${@:2}" >"$scratch/said" 2>&1 &
    program=$!
    opens || { sed 's/^/# /' "$scratch/said" && return 1; }
}
matches_reference() { cp "tests/references/$1.png" "$scratch/wanted.png" && eventually shown wanted; } # NAME
# The window, resized to 300x300, must show the picture that the program of chapter 00 renders at this size.
square() { # SHADER
    "$BUILD/00_first_scene" -s 300x300 -f "$1" -o "$scratch/wanted.png" >/dev/null &&
        wmctrl -i -r "$window" -e 0,-1,-1,300,300 && eventually shown wanted
}
closes() { wmctrl -i -c "$window" && ends_well; }

check 'step 1 opens a window' begin 1
check 'step 1 fills the window, whatever its size' square "$sources/1_screen.frag"
check 'Backspace ends step 1 with status 0' backspace
check 'step 1 reports nothing' [ ! -s "$scratch/said" ]

cp "$sources/2_distance.frag" "$mine"
check 'step 2 opens a file' begin 2 "$mine"
check 'step 2 shows the file' square "$sources/2_distance.frag"
told() { save "$(cat "$scratch/wrong.frag")" && eventually grep -q "^engine: $mine:13: .*rde" "$scratch/said" && shown wanted; }
sed 's/red, green/rde, green/' "$sources/1_screen.frag" >"$scratch/wrong.frag"
check 'a mistake is reported, and the last good picture remains' told
follows() { save "$(cat "$sources/1_screen.frag")" && square "$sources/1_screen.frag"; }
check 'a saved file is shown' follows
check 'the mistake was reported on one line' [ "$(wc -l <"$scratch/said")" = 1 ]
check 'the close button ends step 2 with status 0' closes
check 'if the shader has a mistake when step 2 starts, no window opens' fails 1 "^engine: $scratch/wrong.frag:13: " "$steps/engine_2" "$scratch/wrong.frag"

quoted() { # the position that the page's example prints is the one on the page
    local at
    sed 's/- radius;/- radios;/' "$sources/2_distance.frag" >"$scratch/mine.frag"
    at=$("$steps/engine_2" "$scratch/mine.frag" 2>&1 | grep -o 'mine\.frag:[0-9]*: ') && grep -qF "engine: $at" docs/engine.md
}
check 'the page quotes the line of the mistake in its example' quoted

check 'step 3 opens a file' begin 3 "$sources/2_distance.frag"
check 'step 3 draws an undistorted circle' matches_reference 00_first_scene-step-2
check 'Backspace ends step 3' backspace
check 'step 3 opens chapter 00' begin 3 chapters/00_first_scene.frag
moves() { look before && eventually changed before; }
check 'the scene of chapter 00 moves' moves
check 'Backspace ends step 3 again' backspace

cp "$sources/engine_4.frag" "$mine"
check 'step 4 opens a scene' begin 4 "$mine"
check 'step 4 shows the scene from its camera' matches_reference 00_first_scene-engine-4
near() { look screen && build/tests/compare "$scratch/screen.png" "$scratch/wanted.png" >/dev/null; }
# A drag of 100 units to the right and 50 up turns the camera by 100 and 50 times 2 / (360 x 1.5) radians. The program
# looks once per frame where the pointer is. Two saved files that were shown one after the other prove that it has looked
# before the drag begins.
drags() {
    xdotool mousemove --window "$window" 200 200 && save "$(cat "$sources/1_screen.frag")" &&
        matches_reference 00_first_scene-step-1 && save "$(cat "$sources/engine_4.frag")" && matches_reference 00_first_scene-engine-4 &&
        "$BUILD/00_first_scene" -f "$mine" -c 0,1.3,3.2,21.2207,-0.8489 -o "$scratch/wanted.png" >/dev/null &&
        xdotool mousedown 1 mousemove --window "$window" 300 150 && eventually near && xdotool mouseup 1
}
check 'a drag turns the camera by the angle that it covers' drags
walks() { xdotool keydown w && eventually changed wanted && xdotool keyup w; }
check 'W moves the camera' walks
check 'Backspace ends step 4' backspace

check 'step 5 opens a scene with a picture' begin 5 "$sources/engine_5.frag" "$plank"
check 'step 5 shows the wooden floor' matches_reference engine_5
check 'Backspace ends step 5' backspace
check 'in a window, a version of OpenGL that is too old is refused' fails 1 '^engine: no window with OpenGL 3.3' env MESA_GL_VERSION_OVERRIDE=3.2 "$steps/engine_1"

close_window
plan
