#!/bin/sh
# check.sh - check every file in this folder that has the name of an exercise, such as 03_2.frag or engine_1.c. Exit
# status: 0 if all are right, 1 if not.
cd "$(dirname "$0")/.." || exit 2
make --no-print-directory ready || exit 2
status=0
for file in answers/[0-9][0-9]_*.frag answers/engine_*.c; do
    [ -e "$file" ] || continue
    name=${file##*/}
    # make would carry out a $(shell ...) in the name of a file.
    EXERCISE=${name%.*} FILE=$file FILES='' .make/check.sh || status=1
done
exit $status
