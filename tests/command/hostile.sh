#!/bin/bash
# hostile.sh - tests names and contents that nobody would choose: the programs refuse or show them in harmless UTF-8, do
# not wait for them, and lose no file. tests/corpus has hostile bytes for the functions that read them.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh
. tests/lib/refuse.sh

open_scratch
chmod 755 "$scratch"
open_out
bin=$root/$BUILD
chapter=$bin/03_shadows
unset DISPLAY WAYLAND_DISPLAY
cd "$scratch" || exit 1
small=(-s 16x9)
to=(-o out/new.png "${small[@]}")

# shown NAME PATTERN COMMAND...: the command must succeed, and print harmless text that matches the pattern.
shown() {
    local name=$1 pattern=$2
    shift 2
    run "$@"
    if [ "$status $said" = '0 0' ] && harmless stdout && grep -q -e "$pattern" stdout; then
        ok "$name is shown"
    else
        not_ok "$name is shown" "status $status $error"
    fi
}

# ---- Characters ----

# Each is a name of a missing file, a value, and part of an option's name.
bytes=($'\e[31m' $'\r' $'\a' $'\b\b' $'\n' $'\x7f' $'\xe9' $'\xc0\xaf' $'\xed\xa0\x80' $'\x9b31m' $'\xc2\x9b31m' $'\xe2\x80\xae' $'\xe2\x80\xa8' $'\xe2\x81\xa6')
names=(escape return bell backspace 'line feed' delete 'byte of ISO 8859-1' 'slash in two bytes' 'half of a pair' 'control byte' 'control character'
    override 'line separator' isolate)
for i in "${!bytes[@]}"; do
    refuse "a missing shader with a ${names[i]}" 1 'a?[?0-9m[]*b: cannot be read' "$chapter" "${to[@]}" -f "a${bytes[i]}b"
    refuse "a value with a ${names[i]}" 2 "--time '1?" "$chapter" "${to[@]}" --time "1${bytes[i]}"
    refuse "an option with a ${names[i]}" 2 "unknown option '--x?" "$chapter" "${to[@]}" "--x${bytes[i]}=1"
done
refuse 'an unknown letter that is not ASCII' 2 "unknown option '-?'" "$chapter" $'-\xc3\xa9'
refuse 'a missing folder with an escape' 1 'cannot be written: folder no?' "$chapter" "${small[@]}" -o $'no\e[1m/new.png'
refuse 'a root with an escape' 1 '^--root ?' "$chapter" "${to[@]}" --root $'\e[1m'
refuse 'a driver with an escape' 1 'GALLIUM_DRIVER, which is ?\|driver' env GALLIUM_DRIVER=$'\e[1m\xe9' "$chapter" "${to[@]}"
refuse 'a mesh with an escape' 1 'clay: no?\[1m' "$root/build/shaders/textures/clay" $'no\e[1m\xe9'
refuse 'a tool with an escape' 2 'no?\[1m?: cannot be read: No' "$bin/tests/judge" ray $'no\e[1m\xe9'

bad=$'b\e[31m\xe9\xe2\x80\xae.frag'
cp "$root/chapters/01_normal_colouring.frag" "$bad"
shown 'the name of a measured shader' 'shader  *b?\[31m??\.frag' "$chapter" -f "$bad" "${small[@]}" --benchmark 1
shown 'the name of a shader in JSON' '"shader": "b' "$chapter" -f "$bad" "${small[@]}" --benchmark json
printf '#include "01_normal_colouring.frag"\nuniform float q; // 0.5 in [0, 1], \xe9\e: a \e[31m\xe2\x80\xae meaning\n' >meaning.frag
shown 'the meaning of a parameter' 'q .*a ?\[31m? meaning' "$chapter" -f meaning.frag --list
ln -s "$chapter" $'p\e[31m'
shown 'the name of the program' '^Usage: \./p?\[31m ' $'./p\e[31m' --help
printf '== \e[31m\xe9\n03\n \xe2\x80\xaex\x07 \x1f\n' >list
shown_fields() { tr '\037' '|' <stdout >fields && [ "$(cat fields)" = '1|?[31m?|03_shadows||?x? ?' ]; }
run "$bin/lecture" --print list
check 'the fields of a lecture are printed clean' shown_fields
printf 'void mainImage(out vec4 c, in vec2 p) { c = \xe9\e[31m\xe2\x80\xae; }\n' >latin.frag
refuse_at_length 'an error in a line of ISO 8859-1' 1 'latin.frag:1' "$chapter" "${to[@]}" -f latin.frag
printf '#error \e[31m\xe9\xe2\x80\xae\n' >directive.frag
refuse_at_length "a shader's own message" 1 'directive.frag:1' "$chapter" "${to[@]}" -f directive.frag
printf '#include "no\e[31m\xe9"\n' >include.frag
refuse 'a missing include with an escape' 1 'include.frag:1: #include "no?\[31m?": no such file' "$chapter" "${to[@]}" -f include.frag

# ---- Length ----

long=$(head -c 100000 /dev/zero | tr '\0' x)
spaced=${long//xxxxxxxxx/xxxxxxxx }
refuse 'a long value' 2 "^--set 'xxx.*xxx': must be NAME=VALUE" "$chapter" "${to[@]}" --set "$long"
refuse 'a long value of many words' 2 "^--set 'xxx.*x': must be NAME=VALUE" "$chapter" "${to[@]}" --set "$spaced"
refuse 'a long option' 2 "unknown option '--xxx.*xxx': --help lists" "$chapter" "--$long=1"
refuse 'a long name of a shader' 1 'the path of the shader is too long\|cannot be read' "$chapter" "${to[@]}" -f "${long:0:4000}"
refuse 'a long name of a picture' 1 'new.png: cannot be written' "$chapter" "${small[@]}" -o "${long:0:3000}/new.png"
printf '03 --set %s\n' "$long" >longlist
refuse 'a long value in a lecture' 2 "^longlist:1: --set 'xxx.*xxx': must be" "$bin/lecture" longlist
awk 'BEGIN { for (i = 0; i < 1001; i++) print "03" }' >scenes
refuse 'a lecture of 1001 scenes' 2 'scenes:1001: a lecture has at most 1000 scenes' "$bin/lecture" scenes
# Joining the lines one by one would take minutes.
awk 'BEGIN { print "03"; for (i = 0; i < 340000; i++) print " a" }' >sentence
run "$bin/lecture" --print sentence
check 'a sentence of 340,000 lines is joined' [ "$status $(wc -c <stdout | tr -d ' ')" = '0 680015' ]

# ---- Numbers ----

for number in nan inf -inf 1e999 0x10 1e '1,5' $'1\n' '' - 1_000 $'\xd9\xa1'; do
    refuse "the time '${number//$'\n'/ }'" 2 "--time '" "$chapter" "${to[@]}" --time "$number"
    refuse "the parameter '${number//$'\n'/ }'" 2 'lampHeight' "$chapter" "${to[@]}" --set "lampHeight=$number"
done

# ---- Kinds of files ----

mkfifo fifo
mkdir folder
ln -s nowhere dangling
ln -s loop loop
: >empty
printf 'a\0b\n' >zero
printf '#include "03_shadows.frag"\nuniform sampler2D stone; // "granite.png" sRGB repeat: grey\n' >stone.frag
for kind in fifo folder dangling loop empty zero /dev/zero /dev/null .; do
    printf '#include "%s"\n' "$kind" >include.frag
    printf '#include "03_shadows.frag"\nuniform sampler2D stone; // "%s" sRGB repeat: grey\n' "$kind" >sampler.frag
    refuse "a shader that is $kind" 1 "^$kind: " "$chapter" "${to[@]}" -f "$kind"
    refuse "a second shader that is $kind" 1 "^$kind: " "$chapter" "${to[@]}" --compare "$kind"
    refuse "an include that is $kind" 1 "^include.frag:1: #include \"$kind\": \|^$kind: " "$chapter" "${to[@]}" -f include.frag
    refuse "a sampler that is $kind" 1 "^sampler.frag:2: sampler stone: $kind: " "$chapter" "${to[@]}" -f sampler.frag
    refuse "a texture that is $kind" 1 "^stone.frag:2: sampler stone: $kind: " "$chapter" "${to[@]}" -f stone.frag --texture "stone=$kind"
    refuse "a lecture that is $kind" 2 "^$kind: " "$bin/lecture" "$kind"
    refuse "a mesh that is $kind" 1 "^clay: $kind: " "$root/build/shaders/textures/clay" "$kind"
    [ "$kind" = empty ] || [ "$kind" = zero ] || # judge takes them for tables without a step
        refuse "a probe that is $kind" 2 "^$kind: " "$bin/tests/judge" ray "$kind"
done
refuse 'a root that is a pipe' 1 '^--root fifo: ' "$chapter" "${to[@]}" --root fifo
mkdir out/new.png
expected_listing='./new.png ./old.png ' keep=1
refuse 'a picture that is a folder' 1 'new.png: cannot be written: .*folder' "$chapter" "${to[@]}"
expected_listing='./old.png ' keep=
fill
if [ -e /proc/self/mem ]; then # reading it fails
    refuse 'a mesh that cannot be read' 1 'clay: /proc/self/mem: ' "$root/build/shaders/textures/clay" /proc/self/mem
    refuse 'a probe that cannot be read' 2 '^/proc/self/mem: cannot be read: ' "$bin/tests/judge" ray /proc/self/mem
fi
limited() { (ulimit -f 2 && exec "$@"); }
refuse 'a picture on a full disk' 1 'old.png: cannot be written: ' limited "$chapter" -s 640x360 -o out/old.png

plan
