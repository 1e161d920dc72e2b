#!/bin/bash
# bake.sh [OPTION...] - `make bake MESH=my.obj`: bake the distance to a closed mesh into build/my.png, and show it in
# chapter 23.
#
# Environment: MESH, a Wavefront OBJ file. If the mesh cannot be baked, an earlier picture is kept.
set -u

[ -n "${MESH-}" ] || { echo 'bake: which mesh? For example: make bake MESH=my.obj' >&2 && exit 2; }
name=$(basename "$MESH")
file=build/${name%.obj}.png
trap 'rm -f "$file.new"' EXIT
build/shaders/textures/clay "$MESH" >"$file.new" || exit 1
mv "$file.new" "$file" || exit 1
echo "written  $file"
CHAPTER=23 exec .make/run.sh --texture "grid=$file" "$@"
