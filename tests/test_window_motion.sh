#!/bin/bash
# test_window_motion.sh - the window while something moves: a heavy shader is coarser and sharpens at
# rest, every chapter is fast enough, the time runs and is held, a French keyboard walks by place.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/support.sh
. tests/support_window.sh

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
# P before it is sharp: the window goes on, the picture comes when it is complete.
wrote() { says out "$(basename "$picture"): written"; }
other_title() { [ "$(title)" != "$before" ]; }
early() {
    shots=$((shots + 1))
    picture=$scratch/run/$(printf '%s-%04d.png' $chapter "$shots")
    key Right Left && within 2 coarse_above && sleep 0.3 && before=$(title) && key p Up && within 2 other_title && ! wrote &&
        within 20 wrote && cmp -s "$picture" "$scratch/first.png"
}
check 'a screenshot of a heavy picture does not hold the window up' early
check 'Backspace closes it' backspace

# All rows of one time, though it takes many turns.
cat >"$scratch/heavy.frag" <<'GLSL'
void mainImage(out vec4 c, vec2 p)
{
    float sum;
    for (int i = 0; i < 5000; i++)
        sum += sin(sum + float(i) + p.x);
    c = vec4(fract(iTime), 1.0, 1e-9 * sum, 1.0);
}
GLSL
start $chapter -s 480x300 --shader "$scratch/heavy.frag"
one_time() { shoot $chapter && [ "$(convert "$picture" -format %k info:)" = 1 ]; }
check 'nor does that of a heavy one that moves, and it is of one time' one_time
goes_on() { look before && sleep 0.5 && look screen && ! same before screen; }
check 'which then goes on' within 5 goes_on
check 'Backspace closes it' backspace

# ---- How fast ----

# Hold keys that move for a while, and read the title's rate: the picture goes to and fro until two rates
# are good. The first ones are those of a window that still finds its resolution.
fps() { title | sed -n 's/.* \([0-9][0-9]*\) fps.*/\1/p'; }
fast() { # NAME OPTION...: at least 10 frames a second at 640x360
    local name=$1 i rate rates='' good=0
    shift
    start "$@" -s 640x360 || return 1
    for i in d a d a d a d a; do
        xdotool keydown $i sleep 0.35 keyup $i
        rate=$(fps) rates="$rates $rate"
        [ "${rate:-0}" -ge 10 ] && good=$((good + 1))
        [ $good -lt 2 ] || break
    done
    key BackSpace
    ends_well || return 1
    echo "# $name: frames a second:$rates"
    [ $good = 2 ]
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
        local keyboard
        key k && sleep 0.3 && look french || return
        for keyboard in american french; do
            convert "$scratch/$keyboard.png" -crop 640x70+0+290 +repage "$scratch/$keyboard-keys.png" || return
        done
        [ "$(apart american-keys french-keys)" -gt 30 ]
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

close_window
plan
