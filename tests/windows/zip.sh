#!/bin/bash
# zip.sh - tests the archive of `make windows-zip`: its bytes, its size, its licences and the Windows libraries that its
# programs need. The archive is then used without the rest of the project, in a folder whose name has spaces, accents
# and letters outside the code page. The script is called by run.sh.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh
. tests/lib/window.sh
export LC_ALL=C.UTF-8 # with it, bash passes names on unchanged
: "${loader:?run.sh sets it}" "${at_once:?}"

zip=build/ray-marching-windows.zip
limit=6000000 # in bytes, without the site
wine() { LD_PRELOAD=$at_once "$loader" "$@"; }
windows_path() { printf 'Z:%s' "${1//\//\\}"; }

# ---- The archive ----

packs() { .make/windows_zip.sh >"$scratch/said"; }
check 'the archive is made' packs || { plan; exit; }
# The test sleeps for two seconds, because an archive stores times in steps of two seconds.
again() { cp $zip "$scratch/first.zip" && sleep 2 && packs && cmp "$scratch/first.zip" $zip; }
check 'an archive that is made again has the same bytes' again
cp $zip "$scratch/small.zip"
zip -q -d "$scratch/small.zip" 'ray-marching/site/*' >/dev/null 2>&1
small_enough() { local bytes; bytes=$(wc -c <"$scratch/small.zip") && echo "# $bytes bytes" && [ "$bytes" -le $limit ]; }
check "without the site, the archive takes at most $limit bytes" small_enough

folder="$scratch/Cours d’été – мир 漢字 é"
mkdir "$folder"
unzip -q $zip -d "$folder" || not_ok 'the archive can be unpacked'
course=$folder/ray-marching

# ---- The contents of the archive ----

# The libraries that every installation of Windows 10 has, and the course's own library, harness.dll.
known='^(KERNEL32|USER32|GDI32|SHELL32|ADVAPI32|WINMM|OPENGL32|api-ms-win-crt-[a-z0-9-]+|harness)\.dll$'
asks() {
    local file
    for file in "$course"/*.exe "$course"/*.dll; do
        x86_64-w64-mingw32-objdump -p "$file" | sed -n 's/.*DLL Name: //p' >"$scratch/asked"
        grep -q . "$scratch/asked" || { echo "# $file: objdump lists no library"; return 1; }
        ! grep -vE "$known" "$scratch/asked" | sed "s|^|# ${file##*/} needs |" | grep . || return 1
    done
}
check "the programs need only Windows' libraries and the course's own" asks
licensed() {
    local name words file missing=0
    while IFS='|' read -r name words; do
        file=$course/$name
        { [ -s "$file" ] && grep -q -e "$words" "$file"; } || { echo "# $name: missing, or without '$words'"; missing=1; }
    done
    return $missing
}
check 'the archive has the licences of all its contents' licensed <<'END_OF_LICENCES'
LICENSE.txt|Copyright
licences/cglm.txt|Recep Aslantas
licences/dejavu.txt|Bitstream
licences/glfw.txt|Camilla L
licences/libpng.txt|PNG Reference Library
licences/mingw-w64.txt|ZPL\|Zope
licences/stb_truetype.txt|Sean Barrett
licences/zlib.txt|Jean-loup Gailly
END_OF_LICENCES
named() {
    grep -ohE '[a-z0-9_]+\.(exe|bat)' "$course/README.txt" | sort -u | while read -r name; do
        [ -e "$course/$name" ] || { echo "# $name: missing"; return 1; }
    done
}
check 'the archive has all programs that its README names' named
whole() {
    local file
    git ls-files chapters shaders | grep -E '\.(frag|glsl|vert|png)$' | while read -r file; do
        cmp "$file" "$course/$file" || return 1
    done
}
check 'the archive has all files that the programs read' whole

# ---- Programs ----

draws() { # each chapter's picture, at a small size, equals that of this machine's program
    local file stem
    for file in "$course"/[0-9]*.exe; do
        stem=$(basename "$file" .exe)
        if ! "build/$stem" -s 64x36 -o "$scratch/wanted.png" || ! (cd / && wine "$file" -s 64x36 -o "$folder/drawn.png") ||
            ! build/tests/compare "$scratch/wanted.png" "$folder/drawn.png" >"$scratch/numbers"; then
            echo "# $stem: $(cat "$scratch/numbers")"
            return 1
        fi
    done
    [ "$(find "$course" -name '[0-9]*.exe' | wc -l)" = "$(find chapters -maxdepth 1 -name '[0-9]*.c' | wc -l)" ]
}
check 'the program of every chapter draws its picture' draws
# Run the commands in the archive's folder, as README.txt says.
# shellcheck disable=SC1003 # as Windows' shell would pass it on
in_terminal() { (cd "$course" && wine cmd /c '.\03_shadows.exe --size 64x36 --output build/a.png' && wine cmd /c '.\compare.exe --words build/a.png build\a.png') >"$scratch/said" 2>&1 </dev/null &&
    grep -q 'no pixel differs' "$scratch/said"; }
check "a page's command and a comparison work in a terminal" in_terminal || sed 's/^/# /' "$scratch/said"

# ---- An exercise ----

# checks STATUS PATTERN WORD...: run check.bat, and check its status and output. The command 'call' is not used, because
# with it, Wine's cmd ends only with status 0 or 1.
checks() {
    local wanted=$1 pattern=$2 status
    shift 2
    (cd "$course" && wine cmd /c check.bat "$@" </dev/null) 2>&1 | tr -d '\r' >"$scratch/said"
    status=${PIPESTATUS[0]}
    [ "$status" = "$wanted" ] && LC_ALL=C grep -aq -e "$pattern" "$scratch/said" && return
    echo "# status $status, expected $wanted"
    sed 's/^/# /' "$scratch/said"
    return 1
}
# words FILE: print the verdict and the two rays, without file names.
words() { LC_ALL=C sed -nE 's/.*: ((right|wrong): .*)/\1/; s/: see .*//; /^(right|wrong): /p; /^ +(your pixel|the solution)/p' "$1"; }
# as_here STATUS PATTERN: like checks, for exercise 03_2. The verdict must also have the words of make check on this
# machine.
as_here() {
    checks "$@" 03_2 "$(windows_path "$mine")" || return
    EXERCISE=03_2 FILE=$mine CHECK_FOLDER=$scratch/check .make/check.sh >"$scratch/here" 2>&1
    diff <(words "$scratch/here") <(words "$scratch/said") >"$scratch/differ" && grep -aq . <(words "$scratch/said") && return
    sed 's/^/# /' "$scratch/differ"
    return 1
}
mine="$folder/ma réponse.frag"
cp chapters/solutions/03_shadows_2.frag "$mine"
check 'check.bat accepts a right answer, in the words of make check' as_here 0 ': right: matches the solution in '
sed 's/p + offset \* toLight/p + offset * normal/' chapters/solutions/03_shadows_2.frag >"$mine"
check 'check.bat rejects a wrong answer and shows two rays' as_here 1 "the solution's: .*hit"
# The picture of this answer is right, but its first march goes in the opposite direction.
printf '#include "main.glsl"\n#include "march.glsl"\n#define rayColour painted\n#include "solutions/03_shadows_2.frag"\n#undef rayColour\n%s\n' \
    'vec3 rayColour(Ray ray) { march(Ray(ray.origin, -ray.direction), 0.0, 1.0, 0.001, 64); return painted(ray); }' >"$mine"
check 'check.bat rejects an answer with wrong rays' as_here 1 'its rays are not: pixel '
sed 's/p + offset \* toLight/p + offset * toLigth/' chapters/solutions/03_shadows_2.frag >"$mine"
check 'check.bat reports an answer that does not compile' checks 1 'réponse.frag:[0-9]*: error.*toLigth' 03_2 "$(windows_path "$mine")"
check 'check.bat refuses an unknown exercise' checks 2 '03_9: there is no such exercise' 03_9 "$(windows_path "$mine")"
check 'check.bat refuses a missing file' checks 2 'there is no such file' 03_2 nowhere.frag
without_file() { checks 2 'check.bat EXERCISE FILE' 03_2 && ! grep -q 'any key' "$scratch/said"; } # check.bat does not wait for a key, because no file was dropped onto it
check 'check.bat prints its usage if no file is named' without_file

# ---- A reader's own shader ----

searched() { window=$(wmctrl -l | grep -E -e "$1" | cut -d ' ' -f 1) && [ -n "$window" ]; }
play() { # NAME [FILE]: run play.bat, and wait for a window with this name in its title and for its picture
    title="$1 - ([0-9]+ fps - )?picture" # the frame rate is shown only if it has been measured
    shift
    rm -f "$scratch/said"
    (cd "$folder" && exec env LD_PRELOAD="$at_once" "$loader" cmd /c call "$(windows_path "$course/play.bat")" "$@" </dev/null >"$scratch/said" 2>&1) &
    program=$!
    eventually searched "$title" && eventually focus && eventually drawn && return
    sed 's/^/# /' "$scratch/said"
    return 1
}
has_words() { grep -q -e "$1" "$scratch/said"; }

plays_own() { play play.frag && [ -e "$course/chapters/play.frag" ] && eventually searched 'play.frag - Notepad' && searched "$title"; }
check 'play.bat without a file makes a shader and opens an editor' plays_own
wine taskkill /f /im notepad.exe >/dev/null 2>&1
# If an editor closes just as it gets the keyboard focus, Wine may have no window for the keys, although X reports that
# our window has the focus. A program then accepts the focus only from the window manager, as after a click, so the test
# requests the focus until the window reacts.
closes() {
    ended && return
    searched "$title" && xdotool windowactivate "$window" && key BackSpace
    ended
}
ends() { eventually closes && wait "$program"; }
check 'play.bat ends with status 0' ends
cp chapters/first_steps/play.frag "$mine"
check 'play.bat shows a file whose name has a blank and an accent' play 'ma réponse.frag' "$(windows_path "$mine")"
build/01_normal_colouring --shader chapters/first_steps/play.frag -s 960x540 -o "$scratch/right.png" >/dev/null
sed 's/sdSphere(p, radius)/sdSphere(p, radios)/' chapters/first_steps/play.frag >"$mine"
says_error() { eventually has_words 'réponse.frag:[0-9]*: error.*radios' && eventually searched 'réponse.frag - error'; }
check 'play.bat reports an error in a saved file' says_error
cp chapters/first_steps/play.frag "$mine"
# Beside the panel, the sharpened picture equals the one that this machine draws.
mended() { eventually has_words 'réponse.frag: reloaded' && eventually searched "$title" && eventually part_shown right 300x280+330+120; }
check 'play.bat shows the file again after its error is corrected' mended
check 'play.bat ends with status 0 again' ends
plan
