#!/bin/bash
# windows.sh [PART...|NAME...] - `make test-windows`: the programs and the tests that were built for Windows, run by Wine in a
# virtual display, over the software renderer. Parts: units, pictures, suites, windows, own; all where none is
# named. The suites are those of `make test`: they find programs in build/wine/ that hand their words on to those for
# Windows, and a driver for each of them, GLFW's.
set -u
cd "$(dirname "$0")/.." || exit 1
export LC_ALL=C.UTF-8

loader=/usr/lib/wine/wine64
[ -x "$loader" ] || loader=$(command -v wine) || { echo 'make: test-windows: no Wine on this machine' >&2; exit 1; }
export loader
# Without what it would install first; and without gamepads, whose library leaves a thread behind when GLFW closes it.
export WINEPREFIX=$PWD/build/windows/wine WINEDEBUG=-all
export WINEDLLOVERRIDES='mscoree,mshtml,xinput1_4,xinput1_3,xinput1_2,xinput1_1,xinput9_1_0='
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
for program in build/windows/[0-9]*.exe build/windows/tests/draw.exe; do
    name=${program#build/windows/}
    # shellcheck disable=SC2016 # for that shell
    printf '#!/bin/sh\nDISPLAY=${DISPLAY-%s} LD_PRELOAD=%s exec %s "%s" "$@"\n' "$DISPLAY" "$at_once" "$loader" "$PWD/$program" >"build/wine/${name%.exe}"
    chmod +x "build/wine/${name%.exe}"
done
cp build/windows/flags build/wine/flags
"$loader" wineboot -i >/dev/null 2>&1
wineserver -p 2>/dev/null # it stays between two programs

# ---- One suite ----

# suite NAME COMMAND...: run one that speaks TAP; leaves its counts and prints its line.
suite() {
    local name=$1 ok not skipped status begin=$SECONDS file
    file=$results/${name//\//-}
    shift
    timeout -k 5 600 "$@" >"$file.tap" 2>"$file.err" </dev/null
    status=$?
    tr -d '\r' <"$file.tap" >"$file.text" && mv "$file.text" "$file.tap"
    skipped=$(grep -cE '^(not )?ok\>.*# *SKIP\>' "$file.tap")
    ok=$(grep -E '^ok\>' "$file.tap" | grep -vcE '# *SKIP\>')
    not=$(grep -E '^not ok\>' "$file.tap" | grep -vcE '# *SKIP\>')
    [ "$status" = 0 ] || [ "$not" != 0 ] || not=1
    [ $((ok + not)) != 0 ] || not=1
    echo "$ok $not $skipped" >"$file.counts"
    printf '%s\n' "$(
        printf 'windows/%-24s %4d passed, %d failed, %d skipped  %d s\n' "$name" "$ok" "$not" "$skipped" $((SECONDS - begin))
        [ "$status" = 0 ] || echo "    ended with status $status"
        [ "$not" = 0 ] || { grep -A 3 '^not ok' "$file.tap" | grep -v SKIP | head -n 60; tail -n 5 "$file.err"; }
    )"
}

unit() { suite "$(basename "$1" .exe)" env BUILD=build/windows LD_PRELOAD="$at_once" "$loader" "$1"; }
export -f suite unit
export results

# They compute in double precision for minutes, in one thread, and ask the system for nothing.
left_out='scene_21 sky_table'

units() {
    local name
    for name in $left_out; do
        [ -e "build/windows/tests/test_$name.exe" ] || { echo "make: test-windows: no test $name to leave out" >&2; exit 1; }
    done
    printf '%s\n' build/windows/tests/test_*.exe |
        grep -vE "/test_(${left_out// /|})\.exe$" | xargs -P 2 -I '{}' bash -c 'unit {}'
}

for part in "${@:-units pictures suites windows own}"; do
    for each in $part; do
        case $each in
        units) units ;;
        pictures) suite images tests/test_images.sh ;;
        suites)
            for name in export sequence failures; do suite $name tests/test_$name.sh; done
            ;;
        windows)
            for name in window window_motion; do
                end_wine
                suite $name tests/test_$name.sh
            done
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

read -r passed failed skipped <<<"$(cat $results/*.counts | awk '{ p += $1; f += $2; s += $3 } END { print p + 0, f + 0, s + 0 }')"
echo "$passed passed, $failed failed, $skipped skipped, $SECONDS s"
[ "$failed" = 0 ] && [ "$passed" != 0 ]
