#!/bin/bash
# windows.sh [PART...|NAME...] - `make test-windows`: the programs and the tests that were built for Windows, run by Wine in a
# virtual display, over the software renderer. Parts: units, pictures, suites and windows; own and zip, and all others, are
# suites by name; all where none is named. The suites are those of `make test`: they find programs in build/wine/ that hand
# their words on to those for Windows, and a driver for each of them, GLFW's. A test that is skipped must stand in
# tests/skipped.txt. The seconds are the processor's, without those of Wine's server and of Xvfb.
set -u
# Wine needs a certain place in memory, and where the kernel scatters what a program has, one start in some thousand finds
# its heap there and ends. Here nothing is scattered, if that may be asked for.
if [ -z "${SCATTERED-}" ] && setarch -R true 2>/dev/null; then
    SCATTERED=no exec setarch -R "$0" "$@"
fi
cd "$(dirname "$0")/.." || exit 1
export LC_ALL=C.UTF-8

loader=/usr/lib/wine/wine64
[ -x "$loader" ] || loader=$(command -v wine) || { echo 'make: test-windows: no Wine on this machine' >&2; exit 1; }
export loader
# At each start Wine looks for the time zone in its list of all: this one is the first.
export TZ=AFT-4:30
export WINEPREFIX=$PWD/build/windows/wine WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml=' # not installed first
export LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe PROJECT_ROOT=$PWD CMOCKA_MESSAGE_OUTPUT=TAP
export MESA_SHADER_CACHE_DIR=$PWD/build/shader-cache BUILD=build/wine SYSTEM=Windows
unset WAYLAND_DISPLAY

results=build/windows/results
rm -rf build/wine $results && mkdir -p build/wine/tests $results "$MESA_SHADER_CACHE_DIR"
cc -shared -fPIC -o build/wine/exit_at_once.so tests/exit_at_once.c || exit 1
at_once=$PWD/build/wine/exit_at_once.so
export at_once

# ---- A display, and a Wine for all but the suites of windows ----

display() { # sets DISPLAY and server
    rm -f build/wine/display
    mkfifo build/wine/display
    Xvfb -displayfd 3 -screen 0 1280x1024x24 -noreset -nolisten tcp 3>build/wine/display >/dev/null 2>&1 &
    server=$!
    local number=
    read -r -t 30 number <build/wine/display
    [ -n "$number" ] || { echo 'make: test-windows: Xvfb did not start' >&2; exit 1; }
    export DISPLAY=:$number
}
end_wine() { wineserver -k 2>/dev/null; wineserver -w; }
finish() {
    [ -z "$suites" ] || kill "$suites" 2>/dev/null
    for WINEPREFIX in "$WINEPREFIX"*; do end_wine; done
    kill "$server" 2>/dev/null
}
server=
suites=
display
trap finish EXIT
trap 'exit 1' HUP INT TERM

# Some suites take the display away, without which Windows never is.
for program in build/windows/[0-9]*.exe build/windows/tests/draw.exe build/windows/tests/compare.exe; do
    name=${program#build/windows/}
    # shellcheck disable=SC2016 # for that shell
    printf '#!/bin/sh\nDISPLAY=${DISPLAY-%s} LD_PRELOAD=%s exec %s "%s" "$@"\n' "$DISPLAY" "$at_once" "$loader" "$PWD/$program" >"build/wine/${name%.exe}"
    chmod +x "build/wine/${name%.exe}"
done
cp build/windows/flags build/wine/flags
"$loader" wineboot -i >/dev/null 2>&1
# Without gamepads: their library leaves a thread behind when GLFW closes it. What a batch file starts hears nothing of
# WINEDLLOVERRIDES.
cat >build/wine/overrides.reg <<'END_OF_REGISTRY'
REGEDIT4

[HKEY_CURRENT_USER\Software\Wine\DllOverrides]
"xinput1_4"=""
"xinput1_3"=""
"xinput1_2"=""
"xinput1_1"=""
"xinput9_1_0"=""
END_OF_REGISTRY
"$loader" regedit build/wine/overrides.reg >/dev/null 2>&1
end_wine
wineserver -p 2>/dev/null # it stays between two programs

# ---- One suite ----

# unlisted FILE: the skipped tests that may not be.
unlisted() {
    local name
    sed -nE 's/^(not )?ok [0-9]+ - (.*[^ ]) *# *SKIP\>.*/\2/p' "$1" | while read -r name; do
        awk -F ' *[|] *' -v name="$name" '$1 == "windows" && $2 == name { found = 1 } END { exit !found }' tests/skipped.txt ||
            echo "    skipped, and not in the list: $name"
    done
}

# failures FILE: the lines of failed tests with the comments that stand around them.
failures() {
    awk '/^not ok/ { printf "%s%s\n", said, $0; after = 1; said = ""; next }
        /^#/ { if (after) print; else said = said $0 "\n"; next }
        { after = 0; said = "" }' "$1" | grep -v SKIP
}

# suite NAME COMMAND...: run one that speaks TAP; leaves its counts and prints its line. What never ends is ended.
suite() {
    local name=$1 ok not skipped planned status seconds wrong='' file TIMEFORMAT='%U %S'
    file=$results/${name//\//-}
    shift
    { time timeout -k 5 1800 "$@" >"$file.tap" 2>"$file.err" </dev/null; } 2>"$file.time"
    status=$?
    seconds=$(awk '{ print $1 + $2 }' "$file.time")
    tr -d '\r' <"$file.tap" >"$file.text" && mv "$file.text" "$file.tap"
    skipped=$(grep -cE '^(not )?ok\>.*# *SKIP\>' "$file.tap")
    ok=$(grep -E '^ok\>' "$file.tap" | grep -vcE '# *SKIP\>')
    not=$(grep -E '^not ok\>' "$file.tap" | grep -vcE '# *SKIP\>')
    planned=$(sed -n 's/^1\.\.\([0-9][0-9]*\).*/\1/p' "$file.tap" | awk '{ n += $1 } END { print n + 0 }')
    if [ "$planned" != $((ok + not + skipped)) ] || [ "$planned" = 0 ]; then
        wrong="    planned $planned tests, ran $((ok + not + skipped)), ended with status $status"
    elif [ "$status" != 0 ] && [ "$not" = 0 ]; then
        wrong="    ended with status $status"
    else
        wrong=$(unlisted "$file.tap")
    fi
    [ -z "$wrong" ] || not=$((not + 1))
    echo "$ok $not $skipped $seconds" >"$file.counts"
    printf '%s\n' "$(
        printf 'windows/%-24s %4d passed, %d failed, %d skipped  %.1f s\n' "$name" "$ok" "$not" "$skipped" "$seconds"
        sed -n 's/^# \([0-9]* pictures, \)/    \1/p' "$file.tap"
        [ -z "$wrong" ] || echo "$wrong"
        [ "$not" = 0 ] || { failures "$file.tap" | head -n 60; tail -n 5 "$file.err"; }
    )"
}

# Wine's desktop belongs to one display: a suite that opens another must find no Wine at work. It has one of its own.
own_wine() { # NAME
    local copy=$WINEPREFIX-$1
    rm -rf "$copy" && cp -RPl "$WINEPREFIX" "$copy" && export WINEPREFIX=$copy # a drive there is a link to all of the disk
}

# tried NAME: a suite by its name.
tried() {
    local unit=build/windows/tests/test_$1.exe
    case $1 in window* | zip | images | failures) own_wine "$1" || return ;; esac
    # One of its many programs may end badly without a word: there Wine says what it knows.
    [ "$1" != export ] || export WINEDEBUG=err+all,fixme-all
    case $1 in
    own | zip) suite "$1" "tests/windows_$1.sh" ;;
    *)
        if [ -e "$unit" ]; then
            suite "test_$1" env BUILD=build/windows WINEDEBUG=err+all,fixme-all LD_PRELOAD="$at_once" "$loader" "$unit"
        else
            suite "$1" "tests/test_$1.sh"
        fi
        ;;
    esac
    [ "${WINEPREFIX%-"$1"}" = "$WINEPREFIX" ] || end_wine
}
export -f suite tried own_wine end_wine unlisted failures
export results

# The suites of a part. What takes longest comes first; a program's start under Wine is more waiting than work.
units() { for file in build/windows/tests/test_*.exe; do basename "${file#*/test_}" .exe; done; }
named() { # PART|NAME
    case $1 in
    windows) printf '%s\n' window window_motion ;;
    units) units ;;
    pictures) echo images ;;
    suites) printf '%s\n' export failures sequence ;;
    all) printf '%s\n' images export sequence window_motion window zip failures sky_table night "$(units)" own ;;
    *) echo "$1" ;;
    esac
}
for part in "${@:-all}"; do named "$part"; done | awk '!seen[$0]++' >build/wine/suites
xargs -P 3 -I '{}' bash -c 'tried {}' <build/wine/suites &
suites=$!
wait "$suites"
suites=
for name in $(<build/wine/suites); do
    [ -e "$results/$name.counts" ] || [ -e "$results/test_$name.counts" ] || { echo "windows/$name: was not run" >&2; exit 1; }
done

read -r passed failed skipped seconds <<<"$(cat $results/*.counts | awk '{ p += $1; f += $2; s += $3; t += $4 } END { print p + 0, f + 0, s + 0, t + 0 }')"
echo "$passed passed, $failed failed, $skipped skipped, $seconds s of the processor, $SECONDS s"
[ "$failed" = 0 ] && [ "$passed" != 0 ]
