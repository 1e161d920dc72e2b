#!/bin/sh
# windows_zip.sh - `make windows-zip`: pack the programs for Windows and all the files that they read into
# build/ray-marching-windows.zip, to be unpacked and opened with a double click. The same sources give the same bytes.
set -eu
export TZ=UTC
. .make/write.sh

begin build
out=$new/ray-marching
mkdir -p "$out/licences" "$out/shaders/textures" "$out/exercises" "$out/build" # commands on the pages write their pictures to build

# ---- The programs and the files that they read ----

cp build/windows/[0-9][0-9]_*.exe build/windows/harness.dll build/windows/tests/compare.exe build/windows/tests/judge.exe "$out"
cp shaders/*.glsl shaders/screen.vert "$out/shaders"
cp shaders/textures/*.png "$out/shaders/textures"
find chapters -name '*.frag' ! -path chapters/play.frag -o -name '*.glsl' | while read -r file; do
    mkdir -p "$out/$(dirname "$file")"
    cp "$file" "$out/$file"
done

# Write a file for each exercise, for check.bat. The first line of a file has the program, the solution, the pixels of
# the rays, and the --probe options for these pixels. Each other line has the options of a picture, those that its rays
# use, and those that a page would show, which are last because they may be empty.
.make/exercises.sh | awk -F '|' -v OFS='|' -v ORS='\r\n' -v out="$out/exercises/" '
    { file = out $1 ".txt"; gsub(/^ +| +$/, "", $3); gsub(/^ +| +$/, "", $5) }
    !(file in seen) {
        seen[file] = 1
        probes = " " $6
        gsub(/ /, " --probe=", probes)
        print $2, $2 "_" substr($1, 4), $6, substr(probes, 2) > file
    }
    { print $3, $5, $4 > file }'

# ---- Documentation ----

if [ -d build/site ]; then
    cp -R build/site "$out/site"
    pages='site\index.html. Programs do not run in pages that are opened as files: use the programs beside this file.'
else
    mkdir -p "$out/docs/figures"
    cp docs/*.md "$out/docs"
    cp docs/figures/*.svg "$out/docs/figures"
    pages='docs\README.md, without the pictures that the programs draw.'
fi

# Notepad and cmd.exe expect carriage returns.
returns() { awk '{ sub(/\r$/, ""); printf "%s\r\n", $0 }'; }
returns <LICENSE >"$out/LICENSE.txt"
for file in build/windows/prefix/licences/*.txt; do
    name=$(basename "$file")
    returns <"$file" >"$out/licences/$name"
done
returns <common/picture/font/README >"$out/licences/dejavu.txt"
for file in .make/windows/*; do
    sed "s|@PAGES@|$(printf '%s' "$pages" | sed 's/\\/\\\\/g')|" "$file" | returns >"$out/$(basename "$file")"
done

# ---- The same bytes each time ----

date=$(git log -1 --format=%ct 2>/dev/null || echo 946684800)
find "$out" -type d -exec chmod 755 {} + -o -exec chmod 644 {} +
find "$out" -exec touch -d "@$date" {} +
(cd "$new" && find ray-marching -type f -o -type d -empty | sort | zip -q -9 -X -@ ray-marching-windows.zip)
keep ray-marching-windows.zip
printf 'build/ray-marching-windows.zip: %s bytes\n' "$(wc -c <build/ray-marching-windows.zip | tr -d ' ')"
