#!/bin/bash
# test_window_motion.sh - the window while something moves: a heavy shader is coarser and sharpens at
# rest, every chapter moves, the time runs and is held, a French keyboard walks by position.
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
heavy 2500
# shellcheck disable=SC2086 # options are words
start $chapter $still -s 480x300 --shader "$mine"
key h
# How the window shows rows 60 to 120, and 180 to 240, at the right, where no panel is: 'fine' where the outlines of
# balls are steps from one pixel to the next, with next to no change on either side. A picture that is enlarged by a
# filter takes several pixels for each; one that is enlarged by blocks would have such steps too.
grain() {
    import -window "$window" -crop 240x180+240+60 -colorspace gray -depth 8 gray:- | od -An -v -tu1 -w240 | awk '
        function flat(i) { return $i - $(i - 1) <= 6 && $(i - 1) - $i <= 6 }
        {
            part = NR <= 60 ? 1 : NR <= 120 ? 2 : 3
            for (i = 3; i < NF; i++)
                if (($i - $(i - 1) > 30 || $(i - 1) - $i > 30) && flat(i - 1) && flat(i + 1))
                    steps[part]++
        }
        END { print (steps[1] < 5 ? "coarse" : "fine"), (steps[3] < 5 ? "coarse" : "fine") }'
}
coarse_above() { [[ $(grain) == coarse* ]]; }
fine_screen() { [ "$(grain)" = 'fine fine' ]; }
# Between coarse and sharp lies a moment that may be over before somebody looks: then it is begun anew.
again() { key Right Left; }
half_sharp() {
    case $(grain) in
    'fine coarse') ;;
    'fine fine') again && false ;;
    *) false ;;
    esac
}
coarse_again() { again && coarse_above; }
check 'a heavy picture at rest becomes sharp' eventually fine_screen
# To and fro, so that there is always something to be seen.
swing() { while [ -e "$scratch/swings" ]; do xdotool keydown d sleep 0.2 keyup d keydown a sleep 0.2 keyup a; done; }
moving() {
    local done=0
    : >"$scratch/swings"
    swing &
    local hand=$!
    for _ in 1 2 3; do
        eventually coarse_above && look before && eventually far_off before 1000 && eventually coarse_above || done=1
    done
    rm "$scratch/swings"
    wait $hand
    key shift+r
    return $done
}
check 'while something moves it is coarser, and moves on' moving
# What is seen behind a key may be older than what the key does, but not by several turns of the window, as from
# coarse to half sharp.
downwards() { eventually coarse_again && eventually half_sharp; }
check 'at rest it sharpens from the top down' downwards
panel_over() { [ "$(off before 130x20+8+8)" -gt 100000 ]; }
answers() { # H answers, and interrupts nothing; where it seems to, a key from before may have come late
    local try
    for try in 1 2 3; do
        [ "$try" = 1 ] || downwards || return
        look before && key h && eventually panel_over && key h && ! coarse_above && return
    done
    return 1
}
check 'while it sharpens H is answered' answers
abandons_once() { half_sharp && coarse_again; }
abandons() { eventually abandons_once && eventually half_sharp; }
check 'a change while it sharpens begins anew' abandons
sharpens() { eventually fine_screen && shoot_as first && eventually shown first; }
check 'once it rested it is the screenshot' sharpens
# P before it is sharp: the window goes on, the picture comes when it is complete.
wrote() { says out "$(basename "$picture"): written"; }
other_title() { [ "$(title)" != "$before" ]; }
early() {
    shots=$((shots + 1))
    picture=$scratch/run/$(printf '%s-%04d.png' $chapter "$shots")
    eventually coarse_again && before=$(title) && key p Up && eventually other_title && ! wrote &&
        eventually wrote
}
early_one() { early && cmp -s "$picture" "$scratch/first.png"; }
check 'a screenshot of a heavy picture does not hold the window up' early_one
check 'Backspace closes it' backspace

# The overlay covers the left: at the right the picture is the same, and sharp.
# shellcheck disable=SC2086 # options are words
start $chapter $still -s 480x300 --overlay --shader "$mine"
early_overlaid() {
    early && cp "$picture" "$scratch/overlaid.png" && [ "$(apart first overlaid 180x300+300+0)" = 0 ] &&
        [ "$(apart first overlaid)" -gt 10000 ]
}
check 'nor does one with the overlay' early_overlaid
check 'Backspace closes it' backspace

# All rows of one time, though it takes many turns.
cat >"$scratch/heavy.frag" <<'GLSL'
void mainImage(out vec4 c, vec2 p)
{
    float sum;
    for (int i = 0; i < 2500; i++)
        sum += sin(sum + float(i) + p.x);
    c = vec4(fract(iTime), 1.0, 1e-9 * sum, 1.0);
}
GLSL
start $chapter -s 480x300 --shader "$scratch/heavy.frag"
one_time() { shoot && [ "$(convert "$picture" -format %k info:)" = 1 ]; }
check 'nor does that of a heavy one that moves, and it is of one time' one_time
goes_on() { look before && eventually far_off before 500000; }
check 'which then goes on' goes_on
check 'Backspace closes it' backspace

# ---- Every chapter ----

moves() { # STEM
    start "$1" -s 320x180 && walk d && backspace && [ ! -s "$scratch/run/err" ]
}
for source in chapters/[0-9][0-9]_*.c; do
    check "$(basename "$source" .c) opens, moves and closes" moves "$(basename "$source" .c)"
done

# ---- A French keyboard ----

if ! command -v setxkbmap >/dev/null; then
    skip 'a French keyboard' 'no setxkbmap on this machine'
else
    # The labels Z Q and the comma in place of W A and M, over a picture of one colour: the list of keys
    # stands at the bottom.
    echo 'void mainImage(out vec4 c, in vec2 p) { c = vec4(0.3); }' >"$scratch/flat.frag"
    below=640x70+0+290
    keys() { # NAME
        start $chapter -s 640x360 -f "$scratch/flat.frag" && look before && key k && eventually far_off before 60000 &&
            cp "$scratch/screen.png" "$scratch/$1.png" && backspace
    }
    labels() {
        keys american && keys again && [ "$(apart american again "$below")" = 0 ] && setxkbmap fr && keys french &&
            [ "$(apart american french "$below")" -gt 600 ]
    }
    check 'on a French keyboard the overlay shows its labels' labels
    # shellcheck disable=SC2086 # options are words
    start $chapter $still -s 640x360
    frenchwalk() { walk z && xdotool keydown w sleep 0.15 keyup w && shoot_as a && same there a; }
    check 'Z, in the place of W, moves; W, in the place of Z, does not' frenchwalk
    setxkbmap us
    check 'Backspace closes it' backspace
fi

# ---- A chapter that moves by itself ----

start 00_first_scene -s 320x200
runs() { shoot_as a && shoot_as b && differ a b; }
check 'time runs' runs
counted() { [[ $(title) =~ \ [0-9]+\ fps ]]; }
check 'the title counts frames' eventually counted
pauses() { key Escape && shows '(paused)' && shoot_as a && shoot_as b && same a b; }
check 'Escape pauses it' pauses
refuses() {
    look before && key 4 && eventually far_off before 15000 && shows ' - picture' && key 1 && eventually part_shown before 320x60+0+140
}
check 'a view that a whole file has not is refused in the overlay, until the next key of a view' refuses
# Ticks of the processor in which the program worked, in hundredths of a second.
worked() { awk '{ print $14 + $15 }' "/proc/$program/stat"; }
idles() { # a loop that never waits would work all the time
    local before
    before=$(worked) && sleep 1 && [ $(($(worked) - before)) -le 25 ]
}
if [ -e "/proc/$program/stat" ]; then
    check 'a paused window costs little processor time' eventually idles
fi
restarts() {
    key r && shoot_as begin && "$BUILD/00_first_scene" -s 320x200 -t 0 -o "$scratch/zero.png" &&
        matches zero begin
}
check 'R restarts the time' restarts
resumes() { key Escape && shoot_as a && shoot_as b && differ a b; }
check 'Escape again resumes' resumes
check 'Backspace closes it' backspace

# ---- A whole file that reads OrthoView ----

# Red is OrthoView.
printf '%s\n' '#version 330 core' 'in vec2 FragCoord;' 'in float OrthoView;' 'out vec4 FragColor;' \
    'void main() { FragColor = vec4(OrthoView, step(0.0, FragCoord.x), 0.0, 1.0); }' >"$scratch/whole.frag"
start 00_first_scene -s 160x100 --shader "$scratch/whole.frag"
red() { shoot && red=$(convert "$picture" -format '%[fx:round(255*u.p{80,50}.r)]' info:); }
red_is() { red && [ "$red" = "$1" ]; }
perspective() { red_is 0; }
check 'OrthoView is 0 at first' perspective
arrives() { red_is 0 || red_is 255; }
passes() { # a busy machine may see both keys at once: then they are farther apart
    local pause
    for pause in 0.05 0.1 0.2 0.4 0.8 1.6; do
        xdotool key Tab sleep $pause && red && [ "$red" -gt 0 ] && [ "$red" -lt 255 ] && return
        echo "# $pause s after Tab: $red"
        eventually arrives || return
    done
    return 1
}
check 'Tab leads it through values between 0 and 1' passes
check 'up to an end' eventually arrives
other() { local end=$red; key Tab && eventually red_is $((255 - end)); }
check 'and again to the other end' other
check 'Backspace closes it' backspace

# What follows the time though the view does not: the march of the chosen ray.
stands_still() { look before && shoot && shoot && shown before; } # nothing is shown that moves, once it is sharp
start 03_shadows -s 640x360 -v normals
key h
check 'the normals stand still while the lamp moves' eventually stands_still
counts() {
    look without && xdotool mousemove --window "$window" 380 200 click 1 && eventually says out 'ray of pixel' &&
        eventually far_off without 20000 && look before && eventually far_off before 20
}
check 'the inspector counts the steps of further rays as the lamp moves' counts
check 'Backspace closes it' backspace
start 00_first_scene -s 640x360 -f "$root/chapters/experiments/00_seen.frag" -v slice
key h
turns() { look before && eventually far_off before 4000; }
check 'the slice follows a camera that turns' turns
slice_paused() { key Escape && shows '(paused)' && eventually stands_still; }
check 'and stands still when it is paused' slice_paused
check 'Backspace closes it' backspace

close_window
plan
