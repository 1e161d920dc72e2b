#!/bin/bash
# export.sh - tests --print-shader=shadertoy: it prints each shader as one file that Shadertoy would accept, and that
# renders the same picture here with --shader.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh
. tests/lib/shadertoy.sh

open_scratch
unset DISPLAY WAYLAND_DISPLAY
small=(-s 160x90)

# prints PROGRAM OPTION...: writes the exported file to $scratch/toy.frag.
prints() { "$@" --print-shader=shadertoy >"$scratch/toy.frag" 2>"$scratch/err"; }

# same PROGRAM OPTION...: true if the exported file renders the same picture as the shader. For the exported file, only
# the size and the time are given, because the file contains the values of the other options.
same() {
    local program=$1 numbers
    shift
    "$program" "$@" "${small[@]}" -t 1 -o "$scratch/own.png" 2>&1 | sed 's/^/# /'
    "$BUILD/00_first_scene" -f "$scratch/toy.frag" "${small[@]}" -t 1 -o "$scratch/toy.png" 2>&1 | sed 's/^/# /'
    numbers=$("$BUILD/tests/compare" "$scratch/own.png" "$scratch/toy.png") || { echo "# $numbers"; return 1; }
    worst=$(printf '%s\n' "$worst" "${numbers#F2 }" | sort -n | tail -n 1)
}
worst=0

# refused_textures PROGRAM OPTION...: true if nothing was printed, the shader reads at least one texture, and the only
# line on standard error names every texture that it reads.
refused_textures() {
    [ ! -s "$scratch/toy.frag" ] && [ "$(wc -l <"$scratch/err")" = 1 ] && "$@" --list >"$scratch/parts" &&
        grep -q '^texture ' "$scratch/parts" && sed '1,/^texture /d' "$scratch/parts" | while read -r _ file _; do
        grep -qF "$file" "$scratch/err" || exit 1
    done
}

passes() { # NAME PROGRAM OPTION...: true if a file was printed and is valid
    local name=$1
    shift
    if prints "$@"; then
        check "the export of $name is valid for Shadertoy" valid "$scratch/toy.frag"
    else
        check "the export of $name is refused, because the shader reads textures" refused_textures "$@" || sed 's/^/# /' "$scratch/err"
        return 1
    fi
}
exported() { # NAME PROGRAM OPTION...
    passes "$@" && check "the export of $1 looks the same" same "${@:2}"
}

# fits_a_page PROGRAM OPTION...: true if the file for a page is valid, and its parameters are the shader's.
fits_a_page() {
    "$@" --print-shader=page >"$scratch/page.frag" && valid "$scratch/page.frag" && "$@" --list | sed '1d; /^$/,$d' | while read -r name _; do
        grep -q "^uniform *[a-z0-9]* *$name;" "$scratch/page.frag" || { echo "# $name is no uniform"; exit 1; }
    done
}

# An exported file has no coarse pass, and a picture that shows steps would reveal this. The chapter is therefore
# rendered without the coarse pass too.
for program in "$BUILD"/[0-9][0-9]_*; do
    if [ ! -x "$program" ] || [ ! -f "$program" ]; then continue; fi
    options=()
    "$program" --list | grep -q '^coarsePass ' && options=(-p coarsePass=false)
    exported "$(basename "$program")" "$program" ${options[@]+"${options[@]}"}
done
for file in chapters/first_steps/[!e]*.frag; do
    exported "${file#chapters/}" "$BUILD/01_normal_colouring" -f "$file"
done
exported 'parameters of every type' "$BUILD/01_normal_colouring" -p biased=true -p maxSteps=40 -p focalLength=1.5 -p normalStep=1e-2
exported 'a colour' "$BUILD/02_lighting" -p lampColour=0.5,1,0
exported 'a camera' "$BUILD/01_normal_colouring" -c 0,1,5,10,-10

{
    cat chapters/01_normal_colouring.frag
    printf 'vec3 part() { return vec3(gl_FragCoord.xy + iPixelOffset, VIEW); }\n'
} | sed 's/return SKY;/return part() * 0.001;/; s/^vec3 rayColour/vec3 part();\n&/' >"$scratch/part.frag"
exported 'a shader that itself reads the position of a pixel' "$BUILD/01_normal_colouring" -f "$scratch/part.frag"

exported 'a shader with a coarse pass' "$BUILD/01_normal_colouring" -f tests/shaders/coarse.frag -p coarsePass=false
# The exports of experiments and solutions are validated, but not rendered. Under Wine, where programs start slowly,
# only those of chapter 03 are validated.
for file in chapters/experiments/*.frag chapters/solutions/*.frag; do
    case ${SYSTEM-}$file in Windows*/03_*) ;; Windows*) continue ;; esac
    passes "${file#chapters/}" "$BUILD/01_normal_colouring" -f "$file"
done
# Shadertoy's digits are not those of the font, so figures that write numbers are validated, and the others rendered too.
for file in chapters/figures/*.frag; do
    case ${SYSTEM-}$file in Windows*/03_*) ;; Windows*) continue ;; esac
    check "the export of ${file#chapters/} for a page is valid" fits_a_page "$BUILD/01_normal_colouring" -f "$file"
    if grep -q 'number(' "$file"; then
        passes "${file#chapters/}" "$BUILD/01_normal_colouring" -f "$file"
    else
        exported "${file#chapters/}" "$BUILD/01_normal_colouring" -f "$file"
    fi
done

# These files with their own main have spellings that the chapters do not use.
printf '%s\n' '#version 330 core // comments with main, in and out' 'smooth in vec2 FragCoord; in highp float Time;' \
    'in vec3 Ex, Ey, Ez, CamPos; in float fovValue, FacteurLargeur, OrthoView, CustomToggle, CustomInt;' \
    'layout(location = 0) out mediump vec4 toy;' 'void grow(in float a, inout float b, out float c) { b += a; c = b; }' \
    'void mainImage(out vec4 a, in vec2 b) { a = b.xyxy; }' \
    'void main(void) { vec4 c; float a = fovValue, b; grow(a, a, b); c = vec4(a + OrthoView + CustomToggle + CustomInt, FragCoord, b);' \
    'toy = vec4(c.xyz * 0.3 + 0.1 * Ex + 0.2 * Ey - 0.1 * Ez + CamPos * 0.01 + Time * 0.01 + FacteurLargeur * 0.1, 0.0); }' >"$scratch/whole.frag"
exported 'every input of a file with its own main' "$BUILD/01_normal_colouring" -f "$scratch/whole.frag"
printf '%s\n' '# version 330' 'precision mediump float;' 'layout(location = 1) in vec2 FragCoord; flat in int CustomInt, CustomToggle;' \
    'uniform float iTime; uniform float radius = 0.5; uniform sampler2D none;' 'layout(location = 1) out vec4 other; layout(location = 0) out vec4 shown;' \
    'void main() { shown = vec4(FragCoord * 0.37, radius + iTime * 0.1 + float(CustomInt + CustomToggle), 1.0); other = vec4(1.0); }' >"$scratch/placed.frag"
exported 'locations, initial values and inputs in other spellings' "$BUILD/01_normal_colouring" -f "$scratch/placed.frag"
printf '#version 120\nvarying vec2 FragCoord; void main() { gl_FragColor = vec4(FragCoord * 0.37, 0.5, 1.0); }\n' >"$scratch/old.frag"
exported 'gl_FragColor' "$BUILD/01_normal_colouring" -f "$scratch/old.frag"
printf '#version 330 core\nvoid main() { gl_FragDepth = 0.0; }\n' >"$scratch/none.frag"
none() { ! "$BUILD/01_normal_colouring" --print-shader=shadertoy -f "$scratch/none.frag" >"$scratch/toy.frag" 2>"$scratch/err" && [ ! -s "$scratch/toy.frag" ] && grep -q 'none.frag: no output' "$scratch/err"; }
check 'the export of a file without an output is refused' none
printf 'void mainImage(out vec4 c, vec2 p) { c = vec4(1.0); } // toy\n' >"$scratch/given.frag"
stays() { "$BUILD/01_normal_colouring" --print-shader=shadertoy -f "$scratch/given.frag" | cmp -s - "$scratch/given.frag"; }
check "a Shadertoy file is printed unchanged" stays
printf '#include "%s"\nuniform sampler2D a; // "granite.png" sRGB repeat: stone\nuniform sampler3D n; // "noise.png" linear repeat 64: noise\n' \
    01_normal_colouring.frag >"$scratch/stone.frag"
reads_both() {
    ! prints "$BUILD/01_normal_colouring" -f "$scratch/stone.frag" && refused_textures "$BUILD/01_normal_colouring" -f "$scratch/stone.frag" &&
        grep -q 'stone.frag: reads shaders/textures/granite.png, shaders/textures/noise.png: Shadertoy accepts no files' "$scratch/err"
}
check 'the export of a shader that reads textures is refused, and the textures are named' reads_both
printf '%s\n' '#version 330 core' 'uniform sampler2D iChannel0; uniform vec3 iChannelResolution[4];' 'in vec2 FragCoord; out vec4 c;' \
    'void main() { c = texture(iChannel0, 0.3 * FragCoord) * min(iChannelResolution[0].x, 1.0); }' >"$scratch/channel.frag"
{
    printf '#include "main.glsl"\nuniform sampler2D history; // the last frame\nuniform sampler2D a; // "granite.png" sRGB repeat: x\n'
    printf 'Ray pixelRay(vec2 s) { return Ray(vec3(s, 0.0), vec3(0.0, 0.0, -1.0)); }\nfloat sceneDistance(vec3 p) { return p.z; }\n'
    printf 'vec4 frameKept(vec2 p) { return texelFetch(history, iPixel, 0) + texelFetch(a, iPixel, 0); }\n'
    printf 'vec3 rayColour(Ray ray) { return texelFetch(history, iPixel, 0).rgb; }\n'
} >"$scratch/kept.frag"
keeps() {
    ! prints "$BUILD/01_normal_colouring" -f "$scratch/kept.frag" && refused_textures "$BUILD/01_normal_colouring" -f "$scratch/kept.frag" &&
        grep -q 'reads the last frame, shaders/textures/granite.png: .*an export has no buffers' "$scratch/err" &&
        ! "$BUILD/01_normal_colouring" -f "$scratch/kept.frag" --print-shader=page >"$scratch/page.frag" 2>"$scratch/err" &&
        [ ! -s "$scratch/page.frag" ] && grep -q 'kept.frag: reads the last frame: a page' "$scratch/err"
}
check 'the export of a shader that reads the last frame is refused' keeps

buffers() {
    ! prints "$BUILD/01_normal_colouring" -f tests/shaders/buffers/AB.json && [ ! -s "$scratch/toy.frag" ] &&
        grep -q 'AB.json: has several passes' "$scratch/err"
}
check 'the export of several passes is refused' buffers

channel=(--channel "0=shaders/textures/granite.png")
same_channel() {
    "$BUILD/01_normal_colouring" -f "$scratch/channel.frag" "${channel[@]}" "${small[@]}" -o "$scratch/own.png" &&
        "$BUILD/01_normal_colouring" -f "$scratch/toy.frag" "${channel[@]}" "${small[@]}" -o "$scratch/toy.png" &&
        "$BUILD/tests/compare" "$scratch/own.png" "$scratch/toy.png" >/dev/null
}
passes 'a file with its own main and a channel' "$BUILD/01_normal_colouring" -f "$scratch/channel.frag" "${channel[@]}" &&
    check 'the export of a file with its own main and a channel looks the same' same_channel
printf '%s\n' 'uniform sampler2D stone;' 'uniform vec2 resolution;' 'void main() { gl_FragColor = texture2D(stone, gl_FragCoord.xy / resolution); }' >"$scratch/channel.frag"
passes 'a file with a sampler of its own' "$BUILD/01_normal_colouring" -f "$scratch/channel.frag" "${channel[@]}" &&
    check 'the export of a file with a sampler of its own looks the same' same_channel
named() {
    local name=$scratch/$'two\nlines.frag'
    cp chapters/01_normal_colouring.frag "$name"
    "$BUILD/01_normal_colouring" --print-shader=shadertoy -f "$name" >"$scratch/toy.frag" && head -n 1 "$scratch/toy.frag" | grep -q '^// two?lines.frag for' &&
        ! grep -q '^lines' "$scratch/toy.frag"
}
if [ "${SYSTEM-}" = Windows ]; then
    skip "a line break in a shader's name does not end the comment" 'no file name contains a line break'
else
    check "a line break in a shader's name does not end the comment" named
fi
echo "# the largest difference between two pictures: F2 $worst"
plan
