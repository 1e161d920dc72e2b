#!/bin/bash
# test_window.sh - the interactive window under Xvfb, with real key, mouse, wheel, resize, reload and
# close events. What the eye would judge is judged by screenshots: those that the program writes (P),
# rendered once more from the command line where the picture is known in advance. No clock judges: what is asked for is waited for.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/support.sh
. tests/support_window.sh

# ---- A chapter without motion ----

# shellcheck disable=SC2086 # options are words
if ! start $chapter $still; then
    sed 's/^/# /' "$scratch/run/err"
    echo "# window ${window:-none}; all windows:"
    wmctrl -lp 2>&1 | sed 's/^/# /'
    not_ok 'a window opens'
    close_window
    plan
    exit
fi
ok 'a window opens'
check 'the title names chapter, view and parameter' shows '01 Normal colouring - '
check 'the title shows the parameter that the arrows change' shows ' - picture - focalLength = 2'

check 'P writes a screenshot' shoot_as first
render expected
check 'the screenshot is what -o writes with the same options' matches expected first
# The panel stands at the top, and its width changes with the figures; the keys stand at the bottom.
below() { part_shown first 320x45+0+155; }
folds() { eventually below && look unfolded && key h && eventually shown first; }
check 'H hides the overlay: the window shows the screenshot' folds
unfolded() { below && part_shown unfolded 120x90+8+8 30000; }
unfolds() { key h && eventually hidden first && eventually unfolded; }
check 'H again shows it: title, figures and parameters' unfolds
helps() { key k && eventually far_off unfolded 60000 && key k && eventually unfolded; }
check 'K shows all keys and ranges, and again fewer' helps
key h

view() { # before a screenshot draws it: the key does
    render view -v "$2" && key "$1" && shows " - $2 - " && eventually shown view &&
        shoot_as "$2" && matches view "$2"
}
check '2 shows the normals' view 2 normals
check '3 shows the depth' view 3 depth
check '4 shows the steps' view 4 steps
slice() { key 5 && shows ' - slice - ' && shoot_as slice && render view -v slice && matches view slice; }
check '5 shows the slice of the middle' slice
zooms() { xdotool mousemove --window "$window" 160 100 click 4 && shoot_as nearer && differ slice nearer && xdotool click 5 && shoot_as farther && matches slice farther; }
check 'the wheel zooms the slice in and out' zooms
another_ray() { # a click chooses it, in the slice too, and again lets it go
    xdotool mousemove --window "$window" 170 70 click 1 && eventually says out 'ray of pixel 170,129' &&
        shoot_as other && render view -v slice --probe 170,129 && matches view other &&
        xdotool click 1 && shoot_as middle && same slice middle
}
check 'a click in the slice chooses another ray' another_ray
unview() { key 1 && shows ' - picture - ' && shoot_as back && same first back; }
check '1 shows the picture again' unview

# Parameters.
changes() { # KEY TITLE
    key "$1" && shows "$2"
}
check 'down chooses the next parameter' changes Down 'normalStep = 0.001'
check 'right changes it' changes Right 'normalStep = 0.002'
check 'Shift+right changes it by ten steps, up to its range' changes shift+Right 'normalStep = 0.5'
follows_parameter() { shoot_as coarse && render wanted -p normalStep=0.5 && matches wanted coarse; }
check 'the picture follows the parameter' follows_parameter
check 'Home resets it' changes Home 'normalStep = 0.001'
check 'left changes it back' changes Left 'normalStep = 0.0005'
check 'up chooses the parameter before' changes Up 'focalLength = 2'
key Down Home Up
wheel() {
    xdotool mousemove --window "$window" 100 100 click 4 && shows 'focalLength = 2.2' &&
        shoot_as zoomed && render wanted -p focalLength=2.2 && matches wanted zoomed
}
check 'the wheel zooms' wheel
xdotool click 5
check 'and back' shows 'focalLength = 2'
key Home
tab() { key Tab && shoot_as tab && same first tab; }
check 'Tab changes nothing where there is no orthographic parameter' tab

# The mouse.
click_only() { xdotool mousemove --window "$window" 100 100 click 1 && shoot_as click && same first click; }
check 'a click without dragging turns nothing' click_only
# The click above chose a ray: pixel 100,99 counted from the bottom left.
told() { sed -n '/^ray of pixel 100,99/,/^# /p' "$scratch/run/out" | tail -n +2; }
table() {
    eventually says out 'ray of pixel 100,99' && told >"$scratch/told" || return
    # shellcheck disable=SC2086 # options are words
    "$BUILD/$chapter" $still --probe 100,99 >"$scratch/probed" && cmp "$scratch/told" "$scratch/probed"
}
check 'the click prints the numbers of --probe' table
check 'the overlay marks the pixel and shows its march' eventually hidden first
closes() { xdotool mousemove --window "$window" 100 100 click 1 && eventually shown first; }
check 'a second click on the pixel closes it' closes
drag() {
    xdotool mousemove --window "$window" 100 100 mousedown 1 mousemove_relative 60 0 \
        mousemove_relative -- 0 -40 mouseup 1 &&
        shoot_as dragged && render wanted -c 1.65,1.6,3.4,-17,-17.5 && matches wanted dragged
}
check 'dragging right and up turns right and up, 0.15 degree a pixel' drag
moves_free() {
    xdotool mousemove_relative 30 30 && shoot_as free && same dragged free
}
check 'the free pointer turns nothing' moves_free
# Where the system puts the captured pointer in the middle just then, a first move can be lost on its way.
swings() { xdotool mousemove_relative 30 0 && shoot_as captured && differ before captured; }
captured() { key m && xdotool mousemove_relative 4 0 && shoot_as before && tries=5 attempt swings; }
check 'M captures the pointer: it looks without a button' captured
freed() {
    key m && shoot_as freed && same captured freed &&
        xdotool mousemove_relative 20 20 && shoot_as still && same freed still
}
check 'M again frees it, and neither turns the view' freed

forward() { walk w && shoot_as rest && same there rest; }
check 'W moves, and its release stops' forward
for moving in a s d space c Control_L; do
    check "$moving moves" walk "$moving"
done
cancels() { xdotool keydown w keydown s && shoot_as a && shoot_as b && xdotool keyup w keyup s && same a b; }
check 'W and S together stand still' cancels
returns() { walk w && key shift+r && shoot_as again && same first again; }
check 'Shift+R brings the camera back' returns
pause_held() {
    xdotool keydown d sleep 0.1 key Escape keyup d && shows '(paused)' && shoot_as a &&
        shoot_as b && same a b && key Escape
}
check 'a key held into a pause does not drift' pause_held
# Show the desktop: the window loses the focus while the key is down, and never hears of its release.
forgets() {
    xdotool keydown w sleep 0.1 && wmctrl -k on && eventually unfocused && xdotool keyup w && wmctrl -k off &&
        xdotool windowactivate "$window" && eventually focused && shoot_as a && shoot_as b && same a b
}
check 'lost focus releases the keys that are held' forgets

# Size.
size_is() { [ "$(xdotool getwindowgeometry "$window" | awk '/Geometry/ { print $2 }')" = "$1" ]; }
rectangle() { xdotool getwindowgeometry "$window" | grep -E 'Position|Geometry'; }
rectangle_is() { [ "$(rectangle)" = "$1" ]; }
full_screen() {
    local before
    before=$(rectangle)
    key F11 && eventually size_is 1280x1024 && shoot_as full &&
        [ "$(identify -format %wx%h "$scratch/full.png")" = 1280x1024 ] &&
        key F11 && eventually rectangle_is "$before"
}
check 'F11 fills the screen, and again gives position and size back' full_screen
# What lies beyond the edge of the screen is lost.
moved_from() { ! rectangle_is "$1"; }
goes() { # X Y: there by the window manager
    local before
    before=$(rectangle)
    xdotool windowmove "$window" "$1" "$2" && eventually moved_from "$before"
}
uncovered() {
    shoot_as whole && key h && eventually hidden whole && key h && eventually shown whole &&
        goes -200 50 && goes 300 300 && eventually shown whole
}
check 'what was covered is shown again' uncovered
check 'Backspace closes the window with status 0' backspace
check 'nothing was reported' [ ! -s "$scratch/run/err" ]

# ---- Resize; reload of a reader's own copy ----

loads() { grep -c 'loaded again' "$scratch/run/out"; }
loads_are() { [ "$(loads)" = "$1" ]; }
# It looks at its files ten times a second; a screenshot takes longer than a half of that from key to file.
looks() { shoot && shoot && shoot && shoot && shoot; }
reloads() { # TEXT
    local wanted=$(($(loads) + 1))
    save "$1"
    eventually loads_are "$wanted"
}

save "$good"
# shellcheck disable=SC2086 # options are words
start $chapter $still --shader "$mine"
resize() {
    wmctrl -i -r "$window" -e 0,-1,-1,300,300 && eventually size_is 300x300 &&
        shoot_as resized && render wanted -s 300x300 && matches wanted resized
}
check 'another size keeps the aspect' resize
shoot_as original
other_sky() {
    reloads "${good/const vec3 SKY = vec3(/const vec3 SKY = 0.5 * vec3(}" && shoot_as sky &&
        differ original sky
}
check 'a saved shader is loaded again' other_sky
broken() {
    look good && save "$good
float wrong() { return undeclared; }" && shows 'error: see terminal' && shoot_as kept && same sky kept &&
        grep -q "mine.frag:[0-9]*.*undeclared" "$scratch/run/err"
}
check 'a broken one keeps the picture and names file and line' broken
check 'the overlay shows the error over the last good picture' eventually far_off good 20000
recover() {
    reloads "$good" && shoot_as recovered && same original recovered && [[ $(title) != *error* ]]
}
check 'a good one again recovers' recover
vanish() {
    : >"$scratch/run/err"
    mv "$mine" "$mine.away" && shows 'error: see terminal' && alive && looks &&
        [ "$(wc -l <"$scratch/run/err")" = 1 ] && mv "$mine.away" "$mine" &&
        eventually loads_are 3 && shoot_as again && same original again
}
check 'one that vanishes is reported once, and loaded when it is back' vanish
orthographic() {
    reloads "$good
uniform float orthographic; // 0 in [0, 1]: for this test" && key Up && shows 'orthographic = 0' &&
        key Tab && shows 'orthographic = 1' && key Tab && shows 'orthographic = 0'
}
check 'a new parameter is there, and Tab switches orthographic' orthographic
renamed() {
    key Right && reloads "$good
uniform float fresh; // 3 in [0, 4] step 0.5, scene units: for this test" && key Up && shows 'fresh = 3' &&
        key Right && shows 'fresh = 3.5' && reloads "$good
uniform float fresh; // 3 in [0, 3.2], scene units: for this test" && shows 'fresh = 3.2' && reloads "$good
uniform float fresh; // 2 in [0, 3.2], scene units: for this test" && shows 'fresh = 2'
}
check 'a parameter that is renamed, given another range or value follows at once' renamed
include() {
    cp shaders/*.glsl "$scratch" &&
        echo '// a change' >>"$scratch/march.glsl" && reloads "$good" &&
        wanted=$(($(loads) + 1)) && { echo '// another' >>"$scratch/march.glsl"; eventually loads_are "$wanted"; }
}
check 'an included file that is saved loads it again' include
asked() { wmctrl -i -c "$window" && ends_well; }
check 'a close request closes the window with status 0' asked

# ---- Reload of a texture ----

# plain NAME GREY: a picture of one grey.
plain() {
    echo "void mainImage(out vec4 c, vec2 p) { c = vec4($2); }" >"$scratch/plain.frag"
    "$BUILD/$chapter" -f "$scratch/plain.frag" -s 4x4 -o "$scratch/$1.png"
}
plain first 0.25 && plain second 0.75
put() { cp "$scratch/$1.png" "$scratch/new.png" && mv "$scratch/new.png" "$scratch/stone.png"; } # NAME
put first
# The picture is one colour: that of the texture, as a number; and that of another one.
printf '%s\n' '#include "main.glsl"' 'uniform sampler2D stone; // "stone.png" linear repeat: the one that is saved' \
    'uniform sampler2D other; // "first.png" linear repeat: the one that --texture replaces' \
    'Ray pixelRay(vec2 s) { return Ray(vec3(0.0), vec3(0.0, 0.0, -1.0)); }' 'float sceneDistance(vec3 p) { return 1.0; }' \
    'vec3 rayColour(Ray r) { return vec3(textureLod(stone, vec2(0.5), 0.0).r, textureLod(other, vec2(0.5), 0.0).r, 0.0); }' \
    >"$scratch/stone.frag"
start $chapter -s 160x100 --shader "$scratch/stone.frag" --texture other="$scratch/second.png"
colour_is() { shoot && [ "$(convert "$picture" -format '%[fx:round(255*u.p{80,50}.r)] %[fx:round(255*u.p{80,50}.g)]' info:)" = "$1" ]; }
check 'a texture is read, and --texture puts another one in' colour_is '64 191'
saved() { put second && eventually loads_are 1 && colour_is '191 191'; }
check 'a texture that is saved is loaded again' saved
broken_texture() {
    head -c 60 "$scratch/first.png" >"$scratch/new.png" && mv "$scratch/new.png" "$scratch/stone.png" &&
        shows 'error: see terminal' && colour_is '191 191' && looks && [ "$(wc -l <"$scratch/run/err")" = 1 ] &&
        grep -q 'stone.frag:2: sampler stone: .*stone.png: cannot be read' "$scratch/run/err"
}
check 'one that is broken keeps the last good picture, and says so once, with file and line' broken_texture
mended() { put first && eventually loads_are 2 && colour_is '64 191' && [[ $(title) != *error* ]]; }
check 'a good one again recovers' mended
vanished() {
    : >"$scratch/run/err"
    rm "$scratch/stone.png" && shows 'error: see terminal' && colour_is '64 191' && put second &&
        eventually loads_are 3 && colour_is '191 191' && [ "$(wc -l <"$scratch/run/err")" = 1 ]
}
check 'one that vanishes is reported once, and loaded when it is back' vanished
put_in() {
    cp "$scratch/first.png" "$scratch/new.png" && mv "$scratch/new.png" "$scratch/second.png" &&
        eventually loads_are 4 && colour_is '191 64'
}
check 'the one that was put in is watched too' put_in
check 'Backspace closes it' backspace

printf '%s\n' '#include "main.glsl"' 'uniform sampler2D stone; // "granite.png" sRGB repeat: a picture' \
    'uniform highp sampler3D cloud; // "noise.png" linear repeat 64: a volume' \
    'Ray pixelRay(vec2 s) { return Ray(vec3(s, 0.7), vec3(0.0, 0.0, -1.0)); }' 'float sceneDistance(vec3 p) { return 1.0; }' \
    'vec3 rayColour(Ray r) { return mix(textureGrad(stone, r.origin.xy, vec2(0.01, 0.0), 0.3 * r.origin.xy).rgb, textureLod(cloud, r.origin, 1.5).rgb, 0.5); }' \
    >"$scratch/both.frag"
hidden_window() {
    for backend in egl osmesa glfw; do
        "$BUILD/$chapter" -s 160x90 -f "$scratch/both.frag" -b $backend -o "$scratch/$backend.png" 2>"$scratch/said" ||
            { [ $backend = osmesa ] && cp "$scratch/egl.png" "$scratch/osmesa.png"; } || return # newer Mesa has no OSMesa
    done
    same egl osmesa && same egl glfw
}
if [ "${SYSTEM-}" = Windows ]; then
    skip 'a hidden window and the backends without one read the same textures, to the bit' 'there is GLFW alone'
else
    check 'a hidden window and the backends without one read the same textures, to the bit' hidden_window
fi

# ---- Shadertoy's mouse ----

# The picture shows iMouse and the day of iDate; the same with numbers in their place must match.
# toy X Y Z W YEAR MONTH DAY: the text.
toy() {
    cat <<GLSL
void mainImage(out vec4 c, in vec2 p) {
    vec4 m = vec4($1, $2, $3, $4);
    vec3 d = vec3($5, $6, $7);
    if (p.x < 60.0) c = vec4(m.x / 320.0, m.y / 200.0, sign(m.z) * 0.5 + 0.5, 1.0);
    else if (p.x < 120.0) c = vec4(abs(m.zw) / 320.0, sign(m.w) * 0.5 + 0.5, 1.0);
    else c = vec4(d.x / 4000.0, d.y / 12.0, d.z / 31.0, 1.0);
}
GLSL
}
toy iMouse.x iMouse.y iMouse.z iMouse.w iDate.x iDate.y iDate.z >"$scratch/toy.frag"
mouse_is() { # X Y Z W
    # shellcheck disable=SC2046 # three words
    toy "$@" $(date '+%Y. %m.-1. %d.') >"$scratch/wanted.frag"
    render wanted -f "$scratch/wanted.frag" && shoot_as mouse && matches wanted mouse
}
# shellcheck disable=SC2086 # options are words
start $chapter $still -f "$scratch/toy.frag"
check "iMouse is zero before a press, iDate is today" mouse_is 0. 0. 0. 0.
holds_mouse() {
    xdotool mousemove --window "$window" 100 80 mousedown 1 mousemove --window "$window" 160 150 &&
        shoot && mouse_is 160. 50. 100. -120. # after the frame of the press
}
check 'held: xy the position, zw the press, z positive' holds_mouse
lets_go() { xdotool mouseup 1 mousemove --window "$window" 30 30 && mouse_is 160. 50. -100. -120.; }
check 'let go: the position stays, z is negative' lets_go
check 'Backspace closes it' backspace

# ---- A click that aims ----

# A click drives the parameter aim of chapter 10: the picture is the one that --set aim gives for the place of
# that pixel's centre, 100 from the left and 80 from the top. Half the picture's height shows 1.2 units.
still_sheet='--size 320x200 --camera 0,0,2.4,0,0'
aims() {
    local place
    place=$(awk 'BEGIN { x = (2 * 100 + 1 - 320) / 200 * 1.2; y = (2 * (199 - 80) + 1 - 200) / 200 * 1.2; printf "%.9g,%.9g", x, y }')
    # shellcheck disable=SC2086 # options are words
    "$BUILD/10_distance_in_the_plane" $still_sheet --set aim="$place" --output "$scratch/aimed.png" >/dev/null &&
        xdotool mousemove --window "$window" 100 80 click 1 && shoot_as aim && matches aimed aim
}
# shellcheck disable=SC2086 # options are words
start 10_distance_in_the_plane $still_sheet
key h # the place is below the panel
check 'a click aims the ray of chapter 10' aims
check 'Backspace closes it' backspace

# ---- Two passes ----

# The picture of a window and the march of its slice begin where the coarse pass has ended.
both_passes() {
    render expected -f "$coarse" && shoot_as shown && matches expected shown && render expected -f "$coarse" -v slice &&
        key 5 && shows ' - slice - ' && shoot_as sliced && matches expected sliced
}
coarse=$root/tests/shaders/coarse.frag
# shellcheck disable=SC2086 # options are words
start $chapter $still -f "$coarse"
check 'a picture of two passes is what -o writes, and so is its slice' both_passes
check 'Backspace closes it' backspace

close_window
plan
