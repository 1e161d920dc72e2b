#!/bin/bash
# windows.sh [PART...|NAME...] - `make test-windows`: the programs and the tests that were built for Windows, run by Wine in a
# virtual display, over the software renderer. Parts: units, pictures, suites, windows, zip, own; all where none is
# named. The suites are those of `make test`: they find programs in build/wine/ that hand their words on to those for
# Windows, and a driver for each of them, GLFW's. A test that is skipped must stand in tests/skipped.txt. The seconds are
# the processor's, without those of Wine's server and of Xvfb.
set -u
cd "$(dirname "$0")/.." || exit 1
export LC_ALL=C.UTF-8

loader=/usr/lib/wine/wine64
[ -x "$loader" ] || loader=$(command -v wine) || { echo 'make: test-windows: no Wine on this machine' >&2; exit 1; }
export loader
export WINEPREFIX=$PWD/build/windows/wine WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml=' # not installed first
export LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe PROJECT_ROOT=$PWD CMOCKA_MESSAGE_OUTPUT=TAP
export MESA_SHADER_CACHE_DIR=$PWD/build/shader-cache BUILD=build/wine SYSTEM=Windows EVERY_BACKEND=1
unset WAYLAND_DISPLAY

results=build/windows/results
rm -rf build/wine $results && mkdir -p build/wine/tests $results "$MESA_SHADER_CACHE_DIR"
cc -shared -fPIC -o build/wine/exit_at_once.so tests/exit_at_once.c || exit 1
at_once=$PWD/build/wine/exit_at_once.so
export at_once

# ---- A display, and one Wine for all ----

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
# Wine's desktop belongs to one display: a suite that opens another must find no Wine at work.
end_wine() { wineserver -k 2>/dev/null; wineserver -w; }
finish() {
    end_wine
    kill "$server" 2>/dev/null
}
server=
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
        wrong="    planned $planned tests, ran $((ok + not + skipped))"
    elif [ "$status" != 0 ] && [ "$not" = 0 ]; then
        wrong="    ended with status $status"
    else
        wrong=$(unlisted "$file.tap")
    fi
    [ -z "$wrong" ] || not=$((not + 1))
    echo "$ok $not $skipped $seconds" >"$file.counts"
    printf '%s\n' "$(
        printf 'windows/%-24s %4d passed, %d failed, %d skipped  %.1f s\n' "$name" "$ok" "$not" "$skipped" "$seconds"
        [ -z "$wrong" ] || echo "$wrong"
        [ "$not" = 0 ] || { grep -A 3 '^not ok' "$file.tap" | grep -v SKIP | head -n 60; tail -n 5 "$file.err"; }
    )"
}

unit() { suite "$(basename "$1" .exe)" env BUILD=build/windows LD_PRELOAD="$at_once" "$loader" "$1"; }
export -f suite unit unlisted
export results

# The one that computes for a minute and more, in one thread, comes first.
units() {
    printf '%s\n' build/windows/tests/test_sky_table.exe build/windows/tests/test_*.exe | awk '!seen[$0]++' |
        xargs -P 2 -I '{}' bash -c 'unit {}'
}

for part in "${@:-units pictures suites windows zip own}"; do
    for each in $part; do
        case $each in
        units) units ;;
        pictures) suite images tests/test_images.sh ;;
        suites)
            printf '%s\n' failures export sequence | xargs -P 2 -I '{}' bash -c 'suite {} tests/test_{}.sh'
            ;;
        windows)
            for name in window window_motion; do
                end_wine
                suite $name tests/test_$name.sh
            done
            end_wine
            ;;
        zip)
            end_wine
            suite zip tests/windows_zip.sh
            end_wine
            ;;
        own) suite own tests/windows_own.sh ;;
        *)
            if [ -e "build/windows/tests/test_$each.exe" ]; then
                unit "build/windows/tests/test_$each.exe"
            else
                suite "$each" "tests/test_$each.sh"
            fi
            ;;
        esac
    done
done

read -r passed failed skipped seconds <<<"$(cat $results/*.counts | awk '{ p += $1; f += $2; s += $3; t += $4 } END { print p + 0, f + 0, s + 0, t + 0 }')"
echo "$passed passed, $failed failed, $skipped skipped, $seconds s of the processor, $SECONDS s"
[ "$failed" = 0 ] && [ "$passed" != 0 ]
