#!/bin/bash
# own.sh - tests peculiarities of Windows: names outside any code page, a file that another program has open, line
# endings, capital letters and the console. It is called by run.sh.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/lib/tap.sh
open_scratch
export LC_ALL=C.UTF-8 # with it, bash passes names on unchanged
: "${loader:?run.sh sets it}"

small=(-s 64x36)
picture() { "$BUILD/03_shadows" "${small[@]}" "$@" >"$scratch/said" 2>"$scratch/why"; }
# refused PATTERN COMMAND...: succeeds if the command fails and its only message matches the pattern.
refused() {
    local pattern=$1
    shift
    ! "$@" && [ "$(grep -c '' "$scratch/why")" = 1 ] && grep -q -e "$pattern" "$scratch/why" && return
    sed 's/^/# /' "$scratch/why"
    return 1
}
build/03_shadows "${small[@]}" -o "$scratch/wanted.png"
alike() { build/tests/compare "$scratch/wanted.png" "$1" >"$scratch/numbers" || { echo "# $1: $(cat "$scratch/numbers")"; return 1; }; }

# ---- Names ----

strange="$scratch/Élève 1 – мир 漢字 𝄞"
mkdir "$strange"
named() { picture -o "$strange/ночь é.png" && alike "$strange/ночь é.png"; }
check 'a picture is written to a path outside any code page' named
cp chapters/03_shadows.frag "$strange/ombre à midi.frag"
own_shader() { picture -f "$strange/ombre à midi.frag" -o "$strange/a.png" && alike "$strange/a.png"; }
check 'a shader is read from a path outside any code page' own_shader
printf 'x\n' >>"$strange/ombre à midi.frag"
names_it() { ! picture -f "$strange/ombre à midi.frag" -o "$strange/b.png" && grep -q 'Élève 1 – мир 漢字 𝄞/ombre à midi.frag:[0-9]*: error' "$scratch/why"; }
check 'an error message shows a path outside any code page unchanged' names_it
deep=$strange
for number in 1 2 3 4 5 6; do deep="$deep/un dossier profond au nom assez long, n° $number"; done
mkdir -p "$deep"
cp chapters/03_shadows.frag "$deep/profond.frag"
far_down() { [ "${#deep}" -gt 260 ] && picture -f "$deep/profond.frag" -o "$deep/profond.png" && alike "$deep/profond.png"; }
check 'files are read and written at paths longer than 260 characters' far_down
backslashes() {
    # shellcheck disable=SC1003 # as Windows' shell would pass it on
    (cd "$strange" && "$root/$BUILD/03_shadows" "${small[@]}" --root 'Z:'"${root//\//\\}" -o '.\c.png') && alike "$strange/c.png"
}
check "paths in Windows' notation are accepted" backslashes

# Copy a program and its libraries, as they are distributed, and the shaders with Windows' line endings, as git or an
# editor writes them.
mkdir "$strange/course"
cp build/windows/03_shadows.exe build/windows/*.dll "$strange/course" 2>/dev/null
cp -R shaders "$strange/course" && mkdir "$strange/course/chapters" && cp chapters/*.frag chapters/*.glsl "$strange/course/chapters"
find "$strange/course" -name '*.frag' -o -name '*.glsl' -o -name '*.vert' | while IFS= read -r file; do
    awk '{ printf "%s\r\n", $0 }' "$file" >"$scratch/lines" && cp "$scratch/lines" "$file"
done
elsewhere() { "$loader" "$strange/course/03_shadows.exe" "${small[@]}" -o "$strange/d.png" && alike "$strange/d.png"; }
check "a course with Windows' line endings works in a folder outside any code page" elsewhere

printf '#include "Main.glsl"\n' >"$scratch/letters.frag"
check 'an include that differs from the name on disk in capital letters is refused' refused 'letters.frag:1: #include "Main.glsl": the name on disk is main.glsl' \
    picture -f "$scratch/letters.frag" -o "$scratch/letters.png"

# ---- A file that another program has open ----

# held FILE REDIRECTION COMMAND...: runs a command while a Windows program has the file open.
held() {
    local file=$1 how=$2 holder status
    shift 2
    mkfifo "$scratch/end" && exec 9<>"$scratch/end"
    printf '@echo off\r\ncall :hold %s "%s"\r\nexit /b\r\n:hold\r\necho held > "%s"\r\nset /p line=\r\nexit /b\r\n' \
        "$how" "Z:${file//\//\\}" "Z:${scratch//\//\\}\\held" >"$scratch/hold.bat"
    "$loader" cmd /c "Z:${scratch//\//\\}\\hold.bat" <&9 >/dev/null 2>&1 &
    holder=$!
    local tries=600
    until [ -e "$scratch/held" ] || [ $((tries -= 1)) = 0 ]; do sleep 0.1; done
    "$@"
    status=$?
    echo >&9
    wait "$holder"
    exec 9>&-
    rm -f "$scratch/end" "$scratch/held"
    return $status
}
cp chapters/03_shadows.frag "$scratch/edited.frag"
read_it() { held "$scratch/edited.frag" '>>' picture -f "$scratch/edited.frag" -o "$scratch/e.png" && alike "$scratch/e.png"; }
check 'a shader that an editor has open can be read' read_it
picture -o "$scratch/shown.png"
cp "$scratch/shown.png" "$scratch/before.png"
not_written() { held "$scratch/shown.png" '>>' refused 'shown.png: cannot be written' picture -s 32x18 -o "$scratch/shown.png"; }
check 'a picture that another program is writing is not replaced' not_written
stays() { cmp "$scratch/shown.png" "$scratch/before.png" && [ -z "$(find "$scratch" -name '*.tmp')" ]; }
check 'a picture that another program is writing is unchanged, and no temporary file is left' stays

# ---- The console ----

check 'an error message is one line' refused 'unknown option' picture --nothing
bytes() { picture --list && [ -s "$scratch/said" ] && ! grep -q $'\r' "$scratch/said" "$scratch/why"; }
check 'output has the same line endings as on other systems' bytes
# The program writes the shader's text in several parts. Once head has read one line and ended, every write fails, but
# the program looks up the cause only after the last part.
first_line() {
    for _ in 1 2 3; do
        "$BUILD/03_shadows" --print-shader 2>"$scratch/why" | head -n 1 >"$scratch/said"
        if [ ! -s "$scratch/said" ] || [ -s "$scratch/why" ]; then
            sed 's/^/# /' "$scratch/why"
            return 1
        fi
    done
}
check 'reading only the first line of a long text causes no error message' first_line
plan
