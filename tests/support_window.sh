# shellcheck shell=bash disable=SC2034,SC2154
# support_window.sh - what the window's suites share: start a program in a window, press keys, take and
# compare screenshots. Sourced after support.sh, by a suite that then checks; sets the display up.

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

# A driver may round the half between two levels either way: then pixels differ by 1, not by 3.
on_screen() {
    import -window "$window" "$scratch/screen.png" &&
        build/tests/compare "$scratch/first.png" "$scratch/screen.png" | grep -q '^F2 0.0000'
}

# Movement.
walk() { # KEY
    xdotool keydown "$1" sleep 0.15 keyup "$1"
}

backspace() { key BackSpace && ends_well; }

# How many pixels of two pictures differ.
apart() { # A B
    local numbers
    numbers=$(build/tests/compare "$scratch/$1.png" "$scratch/$2.png")
    [ $? != 2 ] || return
    case $numbers in *' differ '*) numbers=${numbers##* differ } && echo "${numbers%% *}" ;; *) echo 0 ;; esac
}
# How many pixels of the screen differ from a picture.
screen_apart() { import -window "$window" "$scratch/now.png" && apart "$1" now; }

error_shown() { [ "$(screen_apart good)" -gt 2000 ]; }

look() { import -window "$window" "$scratch/$1.png"; }

# How many pixels of the screen differ from what it was before.
changed() { screen_apart before; }

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

# ---- A reader's own shader ----

mine=$scratch/mine.frag
good=$(cat chapters/$chapter.frag)
save() { # TEXT: as an editor does it, beside and renamed
    printf '%s\n' "$1" >"$mine.new" && mv "$mine.new" "$mine"
}
