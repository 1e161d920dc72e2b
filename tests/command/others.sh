#!/bin/bash
# others.sh - tests shaders that were written for other programs, Shadertoy and EnginPasTangible, the engine of the
# report that the course follows: their inputs, their textures, films of them, and malformed text. It also tests make
# play, make bake, make run and printed shaders. tests/command/dialects.sh draws a shader of each dialect.
#
# A shader that checks its inputs is white if the inputs have the right values, and black otherwise.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh

open_scratch
unset DISPLAY WAYLAND_DISPLAY
program=$BUILD/01_normal_colouring
size=(-s 48x27)

# draw NAME OPTION...: renders $scratch/NAME.frag into NAME.png, and sets $said to the messages.
draw() {
    local name=$1
    shift
    said=$("$program" -f "$scratch/$name.frag" "${size[@]}" -o "$scratch/$name.png" "$@" 2>&1)
}
same() { cmp -s "$scratch/$1.png" "$scratch/$2.png"; }

# is_white NAME TITLE [OPTION...] <TEXT: the picture must be white, and there must be no message.
is_white() {
    local name=$1 title=$2
    shift 2
    cat >"$scratch/$name.frag"
    if draw "$name" "$@" && [ -z "$said" ] && same "$name" white; then ok "$title"; else not_ok "$title" "$(tr '\n' ' ' <<<"$said")"; fi
}

# refused NAME PATTERN TITLE <TEXT: the run must fail with status 1 and a message that matches the pattern, and leave no
# picture.
refused() {
    cat >"$scratch/$1.frag"
    draw "$1"
    local status=$?
    if [ "$status" = 1 ] && [[ $said =~ $2 ]] && [ ! -e "$scratch/$1.png" ]; then ok "$3"; else not_ok "$3" "status $status: $(tr '\n' ' ' <<<"$said")"; fi
}

head='void mainImage(out vec4 c, vec2 p)'
printf '%s { c = vec4(1.0); }\n' "$head" >"$scratch/white.frag"
printf '%s { c = vec4(0.0); }\n' "$head" >"$scratch/black.frag"
check 'a white and a black picture are drawn, and differ' eval 'draw white && draw black && ! same white black'

# ---- Inputs ----

is_white report "the inputs of the report's engine have the right values" -c 1,2,3,90,0 -t 1.5 <<'GLSL'
#version 330 core
in float Time, fovValue, FacteurLargeur, OrthoView, CustomToggle, CustomInt; in vec2 FragCoord;
in vec3 CamPos, Ex, Ey, Ez; // right, up, forward
out vec4 c;
bool near(vec3 a, vec3 b) { return length(a - b) < 1e-5; }
void main() {
    c = vec4(Time == 1.5 && near(CamPos, vec3(1, 2, 3)) && near(Ex, vec3(0, 0, 1)) && near(Ey, vec3(0, 1, 0)) &&
        near(Ez, vec3(1, 0, 0)) && fovValue > 0.0 && abs(FacteurLargeur - 48.0 / 27.0) < 1e-5 && OrthoView == 0.0 &&
        CustomToggle == 0.0 && CustomInt == 0.0 && near(vec3(FragCoord, 0), vec3((2.0 * gl_FragCoord.xy - vec2(48, 27)) / 27.0, 0)));
}
GLSL
is_white inputs "Shadertoy's inputs have the right values in a file, without a mouse or a clock" -t 1.5 <<GLSL
$head {
    c = vec4(iResolution == vec3(48, 27, 1) && iTime == 1.5 && iTimeDelta == 0.0 && iFrame == 0 && iFrameRate == 60.0 &&
        iMouse == vec4(0) && iDate == vec4(1970, 0, 1, 1.5) &&
        fract(p) == vec2(0.5) && p == gl_FragCoord.xy && all(lessThan(p, iResolution.xy)));
}
GLSL
mkdir "$scratch/lib"
printf '%s\n' 'uniform float time;' 'bool near(float a, float b) { return abs(a - b) < 1e-5; }' >"$scratch/lib/near.glsl"
is_white parted 'the inputs of a file that includes a part of its own have the right values' -t 1.5 <<'GLSL'
uniform vec2 resolution;
#include "lib/near.glsl"
void main() { gl_FragColor = vec4(near(time, 1.5) && resolution == vec2(48, 27)); }
GLSL
as_written() { # TEXT: true if a variant of the scene looks like the original
    printf '%s' "$1" >"$scratch/changed.frag"
    draw changed && [ -z "$said" ] && same changed scene
}
scene="$head
{
    float t = length(p / iResolution.y); // a scene
    c = vec4(t, 0.5, 0.2, 1.0);
}
"
printf '%s' "$scene" >"$scratch/scene.frag" && draw scene
check "Windows' line endings do not change the picture" as_written "${scene//$'\n'/$'\r\n'}"
check 'a byte-order mark does not change the picture' as_written $'\357\273\277'"$scene"
check 'tabs do not change the picture' as_written "${scene//    /$'\t'}"
check 'comments in Latin-1 and UTF-8 do not change the picture' as_written $'// caf\xe9, \xc3\xa9t\xc3\xa9, \xe2\x88\x9e : c\'est une "scene"\n'"$scene"

# A discarded pixel is black, whatever the previous picture was. All pixels of the second of two frames are discarded.
discards() {
    printf '#version 330 core\nin float Time; out vec4 c; void main() { if (Time > 0.5) discard; c = vec4(1.0); }\n' >"$scratch/discard.frag"
    "$program" -f "$scratch/discard.frag" "${size[@]}" --frames 2 --fps 1 -o "$scratch/discard-%d.png" && same discard-0 white && same discard-1 black
}
check 'a pixel that a shader discards is black' discards
rate() {
    printf '%s { c = vec4(iFrameRate == 25.0); }\n' "$head" >"$scratch/rate.frag"
    "$program" -f "$scratch/rate.frag" "${size[@]}" --frames 2 --fps 25 -o "$scratch/rate-%d.png" && same rate-0 white && same rate-1 white
}
check 'iFrameRate is the frame rate of a film, from the first picture on' rate
piped() {
    said=$("$program" -f <(cat "$scratch/rate.frag") -o "$scratch/piped.png" 2>&1)
    [ $? = 1 ] && [[ $said =~ a\ pipe,\ which\ can\ be\ read\ only\ once ]]
}
[ "${SYSTEM-}" = Windows ] || [ ! -e /dev/fd ] || check 'a shader from a pipe is refused, with the reason' piped

# ---- Textures from --channel ----

# A texture is upright and repeated, and its values are not converted from sRGB. The upper row of this texture is white.
echo "$head { c = vec4(step(1.0, p.y)); }" >"$scratch/rows.frag"
"$program" -f "$scratch/rows.frag" -s 2x2 -o "$scratch/rows.png"
reads='texture(iChannel0, vec2(0.2, 0.75)).rgb == vec3(1) && texture(iChannel0, vec2(0.7, 0.25)).rgb == vec3(0) &&
    texture(iChannel0, vec2(-7.2, 5.75)).r == 1.0 && texture(iChannel0, vec2(9.7, -2.75)).r == 0.0 &&
    abs(texture(iChannel0, vec2(0.5)).r - 0.5) < 0.003 && abs(textureLod(iChannel0, vec2(0.1), 1.0).r - 0.5) < 0.003 &&
    iChannelResolution[0] == vec3(2, 2, 1) && iChannelResolution[3] == vec3(64, 4096, 1) && iChannelResolution[1] == vec3(0) &&
    texture(iChannel3, vec2(0.0)).r < 2.0'
channels=(--channel "0=$scratch/rows.png" --channel "3=shaders/textures/noise.png")
is_white channel "the channels of Shadertoy's dialect have the right values" "${channels[@]}" <<<"$head { c = vec4($reads); }"
is_white channel_whole 'the channels of a file with its own main have the right values' "${channels[@]}" <<GLSL
#version 330 core
uniform sampler2D iChannel0, iChannel3; uniform vec3 iChannelResolution[4];
out vec4 c;
void main() { c = vec4($reads); }
GLSL

reads_both='texture(wood, vec2(0.2, 0.75)).r == 1.0 && texture(wood, vec2(0.7, 0.25)).r == 0.0 && texture(sky, vec2(0.2, 0.75)).r == 1.0'
whole="uniform sampler2D none, wood, sky; void main() { gl_FragColor = vec4($reads_both); }"
is_white sampler_channel 'samplers of any name take the channels in their order' --channel "1=$scratch/rows.png" --channel "2=$scratch/rows.png" <<<"$whole"
is_white sampler_texture 'samplers of any name take --texture' --texture "wood=$scratch/rows.png" --texture "sky=$scratch/rows.png" <<<"$whole"
is_white toy_texture '--texture also names a channel of Shadertoy' --texture "iChannel1=$scratch/rows.png" \
    <<<"$head { c = vec4(texture(iChannel1, vec2(0.2, 0.75)).r == 1.0 && iChannelResolution[1].xy == vec2(2)); }"
is_white local_name 'a local variable may have the name of a channel of another tool' "${channels[@]}" <<GLSL
$head { vec4 texture0 = texture(iChannel0, vec2(0.2, 0.75)), texture3 = texture(iChannel3, vec2(0)); c = vec4(texture0.r == 1.0 && texture3.r < 2.0); }
GLSL
is_white same_channel 'one picture has the names of two tools' --channel "1=$scratch/rows.png" <<<"$head { c = texture(iChannel1, vec2(0.2, 0.75)) * texture(texture1, vec2(0.2, 0.75)); }"

# Samplers of three types are black side by side.
blacks() {
    cat >"$scratch/blacks.json" <<'JSON'
[{"renderpass":[{"inputs":[{"channel":0,"ctype":"volume"},{"channel":1,"ctype":"cubemap"},{"channel":3,"ctype":"music"}],"type":"image",
"code":"void mainImage(out vec4 c, vec2 p) { c = vec4(texture(iChannel0, vec3(0.5)) + textureLod(iChannel1, vec3(1), 0.0) + texture(iChannel2, p) + texelFetch(iChannel3, ivec2(0), 0) == vec4(0, 0, 0, 4)); }"}]}]
JSON
    said=$("$program" -f "$scratch/blacks.json" "${size[@]}" -o "$scratch/blacks.png" 2>&1) && same blacks white && [ "$(grep -c 'warning: .* black' <<<"$said")" = 4 ]
}
check 'a volume, a cube map, a sound and a channel without a picture are black, with a warning each' blacks

# ---- Huge and malformed text ----

# The time to read a shader must be proportional to its length. If it is not, the suite hangs, and tests/run ends it.
crowd() { # FORMAT: true if a shader after 30,000 lines of this format is white; %d is the line's number
    local i
    { for i in {1..30000}; do printf '%s\n' "${1//%d/$i}"; done; cat "$scratch/white.frag"; } >"$scratch/crowd.frag"
    draw crowd && same crowd white
}
check 'a shader with thirty thousand uniforms is drawn' crowd 'uniform float u%d;'
check 'a shader with thirty thousand #ifdef lines is drawn' crowd $'#ifdef A%d\nfloat a%d;\n#endif'

MESA_GL_VERSION_OVERRIDE=3.3 MESA_GLSL_VERSION_OVERRIDE=330 refused version 'version.frag:1: #version 430: this driver does not have it: write #version 330$' \
    'a version that the driver does not have is refused' <<<"#version 430
out vec4 c; void main() { c = vec4(1.0); }"
malformed() { # DIALECT BEGINNING
    local name=malformed_$1
    refused "$name" 'never closed: write \*/ at its end$' "$1: a comment that is not closed is refused" < <(printf '%s\n/*' "$2"; cat "$scratch/white.frag")
    refused "$name" 'larger than 1 MiB: is it a shader\?$' "$1: a file of 10 MB is refused" < <(printf '%s\n' "$2"; head -c 10000000 /dev/zero | tr '\0' ' ')
    refused "$name" 'an array of 2000000000 elements: ' "$1: a huge array is refused" < <(printf '%s\nfloat big[ 2000000000 ];\n' "$2")
    refused "$name" '\.\.\.$' "$1: of a line with 100000 parentheses, only the beginning is shown" < <(printf '%s\nfloat deep = %s1.0%s;\n' "$2" "$deep" "$close")
    refused "$name" 'and [0-9]* more$' "$1: of 99 errors, only the first are shown" < <(printf '%s\n' "$2"; for i in {1..99}; do echo "float e$i = none$i;"; done)
    refused "$name" 'does not|never|error' "$1: binary data is refused" < <(printf '%s\n' "$2"; head -c 3000 "$program" | tr -d '\0')
}
deep=$(printf '%100000s' '' | tr ' ' '(') close=$(tr '(' ')' <<<"$deep")
malformed course '#include "main.glsl"'
malformed whole $'#version 330 core\nvoid main() {}'
malformed toy "$head {}"
# A sum of 40,000 terms uses up the stack of some drivers' compilers; other drivers render it.
endures() {
    printf '%s { c = vec4(p.x%s); }\n' "$head" "$(printf '%40000s' '' | sed 's/ /+p.x/g')" >"$scratch/sum.frag"
    (ulimit -s 4096; draw sum; [ $? = 1 ] && [[ $said =~ sum.frag:\ the\ graphics\ driver\ crashed\ on\ it ]] && [ "$(grep -c '' <<<"$said")" = 1 ]) || draw sum
}
check 'a sum of 40000 terms is drawn, or the crash of the driver is reported' endures

# A shader hides the size of its array, and the driver then requests all the memory at once. The request exceeds the
# limit for a driver, or the limit for the process if that is smaller. A sanitizer prints its own message when it ends a
# program that gets no memory.
bomb() { draw bomb; [ $? = 1 ] && [[ $said =~ bomb.frag:\ the\ graphics\ driver\ crashed\ on\ it,\ or\ needs\ more ]] && [ "$(grep -c '' <<<"$said")" = 1 ]; }
if [ "$BUILD" = build ]; then
    printf '%s\n' 'const int N = 300000000;' 'float a[N * 4];' "$head { c = vec4(a[int(p.x)]); }" >"$scratch/bomb.frag"
    check 'constants that hide a huge array are reported' bomb
    limited() { (ulimit -v 3900000; bomb); } # less than the 4e9 bytes that the program allows each compilation
    check 'constants that hide a huge array are reported under the memory limit of the process' limited
fi
refused bomb 'bomb.frag:42: A40: this macro expands to more than 4 million' 'macros that double 40 times are refused' \
    < <(echo '#define A0 p.x'; for i in {1..40}; do echo "#define A$i A$((i - 1)) + A$((i - 1))"; done; echo "$head { c = vec4(A40); }")

# A KodeLife project is compressed.
printf 'x\332\263\000\001' >"$scratch/sketch.klproj"
names_kodelife() {
    said=$("$program" -f "$scratch/sketch.klproj" "${size[@]}" -o "$scratch/sketch.png" 2>&1)
    [ "$? $said" = "1 $scratch/sketch.klproj: a KodeLife project: copy its fragment shader from KodeLife into a file" ]
}
check 'a KodeLife project is named' names_kodelife
refused zeros 'zeros.frag: contains a zero byte' 'another file with a zero byte is refused' < <(printf 'void\000main')

# ---- make play ----

mkdir "$scratch/project" && cp -r Makefile .make chapters shaders "$scratch/project" && ln -s "$root/$BUILD" "$scratch/project/build"
play() { (cd "$scratch/project" && FILE=${1-} .make/play.sh "${@:2}" >"$scratch/out" 2>"$scratch/err"); }
copies() { play '' -o "$scratch/play.png" "${size[@]}" && cmp -s "$scratch/project/chapters/play.frag" chapters/first_steps/play.frag; }
check 'make play creates chapters/play.frag' copies
keeps() {
    echo '// mine' >>"$scratch/project/chapters/play.frag"
    play '' -o "$scratch/play.png" "${size[@]}" && tail -n 1 "$scratch/project/chapters/play.frag" | grep -q mine
}
check 'make play keeps an existing file' keeps
opens() { play "$scratch/scene.frag" -o "$scratch/opened.png" "${size[@]}" && same opened scene; }
check 'make play FILE opens a file' opens
missing() { ! play nowhere.frag && grep -q 'nowhere.frag: no such file' "$scratch/err" && [ ! -e "$scratch/project/nowhere.frag" ]; }
check 'make play FILE says that a file is missing' missing

# ---- make bake, whose program is not built for Windows ----

if [ "$BUILD" = build ]; then
    printf '%s\n' 'v -1 0 -1' 'v 1 0 -1' 'v 1 0 1' 'v -1 0 1' 'v 0 1.5 0' 'f 1 2 3 4' 'f 2 1 5' 'f 3 2 5' 'f 4 3 5' 'f 1 4 5' >"$scratch/pyramid.obj"
    baked=$scratch/project/build/pyramid.png
    bake() { (cd "$scratch/project" && MESH=${1-} .make/bake.sh -o "$scratch/baked.png" "${size[@]}" >"$scratch/out" 2>"$scratch/err"); }
    shows_mesh() {
        bake "$scratch/pyramid.obj" && build/23_stored_distances "${size[@]}" --texture "grid=$baked" --set eyes=false -o "$scratch/pyramid.png" &&
            same baked pyramid && build/23_stored_distances "${size[@]}" -o "$scratch/elephant.png" && ! same baked elephant
    }
    check 'make bake shows a mesh' shows_mesh
    heeds() { # the window ends at a signal
        # shellcheck disable=SC2016 # the substitute expands the variable
        printf '#!/bin/sh\nkill -TERM $$\necho ignored\n' >"$scratch/project/.make/run.sh"
        { bake "$scratch/pyramid.obj"; } 2>/dev/null
        cp .make/run.sh "$scratch/project/.make/"
        grep -q '^written' "$scratch/out" && ! grep -q ignored "$scratch/out"
    }
    check 'the window of make bake ends at a signal' heeds
    refuses_hole() {
        cp "$baked" "$scratch/before.png" && sed -i.old '$d' "$scratch/pyramid.obj" && ! bake "$scratch/pyramid.obj" &&
            grep -q 'not closed' "$scratch/err" && cmp -s "$baked" "$scratch/before.png" && [ ! -e "$baked.new" ]
    }
    check 'make bake refuses a mesh with a hole, and keeps the earlier picture' refuses_hole
    rm -f "$baked"
fi

# If no window can be opened, the scripts report this and render to files instead; commands that need no window still
# work.
runs() { (cd "$scratch/project" && .make/run.sh "$@" >"$scratch/out" 2>"$scratch/err"); }
gallery() { # NAME
    [ "$(cat "$scratch/out")" = "$(printf 'No window can be opened here: rendering into files instead.\n  build/gallery/%s.png' "$1")" ] &&
        [ "$(grep -c '' "$scratch/err")" = 1 ] && [ -s "$root/$BUILD/gallery/$1.png" ]
}
check 'make play renders to a file if the display is gone' eval "DISPLAY=:4321 WAYLAND_DISPLAY='' play '' \"\${size[@]}\" && gallery play"
check 'make run renders to a file if the display is gone' eval "DISPLAY=:4321 WAYLAND_DISPLAY='' CHAPTER=3 runs \"\${size[@]}\" && gallery 03_shadows"
check 'make run renders to a file if the compositor is gone' \
    eval "DISPLAY='' WAYLAND_DISPLAY=nowhere XDG_RUNTIME_DIR=\$scratch CHAPTER=3 runs \"\${size[@]}\" && gallery 03_shadows"
check 'make run can run a benchmark without a display' eval "DISPLAY='' WAYLAND_DISPLAY='' runs --benchmark 1 \"\${size[@]}\" && grep -q '^shader  *00_' \"\$scratch/out\""
refuses() { runs -p nothing=1; [ $? = 2 ] && [ ! -s "$scratch/out" ] && [ "$(grep -c '' "$scratch/err")" = 1 ]; }
check 'make run refuses an unknown parameter' refuses
refuses_small() { ! make -n run chapter=03 >/dev/null 2>"$scratch/err" && [ "$(grep -c 'capitals.*CHAPTER=03' "$scratch/err")" = 1 ]; }
check 'make refuses a name in small letters' refuses_small

# ---- The course's own shaders, printed ----

# The output of --print-shader renders the same picture as the chapter, with the same parameters and views.
printed() { # OPTION...
    "$program" --print-shader >"$scratch/printed.frag" &&
        "$program" "${size[@]}" -o "$scratch/chapter.png" "$@" && draw printed "$@" && [ -z "$said" ] &&
        same chapter printed
}
check 'a printed chapter draws the same picture' printed -p biased=true
check 'a printed chapter draws the same view' printed -v steps

plan
