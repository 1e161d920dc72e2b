#!/bin/bash
# failures.sh - tests runs that must fail: each prints one clear line on standard error, exits with the right status (1
# if the run failed, 2 if the command line is wrong, 3 if no window can be opened), and leaves no half-written file.
# This suite runs one case of each kind as a process; tests/command/options.c and tests/unit (source, dialect, sampler,
# parameter, image) test the others.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh
. tests/lib/refuse.sh

open_scratch
chmod 755 "$scratch"
open_out
shaders=$scratch/shaders # the folder for faulty shader files
mkdir "$shaders"
chapter=$root/$BUILD/03_shadows
unset DISPLAY WAYLAND_DISPLAY
copy_program() { # FOLDER
    if windows; then
        cp build/windows/03_shadows.exe build/windows/*.dll "$1"
        printf '#!/bin/sh\nexec %s "%s" "$@"\n' "${loader-}" "$1/03_shadows.exe" >"$1/03_shadows" && chmod +x "$1/03_shadows"
    else
        cp "$chapter" "$1"
    fi
}

# succeed NAME COMMAND...: the command must exit with status 0 and print nothing on standard error.
succeed() {
    local name=$1
    shift
    run "$@"
    if [ "$status" = 0 ] && [ "$said" = 0 ]; then
        ok "$name"
    else
        not_ok "$name" "status $status $(tr '\n' ' ' <"$scratch/stderr")"
    fi
}

# True if a file begins and ends like a PNG and is not a link.
is_picture() { # FILE
    [ "$(head -c 4 "$1" | tail -c 3)" = PNG ] && [ "$(tail -c 8 "$1" | head -c 4)" = IEND ] &&
        [ ! -L "$1" ]
}

small=(-s 16x9)
to=(-o "$out/new.png" "${small[@]}")

# ---- The command line and parameters ----

refuse 'a value out of range' 2 "--size" "$chapter" -o "$out/new.png" --size 99999x99999
refuse 'an unknown option' 2 "'--colour'" "$chapter" "${to[@]}" --colour red
# A step beyond the last step of the middle pixel's march cannot be shown.
last_step=$("$chapter" "${small[@]}" --probe 8,4 | awk -F, '/^[0-9]/ { n = $1 } END { print n }')
refuse 'a step just beyond the last step' 1 "the march of pixel 8,4 has $((last_step + 1)) steps" \
    "$chapter" "${to[@]}" -v slice --step $((last_step + 1))
refuse 'an unknown parameter' 2 'lampHeigth.*lampHeight' "$chapter" "${to[@]}" -p lampHeigth=2
refuse 'an unknown parameter without a display' 2 'lampHeigth' "$chapter" -p lampHeigth=2
for action in --list --print-shader=shadertoy; do
    refuse "an unknown parameter with $action" 2 'lampHeigth' "$chapter" $action -p lampHeigth=2
done
refuse 'a parameter that is set for a shader without parameters' 2 'sun' "$root/$BUILD/00_first_scene" "${to[@]}" -p sun=1

clay=$root/$BUILD/23_stored_distances
refuse 'a stroke without points' 2 "--stroke '0.09': must be AMOUNT,X,Y,Z" "$clay" "${to[@]}" --stroke 0.09
refuse 'a stroke with an incomplete point' 2 "--stroke '0.09,1,2': must be AMOUNT,X,Y,Z" "$clay" "${to[@]}" --stroke 0.09,1,2
refuse 'a stroke that is too thick' 2 '--stroke 0.5,...: the amount must be between -0.2 and 0.2' "$clay" "${to[@]}" --stroke 0.5,1,2,3
refuse 'a stroke in a chapter without a tool' 2 '--stroke: 03_shadows has no tool; chapter 23 has one' "$chapter" "${to[@]}" --stroke 0.1,1,2,3
refuse 'a stroke on another shader' 2 "--stroke: .* lacks the sampler 'grid'" "$clay" "${to[@]}" --stroke 0.1,1,2,3 -f "$root/chapters/figures/23_sign.frag"
refuse 'a stroke on a grid of another size' 1 'a stroke needs a volume of 64x64x64 texels' \
    "$clay" "${to[@]}" --stroke 0.1,1,2,3 --texture grid="$root/shaders/textures/clouds_fair.png"

# ---- Shader files ----

good=$root/chapters/01_normal_colouring.frag
whole=$root/chapters/00_first_scene.frag
refuse 'a missing shader' 1 'nowhere.frag.*No such file' "$chapter" "${to[@]}" -f "$shaders/nowhere.frag"
refuse 'a missing shader with --list' 1 'nowhere.frag' "$chapter" --list -f "$shaders/nowhere.frag"
printf 'void mainImage(out vec4 c, in vec2 f) { c = texture(iChannel1, f); }\n' >"$shaders/toy.frag"
refuse 'a channel that a shader does not mention' 2 '--channel 0=.*iChannel0' \
    "$chapter" "${to[@]}" --channel 0=shaders/textures/granite.png --channel 1=shaders/textures/granite.png -f "$shaders/toy.frag"
cp shaders/textures/noise.png "$out/stone.png"
expected_listing='./old.png ./stone.png ' keep=1
refuse 'an output that is also a channel' 1 "stone.png, which this run reads" \
    "$chapter" --channel 1="$out/stone.png" -f "$shaders/toy.frag" -o "$out/stone.png"
printf '#include "03_shadows.frag"\nuniform sampler2D stone; // "granite.png" sRGB repeat: grey\n' >"$shaders/stone.frag"
refuse 'an output that is also given with --texture' 1 "stone.png, which this run reads" \
    "$chapter" --texture stone="$out/stone.png" -f "$shaders/stone.frag" -o "$out/stone.png"
same_noise() { cmp -s shaders/textures/noise.png "$out/stone.png"; }
check 'a texture that is given as the output is unchanged' same_noise
expected_listing='./old.png ' keep=''
fill
refuse 'a view that only shaders in another dialect have' 1 '00_first_scene.frag' "$chapter" "${to[@]}" -v depth -f "$whole"
printf '#include "part.glsl"\n#include "main.glsl"\n' >"$shaders/i.frag"
printf '// a comment\nfloat halved(float x)\n{\n    return 0.5 * y;\n}\n' >"$shaders/part.glsl"
refuse_at_length 'an undeclared name in an included file' 1 'part.glsl:4.*y' "$chapter" "${to[@]}" -f "$shaders/i.frag"
if windows; then
    skip 'an error in a file with a line break in its name is reported' 'no file name contains a line break'
else
    sed 's/FragColor = /FragColour = /' "$whole" >"$shaders/"$'new\nline.frag'
    refuse_at_length 'an error in a file with a line break in its name' 1 'new?line.frag:[0-9]*.*FragColour' \
        "$chapter" "${to[@]}" -f "$shaders"/$'new\nline.frag'
fi
refuse 'a --root folder without shaders' 1 '--root' "$chapter" "${to[@]}" --root "$shaders"
mkdir "$scratch/alone"
copy_program "$scratch/alone"
refuse 'a program outside the folder of the project' 1 '--root' "$scratch/alone/03_shadows" "${to[@]}"
mkdir -p "$scratch/empty root/shaders"
: >"$scratch/empty root/shaders/screen.vert"
refuse 'a project with an empty vertex shader' 1 'screen.vert.*empty' \
    "$chapter" "${to[@]}" --root "$scratch/empty root" -f "$whole"

# ---- The location of the picture ----

refuse 'a missing folder for the output, and not the error in the shader,' 1 'folder.*nowhere' \
    "$chapter" "${small[@]}" -o "$out/nowhere/new.png" -f "$shaders/i.frag"

# A picture never replaces a file that the run reads: the shader itself, an included file, the target of a symbolic
# link, a hard link, or one picture of a sequence.
printf '#include "part.png"\n' >"$out/read.png"
cat "$good" >"$out/part.png"
ln -s read.png "$out/link.png"
ln "$out/part.png" "$out/hard.png"
ln "$out/part.png" "$out/row-1.png"
expected_listing='./hard.png ./link.png ./old.png ./part.png ./read.png ./row-1.png '
kept() { cmp -s "$out/part.png" "$good" && [ -L "$out/link.png" ] && grep -q part "$out/read.png"; }
for name in read part link hard row-%d; do
    frames=()
    [ "$name" = row-%d ] && frames=(--frames 3)
    keep=1 refuse "an output to $name.png, which would replace a file that is read," 1 "which this run reads" \
        "$chapter" "${small[@]}" "${frames[@]}" -f "$out/read.png" -o "$out/$name.png"
    check "an output to $name.png leaves the files that are read unchanged" kept
done
expected_listing='./old.png '
fill
cp -R "$root/shaders" "$scratch/library"
mkdir "$scratch/course" && mv "$scratch/library" "$scratch/course/shaders"
ln -s "$scratch/course/shaders/screen.vert" "$out/vertex.png"
expected_listing='./old.png ./vertex.png '
refuse 'an output that is the vertex shader' 1 'screen.vert, which this run reads' \
    "$chapter" "${small[@]}" --root "$scratch/course" -f "$good" -o "$out/vertex.png"
expected_listing='./old.png '
fill

# ---- Contexts ----

# The shader cache is on a full disk. Only a user who may mount file systems can test this.
mkdir "$scratch/home"
full_cache() {
    # shellcheck disable=SC2016 # the inner shell expands the variables
    "${alone[@]}" bash -c 'mount -t tmpfs -o size=64k none "$0" && { cat /dev/zero >"$0/fill"; "$@"; }' \
        "$scratch/home" env MESA_SHADER_CACHE_DIR="$scratch/home" "$chapter" "${to[@]}" 2>&1 |
        grep -v 'No space left' >&2
    return "${PIPESTATUS[0]}"
}
for how in -m -rm; do
    alone=(unshare "$how")
    ! windows && "${alone[@]}" mount -t tmpfs none "$scratch/home" 2>/dev/null && break
    alone=()
done
if [ ${#alone[@]} = 0 ]; then
    skip 'a full disk for the shader cache is reported' 'this user may not mount file systems'
elif full_cache >/dev/null 2>&1; then
    ok 'a full disk for the shader cache does not stop the driver' # this driver renders without its cache
    fill
else
    refuse 'a full disk for the shader cache' 1 'MESA_SHADER_CACHE_DISABLE' full_cache
fi

if windows; then
    for name in 'a window without a display' 'glfw without a display'; do
        skip "$name is reported" 'Windows always has a display'
    done
else
    refuse 'a window without a display' 3 'display' "$chapter"
    refuse 'glfw without a display' 1 'glfw' "$chapter" "${to[@]}" -b glfw
fi
refuse 'a window requested with egl' 3 'egl' "$chapter" -b egl
refuse 'a window requested with osmesa' 3 'osmesa' "$chapter" -b osmesa
mkdir "$scratch/none"
no_egl=(env "__EGL_VENDOR_LIBRARY_DIRS=$scratch/none")
too_old=(env MESA_GL_VERSION_OVERRIDE=3.2)
if "$chapter" --version -b egl >/dev/null 2>&1; then
    refuse 'an EGL that cannot start' 1 'egl' "${no_egl[@]}" "$chapter" "${to[@]}" -b egl
    refuse 'an EGL that cannot start, with --version,' 1 'egl' "${no_egl[@]}" "$chapter" --version -b egl
    refuse 'egl: a driver that refuses OpenGL 3.3' 1 'egl' "${too_old[@]}" "$chapter" "${to[@]}" -b egl
else
    skip 'an EGL that cannot start is reported' 'this machine has no EGL'
fi
if "$chapter" --version -b osmesa >/dev/null 2>&1; then
    refuse 'osmesa: a driver that refuses OpenGL 3.3' 1 'osmesa' "${too_old[@]}" "$chapter" "${to[@]}" -b osmesa
    "$chapter" "${small[@]}" -o "$scratch/first.png"
    succeed 'the next backend takes over from an EGL that cannot start' \
        "${no_egl[@]}" "$chapter" "${to[@]}"
    check 'the backend after EGL renders the same picture' cmp -s "$scratch/first.png" "$out/new.png"
    fill
else
    skip 'osmesa: a driver that refuses OpenGL 3.3 is reported' 'this machine has no OSMesa'
fi
says=refuse
windows && says=refuse_at_length # Wine's OpenGL library prints a message first
$says 'an unknown driver' 1 'driver' env GALLIUM_DRIVER=nonsense "$chapter" "${to[@]}"
tried='egl.*osmesa.*glfw'
grep -q -e '-DHAVE_OSMESA' "$BUILD/flags" || tried='egl.*glfw' # a backend that make did not find is not tried
windows && tried='glfw'
refuse 'the failure of every backend' 1 "$tried" "${too_old[@]}" "$chapter" "${to[@]}"
if windows || open_display; then
    refuse 'glfw: a driver that refuses OpenGL 3.3' 1 '3\.3.*glfw' "${too_old[@]}" "$chapter" "${to[@]}" -b glfw
    refuse 'a window: a driver that refuses OpenGL 3.3' 3 '3\.3' "${too_old[@]}" "$chapter"
    succeed 'glfw renders to a file' "$chapter" "${to[@]}" -b glfw
    fill
    close_display
    unset DISPLAY
else
    skip 'glfw: a driver that refuses OpenGL 3.3 is reported' 'Xvfb is missing, or did not start'
fi

# ---- Memory ----

# How much memory a driver needs depends on its version, so this limit is larger than any machine's memory. A driver that
# fails while there is a limit may have failed because of it. tests/unit/guard.c tests a driver that crashes.
if windows; then
    skip 'a driver that fails while memory is limited is reported' 'ulimit does not limit Windows programs'
else
    limited() { (ulimit -v 68719476736 && exec "$@"); }
    refuse 'a driver that fails while memory is limited' 1 '70368744 MB of memory: raise the limit (ulimit -v)' \
        limited "${too_old[@]}" "$chapter" "${to[@]}"
fi

# ---- Standard output ----

# The file is as large as any file may become, which is large enough for the driver's cache.
head -c 4194304 /dev/zero >"$scratch/full"
to_full() { within_kib 4096 "$chapter" "$@" >>"$scratch/full"; }
for action in --list --help --print-shader --version '--probe 3,3'; do
    # shellcheck disable=SC2086 # an action may be two words
    refuse "a full disk for the output of $action" 1 'standard output' to_full "${small[@]}" $action
done
to_closed() { "$chapter" "$@" >&-; }
refuse 'a closed standard output of --list' 1 'standard output: is closed' to_closed --list
# If the reader of a pipe has exited, as `head` does, the program prints no message, and its status is 1. SIGPIPE, which
# would end the program, is ignored here, so that the program behaves as on Windows, which has no such signal.
mkfifo "$scratch/left"
# shellcheck disable=SC2094 # both ends are opened, so that neither waits for the other
to_left() (trap '' PIPE && exec 5<>"$scratch/left" 6>"$scratch/left" 5>&- && exec "$chapter" "$@" >&6)
for action in --list --help --print-shader --version; do
    run to_left $action
    check "$action to a pipe whose reader has exited prints no message" [ "$status $said" = '1 0' ]
done

# ---- Interrupted ----

# Background jobs of a script ignore SIGINT. Under job control they do not, unless this script itself ignores the
# signal. In that case, env lets them receive it again or, if env has no such option, timeout receives it and passes it
# on.
hearing=()
if ! windows && env --default-signal=INT true 2>/dev/null; then
    hearing=(env --default-signal=INT)
elif command -v timeout >/dev/null; then
    hearing=(timeout 300)
fi
interrupted() { # FILE ARGUMENT...: interrupts the program once it has written FILE
    local file=$1 job
    shift
    set -m
    ${hearing[@]+"${hearing[@]}"} "$chapter" "$@" >/dev/null 2>&1 &
    job=$!
    set +m
    until [ -e "$file" ] || ! kill -0 "$job" 2>/dev/null; do sleep 0.05; done
    sleep 0.2 # the program now renders the second picture, which it cannot finish
    kill -INT "$job"
    # Wine loses the signal while it is still starting a program, so the signal is repeated until the program reacts.
    while windows && sleep 1 && kill -INT "$job" 2>/dev/null; do :; done
    wait "$job" 2>/dev/null
    status=$?
}
wanted=130
# On Ctrl+C, Wine ends any program with status 0, and Windows with 0xC000013A. A program that did not end would leave a
# second file.
windows && wanted=0
# When the first of two pictures has been written, the program renders the second. Its 60,000 iterations of 32 sines for
# each of 64 million samples take hours. There are not more, because llvmpipe ends any loop after 65,535 iterations.
cat >"$shaders/slow.frag" <<'SLOW'
#define TWICE(x) x x
void mainImage(out vec4 c, vec2 p)
{
    vec4 sum = vec4(p, p);
    int rounds = iFrame > 0 ? 60000 : 0;
    for (int i = 0; i < rounds; i++) {
        TWICE(TWICE(TWICE(sum = fract(sum + sin(sum.yzwx + float(i)));)))
    }
    c = iFrame > 0 ? sum : vec4(1.0);
}
SLOW
interrupted "$out/0.png" -s 1000x1000 -a 8 -f "$shaders/slow.frag" --frames 2 -o "$out/%d.png"
if [ "$status" = $wanted ] && [ "$(listing)" = './0.png ./old.png ' ]; then
    ok 'SIGINT during rendering leaves no unfinished file'
else
    not_ok 'SIGINT during rendering leaves no unfinished file' "status $status, $(listing)"
fi
fill

# The signal is sent while the file is being written, as soon as the folder contains a second name. A picture of noise
# takes a long time to write.
cat >"$shaders/noise.frag" <<'NOISE'
#version 330 core
out vec4 colour;
void main()
{
    uvec2 cell = uvec2(gl_FragCoord.xy);
    uint bits = (cell.x * 1664525u + cell.y) * 22695477u;
    bits = (bits ^ (bits >> 15)) * 2246822519u;
    colour = vec4(uvec4(bits, bits >> 8, bits >> 16, bits >> 24) & 255u) / 255.0;
}
NOISE
interrupted_writing() {
    local job names
    set -m
    ${hearing[@]+"${hearing[@]}"} "$chapter" -s 2000x2000 -f "$shaders/noise.frag" -o "$out/old.png" >/dev/null 2>&1 &
    job=$!
    set +m
    hit=
    shopt -s nullglob dotglob
    while kill -0 "$job" 2>/dev/null; do
        names=("$out"/*)
        if [ ${#names[@]} -gt 1 ]; then
            kill -INT "$job" 2>/dev/null && hit=1
            break
        fi
    done
    shopt -u nullglob dotglob
    wait "$job" 2>/dev/null
    [ -z "$(find "$out" -mindepth 1 ! -name old.png)" ] &&
        { is_picture "$out/old.png" || [ -n "$(listing)" ]; }
}
for _ in 1 2 3 4 5 6; do
    fill
    if ! interrupted_writing; then
        hit=0
        break
    fi
    [ -n "$hit" ] && break
done
case $hit in
1) ok 'SIGINT during writing leaves the old file or the new one' ;;
0) not_ok 'SIGINT during writing leaves the old file or the new one' "$(ls -A "$out")" ;;
*) skip 'SIGINT during writing leaves the old file or the new one' 'the file was always complete before the signal came' ;;
esac
fill

# ---- What must work ----

cp "$good" "$shaders/a name with blanks é.frag"
succeed 'a shader whose name contains spaces is rendered' "$chapter" "${to[@]}" -f "$shaders/a name with blanks é.frag"
fill

# prints NAME PATTERN ARGUMENT...: the program must exit with status 0, print text that matches the pattern on standard
# output, and print nothing on standard error.
prints() {
    local name=$1 pattern=$2
    shift 2
    run "$chapter" "$@"
    if [ "$status" = 0 ] && [ "$said" = 0 ] && grep -q -e "$pattern" "$scratch/stdout"; then
        ok "$name"
    else
        not_ok "$name" "status $status $error"
    fi
}
prints '--version names the driver' '03_shadows.*OpenGL' --version
prints '--list prints the parameters, with a value that was set' 'lampHeight.*7\.5' --list -p lampHeight=7.5
prints '--help is printed although the shader is missing' '--output' --help -f /nowhere.frag

"$chapter" "${to[@]}" 2>/dev/null
ln -s "$chapter" "$scratch/called"
(cd / && exec "$scratch/called" "${small[@]}" -o "$scratch/called.png")
check 'the program renders through a link, from another folder' cmp -s "$out/new.png" "$scratch/called.png"

plan
