#!/bin/sh
# listings.sh - rewrite what the pages take from elsewhere: listings, tables of parameters, reading times.
#
#   .make/listings.sh [--check] [PAGE...]     default: README.md and docs/*.md
#
# A page holds a marker on a line of its own, and the block below it is written by this script:
#
#   <!-- code: shaders/march.glsl march -->               what the file defines under this name
#   <!-- code: shaders/march.glsl march with-comment -->  with the comment block above it
#   <!-- code: chapters/first_steps/1_screen.frag * -->   the whole file
#   <!-- parameters: 01_normal_colouring -->              what build/01_normal_colouring --list prints
#   <!-- time -->                                         how long the page takes to read, by words.awk
#
# What is shown must be used: a page speaks of each of its listings, naming it in backticks; no block of
# code is a copy by hand of a source; and every function and struct of the library that the course
# teaches (shaders/, without the machinery of views and inputs) stands on some page.
#
# A name is a function, struct, enum, variable or #define that begins at column 0; prototypes,
# forward and extern declarations define nothing. An error (a name that is gone or defined twice,
# a malformed marker, a fence without end) gives status 1 and leaves the page as it was. --check
# changes nothing and gives status 1 when a block differs from its source or is not used; without pages
# it also looks at the library.
set -eu
export LC_ALL=C
cd "$(dirname "$0")/.."

mode="write"
if [ "${1-}" = --check ]; then
    mode="check"
    shift
fi
library=""
if [ $# -eq 0 ]; then
    for file in shaders/*.glsl; do
        case $file in
        shaders/main.glsl | shaders/views.glsl | shaders/ramp.glsl | shaders/slice.glsl | shaders/plot.glsl | shaders/places.glsl | shaders/signs.glsl | shaders/inputs.glsl | shaders/marched.glsl) ;;
        *) library="$library $file" ;;
        esac
    done
    set --
    for page in README.md docs/*.md; do
        [ -f "$page" ] && set -- "$@" "$page"
    done
fi

fresh=$(mktemp)
trap 'rm -f "$fresh"' EXIT
status=0
for page in "$@"; do
    if [ ! -r "$page" ]; then
        echo "$page: cannot be read" >&2
        status=1
    elif ! awk -v mode="$mode" -v page="$page" -v build="${BUILD:-build}" \
        -f .make/source.awk -f .make/listings.awk "$page" >"$fresh"; then
        status=1
    elif [ "$mode" = write ] && ! cmp -s "$fresh" "$page"; then
        cat "$fresh" >"$page"
        echo "$page: listings rewritten"
    fi
done
if [ "$mode" = check ] && ! awk -v library="$library" \
    -v sources="$(echo shaders/*.* chapters/*.[cfg]* chapters/*/*.frag common/*.[ch] common/*/*.[ch])" \
    -f .make/source.awk -f .make/listings_used.awk "$@"; then
    status=1
fi
exit "$status"
