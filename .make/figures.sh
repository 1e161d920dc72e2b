#!/bin/sh
# figures.sh NAME... - `make figures`: draw each diagram of docs/figures/ with its program.
set -u
. .make/write.sh

for figure; do
    write "docs/figures/$figure.svg" "build/docs/figures/$figure" || exit 1
done
