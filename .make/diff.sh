#!/bin/sh
# diff.sh - `make diff CHAPTER=03`: what changed since the chapter before.
set -u
. .make/chapters.sh

if [ -z "${CHAPTER-}" ]; then
    echo 'make: which chapter? For example: make diff CHAPTER=02' >&2
    exit 1
fi
stem=$(stem_of "$CHAPTER") || exit 1
before=
for each in $(stems); do
    [ "$each" = "$stem" ] && break
    before=$each
done
if [ -z "$before" ]; then
    echo "$stem is the first chapter: nothing stands before it."
    exit 0
fi

for kind in frag c; do
    old=chapters/$before.$kind new=chapters/$stem.$kind
    if command -v git >/dev/null; then
        git --no-pager diff --no-index --patience "$old" "$new"
    else
        diff -u "$old" "$new"
    fi
    # 1 says that they differ, as they should.
    [ $? -le 1 ] || exit 1
done
