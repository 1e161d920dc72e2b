#!/bin/sh
# run.sh [OPTION...] - `make run`: a chapter in a window; where none can be opened, pictures of all chapters.
#
# Environment: CHAPTER, "03" or a whole stem; the first chapter, or without a window every one.
set -u
. .make/chapters.sh

stem=$(stem_of "${CHAPTER-}") || exit 1
in_window "build/$stem" "$@"
[ -n "${CHAPTER-}" ] || stem=$(stems)
for each in $stem; do
    in_file "$each" "build/$each" "$@"
done
