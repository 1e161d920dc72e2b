#!/bin/bash
# references.sh MODE - renders every picture of tests/pictures/images.txt. Run it from the project's folder.
#
#   gallery  render each picture into build/gallery/
#   update   render each picture in software. A picture without a reference becomes tests/references/NAME.png; one
#            outside the tolerance replaces its reference, and the differences are printed. (FORCE=1 in the environment
#            replaces every reference whose pixels differ.)
#   gpu      render each picture with this machine's graphics processor, and print how far it is from its reference
#
# CHAPTER=03 in the environment leaves out the pictures of the other chapters.
set -u
. .make/chapters.sh

mode=${1-}
case $mode in
gallery) folder=build/gallery ;;
update | gpu) folder=build/references ;;
*) echo 'usage: tests/pictures/references.sh gallery|update|gpu' >&2; exit 2 ;;
esac
references=tests/references
chapter=
if [ -n "${CHAPTER-}" ]; then
    chapter=$(stem_of "$CHAPTER") || exit 2
fi
mkdir -p "$folder" "$references" || exit 1

backend=()
if [ "$mode" = update ]; then
    export LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe
    backend=(-b egl)
elif [ "$mode" = gpu ]; then
    unset LIBGL_ALWAYS_SOFTWARE GALLIUM_DRIVER
fi

rewritten=0 new=0 kept=0 within=0 outside=0

# update NAME PICTURE: create, keep or replace the reference.
update() {
    local stored=$references/$1.png numbers status
    if [ ! -e "$stored" ]; then
        build/tests/compare --pack "$2" "$stored" || exit 1
        new=$((new + 1))
        echo "$1: new"
        return
    fi
    numbers=$(build/tests/compare "$stored" "$2")
    status=$?
    if [ "$status" = 0 ] && [ "${FORCE:-0}" = 0 ]; then
        kept=$((kept + 1))
        return
    fi
    build/tests/compare --pack "$2" "$stored"
    case $? in
    0) rewritten=$((rewritten + 1)) ;;
    1) kept=$((kept + 1)); return ;; # the same pixels
    *) exit 1 ;;
    esac
    echo "$1: rewritten: ${numbers:-could not be compared}"
}

# judge NAME PICTURE: print how far the GPU's picture is from its reference.
judge() {
    local numbers status
    numbers=$(build/tests/compare "$references/$1.png" "$2")
    status=$?
    if [ "$status" = 0 ]; then
        within=$((within + 1))
    else
        outside=$((outside + 1))
    fi
    printf '%-32s %s%s\n' "$1" "${numbers:-could not be compared}" \
        "$([ "$status" = 0 ] || echo ' (outside the tolerance)')"
}

names=' '
while read -r stem variant options; do
    case $stem in '' | '#'*) continue ;; esac
    name=$stem
    [ "$variant" = - ] || name=$stem-$variant
    names="$names$name "
    [ -z "$chapter" ] || [ "$chapter" = "$stem" ] || continue
    picture=$folder/$name.png
    if [ ! -x "build/$stem" ]; then
        echo "tests/pictures/images.txt: $stem: no such program: build/$stem" >&2
        exit 1
    fi
    read -r -a words <<<"$options"
    [ "$mode" = gpu ] && [ $((within + outside)) = 0 ] && "build/$stem" --version
    "build/$stem" ${backend[@]+"${backend[@]}"} -o "$picture" ${words[@]+"${words[@]}"} </dev/null >/dev/null || exit 1
    case $mode in
    gallery) echo "$picture" ;;
    update) update "$name" "$picture" ;;
    gpu) judge "$name" "$picture" ;;
    esac
done <tests/pictures/images.txt

# The picture engine_5 is drawn by the engine of docs/engine.md, not by a chapter's program.
names="${names}engine_5 "
if [ "$mode" = update ] && [ -z "$chapter" ]; then
    build/first_steps/engine_6 -o "$folder/engine_5.png" chapters/first_steps/engine_5.frag shaders/textures/plank.png || exit 1
    update engine_5 "$folder/engine_5.png"
fi

case $mode in
update)
    for stored in "$references"/*.png; do
        name=$(basename "$stored" .png)
        case $names in
        *" $name "*) ;;
        *) echo "$stored: no line of tests/pictures/images.txt produces this picture: remove it" >&2 ;;
        esac
    done
    echo "$kept kept, $rewritten rewritten, $new new"
    ;;
gpu) echo "$within within the tolerance, $outside outside (reported, not judged)" ;;
esac
