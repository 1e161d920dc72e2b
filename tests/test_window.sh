#!/bin/bash
# test_window.sh - the interactive window under Xvfb, with real key, mouse, wheel, resize, reload and
# close events. What the eye would judge is judged by screenshots: those that the program writes (P),
# rendered once more from the command line where the picture is known in advance.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/support.sh

chapter=01_normal_colouring
still='-s 320x200 -c 1.65,1.6,3.4,-26,-23.5'
program='' window='' shots=0 picture=''

# ---- Tools ----

# within SECONDS COMMAND...: wait until the command succeeds.
within() {
    local tries=$(($1 * 20))
    shift
    while ! "$@"; do
        tries=$((tries - 1))
        [ "$tries" -gt 0 ] || return 1
        sleep 0.05
    done
}

title() { xdotool getwindowname "$window" 2>/dev/null; }
titled() { [[ $(title) == *"$1"* ]]; }
shows() { within 5 titled "$1" || { echo "# the title is: $(title)"; return 1; }; }
says() { grep -qF -e "$2" "$scratch/run/$1"; }
alive() { kill -0 "$program" 2>/dev/null; }
key() { xdotool key --delay 20 "$@"; }

find_window() {
    window=$(wmctrl -lp 2>/dev/null | awk -v pid="$program" '$3 == pid { print $1; exit }')
    [ -n "$window" ]
}

# Start STEM OPTION... in a window, with its own folder for what it writes.
start() {
    local stem=$1
    shift
    shots=0
    rm -rf "$scratch/run"
    mkdir "$scratch/run"
    (cd "$scratch/run" && exec "$root/$BUILD/$stem" "$@" >out 2>err) &
    program=$!
    within 20 find_window && xdotool windowfocus --sync "$window" && within 20 drawn
}

# The first frame is there: the pixels in the middle are no longer all of one colour.
drawn() {
    [ "$(import -window "$window" -crop 200x100+60+40 -format %k info: 2>/dev/null)" -gt 1 ] 2>/dev/null
}

# Press P and wait for the file: $picture.
shoot() {
    shots=$((shots + 1))
    picture=$scratch/run/$(printf '%s-%04d.png' "$1" "$shots")
    key p
    within 20 says out "$(basename "$picture"): written"
}

# shoot_as NAME: a screenshot of the chapter, kept under a name.
shoot_as() { shoot $chapter && cp "$picture" "$scratch/$1.png"; }
same() { cmp -s "$scratch/$1.png" "$scratch/$2.png"; }
differ() { ! same "$1" "$2"; }

# Render NAME OPTION...: what the command line makes of it.
render() {
    local name=$1
    shift
    # shellcheck disable=SC2086 # options are words
    "$BUILD/$chapter" $still "$@" -o "$scratch/$name.png" >"$scratch/table"
}
matches() { build/tests/compare "$scratch/$1.png" "$scratch/$2.png" >"$scratch/numbers" || {
    echo "# $1 and $2: $(cat "$scratch/numbers")"
    return 1
}; }

# The program ended by itself with status 0.
ended() { ! alive; }
ends_well() {
    within 5 ended || { kill "$program"; return 1; }
    wait "$program"
}

close_window() {
    alive && kill "$program" 2>/dev/null
    wait "$program" 2>/dev/null
}

# ---- Set-up ----

for tool in Xvfb openbox xdotool wmctrl import; do
    if ! command -v $tool >/dev/null; then
        skip 'the interactive window' "no $tool on this machine: make setup"
        plan
        exit
    fi
done
open_scratch
if ! open_display; then
    skip 'the interactive window' 'Xvfb did not start'
    plan
    exit
fi
openbox >/dev/null 2>&1 &
managed() { wmctrl -m >/dev/null 2>&1; }
within 10 managed || echo '# openbox did not start'

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
folds() { import -window "$window" "$scratch/folded.png" && key h && sleep 0.3; }
check 'H is pressed' folds
# A driver may round the half between two levels either way: then pixels differ by 1, not by 3.
on_screen() {
    import -window "$window" "$scratch/screen.png" &&
        build/tests/compare "$scratch/first.png" "$scratch/screen.png" | grep -q '^F2 0.0000'
}
check 'H hides the overlay: the window shows the screenshot' within 3 on_screen
unfolds() { key h && within 3 off_screen && within 3 screen_is folded; }
off_screen() { ! on_screen; }
screen_is() { [ "$(import -window "$window" png:- | compare -metric AE "$scratch/$1.png" - null: 2>&1)" -lt 400 ]; }
check 'H again shows it: title, figures and parameters' unfolds
helps() { key k && within 3 helped && key k && within 3 screen_is folded; }
helped() { [ "$(import -window "$window" png:- | compare -metric AE "$scratch/folded.png" - null: 2>&1)" -gt 4000 ]; }
check 'K shows all keys and ranges, and again fewer' helps
key h

screen_matches() { import -window "$window" "$scratch/screen.png" && build/tests/compare "$scratch/$1.png" "$scratch/screen.png" | grep -q '^F2 0.0000'; }
view() { # before a screenshot draws it: the key does
    render view -v "$2" && key "$1" && shows " - $2 - " && within 3 screen_matches view &&
        shoot_as "$2" && matches view "$2"
}
check '2 shows the normals' view 2 normals
check '3 shows the depth' view 3 depth
check '4 shows the steps' view 4 steps
slice() { key 5 && shows ' - slice - ' && shoot_as slice && render view -v slice && matches view slice; }
check '5 shows the slice of the middle' slice
zooms() { xdotool click 4 && shoot_as nearer && differ slice nearer && xdotool click 5 && shoot_as farther && matches slice farther; }
check 'the wheel zooms the slice in and out' zooms
another_ray() { # a click chooses it, in the slice too, and again lets it go
    xdotool mousemove --window "$window" 170 70 click 1 && within 5 says out 'ray of pixel 170,129' &&
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
    within 5 says out 'ray of pixel 100,99' && told >"$scratch/told" || return
    # shellcheck disable=SC2086 # options are words
    "$BUILD/$chapter" $still --probe 100,99 >"$scratch/probed" && cmp "$scratch/told" "$scratch/probed"
}
check 'the click prints the numbers of --probe' table
inspects() { within 3 off_screen; }
check 'the overlay marks the pixel and shows its march' inspects
closes() { xdotool mousemove --window "$window" 100 100 click 1 && within 3 on_screen; }
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
captured() {
    key m && xdotool mousemove_relative 4 0 && sleep 0.1 &&
        shoot_as before && xdotool mousemove_relative 30 0 && shoot_as captured && differ before captured
}
check 'M captures the pointer: it looks without a button' captured
freed() {
    key m && shoot_as freed && same captured freed &&
        xdotool mousemove_relative 20 20 && shoot_as still && same freed still
}
check 'M again frees it, and neither turns the view' freed

# Movement.
walk() { # KEY
    xdotool keydown "$1" sleep 0.15 keyup "$1"
}
forward() {
    walk w && shoot_as near && differ freed near && sleep 0.2 && shoot_as rest && same near rest
}
check 'W moves, and its release stops' forward
for moving in a s d space c Control_L; do
    moves() { shoot_as here && walk "$moving" && shoot_as there && differ here there; }
    check "$moving moves" moves
done
cancels() { xdotool keydown w keydown s sleep 0.2 && shoot_as a && sleep 0.2 && shoot_as b && xdotool keyup w keyup s && same a b; }
check 'W and S together stand still' cancels
returns() { walk w && key shift+r && shoot_as again && same first again; }
check 'Shift+R brings the camera back' returns
pause_held() {
    xdotool keydown d sleep 0.1 key Escape keyup d && shows '(paused)' && shoot_as a && sleep 0.2 &&
        shoot_as b && same a b && key Escape
}
check 'a key held into a pause does not drift' pause_held
# Show the desktop: the window loses the focus while the key is down, and never hears of its release.
unfocused() {
    xdotool keydown w sleep 0.1 && wmctrl -k on && sleep 0.3 && xdotool keyup w && wmctrl -k off &&
        xdotool windowactivate --sync "$window" && sleep 0.1 && shoot_as a && sleep 0.2 &&
        shoot_as b && same a b
}
check 'lost focus releases the keys that are held' unfocused

# Size.
size_is() { [ "$(xdotool getwindowgeometry "$window" | awk '/Geometry/ { print $2 }')" = "$1" ]; }
place() { xdotool getwindowgeometry "$window" | grep -E 'Position|Geometry'; }
full_screen() {
    local before
    before=$(place)
    key F11 && within 5 size_is 1280x1024 && shoot_as full &&
        [ "$(identify -format %wx%h "$scratch/full.png")" = 1280x1024 ] &&
        key F11 && within 5 size_is 320x200 && sleep 0.2 && [ "$(place)" = "$before" ]
}
check 'F11 fills the screen, and again gives place and size back' full_screen
backspace() { key BackSpace && ends_well; }
check 'Backspace closes the window with status 0' backspace
check 'nothing was reported' [ ! -s "$scratch/run/err" ]

# ---- Resize; reload of a reader's own copy ----

mine=$scratch/mine.frag
good=$(cat chapters/$chapter.frag)
save() { # TEXT: as an editor does it, beside and renamed
    printf '%s\n' "$1" >"$mine.new" && mv "$mine.new" "$mine"
}
loads() { grep -c 'loaded again' "$scratch/run/out"; }
loads_are() { [ "$(loads)" = "$1" ]; }
reloads() { # TEXT
    local wanted=$(($(loads) + 1))
    save "$1"
    within 5 loads_are "$wanted"
}

save "$good"
# shellcheck disable=SC2086 # options are words
start $chapter $still --shader "$mine"
resize() {
    wmctrl -i -r "$window" -e 0,-1,-1,300,300 && within 5 size_is 300x300 && sleep 0.2 &&
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
    import -window "$window" "$scratch/good.png" && save "$good
float wrong() { return undeclared; }" && shows 'error: see terminal' && shoot_as kept && same sky kept &&
        grep -q "mine.frag:[0-9]*.*undeclared" "$scratch/run/err"
}
check 'a broken one keeps the picture and names file and line' broken
error_shown() { [ "$(import -window "$window" png:- | compare -metric AE "$scratch/good.png" - null: 2>&1)" -gt 2000 ]; }
check 'the overlay shows the error over the last good picture' within 3 error_shown
recover() {
    reloads "$good" && shoot_as recovered && same original recovered && [[ $(title) != *error* ]]
}
check 'a good one again recovers' recover
vanish() {
    : >"$scratch/run/err"
    mv "$mine" "$mine.away" && shows 'error: see terminal' && alive && sleep 0.5 &&
        [ "$(wc -l <"$scratch/run/err")" = 1 ] && mv "$mine.away" "$mine" &&
        within 5 loads_are 3 && shoot_as again && same original again
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
half() { # a slow editor: no half of a file is loaded or reported
    local wanted=$(($(loads) + 1)) before
    before=$(wc -l <"$scratch/run/err")
    { printf '%s' "${good:0:400}"; sleep 0.06; printf '%s\n' "${good:400}"; } >"$mine"
    within 5 loads_are "$wanted" && [ "$(wc -l <"$scratch/run/err")" = "$before" ]
}
check 'a file that is written in two halves is read once it is whole' half
soon() { # 500 ms, and 50 more of the waiting here
    local begin
    begin=$(date +%s%N)
    reloads "$good
// again" && [ $((($(date +%s%N) - begin) / 1000000)) -le 550 ]
}
check 'a saved file is shown within half a second' soon
include() {
    cp shaders/*.glsl "$scratch" &&
        echo '// a change' >>"$scratch/march.glsl" && reloads "$good" &&
        wanted=$(($(loads) + 1)) && { echo '// another' >>"$scratch/march.glsl"; within 5 loads_are "$wanted"; }
}
check 'an included file that is saved loads it again' include
asked() { wmctrl -i -c "$window" && ends_well; }
check 'a close request closes the window with status 0' asked

# ---- A heavy shader ----

# The same picture, whose every pixel waits in a loop that no compiler can leave out.
heavy() { # TURNS
    save "${good/vec3 rayColour(/vec3 rayColourOnce(}
vec3 rayColour(Ray ray)
{
    float sum = 0.0;
    for (int i = 0; i < $1; i++)
        sum += sin(sum + float(i) + ray.direction.x);
    return rayColourOnce(ray) + 1e-9 * sum;
}"
}
heavy 6000
# shellcheck disable=SC2086 # options are words
start $chapter $still -s 480x300 --shader "$mine"
key h
# coarse IMAGE FROM ROWS: of these rows at least every second one is the row above it. They cross
# balls, so that no two rows of a sharp picture are the same.
coarse() {
    [ "$(convert "$scratch/$1.png" -crop "480x$3+0+$2" +repage -depth 8 rgb:- | od -An -v -tx1 -w1440 | uniq | wc -l)" -le $(($3 / 2 + 1)) ]
}
look() { import -window "$window" "$scratch/$1.png"; }
coarse_above() { look screen && coarse screen 60 60; }
fine_screen() { look screen && ! coarse screen 60 60 && ! coarse screen 180 60; }
half_sharp() { look screen && ! coarse screen 60 60 && coarse screen 180 60; }
check 'a heavy picture at rest becomes sharp' within 20 fine_screen
moving() { xdotool keydown d && within 3 coarse_above; local done=$?; xdotool keyup d; return $done; }
check 'while something moves it is coarser' moving
check 'at rest it sharpens from the top down' within 10 half_sharp
answers() { # H answers at once, and interrupts nothing
    cp "$scratch/screen.png" "$scratch/good.png" && key h && within 1 error_shown &&
        key h && look screen && ! coarse screen 60 60
}
check 'while it sharpens H is answered' answers
abandons() { key Right && within 2 coarse_above && key Left && within 10 half_sharp; }
check 'a change while it sharpens begins anew' abandons
sharpens() { within 20 fine_screen && shoot_as first && within 5 on_screen; }
check 'once it rested it is the screenshot' sharpens
check 'Backspace closes it' backspace

# ---- How fast ----

# Hold keys that move for a while, and read the title's rate: the picture goes to and fro.
fps() { title | sed -n 's/.* \([0-9][0-9]*\) fps.*/\1/p'; }
fast() { # NAME OPTION...: at least 10 frames a second at 640x360
    local name=$1 i rates=''
    shift
    start "$@" -s 640x360 || return 1
    for i in d a d; do
        xdotool keydown $i sleep 0.35 keyup $i
        rates="$rates $(fps)"
    done
    key BackSpace
    ends_well || return 1
    echo "# $name: frames a second:$rates"
    [ "$(tr ' ' '\n' <<<"$rates" | sort -n | tail -n 2 | head -n 1)" -ge 10 ]
}
for source in chapters/[0-9][0-9]_*.c; do
    stem=$(basename "$source" .c)
    check "$stem moves with at least 10 frames a second" fast "$stem" "$stem"
done
# build/tests/measure speed counts about 7 and 120 times the processor time of the report's annex
# for them: the first is drawn sharp on two free cores, the second cannot be.
for turns in 110 2000; do
    heavy $turns
    check "a shader of $turns sines a pixel moves with at least 10 frames a second" \
        fast "$turns sines" $chapter --shader "$mine"
done

# ---- A French keyboard ----

if ! command -v setxkbmap >/dev/null; then
    skip 'a French keyboard' 'no setxkbmap on this machine'
else
    # shellcheck disable=SC2086 # options are words
    start $chapter $still -s 640x360
    key k && sleep 0.3 && look american && key BackSpace && ends_well
    setxkbmap fr
    # shellcheck disable=SC2086 # options are words
    start $chapter $still -s 640x360
    # The labels Z Q and the comma in place of W A and M: a few hundred pixels of the list of keys.
    labels() {
        key k && sleep 0.3 && look french &&
            [ "$(convert "$scratch/american.png" "$scratch/french.png" -crop 640x70+0+290 +repage \
                -metric AE -compare -format '%[distortion]' info:)" -gt 30 ]
    }
    check 'on a French keyboard the overlay shows its labels' labels
    frenchwalk() { shoot_as a && walk z && shoot_as b && differ a b && walk w && shoot_as c && same b c; }
    check 'Z, in the place of W, moves; W, in the place of Z, does not' frenchwalk
    setxkbmap us
    check 'Backspace closes it' backspace
fi

# ---- A chapter that moves by itself ----

start 00_first_scene -s 320x200
frame() { shoot 00_first_scene && cp "$picture" "$scratch/$1.png"; }
runs() { frame a && sleep 0.1 && frame b && differ a b; }
check 'time runs' runs
counted() { [[ $(title) =~ \ [0-9]+\ fps ]]; }
rate() { within 5 counted; }
check 'the title counts frames' rate
pauses() { key Escape && shows '(paused)' && frame a && sleep 0.3 && frame b && same a b; }
check 'Escape pauses it' pauses
# How many pixels of the screen differ from what it was before.
changed() { import -window "$window" png:- | compare -metric AE "$scratch/before.png" - null: 2>&1; }
refusal_shown() { [ "$(changed)" -gt 1000 ]; }
refusal_gone() { [ "$(changed)" -lt 400 ]; }
refuses() {
    import -window "$window" "$scratch/before.png" && key 4 && within 3 refusal_shown && shows ' - picture' &&
        key 1 && within 3 refusal_gone
}
check 'a view that a whole file has not is refused in the overlay, until the next key of a view' refuses
idles() { # less than a tenth of a second of processor time in a second
    local before after
    before=$(awk '{ print $14 + $15 }' "/proc/$program/stat")
    sleep 1
    after=$(awk '{ print $14 + $15 }' "/proc/$program/stat")
    [ $((after - before)) -le 10 ]
}
if [ -e "/proc/$program/stat" ]; then
    check 'a paused window costs nearly no processor time' idles
fi
restarts() {
    key r && frame begin && "$BUILD/00_first_scene" -s 320x200 -t 0 -o "$scratch/zero.png" &&
        matches zero begin
}
check 'R restarts the time' restarts
resumes() { key Escape && sleep 0.2 && frame a && differ begin a; }
check 'Escape again resumes' resumes
check 'Backspace closes it' backspace

# ---- A whole file that reads OrthoView ----

# Red is OrthoView.
printf '%s\n' '#version 330 core' 'in vec2 FragCoord;' 'in float OrthoView;' 'out vec4 FragColor;' \
    'void main() { FragColor = vec4(OrthoView, step(0.0, FragCoord.x), 0.0, 1.0); }' >"$scratch/whole.frag"
start 00_first_scene -s 160x100 --shader "$scratch/whole.frag"
red() { shoot 00_first_scene && red=$(convert "$picture" -format '%[fx:round(255*u.p{80,50}.r)]' info:); }
red_is() { red && [ "$red" = "$1" ]; }
perspective() { red_is 0; }
check 'OrthoView is 0 at first' perspective
passes() { # a screenshot may come too late: several tries
    local try
    for try in 1 2 3 4 5; do
        key Tab && red && [ "$red" -gt 0 ] && [ "$red" -lt 255 ] && return
        echo "# try $try: $red"
        sleep 0.6
    done
    return 1
}
check 'Tab leads it through values between 0 and 1' passes
arrives() { red_is 0 || red_is 255; }
check 'up to an end' within 3 arrives
other() { local end=$red; key Tab && sleep 0.6 && red_is $((255 - end)); }
check 'and again to the other end' other
check 'Backspace closes it' backspace

# What follows the time though the view does not: the march of the chosen ray.
look_and_wait() { look before && sleep 0.4 && [ "$(changed)" -gt "$1" ]; }
start 03_shadows -s 640x360 -v normals
stands_still() { ! look_and_wait 0; } # nothing is shown that moves, once it is sharp
key h
check 'the normals stand still while the lamp moves' within 3 stands_still
counts() { xdotool mousemove --window "$window" 380 200 click 1 && sleep 0.3 && within 3 look_and_wait 5; }
check 'the inspector counts the steps of shadow rays as the lamp moves' counts
check 'Backspace closes it' backspace
start 00_first_scene -s 640x360 -f "$root/chapters/experiments/00_seen.frag" -v slice
key h
check 'the slice follows a camera that turns' look_and_wait 1000
slice_paused() { key Escape && shows '(paused)' && within 3 stands_still; }
check 'and stands still when it is paused' slice_paused
check 'Backspace closes it' backspace

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
    render wanted -f "$scratch/wanted.frag" && shoot $chapter && cp "$picture" "$scratch/mouse.png" &&
        matches wanted mouse
}
# shellcheck disable=SC2086 # options are words
start $chapter $still -f "$scratch/toy.frag"
check "iMouse is zero before a press, iDate is today" mouse_is 0. 0. 0. 0.
holds_mouse() {
    xdotool mousemove --window "$window" 100 80 mousedown 1 mousemove --window "$window" 160 150 &&
        sleep 0.3 && mouse_is 160. 50. 100. -120.
}
check 'held: xy the place, zw the press, z positive' holds_mouse
lets_go() { xdotool mouseup 1 mousemove --window "$window" 30 30 && sleep 0.3 && mouse_is 160. 50. -100. -120.; }
check 'let go: the place stays, z is negative' lets_go
check 'Backspace closes it' backspace

close_window
plan
