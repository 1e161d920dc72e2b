#!/bin/bash
# site.sh - `make site`: all pages as a static site, build/site/, and build/site.zip to hand out. Called after the
# module and the node packages are there. The same sources give the same bytes.
set -eu
export LC_ALL=C TZ=UTC SOURCE_DATE_EPOCH=0
. .make/pages.sh
out=${SITE_FOLDER:-build/site} source=${SITE_SOURCE:-docs/web} # the tests build another one

rm -rf "$out" "$out.parts" "$out.zip"
mkdir -p "$out/fonts"
# shellcheck disable=SC2046
node "$source/site.mjs" "$out" $(pages)

# The programs, as `make web` lays them.
(cd build/web && find . -type f ! -path './objects/*' ! -name '*.map') | while read -r file; do
    mkdir -p "$out/$(dirname "$file")"
    cp "build/web/$file" "$out/$file"
done
cp "$source"/{site.css,site.js,play.js,icon.svg} "$out/"
cp "$source/LICENSE.fonts" "$out/fonts/LICENSE.txt"

# subset NAME LETTERS FAMILY:STYLE: only the letters that the pages use, of a font that fontconfig finds.
subset() {
    file=$(fc-match -f '%{file}' "$3")
    case $file in
    *agella*) ;;
    *) echo "make site: the font $3 is missing: $file would stand in its place" >&2; exit 1 ;;
    esac
    pyftsubset "$file" --text-file="$out.parts/$2.txt" --flavor=woff2 --layout-features="$4" --output-file="$out/fonts/$1.woff2" --drop-tables+=FFTM
}
subset regular text 'TeX Gyre Pagella:style=Regular' kern,liga,tnum
subset italic text 'TeX Gyre Pagella:style=Italic' kern,liga,tnum
subset bold text 'TeX Gyre Pagella:style=Bold' kern,liga,tnum
subset formula formula 'TeX Gyre Pagella Math' kern # ssty, half as much again, is what no browser asks for by itself
rm -r "$out.parts"

# No times, no owners, one order: the archive depends on the files alone.
find "$out" -exec chmod u=rwX,go=rX {} + -exec touch -d '1980-01-01 00:00:00' {} +
(cd "$(dirname "$out")" && find "$(basename "$out")" -type f | sort | zip -q -X -9 -@ "$(basename "$out").zip")
echo "$out/: $(find "$out" -type f | wc -l) files, $(du -sm "$out" | cut -f 1) MB; $out.zip: $(du -m "$out.zip" | cut -f 1) MB"
