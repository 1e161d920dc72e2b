#!/bin/bash
# web.sh - write the module, minified, and the files that it reads into build/web/. make calls this script after the
# module is built.
#
# course.json contains the texts of the files that every chapter needs, and the names of the files that only some
# chapters need. The latter files are in course/, and are loaded when a command line needs them.
set -eu
. .make/write.sh
out=${WEB_FOLDER:-build/web} source=${SITE_SOURCE:-docs/web} # the variables replace the target and the source folder

begin "$out"
# These files of the library are needed only from chapter 17 on.
rare='shaders/clouds.glsl shaders/land.glsl shaders/night.glsl shaders/prism.glsl shaders/stored.glsl shaders/water.glsl'
# shellcheck disable=SC2086 # names without blanks
{ printf '%s\n' $rare; find chapters shaders/textures -name '*.frag' -o -name '*.glsl' -o -name '*.png'; } | sort >"$new/later.txt"
while read -r file; do
    mkdir -p "$new/course/$(dirname "$file")"
    cp "$file" "$new/course/$file"
done <"$new/later.txt"
common=()
for file in shaders/*.glsl shaders/screen.vert; do
    case " $rare " in *" $file "*) ;; *) common+=("$file") ;; esac
done
node "$source/pack.mjs" "$new/later.txt" "$new/course.json" "${common[@]}"
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
