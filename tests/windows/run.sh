#!/bin/bash
# run.sh [PART...|NAME...] - `make test-windows`: runs the tests that were built for Windows, and tests the programs
# that were built for Windows, with Wine on a virtual display and the software renderer. PART is units, pictures, suites
# or windows; NAME is any single suite, such as own or zip. By default, it tests the chapters' own pictures, the
# failures and the peculiarities of Windows; with ALL=1, it runs all suites. Apart from own and zip, the suites are the
# same as on other systems. They find scripts in build/wine/ that pass their arguments on to the programs for Windows,
# whose only backend is GLFW. tests/run runs the suites and adds up their time, without that of Wine's server and Xvfb;
# a test that is skipped must be listed in tests/lib/skipped.txt.
set -u
# Wine needs a certain range of addresses. If the kernel randomises addresses, one start in several thousand finds its
# heap in this range and fails, so this script turns the randomisation off, if that is allowed.
if [ -z "${SCATTERED-}" ] && setarch -R true 2>/dev/null; then
    SCATTERED=no exec setarch -R "$0" "$@"
fi
cd "$(dirname "$0")/../.." || exit 1
export LC_ALL=C.UTF-8

loader=/usr/lib/wine/wine64
[ -x "$loader" ] || loader=$(command -v wine) || { echo 'make: test-windows: this machine has no Wine' >&2; exit 1; }
export loader
# At each start, Wine searches for the time zone in its list of all zones, so this is the first zone in that list.
export TZ=AFT-4:30
# The overrides keep Wine from installing Mono and Gecko first.
export WINEPREFIX=$PWD/build/windows/wine WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml='
export LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe PROJECT_ROOT=$PWD CMOCKA_MESSAGE_OUTPUT=TAP
export BUILD=build/wine SYSTEM=Windows
unset WAYLAND_DISPLAY LOCPATH

at_once=$PWD/build/wine/exit_at_once.so
export at_once SKIPPED=windows
end_wine() { wineserver -k 2>/dev/null; wineserver -w; }

# ---- One suite, as tests/run calls it ----

# Wine's desktop belongs to one display, so a suite that opens another display cannot share a running Wine. Such a suite
# gets a copy of Wine's folder and a separate Wine.
own_wine() { # NAME
    local copy=$WINEPREFIX-$1
    # The option -P is needed, because a drive in the folder is a link to the whole disk.
    rm -rf "$copy" && cp -RPl "$WINEPREFIX" "$copy" && export WINEPREFIX=$copy
}

if [ "${1-}" = --suite ]; then
    unit=$(echo build/windows/tests/*/"$2".exe)
    script=$(echo tests/[!l]*/"$2".sh) # not a script of tests/lib/
    case $2 in window | zip | images | failures) own_wine "$2" || exit; trap end_wine EXIT ;; esac
    # One of the many programs of the suite export may crash without a message, so Wine must print its own messages.
    [ "$2" != export ] || export WINEDEBUG=err+all,fixme-all
    case $2 in
    own | zip) "tests/windows/$2.sh" ;;
    *)
        if [ -e "$unit" ]; then
            BUILD=build/windows WINEDEBUG=err+all,fixme-all LD_PRELOAD="$at_once" "$loader" "$unit"
        else
            "$script"
        fi
        ;;
    esac
    exit
fi

# ---- A display, and the Wine that the other suites share ----

rm -rf build/wine && mkdir -p build/wine/tests
cc -shared -fPIC -o build/wine/exit_at_once.so tests/windows/exit_at_once.c || exit 1

finish() {
    [ -z "$suites" ] || kill "$suites" 2>/dev/null
    for WINEPREFIX in "$WINEPREFIX"*; do end_wine; done
    kill "$server" 2>/dev/null
}
suites=
mkfifo build/wine/display
Xvfb -displayfd 3 -screen 0 1280x1024x24 -noreset -nolisten tcp 3>build/wine/display >/dev/null 2>&1 &
server=$!
trap finish EXIT
trap 'exit 1' HUP INT TERM
number=
read -r -t 30 number <build/wine/display
[ -n "$number" ] || { echo 'make: test-windows: Xvfb did not start' >&2; exit 1; }
export DISPLAY=:$number

# Some suites unset DISPLAY, but Windows always has a display.
for program in build/windows/[0-9]*.exe build/windows/tests/draw.exe build/windows/tests/compare.exe; do
    name=${program#build/windows/}
    # shellcheck disable=SC2016 # expanded by the shell that runs the script
    printf '#!/bin/sh\nDISPLAY=${DISPLAY-%s} LD_PRELOAD=%s exec %s "%s" "$@"\n' "$DISPLAY" "$at_once" "$loader" "$PWD/$program" >"build/wine/${name%.exe}"
    chmod +x "build/wine/${name%.exe}"
done
cp build/windows/flags build/wine/flags
"$loader" wineboot -i >/dev/null 2>&1
# Disable the libraries for gamepads, because they leave a thread running after GLFW closes them. The registry is used
# because programs that are started by a batch file ignore WINEDLLOVERRIDES.
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
wineserver -p 2>/dev/null # the server keeps running between two programs

# Print the names of a part's suites, the slowest first, so that tests/run, which runs several at once, ends sooner.
units() { for file in build/windows/tests/*/*.exe; do basename "$file" .exe; done; }
named() { # PART|NAME
    case $1 in
    windows) echo window ;;
    units) units ;;
    pictures) echo images ;;
    suites) printf '%s\n' export failures sequence ;;
    all) printf '%s\n' images export sequence window zip failures sky_table night "$(units)" own ;;
    *) echo "$1" ;;
    esac
}
if [ $# = 0 ] && [ -z "${ALL-}" ]; then
    export CHAPTERS_ONLY=1
    set -- images failures own
fi
for part in "${@:-all}"; do named "$part"; done | awk '!seen[$0]++' >build/wine/suites
# shellcheck disable=SC2046 # the names are separate words
TEST_LIMIT=1800 tests/run $(sed 's,^,windows/,' build/wine/suites) &
suites=$!
wait "$suites"
status=$?
suites=
[ "$status" = 0 ]
