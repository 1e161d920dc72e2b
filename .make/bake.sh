#!/bin/bash
# bake.sh [OPTION...] - `make bake MESH=my.obj`: bake the distance to a closed mesh into build/my.png, and show it in
# chapter 23.
#
# Environment: MESH, a Wavefront OBJ file. If the mesh cannot be baked, an earlier picture is kept.
set -u
. .make/write.sh

[ -n "${MESH-}" ] || fail 2 'which mesh? For example: make bake MESH=my.obj'
mesh=$MESH
[[ $mesh != -* ]] || mesh=./$mesh # a name, not an option
name=${mesh##*/}
name=${name%.obj}.png
! [ "$mesh" -ef "build/$name" ] || fail 2 "MESH=$MESH: the picture would replace this file: give it another name"
begin build || exit 1
build/shaders/textures/clay "$mesh" >"$new/picture" || exit 1
mv "$new/picture" "$new/$name" 2>/dev/null || fail 1 "build/$name: cannot be written: the name is too long"
keep "$name" || exit 1
discard
trap - HUP INT PIPE TERM # the window is to end at a signal
plain "written  build/$name: the distance to $mesh at 64 x 64 x 64 points; a window shows it"
CHAPTER=23 exec .make/run.sh --texture "grid=build/$name" --set eyes=false "$@"
