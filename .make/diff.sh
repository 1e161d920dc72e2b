#!/bin/sh
# diff.sh - `make diff CHAPTER=03`: show what changed since the previous chapter or, with CHAPTER=engine_2,
# since the previous step of docs/engine.md.
set -u
. .make/chapters.sh

if [ -z "${CHAPTER-}" ]; then
    fail 1 'which chapter? For example: make diff CHAPTER=02'
fi
before=
case $CHAPTER in
engine_1) stem=$CHAPTER ;;
engine_[2-6]) stem=first_steps/$CHAPTER before=first_steps/engine_$((${CHAPTER#engine_} - 1)) ;;
*)
    stem=$(stem_of "$CHAPTER") || exit 1
    for each in $(stems); do
        [ "$each" = "$stem" ] && break
        before=$each
    done
    ;;
esac
if [ -z "$before" ]; then
    echo "$stem comes first, so there is nothing to compare it with."
    exit 0
fi

for kind in frag c; do
    old=chapters/$before.$kind new=chapters/$stem.$kind
    if ! [ -e "$old" ] || ! [ -e "$new" ]; then continue; fi # only two steps of the engine have a shader
    if command -v git >/dev/null; then
        git --no-pager diff --no-index --patience "$old" "$new"
    else
        diff -u "$old" "$new"
    fi
    # Status 1 means that the files differ, as expected.
    [ $? -le 1 ] || exit 1
done
