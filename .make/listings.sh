#!/bin/sh
# listings.sh - rewrite the generated parts of the pages: listings, tables of parameters and reading times.
#
#   .make/listings.sh [--check] [PAGE...]     default: README.md and docs/*.md
#
# A page has markers on separate lines, and this script writes the block below each marker:
#
#   <!-- code: shaders/march.glsl march -->               the definition of this name in the file
#   <!-- code: chapters/first_steps/1_screen.frag * -->   the whole file
#   <!-- parameters: 01_normal_colouring -->              the output of build/01_normal_colouring --list
#   <!-- keys -->                                         the keys of a window, from --help
#   <!-- time -->                                         the reading time of the page, from words.awk
#
# Listings must be used: the text of a page must name each of its listings in backticks; no block of code may be copied
# from a source by hand; and every function and struct of the library that the course teaches (shaders/, without the
# machinery of views and inputs) must be on some page.
#
# A name is a function, struct, enum, variable or #define that begins in column 0; prototypes, forward declarations and
# extern declarations define nothing. An error (a name that is not defined or is defined twice, a malformed marker, a
# fence without an end) gives status 1 and leaves the page unchanged. --check changes nothing, and gives status 1 if a
# block differs from its source or is not used; without pages it also checks the library.
set -eu
cd "$(dirname "$0")/.."
. .make/write.sh

mode="write"
if [ "${1-}" = --check ]; then
    mode="check"
    shift
fi
library=""
if [ $# -eq 0 ]; then
    for file in shaders/*.glsl; do
        case $file in
        shaders/main.glsl | shaders/figure.glsl | shaders/views.glsl | shaders/ramp.glsl | shaders/slice.glsl | shaders/plot.glsl | shaders/positions.glsl | shaders/signs.glsl | shaders/inputs.glsl | shaders/marched.glsl) ;;
        *) library="$library $file" ;;
        esac
    done
    set --
    for page in README.md docs/*.md; do
        [ -f "$page" ] && set -- "$@" "$page"
    done
fi

scratch=$(mktemp -d "${TMPDIR:-/tmp}/ray-listings.XXXXXX")
fresh=$scratch/page
wrong=0
for page in "$@"; do
    if [ ! -f "$page" ] || [ ! -r "$page" ]; then
        report "$page: cannot be read"
        wrong=1
    elif ! awk -v mode="$mode" -v page="$page" -v build="${BUILD:-build}" \
        -f .make/source.awk -f .make/listings.awk "$page" >"$fresh"; then
        wrong=1
    elif [ "$mode" = write ] && ! cmp -s "$fresh" "$page"; then
        write "$page" cat "$fresh"
        echo "$page: listings rewritten"
    fi
done
if [ "$mode" = check ] && ! awk -v library="$library" \
    -v sources="$(echo shaders/*.* chapters/*.[cfg]* chapters/*/*.[cf]* common/*.[ch] common/*/*.[ch])" \
    -f .make/source.awk -f .make/listings_used.awk "$@"; then
    wrong=1
fi
exit "$wrong"
