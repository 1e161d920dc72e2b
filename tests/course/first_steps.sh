#!/bin/bash
# first_steps.sh - the engine of docs/engine.md, engine_1.c to engine_6.c: each step builds with the line at its top and
# nothing from common/, and shows its picture; a failure is reported on one line.
# shellcheck disable=SC2317 # functions are handed to check by name
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh

open_scratch
steps=$BUILD/first_steps
sources=chapters/first_steps
plank=shaders/textures/plank.png

if [ ! -x "$steps/engine_6" ] || ! command -v convert >/dev/null; then
    skip 'the engine' 'no GLFW, EGL or convert on this machine'
    plan
    exit
fi

# ---- The sources ----

grown() {
    local step before=100 lines
    for step in 1 2 3 4 5 6; do
        lines=$(wc -l <"$sources/engine_$step.c")
        [ $((lines - before)) -le 60 ] || { echo "# engine_$step.c has $lines lines, the one before $before" && return 1; }
        before=$lines
    done
}
check 'each step is at most 60 lines longer than the one before' grown
check 'no step includes anything of the course' [ "$(cat "$sources"/*.c | grep -c '#include "')" = 0 ]

# builds NAME [EDIT]: with the line at the top of the source, in a folder that contains nothing else.
builds() { # NAME [EDIT]
    local line
    line=$(sed -n "s|^// \(cc .*\)|\1|p" "$sources/$1.c")
    mkdir -p "$scratch/alone/$sources" && sed "${2-}" "$sources/$1.c" >"$scratch/alone/$sources/$1.c" &&
        (cd "$scratch/alone" && eval "$line") 2>"$scratch/said" && [ -x "$scratch/alone/$1" ]
}
for step in 1 2 3 4 5 6; do
    check "engine_$step.c builds with the line at its top" builds "engine_$step"
done

# ---- Without a window ----

# fails STATUS WORDS COMMAND...: the status, and one line from the program itself, with these words.
fails() {
    local wanted=$1 words=$2 status
    shift 2
    "$@" >"$scratch/said" 2>&1
    status=$?
    [ "$status" = "$wanted" ] && [ "$(wc -l <"$scratch/said")" = 1 ] && grep -q -e "$words" "$scratch/said" && return
    echo "# status $status: $(cat "$scratch/said")"
    return 1
}

# Limit files to this many KiB. A signal would hide the program's own words.
within_kib() { # KIB COMMAND...
    (trap '' XFSZ && ulimit -f "$1" && shift && exec "$@")
}

draw() { "$steps/engine_6" -o "$scratch/picture.png" "$@"; }
draws() { # REFERENCE SHADER [PICTURE]
    draw "${@:2}" && build/tests/compare "tests/references/$1.png" "$scratch/picture.png"
}
check 'step 6 draws the first step of chapter 00' draws 00_first_scene-step-1 "$sources/1_screen.frag"
check 'and what its own camera sees' draws 00_first_scene-engine-4 "$sources/engine_4.frag"
check 'and its floor of wood' draws engine_5 "$sources/engine_5.frag" "$plank"

# A picture of two texels, black above white, is read upright, and averaged as light: within a level and between two.
printf '%s\n' '#version 330 core' 'in vec2 FragCoord; uniform sampler2D picture; out vec4 FragColor;' 'void main() {' \
    'FragColor = textureLod(picture, vec2(0.5, FragCoord.x < -0.6 ? 0.25 : 0.5), FragCoord.x < 0.6 ? 0.0 : 1.0); }' >"$scratch/read.frag"
averages() {
    convert -size 1x1 xc:black xc:white -append "PNG24:$scratch/texels.png" && draw "$scratch/read.frag" "$scratch/texels.png" &&
        [[ $(convert "$scratch/picture.png" -crop 3x1+0+0 -resize 1x1\! -depth 8 gray:- | od -An -tu1) -eq 255 ]] &&
        for x in 320 600; do
            [[ $(convert "$scratch/picture.png" -crop "1x1+$x+9" -depth 8 gray:- | od -An -tu1) =~ ^\ *12[78]$ ]] || return 1
        done
}
check 'a texture is upright and averaged as light' averages

for line in '' '-o' '-o a.png' '-t 1 a.frag' 'a b c'; do
    # shellcheck disable=SC2086 # words
    check "the command line '$line' is refused" fails 2 '^usage: ' "$steps/engine_6" $line
done
check 'a missing shader' fails 1 "^engine: $scratch/gone.frag: No such file" draw "$scratch/gone.frag"
check 'a folder as a shader' fails 1 '^engine: tests: ' draw tests
head -c 70000 /dev/zero | tr '\0' ' ' >"$scratch/long.frag"
check 'a shader that is too long' fails 1 'long.frag: too long: ' draw "$scratch/long.frag"
sed 's/red, green/rde, green/' "$sources/1_screen.frag" >"$scratch/wrong.frag"
check 'a mistake is reported with its line' fails 1 "^engine: $scratch/wrong.frag:13: .*rde" draw "$scratch/wrong.frag"
sed 's/in vec2 FragCoord/in vec4 FragCoord/' "$sources/1_screen.frag" >"$scratch/unfit.frag"
check 'so is an input of another type' fails 1 "^engine: $scratch/unfit.frag: .*FragCoord" draw "$scratch/unfit.frag"
check 'a missing picture' fails 1 '^engine: gone.png: ' draw "$sources/engine_5.frag" gone.png
check 'a file that is not a picture' fails 1 '^engine: README.md: ' draw "$sources/engine_5.frag" README.md
head -c 2000 "$plank" >"$scratch/half.png"
check 'half a picture' fails 1 "^engine: $scratch/half.png: " draw "$sources/engine_5.frag" "$scratch/half.png"
check 'a missing folder' fails 1 "^engine: $scratch/gone/a.png: " "$steps/engine_6" -o "$scratch/gone/a.png" "$sources/1_screen.frag"
full() { fails 1 'full.png: ' within_kib 1 "$steps/engine_6" -o "$scratch/full.png" "$sources/engine_4.frag" && [ ! -e "$scratch/full.png" ]; }
check 'a full disk, which leaves no picture' full
# LIBGL_ALWAYS_SOFTWARE is set: the driver is Mesa's.
check 'an OpenGL that is too old' fails 1 '^engine: no OpenGL 3.3' env MESA_GL_VERSION_OVERRIDE=3.2 "$steps/engine_6" -o "$scratch/old.png" "$sources/1_screen.frag"
hidden() { # COMMAND...: where no window can be opened; libwayland may add lines of its own
    env -u DISPLAY -u WAYLAND_DISPLAY "$@" 2>&1 | grep -e '^engine: '
    return "${PIPESTATUS[0]}"
}
check 'a window without a display' fails 1 '^engine: no window' hidden "$steps/engine_1"
check 'which step 6 can do without' fails 1 'needs none' hidden "$steps/engine_6" "$sources/1_screen.frag"

# ---- The exercises ----

checked() { EXERCISE=$1 FILE=$2 FILES='' .make/check.sh >"$scratch/said" 2>&1; }
solved() { # EXERCISE
    patch -s -o "$scratch/my.c" "$sources/engine_6.c" "chapters/solutions/$1.diff" && checked "$1" "$scratch/my.c" &&
        ! checked "$1" "$sources/engine_6.c" && grep -q 'engine_6.c: wrong: with ' "$scratch/said"
}
for diff in chapters/solutions/engine_*.diff; do
    name=$(basename "$diff" .diff)
    check "make check accepts the solution of $name, and not the engine itself" solved "$name" || sed 's/^/# /' "$scratch/said"
done
echo 'int main(void) { return x; }' >"$scratch/broken.c"
refused() { ! checked engine_1 "$scratch/broken.c" && grep -q 'does not compile: .*broken.c:1:' "$scratch/said"; }
check 'and names the line of a program that does not compile' refused
check 'make diff compares a step with the one before' [ "$(CHAPTER=engine_2 .make/diff.sh | grep -c '^[+]static bool read_text')" = 1 ]

# ---- In a window ----

close_scratch
. tests/lib/window.sh
export XDG_RUNTIME_DIR=$scratch # else libwayland says that there is none

begin() { # STEP WORD...
    "$steps/engine_$1" "${@:2}" >"$scratch/said" 2>&1 &
    program=$!
    opens || { sed 's/^/# /' "$scratch/said" && return 1; }
}
matches_reference() { cp "tests/references/$1.png" "$scratch/wanted.png" && eventually shown wanted; } # NAME
# The window shows what the course's own program draws, at its own size.
square() { # SHADER
    "$BUILD/00_first_scene" -s 300x300 -f "$1" -o "$scratch/wanted.png" >/dev/null &&
        wmctrl -i -r "$window" -e 0,-1,-1,300,300 && eventually shown wanted
}
closes() { wmctrl -i -c "$window" && ends_well; }

check 'step 1 opens a window' begin 1
check 'and fills it, whatever its size' square "$sources/1_screen.frag"
check 'Backspace ends it with status 0' backspace
check 'nothing was reported' [ ! -s "$scratch/said" ]

cp "$sources/2_distance.frag" "$mine"
check 'step 2 opens a file' begin 2 "$mine"
check 'and shows it' square "$sources/2_distance.frag"
told() { save "$(cat "$scratch/wrong.frag")" && eventually grep -q "^engine: $mine:13: .*rde" "$scratch/said" && shown wanted; }
sed 's/red, green/rde, green/' "$sources/1_screen.frag" >"$scratch/wrong.frag"
check 'a mistake is reported, and the last good picture stays' told
follows() { save "$(cat "$sources/1_screen.frag")" && square "$sources/1_screen.frag"; }
check 'a file that is saved is shown' follows
check 'it is one line' [ "$(wc -l <"$scratch/said")" = 1 ]
check 'the close button ends it with status 0' closes
check 'a shader with a mistake at the start opens no window' fails 1 "^engine: $scratch/wrong.frag:13: " "$steps/engine_2" "$scratch/wrong.frag"

check 'step 3 opens a file' begin 3 "$sources/2_distance.frag"
check 'and a circle is round' matches_reference 00_first_scene-step-2
check 'it ends' backspace
check 'step 3 opens chapter 00' begin 3 chapters/00_first_scene.frag
changed() { [ "$(off "$1")" != 0 ]; } # NAME
moves() { look before && eventually changed before; }
check 'and its scene moves' moves
check 'it ends' backspace

check 'step 4 opens a scene' begin 4 "$sources/engine_4.frag"
check 'and shows it from its camera' matches_reference 00_first_scene-engine-4
near() { look screen && build/tests/compare "$scratch/screen.png" "$scratch/wanted.png" >/dev/null; }
# 100 units to the right and 50 up are 100 and 50 times 2 / (360 x 1.5) radians.
drags() {
    "$BUILD/00_first_scene" -f "$sources/engine_4.frag" -c 0,1.3,3.2,21.2207,-0.8489 -o "$scratch/wanted.png" >/dev/null &&
        xdotool mousemove --window "$window" 200 200 sleep 1.5 mousedown 1 sleep 1.5 mousemove --window "$window" 300 150 &&
        eventually near && xdotool mouseup 1
}
check 'a drag turns the camera by the angle that it covers' drags
walks() { xdotool keydown w && eventually changed wanted && xdotool keyup w; }
check 'W moves it' walks
check 'it ends' backspace

check 'step 5 opens a scene with a picture' begin 5 "$sources/engine_5.frag" "$plank"
check 'and shows its floor of wood' matches_reference engine_5
check 'it ends' backspace
check 'an OpenGL that is too old is refused' fails 1 '^engine: no window with OpenGL 3.3' env MESA_GL_VERSION_OVERRIDE=3.2 "$steps/engine_1"

close_window
plan
