#!/bin/bash
# test_failures.sh - what cannot be done: one clear line on standard error, the right exit status (1
# it could not be done, 2 the command line is wrong), and nothing half-written.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/support.sh

open_scratch
chmod 755 "$scratch"
out=$scratch/out         # where the pictures go
shaders=$scratch/shaders # shader files that are wrong
mkdir "$out" "$shaders"
chapter=$root/$BUILD/03_shadows
lighting=$root/$BUILD/02_lighting # its parameters include vectors
unset DISPLAY WAYLAND_DISPLAY
pipe='pipe'
# On Windows (windows.sh) what stands in BUILD hands its words on, and a pipe is a device like others.
too_long='too long'
no_links='Wine takes a link that leads nowhere for no file at all'
windows() { [ "${SYSTEM-}" = Windows ]; }
windows && pipe='device' too_long='No such file'
copy_program() { # FOLDER
    if windows; then
        cp build/windows/03_shadows.exe build/windows/*.dll "$1"
        printf '#!/bin/sh\nexec %s "%s" "$@"\n' "${loader-}" "$1/03_shadows.exe" >"$1/03_shadows" && chmod +x "$1/03_shadows"
    else
        cp "$chapter" "$1"
    fi
}

# ---- How one run is judged ----

# The output folder holds one old file, which must still stand, and nothing else.
fill() {
    find "$out" -mindepth 1 -delete
    printf 'an old file' >"$out/old.png"
}

# The names in the output folder, one line; old.png counts only when it is whole.
listing() {
    (cd "$out" && [ "$(cat old.png)" = 'an old file' ] && find . -mindepth 1 | sort | tr '\n' ' ')
}

# run COMMAND...: sets status, error (what was said), said (how many lines).
run() {
    "$@" >"$scratch/stdout" 2>"$scratch/stderr"
    status=$?
    error=$(cat "$scratch/stderr")
    said=$(grep -c '' "$scratch/stderr")
}

# Prints why the last run is not a proper failure; nothing when it is.
complaint() { # STATUS PATTERN LINES
    [ "$status" = "$1" ] || echo "status $status, not $1;"
    [ "$3" = many ] || [ "$said" = 1 ] || echo "$said lines on standard error;"
    [ "$said" -ge 1 ] || echo 'nothing on standard error;'
    grep -q -i -e "$2" "$scratch/stderr" || echo "no '$2' in what it says;"
    if grep -q 'Sanitizer\|runtime error' "$scratch/stderr"; then echo 'a sanitizer speaks;'; fi
    [ -s "$scratch/stdout" ] && echo 'text on standard output;'
    [ "$(listing)" = "$expected_listing" ] || echo "the folder holds $(listing);"
}

# refuse NAME STATUS PATTERN COMMAND...: the command must fail with one line that has the pattern.
# refuse_at_length: with any number of lines, as a shader's errors.
refuse() { judge one "$@"; }
refuse_at_length() { judge many "$@"; }
expected_listing='./old.png '
judge() {
    local lines=$1 name=$2 wanted=$3 pattern=$4 why
    shift 4
    run "$@"
    why=$(complaint "$wanted" "$pattern" "$lines")
    if [ -z "$why" ]; then ok "$name"; else not_ok "$name" "$(echo "$why" "$error" | tr '\n' ' ')"; fi
    [ -z "$why" ] || [ -n "${keep-}" ] || fill
}

# succeed NAME COMMAND...: status 0 and nothing on standard error.
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

# Beginning and end of a PNG.
is_picture() { # FILE
    [ "$(head -c 4 "$1" | tail -c 3)" = PNG ] && [ "$(tail -c 8 "$1" | head -c 4)" = IEND ] &&
        [ ! -L "$1" ]
}

small=(-s 16x9)
to=(-o "$out/new.png" "${small[@]}")
fill

# ---- The command line ----

for size in 0x0 0x9 16x0 -16x9 99999x99999 99999999999999999999x9 abc 16 16x x9 16x9x1 16x9.5 \
    1e2x9 0x10x9 nanx9 '16 x9' ''; do
    refuse "--size '$size'" 2 "--size" "$chapter" -o "$out/new.png" --size "$size"
done
for time in nan inf -inf abc '' 1s 1,5 1e99; do
    refuse "--time '$time'" 2 "--time" "$chapter" "${to[@]}" --time "$time"
done
for samples in 0 -1 9 1.5 x '' 99999999999999999999; do
    refuse "--samples '$samples'" 2 "--samples" "$chapter" "${to[@]}" --samples "$samples"
done
for camera in '' 1,2,3,4 1,2,3,4,5,6 1,2,3,nan,5 1,2,inf,4,5 a,b,c,d,e 0,0,0,0,90 0,0,0,0,-95; do
    refuse "--camera '$camera'" 2 "--camera" "$chapter" "${to[@]}" --camera "$camera"
done
for probe in 16,0 0,9 -1,0 0,-1 16,9 5 x,y 1,2,3 99999999999,0 ''; do
    refuse "--probe '$probe' of 16x9" 2 "--probe" "$chapter" "${small[@]}" --probe "$probe"
done
refuse 'an unknown view' 2 'picture, normals, depth, steps, slice' "$chapter" "${to[@]}" -v colours
refuse 'an unknown backend' 2 'glfw, egl, osmesa' "$chapter" "${to[@]}" -b vulkan
refuse 'an unknown option' 2 "'--colour'" "$chapter" "${to[@]}" --colour red
refuse 'an unknown letter' 2 "'-x'" "$chapter" "${to[@]}" -x
refuse 'an abbreviated option' 2 "'--samp'" "$chapter" "${to[@]}" --samp 2
refuse '--frames without a number in the name' 2 '%d' "$chapter" "${to[@]}" --frames 3
refuse '--fps without --frames' 2 'goes with --frames' "$chapter" "${to[@]}" --fps 25
refuse 'a form of --print-shader that there is not' 2 'must be shadertoy' "$chapter" --print-shader=es
refuse 'a view of --print-shader=shadertoy' 2 'only the picture' "$chapter" --print-shader=shadertoy -v depth
refuse 'an unknown parameter of --print-shader=shadertoy' 2 'lampHeigth' \
    "$chapter" --print-shader=shadertoy -p lampHeigth=2
refuse 'an operand too many' 2 'extra' "$chapter" "${to[@]}" extra
refuse 'a missing value' 2 'missing' "$chapter" --output
refuse 'an output that is no PNG' 2 'ends in .png' "$chapter" "${small[@]}" -o "$out/new.txt"
refuse 'an empty name' 2 '--output' "$chapter" "${small[@]}" -o ''
refuse '--list with a value' 2 '--list' "$chapter" --list=all

# ---- Parameters ----

refuse 'an unknown parameter' 2 'lampHeigth.*lampHeight' "$chapter" "${to[@]}" -p lampHeigth=2
refuse 'a parameter out of its range' 2 '0\.5.*8' "$chapter" "${to[@]}" -p lampHeight=9
refuse 'one component out of its range' 2 '0.*4' "$lighting" "${to[@]}" -p lampColour=1,5,1
for value in nan inf -nan abc '' 1e999 '2 3' 2,3; do
    refuse "lampHeight=$value" 2 'lampHeight' "$chapter" "${to[@]}" -p "lampHeight=$value"
done
refuse 'a comma in a number' 2 'write 2.5$' "$chapter" "${to[@]}" -p lampHeight=2,5
refuse 'a parameter that is wrong, without a display' 2 'lampHeigth' "$chapter" -p lampHeigth=2
refuse 'too few components' 2 'lampColour' "$lighting" "${to[@]}" -p lampColour=1,1
refuse 'a truth that is none' 2 'sun' "$chapter" "${to[@]}" -p sun=perhaps
refuse 'a whole number that is none' 2 'maxSteps' "$chapter" "${to[@]}" -p maxSteps=1.5
refuse 'no equals sign' 2 'NAME=VALUE' "$chapter" "${to[@]}" -p lampHeight
refuse 'an unknown parameter of --list' 2 'lampHeigth' "$chapter" --list -p lampHeigth=2
refuse 'a parameter of a whole file' 2 'sun' "$root/$BUILD/00_first_scene" "${to[@]}" -p sun=1

# ---- Shader files ----

good=$root/chapters/01_normal_colouring.frag
refuse 'a missing shader' 1 'nowhere.frag.*No such file' "$chapter" "${to[@]}" -f "$shaders/nowhere.frag"
refuse 'a missing shader of --list' 1 'nowhere.frag' "$chapter" --list -f "$shaders/nowhere.frag"
refuse 'a missing shader of --print-shader' 1 'nowhere.frag' \
    "$chapter" --print-shader -f "$shaders/nowhere.frag"
refuse 'a folder for a shader' 1 "$shaders" "$chapter" "${to[@]}" -f "$shaders"
refuse 'a device for a shader' 1 '/dev/null' "$chapter" "${to[@]}" -f /dev/null
: >"$shaders/empty.frag"
refuse 'an empty shader' 1 'empty.frag.*empty' "$chapter" "${to[@]}" -f "$shaders/empty.frag"
printf 'void main()\n{\0}\n' >"$shaders/binary.frag"
refuse 'a binary shader' 1 'binary.frag' "$chapter" "${to[@]}" -f "$shaders/binary.frag"
mkdir "$scratch/alone"
copy_program "$scratch/alone"
find "$scratch/alone" -name '03_shadows*' -size +1 -exec cp {} "$shaders/program.frag" \;
refuse 'a program for a shader' 1 'program.frag' "$chapter" "${to[@]}" -f "$shaders/program.frag"
printf '// nothing here\n' >"$shaders/comment.frag"
refuse_at_length 'a shader of comments alone' 1 'comment.frag' \
    "$chapter" "${to[@]}" -f "$shaders/comment.frag"

printf '\n#include "nowhere.glsl"\n' >"$shaders/a.frag"
refuse 'an include that is missing' 1 'a.frag:2.*nowhere.glsl' "$chapter" "${to[@]}" -f "$shaders/a.frag"
printf '#include "b.frag"\n' >"$shaders/b.frag"
refuse 'an include that includes itself' 1 'b.frag:1' "$chapter" "${to[@]}" -f "$shaders/b.frag"
printf '#include "c2.glsl"\n' >"$shaders/c.frag"
printf '\n\n#include "c.frag"\n' >"$shaders/c2.glsl"
refuse 'two that include each other' 1 'c2.glsl:3' "$chapter" "${to[@]}" -f "$shaders/c.frag"
printf 'float outside;\n' >"$scratch/outside.glsl"
printf '#include "../outside.glsl"\n' >"$shaders/d.frag"
refuse 'an include that climbs out' 1 'd.frag:1.*outside' "$chapter" "${to[@]}" -f "$shaders/d.frag"
printf '#include "%s"\n' "$scratch/outside.glsl" >"$shaders/e.frag"
refuse 'an absolute include' 1 'e.frag:1' "$chapter" "${to[@]}" -f "$shaders/e.frag"
ln -s ../outside.glsl "$shaders/link.glsl"
printf '#include "link.glsl"\n' >"$shaders/f.frag"
refuse 'an include that climbs out by a link' 1 'f.frag:1' "$chapter" "${to[@]}" -f "$shaders/f.frag"
printf '#include <main.glsl>\n' >"$shaders/g.frag"
refuse_at_length 'an include in angle brackets' 1 'g.frag:1' "$chapter" "${to[@]}" -f "$shaders/g.frag"
printf '#include "main.glsl\n' >"$shaders/h.frag"
refuse 'an include without its end' 1 'h.frag:1' "$chapter" "${to[@]}" -f "$shaders/h.frag"

# annotation NAME LINE: a course shader with this line in third place.
annotation() {
    printf '#include "main.glsl"\n\n%s\n' "$2" >"$shaders/note.frag"
    sed 1d "$good" | sed 's/ORBIT/BALLS/g' >>"$shaders/note.frag"
    refuse "$1" 1 'note.frag:3' "$chapter" "${to[@]}" -f "$shaders/note.frag"
}
annotation 'a parameter without a range' 'uniform float w; // 1: width'
annotation 'a value outside its range' 'uniform float w; // 3 in [0, 2]: width'
annotation 'a range the wrong way round' 'uniform float w; // 1 in [2, 0]: width'
annotation 'a range without its end' 'uniform float w; // 1 in [0, 2: width'
annotation 'too many values' 'uniform vec2 w; // 1, 2, 3 in [0, 4]: width'
annotation 'a parameter without a meaning' 'uniform float w; // 1 in [0, 2]'
annotation 'a type that has no parameters' 'uniform mat3 w; // 1 in [0, 2]: width'
annotation 'a step of zero' 'uniform float w; // 1 in [0, 2] step 0: width'
annotation 'a sampler without a picture' 'uniform sampler2D w;'
annotation 'a picture that is missing' 'uniform sampler2D w; // "nowhere.png" sRGB repeat: width'
annotation 'a word that a sampler does not know' 'uniform sampler2D w; // "w.png" sRBG repeat: width'
printf 'no picture' >"$shaders/w.png"
annotation 'a picture that is none' 'uniform sampler2D w; // "w.png" sRGB repeat: width'
cp shaders/textures/noise.png "$shaders/w.png"
annotation 'slices that do not fit' 'uniform sampler3D w; // "w.png" linear repeat 60: width'
head -c 3000 shaders/textures/noise.png >"$shaders/w.png"
annotation 'a picture that is broken off' 'uniform sampler3D w; // "w.png" linear repeat 64: width'
rm "$shaders/w.png"
mkfifo "$shaders/w.png"
annotation 'a pipe in the place of a picture' 'uniform sampler2D w; // "w.png" sRGB repeat: width'
awk '/^const float FAR/ { print "uniform bool biased; // true: again" } { print }' "$good" \
    >"$shaders/twice.frag"
line=$(grep -n 'true: again' "$shaders/twice.frag" | cut -d : -f 1)
refuse 'a parameter declared twice' 1 "twice.frag:$line.*biased" \
    "$chapter" "${to[@]}" -f "$shaders/twice.frag"

printf 'void mainImage(out vec4 c, in vec2 f) { c = texture(iChannel1, f); }\n' >"$shaders/toy.frag"
refuse "a channel of Shadertoy's without a picture" 1 'toy.frag:1: iChannel1 has no picture: give --channel 1=' \
    "$chapter" "${to[@]}" -f "$shaders/toy.frag"
refuse 'a picture that is missing for a channel' 1 '--channel 1=nowhere.png: cannot be read' \
    "$chapter" "${to[@]}" --channel 1=nowhere.png -f "$shaders/toy.frag"
refuse 'a channel that a shader does not mention' 2 '--channel 0=.*iChannel0' \
    "$chapter" "${to[@]}" --channel 0=shaders/textures/granite.png --channel 1=shaders/textures/granite.png -f "$shaders/toy.frag"
refuse 'a channel of a chapter' 2 '--channel 0=x.png.*--texture' "$chapter" "${to[@]}" --channel 0=x.png
refuse 'a texture that no sampler has' 2 '--texture stone=x.png: this shader has no textures' "$chapter" "${to[@]}" --texture stone=x.png
refuse 'a texture without a file' 2 "--texture 'stone='" "$chapter" "${to[@]}" --texture stone=
refuse 'a channel of another number' 2 "--channel '4=x.png'" "$chapter" "${to[@]}" --channel 4=x.png
cp shaders/textures/noise.png "$out/stone.png"
expected_listing='./old.png ./stone.png ' keep=1
refuse 'a picture over one that the run reads' 1 "stone.png, which this run reads" \
    "$chapter" --channel 1="$out/stone.png" -f "$shaders/toy.frag" -o "$out/stone.png"
printf '#include "03_shadows.frag"\nuniform sampler2D stone; // "granite.png" sRGB repeat: grey\n' >"$shaders/stone.frag"
refuse 'a picture over one that was put in' 1 "stone.png, which this run reads" \
    "$chapter" --texture stone="$out/stone.png" -f "$shaders/stone.frag" -o "$out/stone.png"
same_noise() { cmp -s shaders/textures/noise.png "$out/stone.png"; }
check 'and it is still there' same_noise
expected_listing='./old.png ' keep=''
fill
if [ "$BUILD" = build ]; then # a sanitizer takes more memory, and speaks itself
    echo 'void mainImage(out vec4 c, vec2 p) { c = vec4(0.5); }' >"$shaders/grey.frag"
    "$chapter" -f "$shaders/grey.frag" -s 4096x4096 -o "$scratch/large.png"
    # How much a driver takes by itself is its own affair: a little more than the least with which a small picture
    # is drawn.
    limit=1600000
    little() { (ulimit -v "$limit" && exec "$chapter" -f "$shaders/stone.frag" "$@"); }
    while little -s 16x16 -o "$scratch/small.png" >/dev/null 2>&1 && [ "$limit" -gt 200000 ]; do
        limit=$((limit - 50000))
    done
    limit=$((limit + 70000))
    refuse 'a picture without memory for it' 1 'stone.frag:2: sampler stone: .*large.png: .*not enough memory' \
        little "${to[@]}" --texture stone="$scratch/large.png"
fi
refuse "a view of Shadertoy's form" 1 'toy.frag: .*view depth' "$chapter" "${to[@]}" -v depth -f "$shaders/toy.frag"
whole=$root/chapters/00_first_scene.frag
refuse 'a view of a whole file' 1 '00_first_scene.frag' "$chapter" "${to[@]}" -v depth -f "$whole"
refuse 'the slice of a whole file' 1 'view slice' "$chapter" "${to[@]}" -v slice -f "$whole"

# ---- A shader's errors: the author's own file and line ----

printf '#include "part.glsl"\n#include "main.glsl"\n' >"$shaders/i.frag"
printf '// a comment\nfloat halved(float x)\n{\n    return 0.5 * y;\n}\n' >"$shaders/part.glsl"
refuse_at_length 'an undeclared name in an included file' 1 'part.glsl:4.*y' \
    "$chapter" "${to[@]}" -f "$shaders/i.frag"
printf '// a comment\nfloat halved(float x)\n{\n    return 0.5 * x\n}\n' >"$shaders/part.glsl"
refuse_at_length 'a syntax error in an included file' 1 'part.glsl:5.*syntax' \
    "$chapter" "${to[@]}" -f "$shaders/i.frag"
sed 's/return SKY/return SKI/' "$good" >"$shaders/j.frag"
line=$(grep -n 'return SKI' "$shaders/j.frag" | cut -d : -f 1)
refuse_at_length 'an undeclared name in the main file' 1 "j.frag:$line.*SKI" \
    "$chapter" "${to[@]}" -f "$shaders/j.frag"
awk '/^vec3 rayColour/ { print "vec3 farAway(Ray ray);" } { print }' "$good" |
    sed 's/return SKY;/return farAway(ray);/' >"$shaders/k.frag"
line=$(grep -n 'return farAway' "$shaders/k.frag" | cut -d : -f 1)
refuse_at_length 'a call that links to nothing' 1 "k.frag:$line.*farAway" \
    "$chapter" "${to[@]}" -f "$shaders/k.frag"
sed 's/^vec3 rayColour/vec3 rayCulour/' "$good" >"$shaders/l.frag"
refuse_at_length 'a chapter without rayColour' 1 'rayColour' "$chapter" "${to[@]}" -f "$shaders/l.frag"
sed 's/FragColor = /FragColour = /' "$whole" >"$shaders/m.frag"
refuse_at_length 'an error in a whole file' 1 'm.frag:[0-9]*.*FragColour' \
    "$chapter" "${to[@]}" -f "$shaders/m.frag"
if windows; then
    skip 'an error in a file with a line end in its name' 'no name has one there'
else
    cp "$shaders/m.frag" "$shaders"/$'new\nline.frag'
    refuse_at_length 'an error in a file with a line end in its name' 1 'new?line.frag:[0-9]*.*FragColour' \
        "$chapter" "${to[@]}" -f "$shaders"/$'new\nline.frag'
fi
refuse '--root without shaders' 1 '--root' "$chapter" "${to[@]}" --root "$shaders"
refuse 'a program far from its shaders' 1 '--root' "$scratch/alone/03_shadows" "${to[@]}"
mkdir -p "$scratch/empty root/shaders"
: >"$scratch/empty root/shaders/screen.vert"
refuse 'a project with an empty vertex shader' 1 'screen.vert.*empty' \
    "$chapter" "${to[@]}" --root "$scratch/empty root" -f "$whole"

# ---- Where the picture goes ----

target_kind() { find "$out" -name target.png -exec ls -ld {} + | cut -c 1; }

# A target of a kind of its own in the output folder, taken away afterwards.
with_target() { # NAME PATTERN
    local name=$1 kind
    kind=$(target_kind)
    expected_listing='./old.png ./target.png '
    keep=1 refuse "$name" 1 "$2" "$chapter" "${small[@]}" -o "$out/target.png"
    check "$name: it still stands" [ "$(target_kind)" = "$kind" ]
    expected_listing='./old.png '
    fill
}
mkdir "$out/target.png"
with_target 'an output that is a folder' 'folder'
mkfifo "$out/target.png"
with_target 'an output that is a pipe' "$pipe"
# Who may not make a device may not harm the one that a link leads to.
mknod "$out/target.png" c 1 3 2>/dev/null || ln -s /dev/null "$out/target.png"
with_target 'an output that is a device' 'device'
mkfifo "$out/pipe"
ln -s pipe "$out/link.png"
expected_listing='./link.png ./old.png ./pipe '
refuse 'an output that is a link to a pipe' 1 "$pipe" "$chapter" "${small[@]}" -o "$out/link.png"
fill
if windows; then
    skip 'an output that is a link to itself' "$no_links"
else
    ln -s loop.png "$out/loop.png"
    expected_listing='./loop.png ./old.png '
    refuse 'an output that is a link to itself' 1 'loop' "$chapter" "${small[@]}" -o "$out/loop.png"
    fill
fi
expected_listing='./old.png '
refuse 'an output in a missing folder' 1 'nowhere' "$chapter" "${small[@]}" -o "$out/nowhere/new.png"
refuse 'the output is looked at before any work' 1 'folder.*nowhere' \
    "$chapter" "${small[@]}" -o "$out/nowhere/new.png" -f "$shaders/j.frag"
refuse 'an output below a file' 1 'old.png' "$chapter" "${small[@]}" -o "$out/old.png/new.png"
refuse 'an output that ends in /' 2 'ends in .png' "$chapter" "${small[@]}" -o "$out/new/"
refuse 'a name longer than any' 1 "$too_long" "$chapter" "${small[@]}" \
    -o "$out/$(printf '%0300d' 0).png"
refuse 'a line end in a name stays in one line' 1 'new?line' "$chapter" "${small[@]}" \
    -o "$out"/$'new\nline/a.png'

# A picture never takes the place of what the run reads: itself, by a link, a hard link, an include, in a row.
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
    keep=1 refuse "an output that is read: $name" 1 "which this run reads" \
        "$chapter" "${small[@]}" "${frames[@]}" -f "$out/read.png" -o "$out/$name.png"
    check "an output that is read: $name: it still stands" kept
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

# A write that fails in the midst, as on a full disk: no file may grow beyond 1 KiB. The driver's own files
# are left out: it does not expect that signal.
full_disk() {
    (ulimit -f 1 && MESA_SHADER_CACHE_DISABLE=true "$chapter" -s 320x180 -o "$1")
}
if windows; then
    for name in 'a full disk' 'a full disk, over an old file'; do
        skip "$name" 'Windows has no such limit on a file, and Wine ends by its signal'
    done
else
    refuse 'a full disk' 1 'new.png' full_disk "$out/new.png"
    refuse 'a full disk, over an old file' 1 'old.png' full_disk "$out/old.png"
fi

# As root nothing is forbidden: an unprivileged user tries, with copies that it can read.
stranger=()
if windows; then
    forbidden='a Wine belongs to the user who began it'
elif [ "$(id -u)" = 0 ]; then
    if command -v setpriv >/dev/null; then
        stranger=(setpriv --reuid=65534 --regid=65534 --clear-groups)
    else
        forbidden='root may do everything here, and there is no setpriv'
    fi
fi
mkdir "$scratch/copy" "$scratch/home"
cp -R "$chapter" shaders chapters tests/lsan.supp "$scratch/copy"
chmod -R a+rX "$scratch/copy" "$out"
chmod 777 "$scratch/home"
as_stranger_do() {
    ${stranger[@]+"${stranger[@]}"} env HOME="$scratch/home" MESA_SHADER_CACHE_DIR="$scratch/home" \
        LSAN_OPTIONS="${LSAN_OPTIONS//"$root/tests"/"$scratch/copy"}" "$@"
}
as_stranger() { as_stranger_do "$scratch/copy/03_shadows" "${small[@]}" "$@"; }
if [ -n "${forbidden-}" ]; then
    for name in 'an unreadable shader' 'an unreadable include' 'a folder that cannot be written' \
        'a file that cannot be written'; do
        skip "$name" "$forbidden"
    done
else
    cp "$good" "$shaders/secret.frag"
    printf '#include "secret.frag"\n' >"$shaders/n.frag"
    chmod 000 "$shaders/secret.frag"
    refuse 'an unreadable shader' 1 'secret.frag.*denied' \
        as_stranger -o "$scratch/home/new.png" -f "$shaders/secret.frag"
    refuse 'an unreadable include' 1 'n.frag:1.*secret.frag' \
        as_stranger -o "$scratch/home/new.png" -f "$shaders/n.frag"
    chmod 555 "$out"
    refuse 'a folder that cannot be written' 1 'new.png' as_stranger -o "$out/new.png"
    chmod 777 "$out"
    chmod 444 "$out/old.png"
    refuse 'a file that cannot be written' 1 'old.png.*denied' as_stranger -o "$out/old.png"
    chmod 644 "$out/old.png"
fi

# ---- Contexts ----

# A software driver has a thread for each processor: one who may have no threads gets a picture all the same.
# The leak checker wants a thread too.
threadless() {
    # shellcheck disable=SC2016 # for the inner shell
    as_stranger_do timeout 120 bash -c 'ulimit -u 1 && exec "$@"' - \
        env ASAN_OPTIONS="$ASAN_OPTIONS:detect_leaks=0" "$scratch/copy/03_shadows" "${small[@]}" \
        -o "$scratch/home/new.png"
}
if [ -n "${forbidden-}" ]; then
    skip 'no threads' "$forbidden"
else
    succeed 'no threads' threadless
fi

# A cache of shaders on a disk that is full, which only one who may mount can try.
full_cache() {
    # shellcheck disable=SC2016 # for the inner shell
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
    skip 'a full disk under the cache of shaders' 'this user may not mount'
else
    succeed 'a full disk under the cache of shaders' full_cache
    fill
fi

if windows; then
    for name in 'a window without a display' 'glfw without a display'; do
        skip "$name" 'Windows always has one'
    done
else
    refuse 'a window without a display' 3 'display' "$chapter"
    refuse 'glfw without a display' 1 'glfw' "$chapter" "${to[@]}" -b glfw
fi
refuse 'a window through egl' 3 'egl' "$chapter" -b egl
refuse 'a window through osmesa' 3 'osmesa' "$chapter" -b osmesa
mkdir "$scratch/none"
no_egl=(env "__EGL_VENDOR_LIBRARY_DIRS=$scratch/none")
too_old=(env MESA_GL_VERSION_OVERRIDE=3.2)
if "$chapter" --version -b egl >/dev/null 2>&1; then
    refuse 'an EGL that cannot start' 1 'egl' "${no_egl[@]}" "$chapter" "${to[@]}" -b egl
    refuse 'an EGL that cannot start, --version' 1 'egl' "${no_egl[@]}" "$chapter" --version -b egl
    refuse 'egl: a driver that refuses 3.3' 1 'egl' "${too_old[@]}" "$chapter" "${to[@]}" -b egl
else
    skip 'an EGL that cannot start' 'no EGL on this machine'
fi
if "$chapter" --version -b osmesa >/dev/null 2>&1; then
    refuse 'osmesa: a driver that refuses 3.3' 1 'osmesa' "${too_old[@]}" "$chapter" "${to[@]}" -b osmesa
    "$chapter" "${small[@]}" -o "$scratch/first.png"
    succeed 'an EGL that cannot start: the next backend takes over' \
        "${no_egl[@]}" "$chapter" "${to[@]}"
    check 'and makes the same picture' cmp -s "$scratch/first.png" "$out/new.png"
    fill
else
    skip 'osmesa: a driver that refuses 3.3' 'no OSMesa on this machine'
fi
says=refuse
windows && says=refuse_at_length # Wine's own library of OpenGL says something first
$says 'a driver that there is not' 1 'driver' env GALLIUM_DRIVER=nonsense "$chapter" "${to[@]}"
small_stack() { (ulimit -s 64 && exec "$chapter" "${to[@]}"); }
if windows; then
    skip 'a stack of 64 KiB' "the program's own file says how large it is"
else
    refuse 'a stack of 64 KiB' 1 'stack may take 64 KiB' small_stack
fi
tried='egl.*osmesa.*glfw'
grep -q -e '-DHAVE_OSMESA' "$BUILD/flags" || tried='egl.*glfw' # what make did not find is not tried
windows && tried='glfw'
refuse 'no backend at all' 1 "$tried" "${too_old[@]}" "$chapter" "${to[@]}"
if windows || open_display; then
    refuse 'glfw: a driver that refuses 3.3' 1 '3\.3.*glfw' "${too_old[@]}" "$chapter" "${to[@]}" -b glfw
    refuse 'a window: a driver that refuses 3.3' 3 '3\.3' "${too_old[@]}" "$chapter"
    succeed 'glfw renders into a file' "$chapter" "${to[@]}" -b glfw
    fill
    close_display
    unset DISPLAY
else
    skip 'glfw: a driver that refuses 3.3' 'no Xvfb on this machine, or it did not start'
fi

# ---- Standard output ----

if [ -e /dev/full ]; then
    to_full() { "$chapter" "$@" >/dev/full; }
    for action in --list --help --print-shader --version '--probe 3,3'; do
        # shellcheck disable=SC2086 # options are words
        refuse "$action to a full disk" 1 'standard output' to_full "${small[@]}" $action
    done
else
    skip '--list to a full disk' 'no /dev/full on this machine'
fi
to_closed() { "$chapter" "$@" >&-; }
refuse '--list with standard output closed' 1 'standard output' to_closed --list
# A pipe whose reader has gone, as `head` goes: that is no mistake, and nothing is said. The signal that ends the
# program then is ignored here, for Windows has none.
mkfifo "$scratch/left"
# shellcheck disable=SC2094 # both ends: neither waits for the other
to_left() (trap '' PIPE && exec 5<>"$scratch/left" 6>"$scratch/left" 5>&- && exec "$chapter" "$@" >&6)
for action in --list --help --print-shader --version; do
    run to_left $action
    check "$action to one who has gone says nothing" [ "$status $said" = '1 0' ]
done

# ---- Interrupted ----

# Background jobs of a script ignore SIGINT; under job control they do not, unless this script has been told to
# ignore it: timeout hears it then too, and hands it on.
hearing=()
command -v timeout >/dev/null && hearing=(timeout 300)
interrupted() { # SECONDS ARGUMENT...
    local seconds=$1 job
    shift
    set -m
    ${hearing[@]+"${hearing[@]}"} "$chapter" "$@" >/dev/null 2>&1 &
    job=$!
    set +m
    sleep "$seconds"
    kill -INT "$job"
    # While Wine still starts a program it loses the signal: there Ctrl+C is pressed until it was heard.
    while windows && sleep 1 && kill -INT "$job" 2>/dev/null; do :; done
    wait "$job" 2>/dev/null
    status=$?
}
wanted=130
windows && wanted=0 # so Wine ends any program at Ctrl+C; Windows with 0xC000013A. Who was not ended would leave a file
interrupted 0.4 -s 4000x4000 -a 8 -o "$out/new.png"
if [ "$status" = $wanted ] && [ "$(listing)" = "$expected_listing" ]; then
    ok 'SIGINT while it renders leaves no file'
else
    not_ok 'SIGINT while it renders leaves no file' "status $status, $(listing)"
fi
fill

# While the file is written: the signal comes as soon as a second name stands in the folder. A picture
# of noise is long to write.
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
1) ok 'SIGINT while it writes leaves the old file or the new one' ;;
0) not_ok 'SIGINT while it writes leaves the old file or the new one' "$(ls -A "$out")" ;;
*) skip 'SIGINT while it writes' 'the file was always whole before the signal came' ;;
esac
fill

# ---- What must work ----

printf '\357\273\277' | cat - "$good" >"$shaders/mark.frag"
succeed 'a byte-order mark' "$chapter" "${to[@]}" -f "$shaders/mark.frag"
awk '{ printf "%s\r\n", $0 }' "$good" >"$shaders/lines.frag"
succeed 'carriage returns' "$chapter" "${to[@]}" -f "$shaders/lines.frag"
printf '%s' "$(cat "$good")" >"$shaders/end.frag"
succeed 'a last line without its end' "$chapter" "${to[@]}" -f "$shaders/end.frag"
cp "$good" "$shaders/a name with blanks é.frag"
succeed 'a name with blanks' "$chapter" "${to[@]}" -f "$shaders/a name with blanks é.frag"

# prints NAME PATTERN ARGUMENT...: status 0, the pattern on standard output, nothing on error.
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
prints '--help prints the options' '--print-shader' --help
prints '-h prints the options' '--output' -h
prints '--version names the driver' '03_shadows.*OpenGL' --version
prints '--list prints the parameters' 'shadowOffset' --list
prints '--list shows a value that was set' 'lampHeight.*7\.5' --list -p lampHeight=7.5
prints '--print-shader prints one text' '^Hit march' --print-shader
prints '--probe prints a table' '^0,' "${small[@]}" --probe 8,4
prints '--help wins over what cannot be done' '--output' --help -f /nowhere.frag

"$chapter" --print-shader >"$shaders/expanded.frag" 2>/dev/null
check '--print-shader leaves no include' [ -z "$(grep '^ *#include' "$shaders/expanded.frag")" ]

fill
succeed 'a picture over an old file' "$chapter" "${small[@]}" -o "$out/old.png"
check 'is a picture' is_picture "$out/old.png"
(cd "$out" && run "$chapter" "${small[@]}" -o here.png && exit "$status")
check 'a picture into the current folder' cmp -s "$out/here.png" "$out/old.png"
fill
mkdir "$out/far"
printf old >"$out/far/target.png"
ln -s far/target.png "$out/link.png"
succeed 'an output through a link' "$chapter" "${small[@]}" -o "$out/link.png"
check 'the link stands' [ -L "$out/link.png" ]
check 'what it points to is the picture' is_picture "$out/far/target.png"
if windows; then
    skip 'an output through a link to nothing yet' "$no_links"
else
    rm "$out/far/target.png"
    succeed 'an output through a link to nothing yet' "$chapter" "${small[@]}" -o "$out/link.png"
    check 'makes what it points to' is_picture "$out/far/target.png"
fi
fill
umask 022
"$chapter" "${to[@]}" 2>/dev/null
check 'a new picture has the permissions of any new file' \
    [ "$(find "$out" -name new.png -perm 644)" ]
ln -s "$chapter" "$scratch/called"
(cd / && exec "$scratch/called" "${small[@]}" -o "$scratch/called.png")
check 'through a link to the program, from another folder' cmp -s "$out/new.png" "$scratch/called.png"

plan
