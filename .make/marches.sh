#!/bin/sh
# marches.sh - `make benchmark MARCHES=1`: measure seven marches in eleven scenes, and print tables of their costs and
# errors.
#
# Environment: WRITE=1, to write the tables to docs/benchmark.md.
set -u
. .make/write.sh
. .make/chapters.sh

scratch=$(mktemp -d "${TMPDIR:-/tmp}/ray-benchmark.XXXXXX") || exit 1
build/tests/measure marches >"$scratch/table" || exit 1
cat "$scratch/table"
[ "${WRITE:-0}" = 0 ] || write_table marches "$scratch/table"
