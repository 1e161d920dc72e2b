#!/bin/sh
# clean.sh - `make clean`: remove build/. The folder build/student/ stays if a lecturer has added something to it, such
# as the repository that docs/teaching.md describes.
set -u
. .make/names.sh
. .make/written.sh

student=build/student
own=
if [ -d $student/ray-marching ]; then
    [ ! -e $student/written ] || known=$student/written
    own=$(added $student/ray-marching "${known:-/dev/null}")
    own=${own:+ray-marching/$own}
fi
for file in "$student"/* "$student"/.[!.]*; do
    case ${file#"$student/"} in
    ray-marching | ray-marching.zip | stored | written | site | site.zip | .ray-marching.*) ;;
    *) [ ! -e "$file" ] || own=${file#"$student/"} ;;
    esac
done
if [ -n "$own" ]; then
    find build/ -mindepth 1 -maxdepth 1 ! -name student -exec rm -rf {} +
    report "$student: kept, because it contains something that make student did not write, $own: delete the folder yourself if you no longer need it"
else
    rm -rf build
fi
