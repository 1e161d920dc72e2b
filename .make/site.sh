#!/bin/bash
# site.sh - `make site`: build a static site from all pages, as the folder build/site/ and as build/site.zip to hand
# out. make calls this script after the module is built and the node packages are installed. The same sources give the
# same bytes.
set -eu
export TZ=UTC SOURCE_DATE_EPOCH=0
. .make/write.sh
. .make/pages.sh
# The variables replace the target, the source folder and the folder of the programs.
target=${SITE_FOLDER:-build/site} source=${SITE_SOURCE:-docs/web} web=${WEB_FOLDER:-build/web}
begin "$(dirname "$target")"
name=$(basename "$target")
out=$new/$name
echo "pages $target/"
mkdir -p "$out/fonts"
# shellcheck disable=SC2046
node "$source/site.mjs" "$out" $(pages)

# Copy the programs, in the layout of `make web`.
(cd "$web" && find . -type f ! -path './objects/*' ! -path './.*' ! -name '*.map') | while read -r file; do
    mkdir -p "$out/$(dirname "$file")"
    cp "$web/$file" "$out/$file"
done
# Every page with figures loads these files, so they are minified.
build/node/node_modules/.bin/esbuild "$source"/sheet{,_parts,_space,_rest}.js "$source/sheet.css" --minify --log-level=warning --outdir="$out"
cp "$source"/{site.css,site.js,find.js,guess.js,question.js,progress.js,play.js,dropped.js,edits.js,icon.svg} "$out/"
cp "$source/LICENSE.fonts" "$out/fonts/LICENSE.txt"

# With fixed times, no owners and a fixed order, the archive depends only on the files.
find "$out" -exec chmod u=rwX,go=rX {} + -exec touch -d '1980-01-01 00:00:00' {} +
(cd "$new" && find "$name" -type f | sort | zip -q -X -9 -@ "$name.zip")
keep "$name" "$name.zip"
echo "$target/: $(find "$target" -type f | wc -l) files, $(du -sm "$target" | cut -f 1) MB; $target.zip: $(du -m "$target.zip" | cut -f 1) MB"
