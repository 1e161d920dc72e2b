# shellcheck shell=bash disable=SC2034,SC2154
# window.sh - starts a program in a window, presses keys, and takes and compares screenshots. A suite sources this file
# after tap.sh; the file sets up a display.

chapter=01_normal_colouring
still='-a 1 -s 320x200 -c 1.65,1.6,3.4,-26,-23.5'
program='' window='' manager='' shots=0 picture='' stem=''

# ---- Tools ----

# eventually COMMAND...: waits until the command succeeds. After 1200 tries, which take at least a minute and longer on
# a slow or busy machine, the function gives up, saves a screenshot next to the suite's output and makes every later
# wait fail at once; the check that contains the wait, or the next check, ends the suite.
gave_up=''
eventually() {
    local tries=1200
    [ -z "$gave_up" ] || return
    until "$@"; do
        [ $((tries -= 1)) != 0 ] || { give_up "$@"; return; }
        sleep 0.05
    done
}
give_up() {
    gave_up="gave up waiting for '$*'"
    echo "# gave up waiting for '$*'; keys go to '$(xdotool getwindowfocus getwindowname 2>&1)'"
    import -window root "${TEST_RESULTS:-$scratch}/$(basename "$0" .sh)-gave-up.png"
    return 1
}
# Like check of tap.sh, but a failed wait ends the suite, because the following checks would have nothing to look at.
check() { # NAME COMMAND...
    local name=$1
    shift
    if [ -z "$gave_up" ] && "$@" && [ -z "$gave_up" ]; then
        ok "$name"
        return
    fi
    not_ok "$name" "$gave_up"
    [ -z "$gave_up" ] || bail_out
    return 1
}
bail_out() {
    close_window
    plan
    exit 1
}

title() { xdotool getwindowname "$window" 2>/dev/null; }
titled() { [[ $(title) == *"$1"* ]]; }
shows() { eventually titled "$1" || { echo "# the title is: $(title)"; return 1; }; }
says() { grep -qF -e "$2" "$scratch/run/$1"; }
alive() { kill -0 "$program" 2>/dev/null; }
key() { xdotool key --delay 20 "$@"; }

find_window() {
    keep_managed
    window=$(wmctrl -lp 2>/dev/null | awk -v pid="$program" '$3 == pid { print $1; exit }')
    [ -n "$window" ]
}

# openbox announces itself to other programs (wmctrl -m) before it has read its theme and fonts, and a window that asks
# to be shown in between is never shown. The command that openbox runs once it has started shows that it is ready.
manage() {
    rm -f "$scratch/managed"
    openbox --config-file "$scratch/openbox.xml" --startup "touch '$scratch/managed'" >/dev/null 2>&1 &
    manager=$!
    eventually [ -e "$scratch/managed" ] || echo '# openbox did not start'
}
# Restart the window manager if it has died. Without a window manager, no window is listed, and the remains of a dead
# window manager make GLFW 3.3 end a program.
keep_managed() { kill -0 "$manager" 2>/dev/null || { echo '# openbox died' && manage; }; }

# start STEM OPTION...: starts a program in a window, with a new folder for the files that it writes.
start() {
    stem=$1 shots=0
    shift
    rm -rf "$scratch/run"
    mkdir "$scratch/run"
    keep_managed
    park
    (cd "$scratch/run" && exec "$root/$BUILD/$stem" "$@" >out 2>err) &
    program=$!
    opens
}

# Move the pointer into the corner of the screen, where no window opens, because a pointer over a panel would open a
# tooltip.
park() { xdotool mousemove 1279 1023; }

# Wait until the program's window exists, has the focus and shows a picture. The window manager may take the focus back
# once.
opens() {
    eventually find_window || {
        echo "# no window of process $program, $(sed -n 's/^State:[[:blank:]]*//p' "/proc/$program/status" 2>&1): $(wmctrl -lp 2>&1 | tr '\n' ' ')"
        return 1
    }
    eventually focus && eventually drawn
}
focus() { xdotool windowfocus "$window" 2>/dev/null && focused; }
focused() { [ "$(xdotool getwindowfocus 2>/dev/null)" = $((window)) ]; }
unfocused() { ! focused; }

# True if the first frame has been drawn: the pixels in the middle, which show more than sky at any window size, no
# longer all have the same colour.
drawn() {
    [ "$(import -window "$window" -gravity center -crop 60x60%+0+0 -format %k info: 2>/dev/null)" -gt 1 ] 2>/dev/null
}

# Take a screenshot (key P), and wait for its file, $picture.
shoot() {
    shots=$((shots + 1))
    picture=$scratch/run/$(printf '%s-%04d.png' "$stem" "$shots")
    key p
    eventually says out "$(basename "$picture"): written"
}

# shoot_as NAME: takes a screenshot and stores it under a name.
shoot_as() { shoot && cp "$picture" "$scratch/$1.png"; }
same() { cmp -s "$scratch/$1.png" "$scratch/$2.png"; }
differ() { ! same "$1" "$2"; }

# render NAME OPTION...: renders a picture with the command line and stores it under a name.
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

# True if the program ends by itself with status 0.
ended() { ! alive; }
ends_well() {
    eventually ended || { kill "$program"; return 1; }
    wait "$program"
}

close_window() {
    alive && kill "$program" 2>/dev/null
    wait "$program" 2>/dev/null
}

# look NAME: stores a picture of the window under a name. Without a window, import would wait for a click.
look() { [ -n "$window" ] && import -window "$window" "$scratch/$1.png"; }

# Print how many of a million pixels differ by more than a driver's rounding. apart compares two stored pictures, or the
# same part of both; off compares what the window shows with a stored picture.
apart() { # A B [WxH+X+Y]
    build/tests/compare ${3:+--part "$3"} "$scratch/$1.png" "$scratch/$2.png" | awk '/^F2/ { printf "%d\n", $2 * 10000 + 0.5 }'
}
off() { look screen && apart screen "$@"; }
shown() { [ "$(off "$1")" = 0 ]; }
changed() { [ "$(off "$1")" != 0 ]; }
# True if the window shows this part of a stored picture, except for at most this many pixels in a million.
part_shown() { # NAME WxH+X+Y [PIXELS]
    [ "$(off "$1" "$2")" -le "${3:-0}" ]
}

# Hold a key until the window shows another picture, and compare screenshots from before and afterwards.
walk() { # KEY
    shoot_as here && look before && xdotool keydown "$1" && eventually changed before && xdotool keyup "$1" &&
        shoot_as there && differ here there
}

backspace() { key BackSpace && ends_well; }

# ---- Set-up ----

export LP_NUM_THREADS=2 # so that a slow picture is slow on any machine

for tool in Xvfb openbox xdotool wmctrl import; do
    if ! command -v $tool >/dev/null; then
        skip 'the interactive window' "this machine has no $tool: make setup installs it"
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
# The window manager reacts to no buttons or keys. Otherwise, it would delay each press of a button until it had handled
# the press, and a key pressed later would arrive first.
echo '<openbox_config xmlns="http://openbox.org/3.4/rc"><keyboard/><mouse/></openbox_config>' >"$scratch/openbox.xml"
manage

# ---- A reader's own shader ----

mine=$scratch/mine.frag
good=$(cat chapters/$chapter.frag)
save() { # TEXT: writes the reader's shader as an editor does, to a new file that is then renamed
    printf '%s\n' "$1" >"$mine.new" && mv "$mine.new" "$mine"
}
