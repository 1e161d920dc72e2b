#!/bin/bash
# web.sh - write the module, minified, and the files that it reads into build/web/. make calls this script after the
# module is built.
set -eu
. .make/write.sh
out=${WEB_FOLDER:-build/web} source=${SITE_SOURCE:-docs/web} # the variables replace the target and the source folder

begin "$out"
find chapters shaders -name '*.frag' -o -name '*.glsl' -o -name '*.vert' -o -name '*.png' | sort | node "$source/pack.mjs" "$new"
cp "$source/live.css" "$new/"
.make/exercises.sh >"$new/exercises.txt"
# Scripts that are loaded together become one file, without comments. Scripts that other files import too remain
# separate.
NODE_PATH=build/node/node_modules build/node/node_modules/.bin/esbuild "$source"/{live,stage,check,program,editor}.js --bundle --minify \
    --format=esm --external:./{harness,program,stage,check,editor}.js --log-level=warning --outdir="$new"
# The module is minified into another file, because minifying a file again gives it other names.
build/node/node_modules/.bin/esbuild build/web/objects/harness.js --minify --format=esm --log-level=warning --outfile="$new/harness.js"
cp build/web/objects/harness.wasm "$new/"
keep harness.js harness.wasm course course.json live.css exercises.txt {live,stage,check,program,editor}.js
total=0
for file in harness.wasm harness.js course.json {live,stage,check,program}.js editor.js exercises.txt; do
    packed=$(gzip -9c "$out/$file" | wc -c)
    printf '%-14s %7d bytes, %6d compressed\n' "$file" "$(wc -c <"$out/$file")" "$packed"
    [[ $file =~ ^(editor|exercises) ]] || total=$((total + packed))
done
echo "together $total bytes compressed, without the editor and the list of exercises"
