#!/bin/bash
# weak.sh - each chapter's picture as drawn by a driver whose built-in functions err as much as they may (weak.glsl). It
# prints how far each is from its reference and does not judge: no driver that we know is nearly so inexact.
# FUNCTIONS='sin cos' lets only these err; CHAPTER=05 draws one chapter.
set -u
cd "$(dirname "$0")/../.." || exit 1
# shellcheck source=tests/lib/tap.sh
. tests/lib/tap.sh
open_scratch

# A program reads the shaders beside its own folder.
mkdir "$scratch/build"
cp -r shaders chapters "$scratch/"
functions=$(echo "${FUNCTIONS-[a-z0-9]+}" | tr ' ' '|')
grep -E "^([^#]|#define (PER_COMPONENT|($functions) weak))" tests/pictures/weak.glsl >"$scratch/shaders/weak.glsl"
{
    echo '#include "weak.glsl"'
    cat shaders/main.glsl
} >"$scratch/shaders/main.glsl"

while read -r stem variant options; do
    case $stem,$variant in "${CHAPTER-}"*,-) ;; *) continue ;; esac
    cp "$BUILD/$stem" "$scratch/build/"
    # shellcheck disable=SC2086 # several words
    check "a weak driver draws $stem" "$scratch/build/$stem" $options -o "$scratch/$stem.png"
    echo "# $stem: $("$BUILD/tests/compare" "tests/references/$stem.png" "$scratch/$stem.png")"
done < <(grep -v '^#' tests/pictures/images.txt)
plan
