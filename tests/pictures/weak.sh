#!/bin/bash
# weak.sh - draws each chapter's picture with built-in functions whose errors go up to the largest that Vulkan allows
# (weak.glsl). It prints how far each picture is from its reference, but does not judge the difference, because no
# driver that we know is nearly so inaccurate. With FUNCTIONS='sin cos', only these functions err; with CHAPTER=05, only
# that chapter is drawn.
set -u
cd "$(dirname "$0")/../.." || exit 1
# shellcheck source=tests/lib/tap.sh
. tests/lib/tap.sh
open_scratch

# A program finds the folders shaders/ and chapters/ beside the folder that contains the program.
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
    # shellcheck disable=SC2086 # the options are separate words
    check "a weak driver draws $stem" "$scratch/build/$stem" $options -o "$scratch/$stem.png"
    echo "# $stem: $("$BUILD/tests/compare" "tests/references/$stem.png" "$scratch/$stem.png")"
done < <(grep -v '^#' tests/pictures/images.txt)
plan
