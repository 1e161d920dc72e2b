#!/bin/sh
# marches.sh - `make benchmark MARCHES=1`: measure seven marches in eleven scenes, and print tables of their costs and
# errors.
#
# Environment: WRITE=1, to write the tables to docs/benchmark.md.
set -u
. .make/chapters.sh

work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
build/tests/measure marches >"$work/table" || exit 1
cat "$work/table"
[ "${WRITE:-0}" = 0 ] || write_table marches "$work/table"
